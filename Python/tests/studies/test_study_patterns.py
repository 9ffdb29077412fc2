# SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
# SPDX-License-Identifier: BSD-3-Clause
"""Scan patterns of the catalogue against the instruments'."""

import importlib
import pathlib
import sys

import numpy as np
import pytest

from _real_data import real_file

STUDIES = pathlib.Path(__file__).resolve().parents[2] / "studies"


@pytest.fixture
def study(monkeypatch):
    monkeypatch.syspath_prepend(STUDIES)
    return importlib.import_module("patterns")


def test_directions_and_angles(study):
    found = study.to_directions([[0, 0], [np.pi / 2, 0], [0.3, np.pi / 2]])
    assert found == pytest.approx(np.array([[0, 1, 0], [-1, 0, 0], [0, 0, 1]]), abs=1e-15)
    assert study.angles_between(found[:1], found[1:2]) == pytest.approx([90])
    tiny = study.to_directions([[1e-9, 0]])
    assert study.angles_between(found[:1], tiny) == pytest.approx([np.degrees(1e-9)], rel=1e-6)


@pytest.mark.parametrize("instrument", ["livox_mid40", "livox_avia"])
def test_pattern_of_the_manufacturer(study, instrument):
    result = study.compare_livox(instrument, real_file(f"pattern/{instrument}.npy"))
    assert result["pulses"] == 100_000
    assert result["rms"] < 0.02 and result["maximum"] < 0.05  # mdeg


def test_ouster_by_its_manual(study):
    rows = study.compare_ouster(real_file("sensor/ouster_os1_128.json"))
    assert [one["pulses"] for one in rows] == [131072, 131072]
    directions, origins = rows
    assert directions["unit"] == "mdeg" and np.radians(directions["maximum"] / 1000) < 1e-6
    assert origins["unit"] == "um" and origins["maximum"] < 1e-3  # nm


def test_table(study, tmp_path, monkeypatch, capsys):
    folder = tmp_path / "pattern"
    folder.mkdir()
    ours = study.directions_of("livox_mid40", 101, 100_000)[1:]
    angles = [np.arctan2(-ours[:, 0], ours[:, 1]), np.arcsin(ours[:, 2])]
    np.save(folder / "livox_mid40.npy", np.stack(angles, axis=1).astype(np.float32))
    monkeypatch.setattr(sys, "argv", ["patterns.py", str(tmp_path), "--quick"])
    study.main()
    lines = capsys.readouterr().out.splitlines()
    assert lines[0].startswith("| instrument |") and len(lines) == 3
    name, what, pulses, rms, maximum = lines[2].strip("| ").split(" | ")
    assert (name, what, pulses) == ("livox_mid40", "directions", "100")
    for text in (rms, maximum):
        assert text == "< 0.001 mdeg" or float(text.split()[0]) < 0.01
