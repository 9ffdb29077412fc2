# SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
# SPDX-License-Identifier: BSD-3-Clause
"""A small run of two scan positions, for tests of post-processing."""

SURVEY = """\
<document>
  <survey name="fence" scene="scene.xml#fence" platform="platforms.xml#tripod"
    scanner="scanners.xml#vz400_class_tls">
    <leg>
      <platformSettings x="0" y="0" z="2" onGround="false"/>
      <scannerSettings active="true" pulseFreq_hz="100000" scanFreq_hz="100"
        verticalAngleMin_deg="-40" verticalAngleMax_deg="20"
        headRotatePerSec_deg="60" headRotateStart_deg="0" headRotateStop_deg="60"/>
    </leg>
    <leg>
      <platformSettings x="-8" y="3" z="2" onGround="false"/>
      <scannerSettings active="true" pulseFreq_hz="100000" scanFreq_hz="100"
        verticalAngleMin_deg="-40" verticalAngleMax_deg="20"
        headRotatePerSec_deg="60" headRotateStart_deg="0" headRotateStop_deg="60"/>
    </leg>
  </survey>
</document>
"""

SCENE = """\
<document>
  <scene id="fence" crs="EPSG:25832">
    <part>
      <filter type="objloader"><param type="string" key="filepath" value="fence.obj"/></filter>
    </part>
  </scene>
</document>
"""


def write_survey(folder):
    """Writes a survey of the ground and a fence before a wall, and returns its path."""
    lines, faces, count = [], [], 0

    def add(corners):
        nonlocal count
        lines.extend("v {} {} {}".format(*corner) for corner in corners)
        faces.append(f"f {count + 1} {count + 2} {count + 3}")
        faces.append(f"f {count + 1} {count + 3} {count + 4}")
        count += 4

    add([(-60, -60, 0), (60, -60, 0), (60, 60, 0), (-60, 60, 0)])
    add([(-40, 21, 0), (40, 21, 0), (40, 21, 8), (-40, 21, 8)])
    for k in range(-150, 150):  # slats thinner than the beam, so that pulses have two echoes
        x = 0.06 * k
        add([(x, 18, 0), (x + 0.003, 18, 0), (x + 0.003, 18, 3), (x, 18, 3)])
    (folder / "fence.obj").write_text("\n".join(lines + faces) + "\n")
    (folder / "scene.xml").write_text(SCENE)
    (folder / "survey.xml").write_text(SURVEY)
    return folder / "survey.xml"
