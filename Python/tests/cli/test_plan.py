# SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
# SPDX-License-Identifier: BSD-3-Clause
"""vtkhelios plan: its plans, files and messages, and whether predictions hold."""

import json
import pathlib
import re
import signal
import subprocess
import sys
import time

import numpy as np
import pytest
from vtkmodules.vtkCommonCore import vtkPoints
from vtkmodules.vtkCommonDataModel import vtkCellArray, vtkPolyData
from vtkmodules.vtkIOXML import vtkXMLPolyDataReader, vtkXMLPolyDataWriter

import vtkhelios

from vtkhelios.cli import main
from vtkhelios.plans.settings import SETTINGS
from vtkhelios.cli import _plan_check, _plan_options
from vtkhelios.reports import plan as _plan_report
from vtkhelios.cli._parser import Parser
from vtkhelios.cli._task import PlanWatch
from vtkhelios.plans.plan import Step

PLANNER = """\
<document>
  <surveyPlanner id="yard" scene="scene.xml#room" platform="platforms.xml#tripod"
    scanner="scanners.xml#vz400_class_tls" gridSizePSP_m="2.5" gridSizeVTP_m="1" {more}/>
  <scene id="room"><part><filter type="objloader">
    <param type="string" key="filepath" value="room.obj"/></filter></part></scene>
</document>
"""


def box(low, high, first):
    """The vertices and faces of a box in OBJ, outward."""
    (x0, y0, z0), (x1, y1, z1) = low, high
    corners = [(x, y, z) for z in (z0, z1) for y in (y0, y1) for x in (x0, x1)]
    faces = [(0, 2, 3, 1), (4, 5, 7, 6), (0, 1, 5, 4), (1, 3, 7, 5), (3, 2, 6, 7), (2, 0, 4, 6)]
    lines = ["v {} {} {}".format(*corner) for corner in corners]
    return lines + ["f " + " ".join(str(first + i) for i in face) for face in faces]


def write_room(path, columns=((3.1, 3.3), (7.2, 4.9))):
    """A walled yard of 10 m by 8 m with columns, its floor and walls of boxes."""
    boxes = [
        ((-0.2, -0.2, -0.2), (10.2, 8.2, 0)),
        ((-0.2, -0.2, 0), (10.2, 0, 3)),
        ((-0.2, 8, 0), (10.2, 8.2, 3)),
        ((-0.2, 0, 0), (0, 8, 3)),
        ((10, 0, 0), (10.2, 8, 3)),
    ]
    boxes += [((x, y, 0), (x + 0.8, y + 0.8, 3)) for x, y in columns]
    lines = []
    for number, (low, high) in enumerate(boxes):
        lines += box(low, high, 1 + 8 * number)
    path.write_text("\n".join(lines) + "\n")


def write_synthetic(path, kind, size, height, resolution=0):
    """A synthetic scene."""
    scene = vtkhelios.vtkHeliosSyntheticScene()
    getattr(scene, f"SetKindTo{kind}")()
    scene.SetSize(size)
    scene.SetHeight(height)
    scene.SetResolution(resolution)
    writer = vtkhelios.vtkHeliosObjSceneWriter()
    writer.SetInputConnection(scene.GetOutputPort())
    writer.SetFileName(str(path))
    assert writer.Write()


@pytest.fixture
def plan(tmp_path, capsys, monkeypatch):
    """Plans in a folder with room.obj and returns (exit code, summary or None, standard error)."""
    monkeypatch.chdir(tmp_path)
    write_room(tmp_path / "room.obj")

    def call(*arguments):
        code = main(["plan", *map(str, arguments), "--no-picture", "--json"])
        said = capsys.readouterr()
        return code, json.loads(said.out) if said.out else None, said.err

    return call


def read_vtp(path):
    reader = vtkXMLPolyDataReader()
    reader.SetFileName(str(path))
    return vtkhelios.arrays(vtkhelios.update(reader))


# Results.


