#!/usr/bin/env python3
# SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
# SPDX-License-Identifier: BSD-3-Clause
"""Seconds from Ctrl-C or SIGTERM to the end, for every command and phase.

    build/venv/bin/python Testing/Benchmarks/stop_times.py [--large] [--moments N] [CASE ...]

Runs each command of Python/tests/stopping/cases.py again and again, sends it a signal at moments spread over
its life, and checks the exit code, the line, and that no half file and no process is left. Prints
median and maximum by what the command said it was doing, and of its first 0.35 s ("starting"). With
--large the inputs are a mesh of ten million triangles and scans of a million pulses.
"""

import argparse
import collections
import itertools
import pathlib
import re
import signal
import statistics
import sys
import tempfile

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[2] / "Python/tests"))
from stopping.cases import CASES, PROGRESS, SIGNALS, Stop, make_inputs  # noqa: E402  of the tests

STARTING = 0.35  # s
# The command line with a line of progress ten times a second.
PROGRAM = (
    "import sys; sys.argv[0] = 'vtkhelios'; from vtkhelios.cli import _progress, main; "
    "_progress.Lines.seconds_between = 0.1; sys.exit(main())"
)


def name_phase(stop):
    """Returns the last activity of the command, without names and numbers."""
    if stop.delay < STARTING:
        return "starting"
    lines = [line for line in stop.errors.splitlines() if PROGRESS.match(line)]
    if not lines:
        return "(nothing said)"
    text = re.sub(r"^ *\d+ % ", "", lines[-1])
    if re.match(r"leg \d+ of", text):
        return "pulses"
    if " points" in text:
        return "points"
    return re.split(r"[\d,/#]", text)[0].strip() or text


def measure(case, inputs, outputs, moments):
    """Prints the lines of a case; returns the number of faults."""
    # environment that the launcher sets
    blocked = ["env", "--block-signal=INT", "--block-signal=TERM"]
    program = [*blocked, sys.executable, "-P", "-c", PROGRAM]
    life = case.life
    if not life:
        whole = Stop(case, inputs, outputs, 0, 0, program)
        if whole.code:
            print(f"{case.name}: exit code {whole.code}: {whole.errors[-500:]}")
            return 1
        life = whole.life
    seconds, faults = collections.defaultdict(lambda: ([], [])), []
    starts = [STARTING * k / moments for k in range(moments)]
    for index, delay in enumerate(starts + [life * (k + 0.5) / moments for k in range(moments)]):
        for which, number in enumerate(SIGNALS):
            stop = Stop(case, inputs, outputs, delay, number, None if index < moments else program)
            if stop.seconds is not None:
                seconds[name_phase(stop)][which].append(stop.seconds)
                faults += filter(None, [stop.find_fault()])
    for phase, both in seconds.items():
        print(f"{case.name:24} {life:7.1f}  {phase[:36]:36} {len(sum(both, [])):4d}   "
              + "   ".join(f"{statistics.median(each):5.2f} {max(each):5.2f}" if each else "    -     -"
                           for each in both), flush=True)  # fmt: skip
    for fault, found in itertools.groupby(sorted(faults)):
        print(f"  FAULT ({len(list(found))}): {fault}")
    return len(faults)


def main():
    parser = argparse.ArgumentParser(description=__doc__.split("\n")[0])
    parser.add_argument("cases", metavar="CASE", nargs="*", help="their names (default: all)")
    parser.add_argument("--large", action="store_true", help="large inputs")
    parser.add_argument("--moments", metavar="N", type=int, default=8, help="of each, and signal")
    arguments = parser.parse_args()
    print(
        f"{'command':24} {'life s':>7}  {'phase':36} {'n':>4}   {'SIGINT p50 max':11} {'SIGTERM p50 max':11}"
    )
    signal.signal(signal.SIGINT, signal.default_int_handler)  # a shell may ignore it for its jobs
    faults = 0
    with tempfile.TemporaryDirectory() as name:
        inputs, outputs = pathlib.Path(name, "in"), pathlib.Path(name, "out")
        inputs.mkdir()
        make_inputs(inputs, *((10.0, 2240) if arguments.large else ()))
        for case in CASES:
            if case.missing() or (arguments.cases and case.name not in arguments.cases):
                continue
            faults += measure(case, inputs, outputs, arguments.moments)
    return 1 if faults else 0


if __name__ == "__main__":
    sys.exit(main())
