# SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
# SPDX-License-Identifier: BSD-3-Clause
"""The study of real clouds flown again: its parts on scenes made here, and AHN3 where it is."""

import importlib
import pathlib
import types

import numpy as np
import pytest

import vtkhelios

from _real_data import real_file

STUDIES = pathlib.Path(__file__).resolve().parents[2] / "studies"


@pytest.fixture
def load(monkeypatch):
    monkeypatch.syspath_prepend(STUDIES)
    return importlib.import_module


BOX = """\
mtllib other.mtl
v 0 0 0
v 10 0 0
v 10 0 10
v 0 0 10
v 0 20 0
v 10 20 0
usemtl BuildingWall
f 1 2 3
f 1 3 4
usemtl Road
f 1 2 6
f 1 6 5
"""


def test_materials_of_a_model_have_classes(load, tmp_path):
    (tmp_path / "model.obj").write_text(BOX)
    (tmp_path / "out").mkdir()
    scene = load("_real_clouds").write_city(tmp_path / "model.obj", tmp_path / "out")
    assert scene == "city.xml#city"
    text = (tmp_path / "out/city.mtl").read_text()
    assert "newmtl BuildingWall\nhelios_reflectance 0.3\nhelios_classification 6" in text
    assert "newmtl Road\nhelios_reflectance 0.3\nhelios_classification 2" in text
    assert "mtllib city.mtl" in (tmp_path / "out/city.obj").read_text()


def test_share_of_facades_with_echoes(load, tmp_path):
    """Echoes on the left half of a wall of 10 x 10 m."""
    study = load("_real_clouds")
    (tmp_path / "model.obj").write_text(BOX)
    study.write_city(tmp_path / "model.obj", tmp_path)
    x, z = np.meshgrid(np.arange(0, 5, 0.2), np.arange(0, 10, 0.2))
    points = np.column_stack([x.ravel(), 0 * x.ravel(), z.ravel()])
    box = np.array([-50.0, -50.0]), np.array([50.0, 50.0])
    share, places = study.facade_share(tmp_path / "city.obj", points, box)
    assert 50 < places < 110 and share == pytest.approx(0.5, abs=0.15)


def test_tables_of_returns(load):
    study = load("_real_clouds")
    cloud = vtkhelios.Cloud.from_arrays(
        np.array([[0, 0, 9.0], [0, 0, 5], [1, 0, 0], [2, 0, 0]]),
        GpsTime=np.array([0.0, 0, 1, 2]),
        ReturnNumber=np.array([1, 2, 1, 1], np.uint8),
        NumberOfReturns=np.array([2, 2, 1, 1], np.uint8),
        ClassificationIds=np.array([1, 2, 2, 2], np.int32),
    )
    rows = list(load("_cloud_tables").class_rows(cloud, cloud, {1: "trees", 7: "none"}))
    assert rows == [["1 (trees)", "1", "2.00", "1", "2.00"], ["7 (none)", "0", "", "0", ""]]
    assert study.separation_of(cloud) == 4.0


def make_strips(x, legs):
    points = np.column_stack([x, np.zeros(len(x)), np.zeros(len(x))])
    first = np.ones(len(x), np.uint8)
    return vtkhelios.Cloud.from_arrays(points, ReturnNumber=first, LegIds=np.array(legs, np.int32))


def test_pulses_of_strips(load):
    """In squares of 2 m of both clouds; an infinite side counts all."""
    tables = load("_cloud_tables")
    real = make_strips([0.0, 1.0, 2.5, 9.0], [40, 40, 50, 50])
    simulated = make_strips([0.5, 2.1, 2.2, 20.0], [0, 1, 1, 1])
    strips = [
        types.SimpleNamespace(number=1, source=40),
        types.SimpleNamespace(number=2, source=50),
    ]
    rows, area = tables.strip_pulses(real, simulated, strips)
    assert rows[0] == ["pulses of strip 1", "2", "1", "-50.0 %", ""]
    assert rows[1] == ["pulses of strip 2", "1", "2", "+100.0 %", ""] and area == 8.0
    rows, _ = tables.strip_pulses(real, simulated, strips, np.inf)
    assert rows[1][1:3] == ["2", "3"]
    assert tables.count_row("none", 0, 0) == ["none", "0", "0", "", ""]


