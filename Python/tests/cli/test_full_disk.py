# SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
# SPDX-License-Identifier: BSD-3-Clause
"""Python output on a full disk: the error names the file and the remedy, and no .part is left."""

import errno
import os
import pathlib
import re
import runpy
import subprocess
import sys

import numpy as np
import pytest

import vtkhelios
from vtkhelios.core import files as _files
from vtkhelios import cli


def can_mount():
    done = subprocess.run(
        ["unshare", "-m", "mount", "-t", "tmpfs", "none", "/mnt"], capture_output=True, check=False
    )
    return done.returncode == 0


@pytest.fixture
def small_disk(tmp_path):
    """Runs vtkhelios with a small disk at tmp_path/disk; its result, and the files left there."""
    if not can_mount():
        pytest.skip("file systems cannot be mounted here")
    disk = tmp_path / "disk"
    disk.mkdir()

    def call(size, *arguments, into=None):
        words = " ".join(
            f"'{word}'" for word in [sys.executable, "-P", "-m", "vtkhelios", *arguments]
        )
        into = f" > '{into}'" if into else ""
        left = (
            "*" if arguments[0] in ("export", "fit", "tradeoff", "convert", "plan") else "*.part*"
        )
        script = (
            f"mount -t tmpfs -o size={size} none '{disk}' && {words}{into}; code=$?; "
            f"cd '{disk}' && find . -type f -name '{left}'; exit $code"
        )
        return subprocess.run(
            ["unshare", "-m", "sh", "-c", script],
            capture_output=True,
            text=True,
            env={**os.environ, "PYTHONPATH": ":".join(sys.path)},
        )

    return disk, call


def expect_full(done, file):
    assert done.returncode == 1, done
    assert done.stderr == (
        f"error: {file}: cannot be written: No space left on device; free space on its disk or give "
        "another --output\n"
    )
    assert ".part" not in done.stdout


def test_report(small_disk, small_runs):
    disk, call = small_disk
    page = disk / "report.html"
    command = ["report", small_runs["las"], "--output", page, "--quiet"]
    expect_full(call("40k", *command), disk / "report_cloud.html")
    expect_full(call("40k", *command, "--cloud-points", 0), page)


def test_schema(small_disk):
    disk, call = small_disk
    expect_full(call("8k", "schema", "--output", disk), disk / "helios.xsd")


@pytest.mark.parametrize("unbuffered", ["", "1"])
def test_standard_output(small_disk, unbuffered, monkeypatch):
    """Also of python -u, whose text streams ignore that only a part was written."""
    disk, call = small_disk
    monkeypatch.setenv("PYTHONUNBUFFERED", unbuffered)
    done = call("16k", "schema", into=disk / "helios.xsd")
    assert done.returncode == 1 and done.stderr == (
        "error: standard output: No space left on device: the output is lost; the files that the "
        "command wrote are complete\n"
    )


@pytest.mark.parametrize("layout", ["kitti", "semantickitti", "s3dis", "mcap"])
@pytest.mark.parametrize("size", ["4k", "16k"])
def test_export(small_disk, small_runs, layout, size):
    """Nothing is left, so that the command can be repeated."""
    if layout == "mcap":
        pytest.importorskip("mcap")
    disk, call = small_disk
    output = disk / "out"
    done = call(size, "export", small_runs["las"], output, f"--{layout}", "--quiet")
    assert done.returncode == 1 and done.stdout == "", done
    assert re.fullmatch(
        rf"error: {output}[^:]*: cannot be written: No space left on device; free space on its disk "
        r"or give another OUT\n", done.stderr,
    ), done.stderr  # fmt: skip


@pytest.mark.parametrize(
    "ending", ["xyz", "las", "laz", "copc.laz", "ply", "pcd", "vtp", "pvtp", "e57"]
)
def test_convert(small_disk, small_runs, ending):
    """Nothing is left."""
    pytest.importorskip("pye57" if ending == "e57" else "numpy")
    disk, call = small_disk
    path = disk / f"a.{ending}"
    done = call("60k", "convert", small_runs["las"], path, "--quiet")
    assert done.returncode == 1 and done.stdout == "", done
    assert done.stderr.startswith(f"error: {disk}/a") and done.stderr.count("\n") == 1
    assert "are safe" not in done.stderr
    # libraries give their own reasons
    assert re.search(
        r"No space left on device|call write|LASwritePoint|write\(\) failed", done.stderr
    ), done.stderr


