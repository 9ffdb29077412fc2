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
v -50 10 -1
v 50 10 -1
v 50 10 50
v -50 10 50
v -50 -50 -1
v 50 -50 -1
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
    assert len(once) == len(more)  # no echo of the sampling
    added = more["Amplitude"].sum() - once["Amplitude"].sum()
    error = np.sqrt((more["ScatteredDeviation"] ** 2).sum())
    assert added > 0.01 * once["Amplitude"].sum() > 20 * error
    assert added == pytest.approx(more["ScatteredAmplitude"].sum(), abs=0.02 * added)
    # nearer to the edge there is more of it
    near = np.abs(once.points[:, 1] - 10) + np.abs(once.points[:, 2] + 1) < 0.1
    share = more["ScatteredAmplitude"] / more["Amplitude"]
    assert share[near].mean() > 2 * share[~near].mean()


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
