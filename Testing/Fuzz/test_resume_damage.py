# SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
# SPDX-License-Identifier: BSD-3-Clause
"""A short campaign of resume.py: killed runs, damaged journals and files."""

import os
import pathlib
import re
import subprocess
import sys

import vtkhelios

PACKAGE_DIR = pathlib.Path(vtkhelios.__file__).absolute().parents[1]
PROGRAM = pathlib.Path(__file__).with_name("resume.py")


def test_damaged_runs_are_resumed_correctly_or_refused():
    done = subprocess.run(
        [sys.executable, "-P", PROGRAM, "--kills", "8", "--cases", "400"],
        capture_output=True,
        text=True,
        env={**os.environ, "PYTHONPATH": str(PACKAGE_DIR)},
        timeout=900,
    )
    assert done.returncode == 0, done.stdout + done.stderr
    figures = {
        what: int(count) for count, what in re.findall(r"^ *(\d+)  (.+)$", done.stdout, re.M)
    }
    assert figures["undamaged right"] >= 4
    for kind in ("journal", "part", "whole", "finished"):
        assert figures[f"{kind} damaged error"] > 10
    assert figures["journal damaged right"] > 10
    assert "0 wrong outcomes" in done.stdout
