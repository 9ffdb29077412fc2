# SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
# SPDX-License-Identifier: BSD-3-Clause
"""Every command ends by Ctrl-C and SIGTERM at any moment: one line, an exit code, no half file."""

import itertools

import pytest

from stopping.cases import CASES, LAUNCHER, SIGNALS, Stop, make_inputs

SHARES = (0.15, 0.4, 0.65, 0.9)  # shares of the life of a command
FIRST = (0.0, 0.01, 0.05, 0.1, 0.2)  # s, while it starts

pytestmark = pytest.mark.skipif(not LAUNCHER.is_file(), reason="the launcher is not built")


@pytest.fixture(scope="module")
def inputs(tmp_path_factory):
    folder = tmp_path_factory.mktemp("inputs")
    make_inputs(folder)
    return folder


def check(case, inputs, outputs, moments):
    """Stops a command at several moments, by both signals in turn."""
    for delay, number in zip(moments, itertools.cycle(SIGNALS)):
        stop = Stop(case, inputs, outputs, delay, number)
        if stop.seconds is None:
            assert stop.code == 0, stop.errors
            continue
        fault = stop.find_fault()
        assert fault is None, f"{case.name}, signal {number} after {delay:.2f} s: {fault}"


@pytest.mark.parametrize("case", CASES, ids=lambda case: case.name)
def test_stop(case, inputs, tmp_path):
    if need := case.missing():
        pytest.skip(f"{need} is missing")
    life = case.life
    if not life:
        whole = Stop(case, inputs, tmp_path / "out", 0, 0)
        assert whole.code == 0, whole.errors
        life = whole.life
    check(case, inputs, tmp_path / "out", [share * life for share in SHARES])


@pytest.mark.parametrize("case", [CASES[0], CASES[-1]], ids=lambda case: case.name)
def test_stop_while_it_starts(case, inputs, tmp_path):
    check(case, inputs, tmp_path / "out", [delay for delay in FIRST for _ in SIGNALS])
