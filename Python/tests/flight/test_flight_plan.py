# SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
# SPDX-License-Identifier: BSD-3-Clause
"""vtkhelios.plan_flight(): designs against closed forms, predictions against simulated echoes."""

import math

import numpy as np
import pytest

import vtkhelios
from vtkhelios.plans.kinds import SettingError
from vtkhelios.array_names import RETURN_NUMBER
from vtkhelios.flight._check import Counts
from vtkhelios.flight._settings import ALL, check_flight_settings


def check_plan(plan):
    """Simulates a FlightPlan in memory, without noise; returns the comparison of Counts.compare()."""
    counts, survey = Counts(plan), plan.survey()
    legs = [leg.index for leg in survey.legs if leg.active]
    for leg in legs:
        if survey.leg_pulses(leg)[0] == survey.leg_pulses(leg)[1]:
            continue
        cloud = survey.run(legs=leg, noise=False)
        counts.add(cloud.points[cloud[RETURN_NUMBER] == 1])
    return counts.compare()


def make_ground(height=lambda x, y: 0.0 * x, size=(240.0, 160.0), step=10.0, margin=60.0):
    """A scene of ground over [0, size] and a margin around it."""
    x = np.arange(-margin, size[0] + margin + step / 2, step)
    y = np.arange(-margin, size[1] + margin + step / 2, step)
    xs, ys = np.meshgrid(x, y)
    points = np.column_stack([xs.ravel(), ys.ravel(), height(xs, ys).ravel()])
    first = (np.arange(len(y) - 1)[:, None] * len(x) + np.arange(len(x) - 1)).ravel()
    n = len(x)
    lower = np.column_stack([first, first + 1, first + n + 1])
    upper = np.column_stack([first, first + n + 1, first + n])
    return vtkhelios.Scene(points, np.concatenate([lower, upper]))


def make_hills(x, y):
    """Slopes of up to 24 degrees."""
    return 12.0 * np.sin(x / 40.0) * np.cos(y / 35.0) + 0.03 * x


AREA = [(0, 0), (240, 0), (240, 160), (0, 160)]


@pytest.fixture(scope="module")
def flat():
    return make_ground()


# The design against closed forms.


def test_a_rotating_mirror_on_flat_ground(flat):
    plan = vtkhelios.plan_flight(
        flat, area=AREA, density=5, flying_height=100, scanner="copter_uls", pulse_frequency=100e3,
        scan_angle=30, side_overlap=25, min_speed=1, max_speed=50, turn_time=20, heading=90,
    )  # fmt: skip
    design, swath = plan.design, 2 * 100 * math.tan(math.radians(30))
    # 100 kHz over 360 degrees: a pulse each d radians, the least density at the edges, cos^2 of nadir.
    rate = 100e3 / (2 * math.pi)
    speed = rate * math.cos(math.radians(30)) ** 2 / (100 * 5)
    assert design.speed == pytest.approx(speed, rel=0.01)
    assert design.swath_width == pytest.approx(swath, rel=0.002)
    assert design.line_spacing == pytest.approx(0.75 * design.swath_width)
    lines = math.ceil((160 - swath) / (0.75 * swath)) + 1
    assert len(plan) == lines == 2
    assert [row["heading_deg"] for row in plan.lines] == pytest.approx([90, 270])
    assert plan.pattern["time_s"] == pytest.approx(lines * 240 / design.speed + 20 * (lines - 1))
    nadir = rate / (100 * design.speed)
    assert plan.cells["StripDensity"].max() == pytest.approx(nadir, rel=0.01)
    assert plan.cells["StripDensity"].min() >= 5 * 0.999
    # Lines as far apart as pulses at nadir: v / f = 100 d.
    angle = 2 * math.pi * design.scan_frequency / 100e3
    assert design.speed / design.scan_frequency == pytest.approx(100 * angle, rel=0.01)
    assert plan.report["predicted"]["covered_percent"] == 100
    assert plan.waypoints.points[:, 2] == pytest.approx(100)


def test_spacing_of_pulses(flat):
    plan = vtkhelios.plan_flight(
        flat, area=AREA, spacing=(0.5, 0.8), flying_height=120, scanner="copter_uls", scan_angle=30,
        max_speed=60,
    )  # fmt: skip
    design = plan.design
    step = 2 * math.pi * design.scan_frequency / design.pulse_frequency  # radians
    assert design.speed / design.scan_frequency == pytest.approx(0.5, rel=1e-6)
    assert design.across == pytest.approx(120 * step / math.cos(math.radians(30)) ** 2, rel=0.01)
    assert design.across <= 0.8 * (1 + 1e-9)


