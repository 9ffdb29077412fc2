# SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
# SPDX-License-Identifier: BSD-3-Clause
"""The accuracy that a run reports of itself."""

import json
import re
import pathlib
import runpy

import pytest
from vtkmodules.vtkCommonCore import vtkSMPTools

import vtkhelios
from vtkhelios.reports.accuracy import accuracy_line, accuracy_lines, accuracy_rows
from vtkhelios.formats._summary import parse_summary
from vtkhelios.reports.run import forecast_line, forecast_table

MEASURES = ("rangeP50_m", "rangeP95_m", "rangeRms_m", "missed", "invented", "missedAndInvented")
MEASURES += ("amplitudeRms", "widthRms_ns")


@pytest.fixture(scope="module")
def fence(tmp_path_factory):
    """Two scan positions before slats of 3 mm, thinner than the beam, and a wall."""
    small_run = runpy.run_path(pathlib.Path(__file__).with_name("_small_run.py"))
    return small_run["write_survey"](tmp_path_factory.mktemp("fence"))


def run(survey, folder, **options):
    return vtkhelios.read_survey(survey).run_to(folder, **options)


def points_of(report):
    return {path.name: path.read_bytes() for path in sorted(report["folder"].glob("*.xyz"))}


def test_a_run_on_a_plane_has_no_error(make_survey, tmp_path):
    report = run(make_survey(), tmp_path)
    accuracy = report["accuracy"]
    assert accuracy["echoes"] == accuracy["matched"] > 150
    assert 200 < accuracy["pulses"] < 1000
    assert accuracy["rangeP95_m"][2] < 1e-4  # with the upper end
    assert accuracy["missed"][0] == accuracy["invented"][0] == 0
    assert accuracy["amplitudeRms"][0] < 2e-3
    assert accuracy["asked"] == {"rangeTolerance_m": 0.001, "energyTolerance": 0.01}
    summary = json.loads((report["folder"] / "run_summary.json").read_text())
    assert summary["accuracy"] == accuracy
    parse_summary(json.dumps(summary), "a")


def test_intervals_contain_their_values(fence, tmp_path):
    accuracy = run(fence, tmp_path)["accuracy"]
    for errors in (accuracy, accuracy["reference"]):
        for name in MEASURES:
            value, lower, upper = errors[name]
            assert 0 <= lower <= value <= upper, name
    reference = accuracy["reference"]
    assert (reference["rangeTolerance_m"], reference["energyTolerance"]) == (1e-4, 1e-3)
    assert reference["rangeP95_m"][0] < 1e-4
    check = reference["check"]
    assert check["subRays"] == 32768 and 16 < check["pulses"] < 200
    assert 0 < check["rangeP95_m"][0] < 1e-3  # error of the sub-rays


def test_slats_are_seen_by_visible_areas_and_missed_by_few_sub_rays(fence, tmp_path):
    adaptive = run(fence, tmp_path / "adaptive")["accuracy"]
    assert adaptive["rangeP95_m"][1] <= 0.001
    assert adaptive["missedAndInvented"][1] <= 0.01
    seven = run(fence, tmp_path / "seven", sub_rays=7)["accuracy"]
    assert "asked" not in seven
    assert seven["amplitudeRms"][1] > 5 * adaptive["amplitudeRms"][2]
    assert seven["rangeP95_m"][1] > adaptive["rangeP95_m"][2]


def test_it_is_the_same_for_threads_blocks_and_seeds_of_the_noise(fence, tmp_path):
    threads = vtkSMPTools.GetEstimatedNumberOfThreads()
    try:
        vtkSMPTools.Initialize(1)
        one = run(fence, tmp_path / "one")["accuracy"]
    finally:
        vtkSMPTools.Initialize(threads)
    assert one["without"] == ["noise"]
    assert run(fence, tmp_path / "blocks", pulses_per_block=999)["accuracy"] == one
    assert run(fence, tmp_path / "seed", seed=5)["accuracy"] == one
    without = run(fence, tmp_path / "noise", noise=False)["accuracy"]
    assert {**without, "without": ["noise"]} == one and without["without"] == []


def test_it_changes_no_point_and_can_be_left_out(fence, tmp_path):
    report = run(fence, tmp_path / "with")
    bare = run(fence, tmp_path / "without", accuracy_report=False)
    assert points_of(bare) == points_of(report)
    assert "accuracy" in report and "accuracy" not in bare
    ignored = ("accuracy", "timings", "checksum", "folder")
    for each in (report, bare):
        for name in ignored:
            each.pop(name, None)
    assert bare == report


