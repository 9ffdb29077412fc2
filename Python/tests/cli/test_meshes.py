# SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
# SPDX-License-Identifier: BSD-3-Clause
"""vtkhelios info and vtkhelios convert of meshes."""

import json

import pytest

import vtkhelios
from vtkhelios.cli import main

PLY = (
    "ply\nformat ascii 1.0\nelement vertex 4\nproperty double x\nproperty double y\n"
    "property double z\nelement face {0}\nproperty list uchar int vertex_indices\nend_header\n"
    "10 0 0\n14 0 0\n14 3 0\n10 3 0\n"
)
SQUARE = PLY.format(1) + "4 0 1 2 3\n"
CITY = {
    "type": "CityJSON",
    "version": "2.0",
    "transform": {"scale": [1, 1, 1], "translate": [0, 0, 0]},
    "metadata": {"referenceSystem": "https://www.opengis.net/def/crs/EPSG/0/7415"},
    "CityObjects": {
        name: {
            "type": name,
            "geometry": [{"type": "MultiSurface", "lod": "1", "boundaries": [[[0, 1, 2]]]}],
        }
        for name in ("Building", "Road")
    },
    "vertices": [[0, 0, 0], [4, 0, 0], [0, 3, 0]],
}


@pytest.fixture
def call(tmp_path, capsys, monkeypatch):
    """Runs a command in a folder with a mesh of each kind: (exit code, output, messages)."""
    monkeypatch.chdir(tmp_path)
    (tmp_path / "square.ply").write_text(SQUARE)
    (tmp_path / "cloud.ply").write_text(PLY.format(0))
    (tmp_path / "town.city.json").write_text(json.dumps(CITY))

    def run(*arguments):
        code = main([*arguments])
        out, err = capsys.readouterr()
        return code, out, err

    return run


def test_info_of_a_mesh_as_text(call):
    code, out, err = call("info", "town.city.json")
    assert (code, err) == (0, "")
    assert out.splitlines() == [
        "format     mesh (CityJSON)",
        "triangles  2, with 3 vertices",
        "x          0.000 to 4.000 m",
        "y          0.000 to 3.000 m",
        "z          0.000 to 0.000 m",
        "crs        EPSG:7415 (Amersfoort / RD New + NAP height)",
        "area       12 m²",
        "material   Building: 1 triangle, 6 m², class 6",
        "material   Road: 1 triangle, 6 m², class 11, ground",
        "parts      2",
        "part       Building: 1 triangle, 6 m²",
        "part       Road: 1 triangle, 6 m²",
    ]


def test_info_of_many_parts_shows_the_first(call, tmp_path):
    objects = {f"house {i:02}": CITY["CityObjects"]["Building"] for i in range(13)}
    (tmp_path / "many.city.json").write_text(json.dumps({**CITY, "CityObjects": objects}))
    lines = call("info", "many.city.json")[1].splitlines()
    assert lines[-12:-10] == ["parts      13", "part       house 00: 1 triangle, 6 m²"]
    assert lines[-1] == "           and 3 more; --json lists all"
    facts = json.loads(call("info", "many.city.json", "--json")[1])
    assert len(facts["parts"]) == 13
    assert facts["parts"][12] == {"id": 12, "name": "house 12", "triangles": 1, "area_m2": 6.0}


def test_info_of_a_mesh_as_json(call):
    code, out, _ = call("info", "square.ply", "--json")
    facts = json.loads(out)
    assert code == 0
    assert facts["triangles"] == 2 and facts["vertices"] == 4 and facts["area_m2"] == 12.0
    assert facts["bounds"] == {"minimum": [10, 0, 0], "maximum": [14, 3, 0]}
    assert facts["materials"] == [
        {
            "name": "default", "triangles": 2, "area_m2": 12.0, "reflectance": None, "class": 0,
            "ground": False,
        }
    ]  # fmt: skip


def test_info_of_reflectances(call, tmp_path):
    (tmp_path / "a.mtl").write_text("newmtl leaf\nhelios_reflectance 0.25\n")
    (tmp_path / "a.obj").write_text(
        "mtllib a.mtl\nusemtl leaf\nv 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n"
    )
    out = call("info", "a.obj")[1]
    assert "material   leaf: 1 triangle, 0.5 m², reflectance 0.25, class 0\n" in out


def test_ply_without_faces_is_a_cloud(call):
    code, out, _ = call("info", "cloud.ply", "--json")
    assert code == 0
    assert json.loads(out)["points"] == 4


def test_info_of_a_damaged_mesh(call, tmp_path):
    (tmp_path / "bad.stl").write_text("solid a\nvertex 1 2 x\n")
    code, out, err = call("info", "bad.stl")
    assert (code, out) == (1, "")
    assert 'bad.stl:2: "x" is not a number' in err


def test_convert_writes_obj(call, tmp_path):
    code, out, err = call("convert", "town.city.json", "town.obj")
    assert code == 0
    assert out == "output   town.obj: 2 triangles\n"
    assert err == (
        "warning: town.city.json: its coordinate system EPSG:7415 is dropped: OBJ has none\n"
        "warning: town.city.json: the names of its 2 parts are dropped: OBJ has none\n"
    )
    scene = vtkhelios.Scene.read(tmp_path / "town.obj")
    assert len(scene) == 2
    assert "class 11, ground" in call("info", "town.obj")[1]
    code, _, err = call("convert", "town.city.json", "town.obj")
    assert code == 1 and "town.obj: already exists; give --overwrite to replace it" in err
    assert call("convert", "square.ply", "town.obj", "--overwrite")[0] == 0
    assert len(vtkhelios.Scene.read(tmp_path / "town.obj")) == 2


@pytest.mark.parametrize(
    ("arguments", "message"),
    [
        (
            ("cloud.ply", "a.obj"),
            "a.obj: OBJ is written of one mesh (.obj, .tif, .tiff, .vrt, .ply, ",
        ),
        (("square.ply", "square.ply", "a.obj"), "a.obj: OBJ is written of one mesh"),
        (("none.stl", "a.obj"), "none.stl: no such file or folder; check its name"),
        (("square.ply", "a.obj", "--class", "2"), "--class is for points, and this is a mesh"),
        (("square.ply", "a.obj", "--every", "2"), "--every is for points"),
        (("square.ply", "none/a.obj"), "none/a.mtl"),
    ],
)
def test_convert_refuses(call, arguments, message):
    code, _, err = call("convert", *arguments)
    assert code == 1
    assert message in err and "Traceback" not in err


def test_convert_does_not_overwrite_its_input(call):
    call("convert", "square.ply", "a.obj")
    code, _, err = call("convert", "a.obj", "a.obj", "--overwrite")
    assert code == 1 and "a.obj: is also an input; give another name" in err
