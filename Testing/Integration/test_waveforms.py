# SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
# SPDX-License-Identifier: BSD-3-Clause
"""Waveforms of a run: written as text and as VTK tables, read back, and where their echoes are."""

import os
import pathlib
import subprocess
import sys

import numpy as np
import pytest
from vtkmodules.vtkIOXML import vtkXMLPPolyDataReader, vtkXMLPTableReader, vtkXMLTableReader

import vtkhelios

PACKAGE_DIR = pathlib.Path(vtkhelios.__file__).absolute().parents[1]
SPEED_OF_LIGHT = 0.299792458  # m/ns

SURVEY = """\
<document>
<survey name="steps" platform="platforms.xml#tripod" scanner="scanners.xml#vz400_class_tls" scene="scene.xml#s">
<FWFSettings {fwf}/>
<leg><platformSettings x="0" y="0" z="2"/>
<scannerSettings active="true" pulseFreq_hz="100000" scanFreq_hz="100" headRotatePerSec_deg="30"
 headRotateStart_deg="0" headRotateStop_deg="3"/></leg>
</survey></document>
"""
SCENE = """\
<document><scene id="s"><part><filter type="objloader">
<param type="string" key="filepath" value="steps.obj"/></filter></part></scene></document>
"""


def steps():
    """A floor, and walls one behind the other with gaps between them."""
    lines = ["v -60 -60 0", "v 60 -60 0", "v 60 60 0", "v -60 60 0", "f 1 2 3 4"]
    for k in range(40):
        x, y = -10 + 0.5 * k, 15 + 0.8 * (k % 3)
        lines += [f"v {x} {y} 0", f"v {x + 0.5} {y} 0", f"v {x + 0.5} {y} 9", f"v {x} {y} 9"]
        lines.append(f"f {4 * k + 5} {4 * k + 6} {4 * k + 7} {4 * k + 8}")
    return "\n".join(lines) + "\n"


@pytest.fixture
def run(tmp_path):
    """Runs the survey and returns the folder of its files."""

    def call(*options, fwf='binSize_ns="0.25"'):
        (tmp_path / "survey.xml").write_text(SURVEY.format(fwf=fwf))
        (tmp_path / "scene.xml").write_text(SCENE)
        (tmp_path / "steps.obj").write_text(steps())
        done = subprocess.run(
            [sys.executable, "-P", "-m", "vtkhelios", "run", "survey.xml", "--overwrite", *options],
            capture_output=True,
            text=True,
            cwd=tmp_path,
            env={**os.environ, "PYTHONPATH": str(PACKAGE_DIR)},
            timeout=300,
        )
        assert done.returncode == 0, done.stderr
        return tmp_path / "output" / "steps"

    return call


def read(reader, path):
    reader.SetFileName(str(path))
    return vtkhelios.arrays(vtkhelios.update(reader))


def samples_of(table, row):
    first = table["Offset"][row]
    return table["Samples"][first : first + table["Count"][row]]


def test_text_and_binary_are_the_same_waveforms(run):
    text = read(
        vtkhelios.vtkHeliosWaveformTextReader(),
        run("--waveforms") / "leg000_fullwave.txt",
    )
    folder = run("--waveforms", "--format", "vtp")
    binary = read(vtkhelios.vtkHeliosWaveformXMLReader(), folder / "leg000_fullwave.pvtt")
    assert not (folder / "leg000_fullwave.txt").exists()
    assert len(text["PulseIds"]) > 1000
    for name in ("PulseIds", "Count", "BinSize"):
        np.testing.assert_array_equal(text[name], binary[name])
    for name, rounding in (("Origin", 5e-5), ("StartTime", 5e-5), ("GpsTime", 5e-10)):
        np.testing.assert_allclose(text[name], binary[name], rtol=0, atol=1.01 * rounding)
    np.testing.assert_allclose(text["Direction"], binary["Direction"], rtol=0, atol=1e-9)
    # 9 decimals of a nanowatt, and the rounding of a float
    np.testing.assert_allclose(text["Samples"], binary["Samples"], rtol=6e-8, atol=5.1e-19)