def test_rows_of_metrics(load):
    tables = load("_cloud_tables")
    row = types.SimpleNamespace(
        a=(0.0123, 0.01, 0.015), b=None, difference=(0.5, np.nan, np.nan), unit="m", agrees=False
    )
    found = tables.metric_row({"noise": row}, "noise", "noise of roofs", millimetres=True)
    assert found == ["noise of roofs [mm]", "12.3 [10, 15]", "", "500", "differs"]
    result = types.SimpleNamespace(shift=[None, None, (-0.0038, -0.0059, -0.0021)])
    assert tables.shift_row(result)[3] == "-3.8 [-5.9, -2.1]"
    result.shift[2] = None
    assert tables.shift_row(result)[3] == "not determined"


def test_yaw_off_the_course(load):
    """Across north."""
    fit = types.SimpleNamespace(of_strip=lambda *_: types.SimpleNamespace(value=359.0))
    strip = types.SimpleNamespace(number=1, angles=np.array([[0, 0, 1.0], [2, 0, 358.0]]))
    assert load("_cloud_tables").attitude_range(fit, strip, 2) == "-1.0 to 2.0 deg"
    assert load("_cloud_tables").attitude_range(fit, strip, 0) == "0.0 to 2.0 deg"


def test_an_absent_cloud_is_named(load, tmp_path):
    with pytest.raises(FileNotFoundError) as error:
        list(load("real_clouds").make_tables(tmp_path, None))
    assert error.value.filename == str(tmp_path / "als/ahn3_delft_1.laz")


def test_trees_of_the_forest(load, tmp_path):
    forest = load("_forest")
    trees = forest.place_trees(50.0)
    assert len(trees) == 200 and np.array_equal(trees, forest.place_trees(50.0))
    apart = np.linalg.norm(trees[:, None, :2] - trees[None, :, :2], axis=2) + 10 * np.eye(200)
    assert apart.min() > forest.SPACING
    assert trees[:, 2].mean() == pytest.approx(10.5, abs=0.6)
    scene = forest.write_forest(tmp_path, (1000.0, 2000.0), 50.0, side=8.0)
    assert scene == "forest.xml#forest"
    text = (tmp_path / "forest.xml").read_text()
    assert text.count("<part ") == 1 + len(forest.place_trees(8.0))
    assert "v 936.000 1936.000 50.000" in (tmp_path / "ground_of_forest.obj").read_text()


def test_ahn3_is_flown_again(load, tmp_path):
    """Pulses of the strip that covers the model, by square, and the spacing of its pulses."""
    cloud, model = real_file("als/ahn3_delft_1.laz"), real_file("scene/delft_testarea.obj")
    parts, study = load("_real_clouds"), load("real_clouds")
    with pytest.warns(RuntimeWarning, match="triangles, which have no area"):
        scene = parts.write_city(model, tmp_path)
        fit, simulated = study.fit_and_fly([cloud], tmp_path, scene)
    real = parts.read_cloud(cloud)
    counts, corner = [], real.points[:, :2].min(axis=0)
    for each, leg in ((real, fit.strips[1].source), (simulated, 1)):
        first = (each["ReturnNumber"] == 1) & (each["LegIds"] == leg)
        place = np.floor((each.points[first, :2] - corner) / 8).astype(int)
        place = place[((place >= 0) & (place < 100)).all(axis=1)]
        counts.append(np.bincount(place @ [100, 1], minlength=10_000))
    both = (counts[0] > 200) & (counts[1] > 200)
    ratio = counts[1][both].sum() / counts[0][both].sum()
    assert both.sum() > 100 and ratio == pytest.approx(1, abs=0.03)
