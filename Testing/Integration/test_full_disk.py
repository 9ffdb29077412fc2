# SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
# SPDX-License-Identifier: BSD-3-Clause
"""Disks that fill up at any point of a run: an error about it, no wrong file, and resume once there is space."""

import hashlib
import json
import os
import pathlib
import subprocess
import sys

import pytest

import vtkhelios

PACKAGE_DIR = pathlib.Path(vtkhelios.__file__).absolute().parents[1]
SURVEY = """\
<document>
<scannerSettings id="turn" pulseFreq_hz="100000" scanFreq_hz="100" headRotatePerSec_deg="30"
 headRotateStart_deg="0" headRotateStop_deg="2" trajectoryTimeInterval_s="0.01"/>
<survey name="yard" platform="platforms.xml#tripod" scanner="scanners.xml#vz400_class_tls" scene="scene.xml#s">
<leg><platformSettings x="0" y="0" z="2"/><scannerSettings template="turn"/></leg>
<leg><platformSettings x="9" y="1" z="2"/><scannerSettings template="turn" headRotateStop_deg="1"/></leg>
</survey></document>
"""
SCENE = """\
<document><scene id="s"><part><filter type="objloader">
<param type="string" key="filepath" value="yard.obj"/></filter></part></scene></document>
"""
YARD = "v -60 -60 0\nv 60 -60 0\nv 60 60 0\nv -60 60 0\nf 1 2 3 4\n"
FORMATS = {
    "text": ["--format", "xyz", "--waveforms", "--pulses"],
    "las": ["--format", "las", "--waveforms"],
    "vtp": ["--format", "vtp", "--waveforms", "--pulses"],
}


def run(folder, *options):
    return subprocess.run(
        [
            sys.executable,
            "-P",
            "-m",
            "vtkhelios",
            "run",
            "survey.xml",
            "--pulses-per-block",
            "1000",
            *options,
        ],
        capture_output=True,
        text=True,
        cwd=folder,
        env={**os.environ, "PYTHONPATH": str(PACKAGE_DIR)},
        timeout=300,
    )


def digests(folder):
    return {
        path.name: hashlib.sha256(path.read_bytes()).hexdigest()
        for path in folder.iterdir()
        if path.name != "run_summary.json"
    }


@pytest.fixture
def disk(tmp_path):
    """A function that sets the size [KiB] of the folder "disk"."""
    (tmp_path / "survey.xml").write_text(SURVEY)
    (tmp_path / "scene.xml").write_text(SCENE)
    (tmp_path / "yard.obj").write_text(YARD)
    folder = tmp_path / "disk"
    folder.mkdir()
    if subprocess.run(
        ["mount", "-t", "tmpfs", "-o", "size=4k", "tmpfs", folder], check=False
    ).returncode:
        pytest.skip("no disk can be mounted here")

    def resize(kibibytes):
        subprocess.run(["mount", "-o", f"remount,size={kibibytes}k", folder], check=True)

    yield resize
    subprocess.run(["umount", folder], check=True)


@pytest.mark.parametrize("name", FORMATS)
def test_full_at_any_point(name, disk, tmp_path):
    options = [*FORMATS[name], "--output", "whole"]
    assert run(tmp_path, *options).returncode == 0
    truth = digests(tmp_path / "whole/yard")
    total = sum(path.stat().st_size for path in (tmp_path / "whole/yard").iterdir()) // 1024
    folder = tmp_path / "disk/yard"
    options = [*FORMATS[name], "--output", "disk"]
    for room in (8, 20, 48, total // 3, 2 * total // 3, total):
        disk(room)
        done = run(
            tmp_path,
            *options,
            *(["--resume"] if (folder / "run.journal").exists() else ["--overwrite"]),
        )
        assert done.returncode == 1, (room, done.stderr)
        assert (
            "No space left on device" in done.stderr
            and str(folder.relative_to(tmp_path)) in done.stderr
        )
        assert "room" in done.stderr or "another" in done.stderr, done.stderr
        assert "No such file" not in done.stderr and "Traceback" not in done.stderr, done.stderr
        assert not (folder / "run_summary.json").exists()
        for file, digest in digests(folder).items():
            assert file == "run.journal" or file.endswith(".part") or digest == truth[file], (
                room,
                file,
            )
    disk(4 * total + 1000)
    done = run(tmp_path, *options, "--resume", "--check-all")
    assert done.returncode == 0, done.stderr
    assert digests(folder) == truth
    summaries = [
        json.loads((each / "run_summary.json").read_text())
        for each in (folder, tmp_path / "whole/yard")
    ]
    assert all(summary.pop("timings") for summary in summaries)
    assert summaries[0] == summaries[1]
    for file in summaries[0]["legs"][0][
        "files"
    ]:  # files of LAS with its waveforms, of an index with its pieces
        path = folder / file["name"]
        stem = path.with_suffix("").name
        with_it = [
            each
            for each in folder.iterdir()
            if each == path or each.stem == stem or stem + "_0" in each.name
        ]
        assert file["bytes"] == sum(each.stat().st_size for each in with_it), file