def test_a_mesh(plan, tmp_path):
    code, summary, said = plan("room.obj", "--grid", 1, "--ground", "false")
    assert code == 0, said
    folder = tmp_path / "output/room"
    assert sorted(path.name for path in folder.iterdir()) == sorted(
        [
            "survey.xml",
            "positions.vtp",
            "candidates.vtp",
            "test_points.vtp",
            "plan_summary.json",
            "positions.csv",
            "positions.dxf",
        ]
    )
    assert json.loads((folder / "plan_summary.json").read_text()) == summary
    candidates = read_vtp(folder / "candidates.vtp")
    points = read_vtp(folder / "test_points.vtp")
    positions = read_vtp(folder / "positions.vtp")
    assert len(candidates["points"]) == summary["candidates"]
    assert len(points["points"]) == summary["testPoints"]
    assert len(positions["points"]) == summary["result"]["scans"] == candidates["Selected"].sum()
    assert "Visibility" not in candidates
    assert (points["Coverable"] > 0).sum() == summary["coverable"]
    assert (points["NumberOfScans"] > 0).sum() == summary["result"]["covered"]
    assert summary["result"]["coverableCoverage_percent"] == 100
    assert summary["result"]["lowerBound"] <= summary["result"]["scans"]
    adds = [row["adds"] for row in summary["positions"]]
    assert adds == sorted(adds, reverse=True) and sum(adds) == summary["result"]["covered"]
    assert summary["settings"]["method"] == "best"
    assert summary["settings"]["height_m"] == pytest.approx(1.7)


def test_no_candidate_inside_a_block(plan, tmp_path, capsys):
    (tmp_path / "yard.mtl").write_text("newmtl lawn\nhelios_isGround true\nnewmtl stone\n")
    lawn = ["mtllib yard.mtl", "usemtl lawn", "v -5 -5 0", "v 5 -5 0", "v 5 5 0", "v -5 5 0"]
    block = ["f 1 2 3 4", "usemtl stone", *box((-1.4, -1.4, 0), (1.4, 1.4, 3), 5)]
    (tmp_path / "yard.obj").write_text("\n".join(lawn + block) + "\n")
    code, outside, said = plan("yard.obj", "--grid", 1)
    assert code == 0, said
    assert outside["enclosed"] == 4 and outside["candidates"] == 96
    assert all(abs(row["x"]) > 1.4 or abs(row["y"]) > 1.4 for row in outside["positions"])
    code, anywhere, _ = plan("yard.obj", "--grid", 1, "--enclosed", "--overwrite")
    assert code == 0 and anywhere["enclosed"] == 0 and anywhere["candidates"] == 100
    assert anywhere["coverable"] > outside["coverable"]
    assert any(abs(row["x"]) < 1.4 and abs(row["y"]) < 1.4 for row in anywhere["positions"])
    assert main(["plan", "yard.obj", "--grid", "1", "--overwrite", "--no-picture"]) == 0
    assert "without 4 enclosed places (--enclosed includes them)" in (capsys.readouterr().out)


def test_the_survey_runs_from_the_positions(plan, tmp_path, command_line):
    code, summary, _ = plan("room.obj", "--grid", 2.5, "--resolution", 0.8)
    assert code == 0
    survey = tmp_path / "output/room/survey.xml"
    done = command_line("run", survey, "--pulses", "--no-noise", "--output", tmp_path / "scans")
    assert done.returncode == 0, done.stderr
    assert "warning" not in done.stderr
    for row in summary["positions"]:
        pulses = np.loadtxt(tmp_path / f"scans/room/leg{row['scan']:03}_pulse.txt", max_rows=9)
        wanted = np.tile([row["x"], row["y"], row["z"]], (9, 1))
        assert np.allclose(pulses[:, :3], wanted, atol=1e-3)  # rounded in the text
    legs = vtkhelios.vtkHeliosSurveyReader()
    legs.SetFileName(str(survey))
    legs.AddAssetDirectory(str(vtkhelios.data_directory() / "Assets"))
    assert legs.Read()
    assert legs.GetSurvey().GetNumberOfLegs() == len(summary["positions"])
    first = [0.0, 0.0, 0.0]
    legs.GetSurvey().GetLegPosition(0, first)
    row = summary["positions"][0]
    assert first == pytest.approx([row["x"], row["y"], row["z"] - 1.7], abs=1e-12)


