# SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
# SPDX-License-Identifier: BSD-3-Clause
"""vtkhelios.plan(): plans with a known number of scans, settings, progress, and the same files as the
command line's."""

import json
import os
import pathlib
import signal
import threading

import numpy as np
import pytest

import vtkhelios
from vtkhelios.plans import plan as planning
from vtkhelios.plans.settings import SETTINGS, SettingError, report_settings
from vtkhelios.cli import main

SIZE, HEIGHT = 4.0, 3.0  # m, of a room


def make_rooms(count):
    """Square rooms in a row, with thin walls, without ceilings: every one needs its own scan."""
    points, triangles = [], []

    def add(*corners):
        first = len(points)
        points.extend(corners)
        triangles.extend([(first, first + 1, first + 2), (first, first + 2, first + 3)])

    length = count * SIZE
    add((0, 0, 0), (length, 0, 0), (length, SIZE, 0), (0, SIZE, 0))
    for y in (0, SIZE):
        add((0, y, 0), (length, y, 0), (length, y, HEIGHT), (0, y, HEIGHT))
    for x in np.arange(count + 1) * SIZE:
        add((x, 0, 0), (x, SIZE, 0), (x, SIZE, HEIGHT), (x, 0, HEIGHT))
    return vtkhelios.Scene(np.array(points, dtype=float), np.array(triangles))


@pytest.fixture
def rooms():
    return make_rooms(3)


# Results.


