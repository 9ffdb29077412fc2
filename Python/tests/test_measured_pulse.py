# SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
# SPDX-License-Identifier: BSD-3-Clause
"""The pulse of an instrument, from its outgoing waveforms."""

import numpy as np
import pytest
from _real_data import real_file
from vtkmodules.vtkCommonCore import vtkPoints
from vtkmodules.vtkCommonDataModel import vtkPolyData
from vtkmodules.vtkFiltersCore import vtkTriangleFilter
from vtkmodules.vtkFiltersSources import vtkPlaneSource

import vtkhelios
from vtkhelios import cli, formats
from vtkhelios.surveys import measured_pulse

RIEGL = "waveform/100429_152240_2535pt_UTM.pls"


def ring(time):
    """A pulse of 4 ns with its peak at 0, and ringing from 6 ns on."""
    late = np.maximum(time - 6.0, 0.0)
    return np.exp(-0.5 * (time * 2.3548 / 4.0) ** 2) + 0.03 * np.exp(-late / 3) * np.sin(late)


def make_pulses(count=500, noise=0.0):
    """Samples of 1 ns at random phases, heights and zeros."""
    random = np.random.default_rng(3)
    pulses = []
    for _ in range(count):
        time = np.arange(-12.0, 14.0) + random.uniform(-0.5, 0.5)
        samples = random.uniform(50, 200) * ring(time) + random.uniform(0, 5)
        pulses.append(samples + noise * random.standard_normal(len(time)))
    return pulses


def test_the_mean_of_pulses_is_finer_than_their_samples():
    table = measured_pulse.average_pulses(make_pulses(), 1.0, step=0.2)
    assert len(table) > 100 and (np.diff(table[:, 0]) > 0).all()
    assert np.abs(table[:, 1] - ring(table[:, 0])).max() < 2e-3
    noisy = measured_pulse.average_pulses(make_pulses(noise=1.0), np.ones(500), step=0.2)
    assert np.abs(noisy[:, 1] - np.interp(noisy[:, 0], *table.T)).max() < 0.01


def test_bad_pulses():
    flat, cut = np.zeros(20), np.arange(20.0)
    with pytest.raises(ValueError, match="none of 3 outgoing waveforms has a peak inside"):
        measured_pulse.average_pulses([flat, cut, cut[:4]], 1.0)
    with pytest.raises(ValueError, match=r"step is 0; give a positive time \[ns\]"):
        measured_pulse.average_pulses(make_pulses(1), 1.0, step=0)
    good = make_pulses(20)
    assert np.array_equal(
        measured_pulse.average_pulses([*good, flat, cut], 1.0),
        measured_pulse.average_pulses(good, 1.0),
    )


def test_a_scan_with_the_measured_pulse(tmp_path, capsys):
    path, output = real_file(RIEGL), tmp_path / "pulse.csv"
    assert cli.main(["instrument", str(path), "--output", str(output)]) == 0
    assert capsys.readouterr().out.strip() == str(output)
    lines = output.read_text().splitlines()
    assert lines[0] == f"# the mean outgoing pulse of {path.name}"
    table = np.array([line.split(",") for line in lines[2:]], float)
    half = table[table[:, 1] >= 0.5, 0]
    assert np.ptp(half) == pytest.approx(4.5, abs=0.2)  # [ns]
    assert table[np.abs(table[:, 0] - 9.4).argmin(), 1] == pytest.approx(0.018, abs=2e-3)  # rings

    for detector in ("peak", "gaussian", "cfd"):
        assert range_of_wall(output, detector) == pytest.approx(40.0, abs=4e-3), detector


def range_of_wall(pulse, detector):
    """The range of a wall across the beam, 40 m ahead."""
    wall = vtkPlaneSource()
    wall.SetOrigin(-20, 40, -20)
    wall.SetPoint1(20, 40, -20)
    wall.SetPoint2(-20, 40, 20)
    triangles = vtkTriangleFilter()
    triangles.SetInputConnection(wall.GetOutputPort())
    place = vtkPoints()
    place.SetDataTypeToDouble()
    place.InsertNextPoint(0, 0, 0)
    waypoints = vtkPolyData()
    waypoints.SetPoints(place)
    platform = vtkhelios.vtkHeliosStaticPlatform()
    platform.SetInputData(waypoints)
    scanner = vtkhelios.vtkHeliosScanner(pulse_file_name=str(pulse), duration=1e-4)
    scanner.SetPulseShapeToSampled()
    scanner.SetInputConnection(0, triangles.GetOutputPort())
    scanner.SetInputConnection(1, platform.GetOutputPort())
    scanner.SetBeamDeflector(vtkhelios.vtkHeliosConicMirror(scan_angle=0.0))
    scanner.SetEchoDetector(vtkhelios.vtkHeliosEchoDetection.MakeDetector(detector))
    scanner.GetEchoDetector().SetDetectionThreshold(1e-6)  # above noise and ringing
    return vtkhelios.arrays(vtkhelios.update(scanner))["Range"][0]


def test_errors_name_the_file(tmp_path, capsys, monkeypatch):
    missing = tmp_path / "none.pls"
    assert cli.main(["instrument", str(missing)]) == 1
    assert f"{missing}: " in capsys.readouterr().err
    path = real_file(RIEGL)
    whole = formats.read_pulsewaves(path)
    whole.outgoing.SetNumberOfRows(0)
    monkeypatch.setattr(measured_pulse, "read_pulsewaves", lambda _: whole)
    with pytest.raises(formats.FormatError, match="has no outgoing waveforms; give a file with"):
        measured_pulse.read_pulse(path)
