# SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
# SPDX-License-Identifier: BSD-3-Clause
"""Weather in surveys, from Python and on the command line."""

import hashlib

import numpy as np
import pytest

import vtkhelios
from vtkhelios import PipelineError

SCANNER = """<document><scanner id="s" optics="rotating" pulseFreqs_Hz="50000" rangeMin_m="2"
  beamDivergence_rad="0.0005" scanAngleMax_deg="45" headRotatePerSecMax_deg="200"
  scanFreqMax_Hz="100" accuracy_m="0" {0}/></document>"""
SCENE = """<document><scene id="wall"><part>
<filter type="objloader"><param type="string" key="filepath" value="wall.obj"/></filter>
</part></scene></document>"""
WALL = "v -50 30 -50\nv 50 30 -50\nv 50 30 50\nv -50 30 50\nf 1 2 3 4\n"
SURVEY = """<document><survey name="fog" scene="scene.xml#wall" platform="platforms.xml#tripod"
  scanner="scanner.xml#s">{0}<leg><platformSettings x="0" y="0" z="0"/>
  <scannerSettings active="true" pulseFreq_hz="50000" scanFreq_hz="50" verticalAngleMin_deg="-20"
  verticalAngleMax_deg="20" headRotatePerSec_deg="100" headRotateStart_deg="-10"
  headRotateStop_deg="10"/></leg></survey></document>"""


@pytest.fixture
def survey(tmp_path):
    def write(scanner="", settings=""):
        (tmp_path / "scanner.xml").write_text(SCANNER.format(scanner))
        (tmp_path / "scene.xml").write_text(SCENE)
        (tmp_path / "wall.obj").write_text(WALL)
        path = tmp_path / "survey.xml"
        path.write_text(SURVEY.format(settings))
        return path

    return write


def count_of_air(cloud):
    return int((cloud["CellIds"] < 0).sum())


def test_weather_of_a_run_of_its_scanner_and_of_its_survey_are_the_same(survey):
    clear = vtkhelios.read_survey(survey()).run()
    assert count_of_air(clear) == 0
    clouds = [
        vtkhelios.read_survey(survey()).run(weather="fog 0.05"),
        vtkhelios.read_survey(survey('weather="fog 0.05"')).run(),
        vtkhelios.read_survey(survey("", '<FWFSettings weather="fog 0.05"/>')).run(),
    ]
    assert count_of_air(clouds[0]) > 1000
    for cloud in clouds[1:]:
        assert np.array_equal(cloud.points, clouds[0].points)
    near = np.linalg.norm(clouds[0].points, axis=1)[clouds[0]["CellIds"] < 0]
    assert near.max() < 4


def test_a_run_without_the_atmosphere_has_no_weather(survey):
    cloud = vtkhelios.read_survey(survey('weather="fog 0.05"')).run(without="atmosphere")
    assert count_of_air(cloud) == 0


def test_wrong_weather(survey, command_line, tmp_path):
    with pytest.raises(PipelineError, match='Weather is "mist 1"; give clear, fog, smoke or dust'):
        vtkhelios.read_survey(survey()).run(weather="mist 1")
    done = command_line("run", survey(), "--weather", "fog", "--output", tmp_path / "out")
    assert done.returncode != 0
    assert 'Weather is "fog"; give fog and the visibility in km, from 0.005 to 1000' in done.stderr
    done = command_line("validate", survey('weather="hail"'))
    assert done.returncode != 0
    assert "hail" in done.stderr + done.stdout
    assert "scanner.xml:" in done.stderr + done.stdout
    assert "give clear, fog, smoke or dust and the visibility in km" in done.stderr + done.stdout


def test_single_drops_are_the_same_for_threads_and_pieces(survey, command_line, tmp_path):
    path = survey('weather="rain 5 drops"')
    hashes = set()
    for number, options in enumerate(
        [("--threads", 1), ("--threads", 2, "--pulses-per-block", 777)]
    ):
        done = command_line("run", path, "--output", tmp_path / str(number), *options)
        assert done.returncode == 0, done.stderr
        data = (tmp_path / str(number) / "fog/leg000_points.xyz").read_bytes()
        hashes.add(hashlib.sha256(data).hexdigest())
    assert len(hashes) == 1
    ranges = np.linalg.norm(
        np.array([line.split()[:3] for line in data.splitlines()], float), axis=1
    )
    assert (ranges < 29).sum() > 500, "no drops"
