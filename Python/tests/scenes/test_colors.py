# SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
# SPDX-License-Identifier: BSD-3-Clause
"""Colours and textures of OBJ files as RGB of echoes, read back by other programs."""

import hashlib
import json
import os
import struct
import zlib

import numpy as np
import pytest
from vtkmodules.util.numpy_support import numpy_to_vtk
from vtkmodules.vtkCommonDataModel import vtkImageData
from vtkmodules.vtkIOImage import vtkPNGWriter

import vtkhelios
from vtkhelios import cli

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
    assert "colours are stored in 16 bits, which read_scan() of pye57 does not read" in done.stderr
    check_colors(*read_e57(room / "copy.e57"), 1 / 255)


def read_e57(path):
    """Points and colours of a scan with colours of any number of bits, by the library of pye57."""
    pye57 = pytest.importorskip("pye57")
    names = [f"cartesian{k}" for k in "XYZ"] + [f"color{k}" for k in ("Red", "Green", "Blue")]
    with pye57.E57(str(path)) as file:
        header = file.get_header(0)
        data = {name: np.empty(header.point_count) for name in names}
        buffers = pye57.libe57.VectorSourceDestBuffer()
        for name, values in data.items():
            buffers.append(pye57.libe57.SourceDestBuffer(
                file.image_file, name, values, len(values), True, True))  # fmt: skip
        header.points.reader(buffers).read()
        full = header["colorLimits"]["colorRedMaximum"].value()
    table = np.column_stack(list(data.values()))
    return table[:, :3], table[:, 3:] / full


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
    assert "--colors needs --format las, laz, copc or vtp" in done.stderr


def remove(path):
    path.unlink()


def make_folder(path):
    path.unlink()
    path.mkdir()


def make_fifo(path):
    path.unlink()
    os.mkfifo(path)


def link_to_device(path):
    path.unlink()
    path.symlink_to("/dev/zero")


def truncate(path):
    path.write_bytes(path.read_bytes()[:-30])


def change(path):
    data = bytearray(path.read_bytes())
    data[-30] ^= 1
    path.write_bytes(data)


def write_text(path):
    path.write_text("no image")


def promise(path):
    """64 million pixels in a small file that is whole."""
    rows = zlib.compress(bytes(1001 * 8000), 9)  # pixels of one bit
    chunks = [(b"IHDR", struct.pack(">IIBBBBB", 8000, 8000, 1, 0, 0, 0, 0)), (b"IDAT", rows)]
    data = b"\x89PNG\r\n\x1a\n"
    for name, content in [*chunks, (b"IEND", b"")]:
        data += struct.pack(">I", len(content)) + name + content
        data += struct.pack(">I", zlib.crc32(name + content))
    path.write_bytes(data)


BAD = {
    remove: " does not exist; give it",
    make_folder: ": cannot be read: it is a folder; give the name of a file",
    make_fifo: ": cannot be read: it is a FIFO, not a regular file; copy it to a file",
    link_to_device: ": cannot be read: it is a character device, not a regular file",
    truncate: ": PNG image cannot be read: ",
    change: ": PNG image cannot be read: IDAT: CRC error; get it again",
    write_text: " is no image that is read; give PNG, JPEG, TIFF, BMP or PNM",
}


@pytest.mark.parametrize("damage", BAD, ids=lambda damage: damage.__name__)
def test_a_bad_texture_is_one_error_with_its_name(room, capfd, damage):
    damage(room / "ramp.png")
    told = f"texture {room / 'ramp.png'}{BAD[damage]}"
    run = ["run", room / "survey.xml", "--output", room / "out", "--format", "las", "--colors"]
    for options in [], ["--dry-run"]:
        code, output = call(capfd, *run, *options)
        assert code == 1, output.err
        assert told in output.err and output.err.count("ramp.png") == 1
        assert output.err.rstrip().endswith("or remove map_Kd")
        assert not list(room.rglob("*.las*"))

    code, output = call(capfd, "validate", room / "survey.xml", "--deep")
    assert code == 0, output.out
    (line,) = [line for line in output.out.splitlines() if "ramp.png" in line]
    assert "warning: " in line and told in line
    assert line.endswith("or remove map_Kd; only a run with --colors reads it")
    code, output = call(capfd, "info", room / "room.obj", "--json")
    assert code == 0, output.err
    assert told in output.err and json.loads(output.out)["textures"] == []


