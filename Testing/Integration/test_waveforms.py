# SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
# SPDX-License-Identifier: BSD-3-Clause
"""Waveforms of a run: written as text and as VTK tables, read back, and the positions of their echoes."""

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
    """A floor, and walls behind each other with gaps between them."""
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
    # 9 decimals of a nanowatt, and float rounding
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
    sigma = 3.0 / 2.3548  # width of a pulse, at most
    for i in np.concatenate([several[:200], np.arange(0, len(echoes["Range"]), 97)]):
        row = rows[echoes["WaveformIds"][i]]
        samples, bin_size = samples_of(waveforms, row), waveforms["BinSize"][row]
        time = 2 * echoes["Range"][i] / SPEED_OF_LIGHT - waveforms["StartTime"][row]
        at = int(round(time / bin_size))
        near = samples[max(0, at - 2) : at + 3]
        assert samples[at] > 0.98 * near.max()  # a maximum within a bin or two
        assert echoes["Amplitude"][i] == pytest.approx(near.max(), rel=0.1 * bin_size / sigma)


def test_curves_are_displaced_by_the_amplitude(run):
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
    # along the beam at the range, across it scaled by the largest amplitude
    origin = np.array([0.0, 0.0, waveforms["Origin"][0][2]])
    largest = np.abs(waveforms["Samples"]).max()
    squared = points["Range"] ** 2 + (2 * points["Amplitude"] / largest) ** 2
    distance = np.linalg.norm(points["points"] - origin, axis=1)
    np.testing.assert_allclose(distance, np.sqrt(squared), rtol=0, atol=1e-5)


def test_interrupted_run_leaves_readable_waveforms(run, tmp_path):
    folder = run("--waveforms")
    path = folder / "leg000_fullwave.txt"
    cut = tmp_path / "cut.txt"
    cut.write_bytes(path.read_bytes()[:100_000])
    with pytest.raises(vtkhelios.PipelineError, match=r"cut\.txt:\d+: "):
        read(vtkhelios.vtkHeliosWaveformTextReader(), cut)


# Echoes of stored waveforms.


def detect(tmp_path, *arguments):
    return subprocess.run(
        [sys.executable, "-P", "-m", "vtkhelios", "detect", *map(str, arguments)],
        capture_output=True,
        text=True,
        cwd=tmp_path,
        env={**os.environ, "PYTHONPATH": str(PACKAGE_DIR)},
        timeout=300,
    )


def test_detect_reproduces_the_echoes_of_a_fixed_run(run, tmp_path):
    folder = run("--waveforms", "--format", "vtp", "--no-noise", "--sub-rays", "19")
    done = detect(
        tmp_path,
        folder / "leg000_fullwave.pvtt",
        "-o",
        tmp_path / "again.pvtp",
        "--threshold",
        "0.05",
    )
    assert done.returncode == 0, done.stderr
    was = read(vtkXMLPPolyDataReader(), folder / "leg000_points.pvtp")
    again = read(vtkXMLPPolyDataReader(), tmp_path / "again.pvtp")
    for name in (
        "PulseIds",
        "ReturnNumber",
        "NumberOfReturns",
        "Range",
        "Amplitude",
        "EchoWidth",
        "points",
    ):
        np.testing.assert_array_equal(again[name], was[name])
    assert f"points   {len(was['Range']):,} by peak" in done.stdout


def test_detect_in_text_by_a_decomposition(run, tmp_path):
    folder = run("--waveforms", "--no-noise")
    done = detect(
        tmp_path,
        folder / "leg000_fullwave.txt",
        "--detector",
        "gaussian",
        "--pulse-length",
        "4",
        "-o",
        "gaussian.xyz",
    )
    assert done.returncode == 0, done.stderr
    rows = np.loadtxt(tmp_path / "gaussian.xyz")
    was = np.loadtxt(folder / "leg000_points.xyz", usecols=(0, 1, 2, 3, 4, 5, 6, 7, 9, 10))
    assert rows.shape[1] == 11 and (rows[:, 8] == -1).all() and (rows[:, 9] == 0).all()
    single = np.isin(rows[:, 7], was[was[:, 6] == 1, 7]) & (rows[:, 6] == 1)
    assert single.sum() > 1000
    order = np.searchsorted(was[:, 7], rows[single, 7])
    distance = np.linalg.norm(rows[single, :3] - was[order, :3], axis=1)
    assert np.median(distance) < 1e-3 and np.quantile(distance, 0.9) < 0.05


def test_detect_keeps_the_selected_returns(run, tmp_path):
    folder = run("--waveforms", "--format", "vtp")
    name = folder / "leg000_fullwave.pvtt"

    def pulses(*options):
        done = detect(tmp_path, name, "-o", "some.pvtp", *options)
        assert done.returncode == 0, done.stderr
        return read(vtkXMLPPolyDataReader(), tmp_path / "some.pvtp")["PulseIds"]

    last = pulses("--returns", "last")
    assert len(last) == len(set(last)) < len(pulses())
    np.testing.assert_array_equal(pulses("--max-returns", "1"), last)


WRONG_DETECTIONS = {
    "no file": (["nowhere.pvtt", "-o", "a.xyz"], 1, "nowhere.pvtt: there is no such file"),
    "no text": (["nowhere.txt", "-o", "a.xyz"], 1, "nowhere.txt: cannot be read"),
    "no form": (
        ["a.pvtt", "-o", "a.las"],
        2,
        "'a.las' is not valid: expected a name that ends in .xyz (text) or .pvtp",
    ),
    "no output": (["a.pvtt"], 2, "required: -o/--output"),
    "no detector": (["a.pvtt", "-o", "a.xyz", "--detector", "pek"], 2, "did you mean peak?"),
}


@pytest.mark.parametrize("case", WRONG_DETECTIONS)
def test_detect_errors(case, tmp_path):
    arguments, code, message = WRONG_DETECTIONS[case]
    done = detect(tmp_path, *arguments)
    assert done.returncode == code
    assert message in done.stderr and "Traceback" not in done.stderr
    assert not (tmp_path / "a.xyz").exists()


def test_detect_without_an_echo_is_reported(run, tmp_path):
    folder = run("--waveforms", "--format", "vtp")
    done = detect(tmp_path, folder / "leg000_fullwave.pvtt", "-o", "a.xyz", "--threshold", "1e9")
    assert done.returncode == 1
    assert "no echo reaches 1e+09 nW; give a lower --threshold" in done.stderr
