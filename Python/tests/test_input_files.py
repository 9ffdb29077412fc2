# SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
# SPDX-License-Identifier: BSD-3-Clause
"""Files that are not regular are reported, and not read; --memory rejects large ones."""

import os
import shutil
import socket

import pytest

import vtkhelios
from vtkhelios import cli, formats
from vtkhelios.formats._base import check_file

FIFO = "cannot be read: it is a FIFO, not a regular file; copy it to a file"
DEVICE = "cannot be read: it is a character device, not a regular file; copy what is read to a file"
KERNEL = "cannot be read: it is a file of the kernel (/proc, /sys), not a regular file; copy it to a file"
SOCKET = "cannot be read: it is a socket, not a regular file; copy what it sends to a file"


@pytest.fixture
def odd(tmp_path, monkeypatch):
    """Names that are not files, and the message for each."""
    monkeypatch.chdir(tmp_path)
    os.mkfifo("fifo")
    os.mkdir("folder")
    os.symlink("fifo", "link")
    with socket.socket(socket.AF_UNIX) as listener:
        listener.bind("socket")
    return {
        "fifo": FIFO, "link": FIFO, "socket": SOCKET, "/dev/zero": DEVICE,
        "/proc/self/status": KERNEL,
        "folder": "cannot be read: it is a folder; give the name of a file",
    }  # fmt: skip


def test_python_and_cxx_have_the_same_messages(odd):
    reader = vtkhelios.vtkHeliosObjSceneReader()
    for name, problem in odd.items():
        with pytest.raises(formats.FormatError) as caught:
            check_file(name)
        assert str(caught.value) == f"{name}: {problem}"
        reader.file_name = name
        with pytest.raises(vtkhelios.PipelineError) as raised:
            vtkhelios.update(reader)
        assert str(raised.value) == f"{name}: {problem}"


def test_missing_files(tmp_path):
    with pytest.raises(formats.FormatError, match="none: no such file; check its name"):
        check_file(tmp_path / "none")
    with pytest.raises(formats.FormatError, match="cannot be read: embedded null byte; check its"):
        check_file("a\0b")
    (tmp_path / "a").write_text("")
    os.symlink("a", tmp_path / "b")
    check_file(tmp_path / "b")


@pytest.mark.parametrize("ending", formats.FORMATS)
def test_points(odd, capsys, ending):
    for name in ("fifo", "/dev/zero"):
        path = f"points{ending}"
        os.symlink(name, path)
        for command in (["info", path], ["convert", path, "other.ply"]):
            assert cli.main(command) == 1
            assert f"{path}: {odd[name]}" in capsys.readouterr().err
        os.unlink(path)


@pytest.mark.parametrize("name", ["fifo", "/dev/zero"])
@pytest.mark.parametrize("place", ["survey.xml", "scene.xml", "plane.obj"])
def test_surveys(odd, capsys, make_survey, name, place):
    """A survey, its scene and its geometry."""
    survey = make_survey()
    path = survey.parent / place
    path.unlink()
    os.symlink(name, path) if name.startswith("/") else os.mkfifo(path)
    for command in ("run", "validate"):
        if (command, place) == ("validate", "plane.obj"):
            continue  # geometry is not read
        capsys.readouterr()
        assert cli.main([command, str(survey)]) == 1
        out, err = capsys.readouterr()
        assert f"{place}: {odd[name]}" in (err + out).replace(": error", "")


@pytest.mark.parametrize("ending", [".txt", ".vtt", ".pvtt", ".las"])
def test_waveforms(odd, capsys, ending):
    os.mkfifo(f"waves{ending}")
    assert cli.main(["detect", f"waves{ending}", "-o", "a.xyz"]) == 1
    assert f"waves{ending}: {FIFO}" in capsys.readouterr().err


def test_run_with_a_fifo_as_point_file(odd, tmp_path, capsys, small_runs):
    shutil.copytree(small_runs["xyz"], "run")
    path = next((tmp_path / "run").glob("leg000_points.xyz"))
    path.unlink()
    os.mkfifo(path)
    for command in ("info", "report"):
        assert cli.main([command, "run"]) == 1
        assert f"leg000_points.xyz: {FIFO}" in capsys.readouterr().err


# Memory


@pytest.fixture
def no_limit():
    yield
    vtkhelios.vtkHeliosMemoryLimit.SetLimit(0.0)


@pytest.mark.parametrize("command", [["run"], ["run", "--dry-run"]])
def test_scene_above_the_memory_limit(make_survey, tmp_path, capsys, no_limit, command):
    survey = make_survey()
    arguments = [*command, str(survey), "--output", str(tmp_path / "out")]
    assert cli.main([*arguments, "--memory", "1kB"]) == 1
    err = capsys.readouterr().err
    assert "plane.obj: 2 triangles with their vertices need about" in err
    assert "and 0 MB are available of the 0.001 MB that may be used; use fewer, or allow" in err
    assert not list(tmp_path.rglob("*points*"))
    assert cli.main([*arguments, "--memory", "1T", "--quiet"]) == 0


def test_copies_of_a_part(make_survey, capsys, no_limit):
    """Parts that each fit do not fit together."""
    survey = make_survey()
    n = 1500
    lines = [f"v {x} {y} 0" for y in range(n) for x in range(2)]
    lines += [f"f {2 * y + 1} {2 * y + 2} {2 * y + 4}" for y in range(n - 1)]
    (survey.parent / "plane.obj").write_text("\n".join(lines) + "\n")
    part = (
        '<part><filter type="objloader"><param type="string" key="filepath" value="plane.obj"/>'
        "</filter></part>"
    )
    scene = f'<document><scene id="plane">{part * 600}</scene></document>'
    (survey.parent / "scene.xml").write_text(scene)
    own = 1e6 + vtkhelios_memory()
    run = ["run", str(survey), "--dry-run", "--memory", f"{own + 5e7:.0f}"]
    assert cli.main(run) == 0  # stored as instances
    capsys.readouterr()
    assert cli.main([*run, "--no-instances"]) == 1
    err = capsys.readouterr().err
    assert "899400 triangles of all parts need about 67.5 MB of memory, and" in err


def vtkhelios_memory():
    """Memory of this process, without pages of files [bytes]."""
    return vtkhelios.vtkHeliosMemoryLimit.GetUsed() * 2**20


@pytest.mark.parametrize("text", ["8X", "-1", "0", "", "nan", "1e9", "8 GB B", "9" * 40])
def test_invalid_sizes(capsys, text):
    with pytest.raises(SystemExit):
        cli.main(["run", "survey.xml", f"--memory={text}"])
    assert (
        f"{text!r} is not a size; expected a number of bytes such as 8G or 512M"
        in capsys.readouterr().err
    )


def test_sizes():
    from vtkhelios.cli._reading import size

    for text, expected in {
        "8G": 8e9,
        "512MiB": 512 * 2**20,
        "1.5 t": 1.5e12,
        "7": 7,
        "2kb": 2e3,
    }.items():
        assert size(text) == expected
