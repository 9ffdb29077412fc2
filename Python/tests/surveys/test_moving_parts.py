# SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
# SPDX-License-Identifier: BSD-3-Clause
"""Moving parts in info, plans, reports and tradeoffs: a wall that drives away at 10 m/s, with a wheel."""

import json

import numpy as np
import pytest

import vtkhelios
from vtkhelios import cli, formats
from vtkhelios.reports.moving import MOST, MovingParts, moving_rows
from vtkhelios.surveys.tradeoff import Row, find_verdict
from vtkhelios.surveys.accuracy import Estimate

SPEED = 10.0  # [m/s]
FLOOR = "v -60 -60 0\nv 60 -60 0\nv 60 60 0\nv -60 60 0\nf 1 2 3 4\n"
WALL = "v -5 8 0\nv 5 8 0\nv 5 8 4\nv -5 8 4\nf 1 2 3 4\n"
WHEEL = "v -8 8 0\nv -6 8 0\nv -7 8 2\nf 1 2 3\n"


@pytest.fixture(scope="module")
def survey(tmp_path_factory):
    """The file of a survey of 60 degrees in 1 s."""
    folder = tmp_path_factory.mktemp("moving")
    for name, text in (("floor", FLOOR), ("wall", WALL), ("wheel", WHEEL)):
        (folder / f"{name}.obj").write_text(text)
    drive = {"loop": 0, "motion": {"type": "translation", "vec": (0, 0.01 * SPEED, 0)}}
    parts = [
        {"id": "floor", "file": folder / "floor.obj"},
        {"id": "car", "file": folder / "wall.obj", "dmotion": drive, "dynTimeStep": 0.01, "motion": "continuous"},
        {"id": "wheel", "file": folder / "wheel.obj", "mount": "car"},
        {"id": "rest", "file": folder / "wheel.obj", "mount": "floor", "translate": {"offset": (-5, 0, 0)}},
    ]  # fmt: skip
    made = vtkhelios.make_survey(
        parts, [(0, 0, 0)], head_speed=60, head=(-30, 30), scan_frequency=50,
        name="moving",
    )  # fmt: skip
    made.write(folder / "survey.xml")
    return folder / "survey.xml"


@pytest.fixture(scope="module")
def run(survey, tmp_path_factory):
    report = vtkhelios.read_survey(survey).run_to(
        tmp_path_factory.mktemp("run"), "vtp", velocities=True, noise=False, sub_rays=1
    )
    return report["folder"]


def test_a_survey_knows_its_moving_parts(survey):
    assert vtkhelios.read_survey(survey).moving_parts == {"car": "continuous", "wheel": "on car"}


def test_info_lists_them(survey, capsys):
    assert cli.main(["info", str(survey)]) == 0
    assert "moving     car: continuous\n           wheel: on car\n" in capsys.readouterr().out
    assert cli.main(["info", str(survey), "--json"]) == 0
    facts = json.loads(capsys.readouterr().out)
    assert facts["movingParts"][1] == {"part": "wheel", "motion": "on car"}


def test_a_summary_has_their_speeds(run):
    summary = json.loads((run / "run_summary.json").read_text())
    assert [part["part"] for part in summary["movingParts"]] == ["car", "wheel"]
    for part in summary["movingParts"]:
        assert part["speed_m_s"] == pytest.approx([SPEED, SPEED])


def test_a_report_has_their_echoes_and_velocities(run, tmp_path, capsys):
    pytest.importorskip("matplotlib")
    page = tmp_path / "report.html"
    arguments = ["report", str(run), "--output", str(page), "--cloud-points", "0", "--json"]
    assert cli.main(arguments) == 0
    numbers = json.loads(capsys.readouterr().out)["movingParts"]
    with formats.open_reader(run) as reader:
        chunks = list(reader.chunks())
    ids = np.concatenate([chunk["PartIds"] for chunk in chunks])
    speeds = np.concatenate([chunk["RadialVelocity"] for chunk in chunks])
    for number, part in zip((1, 2), numbers):
        assert part["points"] == np.count_nonzero(ids == number) > 100
        mine = speeds[ids == number]
        assert part["radialVelocity_m_s"] == pytest.approx([mine.min(), mine.max()])
        assert 0.5 * SPEED < mine.min() <= mine.max() <= SPEED
    text = page.read_text()
    assert "<h2>Moving parts</h2>" in text and '<td class="text">on car</td>' in text
    assert f"{numbers[0]['points']:,}" in text and "of the points on parts that moved" in text


def test_a_report_of_parts_at_rest_does_not_name_them(small_runs, tmp_path, capsys):
    pytest.importorskip("matplotlib")
    page = tmp_path / "report.html"
    arguments = ["report", str(small_runs["xyz"]), "--output", str(page), "--cloud-points", "0"]
    assert cli.main([*arguments, "--json"]) == 0
    assert "movingParts" not in json.loads(capsys.readouterr().out)
    assert "Moving parts" not in page.read_text()