def test_the_fastest_of_heights_and_frequencies(flat):
    settings = dict(area=AREA, density=10, scanner="copter_uls", scan_angle=40)
    best = vtkhelios.plan_flight(flat, min_flying_height=40, max_flying_height=160, **settings)
    for height in (40, 80, 120, 160):
        for frequency in (100e3, 550e3):
            try:
                other = vtkhelios.plan_flight(
                    flat, flying_height=height, pulse_frequency=frequency, **settings
                )
            except SettingError as error:
                assert "no flight meets the requirements" in str(error)  # noqa: PT017
                continue
            assert best.pattern["time_s"] <= other.pattern["time_s"] * 1.002


def test_of_equal_times_the_fewest_pulses(flat):
    settings = dict(area=AREA, density=8, flying_height=150, scanner="rotating_als")
    plan = vtkhelios.plan_flight(flat, max_speed=40, **settings)
    assert plan.design.pulse_frequency == 150e3 and plan.design.speed == 40
    least = plan.report["predicted"]["strip_1_m2"]["minimum"]
    assert 8 <= least <= 16
    assert plan.steps["lower"] == "no lower pulse frequency to choose"
    higher = plan.report["steps"]["higher"]
    assert higher["pulseFrequency_Hz"] == 250e3 and higher["speed_m_s"] == 40
    assert higher["timeFactor"] == pytest.approx(1)
    assert higher["pulsesFactor"] == pytest.approx(250 / 150)
    other = vtkhelios.plan_flight(flat, max_speed=40, pulse_frequency=250e3, **settings)
    assert other.pattern["time_s"] == pytest.approx(plan.pattern["time_s"], rel=1e-3)
    assert other.design.density == pytest.approx(higher["strip_1_m2"], rel=0.01)
    assert other.steps == {name: f"no {name} pulse frequency to choose" for name in plan.steps}


def test_the_cost_of_fewer_pulses(flat):
    settings = dict(area=AREA, flying_height=150, scanner="rotating_als", max_speed=40)
    plan = vtkhelios.plan_flight(flat, density=20, turn_time=10, min_speed=10, **settings)
    lower = plan.steps["lower"]
    assert lower.pulse_frequency < plan.design.pulse_frequency
    assert lower.density == pytest.approx(20) and lower.speed < 40
    assert lower.time > plan.design.time and lower.pulses < plan.design.pulses
    plan = vtkhelios.plan_flight(flat, density=20, min_speed=39.9, **settings)
    assert "the speed would be" in plan.report["steps"]["lower"]["reason"]


def test_limits_of_the_instrument(flat):
    plan = vtkhelios.plan_flight(
        flat, area=AREA, density=3, scanner="livox_mid70", platform="copter_linearpath"
    )
    slant = plan.design.flying_height * math.hypot(1, plan.swath.GetRightTangent())
    assert slant <= 260 * 1.001
    plan = vtkhelios.plan_flight(
        flat, area=AREA, density=0.2, scanner="oscillating_als", flying_height=200
    )
    assert plan.design.scan_angle * plan.design.scan_frequency <= 1000 * (1 + 1e-9)
    plan = vtkhelios.plan_flight(
        flat, area=AREA, density=5, scanner="copter_uls", nohd=90, max_flying_height=150
    )
    assert plan.cells["FlyingHeight"].min() >= 90


# Predicted against simulated. The tolerance of the mean comes from the edges of cells and lines.

FLIGHTS = {  # scanner: settings, tolerance of the mean [%], of 95 % of the cells [%]
    "copter_uls": (dict(flying_height=60, density=4, scan_angle=35, pulse_frequency=50e3), 0.5, 5),
    "oscillating_als": (
        dict(flying_height=150, density=1, scan_angle=20, pulse_frequency=33e3),
        0.5,
        10,
    ),
    "conic_als": (dict(flying_height=150, density=5, pulse_frequency=200e3), 0.5, 20),
    "riegl_vq840gl": (dict(flying_height=80, density=5, pulse_frequency=50e3), 0.5, 35),
    "fiber_als": (dict(flying_height=400, density=2), 0.5, 15),
    "livox_mid40": (dict(flying_height=70, density=5), 0.5, 45),
    "riegl_vq1560i": (dict(flying_height=200, density=5, pulse_frequency=150e3), 0.5, 5),
}


@pytest.mark.parametrize("scanner", FLIGHTS)
def test_simulated_density_on_flat_ground(flat, scanner):
    settings, mean, cells = FLIGHTS[scanner]
    plan = vtkhelios.plan_flight(flat, area=AREA, scanner=scanner, **settings)
    check = check_plan(plan)
    assert check["cells"] > 20
    assert abs(check["bias_percent"]) < mean, check
    assert check["within95_percent"] < cells, check
    assert check["empty"] == 0 or not plan.instrument.has_lines(), check
    assert plan.report["predicted"]["met_percent"] > 99


