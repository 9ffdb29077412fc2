# SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
# SPDX-License-Identifier: BSD-3-Clause
"""vtkhelios new: every kind of example is valid, runs, and has what its README says."""

import collections
import json
import math
import pathlib
import re
import shutil

import numpy as np
import pytest
from vtkmodules.util.numpy_support import vtk_to_numpy

import vtkhelios
from vtkhelios import cli
from vtkhelios.example_surveys import KINDS, als, city, forest, mls, river, tls, write_example

# Classes of the echoes: ground 2, low vegetation 3, high vegetation 5, building 6, water 9, road 11,
# bridge 17, bottom of water 40, and of other things 1.
CLASSES = {
    "tls": {2, 5, 6, 11},
    "als": {2, 5, 6},
    "uls": {1, 2, 5},
    "mls": {1, 5, 6, 11},
    "street": {1, 5, 6, 11},
    "forest": {2, 3, 5},
    "city": {2, 5, 6, 11},
    "river": {1, 2, 3, 5, 9, 11, 17, 40},
}
FEWER = 25  # every n-th pulse


@pytest.fixture(scope="module")
def examples(tmp_path_factory):
    """The folders of all kinds, by kind."""
    parent = tmp_path_factory.mktemp("examples")
    for kind in KINDS:
        write_example(kind, parent / kind)
    return {kind: parent / kind for kind in KINDS}


def run(folder, **options):
    return vtkhelios.read_survey(folder / f"{folder.name}.xml").run(pulse_step=FEWER, **options)


@pytest.mark.parametrize("kind", KINDS)
def test_every_kind_runs(kind, examples):
    cloud = run(examples[kind])
    assert len(cloud) > 2000
    assert CLASSES[kind] == set(np.unique(cloud["ClassificationIds"]))
    assert set(np.unique(cloud["LegIds"])) <= set(range(5))


@pytest.mark.parametrize("kind", KINDS)
def test_every_kind_is_valid(kind, examples, capsys):
    assert cli.main(["validate", str(examples[kind] / f"{kind}.xml")]) == 0
    said = capsys.readouterr()
    assert said.err == ""


@pytest.mark.parametrize("kind", KINDS)
def test_the_readme_names_the_files(kind, examples):
    folder = examples[kind]
    text = (folder / "README.md").read_text()
    assert "@" not in text
    assert f"vtkhelios run {kind}.xml " in text
    named = set(re.findall(r"`([\w.]+\.\w+)`", text))
    present = {path.name for path in folder.iterdir()} - {"README.md"}
    own_materials = {path.with_suffix(".mtl").name for path in folder.glob("*.obj")}
    assert present - own_materials <= named


def test_the_command_makes_what_it_prints(tmp_path, monkeypatch, capsys):
    monkeypatch.chdir(tmp_path)
    assert cli.main(["new", "my yard"]) == 0
    said = capsys.readouterr().out
    assert said.startswith("my yard: a house and its yard")
    assert said.endswith("to run it:\n  cd 'my yard'\n  vtkhelios run 'my yard'.xml\n")
    monkeypatch.chdir(tmp_path / "my yard")
    assert cli.main(["run", "my yard.xml", "--dry-run"]) == 0
    assert "points" in capsys.readouterr().out


def test_the_same_kind_has_the_same_bytes(tmp_path, examples):
    again = write_example("mls", tmp_path / "mls")
    assert [path.name for path in again] == sorted(path.name for path in examples["mls"].iterdir())
    for path in again:
        assert path.read_bytes() == (examples["mls"] / path.name).read_bytes()


# Contents of the scenes.


@pytest.mark.parametrize("kind", [als, river], ids=["als", "river"])
def test_rasters_are_geotiff_for_other_readers(kind, examples):
    gdal = pytest.importorskip("osgeo.gdal")
    gdal.UseExceptions()
    raster = gdal.Open(str(examples[kind.__name__.rpartition(".")[2]] / "terrain.tif"))
    corner = (kind.WEST, kind.PIXEL, 0.0, kind.SOUTH + kind.DEPTH, 0.0, -kind.PIXEL)
    assert raster.GetGeoTransform() == corner
    assert raster.GetSpatialRef().GetAuthorityCode(None) == str(kind.EPSG)
    assert raster.GetMetadataItem("AREA_OR_POINT") == "Area"
    heights = raster.ReadAsArray()
    assert heights.shape == (kind.DEPTH / kind.PIXEL, kind.WIDTH / kind.PIXEL)
    row, column = 3, 7
    x, y = (column + 0.5) * kind.PIXEL, kind.DEPTH - (row + 0.5) * kind.PIXEL
    assert heights[row, column] == np.float32(kind.height_at(x, y))