def call(capfd, *arguments):
    """Runs a command in this process: its exit code, and what it printed."""
    code = cli.main([str(each) for each in arguments])
    return code, capfd.readouterr()


def test_without_colours_no_texture_is_read(room, capfd):
    make_fifo(room / "ramp.png")
    code, output = call(
        capfd,
        "run",
        room / "survey.xml",
        "--output",
        room / "out",
        "--no-accuracy-report",
        "--quiet",
    )
    assert (code, output.err) == (0, "")


def test_info_lists_textures(room, command_line):
    done = command_line("info", room / "room.obj")
    assert f"texture    {room / 'ramp.png'}: 64 x 64 pixels\n" in done.stdout
    assert not done.stderr
    done = command_line("validate", room / "survey.xml", "--deep")
    assert "0 errors, 0 warnings" in done.stdout


def test_an_error_of_the_scene_is_one_with_and_without_colours(room, command_line):
    (room / "room.obj").write_text(MESH + "f 1 2 99\n")
    done = command_line("validate", room / "survey.xml", "--deep")
    assert done.returncode == 1
    assert done.stdout.count("room.obj:18") == 1 and "--colors" not in done.stdout


def test_memory_counts_textures_by_their_headers(room, command_line):
    """192 MB of pixels in a file of 8 kB."""
    run = ["run", room / "survey.xml", "--output", room / "out", "--format", "las", "--colors"]
    without = needed_memory(command_line, run)
    promise(room / "ramp.png")
    assert (room / "ramp.png").stat().st_size < 10_000
    done = command_line(*run, "--memory", "180M")
    assert done.returncode == 1
    assert f"{room / 'ramp.png'}: 64000000 pixels of 1 texture need about 192 MB" in done.stderr
    needed = needed_memory(command_line, run)
    assert 150e6 < needed - without < 250e6  # --dry-run counts them, too
    done = command_line(*run, "--memory", f"{needed + 100e6:.0f}", "--no-accuracy-report")
    assert done.returncode == 0, done.stderr


def needed_memory(command_line, run):
    """Returns the bytes that --dry-run estimates."""
    done = command_line(*run, "--dry-run", "--json")
    assert done.returncode == 0, done.stderr
    return json.loads(done.stdout)["memory_bytes"]


def test_textures_are_read_once_a_run(room):
    """By all scanners, and by the report on accuracy: the file is gone once the pulses begin."""
    text = (room / "survey.xml").read_text()
    leg = text[text.index("<leg>") : text.index("</survey>")]
    other = leg.replace("<leg>", '<leg scanner="scanners.xml#riegl_vz400">')
    (room / "survey.xml").write_text(text.replace(leg, leg + other))
    player = vtkhelios.vtkHeliosSurveyPlayer(
        source=vtkhelios.read_survey(room / "survey.xml").source()
    )
    player.SetOutputDirectory(str(room / "out"))
    player.SetFormat("las")
    player.WriteColorsOn()
    player.SetPulsesPerBlock(30_000)
    gone = []

    def hide(*_):
        if player.GetCount("pulses") > 0 and not gone:
            (room / "ramp.png").unlink()
            gone.append(player.GetCount("pulses"))

    player.AddObserver("ProgressEvent", hide)
    assert player.Run()
    assert gone and gone[0] < player.GetCount("pulses")
    assert "range" in json.dumps(json.loads(player.GetReport())["accuracy"])


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
        vtkhelios.PipelineError,
        match='"xyz" cannot have colours of surfaces; give las, laz, copc or vtp',
    ):
        survey.run_to(tmp_path / "text", colors=True)
