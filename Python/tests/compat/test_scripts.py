# SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
# SPDX-License-Identifier: BSD-3-Clause
"""Calls that the example scripts, notebooks and tests of HELIOS++ 2.2 make, on a survey of this test;
and those scripts themselves, where they are beside the project (Docs/from-helios.md has the table)."""

import math
import os
import pathlib
import re
import shutil
import subprocess
import sys

import numpy as np
import pytest

import vtkhelios
from vtkhelios.compat import pyhelios

ROOT = pathlib.Path(__file__).resolve().parents[3]
HELIOS = ROOT.parent / "shared/data/helios"

SURVEY = """
<?xml version="1.0" encoding="UTF-8"?>
<document>
  <scannerSettings id="slow" active="true" pulseFreq_hz="10000" scanFreq_hz="50" scanAngle_deg="20"
                   trajectoryTimeInterval_s="0.01"/>
  <platformSettings id="low" z="100" movePerSec_m="30"/>
  <survey name="hall" scene="scene.xml#hall" platform="own.xml#plane" scanner="own.xml#two">
  LEGS
  </survey>
</document>"""
LEGS = """
    <leg><platformSettings template="low" x="-20" y="0"/><scannerSettings template="slow"/></leg>
    <leg><platformSettings template="low" x="20" y="0"/><scannerSettings active="false"/></leg>"""
OWN = """<document>
  <scanner id="two" name="Two Eyes" accuracy_m="0.01" rangeMin_m="2" beamDivergence_rad="0.0005"
           pulseFreqs_Hz="10000,20000" pulseLength_ns="4" averagePower_w="4" wavelength_nm="1550"
           scanAngleMax_deg="30" scanFreqMin_Hz="10" scanFreqMax_Hz="80" optics="oscillating"/>
  <platform id="plane" name="Plane" type="linearpath"><scannerMount><rot axis="x" angle_deg="-90"/></scannerMount></platform>
</document>"""
SCENE = """<document><scene id="hall"><part id="1"><filter type="objloader">
  <param type="string" key="filepath" value="hall.obj"/></filter></part></scene></document>"""
OBJ = "mtllib hall.mtl\nv -50 -50 0\nv 50 -50 0\nv 50 50 0\nv -50 50 0\nusemtl floor\nf 1 2 3\nf 1 3 4\n"
MTL = (
    "newmtl floor\nKa 0.1 0.2 0.3\nKd 0.25 0.5 0.75\nhelios_isGround true\nhelios_reflectance 0.3\n"
)


@pytest.fixture
def hall(tmp_path, monkeypatch):
    """The folder of a survey; the working directory."""
    monkeypatch.setattr("vtkhelios.compat.pyhelios._simulation._seed", "")
    files = {"own.xml": OWN, "scene.xml": SCENE, "hall.obj": OBJ, "hall.mtl": MTL}
    files |= {"hall.xml": SURVEY.replace("LEGS", LEGS), "bare.xml": SURVEY.replace("LEGS", "")}
    for name, text in files.items():
        (tmp_path / name).write_text(text)
    monkeypatch.chdir(tmp_path)
    return tmp_path


def make_builder(name="hall.xml"):
    return pyhelios.SimulationBuilder(name, ["."], "output/")


def run(simulation):
    simulation.start()
    return simulation.join()


def test_pulses_are_written(hall):
    builder = make_builder()
    builder.setWritePulse(True)
    builder.setLasScale(0.001)
    folder = pathlib.Path(run(builder.build()).outpath).parent
    assert len((folder / "leg000_pulse.txt").read_text().splitlines()) > 1000
    with pytest.raises(
        pyhelios.PyHeliosToolsException, match="setLasScale.-1.: expected a number ab"
    ):
        builder.setLasScale(-1)


