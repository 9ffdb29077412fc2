# SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
# SPDX-License-Identifier: BSD-3-Clause
"""Hits of sub-rays on disk: the shares of a pulse that surfaces and leaves intercept."""

import json

import numpy as np
import pytest

import vtkhelios
from vtkhelios import arrays, cli, update

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
  <scene id="s"><part><filter type="{loader}"><param key="filepath" value="{file}"/>
  <param key="intersectionMode" value="scaled"/></filter></part></scene>
</document>
"""
# A wall 20 m in front of the tripod, of slanted strips as wide as the gaps between them: 5 mm, less than the
# footprint of 7 mm.
PERIOD, DISTANCE = 0.01, 20.0


def write_strips(path):
    corners = []
    for k in range(-1200, 1200):
        x = k * PERIOD
        corners += [(x, -9), (x + PERIOD / 2, -9), (x + PERIOD / 2, 12), (x, 12)]
    vertices = "\n".join(f"v {x + 0.37 * z} {DISTANCE} {z}" for x, z in corners)
    faces = "\n".join(f"f {k + 1} {k + 2} {k + 3} {k + 4}" for k in range(0, len(corners), 4))
    path.write_text(f"{vertices}\n{faces}\n")


@pytest.fixture
def hits(tmp_path):
    """The number of pulses, the share of each that is intercepted, if any, and the columns."""

    def call(*options):
        write_strips(tmp_path / "strips.obj")
        survey = tmp_path / "survey.xml"
        survey.write_text(SURVEY.format(loader="objloader", file="strips.obj"))
        command = ["run", str(survey), "--output", str(tmp_path / "out"), "--hits"]
        assert cli.main([*command, "--quiet", "--no-accuracy-report", *options]) == 0
        name = tmp_path / "out/s/leg000_hits.pvtp"
        columns = arrays(update(vtkhelios.vtkHeliosPointXMLReader(file_name=name)))
        summary = json.loads((tmp_path / "out/s/run_summary.json").read_text())
        ids, index = np.unique(columns["PulseIds"], return_inverse=True)
        return summary["totals"]["pulsesFired"], np.bincount(index, columns["Weight"]), columns

    return call


@pytest.mark.parametrize("options", [(), ("--sub-rays", "127")])
def test_strips_intercept_half_of_the_light(hits, options):
    fired, shares, columns = hits(*options)
    assert fired > 5_000
    assert shares.max() <= 1 + 1e-9 and columns["Weight"].min() > 0
    assert shares.sum() / fired == pytest.approx(0.5, abs=0.01)
    assert columns["Range"].min() > DISTANCE - 0.05