def test_rows_of_many_parts():
    part = {"part": "car", "motion": "along car.csv", "speed_m_s": [0.0, 12.3456]}
    assert moving_rows([part]) == [("car", "along car.csv", "0 to 12.3", "not in the files", "")]
    rows = moving_rows([{**part, "points": 1234, "radialVelocity_m_s": [-3.0, -3.0]}] * (MOST + 2))
    assert rows[0][3:] == ("1,234", "-3") and rows[-1][0] == "and 2 more" and len(rows) == MOST + 1
    assert MovingParts().to_list({}) == []


def test_without_their_motion_parts_stand_still(survey):
    read = vtkhelios.read_survey(survey)
    cloud = read.run(noise=False, sub_rays=1, without="partMotion")
    on_car = cloud[cloud["PartIds"] == 1]
    assert len(on_car) > 100 and on_car.points[:, 1] == pytest.approx(8.0, abs=1e-6)
    moved = read.run(noise=False, sub_rays=1)
    assert moved[moved["PartIds"] == 1].points[:, 1].max() > 9.0


def test_a_tradeoff_tells_what_motion_changes(survey):
    result = vtkhelios.read_survey(survey).tradeoff(pulses=200, seconds=20)
    row = next(row for row in result.parts if row.name == "without partMotion")
    assert row.options == {"without": "partMotion"}
    assert row.errors["missedAndInvented"].lower > 0.02
    assert (
        row.verdict.startswith("matters: ") and "% of the echoes missed or invented" in row.verdict
    )
    assert all(each.verdict for each in result.parts[1:] if each.kind == "part")
    assert all(each.seconds > 1e-8 for each in result.ways)  # trees are built before
    assert row.as_dict()["verdict"] == row.verdict


def make_row(seconds, unclear=(), **errors):
    names = ("missedAndInvented", "positionP95_m", "amplitudeRms")
    estimates = {name: Estimate(errors.get(name, 0.0), 0.0, 0.0) for name in names}
    return Row("a", "part", {}, estimates, seconds, 100, unclear=unclear)


@pytest.mark.parametrize(
    "row, text",
    [
        (make_row(1.0), "no difference; no time"),
        (make_row(0.96, amplitudeRms=0.009), "small: below 1 mm and 1 %; no time"),
        (make_row(1.0, ("positionP95_m",), positionP95_m=0.3), "no difference; no time"),
        (make_row(0.25, positionP95_m=0.3), "matters: positions by 300 mm; 75 % of the time"),
        (
            make_row(3.2, missedAndInvented=0.05, amplitudeRms=0.12),
            "matters: 5 % of the echoes missed or invented, amplitudes by 12 %; 3.2 times the time",
        ),
    ],
)
def test_verdicts(row, text):
    assert find_verdict(row, make_row(1.0)) == text


def test_a_plan_leaves_them_out(survey, tmp_path, capsys):
    arguments = [
        "plan",
        str(survey),
        "--output",
        str(tmp_path),
        "--grid",
        "20",
        "--no-picture",
        "--geo",
        "none",
    ]
    assert cli.main([*arguments, "--json"]) == 0
    done = capsys.readouterr()
    assert json.loads(done.out)["settings"]["movingParts"] is False
    assert (
        "the plan leaves out parts car and wheel, which move; set UseMovingParts (--moving-parts)"
        in done.err
    )
    plan = vtkhelios.plan(survey, grid=20)
    assert plan.scene.GetBounds()[5] == pytest.approx(2.0)  # top of the wheel that rests
    kept = vtkhelios.plan(survey, grid=20, moving_parts=True)
    assert kept.scene.GetBounds()[5] == pytest.approx(4.0)
    assert kept.report["settings"]["movingParts"] is True


@pytest.mark.parametrize("motion", ["continuous", None])
@pytest.mark.parametrize("sub_rays", [None, 19])
def test_a_pulse_alone_has_the_same_echoes(survey, motion, sub_rays):
    """Pulses are traced in groups where nothing moves; results do not depend on that."""
    read = vtkhelios.read_survey(survey)
    read.parts[1].motion = motion
    options = {"noise": False} | ({} if sub_rays is None else {"sub_rays": sub_rays})
    whole = read.run(**options)
    pulses = whole["PulseIds"]
    moving = np.unique(pulses[np.isin(whole["PartIds"], (1, 2))])
    assert len(moving) > 1000
    for pulse in np.unique(moving[40 :: len(moving) // 40] + np.array([[-1], [0], [1]])):
        alone = read.run_window(options, (int(pulse), int(pulse) + 1))
        assert np.array_equal(alone.points, whole.points[pulses == pulse]), pulse
