# SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
# SPDX-License-Identifier: BSD-3-Clause
"""Pulses across the swath: what the study reads from whole degrees, and the real tiles."""

import importlib
import pathlib
import sys

import numpy as np
import pytest

from _real_data import real_file

STUDIES = pathlib.Path(__file__).resolve().parents[2] / "studies"
RATE, FREQUENCY, ANGLE, TURNING, SPEED = 100e3, 65.0, 15.0, 200, 60.0


@pytest.fixture
def study(monkeypatch):
    monkeypatch.syspath_prepend(STUDIES)
    return importlib.import_module("swath")


@pytest.fixture
def flown(study):
    return study.fly(RATE, FREQUENCY, ANGLE, TURNING, SPEED, duration=0.25)


def test_rate_lines_and_speed_of_a_flight(study, flown):
    assert study.find_rate(flown) == pytest.approx(RATE, rel=1e-6)
    assert study.line_period(flown) == pytest.approx(1 / FREQUENCY, abs=1e-5)
    spacing, speed = study.line_spacing(flown, flown["points"])
    assert speed == pytest.approx(SPEED, rel=1e-3)
    assert np.allclose(spacing, SPEED / FREQUENCY, atol=2 * SPEED / RATE)


def test_times_per_degree_of_a_flight(study, flown):
    """Pulses between half degrees, from whole degrees: the times of the mirror within a pulse."""
    found = RATE * study.times_per_degree(flown)
    expected = RATE * study.mirror_times(RATE, FREQUENCY, ANGLE, TURNING)
    assert np.abs(found - expected).max() < 1.0
    assert expected[0] == pytest.approx(
        (RATE / FREQUENCY / 2 - TURNING / 2) / (2 * ANGLE), rel=1e-3
    )
    assert study.pulses_in_turn(flown) == pytest.approx(expected[-1], abs=1.0)


def test_the_fit_finds_the_mirror(study):
    times = study.mirror_times(RATE, FREQUENCY, 15.2, 160)
    angle, turning = study.fit_mirror(times, RATE, FREQUENCY)
    assert angle == pytest.approx(15.2, abs=0.01)
    assert turning == pytest.approx(160, abs=1)


def test_real_tiles(study):
    data = real_file("als/bcts_1.laz").parents[1]
    real_file("als/bcts_2.laz")
    real, (angle, turning), simulated = study.compare(data)
    assert real["rate"] == pytest.approx(100e3, rel=1e-3)
    assert real["frequency"] == pytest.approx(65.06, abs=0.05)
    assert angle == pytest.approx(14.9, abs=0.1) and turning == pytest.approx(203, abs=10)
    ratio = simulated["times"] / real["times"]
    assert np.abs(ratio[:9] - 1).max() < 0.02  # to 9 degrees
    assert np.abs(ratio - 1).max() < 0.12
    assert real["turn"] < 0.4 * simulated["turn"]  # pulses of the turn are not in the file


def test_run(study, tmp_path, monkeypatch, capsys):
    real_file("als/bcts_1.laz")
    monkeypatch.setattr(sys, "argv", ["swath.py", str(tmp_path)])
    study.main()
    assert (tmp_path / "swath.csv").is_file() and (tmp_path / "lines.csv").is_file()
    assert "line spacing" in capsys.readouterr().out
