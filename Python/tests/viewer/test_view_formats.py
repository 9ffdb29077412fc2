# SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
# SPDX-License-Identifier: BSD-3-Clause
"""vtkhelios view opens clouds of every format that vtkhelios convert reads."""

import json
import os
import pathlib

import pytest
from _point_files import COUNT, write
from _viewer_window import needs_window

from vtkhelios import cli, formats
from vtkhelios.cli import view

pytestmark = needs_window


@pytest.fixture
def start(monkeypatch, tmp_path):
    """Runs vtkhelios view off screen; returns its exit code and its state."""

    def call(*arguments):
        state = tmp_path / "state.json"
        monkeypatch.delenv("DISPLAY", raising=False)
        code = cli.main(
            ["view", *map(str, arguments), "--offscreen", "--still", str(tmp_path / "still.png")]
            + ["--size", "160x120", "--state", str(state)]
        )
        return code, json.loads(state.read_text()) if state.exists() else None

    return call


@pytest.fixture
def cloud(request, tmp_path):
    """A file of the format of the parameter."""
    try:
        write(tmp_path / f"cloud{request.param}")
    except formats.FormatError as error:
        pytest.skip(str(error))
    return tmp_path / f"cloud{request.param}"


def check_cloud(state):
    assert state["cloud"]["points"] == COUNT
    assert state["camera"]["focalPoint"][0] == pytest.approx(476050, abs=50)


@pytest.mark.parametrize("cloud", [".pcd", ".e57"], indirect=True)
def test_converted_formats(start, cloud):
    code, state = start(cloud)
    assert code == 0
    check_cloud(state)


@pytest.mark.parametrize("cloud", [".laz", ".copc.laz"], indirect=True)
def test_laz_is_read_by_the_viewer(command_line, cloud, tmp_path, monkeypatch):
    monkeypatch.delenv("DISPLAY", raising=False)
    state = tmp_path / "state.json"
    picture = ["--offscreen", "--still", tmp_path / "still.png", "--size", "160x120"]
    done = command_line("view", cloud, *picture, "--state", state)
    assert done.returncode == 0, done.stderr
    check_cloud(json.loads(state.read_text()))


def test_nothing_is_left_behind(start, tmp_path, monkeypatch):
    monkeypatch.setattr("tempfile.tempdir", str(tmp_path / "temporary"))
    os.mkdir(tmp_path / "temporary")
    write(tmp_path / "cloud.pcd")
    assert start(tmp_path / "cloud.pcd")[0] == 0
    assert list(pathlib.Path(tmp_path / "temporary").iterdir()) == []


def test_damaged_files_are_reported(start, tmp_path, capsys):
    damaged = tmp_path / "damaged.pcd"
    damaged.write_bytes(b"this is no PCD")
    code, state = start(damaged)
    assert (code, state) == (1, None)
    assert "damaged.pcd" in capsys.readouterr().err


def test_files_of_the_viewer_are_not_converted(tmp_path):
    for name in ("a.las", "a.xyz", "a.ply", "a.vtp", "survey.xml"):
        (tmp_path / name).write_text("")
        assert not view.needs_conversion(str(tmp_path / name))
    assert not view.needs_conversion(str(tmp_path / "missing.laz"))
