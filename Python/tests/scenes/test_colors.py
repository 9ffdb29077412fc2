# SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
# SPDX-License-Identifier: BSD-3-Clause
"""Colours and textures of OBJ files as RGB of echoes, read back by other programs."""

import hashlib

import numpy as np
import pytest
from vtkmodules.util.numpy_support import numpy_to_vtk
from vtkmodules.vtkCommonDataModel import vtkImageData
from vtkmodules.vtkIOImage import vtkPNGWriter

import vtkhelios

SIZE = 64  # pixels and metres of the ramp
MESH = """\
mtllib room.mtl
v -32 20 -32
v 32 20 -32
v 32 20 32
v -32 20 32
v -5 10 -5
v -1 10 -5
v -1 10 5
v -5 10 5
vt 0 0
vt 1 0
vt 1 1
vt 0 1
usemtl ramp
f 1/1 2/2 3/3 4/4
usemtl red
f 5 6 7 8
"""
MATERIALS = "newmtl ramp\nKd 1 1 0.5\nmap_Kd ramp.png\nnewmtl red\nKd 0.8 0.1 0\n"
SCENE = """\
<document><scene id="room"><part>
<filter type="objloader"><param type="string" key="filepath" value="room.obj"/></filter>
<filter type="translate"><param type="vec3" key="offset" value="500000;5000000;0"/></filter>
</part></scene></document>
"""
SURVEY = """\
<document><survey name="room" scene="scene.xml#room" platform="platforms.xml#tripod"
  scanner="scanners.xml#vz400_class_tls"><leg><platformSettings x="500000" y="5000000" z="0.5"/>
  <scannerSettings active="true" pulseFreq_hz="100000" scanFreq_hz="100" verticalAngleMin_deg="-20"
  verticalAngleMax_deg="20" headRotatePerSec_deg="60" headRotateStart_deg="-30"
  headRotateStop_deg="30"/></leg></survey></document>
"""


def write_ramp(path):
    """Red grows with the column, green with the row from the lowest; blue is full."""
    rows, columns = np.divmod(np.arange(SIZE * SIZE), SIZE)
    pixels = np.column_stack([4 * columns, 4 * rows, np.full(len(rows), 255)]).astype(np.uint8)
    image = vtkImageData()
    image.SetDimensions(SIZE, SIZE, 1)
    image.GetPointData().SetScalars(numpy_to_vtk(pixels, deep=True))
    writer = vtkPNGWriter()
    writer.SetFileName(str(path))
    writer.SetInputData(image)
    writer.Write()


@pytest.fixture
def room(tmp_path):
    for name, text in {
        "room.mtl": MATERIALS, "room.obj": MESH, "scene.xml": SCENE, "survey.xml": SURVEY
    }.items():  # fmt: skip
        (tmp_path / name).write_text(text)
    write_ramp(tmp_path / "ramp.png")
    return tmp_path


def check_colors(points, colors, tolerance):
    """points and colours of the wall, y = 20, and the red panel, y = 10."""
    x, y, z = (points - [500000, 5000000, 0]).T
    wall = np.abs(y - 20) < 0.1
    red = np.abs(y - 10) < 0.1
    assert wall.sum() > 10_000 and red.sum() > 1_000
    inside = wall & (np.abs(x) < 31) & (np.abs(z) < 31)
    expected = np.column_stack([
        4 * (x + 32 - 0.5) / 255, 4 * (z + 32 - 0.5) / 255, np.full(len(x), 0.5)
    ])[inside]  # fmt: skip
    assert np.abs(colors[inside] - expected).max() < tolerance
    assert np.abs(colors[red] - [0.8, 0.1, 0]).max() < tolerance


def test_echoes_have_the_colour_where_they_are(room):
    survey = vtkhelios.read_survey(room / "survey.xml")
    plain = survey.run(noise=False)
    assert "RGB" not in plain.names
    cloud = survey.run(noise=False, colors=True)
    # within the footprint, a millimetre
    check_colors(cloud.points, cloud["RGB"], 4 * 0.01 / 255)
    assert (cloud.points == plain.points).all()