@pytest.mark.parametrize("follows", [False, True])
def test_simulated_density_on_hills(follows):
    plan = vtkhelios.plan_flight(
        make_ground(make_hills, step=4.0), area=AREA, scanner="copter_uls", flying_height=70, density=5,
        scan_angle=35, terrain_following=follows, max_climb=25, min_speed=1, pulse_frequency=50e3,
    )  # fmt: skip
    flying = plan.cells["FlyingHeight"]
    assert plan.report["predicted"]["covered_percent"] == 100
    assert plan.report["predicted"]["met_percent"] >= 99
    if follows:
        assert np.ptp(plan.waypoints.points[:, 2]) > 8 and flying.max() < 95
    else:
        assert np.ptp(plan.waypoints.points[:, 2]) == 0 and flying.min() >= 69.9
    check = check_plan(plan)
    assert abs(check["bias_percent"]) < 1, check
    assert check["within95_percent"] < 10, check
    assert check["empty"] == 0, check


# Settings and errors.


def test_settings_have_defaults_and_names():
    values = check_flight_settings({"density": None})
    assert set(values) == set(ALL) and values["density"] == 4 and values["side_overlap"] == 20


@pytest.mark.parametrize(
    ("settings", "message"),
    [
        (dict(density=-1), r"density is -1; its valid range is \(0, 1e\+06\] 1/m2"),
        (dict(side_overlap=95), r"side_overlap is 95; its valid range is \[0, 90\] %"),
        (dict(spacing=(0, 1)), r"spacing is 0, 1; the valid range of both is \(0, 10000\] m"),
        (dict(density=1, spacing=(1, 1)), "density and spacing are both given; give one of them"),
        (dict(speed=1, max_speed=2), "speed and max_speed are both given"),
        (
            dict(min_speed=9, max_speed=2),
            "min_speed is 9 and max_speed is 2; give a smaller min_speed",
        ),
        (dict(), "no largest range of scanners.xml#rotating_als; give flying_height or max_flying"),
        (
            dict(flying_height=50),
            "no flight meets the requirements: the lowest height above the ground",
        ),
        (dict(flying_height=300, density=900), "the speed would be .* m/s, below 40 m/s"),
        (dict(flying_height=300, pulse_frequency=1), "pulse_frequency is 1, not supported by"),
        (dict(flying_height=300, scan_angle=50), "scan_angle is 50, above the 30 deg of"),
        (dict(flying_height=300, scan_frequency=900), "scan_frequency is 900; .* has 20 to 300 Hz"),
        (dict(flying_height=99, scanner="fiber_als", spacing=(1, 1)), "spacing needs scan lines"),
        (dict(flying_height=99, platform="tripod"), "platforms.xml#tripod, which does not move"),
        (
            dict(flying_height=300, area=[(5e3, 0), (6e3, 0), (6e3, 9)]),
            "area has no ground of the scene",
        ),
        (dict(flying_height=300, cell=1e-3), "cell is 0.001 m, which makes .* cells"),
        (dict(flying_height=3000, scanner="livox_mid40"), "largest range is .* above the 260 m"),
        (
            dict(nohd=400, scanner="livox_mid40"),
            "the lowest flying height would be .* above the largest",
        ),
    ],
)
def test_errors(flat, settings, message):
    with pytest.raises(SettingError, match=message):
        vtkhelios.plan_flight(flat, **settings)


def test_types(flat):
    with pytest.raises(
        TypeError, match="side_overlp is not a setting .* did you mean side_overlap"
    ):
        vtkhelios.plan_flight(flat, side_overlp=3)
    with pytest.raises(TypeError, match="density is 'x'; give a number"):
        vtkhelios.plan_flight(flat, density="x")
    with pytest.raises(TypeError, match="terrain_following is 1; give True or False"):
        vtkhelios.plan_flight(flat, terrain_following=1)
    with pytest.raises(TypeError, match="spacing is 3; give two numbers"):
        vtkhelios.plan_flight(flat, spacing=3)


# Files.


def test_files_are_read_back(flat, tmp_path):
    plan = vtkhelios.plan_flight(
        flat, area=AREA, name="flat", density=2, scanner="copter_uls", flying_height=80
    )
    files = {path.name: path for path in plan.write(tmp_path)}
    assert set(files) == {
        "survey.xml", "scene.obj", "lines.vtp", "cells.vtp", "lines.csv", "lines.dxf",
        "plan_summary.json",
    }  # fmt: skip
    survey = vtkhelios.read_survey(files["survey.xml"])
    assert [leg.active for leg in survey.legs] == [True, False] * len(plan)
    rows = np.loadtxt(files["lines.csv"], delimiter=",", skiprows=1, ndmin=2, usecols=range(10))
    assert len(rows) == len(plan)
    assert rows[:, 8] == pytest.approx([row["length_m"] for row in plan.lines], abs=0.06)
    assert repr(plan).startswith("FlightPlan('flat': ")
    with pytest.raises(FileExistsError, match="has the files of an earlier plan"):
        plan.write(tmp_path)
    plan.write(tmp_path, overwrite=True)
