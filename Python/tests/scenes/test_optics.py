# SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
# SPDX-License-Identifier: BSD-3-Clause
"""Mirrors, glass and water in scenes of arrays and in surveys."""

import hashlib

import numpy as np
import pytest

import vtkhelios

QUAD = [[0, 1, 2], [0, 2, 3]]
SCAN = {
    "position": (0, 0, 1.5), "scan_frequency": 20, "vertical": (-40, 40), "head": (0, 360), "head_speed": 60,
    "noise": False, "truth": True,
}  # fmt: skip

MATERIALS = """\
newmtl window
helios_optics pane
newmtl mirror
helios_optics mirror
helios_mirrorReflectance 0.9
"""
MESH = """\
mtllib room.mtl
usemtl window
v -4 10 0
v 0 10 0
v 0 10 3
v -4 10 3
f 1 2 3 4
usemtl mirror
v 1 10 0
v 3 12 0
v 3 12 3
v 1 10 3
f 5 6 7 8
usemtl default
v -20 20 -1
v 20 20 -1
v 20 20 8
v -20 20 8
f 9 10 11 12
v 15 -20 -1
v 15 20 -1
v 15 20 8
v 15 -20 8
f 13 14 15 16
"""
SCENE = """\
<document><scene id="room"><part>
<filter type="objloader"><param type="string" key="filepath" value="room.obj"/></filter>
<filter type="translate"><param type="vec3" key="offset" value="500000;5000000;0"/></filter>
</part></scene></document>
"""
SURVEY = """\
<document><survey name="room" scene="scene.xml#room" platform="platforms.xml#tripod"
  scanner="scanners.xml#vz400_class_tls"><leg><platformSettings x="500000" y="5000000" z="0.5"/>
  <scannerSettings active="true" pulseFreq_hz="100000" scanFreq_hz="100" verticalAngleMin_deg="-30"
  verticalAngleMax_deg="30" headRotatePerSec_deg="60" headRotateStart_deg="-30"
  headRotateStop_deg="30"/></leg></survey></document>
"""


def make_room(optics):
    """A wall of optics at y = 5, others at y = 9 and behind the scanner at y = -7."""
    front = vtkhelios.Scene([[-6, 5, 0], [6, 5, 0], [6, 5, 4], [-6, 5, 4]], QUAD, optics=optics)
    walls = [
        vtkhelios.Scene([[-40, y, -9], [40, y, -9], [40, y, 9], [-40, y, 9]], QUAD) for y in (9, -7)
    ]
    return front + walls[0] + walls[1]


@pytest.fixture
def room(tmp_path):
    for name, text in {
        "room.mtl": MATERIALS, "room.obj": MESH, "scene.xml": SCENE, "survey.xml": SURVEY
    }.items():  # fmt: skip
        (tmp_path / name).write_text(text)
    return tmp_path


def test_a_mirror_has_ghosts_at_the_mirrored_places():
    cloud = vtkhelios.scan(make_room("mirror"), **SCAN)
    ghosts = cloud["SpecularEvents"] == 1
    assert ghosts.sum() > 100
    true = cloud["TruePoint"][ghosts]
    is_wall = np.abs(true[:, 1] + 7) < 1e-6
    assert is_wall.sum() > 100
    mirrored = true * [1, -1, 1] + [0, 10, 0]
    assert np.abs(cloud.points[ghosts] - mirrored)[is_wall].max() < 0.01  # within the footprint
    assert (cloud["SpecularEvents"][cloud.points[:, 1] > 5.1] > 0).any()


def test_a_pane_lets_the_wall_behind_through():
    cloud = vtkhelios.scan(make_room({"kind": "pane", "thickness": 0.01}), **SCAN)
    behind = (cloud["SpecularEvents"] == 1) & (np.abs(cloud["TruePoint"][:, 1] - 9) < 1e-6)
    shift = np.linalg.norm(cloud.points - cloud["TruePoint"], axis=1)[behind]
    assert behind.sum() > 100
    assert shift.min() > 0.004 and shift.max() < 0.02


def test_a_pane_of_a_medium_is_as_slow_as_its_group_index():
    phase, group = 1.50065, 1.52007  # refractive index of BK7 at 1550 nm
    glass = {"kind": "pane", "thickness": 0.1}
    clouds = [
        vtkhelios.scan(make_room({**glass, **index}), **SCAN)
        for index in ({"dispersion": "bk7"}, {"refractive_index": phase})
    ]
    ranges = [
        dict(zip(cloud["PulseIds"][behind], cloud["Range"][behind]))
        for cloud in clouds
        for behind in [
            (np.abs(cloud["TruePoint"][:, 1] - 9) < 1e-6) & (cloud["SpecularEvents"] == 1)
        ]
    ]
    slower = [value - ranges[1][pulse] for pulse, value in ranges[0].items() if pulse in ranges[1]]
    assert len(slower) > 100
    # Within the pane the path is thickness / cos(b), b up to 25 degrees; edges of the pane fill some beams in part.
    least = (group - phase) * 0.1
    assert least < np.median(slower) < 1.1 * least


def test_scenes_without_optics_have_no_events():
    cloud = vtkhelios.scan(make_room(None), **SCAN)
    assert "SpecularEvents" not in cloud.names


@pytest.mark.parametrize(
    "optics, message",
    [
        ("glass", "optics is 'glass'; give one of: mirror, pane, volume"),
        ({"thickness": 1}, "optics is None; give one of: mirror, pane, volume"),
        ({"kind": "pane", "width": 1}, "optics has 'width'; known: kind, mirror_reflectance, "),
        (
            {"kind": "pane", "dispersion": "flint"},
            "dispersion is 'flint'; give one of: water, sodaLime",
        ),
        ({"kind": "pane", "refractive_index": 0.3}, r"refractive_index is 0.3; .* \[1, 4\]"),
    ],
)
def test_wrong_optics(optics, message):
    with pytest.raises(ValueError, match=message):
        vtkhelios.Scene([[0, 0, 0], [1, 0, 0], [0, 1, 0]], [[0, 1, 2]], optics=optics)


def test_a_survey_is_the_same_for_threads_instances_and_places(command_line, room):
    hashes = set()
    for number, options in enumerate([[], ["--threads", 1], ["--no-instances"]]):
        done = command_line("run", room / "survey.xml", "--output", room / str(number), *options)
        assert done.returncode == 0, done.stderr
        data = (room / str(number) / "room/leg000_points.xyz").read_bytes()
        hashes.add(hashlib.sha256(data).hexdigest())
    assert len(hashes) == 1
    points = np.array([line.split()[:3] for line in data.splitlines()], float)
    assert (points[:, 1] > 5000021).any(), "no ghost behind the wall"
