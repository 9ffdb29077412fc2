# SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
# SPDX-License-Identifier: BSD-3-Clause
"""The commands in README.md for new users work. Testing/Install/readme.sh reads and runs them all."""

import importlib.util
import pathlib
import re
import shlex
import subprocess

ROOT = pathlib.Path(__file__).resolve().parents[2]
READER = ROOT / "Testing/Install/readme.sh"


def read_readme(*arguments):
    done = subprocess.run([READER, *arguments], capture_output=True, text=True, check=True)
    return done.stdout.splitlines()


def needs_no_display(command):
    kind = command.split()[1]
    return kind in ("new", "run", "plan", "convert", "report", "export") or "--html" in command


def test_first_scene(command_line, tmp_path):
    read_readme("--files", tmp_path)
    commands = [
        shlex.split(command)[1:]
        for command in read_readme("--commands")
        if re.search("my_|yard|street", command) and needs_no_display(command)
    ]
    kinds = [command[0] for command in commands]
    whole = ["new", "run", "run", "run", "view", "plan", "plan", "convert", "report", "export"]
    assert kinds == whole
    first = commands.index(["run", "my_survey.xml"])
    done = command_line(*commands[first], cwd=tmp_path)
    assert done.returncode == 0, done.stderr
    points = [
        [float(word) for word in line.split()[:3]]
        for line in (tmp_path / "output/yard/leg000_points.xyz").read_text().splitlines()
    ]
    assert any(abs(z) < 0.1 for x, y, z in points), "no echo from the ground"
    assert any(abs(y - 10) < 0.1 and z > 1 for x, y, z in points), "no echo from the wall"
    for command in commands[:first] + commands[first + 1 :]:
        if "yard.laz" in command and importlib.util.find_spec("lazrs") is None:
            continue
        display = ["--no-picture"] if command[0] == "plan" else []
        done = command_line(*command, *display, cwd=tmp_path)
        assert done.returncode == 0, done.stderr


def test_all_commands_are_read():
    commands = read_readme("--commands")
    assert commands[0] == "./Apps/demo.sh"
    others = [command.split()[:1] for command in commands[1:]]
    assert others == [["build/bin/vtkhelios"]] * len(others)


def test_scripts_are_executable():
    for name in (
        "Apps/demo.sh",
        "Testing/run.sh",
        "Testing/Install/clean_root.sh",
        "Testing/Install/readme.sh",
        ".ci/run",
    ):
        assert (ROOT / name).stat().st_mode & 0o111, name