def test_a_run_stopped_while_it_is_measured_is_complete_without_it(fence, tmp_path):
    whole = run(fence, tmp_path / "whole")
    player = vtkhelios.vtkHeliosSurveyPlayer(source=vtkhelios.read_survey(fence).source())
    player.SetOutputDirectory(str(tmp_path / "stopped"))
    steps = []

    def stop(*_):
        if player.GetMessage() == "measuring the accuracy":
            steps.append(player.GetProgress())
            player.Abort()

    player.AddObserver("ProgressEvent", stop)
    assert player.Run()
    assert steps == [1.0]
    report = json.loads(player.GetReport())
    assert report["accuracy"] == {"reason": "it was stopped while it was measured"}
    report["folder"] = pathlib.Path(player.GetRunFolder())
    assert points_of(report) == points_of(whole)


def test_a_resumed_run_has_the_same_accuracy(fence, tmp_path):
    whole = run(fence, tmp_path / "whole", pulses_per_block=20000)
    player = vtkhelios.vtkHeliosSurveyPlayer(source=vtkhelios.read_survey(fence).source())
    player.SetOutputDirectory(str(tmp_path / "stopped"))
    player.SetPulsesPerBlock(20000)

    def stop(*_):
        if player.GetCount("pulses") > 60000:
            player.Abort()

    player.AddObserver("ProgressEvent", stop)
    assert not player.Run()
    resumed = run(fence, tmp_path / "stopped", resume=True, pulses_per_block=20000)
    assert resumed["accuracy"] == whole["accuracy"]
    assert points_of(resumed) == points_of(whole)


def test_moving_parts_are_where_they_were(make_survey, tmp_path):
    survey = make_survey(stop=10)
    (tmp_path / "board.obj").write_text("v -1 8 0\nv 1 8 0\nv 1 8 4\nv -1 8 4\nf 1 2 3\nf 1 3 4\n")
    scene = (tmp_path / "scene.xml").read_text()
    moving = """<part><filter type="objloader"><param type="string" key="filepath" value="board.obj"/>
      </filter><dmotion id="a" loop="0"><motion type="translation" vec="0;0.01;0"/></dmotion></part>"""
    (tmp_path / "scene.xml").write_text(scene.replace("</scene>", f"{moving}</scene>"))
    accuracy = run(survey, tmp_path / "out")["accuracy"]
    assert accuracy["missedAndInvented"][0] == 0
    assert accuracy["rangeP95_m"][1] < 1e-3


def test_a_scene_of_voxels_has_no_reference():
    accuracy = {"reason": "the scene has only turbid voxels, which are random"}
    assert accuracy_line(accuracy) == f"accuracy not measured: {accuracy['reason']}"
    assert list(accuracy_lines(accuracy)) == [accuracy_line(accuracy)]
    assert list(accuracy_rows(accuracy)) == [("accuracy", accuracy["reason"])]
    assert list(accuracy_rows(None)) == [("accuracy", "not measured")]


def test_what_the_reference_cannot_tell_is_no_number(fence, tmp_path):
    accuracy = run(fence, tmp_path)["accuracy"]
    accuracy["reference"]["rangeP95_m"] = [0.0084, 0.007, 0.01]
    lines = list(accuracy_lines(accuracy))
    row = next(line for line in lines if "95th percentile" in line)
    assert row.endswith(" cannot be told to better than 8.4 mm, asked 1 mm")
    assert "95 % of the ranges within 8.4 mm or better, " in accuracy_line(accuracy)
    accuracy["missedAndInvented"] = [0.03, 0.02, 0.04]
    assert "3 % of the echoes missed or invented (more than asked), " in accuracy_line(accuracy)
    assert accuracy_line(accuracy | {"echoes": 1}).endswith("; asked 1 mm, 1 %, 1 %; from 1 echo")
    del accuracy["asked"]  # like a fixed number of sub-rays
    assert "asked" not in accuracy_line(accuracy)


def test_the_text_of_a_run_of_version_0_2(fence, tmp_path):
    accuracy = run(fence, tmp_path)["accuracy"]
    accuracy["reference"] = {name: [0, 0, 0] for name in MEASURES} | {"subRays": 4096}
    parse_summary(json.dumps({"legs": [], "accuracy": accuracy}), "a", {})
    assert "again with 4096 sub-rays" in next(accuracy_lines(accuracy))