def test_detect(small_disk, small_runs):
    """The data that the error names are kept."""
    disk, call = small_disk
    waveforms = small_runs["vtp"] / "leg000_fullwave.pvtt"
    done = call("40k", "detect", waveforms, "-o", disk / "a.xyz", "--quiet")
    assert done.returncode == 1 and done.stdout == "./a.xyz.part\n", done
    assert f"records are safe in {disk}/a.xyz.part; make room" in done.stderr


def test_compare(small_disk, small_runs):
    disk, call = small_disk
    page = disk / "a.html"
    command = ("compare", small_runs["las"], small_runs["xyz"], "--output", page, "--quiet")
    expect_full(call("60k", *command), page)


def test_page_of_a_cloud(small_disk, small_runs):
    disk, call = small_disk
    done = call("60k", "view", small_runs["las"], "--html", disk / "a.html", "--quiet")
    assert done.returncode == 1 and done.stdout == ""
    assert "a.html: cannot be written: No space left on device; free space" in done.stderr


@pytest.mark.parametrize("size", ["4k", "8k", "16k"])
def test_fit(small_disk, size):
    """All files, or none."""
    disk, call = small_disk
    write = runpy.run_path(pathlib.Path(__file__).with_name("test_fit.py"))["write"]
    cloud = write(disk.parent / "a.las")
    done = call(size, "fit", cloud, "--output", disk / "fitted", "--quiet")
    expect_full_of_files(done, disk / "fitted")


def test_tradeoff(small_disk, make_survey):
    disk, call = small_disk
    options = ("--pulses", "10", "--no-parts", "--quiet", "--output", disk)
    done = call("8k", "tradeoff", make_survey(stop=5), *options)
    expect_full_of_files(done, disk)


def expect_full_of_files(done, folder):
    """An error of one of several files, none of which is there."""
    assert done.returncode == 1 and done.stdout == "", done
    assert re.fullmatch(
        rf"error: {folder}/\S+: cannot be written: No space left on device; free space on its disk "
        r"or give another --output\n", done.stderr,
    ), done.stderr  # fmt: skip


@pytest.mark.parametrize("size", ["4k", "8k", "12k", "24k"])
def test_plan(small_disk, make_survey, size):
    """Any first file may lack space."""
    disk, call = small_disk
    make_survey()
    scene = disk.parent / "scene.xml"
    done = call(size, "plan", scene, "--output", disk, "--no-picture", "--grid", "20", "--quiet")
    assert done.returncode == 1, done
    assert "Traceback" not in done.stderr
    assert done.stderr.splitlines()[-1].startswith(f"error: {disk}/scene/")
    assert done.stderr.endswith("; free space on its disk or give another --output\n")
    assert done.stdout == ""


@pytest.mark.parametrize("size", ["8k", "100k"])
def test_flight_plan(small_disk, make_survey, size):
    disk, call = small_disk
    make_survey()
    scene = disk.parent / "plane.obj"
    flight = ("--als", "--flying-height", "300", "--density", "2")
    done = call(size, "plan", scene, *flight, "--output", disk, "--quiet")
    assert done.returncode == 1 and done.stdout == "", done
    assert done.stderr.startswith(f"error: {disk}/plane_als/"), done.stderr
    assert done.stderr.endswith(
        "No space left on device; free space on its disk or give another --output\n"
    )


def test_picture(small_disk):
    """Size of a disk that holds the beginning."""
    from vtkhelios.reports import picture

    disk, _ = small_disk
    code = (
        "import sys, numpy as np; from vtkhelios import picture; "
        "picture.write_png(np.random.default_rng(1).random((400, 400, 3)), sys.argv[1])"
    )
    script = (
        f"mount -t tmpfs -o size=16k none '{disk}' && "
        f"'{sys.executable}' -c '{code}' '{disk}/a.png'; ls '{disk}'"
    )
    assert picture.OVERSAMPLING == 2
    done = subprocess.run(
        ["unshare", "-m", "sh", "-c", script],
        capture_output=True,
        text=True,
        env={**os.environ, "PYTHONPATH": ":".join(sys.path)},
    )
    assert f"OSError: [Errno 28] No space left on device: '{disk}/a.png'" in done.stderr
    assert done.stdout == ""


def raise_full(*_):
    raise OSError(errno.ENOSPC, os.strerror(errno.ENOSPC))


