# SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
# SPDX-License-Identifier: BSD-3-Clause
"""Objects of city models as parts of surveys, and walls with openings."""

import json

import numpy as np
import pytest
from vtkmodules.util.numpy_support import vtk_to_numpy

import vtkhelios
from vtkhelios import cli
from vtkhelios.array_names import CLASSIFICATION_IDS, PART_IDS, PART_NAME

SURVEY = """\
<document>
  <survey name="s" scene="#s" platform="platforms.xml#tripod" scanner="scanners.xml#vz400_class_tls">
    <leg>
      <platformSettings x="0" y="0" z="6" onGround="false"/>
      <scannerSettings pulseFreq_hz="100000" scanFreq_hz="100" verticalAngleMin_deg="-40"
        verticalAngleMax_deg="60" headRotatePerSec_deg="60" headRotateStop_deg="360"/>
    </leg>
  </survey>
  <scene id="s">{parts}</scene>
</document>
"""
PART = """\
<part id="{id}"><filter type="{loader}"><param key="filepath" value="{path}"/></filter>
<filter type="translate"><param key="offset" value="{x};0;0"/></filter></part>
"""
BOX = [
    [[0, 1, 2, 3]],
    [[4, 5, 6, 7]],
    [[0, 1, 5, 4]],
    [[1, 2, 6, 5]],
    [[2, 3, 7, 6]],
    [[3, 0, 4, 7]],
]


def make_object(kind, first):
    boundaries = [[[corner + first for corner in ring] for ring in face] for face in BOX]
    return {
        "type": kind,
        "geometry": [{"type": "MultiSurface", "lod": "2", "boundaries": boundaries}],
    }


def box(x, y):
    return [[x + a, y + b, c] for c in (0, 8) for a, b in ((0, 0), (4, 0), (4, 4), (0, 4))]


@pytest.fixture
def town(tmp_path):
    """A city of two houses and a bridge, as a document and as a sequence, and the ground."""
    vertices = [*box(10, 0), *box(-2, 10), *box(-14, -2)]
    objects = {"pand-7": make_object("Building", 0), "pand-8": make_object("Building", 8)}
    objects["brug"] = make_object("Bridge", 16)
    head = {
        "type": "CityJSON", "version": "2.0", "CityObjects": {}, "vertices": [],
        "transform": {"scale": [1, 1, 1], "translate": [0, 0, 0]},
    }  # fmt: skip
    (tmp_path / "a.city.json").write_text(
        json.dumps({**head, "CityObjects": objects, "vertices": vertices})
    )
    lines = [head]
    for number, (name, kind) in enumerate({"pand-7": "Building", "pand-8": "Building", "brug": "Bridge"}.items()):  # fmt: skip
        own = {name: make_object(kind, 0)}
        feature = {"type": "CityJSONFeature", "id": name, "CityObjects": own}
        lines.append({**feature, "vertices": vertices[8 * number : 8 * number + 8]})
    (tmp_path / "a.city.jsonl").write_text("".join(f"{json.dumps(line)}\n" for line in lines))
    (tmp_path / "ground.obj").write_text(
        "v -50 -50 0\nv 50 -50 0\nv 50 50 0\nv -50 50 0\nf 1 2 3 4\n"
    )

    def write(*parts):
        text = "".join(
            PART.format(id=name, loader=loader, path=path, x=x) for name, loader, path, x in parts
        )
        survey = tmp_path / "survey.xml"
        survey.write_text(SURVEY.format(parts=text))
        return survey

    return write


def names_of(data):
    array = data.GetFieldData().GetAbstractArray(PART_NAME)
    return [array.GetValue(row) for row in range(array.GetNumberOfValues())]


@pytest.mark.parametrize("path", ["a.city.json", "a.city.jsonl"])
def test_echoes_have_the_objects_of_a_city(town, path):
    survey = town(("city", "cityjsonloader", path, 0), ("ground", "objloader", "ground.obj", 0))
    echoes = vtkhelios.read_survey(survey).run()
    names = names_of(echoes.data)
    assert names[:2] == ["city", "ground"] and sorted(names[2:]) == ["brug", "pand-7", "pand-8"]
    parts, classes = echoes[PART_IDS], echoes[CLASSIFICATION_IDS]
    points = echoes.points
    middles = {"pand-7": (12, 2), "pand-8": (0, 12), "brug": (-12, 0)}
    for row, name in enumerate(names):
        own = points[parts == row]
        if name == "city":
            assert len(own) == 0
        elif name == "ground":
            assert len(own) > 1000 and abs(own[:, 2]).max() < 0.1
        else:
            assert len(own) > 1000
            assert abs(own[:, :2] - middles[name]).max() < 2.1
            assert set(classes[parts == row]) == {17 if name == "brug" else 6}


def test_a_city_that_stands_twice_keeps_its_objects(town):
    survey = town(
        ("a", "cityjsonloader", "a.city.json", 0), ("b", "cityjsonloader", "a.city.json", 50)
    )
    scene = vtkhelios.read_survey(survey).scene
    names = names_of(scene)
    assert names[:2] == ["a", "b"]
    assert sorted(names[2:]) == ["brug", "brug", "pand-7", "pand-7", "pand-8", "pand-8"]
    ids = vtk_to_numpy(scene.GetCellData().GetArray(PART_IDS))
    assert sorted(set(ids)) == [2, 3, 4, 5, 6, 7]


def test_text_names_the_objects(town, tmp_path, capsys):
    survey = town(("city", "cityjsonloader", "a.city.jsonl", 0))
    assert cli.main(["run", str(survey), "--output", str(tmp_path / "out"), "--quiet"]) == 0
    (points,) = (tmp_path / "out").rglob("leg000_points.xyz")
    names = {line.split()[8] for line in points.read_text().splitlines()}
    assert names == {"brug", "pand-7", "pand-8"}
    capsys.readouterr()


def test_no_points_in_the_opening_of_a_wall(tmp_path):
    """A wall 10 m wide and 6 m high with a gate 4 m wide and 4 m high, from each first corner."""
    corners = [(-5, 0), (-2, 0), (-2, 4), (2, 4), (2, 0), (5, 0), (5, 6), (-5, 6)]
    text = "".join(f"v {x} 8 {z}\n" for x, z in corners)
    for first in range(8):
        face = " ".join(str((first + k) % 8 + 1) for k in range(8))
        (tmp_path / "wall.obj").write_text(f"{text}f {face}\n")
        survey = tmp_path / "survey.xml"
        part = PART.format(id="wall", loader="objloader", path="wall.obj", x=0)
        survey.write_text(SURVEY.format(parts=part).replace('z="6"', 'z="2"'))
        points = vtkhelios.read_survey(survey).run().points
        inside = (abs(points[:, 0]) < 1.95) & (points[:, 2] < 3.95)
        assert len(points) > 1000 and not inside.any()
        assert (
            np.count_nonzero(points[:, 0] > 2) > 100 and np.count_nonzero(points[:, 0] < -2) > 100
        )