def test_options_override_a_planner_document(plan, tmp_path):
    (tmp_path / "scene.xml").write_text(PLANNER.format(more=""))
    (tmp_path / "plan.xml").write_text(
        PLANNER.format(
            more='method="reduce" pspRemoveOrder="meanIncidenceAngle" minCoverage_percent="95" '
            'maxSlope_deg="20" hitTolerance_m="0.02" rangeMax_m="30"'
        )
    )
    code, summary, said = plan("plan.xml")
    assert code == 0, said
    settings = summary["settings"]
    assert summary["name"] == "yard"
    assert summary["source"] == {"file": "plan.xml", "kind": "planner"}
    assert (settings["method"], settings["removeOrder"]) == ("reduce", "meanIncidenceAngle")
    assert (settings["grid_m"], settings["gridY_m"], settings["testGrid_m"]) == (2.5, 2.5, 1)
    assert (settings["coverage_percent"], settings["maxSlope_deg"]) == (95, 20)
    assert (settings["hitTolerance_m"], settings["rangeMax_m"]) == (0.02, 30)
    assert summary["result"]["coverableCoverage_percent"] >= 95
    options = "--method optimal --coverage 100 --grid 2 --tolerance 0.04 --overwrite".split()
    code, summary, said = plan("plan.xml", *options)
    assert code == 0, said
    settings = summary["settings"]
    assert (settings["method"], settings["coverage_percent"]) == ("optimal", 100)
    assert (settings["grid_m"], settings["testGrid_m"], settings["hitTolerance_m"]) == (2, 2, 0.04)
    assert settings["maxSlope_deg"] == 20
    assert summary["result"]["isProvedOptimal"]
    assert summary["result"]["bestBound"] == summary["result"]["scans"]


def test_a_survey(plan, tmp_path, make_survey):
    make_survey(speed=30)
    write_room(tmp_path / "plane.obj")
    code, summary, said = plan("survey.xml", "--grid", 2)
    assert code == 0, said
    assert summary["source"]["kind"] == "survey" and summary["name"] == "plane"
    text = (tmp_path / "output/plane/survey.xml").read_text()
    for wanted in (
        'scene="../../scene.xml#plane"',
        'platform="platforms.xml#tripod"',
        'verticalAngleMin_deg="-40" verticalAngleMax_deg="60"',
        'scanFreq_hz="100"',
        'headRotateStop_deg="360"',
        'headRotatePerSec_deg="30"',
    ):
        assert wanted in text


def test_methods_agree_on_coverable_points(plan):
    results = {}
    for method in ("reduce", "greedy", "best", "optimal"):
        code, summary, said = plan("room.obj", "--grid", 1, "--method", method, "--overwrite")
        assert code == 0, said
        results[method] = summary
    assert len({summary["coverable"] for summary in results.values()}) == 1
    scans = {method: summary["result"]["scans"] for method, summary in results.items()}
    assert scans["optimal"] <= scans["best"] <= min(scans["greedy"], scans["reduce"])
    assert results["optimal"]["result"]["gap_percent"] == 0


