# SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
# SPDX-License-Identifier: BSD-3-Clause
"""A survey moved to UTM coordinates gives the same cloud, moved: to 1e-8 m.

At grazing incidence the rounding of the coordinates, 1e-9 m, shows up to a hundred times as large.
"""

import numpy as np
import pytest
from vtkmodules.vtkIOXML import vtkXMLPPolyDataReader

import vtkhelios

SHIFT = np.array([500_000.0, 5_500_000.0, 300.0])

SURVEY = """\
<document><survey name="hills" platform="platforms.xml#tripod" scanner="scanners.xml#vz400_class_tls"
  scene="scene.xml#s">
<leg><platformSettings x="{0}" y="{1}" z="{2}"/>
<scannerSettings active="true" pulseFreq_hz="100000" scanFreq_hz="100" headRotatePerSec_deg="180"
  headRotateStart_deg="0" headRotateStop_deg="360"/></leg>
</survey></document>
"""

SCENE = """\
<document><scene id="s"><part>
<filter type="objloader"><param type="string" key="filepath" value="hills.obj"/></filter>
<filter type="translate"><param type="vec3" key="offset" value="{0};{1};{2}"/></filter>
</part></scene></document>
"""


def make_hills(path, side=120):
    """A rough surface whose coordinates are multiples of 2^-10 m: shifts do not round."""
    x, y = np.meshgrid(np.arange(side) - side / 2, np.arange(side) - side / 2)
    z = np.random.default_rng(0).normal(0.0, 0.7, x.shape)
    points = np.round(1024 * np.stack([x, y, z], axis=-1).reshape(-1, 3)) / 1024
    first = (np.arange(side - 1)[:, None] * side + np.arange(side - 1)).ravel() + 1
    faces = np.stack([first, first + 1, first + side + 1, first + side], axis=-1)
    with open(path, "w") as file:
        file.writelines(f"v {p[0]!r} {p[1]!r} {p[2]!r}\n" for p in points.tolist())
        file.writelines("f {} {} {} {}\n".format(*face) for face in faces.tolist())


def run(folder, shift):
    folder.mkdir()
    make_hills(folder / "hills.obj")
    (folder / "scene.xml").write_text(SCENE.format(*shift))
    (folder / "survey.xml").write_text(SURVEY.format(*(np.array([0.0, 0.0, 4.0]) + shift)))
    reader = vtkhelios.vtkHeliosSurveyReader()
    reader.SetFileName(str(folder / "survey.xml"))
    reader.AddAssetDirectory(str(vtkhelios.data_directory() / "Assets"))
    assert reader.Read()
    player = vtkhelios.vtkHeliosSurveyPlayer()
    player.SetSurvey(reader.GetSurvey())
    player.SetOutputDirectory(str(folder))
    player.SetFormat("vtp")
    assert player.Run()
    cloud = vtkXMLPPolyDataReader()
    cloud.SetFileName(str(folder / "hills" / "leg000_points.pvtp"))
    cloud.Update()
    return vtkhelios.arrays(cloud.GetOutput())


def check_same(differences):
    differences = np.abs(differences)
    assert np.count_nonzero(differences > 1e-8) <= 1e-4 * len(differences)
    assert differences.max() <= 1e-6


@pytest.fixture(scope="module")
def clouds(tmp_path_factory):
    folder = tmp_path_factory.mktemp("shift")
    return run(folder / "near", np.zeros(3)), run(folder / "far", SHIFT)


def test_the_cloud_shifts_with_the_survey(clouds):
    near, far = clouds
    assert len(near["points"]) > 50_000
    assert len(near["points"]) == len(far["points"])
    check_same(far["points"] - SHIFT - near["points"])


def test_measurements_are_unchanged(clouds):
    near, far = clouds
    for name in ("PulseIds", "ReturnNumber"):
        assert np.array_equal(near[name], far[name])
    # The cell belongs to the sub-ray nearest in range: some are equally near.
    assert np.count_nonzero(near["CellIds"] != far["CellIds"]) <= 1e-4 * len(near["CellIds"])
    check_same(far["Range"] - near["Range"])
    assert np.allclose(far["Amplitude"], near["Amplitude"], rtol=1e-3, atol=0)
