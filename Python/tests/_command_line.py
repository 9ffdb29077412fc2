# SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
# SPDX-License-Identifier: BSD-3-Clause
"""Shared by tests of the command line."""

import os
import re
import subprocess
import sys

# pulses of make_survey(): 0.5 s at 100 kHz, the mirror emits over 100 of 240 degrees
PULSES = 20_850


def expect_failure(done, message):
    assert done.returncode == 1, done
    assert re.search(message, done.stderr), done.stderr
    assert done.stderr.startswith("error: ") or "\nerror: " in done.stderr
    assert "Traceback" not in done.stderr and "0x" not in done.stderr


def start(survey, output, more=(), **options):
    environment = {**os.environ, "PYTHONPATH": ":".join(sys.path)}
    return subprocess.Popen(
        [
            sys.executable,
            "-P",
            "-m",
            "vtkhelios",
            "run",
            str(survey),
            "--output",
            str(output),
            *more,
        ],
        env=environment,
        **options,
    )