def test_excluded_areas(plan, tmp_path):
    points = vtkPoints()
    for x, y in ((-1, -1), (6, -1), (6, 9), (-1, 9)):
        points.InsertNextPoint(x, y, 0)
    polygon = vtkCellArray()
    polygon.InsertNextCell(4, [0, 1, 2, 3])
    area = vtkPolyData()
    area.SetPoints(points)
    area.SetPolys(polygon)
    writer = vtkXMLPolyDataWriter()
    writer.SetFileName(str(tmp_path / "west.vtp"))
    writer.SetInputData(area)
    writer.Write()
    code, summary, said = plan("room.obj", "--grid", 1, "--exclude", "west.vtp", "--coverage", 80)
    assert code == 0, said
    assert read_vtp(tmp_path / "output/room/candidates.vtp")["points"][:, 0].min() > 6
    code, _, said = plan("room.obj", "--region", 0, 5, 0, 8, "--exclude", "west.vtp", "--overwrite")
    assert code == 1 and "lie in excluded areas" in said


# Predicted against simulated coverage: within 1 % on three scenes, from scans finer than the test
# points.


@pytest.mark.parametrize(
    "scene, options",
    [
        ("room", ["--grid", 1.5, "--test-grid", 0.5, "--ground", "false", "--coverage", 90]),
        ("blocks", ["--grid", 2, "--test-grid", 0.5, "--ground", "open", "--coverage", 90]),
        ("pyramid", ["--grid", 2, "--test-grid", 0.6, "--max-slope", 30, "--coverage", 80]),
    ],
)
def test_predicted_coverage_is_simulated(plan, tmp_path, scene, options):
    if scene == "blocks":
        write_synthetic(tmp_path / "blocks.obj", "Blocks", 14, 3, 3)
    if scene == "pyramid":
        write_synthetic(tmp_path / "pyramid.obj", "Pyramid", 8, 2)
    limits = ["--scanner-limits", "--max-incidence", 75]
    code, summary, said = plan(f"{scene}.obj", *options, *limits, "--resolution", 0.25, "--check")
    assert code == 0, said
    check = summary["check"]
    assert check["predicted_percent"] == pytest.approx(
        summary["result"]["coverableCoverage_percent"]
    )
    assert abs(check["predicted_percent"] - check["simulated_percent"]) < 1, check
    assert abs(check["predicted_percent"] - check["withinTolerance_percent"]) < 1, check
    assert check["coarse_percent"] < 5
    assert check["echoes"] > 100 * summary["coverable"]


def test_a_failed_check_states_the_reason(plan):
    options = ["--grid", 1, "--resolution", 0.5, "--check", "--tolerance", 0.1]
    code, summary, said = plan("room.obj", *options, "--ground", "false", "--quiet")
    assert code == 0
    assert summary["check"]["predictedNotMet"] > 0  # right below the tripod
    limited, _, _ = plan("room.obj", *options, "--scanner-limits", "--overwrite")
    assert limited == 0


def test_differences_are_explained():
    check = {"predicted_percent": 100.0, "simulated_percent": 97.0}
    asked = _plan_check.explain_difference(check, {"scannerLimits": False})
    assert asked.startswith("simulated coverage is 3.0 % below predicted")
    assert "--scanner-limits" in asked
    assert "--resolution" in _plan_check.explain_difference(check, {"scannerLimits": True})
    assert _plan_check.explain_difference({**check, "simulated_percent": 99.5}, {}) is None


def test_half_spacing_of_echoes():
    places = np.array([[10.0, 0.0, 0.0], [0.0, 10.0, 0.0]])
    normals = np.array([[1.0, 0.0, 0.0], [0.0, 0.5, np.sqrt(0.75)]])
    step = np.radians(0.1) * 10
    sights = _plan_check.Sights(places, normals, np.zeros(3), 0.1)
    assert sights.half_spacing() == pytest.approx(
        [step / np.sqrt(2), 0.5 * np.hypot(step, 2 * step)]
    )