@pytest.mark.parametrize("count", [1, 2, 4])
@pytest.mark.parametrize("method", ["reduce", "greedy", "best", "optimal"])
def test_as_many_scans_as_rooms(count, method):
    plan = vtkhelios.plan(make_rooms(count), grid=1, method=method)
    assert sorted(plan.positions[:, 0] // SIZE) == list(range(count))
    assert plan.positions[:, 2] == pytest.approx(1.7)
    assert (len(plan), plan.coverage, plan.is_proved_optimal) == (count, 100, True)
    assert plan.report["candidates"] == len(plan.candidates) == 16 * count
    assert (
        plan.report["coverable"] == len(plan.test_points) == (plan.test_points["Coverable"]).sum()
    )
    assert (plan.test_points["NumberOfScans"] > 0).all()
    assert plan.candidates["Selected"].sum() == count
    assert plan.scans["NewlyCovered"].sum() == len(plan.test_points)


def test_less_coverage_needs_fewer_scans(rooms):
    assert len(vtkhelios.plan(rooms, grid=1, coverage=60)) == 2  # a room has more than 30 %
    assert len(vtkhelios.plan(rooms, grid=1, coverage=30)) == 1


def test_settings_reach_the_filters(rooms):
    areas = vtkhelios.Scene(
        [[0, -1, 0], [SIZE, -1, 0], [SIZE, 9, 0], [0, 9, 0]], [[0, 1, 2], [0, 2, 3]]
    )
    plan = vtkhelios.plan(rooms, grid=1, exclude=areas, height=2, test_lines="vertical")
    assert len(plan) == 2 and plan.positions[:, 0].min() > SIZE
    assert plan.positions[:, 2] == pytest.approx(2)
    assert plan.test_points.points[:, 2] == pytest.approx(0)
    assert plan.report["settings"]["exclude"] == "polygons"
    plan = vtkhelios.plan(rooms, grid=1, grid_y=2, test_grid=0.5, region=(0, SIZE, 0, SIZE))
    assert len(plan.candidates) == 8
    assert np.ptp(plan.test_points.points[:16, 0]) == pytest.approx(7.5)


# Values of a document and of the caller: a value, the value that the caller gives, and what the
# report says of both.
GIVEN = {
    "method": ("best", "optimal"),
    "grid": (2, 1.5),
    "grid_y": (2.5, 1),
    "test_grid": (1, 0.5),
    "test_lines": ("vertical", "all"),
    "region": (None, [0, 8, 0, 4]),
    "region_of": ("candidates", "all"),
    "candidates": (None, None),
    "exclude": (None, None),
    "max_slope": (20, 10),
    "ground": ("false", "auto"),
    "enclosed": (True, False),
    "height": (1.5, 2),
    "tolerance": (0.02, 0.03),
    "two_sided": (True, False),
    "scanner_limits": (True, False),
    "moving_parts": (True, False),
    "range_min": (0.25, 0.5),
    "range_max": (30, 40),
    "elevation_min": (-80, -85),
    "elevation_max": (70, 75),
    "max_incidence": (89, 88),
    "min_density": (1, 2),
    "coverage": (50, 60),
    "coverage_of": ("all", "coverable"),
    "area_weights": (True, False),
    "overlap": (0, 7),
    "objects": (0, 30),
    "order": ("gain", "walk"),
    "remove_order": ("viewshedSize", "meanIncidenceAngle"),
    "remove_first": ("smallest", "largest"),
    "setup_time": (300, 60),
    "walking_speed": (1, 2),
    "crs": (None, "EPSG:25832"),
    "time_limit": (20, 30),
}
DOCUMENT = """\
<document>
  <surveyPlanner id="rooms" scene="scene.xml#s" platform="platforms.xml#tripod"
    scanner="scanners.xml#vz400_class_tls" {0}>{1}</surveyPlanner>
  <scene id="s"><part><filter type="objloader">
    <param type="string" key="filepath" value="rooms.obj"/></filter></part></scene>
</document>
"""
FULL = """method="best" gridSizePSP_m="2" gridSizePSPy_m="2.5" gridSizeVTP_m="1" vtpLines="vertical"
 maxSlope_deg="20" groundOnly="false" enclosed="true" scannerHeight_m="1.5" hitTolerance_m="0.02"
 hitBehind="false" scannerLimits="true" movingParts="true" rangeMin_m="0.25" rangeMax_m="30" elevationMin_deg="-80"
 elevationMax_deg="70" maxIncidence_deg="89" minPointDensity_1_m2="1" minCoverage_percent="50"
 coverageOf="all" areaWeights="true" timeLimit_s="20" """


@pytest.fixture
def write_document(tmp_path, rooms, monkeypatch):
    """Writes a planner document with some attributes, and its scene, beside scene.xml."""
    monkeypatch.chdir(tmp_path)
    rooms.write(tmp_path / "rooms.obj")
    (tmp_path / "scene.xml").write_text(DOCUMENT.format("", ""))

    def write(attributes, child=""):
        (tmp_path / "plan.xml").write_text(DOCUMENT.format(attributes, child))
        return "plan.xml"

    return write


@pytest.mark.parametrize("by_document", [True, False])
def test_a_document_and_settings_that_override_it(write_document, by_document):
    assert GIVEN.keys() == {name for name, setting in SETTINGS.items() if setting.reported}
    column = 0 if by_document else 1
    given = {} if by_document else {name: values[1] for name, values in GIVEN.items()}
    # The reader's, which only add to the document.
    for name in ("scanner_limits", "moving_parts"):
        given.pop(name, None)
    task = planning.PlanTask(write_document(FULL), **given)
    wanted = {name: values[column] for name, values in GIVEN.items()} | {
        "scanner_limits": True,
        "moving_parts": True,
    }
    assert {name: task.settings[name] for name in GIVEN} == wanted
    assert report_settings(task.settings)["hitBehind"] != wanted["two_sided"]
    assert "timeLimit_s" in report_settings({**wanted, "method": "optimal"})
    assert "timeLimit_s" not in report_settings({**wanted, "method": "reduce"})
    filters = task.filters
    assert filters.candidates.x_step == wanted["grid"]
    assert filters.candidates.surface == {"false": "highest", "auto": "automatic"}[wanted["ground"]]
    assert filters.candidates.skip_enclosed != wanted["enclosed"]
    assert filters.test_points.horizontal == (wanted["test_lines"] == "all")
    assert filters.test_points.generate_areas == filters.planner.use_areas == wanted["area_weights"]
    assert filters.viewsheds.maximum_range == wanted["range_max"]
    assert filters.viewsheds.angular_step == pytest.approx(0.1)
    assert filters.planner.method == wanted["method"]
    assert filters.planner.minimum_overlap == pytest.approx(wanted["overlap"] / 100)


def test_methods_and_orders_of_removal(write_document):
    def method(attributes, **settings):
        return planning.PlanTask(write_document(attributes), **settings).filters.planner.method

    assert method("") == "viewshed_size"
    assert method("", remove_order="meanIncidenceAngle") == "mean_incidence_angle"
    assert method('pspRemoveOrder="meanIncidenceAngle"') == "mean_incidence_angle"
    assert method('pspRemoveOrder="meanIncidenceAngle"', method="best") == "best"
    later = 'method="best" pspRemoveOrder="meanIncidenceAngle"'
    assert method(later) == "best" and method(later, method="reduce") == "mean_incidence_angle"
    assert method('method="bestcoverage"') == method("", method="bestcoverage") == "greedy"


def test_one_grid_stands_for_all(write_document, rooms):
    task = planning.PlanTask(write_document('gridSizePSP_m="2" gridSizeVTP_m="1"'), grid=3)
    assert (task.settings["grid_y"], task.settings["test_grid"]) == (3, 3)
    task = planning.PlanTask("plan.xml", test_grid=0.5)
    assert (task.settings["grid"], task.settings["test_grid"]) == (2, 0.5)
    assert planning.PlanTask(rooms).settings["grid"] == 0  # chosen by the filters


def test_all_kinds_of_scenes(write_document, rooms, tmp_path):
    reader = vtkhelios.vtkHeliosPlannerReader(
        file_name="rooms.obj", default_platform="platforms.xml#tripod"
    )
    reader.AddAssetDirectory(str(vtkhelios.data_directory() / "Assets"))
    obj = vtkhelios.vtkHeliosObjSceneReader(file_name="rooms.obj")
    write_document("")
    wanted = vtkhelios.plan(rooms, grid=1)
    scenes = [rooms.polydata, obj, "rooms.obj", pathlib.Path("rooms.obj"), "scene.xml", reader]
    for scene in scenes:
        plan = vtkhelios.plan(scene, grid=1, method="best", scanner="vz400_class_tls")
        assert np.array_equal(plan.positions, wanted.positions), scene
        assert plan.report["result"] == wanted.report["result"]
    assert wanted.report["source"] == {"file": None, "kind": "scene"}
    assert wanted.name == "plan" and vtkhelios.plan(rooms, grid=1, name="flat").name == "flat"
    assert vtkhelios.plan("scene.xml").name == "rooms"


def test_a_later_run_does_not_change_a_plan(rooms):
    task = planning.PlanTask(rooms, grid=1)
    first = task.run()
    before = first.positions.copy(), first.report
    task.filters.candidates.SetStep(2)
    second = task.run()
    assert len(second.candidates) < len(first.candidates)
    assert np.array_equal(first.positions, before[0]) and first.report == before[1]
    assert set(first.seconds) > {"loading the scene", "finding candidates", "selecting positions"}


def test_how_a_plan_is_shown(rooms):
    plan = vtkhelios.plan(rooms, grid=1)
    words = "3 scans, the fewest of 48 candidates, cover 100.00 % of the 168 coverable test points"
    assert repr(plan) == f"Plan('plan': {words})"
    assert words in plan._repr_html_() and plan._repr_html_().count("<tr>") == 4
    one = vtkhelios.plan(make_rooms(1), grid=1, name="<b>")
    assert repr(one).startswith("Plan('<b>': 1 scan, ") and "<b>" not in one._repr_html_()


@pytest.mark.parametrize("order", ["walk", "round"])
def test_the_shortest_walk(order):
    plan = vtkhelios.plan(make_rooms(4), grid=1, order=order)
    x = plan.positions[:, 0]
    steps = np.linalg.norm(np.diff(plan.positions, axis=0), axis=1).sum()
    back = np.linalg.norm(plan.positions[-1] - plan.positions[0]) if order == "round" else 0
    assert plan.report["walk"]["length_m"] == pytest.approx(steps + back)
    assert plan.report["walk"]["isProvedShortest"]
    assert [row["x"] for row in plan.report["positions"]] == pytest.approx(x.tolist())
    if order == "walk":
        assert (np.diff(x) > 0).all() or (np.diff(x) < 0).all()
    assert "walk" not in vtkhelios.plan(make_rooms(1), grid=1).report


def test_shares_of_objects():
    scene = make_rooms(1) + vtkhelios.Scene(
        make_rooms(1).points + (20, 0, 0), make_rooms(1).triangles
    )
    assert len(vtkhelios.plan(scene, grid=1)) == 2
    plan = vtkhelios.plan(scene, grid=1, objects=40)
    assert len(plan) == 2  # coverage of 40 % in all would be one
    assert [row["covered_percent"] >= 40 for row in plan.report["objects"]] == [True, True]
    assert len(vtkhelios.plan(scene, grid=1, coverage=40)) == 1


def test_settings_are_documented():
    for name in SETTINGS:
        words = planning.plan.__doc__.replace(",", " ").split()
        assert name in words, name


# The same as the command line.


@pytest.mark.parametrize(
    "attributes",
    [
        "",
        FULL.replace('"best"', '"optimal"'),
        'pspRemoveOrder="meanIncidenceAngle" pspRemoveFirst="largest" gridSizePSP_m="2"',
        'method="bestcoverage" minOverlap_percent="7" gridSizePSP_m="1" minCoverage_percent="60"',
        'method="greedy" gridSizePSP_m="1" vtpLines="horizontal" hitBehind="false"',
    ],
)
def test_the_files_are_those_of_the_command_line(write_document, attributes, tmp_path):
    scan = '<scannerSettings verticalResolution_deg="0.2" horizontalResolution_deg="0.2"/>'
    path = write_document(attributes, scan)
    assert main(["plan", path, "--no-picture", "--quiet"]) == 0
    paths = vtkhelios.plan(path).write("plans")
    names = sorted(path.name for path in (tmp_path / "output/rooms").iterdir())
    assert names == sorted(path.name for path in paths)
    for path in paths:
        same = tmp_path / "output/rooms" / path.name
        if path.suffix == ".json":
            mine, theirs = json.loads(path.read_text()), json.loads(same.read_text())
            assert mine.pop("timings").keys() == theirs.pop("timings").keys()
            assert mine == theirs and list(mine) == list(theirs)
        else:
            assert path.read_bytes() == same.read_bytes(), path


def test_an_earlier_plan_is_kept(rooms, tmp_path):
    plan = vtkhelios.plan(rooms, grid=1)
    paths = plan.write(tmp_path)
    assert {path.name for path in (tmp_path / "plan").iterdir()} > {path.name for path in paths}
    with pytest.raises(FileExistsError, match="earlier plan; give overwrite=True"):
        plan.write(tmp_path)
    assert plan.write(tmp_path, overwrite=True) == paths
    for path in paths:
        path.unlink()  # all but the scene, which may be another one
    with pytest.raises(FileExistsError, match="give overwrite=True"):
        plan.write(tmp_path)


def test_a_scene_in_memory_is_written(rooms, tmp_path):
    plan = vtkhelios.plan(rooms, grid=1, resolution=1, name="flat")
    paths = plan.write(tmp_path)
    assert (tmp_path / "flat/scene.obj").is_file()
    written = vtkhelios.read_survey(paths[0])
    survey = plan.survey()
    survey.write(tmp_path / "again.xml")
    again = vtkhelios.read_survey(tmp_path / "again.xml", scene=rooms)
    assert [leg.position for leg in again.legs] == [leg.position for leg in written.legs]
    assert [leg.position for leg in survey.legs] == [leg.position for leg in written.legs]
    assert survey.name == written.name == "flat"
    clouds = survey.run(legs=0, noise=False), written.run(legs=0, noise=False)
    assert np.array_equal(clouds[0].points, clouds[1].points) and len(clouds[0]) > 10000


def test_the_survey_of_a_document(write_document):
    plan = vtkhelios.plan(write_document('gridSizePSP_m="2"'), resolution=1)
    survey = plan.survey()
    survey.write("again.xml")
    again = vtkhelios.read_survey("again.xml")
    assert [leg.position for leg in again.legs] == [leg.position for leg in survey.legs]
    assert len(again.parts) == len(survey.parts) == 1
    feet = [leg.position for leg in survey.legs]
    assert np.array(feet) == pytest.approx(plan.positions - [0, 0, 1.7])
    cloud = survey.run(legs=0, noise=False)
    assert cloud.points.min() > -1e-3 and cloud.points[:, 0].max() < 3 * SIZE + 1e-3


def test_a_picture_needs_a_display(rooms, tmp_path, monkeypatch):
    monkeypatch.delenv("DISPLAY", raising=False)
    monkeypatch.setenv("PATH", str(tmp_path))  # without Xvfb
    with pytest.raises(RuntimeError, match="no X display, and no Xvfb .*: apt-get install xvfb"):
        vtkhelios.plan(rooms, grid=1).write(tmp_path, picture=True)


# Errors.


@pytest.mark.parametrize(
    "settings, kind, message",
    [
        (
            {"max_slop": 3},
            TypeError,
            "max_slop is not a setting of a plan; did you mean max_slope?",
        ),
        (
            {"colour": 3},
            TypeError,
            "colour is not a setting of a plan; settings are: method, grid, ",
        ),
        ({"max_slope": 95}, ValueError, "max_slope is 95; its valid range is [0, 90] deg"),
        ({"max_slope": float("nan")}, ValueError, "max_slope is nan; its valid range is [0, 90]"),
        ({"max_slope": "steep"}, TypeError, "max_slope is 'steep'; give a number [deg]"),
        ({"grid": 0}, ValueError, "grid is 0; its valid range is [1e-06, 1e+06] m"),
        ({"overlap": 99.95}, ValueError, "overlap is 99.95; its valid range is [0, 99.9] %"),
        ({"coverage": True}, TypeError, "coverage is True; give a number [%]"),
        ({"resolution": 91}, ValueError, "resolution is 91; its valid range is [1e-06, 90] deg"),
        (
            {"method": "optimum"},
            ValueError,
            "method is 'optimum'; did you mean optimal? (expected one of: reduce, bestcoverage, ",
        ),
        ({"ground": "x"}, ValueError, "ground is 'x'; expected one of: auto, true, false, open"),
        ({"enclosed": "yes"}, TypeError, "enclosed is 'yes'; give True or False"),
        ({"region": (1, 2)}, TypeError, "region is (1, 2); give 4 numbers: x0, x1, y0, y1 [m]"),
        ({"region": (2, 1, 0, 9)}, ValueError, "region is x 2 to 1, y 0 to 9; the first of each"),
        (
            {"exclude": "none.vtp"},
            ValueError,
            "exclude none.vtp: is not a VTK XML file of polygons",
        ),
        ({"exclude": 7}, TypeError, "a Scene is made of"),
        ({"assets": ["nowhere"]}, ValueError, "assets nowhere: no such folder"),
        ({"platform": 7}, TypeError, "platform is 7; give file.xml#id, or an id in platforms.xml"),
        (
            {"range_min": 5, "range_max": 5},
            ValueError,
            "range_min is 5 and range_max is 5, so nothing is visible; give a smaller range_min or a",
        ),
        ({"on": "roof"}, ValueError, "on is 'roof'; expected one of: ground, any"),
        ({"on": "any", "ground": "open"}, ValueError, "on and ground are both given; give one"),
        ({"region_of": "all"}, ValueError, "region_of is all, and region is not given; give it"),
        ({"setup_time": -1}, ValueError, "setup_time is -1; its valid range is [0, 100000] s"),
        (
            {"walking_speed": 0},
            ValueError,
            "walking_speed is 0; its valid range is [0.01, 100] m/s",
        ),
        ({"crs": 25832}, TypeError, "crs is 25832; give a text"),
        (
            {"crs": "EPSG:4326"},
            ValueError,
            "crs EPSG:4326: has units of degrees; a scene has metres",
        ),
        ({"crs": "EPSG:2263"}, ValueError, "crs EPSG:2263: has units of US survey foot; a scene"),
        ({"crs": "UTM"}, ValueError, "crs "),
        ({"candidates": "spots.kml"}, ValueError, "candidates spots.kml: is not CSV or GeoJSON"),
        (
            {"candidates": 7},
            TypeError,
            "candidates has the shape (); give places (n x 2, or n x 3)",
        ),
        ({"candidates": "a.csv"}, ValueError, "candidates a.csv: cannot be read: No such file"),
        ({"candidates": [["a", 1]]}, TypeError, "give a file, or places (n x 2)"),
        (
            {"candidates": [[np.nan, 1]]},
            ValueError,
            "candidates has a coordinate that is not finite",
        ),
        (
            {"candidates": [[1, 1]], "grid_y": 2},
            ValueError,
            "candidates and grid_y are both given; give one of them",
        ),
        (
            {"candidates": [[1, 1]], "region": (5, 6, 0, 1)},
            ValueError,
            "region has none of the 1 places of candidates; give a larger one",
        ),
        ({"progress": 3}, TypeError, "progress is 3; give True, False or a function"),
    ],
)
def test_settings_that_are_not_valid(rooms, settings, kind, message):
    with pytest.raises(kind) as raised:
        vtkhelios.plan(rooms, **settings)
    assert message in str(raised.value)


@pytest.mark.parametrize(
    "settings, message",
    [
        ({"scanner": "tls"}, 'scanner="scanners.xml#tls": '),
        ({"platform": "copter_linearpath"}, "moves, but positions are planned for a static one"),
        ({"ground": True}, "Candidates are to be on the ground, but no material of the scene is"),
        ({"region": (50, 60, 0, 1)}, "have no surface below"),
        ({"grid": 0.001, "memory": 64}, "more than the memory limit (64 MiB); make the grid of"),
        ({"range_max": 0.01}, "no candidate sees any test point"),
        ({"region": (0, SIZE, 0, 4), "coverage_of": "all"}, "the minimum coverage of 100 % of all"),
        ({"overlap": 99, "grid": 1}, "connected by the minimum overlap of 99 % sees enough; lower"),
    ],
)
def test_what_cannot_be_planned(rooms, settings, message):
    with pytest.raises(vtkhelios.PipelineError) as raised:
        vtkhelios.plan(rooms, **settings)
    assert message in str(raised.value) and len(raised.value.messages) == 1


def test_scenes_that_are_not_valid(tmp_path):
    with pytest.raises(vtkhelios.PipelineError, match="none.obj: no such file"):
        vtkhelios.plan("none.obj")
    with pytest.raises(TypeError, match="a Scene is made of points and triangles"):
        vtkhelios.plan(7)
    with pytest.raises(vtkhelios.PipelineError, match="The scene on port 0 is empty"):
        vtkhelios.plan(vtkhelios.Scene(np.zeros((3, 3)), np.zeros((0, 3), dtype=int)))


def test_warnings_of_a_document(write_document):
    with pytest.warns(RuntimeWarning, match="did you mean gridSizePSP_m?"):
        vtkhelios.plan(write_document('gridSizePSP="3"'))


def test_names_as_the_caller_spells_them():
    error = SettingError("{0} is {value!r}, above {1}; give {{}}", "a_b", "c", value="{0}")
    assert str(error) == "a_b is '{0}', above c; give {}"
    assert error.format(lambda name: f"--{name}") == "--a_b is '{0}', above --c; give {}"


# Progress and Ctrl-C.


def test_progress(rooms, capsys):
    shares = []
    vtkhelios.plan(rooms, grid=0.25, progress=shares.append)
    assert shares == sorted(shares) and shares[0] >= 0 and 0.8 <= shares[-1] <= 1
    vtkhelios.plan(rooms, grid=0.25, progress=True)
    assert "%" in capsys.readouterr().err


def test_an_exception_in_progress_ends_planning(rooms):
    def stop(share):
        if share > 0.2:
            raise LookupError("enough")

    task = planning.PlanTask(rooms, grid=1)
    with pytest.raises(LookupError, match="enough"):
        task.run(stop)
    assert len(task.run()) == 3


def test_interrupted(rooms):
    before = signal.signal(signal.SIGINT, signal.default_int_handler)
    timer = threading.Timer(0.15, os.kill, (os.getpid(), signal.SIGINT))
    timer.start()
    try:
        with pytest.raises(KeyboardInterrupt):
            vtkhelios.plan(rooms, grid=0.05, test_grid=0.05)  # takes much longer
    finally:
        timer.cancel()
        signal.signal(signal.SIGINT, before)


# Roofs, and the catalogue.


def make_hall(tmp_path, ground=False):
    """A floor of 20 m x 20 m with a hall of 8 m x 8 m, 4 m high, as OBJ."""
    lines = [
        "mtllib hall.mtl",
        "usemtl floor",
        "v -10 -10 0",
        "v 10 -10 0",
        "v 10 10 0",
        "v -10 10 0",
    ]
    lines += [
        "f 1 2 3 4",
        "usemtl roof",
        "v -4 -4 4",
        "v 4 -4 4",
        "v 4 4 4",
        "v -4 4 4",
        "f 5 6 7 8",
    ]
    lines += ["v -4 -4 0", "v 4 -4 0", "v 4 4 0", "v -4 4 0", "f 5 6 10 9", "f 6 7 11 10"]
    lines += ["f 7 8 12 11", "f 8 5 9 12"]
    (tmp_path / "hall.obj").write_text("\n".join(lines) + "\n")
    is_ground = f"helios_isGround {str(ground).lower()}\n"
    (tmp_path / "hall.mtl").write_text(
        f"newmtl floor\nKd 1 1 1\n{is_ground}newmtl roof\nKd 1 1 1\n"
    )
    return tmp_path / "hall.obj"


def test_no_position_is_on_a_roof_unless_asked(tmp_path):
    plan = vtkhelios.plan(make_hall(tmp_path), grid=2)
    assert plan.positions[:, 2].max() < 4 and plan.report["onRoofs"] == 16
    anywhere = vtkhelios.plan(make_hall(tmp_path), grid=2, on="any")
    assert anywhere.positions[:, 2].max() > 4 and anywhere.report["onRoofs"] == 0
    with pytest.warns(RuntimeWarning, match="All of 16 places are 1.8 m or more above another"):
        only_roof = vtkhelios.plan(make_hall(tmp_path), grid=2, region=(-4, 4, -4, 4))
    assert only_roof.positions[:, 2].min() > 4


def test_no_position_is_on_a_roof_with_ground_materials(tmp_path, recwarn):
    plan = vtkhelios.plan(make_hall(tmp_path, ground=True), grid=2)
    assert (plan.positions[:, 2] < 4).all()
    assert not [each for each in recwarn if "roof" in str(each.message)]


def test_a_catalogue_in_the_working_directory_is_not_the_default(rooms, tmp_path, monkeypatch):
    own = '<document><scanner id="vz400_class_tls" optics="rotating" pulseFreqs_Hz="7000" '
    own += 'scanAngleMax_deg="100" headRotatePerSecMax_deg="60" scanFreqMax_Hz="100"/></document>'
    (tmp_path / "scanners.xml").write_text(own)
    (tmp_path / "platforms.xml").write_text(
        '<document><platform id="tripod" type="static"/></document>'
    )
    expected = vtkhelios.plan(rooms, grid=2)
    monkeypatch.chdir(tmp_path)
    plan = vtkhelios.plan(rooms, grid=2)
    assert plan.task.document.GetLegPulseFrequency() > 7000
    assert (plan.positions == expected.positions).all()
    rooms.write(tmp_path / "rooms.obj")
    assert vtkhelios.plan("rooms.obj", grid=2).task.document.GetLegPulseFrequency() > 7000
    own_one = vtkhelios.plan("rooms.obj", grid=2, scanner="scanners.xml#vz400_class_tls")
    assert own_one.task.document.GetLegPulseFrequency() == 7000
