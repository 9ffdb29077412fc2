# SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
# SPDX-License-Identifier: BSD-3-Clause
"""The study of large footprints: its percentiles against closed forms, its results."""

import importlib
import pathlib
import sys

import numpy as np
import pytest

import vtkhelios
from vtkhelios.example_surveys import write_example

STUDIES = pathlib.Path(__file__).resolve().parents[2] / "studies"


@pytest.fixture
def study(monkeypatch):
    monkeypatch.syspath_prepend(STUDIES)
    return importlib.import_module("large_footprint")


def test_percentiles_of_a_uniform_profile(study):
    heights = np.arange(0.0, 20.0, 0.1)
    found = study.find_percentiles(heights, np.ones(200))
    assert found == pytest.approx(0.2 * np.array(study.PERCENTS), abs=0.11)


def test_points_are_folded_with_the_pulse_and_the_beam(study):
    """A plane: the percentiles of the pulse. Points far from the centre weigh less."""
    x, y = np.meshgrid(np.linspace(-30, 30, 121), np.linspace(-30, 30, 121))
    points = np.c_[x.ravel(), y.ravel(), np.where(np.hypot(x, y).ravel() < 5.5, 10.0, 0.0)]
    cloud = vtkhelios.Cloud.from_arrays(points * [1.0, 1.0, 0.0])
    flat = study.find_percentiles(*study.make_profile(cloud, (0, 0), False))
    assert flat[1] == pytest.approx(0.0, abs=0.1)
    assert flat[3] == pytest.approx(1.2816 * study.PULSE, abs=0.12)
    step = vtkhelios.Cloud.from_arrays(points)
    heights, energies = study.make_profile(step, (0, 0), False)
    inside = energies[heights > 5].sum() / energies.sum()
    assert inside == pytest.approx(1 - np.exp(-0.5), rel=0.03)  # energy within one sigma


def test_study(study, tmp_path, monkeypatch, capsys):
    pytest.importorskip("matplotlib")
    monkeypatch.setattr(sys, "argv", ["large_footprint.py", str(tmp_path / "out"), "--quick"])
    monkeypatch.setattr(study, "measure_costs", lambda survey, counts: [{"sub_rays": 1}])
    rows = study.main()["percentiles"]
    assert "9 footprints" in capsys.readouterr().out
    assert [row["percentile"] for row in rows] == ["RH25", "RH50", "RH75", "RH90", "RH98"]
    # Points count leaves, not light: they are higher; with their energies they agree.
    assert all(abs(row["energies_m"]) < 0.5 for row in rows)
    assert max(row["points_m"] for row in rows) > 1.5 and rows[-1]["GEDI_m"] > 12
    assert (tmp_path / "out" / "large_footprint.png").read_bytes()[1:4] == b"PNG"


def test_the_example_has_nine_footprints_in_the_stand(study, tmp_path):
    write_example("forest", tmp_path / "stand")
    survey = vtkhelios.read_survey(tmp_path / "stand" / "space.xml")
    cloud = survey.run(
        waveforms=True, noise=False, instances=True, tolerance=0.1, energy_tolerance=0.2
    )
    centres = study.Waveforms(cloud.waveforms).centres
    expected = [(x, y) for x in (-10, 0, 10) for y in (-10, 0, 10)]
    assert np.array(centres) == pytest.approx(np.array(expected), abs=0.2)
    assert set(cloud["ChannelIds"]) == {2}
