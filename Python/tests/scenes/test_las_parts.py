# SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
# SPDX-License-Identifier: BSD-3-Clause
"""LAS files as parts of a scene."""

import os

import numpy as np
import pytest
from _real_data import real_file

import vtkhelios
from vtkhelios import cli, formats
from vtkhelios.array_names import CLASSIFICATION_FLAGS, CLASSIFICATION_IDS

SURVEY = """\
<document>
  <survey name="s" scene="#s" platform="platforms.xml#tripod" scanner="scanners.xml#vz400_class_tls">
    <leg>
      <platformSettings z="5" onGround="false"/>
      <scannerSettings pulseFreq_hz="100000" scanFreq_hz="100" verticalAngleMin_deg="-40"
        verticalAngleMax_deg="60" headRotatePerSec_deg="60" headRotateStop_deg="360"/>
    </leg>
  </survey>
  <scene id="s">
    <part classification="6">
      <filter type="lasloader">
        <param key="{key}" value="{path}"/>
        <param key="voxelSize" value="0.5"/>
        <param key="classes" value="{classes}"/>
      </filter>
    </part>
  </scene>
</document>
"""


@pytest.fixture
def write(tmp_path):
    """Two boxes of points: class 2 below, class 6 three metres above; returns a survey."""
    pytest.importorskip("laspy")
    grid = np.indices((8, 8, 2)).reshape(3, -1).T * 0.5 + 0.1
    points = np.concatenate([grid, grid + [0, 0, 3]])
    classes = np.repeat([2, 6], len(grid))
    for name, offset in (("a.las", 0), ("b.las", 20)):
        with formats.open_writer(tmp_path / name) as writer:
            writer.write({"points": points + [offset, 0, 0], CLASSIFICATION_IDS: classes})

    def call(classes="", path="a.las", key="filepath"):
        survey = tmp_path / "survey.xml"
        survey.write_text(SURVEY.format(path=path, classes=classes, key=key))
        return survey

    return call


def scene_of(survey):
    mesh = vtkhelios.read_survey(survey).scene
    return mesh, np.reshape(mesh.GetBounds(), (3, 2)).T


def area(mesh):
    scene = vtkhelios.Scene(mesh)
    p = scene.points[scene.triangles]
    return np.linalg.norm(np.cross(p[:, 1] - p[:, 0], p[:, 2] - p[:, 0]), axis=1).sum() / 2


BOX = 2 * 4 * 4 + 4 * 4 * 1  # m2: 8 x 8 x 2 voxels of 0.5 m


@pytest.mark.parametrize(("classes", "bottom", "top", "boxes"), [("", 0.1, 4.1, 2), ("6", 3.1, 4.1, 1), ("2 6", 0.1, 4.1, 2)])  # fmt: skip
def test_points_become_voxels(write, classes, bottom, top, boxes):
    mesh, (low, high) = scene_of(write(classes))
    assert low == pytest.approx([0.1, 0.1, bottom]) and high == pytest.approx([4.1, 4.1, top])
    assert area(mesh) == pytest.approx(boxes * BOX)


def pack(path):
    packed = path.with_suffix(".laz")
    assert cli.main(["convert", str(path), str(packed), "--quiet"]) == 0
    return packed


def test_laz(write, tmp_path):
    pytest.importorskip("lazrs")
    survey = write("6", "b.laz")
    pack(tmp_path / "b.las")
    mesh, (low, high) = scene_of(survey)
    assert high[0] == pytest.approx(24.1) and area(mesh) == pytest.approx(BOX)
    pack(tmp_path / "a.las")
    mesh, (low, high) = scene_of(write("6", "[ab].laz", "efilepath"))
    assert high[0] == pytest.approx(24.1) and area(mesh) == pytest.approx(2 * BOX)


@pytest.mark.parametrize(
    "name", ["als/ahn3_delft_1.laz", "als/autzen_trim.laz", "als/bcts_1.laz", "als/bcts_2.laz"]
)
def test_real_laz_has_the_points_of_laspy(name):
    laspy, _ = pytest.importorskip("laspy"), pytest.importorskip("lazrs")
    truth = laspy.read(real_file(name))
    reader = vtkhelios.vtkHeliosLASReader(file_name=real_file(name))
    cloud = vtkhelios.Cloud(vtkhelios.update(reader))
    assert np.array_equal(cloud.points, np.column_stack([truth.x, truth.y, truth.z]))
    assert np.array_equal(cloud[CLASSIFICATION_IDS], truth.classification)
    assert np.array_equal(cloud["GpsTime"], truth.gps_time)
    assert np.array_equal(cloud["Intensity"], truth.intensity)


def test_withheld_points_are_left_out_and_counted(write, tmp_path, capsys):
    survey = write()
    with formats.open_reader(tmp_path / "a.las") as reader:
        chunk = next(reader.chunks())
    upper = chunk["points"][:, 2] > 2
    flags = np.where(upper, 4, 1).astype(np.uint8)  # withheld above, synthetic below
    with formats.open_writer(tmp_path / "a.las") as writer:
        writer.write({**chunk, CLASSIFICATION_FLAGS: flags})
    mesh, (low, high) = scene_of(survey)
    assert high[2] == pytest.approx(1.1) and area(mesh) == pytest.approx(BOX)
    cli.main(["validate", str(survey), "--deep"])
    said = capsys.readouterr()
    assert "a.las: 128 of 256 points are withheld; they are left out" in said.out + said.err


def test_several_files(write):
    mesh, (low, high) = scene_of(write("6", "[ab].las", "efilepath"))
    assert high[0] == pytest.approx(24.1) and area(mesh) == pytest.approx(2 * BOX)


def test_echoes_have_the_class_of_the_part(write):
    cloud = vtkhelios.read_survey(write("6")).run()
    assert len(cloud) > 50 and set(cloud[CLASSIFICATION_IDS]) == {6}


@pytest.mark.parametrize(
    ("classes", "path", "message"),
    [
        ("2;6", "a.las", 'Classes has "2;6"; give classes from 0 to 255'),
        ("256", "a.las", 'Classes has "256"'),
        ("77", "a.las", "no points"),
        ("", "c.laz", "c.laz: has no table of its 256 points at byte "),
        ("", "d.las", "d.las"),
    ],
)
def test_errors_name_the_part(write, tmp_path, capsys, classes, path, message):
    survey = write(classes, path)
    if path == "c.laz":
        pack(tmp_path / "a.las").rename(tmp_path / "c.laz")
        os.truncate(tmp_path / "c.laz", 1000)
    (tmp_path / "d.las").write_bytes(b"LASF but no more")
    assert cli.main(["validate", str(survey), "--deep"]) == 1
    out = capsys.readouterr().out
    assert message in out and "survey.xml:10: error: " in out, out