def test_las_and_other_formats_store_colours(room, command_line):
    laspy = pytest.importorskip("laspy")
    done = command_line(
        "run", room / "survey.xml", "--output", room, "--format", "las", "--colors", "--no-noise"
    )
    assert done.returncode == 0, done.stderr
    path = room / "room/leg000_points.las"
    las = laspy.read(path)
    assert las.header.point_format.id == 7
    points = np.column_stack([las.x, las.y, las.z])
    colors = np.column_stack([las.red, las.green, las.blue]) / 65535.0
    check_colors(points, colors, 4 * 0.01 / 255 + 1e-4)

    for name in ("copy.ply", "copy.e57"):
        done = command_line("convert", path, room / name)
        assert done.returncode == 0, done.stderr
    plyfile = pytest.importorskip("plyfile")
    vertices = plyfile.PlyData.read(str(room / "copy.ply"))["vertex"]
    xyz = np.column_stack([vertices[k] for k in "xyz"]).astype(float)
    rgb = np.column_stack([vertices[k] for k in ("red", "green", "blue")]) / 255.0
    check_colors(xyz, rgb, 1 / 255)
    e57 = pytest.importorskip("pye57").E57(str(room / "copy.e57"))
    data = e57.read_scan(0, colors=True, ignore_missing_fields=True)
    xyz = np.column_stack([data[f"cartesian{k}"] for k in "XYZ"])
    rgb = np.column_stack([data[f"color{k}"] for k in ("Red", "Green", "Blue")]) / 255.0
    check_colors(xyz, rgb, 1 / 255)


def test_a_run_is_the_same_for_threads_and_instances(room, command_line):
    hashes = set()
    for number, options in enumerate([[], ["--threads", 1], ["--no-instances"]]):
        done = command_line(
            "run", room / "survey.xml", "--output", room / str(number), "--format", "las", "--colors",
            *options,
        )  # fmt: skip
        assert done.returncode == 0, done.stderr
        data = (room / str(number) / "room/leg000_points.las").read_bytes()
        hashes.add(hashlib.sha256(data).hexdigest())
    assert len(hashes) == 1


def test_text_has_no_colours(room, command_line):
    done = command_line("run", room / "survey.xml", "--output", room, "--colors")
    assert done.returncode != 0
    assert "--colors needs --format las or vtp" in done.stderr


def test_a_missing_texture_is_named(room, command_line):
    (room / "ramp.png").unlink()
    done = command_line("run", room / "survey.xml", "--output", room, "--format", "las", "--colors")
    assert done.returncode == 0, done.stderr
    assert f"texture {room / 'ramp.png'} does not exist; give it, or remove map_Kd" in done.stderr
    assert done.stderr.count("does not exist") == 1


def test_meshes_of_other_libraries_keep_the_colours_of_their_vertices():
    corners = [[-9, 10, -9], [9, 10, -9], [9, 10, 9], [-9, 10, 9]]
    scene = vtkhelios.Scene(corners, [[0, 1, 2], [0, 2, 3]])
    colors = numpy_to_vtk(
        np.array([[0, 0, 1], [1, 0, 1], [1, 0, 1], [0, 0, 1]], np.float32), deep=True
    )
    colors.SetName("RGB")
    scene.polydata.GetPointData().AddArray(colors)
    cloud = vtkhelios.scan(
        scene, position=(0, 0, 0), scan_frequency=20, vertical=(-30, 30), head=(-30, 30), head_speed=60,
        noise=False, colors=True,
    )  # fmt: skip
    assert len(cloud) > 1000
    assert np.abs(cloud["RGB"][:, 0] - (cloud.points[:, 0] + 9) / 18).max() < 0.01
    assert np.allclose(cloud["RGB"][:, 1:], [0, 1])


def test_run_to_writes_colours_where_the_format_has_them(room, tmp_path):
    survey = vtkhelios.read_survey(room / "survey.xml")
    report = survey.run_to(tmp_path / "out", format="las", colors=True, noise=False)
    reader = vtkhelios.vtkHeliosLASReader()
    reader.SetFileName(str(report["folder"] / "leg000_points.las"))
    vtkhelios.update(reader)
    cloud = vtkhelios.Cloud(reader.GetOutput())
    check_colors(cloud.points, cloud["RGB"], 4 * 0.01 / 255 + 1e-4)
    with pytest.raises(
        vtkhelios.PipelineError, match='Format "xyz" has no colours; give las or vtp'
    ):
        survey.run_to(tmp_path / "text", colors=True)
