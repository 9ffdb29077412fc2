# SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
# SPDX-License-Identifier: BSD-3-Clause
"""Python output on a full disk: the error names the file and the remedy, and no .part is left."""

import errno
import os
import pathlib
import subprocess
import sys

import pytest

from vtkhelios import cli
from vtkhelios.cli import _files


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

    def call(size, *arguments):
        words = " ".join(
            f"'{word}'" for word in [sys.executable, "-P", "-m", "vtkhelios", *arguments]
        )
        script = (
            f"mount -t tmpfs -o size={size} none '{disk}' && {words}; code=$?; "
            f"cd '{disk}' && find . -type f -name '*.part*'; exit $code"
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


@pytest.mark.parametrize("size", ["4k", "8k", "12k", "24k"])
def test_plan(small_disk, make_survey, size):
    """For any first file without space."""
    disk, call = small_disk
    make_survey()
    scene = disk.parent / "scene.xml"
    done = call(size, "plan", scene, "--output", disk, "--no-picture", "--grid", "20", "--quiet")
    assert done.returncode == 1, done
    assert "Traceback" not in done.stderr
    assert done.stderr.splitlines()[-1].startswith(f"error: {disk}/scene/")
    assert done.stderr.endswith("; free space on its disk or give another --output\n")
    assert ".part" not in done.stdout


def test_picture(small_disk):
    """Size of a disk that holds the beginning."""
    from vtkhelios import picture

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
    assert f"OSError: [Errno 28] the disk may be full: '{disk}/a.png'" in done.stderr
    assert done.stdout == ""


def test_write_whole(tmp_path, monkeypatch):
    path = tmp_path / "a.html"
    path.write_text("the old one")

    def write_half(self, _text, **_):
        self.write_bytes(b"half")
        raise OSError(errno.ENOSPC, os.strerror(errno.ENOSPC))

    with monkeypatch.context() as patch:
        patch.setattr(pathlib.Path, "write_text", write_half)
        with pytest.raises(OSError) as caught:
            _files.write_whole(path, "the new one")
    assert caught.value.filename == str(path) and caught.value.errno == errno.ENOSPC
    assert [file.name for file in tmp_path.iterdir()] == ["a.html"]
    assert path.read_text() == "the old one"
    _files.write_whole(path, "größer")
    assert path.read_text(encoding="utf-8") == "größer"


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


def test_report_into_a_path_that_is_not_a_folder(small_runs, tmp_path, capsys):
    (tmp_path / "file").write_text("")
    page = tmp_path / "file" / "page.html"
    assert cli.main(["report", str(small_runs["las"]), "--output", str(page), "--quiet"]) == 1
    error = capsys.readouterr().err
    assert error == (
        f"error: {tmp_path / 'file'}: cannot be written: File exists; give another --output\n"
    )