def test_a_survey_without_legs_gets_them_from_the_script(hall):
    builder = make_builder("bare.xml")
    build = builder.build()
    assert build.sim.getNumLegs() == 0 and build.sim.getSurvey().name == "hall"
    for index, x in enumerate((-20.0, 20.0)):
        leg = build.sim.newLeg(index)
        leg.serialId = index
        leg.getPlatformSettings().x, leg.getPlatformSettings().z = x, 100.0
        leg.getPlatformSettings().movePerSec = 30
        leg.getScannerSettings().pulseFreq = 10_000
        leg.getScannerSettings().scanFreq = 50
        leg.getScannerSettings().scanAngle = math.radians(20)
        leg.getScannerSettings().active = index == 0
        leg.getScannerSettings().trajectoryTimeInterval = 0.01
    build.sim.getSurvey().calculateLength()
    assert build.sim.getSurvey().getLength() == 40.0
    made = pyhelios.outputToNumpy(run(build))
    read = pyhelios.outputToNumpy(run(make_builder().build()))
    assert np.array_equal(made[0], read[0]) and len(made[0]) > 10_000
    (hall / "bare.xml").write_text(
        "<document><survey name='x' scene='a.xml#b' platform='p.xml#q' scanner='s.xml#t'/></document>"
    )
    with pytest.raises(vtkhelios.PipelineError, match="bare.xml:1: .*a.xml") as caught:
        make_builder("bare.xml").build()
    assert "/vtkhelios-" not in str(caught.value)


def test_devices_rays_head_and_deflector(hall):
    scanner = make_builder().build().getScanner()
    assert [scanner.getDeviceId(i) for i in range(scanner.getNumDevices())] == ["two"]
    assert scanner.deviceId == "two" and scanner.numRays == 19
    scanner.fwfSettings.beamSampleQuality = 4
    assert scanner.numRays == 37
    deflector = scanner.getBeamDeflector()
    assert deflector.getOpticsType() == "OSCILLATING"
    assert (deflector.scanFreqMin, deflector.scanFreqMax) == (10, 80)
    assert round(math.degrees(deflector.scanAngleMax)) == 30
    assert scanner.getScannerHead().rotatePerSecMax == 0
    assert scanner.toString().startswith("Scanner: two\nDevice[0]: two\n\tAverage Power: 4 W\n")
    with pytest.raises(IndexError, match="there is no device 1; there are 1"):
        scanner.getDeviceId(1)


def test_devices_are_channels(hall):
    text = OWN.replace('optics="oscillating"/>', 'optics="oscillating"><channels><channel id="left"/>'
                       '<channel id="right"/></channels></scanner>')  # fmt: skip
    (hall / "own.xml").write_text(text)
    scanner = make_builder().build().getScanner()
    assert scanner.getNumDevices() == 2
    assert [scanner.getDeviceId(i) for i in range(2)] == ["two_0", "two_1"]


def test_copies_are_independent_and_have_what_was_changed(hall):
    build = make_builder().build()
    build.sim.getScanner().getDetector().accuracy = 0.005
    build.sim.getLeg(0).getScannerSettings().pulseFreq += 10_000
    build.sim.callbackFrequency = 7
    first = build.sim.copy()
    assert first.getLeg(0).getScannerSettings().pulseFreq == 20_000 and first.callbackFrequency == 7
    assert first.getScanner().getDetector().accuracy == 0.005
    first.getLeg(0).getScannerSettings().pulseFreq = 10_000
    assert build.sim.getLeg(0).getScannerSettings().pulseFreq == 20_000
    points = [len(run(each).measurements) for each in (first, build.copy())]
    assert points[1] == pytest.approx(2 * points[0], rel=0.01)
    with pytest.raises(pyhelios.PyHeliosToolsException, match="call loadSurvey.. first"):
        pyhelios.Simulation("hall.xml").copy()


def test_templates(hall):
    simulation = make_builder().build().sim
    settings = simulation.getLeg(0).getScannerSettings()
    assert settings.hasTemplate() and simulation.getLeg(1).getPlatformSettings().has_template()
    template = settings.getTemplate()
    assert (template.id, template.active, template.pulseFreq) == ("slow", True, 10_000)
    assert template.scanAngle * 180 / np.pi == pytest.approx(20) and template.scanFreq == 50
    low = simulation.getLeg(0).getPlatformSettings().getTemplate()
    assert (low.id, low.movePerSec, low.z) == ("low", 30, 100)
    low.z += 20
    assert low.z == 120 and simulation.getLeg(0).getPlatformSettings().z == 100
    assert not simulation.getLeg(1).getScannerSettings().hasTemplate()
    with pytest.raises(pyhelios.PyHeliosToolsException, match="no template; see hasTemplate"):
        simulation.getLeg(1).getScannerSettings().getTemplate()
    simulation.removeLeg(0)
    assert not simulation.getLeg(0).getScannerSettings().hasTemplate()


def test_materials_have_their_file_and_colours(hall):
    material = make_builder().build().sim.getScene().getPrimitive(0).getMaterial()
    assert material.name == "floor" and material.isGround and material.reflectance == 30
    assert pathlib.Path(material.matFilePath).samefile(hall / "hall.mtl")
    assert (material.kd0, material.kd1, material.ka2, material.ks0) == (0.25, 0.5, 0.3, 0)
    with pytest.raises(pyhelios.NotCoveredError, match="Material.kx is not covered"):
        material.kx