def test_houses_of_the_city_are_closed_and_face_outwards(examples):
    document = json.loads((examples["city"] / "city.city.json").read_text())
    vertices = np.array(document["vertices"]) / 1000.0
    houses = [each for each in document["CityObjects"].values() if each["type"] == "Building"]
    assert len(houses) == 48
    for house in houses:
        (shell,) = house["geometry"][0]["boundaries"]
        edges, volume = collections.Counter(), 0.0
        for (ring,) in shell:
            edges.update(zip(ring, ring[1:] + ring[:1]))
            a, *others = vertices[ring]
            volume += sum(np.dot(a, np.cross(b, c)) for b, c in zip(others, others[1:])) / 6.0
        assert all(edges[edge] == edges[edge[::-1]] == 1 for edge in edges)
        floors, roof = house["attributes"]["storeysAboveGround"], volume / city.WIDTH / city.DEPTH
        assert 3.2 * floors + 1.5 <= roof + 1e-9 <= 3.2 * floors + 2.0 + 1e-8


def test_the_car_follows_the_trajectory(examples):
    survey = vtkhelios.read_survey(examples["mls"] / "mls.xml")
    flown = survey.trajectory(0, 0.5)
    rows = mls.make_trajectory()
    assert flown["GpsTime"][-1] == pytest.approx(4.0, abs=1e-4)
    for axis in range(3):
        expected = np.interp(flown["GpsTime"], rows[:, 0], rows[:, 4 + axis])
        assert flown.points[:, axis] == pytest.approx(expected, abs=1e-3)


def test_tables_place_on_the_ground(examples):
    rows = (examples["forest"] / "stand.csv").read_text().splitlines()
    scene = vtkhelios.read_survey(examples["forest"] / "forest.xml").source(instances=False)
    assert scene.Load()
    mesh = vtkhelios.Scene(scene.GetScene())
    parts = vtk_to_numpy(mesh.polydata.GetCellData().GetArray("PartIds"))
    first = parts == 1  # after the ground; voxels come last
    _, x, y = rows[1].split(",")
    lowest = mesh.points[mesh.triangles[first].ravel(), 2].min()
    assert lowest == pytest.approx(forest.height_at(float(x), float(y)), abs=0.5)


def test_the_river_has_a_surface_and_a_bed(examples):
    cloud = run(examples["river"], truth=True, noise=False)
    water, bed = (cloud["ClassificationIds"] == kind for kind in (9, 40))
    assert water.sum() > 300 and bed.sum() > 300
    assert cloud.points[water, 2] == pytest.approx(river.WATER, abs=0.1)
    true, apparent = cloud["TruePoint"][bed, 2], cloud.points[bed, 2]
    # The optical length 1.34 d / cos(b) along the beam, 20 degrees off nadir; sin(b) = sin(20) / 1.34.
    beam = math.radians(20.0)
    stretch = 1.34 / math.cos(math.asin(math.sin(beam) / 1.34)) * math.cos(beam)
    ratio = (river.WATER - apparent) / (river.WATER - true)
    assert np.median(ratio) == pytest.approx(stretch, rel=0.01)


def test_near_infrared_as_the_readme_of_the_river_says(examples, tmp_path):
    folder = pathlib.Path(shutil.copytree(examples["river"], tmp_path / "river"))
    settings = re.findall(r'`(\w+="[^"]+")`', (folder / "README.md").read_text())
    assert len(settings) == 4
    text = (folder / "river.xml").read_text()
    for setting in settings:
        text = re.sub(rf'{setting.split("=")[0]}="[^"]*"', setting, text)
    (folder / "river.xml").write_text(text)
    cloud = run(folder, truth=True)
    is_deep = cloud["TruePoint"][:, 2] < river.WATER - 0.3
    assert (cloud["ClassificationIds"] == 9).sum() > 100
    assert not is_deep.any()


def test_the_ground_of_the_yard_is_level_below_the_house():
    assert tls.height_at(np.array([0.0, 6.0]), np.array([0.0, -6.0])) == pytest.approx([0.0, 0.0])


# Errors.


def test_an_existing_folder_is_kept(tmp_path, capsys):
    (tmp_path / "yard").mkdir()
    assert cli.main(["new", str(tmp_path / "yard")]) == 1
    said = capsys.readouterr().err
    assert said == f"error: {tmp_path}/yard: exists and is kept; give another name, or remove it\n"
    assert list(tmp_path.iterdir()) == [tmp_path / "yard"]


def test_a_folder_that_cannot_be_made_is_named(tmp_path, capsys):
    (tmp_path / "file").write_text("")
    assert cli.main(["new", str(tmp_path / "file/yard")]) == 1
    assert re.fullmatch(
        rf"error: {tmp_path}/file: cannot be written: .*; give another NAME\n",
        capsys.readouterr().err,
    )


def test_nothing_is_left_of_an_example_that_fails(tmp_path, monkeypatch):
    def fail(folder):
        (folder / "half.obj").write_text("")
        raise OSError(28, "No space left on device", "half.obj")

    monkeypatch.setattr(tls, "write_geometry", fail)
    with pytest.raises(OSError, match="No space"):
        write_example("tls", tmp_path / "yard")
    assert list(tmp_path.iterdir()) == []


def test_an_unknown_kind_names_the_nearest(tmp_path, capsys):
    with pytest.raises(SystemExit) as end:
        cli.main(["new", str(tmp_path / "x"), "--kind", "forrest"])
    assert end.value.code == 2
    assert "unknown 'forrest': did you mean forest?" in capsys.readouterr().err
    with pytest.raises(ValueError, match="kind is 'x'; known: tls, als"):
        write_example("x", tmp_path / "x")