def test_write_whole(tmp_path, monkeypatch):
    path = tmp_path / "a.html"
    path.write_text("the old one")
    with monkeypatch.context() as patch:
        patch.setattr(_files, "keep_part", raise_full)  # the .part is written
        with pytest.raises(OSError) as caught:
            _files.write_whole(path, "the new one")
    assert caught.value.filename == str(path) and caught.value.errno == errno.ENOSPC
    assert [file.name for file in tmp_path.iterdir()] == ["a.html"]
    assert path.read_text() == "the old one"
    _files.write_whole(path, "größer")
    assert path.read_text(encoding="utf-8") == "größer"
    _files.write_whole(path, b"\xff")
    assert path.read_bytes() == b"\xff"


def test_files_that_belong_together(tmp_path):
    """If the second cannot be written, neither is there."""
    (tmp_path / "b.txt.part").mkdir()
    with pytest.raises(OSError) as caught:
        _files.write_files(tmp_path, {"a.txt": "a", "b.txt": "b", "c.txt": "c"})
    assert caught.value.filename == str(tmp_path / "b.txt")
    assert [file.name for file in tmp_path.iterdir()] == ["b.txt.part"]
    (tmp_path / "b.txt.part").rmdir()
    paths = _files.write_files(tmp_path, {"a.txt": "a", "b.txt": "b"})
    assert [path.read_text() for path in paths] == ["a", "b"]


def test_a_part_is_not_written_through_a_link(tmp_path):
    other = tmp_path / "other.txt"
    other.write_text("of the user")
    for link in (tmp_path / "a.txt.part", tmp_path / "a.vtp.part", tmp_path / "a.las.part"):
        link.symlink_to(other)
    _files.write_whole(tmp_path / "a.txt", "a")
    cloud = vtkhelios.Cloud.from_arrays(np.zeros((3, 3)))
    cloud.write(tmp_path / "a.vtp")
    cloud.write(tmp_path / "a.las")
    assert other.read_text() == "of the user"
    names = {path.name for path in tmp_path.iterdir() if not path.is_symlink()}
    assert names == {"a.txt", "a.vtp", "a.las", "other.txt"}


@pytest.mark.parametrize("exists", [False, True])
def test_new_folder(tmp_path, exists):
    folder = tmp_path / "below/new"
    if exists:
        folder.mkdir(parents=True)
    with pytest.raises(OSError) as caught, _files.new_folder(folder) as unfinished:
        (unfinished / "a.txt").write_text("a")
        (unfinished / "none/b.txt").write_text("b")
    assert caught.value.filename == str(folder / "none/b.txt")
    assert [path for path in tmp_path.rglob("*") if path.is_file()] == []
    assert folder.exists() == exists
    with _files.new_folder(folder) as unfinished:
        (unfinished / "a.txt").write_text("a")
    assert [path.name for path in folder.iterdir()] == ["a.txt"]
    assert [path.name for path in folder.parent.iterdir()] == ["new"]
    (tmp_path / "file").touch()
    with pytest.raises(NotADirectoryError, match="is not a folder: '.*file'"):
        with _files.new_folder(tmp_path / "file/new"):
            pass


@pytest.mark.parametrize(
    "number, cure",
    [
        (errno.ENOSPC, "free space on its disk or give another --output"),
        (errno.EDQUOT, "free space of your quota or give another --output"),
        (errno.EACCES, "give another --output"),
    ],
)
def test_message(number, cure):
    error = OSError(number, os.strerror(number))
    said = _files.cannot_be_written(error, "a.html", "--output")
    assert said == f"a.html: cannot be written: {os.strerror(number)}; {cure}"


def test_message_without_a_number():
    """A MemoryError of numpy has none, for one."""
    said = _files.cannot_be_written(OSError("673 written"), "a.bin", "OUT")
    assert said == "a.bin: cannot be written: 673 written; give another OUT"


def test_report_into_a_path_that_is_not_a_folder(small_runs, tmp_path, capsys):
    (tmp_path / "file").write_text("")
    page = tmp_path / "file" / "page.html"
    assert cli.main(["report", str(small_runs["las"]), "--output", str(page), "--quiet"]) == 1
    error = capsys.readouterr().err
    assert error == (
        f"error: {tmp_path / 'file'}: cannot be written: File exists; give another --output\n"
    )
