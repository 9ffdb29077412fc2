# SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
# SPDX-License-Identifier: BSD-3-Clause
"""Trajectories and georeferencing against recorded data and independent programs.

Data are in real/ of the folder that HELIOS_DATA names; without it: data of a folder "shared" beside
the repository."""

import importlib
import pathlib
import sys

import numpy as np
import pytest

import vtkhelios

STUDIES = pathlib.Path(__file__).resolve().parents[2] / "studies"


@pytest.fixture
def study(monkeypatch):
    monkeypatch.syspath_prepend(STUDIES)
    return importlib.import_module("trajectories")


def _need(study, name):
    """The path of a file of the data; skips the test without it."""
    path = study.DATA / name
    if not path.is_file():
        pytest.skip(f"without {name}")
    return path


def test_optech_pulses_within_a_millimetre(study):
    """Platform, mount and mirror in a local system, against matrices in geocentric coordinates."""
    pulses, boresight = study.read_csd(_need(study, "sensor/optech_sample.csd"))
    assert len(pulses["time"]) == 1000
    found = study.compare_georeferencing(pulses, boresight)
    assert found["local"].max() < 1e-6
    # a projected system changes lengths, by the scale of the map at the place
    assert 0.01 < found["utm"].max() < 0.1
    # another order of pitch and roll is seen
    assert found["arinc"].max() > 0.02


def test_optech_scan_angles(study):
    """A rounded triangle is the law of the recorded angles to 0.2 degrees, not to their noise."""
    pulses, _ = study.read_csd(_need(study, "sensor/optech_sample.csd"))
    fitted, residual = study.fit_mirror(pulses)
    assert study.angle_noise(pulses) < 1e-3
    assert np.sqrt(np.mean(residual**2)) < 0.06 and np.abs(residual).max() < 0.2
    assert fitted["frequency"] == pytest.approx(59.9, abs=0.2)
    assert fitted["angle"] == pytest.approx(15.2, abs=0.1)


def test_laws_of_the_optech_mirror(study):
    """The rounded triangle of harmonics equals the law of our mirror; no law reaches the noise."""
    pulses, _ = study.read_csd(_need(study, "sensor/optech_sample.csd"))
    found = study.compare_laws(pulses)
    rms = {name: np.sqrt(np.mean(residual**2)) for name, (residual, _) in found.items()}
    ours = study.fit_mirror(pulses)[1]
    assert rms["rounded triangle"] == pytest.approx(np.sqrt(np.mean(ours**2)), rel=0.02)
    assert rms["rounded triangle through a second-order system"] < 0.01
    assert min(rms.values()) > 5 * study.angle_noise(pulses)


def test_laws_find_what_they_are_made_of(monkeypatch):
    monkeypatch.syspath_prepend(STUDIES)
    laws = importlib.import_module("_mirror_laws")
    phase = np.linspace(0, 2 * np.pi, 9)
    assert np.allclose(laws.triangle(phase, 1), np.abs(np.arange(9) - 4) / 2 - 1, atol=0.02)
    time = np.linspace(0, 0.014, 500)
    angle = 17 * laws.triangle(2 * np.pi * 60.3 * time + 3, laws.second_order(6.0, 0.7)) + 0.1
    residual, unknowns = laws.fit_law("triangle through a second-order system", time, angle, 59.9)
    assert unknowns == 6 and np.abs(residual).max() < 1e-4


def test_atm_is_a_palmer_scanner(study):
    shots = study.read_qfit(_need(study, "sensor/atm_qfit.qi"))
    assert len(shots["time"]) == 10314
    cone = study.fit_pattern(shots, 70, 75, "cone")
    palmer = study.fit_pattern(shots, 70, 75, "palmer")
    assert cone["rms"] > 3
    assert palmer["rms"] < 1.2 and palmer["median"] < 0.6
    assert palmer["speed"] == pytest.approx(135, abs=3)


def test_the_palmer_mirror_of_the_fit_is_ours(study):
    mirror = vtkhelios.vtkHeliosPalmerMirror()
    mirror.SetWobbleAngle(7.2)
    mirror.SetPulseFrequency(36)
    mirror.SetScanFrequency(1)
    phases = np.radians(10.0 * np.arange(36))
    ours = np.empty((36, 3))
    for k in range(36):
        direction = [0.0, 0.0, 0.0]
        mirror.GetDirection(k, direction)
        ours[k] = direction
    assert np.allclose(study.palmer(np.radians(7.2), phases), ours, atol=1e-12)