@pytest.mark.parametrize(
    "limit, wanted",
    [
        ({}, [True, True]),
        ({"rangeMin_m": 6}, [False, True]),
        ({"rangeMax_m": 6}, [True, False]),
        ({"elevationMin_deg": 1}, [False, True]),
        ({"elevationMax_deg": 1}, [True, False]),
        ({"maxIncidence_deg": 40}, [True, False]),
        ({"minDensity_1_m2": 0.9 / (np.radians(1) * 5) ** 2}, [True, False]),
    ],
)
def test_limits_of_lines_of_sight(limit, wanted):
    places = np.array([[5.0, 0.0, 0.0], [0.0, 5.0, 5.0]])
    normals = np.array([[1.0, 0.0, 0.0], [0.0, 0.0, 1.0]])
    settings = {"rangeMin_m": 0, "rangeMax_m": 1e9, "elevationMin_deg": -90, "elevationMax_deg": 90}
    settings |= {"maxIncidence_deg": 90, "minDensity_1_m2": 0} | limit
    sights = _plan_check.Sights(places, normals, np.zeros(3), 1.0)
    assert sights.find_wanted(settings).tolist() == wanted


# Messages.


def test_printed_plan(plan, tmp_path, command_line):
    done = command_line("plan", tmp_path / "room.obj", "--grid", "1", "--no-picture", cwd=tmp_path)
    assert done.returncode == 0, done.stderr
    assert re.search(
        r"scan +x \[m\] +y \[m\] +z \[m\] +sees +adds +only it +incidence", done.stdout
    )
    assert re.search(r"\n +0 +[\d.]+ +[\d.]+ +1\.700 +\d+ +\d+ +\d+ +[\d.]+", done.stdout)
    assert ": 100.00 % of the " in done.stdout and "linear bound " in done.stdout
    assert (
        "run it   vtkhelios run output/room/survey.xml\n"
        "         with --dry-run: an estimate of its time and points\n"
    ) in done.stdout
    assert (tmp_path / "output/room/positions.vtp").is_file()
    assert not list(tmp_path.rglob("*.part"))


def test_table_without_rich(monkeypatch, capsys):
    monkeypatch.setattr(_plan_report, "Table", None)
    row = dict(scan=0, x=1.0, y=2.0, z=3.0, sees=1000, adds=900, onlyIt=8, meanIncidence_deg=None)
    _plan_report.print_table([row] * 60)
    lines = capsys.readouterr().out.splitlines()
    assert lines[0].split()[:3] == ["scan", "x", "[m]"]
    assert lines[1].split() == ["0", "1.000", "2.000", "3.000", "1,000", "900", "8", "-"]
    assert lines[-1] == "and 10 more; all are in positions.vtp"


def test_proofs_are_described():
    result = dict(scans=4, lowerBound=2.13, bestBound=3, gap_percent=25.0, isProvedOptimal=False)
    assert _plan_report.describe_proof(result) == (
        "4 scans; lower bound: 3 scans (linear bound 2.13, gap 25 %); --method optimal searches "
        "further"
    )
    proved = {**result, "scans": 1, "isProvedOptimal": True}
    assert _plan_report.describe_proof(result, 300.0).endswith(
        "gap 25 %); the proof was not finished in 300 s; give a longer --time-limit"
    )
    assert _plan_report.describe_proof(proved).startswith("1 scan, proved to be the minimum")


def test_help(command_line):
    done = command_line("plan", "--help")
    assert done.returncode == 0
    for word in ("--scanner-limits", "Bechtold", "survey.xml", "exit codes", "--time-limit"):
        assert word in done.stdout


