# SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
# SPDX-License-Identifier: BSD-3-Clause
"""The commands in README.md for new users work."""

import pathlib
import re

ROOT = pathlib.Path(__file__).resolve().parents[2]
README = (ROOT / "README.md").read_text()


def test_own_survey(command_line, tmp_path):
    for name in ("my_scene.xml", "my_survey.xml"):
        (tmp_path / name).write_text(
            re.search(rf"`{name}`:\n\n```xml\n(.*?)```", README, re.S).group(1)
        )
    (tmp_path / "my_yard.obj").write_text(
        "v -90 -90 0\nv 90 -90 0\nv 90 90 0\nv -90 90 0\nf 1 2 3 4\n"
    )
    done = command_line("run", "my_survey.xml", cwd=tmp_path)
    assert done.returncode == 0, done.stderr
    assert (tmp_path / "output/yard/leg000_points.xyz").is_file()


def test_named_files_exist():
    for name in re.findall(r"`((?:Apps|Testing|Python|Data)/[^`\s*]+|\w+\.md)`", README):
        assert (ROOT / name).exists(), name


def test_scripts_are_executable():
    for name in ("Apps/demo.sh", "Testing/run.sh", ".ci/run"):
        assert (ROOT / name).stat().st_mode & 0o111, name