def test_two_points_of_sbet(study):
    """The velocities of a recorded file decide the sign of the wander angle."""
    angles = study.compare_wander(_need(study, "trajectory/two_points.sbet"))
    assert abs(angles["subtracted"]) < 0.5
    assert abs(angles["added"]) > 2
    assert abs(angles["ignored"]) > 0.9


def test_sbet_in_utm_against_pyproj(study, tmp_path):
    pytest.importorskip("pyproj")
    position, yaw = study.compare_projection(tmp_path, 200)
    assert position < 1e-6
    assert yaw < 1e-8


def test_sbet_time_and_target(tmp_path):
    """The EPSG code of the target is the field data CRS of the output."""
    records = np.zeros((2, 17))
    records[:, 0] = 1, 2
    records[:, 1:3] = np.radians([49, 9])
    path = tmp_path / "a.out"
    path.write_bytes(records.astype("<f8").tobytes())
    reader = vtkhelios.vtkHeliosTrajectoryReader()
    reader.SetFileName(str(path))
    flight = vtkhelios.update(reader)
    assert np.array_equal(vtkhelios.arrays(flight)["GpsTime"], [1, 2])
    assert flight.GetFieldData().GetAbstractArray("CRS").GetValue(0) == "EPSG:32632"


def test_euroc(study):
    """All rows of a recorded file; its quaternions have few digits and are normalized."""
    path = _need(study, "trajectory/euroc_v102.csv")
    raw = np.loadtxt(path, delimiter=",")
    reader = vtkhelios.vtkHeliosTrajectoryReader()
    reader.SetFileName(str(path))
    reader.SetFileFormatToEuroc()
    rows = vtkhelios.arrays(vtkhelios.update(reader))
    assert len(rows["GpsTime"]) == len(raw)
    assert np.abs(rows["GpsTime"] - raw[:, 0] / 1e9).max() < 5e-7
    assert np.array_equal(rows["points"], raw[:, 1:4])
    unit = raw[:, 4:8] / np.linalg.norm(raw[:, 4:8], axis=1, keepdims=True)
    signs = np.sign(np.sum(rows["Orientation"] * unit, axis=1))
    assert np.abs(signs[:, None] * rows["Orientation"] - unit).max() < 1e-15


def test_errors_of_a_real_report(study):
    report = vtkhelios.vtkHeliosNavigationReport()
    path = _need(study, "trajectory/smrmsg.txt")
    assert report.Read(str(path))
    raw = np.loadtxt(path, delimiter=",", skiprows=1)
    expected = np.sqrt(np.mean(raw**2, axis=0))
    assert report.GetNumberOfRows() == len(raw) == 21902
    found = [report.GetRMS(k) for k in range(6)]
    assert found[:3] == pytest.approx(expected[[2, 1, 3]])
    assert found[3:] == pytest.approx(expected[[8, 7, 9]] / 60)


def test_navigation_grade_is_that_of_a_real_report(study):
    """The medians of the report are the numbers of the grade "navigation"."""
    raw = np.loadtxt(_need(study, "trajectory/smrmsg.txt"), delimiter=",", skiprows=1)
    north, east, down = np.median(raw, axis=0)[1:4]
    roll, pitch, heading = np.median(raw, axis=0)[7:] / 60
    noise = vtkhelios.vtkHeliosPlatformNoise()
    assert noise.SetGrade("navigation")
    found = [noise.GetSlowErrorRMS(k) for k in range(6)]
    assert found[:3] == pytest.approx([east, north, down], abs=5e-4)
    assert found[3:] == pytest.approx([pitch, roll, heading], abs=5e-5)


def test_strips_differ_by_their_slow_errors(study):
    """Height differences of two strips over a plane equal the errors at their times."""
    strips = study.fly_strips(seed=3)
    for strip in strips:
        assert strip["heights"] == pytest.approx(strip["expected"], abs=2e-3)
    assert len({round(strip["heights"], 4) for strip in strips}) == len(strips)


def test_quick_run(study, tmp_path, monkeypatch, capsys):
    if not study.DATA.is_dir():
        pytest.skip("without the data")
    pytest.importorskip("matplotlib")
    monkeypatch.setattr(sys, "argv", ["trajectories.py", str(tmp_path), "--quick"])
    study.main()
    assert (tmp_path / "trajectories.png").is_file()
    assert "georeferencing" in capsys.readouterr().out
