# SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
# SPDX-License-Identifier: BSD-3-Clause
"""The commands in README.md for new users work."""

import importlib.util
import pathlib
import re

ROOT = pathlib.Path(__file__).resolve().parents[2]
README = (ROOT / "README.md").read_text()


def test_first_scene(command_line, tmp_path):
    for name in ("my_yard.obj", "my_scene.xml", "my_survey.xml"):
        text = re.search(rf"`{name}`:\n\n```\w+\n(.*?)```", README, re.S).group(1)
        (tmp_path / name).write_text(text)
    done = command_line("run", "my_survey.xml", cwd=tmp_path)
    assert done.returncode == 0, done.stderr
    points = [
        [float(word) for word in line.split()[:3]]
        for line in (tmp_path / "output/yard/leg000_points.xyz").read_text().splitlines()
    ]
    assert any(abs(z) < 0.1 for x, y, z in points), "no echo from the ground"
    assert any(abs(y - 10) < 0.1 and z > 1 for x, y, z in points), "no echo from the wall"
    commands = re.findall(
        r"^build/bin/vtkhelios ((?:run|plan|convert|report|view .* --html) .*)$", README, re.M
    )
    assert len(commands) == 6
    for command in commands[1:]:
        if ".laz" in command and importlib.util.find_spec("lazrs") is None:
            continue
        display = ["--no-picture"] if command.startswith("plan") else []
        done = command_line(*command.split(), *display, cwd=tmp_path)
        assert done.returncode == 0, done.stderr


def test_scripts_are_executable():
    for name in ("Apps/demo.sh", "Testing/run.sh", ".ci/run"):
        assert (ROOT / name).stat().st_mode & 0o111, name
