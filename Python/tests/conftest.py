# SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
# SPDX-License-Identifier: BSD-3-Clause
"""Shared by the tests of the package."""

import os
import pathlib
import runpy
import signal
import subprocess
import sys

import pytest

import vtkhelios

# A shell ignores Ctrl-C in what it runs in the background, and so do all programs started there.
signal.signal(signal.SIGINT, signal.default_int_handler)

PACKAGE_DIR = pathlib.Path(vtkhelios.__file__).absolute().parents[1]

SURVEY = """\
<document>
  <survey name="plane" scene="scene.xml#plane" platform="platforms.xml#tripod"
    scanner="scanners.xml#vz400_class_tls">
    <leg>
      <platformSettings x="0" y="0" z="2" onGround="false"/>
      <scannerSettings active="true" pulseFreq_hz="100000" scanFreq_hz="100"
        verticalAngleMin_deg="-40" verticalAngleMax_deg="60"
        headRotatePerSec_deg="{speed}" headRotateStart_deg="0" headRotateStop_deg="{stop}"/>
    </leg>
  </survey>
</document>
"""

SCENE = """\
<document>
  <scene id="plane">
    <part>
      <filter type="objloader"><param type="string" key="filepath" value="plane.obj"/></filter>
    </part>
  </scene>
</document>
"""

PLANE = "v -200 -200 {z}\nv 200 -200 {z}\nv 200 200 {z}\nv -200 200 {z}\nf 1 2 3\nf 1 3 4\n"


@pytest.fixture
def command_line():
    """Runs the command line and returns its result (returncode, stdout, stderr)."""

    def call(*arguments, **options):
        environment = {**os.environ, "PYTHONPATH": str(PACKAGE_DIR)}
        return subprocess.run(
            [sys.executable, "-P", "-m", "vtkhelios", *map(str, arguments)],
            capture_output=True,
            text=True,
            env=environment,
            timeout=300,
            **options,
        )

    return call


@pytest.fixture
def make_survey(tmp_path):
    """Writes a survey of a tripod 2 m above a plane and returns its path."""

    def make(speed=60, stop=30, z=0.0):
        (tmp_path / "survey.xml").write_text(SURVEY.format(speed=speed, stop=stop))
        (tmp_path / "scene.xml").write_text(SCENE)
        (tmp_path / "plane.obj").write_text(PLANE.format(z=z))
        return tmp_path / "survey.xml"

    return make


@pytest.fixture
def read_pixels():
    """Reads a PNG: height x width x 3 integers, from the bottom row up."""

    def read(path):
        from vtkmodules.util.numpy_support import vtk_to_numpy
        from vtkmodules.vtkIOImage import vtkPNGReader

        reader = vtkPNGReader()
        reader.SetFileName(str(path))
        reader.Update()
        width, height, _ = reader.GetOutput().GetDimensions()
        pixels = vtk_to_numpy(reader.GetOutput().GetPointData().GetScalars())
        return pixels.reshape(height, width, -1)[:, :, :3].astype(int)  # drop opacity

    return read


@pytest.fixture(scope="session")
def small_runs(tmp_path_factory):
    """Two scan positions before a fence, run in every format with waveforms and pulses."""
    from vtkhelios import cli

    folder = tmp_path_factory.mktemp("runs")
    small_run = runpy.run_path(pathlib.Path(__file__).with_name("_small_run.py"))
    survey = small_run["write_survey"](folder)
    runs = {}
    for kind in ("las", "xyz", "vtp"):
        output = folder / kind
        arguments = ["run", survey, "--format", kind, "--output", output, "--waveforms"]
        arguments += ["--waveforms-in-points"] if kind == "las" else []
        assert cli.main([*map(str, arguments), "--pulses", "--quiet"]) == 0
        runs[kind] = output / "fence"
    return runs


@pytest.fixture
def window():
    """VTK's original output window: PyVista replaces it when imported."""
    from vtkmodules.vtkCommonCore import vtkOutputWindow

    before, own = vtkOutputWindow.GetInstance(), vtkOutputWindow()
    vtkOutputWindow.SetInstance(own)
    yield own
    vtkOutputWindow.SetInstance(before)
