# SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
# SPDX-License-Identifier: BSD-3-Clause
"""Light scattered more than once in surveys, from Python and on the command line."""

import numpy as np
import pytest

import vtkhelios

SCANNER = """<document><scanner id="s" optics="rotating" pulseFreqs_Hz="50000" rangeMin_m="1"
  beamDivergence_rad="0.001" scanAngleMax_deg="45" headRotatePerSecMax_deg="200" fieldOfView_rad="0.1"
  scanFreqMax_Hz="100" accuracy_m="0"/></document>"""
SCENE = """<document><scene id="room"><part>
<filter type="objloader"><param type="string" key="filepath" value="room.obj"/></filter>
</part></scene></document>"""
# a wall, and the floor at its foot
ROOM = """mtllib room.mtl
usemtl white
v -50 10 0.4
v 50 10 0.4
v 50 10 50
v -50 10 50
v -50 -50 0.4
v 50 -50 0.4
f 1 2 3 4
f 5 6 2 1
"""
SURVEY = """<document>
<survey name="room" scene="scene.xml#room" platform="platforms.xml#tripod" scanner="scanner.xml#s" {0}>
  <leg><platformSettings x="0" y="0" z="0"/>
  <scannerSettings active="true" pulseFreq_hz="50000" scanFreq_hz="50" verticalAngleMin_deg="-8"
  verticalAngleMax_deg="-4" headRotatePerSec_deg="100" headRotateStart_deg="0"
  headRotateStop_deg="10"/></leg></survey></document>"""


@pytest.fixture
def survey(tmp_path):
    def write(attributes=""):
        (tmp_path / "scanner.xml").write_text(SCANNER)
        (tmp_path / "scene.xml").write_text(SCENE)
        (tmp_path / "room.obj").write_text(ROOM)
        (tmp_path / "room.mtl").write_text("newmtl white\nKd 0.8 0.8 0.8\nhelios_reflectance 0.8\n")
        path = tmp_path / "survey.xml"
        path.write_text(SURVEY.format(attributes))
        return path

    return write


def test_orders_of_a_run_and_of_its_survey_are_the_same(survey):
    once = vtkhelios.read_survey(survey()).run()
    assert "ScatteredAmplitude" not in once.names
    option = vtkhelios.read_survey(survey()).run(scattering_orders=3, scattering_paths=64)
    attribute = vtkhelios.read_survey(
        survey('scatteringOrders="3" scatteringPaths="64" scatteringPhase="leaf"')
    ).run()
    assert np.array_equal(option["Amplitude"], attribute["Amplitude"])
    assert np.array_equal(option["ScatteredDeviation"], attribute["ScatteredDeviation"])
    without = vtkhelios.read_survey(survey('scatteringOrders="3"')).run(without="scattering")
    assert np.allclose(without["Amplitude"], once["Amplitude"])


def test_a_corner_is_brighter_and_tells_by_how_much(survey):
    survey = vtkhelios.read_survey(survey())
    once, more = survey.run(), survey.run(scattering_orders=3)
    first = more["ReturnNumber"] == 1  # others come over the wall, later
    assert np.array_equal(once["PulseIds"], more["PulseIds"][first])
    added = more["Amplitude"][first] - once["Amplitude"]
    scattered = more["ScatteredAmplitude"][first]
    error = np.sqrt((more["ScatteredDeviation"][first] ** 2).sum())
    assert added.sum() > 0.05 * once["Amplitude"].sum() > 20 * error
    assert added.sum() == pytest.approx(scattered.sum(), rel=0.05)
    # nearer to the edge there is more of it
    near = np.abs(once.points[:, 1] - 10) + np.abs(once.points[:, 2] - 0.4) < 0.2
    share = scattered / more["Amplitude"][first]
    assert share[near].mean() > 1.5 * share[~near].mean()
    # a later echo is light of a floor over the wall
    assert (more["ScatteredAmplitude"][~first] > 0.9 * more["Amplitude"][~first]).all()
    assert (np.linalg.norm(more.points[~first], axis=1) > 9).all()


def test_the_command_line_has_orders_and_says_what_is_wrong(survey, command_line, tmp_path):
    path = survey()
    arguments = ("run", path, "--format", "vtp", "--quiet", "--output", tmp_path / "out")
    done = command_line(*arguments, "--scattering-orders", "2", "--scattering-paths", "16")
    assert done.returncode == 0, done.stderr
    points = next((tmp_path / "out").rglob("*_points*.vtp")).read_bytes()
    assert b"ScatteredAmplitude" in points and b"ScatteredDeviation" in points
    wrong = command_line(*arguments, "--overwrite", "--scattering-orders", "65")
    assert wrong.returncode != 0
    assert "--scattering-orders" in wrong.stderr and "64" in wrong.stderr
    survey('scatteringOrders="0"')
    wrong = command_line(*arguments, "--overwrite")
    assert wrong.returncode != 0
    assert 'survey.xml:2: scatteringOrders="0"' in wrong.stderr and "64" in wrong.stderr


def test_a_tradeoff_tells_whether_light_scattered_more_than_once_matters(survey):
    def find(attributes):
        result = vtkhelios.read_survey(survey(attributes)).tradeoff(pulses=200, seconds=60)
        return {row.name: row for row in result.parts}

    rows = find("")
    assert rows["with scattering"].options == {"scattering_orders": 3}
    assert "without scattering" not in rows
    assert rows["with scattering"].errors["amplitudeRms"].value > 0.01
    rows = find('scatteringOrders="3"')
    assert "with scattering" not in rows
    assert rows["without scattering"].errors["amplitudeRms"].value > 0.01
    assert rows["without scattering"].seconds < 0.5 * rows["the whole model"].seconds
