# SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
# SPDX-License-Identifier: BSD-3-Clause
"""Invalid input to `vtkhelios run`: a clear message, an exit code, and no data loss."""

import os
import pathlib
import subprocess
import sys

import pytest

import vtkhelios

PACKAGE_DIR = pathlib.Path(vtkhelios.__file__).absolute().parents[1]

SURVEY = """\
<?xml version="1.0"?>
<document>
<survey name="bad" platform="platforms.xml#tripod" scanner="scanners.xml#vz400_class_tls" scene="scene.xml#s">
<leg><platformSettings x="0" y="0" z="2"/>
<scannerSettings active="true" pulseFreq_hz="100000" scanFreq_hz="100" headRotatePerSec_deg="30" headRotateStart_deg="0" headRotateStop_deg="3"/></leg>
</survey></document>
"""
SCENE = """\
<document><scene id="s"><part><filter type="objloader">
<param type="string" key="filepath" value="plane.obj"/></filter></part></scene></document>
"""
PLANE = "v -50 -50 0\nv 50 -50 0\nv 50 50 0\nv -50 50 0\nf 1 2 3 4\n"


@pytest.fixture
def run(tmp_path):
    """Runs the survey with texts replaced in it; returns exit code and messages."""

    def call(*changes, scene=SCENE, plane=PLANE, output="out", options=()):
        survey = SURVEY
        for old, new in changes:
            assert old in survey
            survey = survey.replace(old, new, 1)
        (tmp_path / "survey.xml").write_text(survey)
        if scene is not None:
            (tmp_path / "scene.xml").write_text(scene)
        if plane is not None:
            (tmp_path / "plane.obj").write_text(plane)
        result = subprocess.run(
            [
                sys.executable,
                "-P",
                "-m",
                "vtkhelios",
                "run",
                "survey.xml",
                "--output",
                output,
                *options,
            ],
            capture_output=True,
            text=True,
            cwd=tmp_path,
            env={**os.environ, "PYTHONPATH": str(PACKAGE_DIR)},
            timeout=120,
        )
        assert "Traceback" not in result.stderr
        return result.returncode, result.stderr

    return call


REFUSED = {
    "malformed": ([("</leg>", "</lag>")], ["survey.xml:", "not XML"]),
    "two roots": ([("</document>", "</document><document/>")], ["survey.xml:"]),
    "a duplicate attribute": ([('z="2"', 'z="2" z="3"')], ["survey.xml:4", "z"]),
    "unknown platform": (
        [("#tripod", "#tripot")],
        ["survey.xml:3", "tripot", "did you mean tripod"],
    ),
    "unknown scanner": ([("#vz400", "#vz4000")], ["survey.xml:3", "mobile_mls"]),
    "unknown scene": ([("scene.xml#s", "scene.xml#t")], ["survey.xml:3", "ids are s"]),
    "a missing file": ([("platforms.xml", "nowhere.xml")], ["survey.xml:3", "nowhere.xml"]),
    "a frequency that is no number": (
        [('pulseFreq_hz="100000"', 'pulseFreq_hz="abc"')],
        ["survey.xml:5", 'pulseFreq_hz="abc"', "not a number"],
    ),
    "a decimal comma": ([('x="0"', 'x="1,5"')], ["survey.xml:4", 'x="1,5"']),
    "not a number": ([('x="0"', 'x="nan"')], ["survey.xml:4", 'x="nan"']),
    "frequency 0": (
        [('pulseFreq_hz="100000"', 'pulseFreq_hz="0"')],
        ["survey.xml:5", 'pulseFreq_hz="0"', "from 0.001"],
    ),
    "a negative frequency": (
        [('pulseFreq_hz="100000"', 'pulseFreq_hz="-5"')],
        ["survey.xml:5", 'pulseFreq_hz="-5"'],
    ),
    "a negative divergence": (
        [('active="true"', 'active="true" beamDivergence_rad="-1"')],
        ["survey.xml:5", 'beamDivergence_rad="-1"'],
    ),
    "a scan that never ends": (
        [('headRotatePerSec_deg="30"', 'headRotatePerSec_deg="0"')],
        ["survey.xml:5", "never ends"],
    ),
    "a head that turns away": (
        [('headRotatePerSec_deg="30"', 'headRotatePerSec_deg="-30"')],
        ["survey.xml:5", "headRotatePerSec_deg"],
    ),
    "bins wider than the pulse": (
        [("<leg>", '<FWFSettings binSize_ns="50"/><leg>')],
        ["survey.xml:4", 'binSize_ns="50" is wider than half of pulseLength_ns'],
    ),
    "waveforms shorter than the pulse": (
        [("<leg>", '<FWFSettings maxFullwaveRange_ns="0.5"/><leg>')],
        ["survey.xml:4", "waveforms of 0.5 ns (maxFullwaveRange_ns) are shorter"],
    ),
    "a misspelt detector": (
        [("<leg>", '<FWFSettings echoDetector="gausian"/><leg>')],
        ["survey.xml:4", 'echoDetector="gausian"', "did you mean gaussian?"],
    ),
    "a tolerance of nothing": (
        [('name="bad"', 'name="bad" rangeTolerance_m="0"')],
        ["survey.xml:3", 'rangeTolerance_m="0" is out of range'],
    ),
    "half an expression": (
        [("<leg>", '<detectorSettings distanceMeasurementError="1 +"/><leg>')],
        ["survey.xml:4", 'distanceMeasurementError="1 +"'],
    ),
    "nothing in sight": ([('z="2"', 'z="-2000"')], ["No points", "none of", "hit the scene"]),
}