def test_a_picture(tmp_path, read_pixels):
    write_room(tmp_path / "room.obj")
    command = [
        sys.executable,
        "-P",
        "-m",
        "vtkhelios",
        "plan",
        "room.obj",
        "--grid",
        "1",
        "--coverage",
        "90",
        "--quiet",
    ]
    environment = {"PYTHONPATH": ":".join(sys.path), "PATH": "/usr/bin:/bin", "HOME": str(tmp_path)}
    done = subprocess.run(
        command, cwd=tmp_path, env=environment, capture_output=True, text=True, timeout=120
    )
    assert done.returncode == 0, done.stderr
    pixels = read_pixels(tmp_path / "output/room/plan.png")
    assert pixels.shape == (820, 1800, 3)
    gold = (abs(pixels - [255, 204, 51]).max(axis=2) < 30).nonzero()[1]
    assert (gold < 900).any() and (gold >= 900).any()  # positions are marked on both sides
    for half in (pixels[100:750, :900], pixels[100:750, 900:]):
        assert len(np.unique(half.reshape(-1, 3) // 32, axis=0)) > 20


def test_no_picture_without_a_display_and_xvfb(tmp_path, command_line, monkeypatch):
    monkeypatch.delenv("DISPLAY", raising=False)
    monkeypatch.setenv("PATH", str(tmp_path))
    write_room(tmp_path / "room.obj")
    done = command_line("plan", "room.obj", "--grid", "3", cwd=tmp_path)
    assert done.returncode == 0
    assert (
        "no plan.png: no X display, and no Xvfb for a virtual one: apt-get install xvfb, or give "
        "--no-picture" in done.stderr
    )
    assert not (tmp_path / "output/room/plan.png").exists()


# Errors.


@pytest.mark.parametrize(
    "options, message",
    [
        (["--method", "optimum"], "unknown 'optimum': did you mean optimal?"),
        (["--coverage", "0"], "'0' is not a number from 1e-06 to 100"),
        (["--max-slope", "91"], "'91' is not a number from 0 to 90"),
        (["--grid", "fine"], "'fine' is not a number from 1e-06 to 1e+06"),
        (["--ground", "yes"], "unknown 'yes': known: auto, true, false, open"),
        (["--toleranc", "1"], "unknown option --toleranc: did you mean --tolerance?"),
        (["--region", "1", "2"], "argument --region: expected 4 arguments"),
    ],
)
def test_wrong_usage(options, message, capsys):
    with pytest.raises(SystemExit) as stopped:
        main(["plan", "room.obj", *options])
    assert stopped.value.code == 2
    assert message in capsys.readouterr().err


@pytest.mark.parametrize(
    "options, message",
    [
        (["--region", 100, 120, 0, 9], "have no surface below"),
        (["--region", 9, 1, 0, 9], "--region is x 9 to 1"),
        (["--grid", 0.001], "the memory limit (2048 MiB); make the grid of candidates coarser"),
        (
            ["--test-grid", 0.0005],
            "the memory limit (2048 MiB); make the grid of test points coarser",
        ),
        (["--grid", 0.1, "--test-grid", 0.1, "--memory", 1], "more than the memory limit (1 MiB)"),
        (
            ["--range-min", 5, "--range-max", 5],
            "--range-min is 5 and --range-max is 5, so nothing is visible; give a smaller "
            "--range-min or a larger --range-max",
        ),
        (
            ["--elevation-min", 50, "--elevation-max", 40],
            "--elevation-min is 50 and --elevation-max is 40, so nothing is visible",
        ),
        (["--range-max", 0.01], "no candidate sees any test point"),
        (
            ["--coverage-of", "all"],
            "the minimum coverage of 100 % of all test points cannot be reached",
        ),
        (
            ["--overlap", 99.9, "--grid", 1],
            "connected by the minimum overlap of 99.9 % sees enough",
        ),
        (["--ground", "true"], "to be on the ground, but no material of the scene is ground"),
        (
            ["--exclude", "none.vtp"],
            "--exclude none.vtp: is not a VTK XML file of polygons; give a .vtp",
        ),
        (["--exclude", "room.obj"], "--exclude room.obj: is not a VTK XML file"),
        (["--assets", "nowhere"], "--assets nowhere: no such folder"),
        (
            ["--output", "room.obj"],
            "room.obj/room: cannot be written: Not a directory; give another",
        ),
        (
            ["--scanner", "scanners.xml#conic_als"],
            "scanner conic_als has a head that does not rotate",
        ),
        (["--platform", "platforms.xml#tripot"], "did you mean tripod?"),
        (["--platform", "platforms.xml#copter"], "platform Multicopter moves"),
    ],
)
def test_errors(plan, options, message):
    code, summary, said = plan("room.obj", *options)
    assert (code, summary) == (1, None)
    assert message in said and "Traceback" not in said
    assert said.count("error:") == 1, said


def test_no_horizontal_surface(plan, tmp_path):
    (tmp_path / "wall.obj").write_text("v 0 0 0\nv 9 4 0\nv 9 5 9\nv 0 1 9\nf 1 2 3 4\n")
    code, _, said = plan("wall.obj", "--grid", 0.3)
    assert code == 1
    assert "No candidate is left" in said and "are steeper than the maximum slope (15 deg)" in said


def test_no_test_point(plan, tmp_path):
    (tmp_path / "floor.obj").write_text("v 0 0 0\nv 9 0 0\nv 9 9 0\nv 0 9 0\nf 1 2 3 4\n")
    code, _, said = plan("floor.obj", "--test-lines", "horizontal")
    assert code == 1 and "No test point: none of " in said
    assert plan("floor.obj", "--test-lines", "vertical")[0] == 0


def test_bad_files(plan, tmp_path):
    assert "none.obj: no such file" in plan("none.obj")[2]
    assert "none.xml: no such file" in plan("none.xml")[2]
    (tmp_path / "a.xml").write_text("<document/>")
    assert "the file has nothing to plan" in plan("a.xml")[2]
    (tmp_path / "scene.xml").write_text(PLANNER.format(more=""))
    (tmp_path / "a.xml").write_text(PLANNER.format(more='method="beast" maxSlope_deg="-2"'))
    code, _, said = plan("a.xml")
    assert code == 1
    assert 'a.xml:2: method="beast" is not valid; did you mean best?' in said
    assert 'a.xml:2: maxSlope_deg="-2"' in said


def test_an_earlier_plan_is_kept(plan, tmp_path):
    assert plan("room.obj", "--grid", 3)[0] == 0
    before = (tmp_path / "output/room/survey.xml").read_bytes()
    code, _, said = plan("room.obj", "--grid", 2)
    assert code == 1
    assert (
        "output/room: holds the files of an earlier plan, which are kept; give --overwrite" in said
    )
    assert (tmp_path / "output/room/survey.xml").read_bytes() == before
    (tmp_path / "output/room/check").mkdir()
    assert plan("room.obj", "--grid", 2, "--overwrite")[0] == 0
    assert (tmp_path / "output/room/survey.xml").read_bytes() != before
    assert not (tmp_path / "output/room/check").exists()


def test_interrupted(tmp_path):
    write_room(tmp_path / "room.obj")
    package = pathlib.Path(vtkhelios.__file__).absolute().parents[1]
    process = subprocess.Popen(
        [sys.executable, "-P", "-m", "vtkhelios", "plan", "room.obj", "--no-picture"]
        + ["--grid", "0.05", "--test-grid", "0.1", "--threads", "1"],
        cwd=tmp_path,
        env={"PYTHONPATH": str(package), "PATH": "/usr/bin:/bin"},
        stdout=subprocess.PIPE,
        stderr=subprocess.PIPE,
        text=True,
    )
    assert process.stdout.readline().startswith("plan     room")
    time.sleep(1.0)
    process.send_signal(signal.SIGINT)
    _, said = process.communicate(timeout=60)
    assert process.returncode == 130, said
    assert "error: interrupted before the plan was made; nothing was written" in said
    assert said.count("error:") == 1 and "Traceback" not in said
    assert not list((tmp_path / "output/room").iterdir())


def test_steps_are_watched():
    watch, said = PlanWatch(), []
    watch.AddObserver("ProgressEvent", lambda *_: said.append(watch.GetMessage()))
    watch.begin(Step("sleeping", None, 0, 0.5))
    watch.on_progress(None, 0.25)
    assert watch.GetProgress() == 0.25
    watch.begin(Step("dozing", None, 0.5, 1, is_even=False))
    watch.on_progress(None, 0.5)
    assert said == ["sleeping", "sleeping", "dozing", "dozing"]
    watch.begin(Step("sleeping", None, 0, 0.5))
    watch.on_progress(None, 0.25)
    time.sleep(0.1)
    watch.on_progress(None, 0.75)
    assert said[-1] == "sleeping, 0:00 left"


def test_every_setting_is_an_option():
    parser = Parser()
    _plan_options.add_plan_arguments(parser)
    known = {option for action in parser._actions for option in action.option_strings}
    assert {_plan_options.option_of(name) for name in SETTINGS} <= known
    given = _plan_options.given_settings(parser.parse_args(["scene.obj"]))
    assert list(given) == list(SETTINGS) and set(given.values()) == {None}


def test_interrupted_check(tmp_path):
    write_room(tmp_path / "room.obj")
    package = pathlib.Path(vtkhelios.__file__).absolute().parents[1]
    process = subprocess.Popen(
        [sys.executable, "-P", "-m", "vtkhelios", "plan", "room.obj", "--no-picture", "--grid", "2"]
        + ["--resolution", "0.01", "--check"],
        cwd=tmp_path,
        env={"PYTHONPATH": str(package), "PATH": "/usr/bin:/bin"},
        stdout=subprocess.PIPE,
        stderr=subprocess.PIPE,
        text=True,
    )
    assert any(line.startswith("scans ") for line in process.stdout)
    points = tmp_path / "output/room/check/room"
    deadline = time.monotonic() + 60
    while not list(points.glob("*.part")) and time.monotonic() < deadline:
        time.sleep(0.1)
    process.send_signal(signal.SIGINT)
    _, said = process.communicate(timeout=120)
    assert process.returncode == 130, said
    assert "interrupted during the simulation of the survey; the plan itself is written" in said
    summary = json.loads((tmp_path / "output/room/plan_summary.json").read_text())
    assert "check" not in summary and summary["result"]["scans"] > 0


# The pyramid of Bechtold and Hoefle 2016 (figure 5), a steep frustum with a flat top pyramid.


def write_paper_pyramid(path):
    """The ground ring to 10.5 m, the frustum from 2.5 m to 1.75 m at 2 m, the top to 2.4375 m."""
    rings = [(10.5, 0.0), (2.5, 0.0), (1.75, 2.0)]
    corners = [(-1, -1), (1, -1), (1, 1), (-1, 1)]
    lines = [f"v {r * x} {r * y} {z}" for r, z in rings for x, y in corners] + ["v 0 0 2.4375"]
    for ring in range(2):
        for i in range(4):
            a, b = 4 * ring + i + 1, 4 * ring + (i + 1) % 4 + 1
            lines += [f"f {a} {b} {b + 4}", f"f {a} {b + 4} {a + 4}"]
    lines += [f"f {9 + i} {9 + (i + 1) % 4} 13" for i in range(4)]
    path.write_text("\n".join(lines) + "\n")


@pytest.mark.parametrize(
    "order, wanted",
    [
        ("viewshedSize", {(-2, 10, 1.5): 347, (0, 0, 3.9375): 401, (10, -2, 1.5): 347}),
        ("meanIncidenceAngle", {(-10, -10, 1.5): 329, (10, 10, 1.5): 329}),
    ],
)
def test_the_pyramid_of_the_paper(plan, tmp_path, order, wanted):
    write_paper_pyramid(tmp_path / "pyramid.obj")
    options = (
        "--grid 1 --test-lines vertical --max-slope 30 --height 1.5 --two-sided --method reduce"
    )
    code, summary, said = plan("pyramid.obj", *options.split(), "--remove-order", order)
    assert code == 0, said
    assert (summary["candidates"], summary["testPoints"], summary["coverable"]) == (425, 441, 441)
    found = {(row["x"], row["y"], round(row["z"], 9)): row["sees"] for row in summary["positions"]}
    assert found == wanted
    assert summary["result"]["covered"] == 441
