# SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
# SPDX-License-Identifier: BSD-3-Clause
"""Slowdown of a survey by its viewer window.

    xvfb-run -a build/venv/bin/python Testing/Benchmarks/viewer.py SURVEY.xml SCENE-FOLDER [TIMES]

Runs a survey in the viewer to the end, alternately in a window (under Xvfb: the software rasteriser
uses the same processors) and without drawing, TIMES times (default: 3). Prints the computing time
of the pulse blocks [s], of each run and their medians, and the ratio of the medians; first it
checks that both computed the same pulses and number of points.
"""

import json
import os
import pathlib
import statistics
import subprocess
import sys
import tempfile
import time

from vtkhelios.cli import view


def is_over(time_shown):
    """Returns whether all echoes have arrived, or none can arrive."""
    phase, computed, end = (time_shown[name] for name in ("phase", "computed", "end"))
    return phase == "failed" or (phase == "finished" and computed >= end)


def run(survey, scene, folder, draws):
    """The state of a viewer at the end of the survey."""
    state_file = pathlib.Path(folder) / "state.json"
    state_file.unlink(missing_ok=True)
    words = [survey, "--assets", scene, "--state", str(state_file)]
    words += [] if draws else ["--offscreen", "--still", f"{folder}/still.png"]
    viewer = subprocess.Popen(view.command(view.find_viewer(), words, os.environ))
    state = None
    while not (state and is_over(state["time"])):
        time.sleep(0.1)
        state = json.loads(state_file.read_text()) if state_file.exists() else None
        if viewer.poll() is not None and not state:
            sys.exit("the viewer ended unexpectedly")
    viewer.terminate()
    viewer.wait()
    return state


def main(arguments):
    if len(arguments) < 2:
        print(__doc__.strip(), file=sys.stderr)
        return 2
    times = int(arguments[2]) if len(arguments) > 2 else 3
    seconds = {True: [], False: []}
    with tempfile.TemporaryDirectory() as folder:
        for _ in range(times):
            states = {draws: run(*arguments[:2], folder, draws) for draws in (True, False)}
            if states[True]["time"]["pulses"] != states[False]["time"]["pulses"]:
                sys.exit("the runs differ in their pulses")
            for draws, state in states.items():
                seconds[draws].append(state["time"]["computingSeconds"])
                print(
                    f"{'window' if draws else 'alone ':6}  {seconds[draws][-1]:.2f} s", flush=True
                )
    window, alone = (statistics.median(seconds[draws]) for draws in (True, False))
    print(f"medians: window {window:.2f} s, alone {alone:.2f} s, ratio {window / alone:.3f}")
    return 0


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
