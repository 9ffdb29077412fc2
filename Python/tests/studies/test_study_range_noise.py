# SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
# SPDX-License-Identifier: BSD-3-Clause
"""Range noise of planes against the bound of Cramer and Rao."""

import importlib
import math
import pathlib
import sys

import pytest

STUDIES = pathlib.Path(__file__).resolve().parents[2] / "studies"


@pytest.fixture
def study(monkeypatch):
    monkeypatch.syspath_prepend(STUDIES)
    return importlib.import_module("range_noise")


@pytest.mark.parametrize("distance, incidence", [(50, 0), (25, 75), (100, 60)])
def test_spread_is_the_bound(study, distance, incidence):
    """The spread of 1,000 ranges is known to 2.2 %, one sigma."""
    row = study.compare(study.reference_noise(), distance, incidence, 1000)
    assert row["Gaussian"] == pytest.approx(row["bound"], rel=0.08)
    assert row["Peak"] > 1.5 * row["bound"]


def test_signal_is_that_of_a_plane(study):
    row = study.compare(study.reference_noise(), 50, 60, 1)
    assert row["signal to noise"] == pytest.approx(row["signal law"], rel=0.01)
    flat = study.compare(study.reference_noise(), 100, 85, 1)
    assert flat["signal to noise"] < 0.8 * flat["signal law"]


def test_bound(study):
    """Twice the noise, twice the spread; a footprint of 0.25 m at 45 degrees is 0.125 m / c wide."""
    assert study.range_bound(2, 50) == pytest.approx(2 * study.range_bound(2, 100))
    wide = study.echo_deviation(500, 45)
    pulse = study.echo_deviation(500, 0)
    assert wide**2 - pulse**2 == pytest.approx((2 * 0.125 / study.LIGHT) ** 2)


def test_lost_echoes_have_no_spread(study):
    assert math.isnan(study.compare(study.reference_noise(), 100, 85, 200)["Gaussian"])
    assert study.spread_of(math.nan) == "lost" and study.spread_of(0.00123) == "1.23"


def test_quick_run(study, tmp_path, monkeypatch, capsys):
    pytest.importorskip("matplotlib")
    monkeypatch.setattr(study, "RANGES", (50.0,))
    monkeypatch.setattr(sys, "argv", ["range_noise.py", str(tmp_path), "--quick"])
    study.main()
    assert (tmp_path / "range_noise.png").is_file() and (tmp_path / "range_noise.csv").is_file()
    assert "Range noise" in capsys.readouterr().out