def test_the_last_lines_of_a_run_say_it(command_line, make_survey, tmp_path):
    arguments = ("run", make_survey(), "--output", tmp_path / "out", "--no-noise", "--overwrite")
    done = command_line(*arguments)
    assert done.returncode == 0, done.stderr
    lines = [line for line in done.stdout.splitlines() if line.startswith("accuracy")]
    assert lines == done.stdout.splitlines()[-1:]
    assert re.fullmatch(
        r"accuracy 95 % of the ranges within [\d.e-]+ mm, [\d.]+ % of the echoes missed or invented, "
        r"amplitudes within [\d.e-]+ % \(RMS\); asked 1 mm, 1 %, 1 %; from [\d,]+ echoes",
        lines[0],
    )
    done = command_line(*arguments, "--verbose")
    assert done.returncode == 0, done.stderr
    title, *rows = done.stdout.splitlines()[-7:]
    assert title.startswith("accuracy of ") and title.endswith("again within 0.1 mm and 0.1 %")
    p95 = next(row for row in rows if "95th percentile" in row)
    assert "asked 1 mm (reference itself" in p95 and "[" in p95
    lost = next(row for row in rows if "missed and invented" in row)
    assert "0 % [0, " in lost and "asked 1 %" in lost


def test_it_is_left_out_on_request(command_line, make_survey, tmp_path):
    arguments = ("run", make_survey(), "--output", tmp_path / "out", "--no-accuracy-report")
    done = command_line(*arguments, "--json")
    assert done.returncode == 0, done.stderr
    assert "accuracy" not in json.loads(done.stdout)


FORECAST = {
    "pulses": 1234,
    "ways": [
        {"rangeTolerance_m": 0.001, "us_per_pulse": 3.0, "run_s": 12.0},
        {"rangeTolerance_m": 0.01, "us_per_pulse": 2.0, "run_s": 80.0},
        {"subRays": 19, "us_per_pulse": 1.0, "run_s": 5.0},
    ],
}


def test_the_price_of_tolerances_is_one_line():
    errors = {"rangeP95_m": [0.02, 0.01, 0.03], "missedAndInvented": [0.21, 0.2, 0.22]}
    ways = [{**way, **errors} for way in FORECAST["ways"]]
    line = forecast_line({**FORECAST, "ways": ways})
    assert line.startswith(
        "price    about 1 mm 12 s, 10 mm 1 min 20 s; 19 fixed sub-rays 5 s, with 21 % of the echoes "
        "missed or invented and 95 % of the ranges within 20 mm; from 1,234 pulses"
    )
    ways[1]["run_s"] = 12.0
    line = forecast_line({**FORECAST, "ways": ways})
    assert line.startswith("price    about 1 mm to 10 mm 12 s; 19 fixed")
    assert forecast_line({"reason": "the run is short"}) is None
    assert list(forecast_table({"reason": "photons"})) == ["price    not known: photons"]


def test_a_dry_run_has_the_price_of_other_settings(fence, tmp_path):
    player = vtkhelios.vtkHeliosSurveyPlayer(source=vtkhelios.read_survey(fence).source())
    player.SetOutputDirectory(str(tmp_path / "none"))
    assert player.Estimate()
    ways = json.loads(player.GetReport())["forecast"]["ways"]
    assert [way["subRays"] for way in ways if "subRays" in way] == [1, 7, 19, 62, 223]
    assert [way["rangeTolerance_m"] for way in ways[:5]] == [0.001, 0.003, 0.01, 0.03, 0.1]
    errors = {way.get("subRays", 0): way["amplitudeRms"][0] for way in ways}
    assert errors[7] > errors[223] > ways[0]["amplitudeRms"][0]
    lines = list(forecast_table(json.loads(player.GetReport())["forecast"]))
    assert len(lines) == 12 and lines[7].split()[:2] == ["1", "sub-ray"]

    def stop(*_):
        if player.GetMessage() == "comparing tolerances":
            player.Abort()

    player.AddObserver("ProgressEvent", stop)
    assert not player.Estimate()
    assert player.GetReport() == "" and player.GetMessage() == "Stopped."


def test_a_forecast_changes_no_file(fence, tmp_path):
    for name in ("with", "without"):
        player = vtkhelios.vtkHeliosSurveyPlayer(source=vtkhelios.read_survey(fence).source())
        player.SetOutputDirectory(str(tmp_path / name))
        player.SetForecast(name == "with")
        assert player.Run()
        assert bool(player.GetForecastReport()) == (name == "with")
    one, two = (sorted((tmp_path / name).rglob("*.xyz")) for name in ("with", "without"))
    assert [path.read_bytes() for path in one] == [path.read_bytes() for path in two]
