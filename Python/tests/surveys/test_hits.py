# SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
# SPDX-License-Identifier: BSD-3-Clause
"""Hits of sub-rays on disk: the shares of a pulse that surfaces and leaves intercept."""

import json

import numpy as np
import pytest

import vtkhelios
from vtkhelios import arrays, cli, update
from vtkhelios.vtkmodules.util.numpy_support import vtk_to_numpy
from vtkhelios.vtkmodules.vtkIOXML import vtkXMLPPolyDataReader

SURVEY = """\
<document>
  <survey name="s" scene="#s" platform="platforms.xml#tripod" scanner="scanners.xml#vz400_class_tls">
    <leg>
      <platformSettings z="0" onGround="false"/>
      <scannerSettings pulseFreq_hz="100000" scanFreq_hz="100" verticalAngleMin_deg="-10"
        verticalAngleMax_deg="10" headRotatePerSec_deg="20" headRotateStart_deg="0"
        headRotateStop_deg="20"/>
    </leg>
  </survey>
  <scene id="s"><part><filter type="{loader}"><param key="filepath" value="{file}"/></filter></part></scene>
</document>
"""
DISTANCE = 20.0  # distance of a wall in front of the tripod [m]
# period of its slanted strips, as wide as the gaps: 5 mm, less than the footprint of 7 mm
PERIOD = 0.01
DENSITY, THICKNESS = 1.5, 1.0  # leaves in a wall [m2/m3], [m]


def write_strips(path):
    corners = []
    for k in range(-1200, 1200):
        x = k * PERIOD
        corners += [(x, -9), (x + PERIOD / 2, -9), (x + PERIOD / 2, 12), (x, 12)]
    vertices = "\n".join(f"v {x + 0.37 * z} {DISTANCE} {z}" for x, z in corners)
    faces = "\n".join(f"f {k + 1} {k + 2} {k + 3} {k + 4}" for k in range(0, len(corners), 4))
    path.write_text(f"{vertices}\n{faces}\n")


def write_leaves(path):
    cells = "\n".join(f"{i} 0 {k} {DENSITY}" for i in range(40) for k in range(22))
    path.write_text(
        f"VOXEL SPACE\n#min_corner: -20 {DISTANCE} -10\n#max_corner: 20 {DISTANCE + THICKNESS} 12\n"
        f"#split: 40 1 22\n#res: 1 #max_pad: {DENSITY}\ni j k PadBVTotal\n{cells}\n"
    )


@pytest.fixture
def run(tmp_path):
    """Runs a survey of a wall; returns the folder of its files, and the hits."""

    def call(loader, name, *options):
        survey = tmp_path / "survey.xml"
        survey.write_text(SURVEY.format(loader=loader, file=name))
        command = ["run", str(survey), "--output", str(tmp_path / "out"), "--hits", "--pulses"]
        assert cli.main([*command, "--quiet", "--no-accuracy-report", *options]) == 0
        folder = tmp_path / "out/s"
        return folder, read(folder / "leg000_hits.pvtp")

    return call


def read(path):
    return arrays(update(vtkhelios.vtkHeliosPointXMLReader(file_name=path)))


def sum_weights(hits):
    """The share of each pulse with a hit that is intercepted."""
    return np.bincount(np.unique(hits["PulseIds"], return_inverse=True)[1], hits["Weight"])


@pytest.mark.parametrize("options", [(), ("--sub-rays", "127")])
def test_strips_intercept_half_of_the_light(run, tmp_path, options):
    write_strips(tmp_path / "strips.obj")
    folder, hits = run("objloader", "strips.obj", *options)
    fired = json.loads((folder / "run_summary.json").read_text())["totals"]["pulsesFired"]
    shares = sum_weights(hits)
    assert fired > 5_000
    assert shares.max() <= 1 + 1e-9 and hits["Weight"].min() > 0
    assert shares.sum() / fired == pytest.approx(0.5, abs=0.01)
    assert hits["Range"].min() > DISTANCE - 0.05


def test_leaves_intercept_by_the_law_of_beer(run, tmp_path):
    """1 - exp(-G PAD s) of a pulse with the path s, with G = 0.5 of spherical leaf angles."""
    write_leaves(tmp_path / "leaves.vox")
    folder, hits = run("detailedvoxels", "leaves.vox", "--format", "vtp")
    directions = read(folder / "leg000_pulse.pvtp")["Direction"]
    path = THICKNESS / np.abs(directions[:, 1])
    expected = 1 - np.exp(-0.5 * DENSITY * path)
    shares = sum_weights(hits)
    assert shares.max() <= 1 + 1e-9
    assert shares.sum() / len(path) == pytest.approx(expected.mean(), rel=0.01)


def test_other_programs_read_the_hits(run, tmp_path):
    """By VTK's own reader of parallel files."""
    write_strips(tmp_path / "strips.obj")
    folder, hits = run("objloader", "strips.obj")
    reader = vtkXMLPPolyDataReader()
    reader.SetFileName(str(folder / "leg000_hits.pvtp"))
    reader.Update()
    data = reader.GetOutput().GetPointData()
    for name in ("PulseIds", "Weight", "Range", "CellIds", "IncidenceAngle"):
        assert np.array_equal(vtk_to_numpy(data.GetArray(name)), hits[name]), name