def test_stock_vtk_reads_the_pieces(run):
    folder = run("--waveforms", "--format", "vtp")
    whole = read(vtkhelios.vtkHeliosWaveformXMLReader(), folder / "leg000_fullwave.pvtt")
    pieces = sorted(folder.glob("leg000_fullwave_*.vtt"))
    index = vtkXMLPTableReader()
    index.SetFileName(str(folder / "leg000_fullwave.pvtt"))
    index.UpdateInformation()
    assert index.GetNumberOfPieces() == len(pieces)
    row, sample = 0, 0
    for k, path in enumerate(pieces):
        index.UpdatePiece(k, len(pieces), 0)
        table = vtkhelios.arrays(index.GetOutput())
        alone = read(vtkXMLTableReader(), path)
        for name, values in alone.items():
            np.testing.assert_array_equal(table[name], values)
        count = len(alone["PulseIds"])
        np.testing.assert_array_equal(alone["PulseIds"], whole["PulseIds"][row : row + count])
        assert set(whole["Offset"][row : row + count] - alone["Offset"]) == {sample}
        row += count
        sample += len(alone["Samples"])
    assert row == len(whole["PulseIds"]) and sample == len(whole["Samples"])


@pytest.mark.parametrize("fwf", ['binSize_ns="0.25"', 'beamSampleQuality="3"'])
def test_echoes_are_where_their_waveforms_peak(run, fwf):
    folder = run("--waveforms", "--format", "vtp", "--no-noise", fwf=fwf)
    waveforms = read(vtkhelios.vtkHeliosWaveformXMLReader(), folder / "leg000_fullwave.pvtt")
    echoes = read(vtkXMLPPolyDataReader(), folder / "leg000_points.pvtp")
    rows = {pulse: row for row, pulse in enumerate(waveforms["PulseIds"])}
    assert (echoes["WaveformIds"] == echoes["PulseIds"]).all()
    several = np.flatnonzero(echoes["NumberOfReturns"] > 1)
    assert len(several) > 20
    sigma = 3.0 / 2.3548  # of a pulse, or less
    for i in np.concatenate([several[:200], np.arange(0, len(echoes["Range"]), 97)]):
        row = rows[echoes["WaveformIds"][i]]
        samples, bin_size = samples_of(waveforms, row), waveforms["BinSize"][row]
        time = 2 * echoes["Range"][i] / SPEED_OF_LIGHT - waveforms["StartTime"][row]
        at = int(round(time / bin_size))
        near = samples[max(0, at - 2) : at + 3]
        assert samples[at] > 0.98 * near.max()  # a maximum within a bin or two
        assert echoes["Amplitude"][i] == pytest.approx(near.max(), rel=0.1 * bin_size / sigma)


def test_curves_stand_beside_their_echoes(run):
    folder = run("--waveforms", "--format", "vtp", "--no-noise")
    reader = vtkhelios.vtkHeliosWaveformXMLReader()
    waveforms = read(reader, folder / "leg000_fullwave.pvtt")
    curves = vtkhelios.vtkHeliosWaveformPolylines()
    curves.SetInputConnection(reader.GetOutputPort())
    curves.SetScale(0)
    curves.SetHeight(2)
    curves.SetEveryNth(50)
    output = vtkhelios.update(curves)
    assert output.GetNumberOfLines() == -(-len(waveforms["PulseIds"]) // 50)
    points = vtkhelios.arrays(output)
    # along the beam at the range, across it by the share of the largest amplitude
    origin = np.array([0.0, 0.0, waveforms["Origin"][0][2]])
    largest = np.abs(waveforms["Samples"]).max()
    squared = points["Range"] ** 2 + (2 * points["Amplitude"] / largest) ** 2
    distance = np.linalg.norm(points["points"] - origin, axis=1)
    np.testing.assert_allclose(distance, np.sqrt(squared), rtol=0, atol=1e-5)


def test_a_run_cut_off_leaves_waveforms_that_read(run, tmp_path):
    folder = run("--waveforms")
    path = folder / "leg000_fullwave.txt"
    cut = tmp_path / "cut.txt"
    cut.write_bytes(path.read_bytes()[:100_000])
    with pytest.raises(vtkhelios.PipelineError, match=r"cut\.txt:\d+: "):
        read(vtkhelios.vtkHeliosWaveformTextReader(), cut)