@pytest.mark.parametrize("case", REFUSED)
def test_survey_is_refused(case, run):
    changes, messages = REFUSED[case]
    code, text = run(*changes)
    assert code == 1
    for message in messages:
        assert message in text


BAD_PLANES = {
    "vertex index": (PLANE + "f 1 2 9\n", ["plane.obj:6", "vertex 9"]),
    "no number": (PLANE + "v 1 2 abc\n", ["plane.obj:6", "abc"]),
    "NaN": (PLANE + "v 1 nan 0\n", ["plane.obj:6", "NaN"]),
    "infinity": (PLANE + "v 1 2 inf\n", ["plane.obj:6", "inf"]),
    "no triangles": ("v 0 0 0\n", ["empty"]),
    "an empty file": ("", ["empty"]),
}


@pytest.mark.parametrize("case", BAD_PLANES)
def test_scene_is_refused(case, run):
    plane, messages = BAD_PLANES[case]
    code, text = run(plane=plane)
    assert code == 1
    for message in messages:
        assert message.lower() in text.lower()


def test_a_missing_obj_is_refused(run):
    code, text = run(plane=None)
    assert code == 1
    assert "scene.xml:2" in text and "plane.obj" in text


def test_a_missing_scene_file_is_refused(run):
    code, text = run(scene=None)
    assert code == 1
    assert "survey.xml:3" in text and "scene.xml" in text


WARNED = {
    "a misspelt attribute": (
        {"changes": [("pulseFreq_hz", "pulseFrq_hz")]},
        ["survey.xml:5", "pulseFrq_hz", "pulseFreq_hz"],
    ),
    "a missing MTL": ({"plane": "mtllib none.mtl\n" + PLANE}, ["plane.obj:1", "none.mtl"]),
    "a triangle without area": ({"plane": PLANE + "f 1 2 2\n"}, ["1", "area"]),
    "a stray vertex": ({"plane": PLANE + "v 1e30 0 0\nf 1 2 5\n"}, ["1e+30"]),
    "an unknown frequency": ({"changes": [('"100000"', '"99999"')]}, ["survey.xml:5", "99999"]),
}


@pytest.mark.parametrize("case", WARNED)
def test_survey_runs_with_a_warning(case, run):
    arguments, messages = WARNED[case]
    code, text = run(*arguments.pop("changes", []), **arguments)
    assert code == 0, text
    assert "warning" in text
    for message in messages:
        assert message in text


def test_divergence_zero_is_one_ray(run):
    code, text = run(('active="true"', 'active="true" beamDivergence_rad="0"'))
    assert code == 0, text


def test_xml_declaration_is_optional(run):
    code, text = run(('<?xml version="1.0"?>\n', ""))
    assert code == 0, text


def test_a_full_disk_keeps_complete_lines(run, tmp_path):
    disk = tmp_path / "disk"
    disk.mkdir()
    if subprocess.run(
        ["mount", "-t", "tmpfs", "-o", "size=64k", "tmpfs", disk], check=False
    ).returncode:
        pytest.skip("no small disk can be mounted here")
    try:
        code, text = run(('Stop_deg="3"', 'Stop_deg="60"'), output=str(disk))
        assert code == 1
        assert "No space left on device" in text and "records are safe" in text
        kept = (disk / "bad" / "leg000_points.xyz.part").read_bytes()
        assert kept == b"" or kept.endswith(b"\n")
    finally:
        subprocess.run(["umount", disk], check=True)