@pytest.mark.parametrize("zipped", [False, True])
def test_las_of_version_1_0(hall, zipped):
    laspy = pytest.importorskip("laspy")
    pytest.importorskip("lazrs")
    builder = make_builder()
    builder.setLasOutput(True)
    builder.setLas10(True)
    builder.setZipOutput(zipped)
    output = run(builder.build())
    data = pathlib.Path(output.outpath).read_bytes()
    assert data[:4] == b"LASF" and (data[24], data[25]) == (1, 0)
    path = hall / pathlib.Path(output.outpath).name  # laspy reads 1.1, which has the same records
    path.write_bytes(data[:25] + b"\1" + data[26:])
    las = laspy.read(path)
    assert np.allclose(las.xyz, [each.position for each in output.measurements], atol=1e-3)
    assert las.gps_time[0] == output.measurements[0].gpsTime


# HELIOS++'s own scripts.

NEEDED = {  # libraries and data that scripts need besides pyhelios
    "pysimulation_exhaustive_demo.py": ("scipy", "tqdm", "polyscope"),
    "pysimulation_heavy_multirun_demo.py": ("data/sceneparts/syssifoss/F_BR08_08_merged.vox",),
    "pysimulation_light_multirun_demo.py": ("data/sceneparts/syssifoss/F_BR08_08_merged.vox",),
    "pysimulation_multiscanner_demo.py": (
        "data/surveys/demo/light_als_toyblocks_multiscanner.xml",
    ),
    "pysimulation_quick_demo.py": ("data/surveys/toyblocks/als_toyblocks.xml",),
}


def change_line(text):
    """The one line that a script changes."""
    text = re.sub(
        r"^( *)import pyhelios$", r"\1from vtkhelios.compat import pyhelios", text, flags=re.M
    )
    return re.sub(
        r"^( *)from pyhelios import", r"\1from vtkhelios.compat.pyhelios import", text, flags=re.M
    )


@pytest.mark.parametrize("name", NEEDED)
def test_example_scripts_of_helios(name, tmp_path):
    script = HELIOS / "example_scripts" / name
    if not script.is_file():
        pytest.skip("the example scripts of HELIOS++ are not here")
    for need in NEEDED[name]:
        if "/" in need and not (HELIOS / need).is_file():
            pytest.skip(f"{need} is not here")
        if "/" not in need:
            pytest.importorskip(need)
    shutil.copytree(HELIOS / "data", tmp_path / "data")
    (tmp_path / name).write_text(change_line(script.read_text()))
    environment = {**os.environ, "PYTHONPATH": ":".join(sys.path), "MPLBACKEND": "Agg"}
    done = subprocess.run([sys.executable, name], cwd=tmp_path, env=environment,
                          capture_output=True, text=True)  # fmt: skip
    assert done.returncode == 0, done.stderr


def test_the_quick_script_on_the_toy_blocks_of_helios(tmp_path, monkeypatch):
    """Makes the calls of pysimulation_quick_demo.py in other words."""
    survey = HELIOS / "data/surveys/toyblocks/als_toyblocks.xml"
    if not survey.is_file():
        pytest.skip("the data of HELIOS++ are not here")
    monkeypatch.chdir(tmp_path)
    monkeypatch.setattr("vtkhelios.compat.pyhelios._simulation._seed", "")
    pyhelios.loggingQuiet()
    counted = []
    builder = pyhelios.SimulationBuilder(str(survey), [str(HELIOS)], "output/")
    for setter in ("LegNoiseDisabled", "RebuildScene", "WriteWaveform", "WritePulse", "CalcEchowidth",
                   "PlatformNoiseDisabled", "FinalOutput"):  # fmt: skip
        getattr(builder, f"set{setter}")(True)
    builder.setFullwaveNoise(False)
    builder.setCallbackFrequency(10)
    builder.setCallback(lambda output=None: counted.append(len(output.measurements)))
    build = builder.build()
    build.start()
    build.pause()
    assert build.isPaused()
    build.resume()
    output = build.join()
    assert sum(counted) == len(output.measurements) > 1000 and output.finished
    settings = build.sim.getLeg(0).getScannerSettings()
    assert settings.hasTemplate() and settings.getTemplate().pulseFreq == settings.pulseFreq
