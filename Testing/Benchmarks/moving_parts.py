#!/usr/bin/env python3
# SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
# SPDX-License-Identifier: BSD-3-Clause
"""The cost of parts that move: a flight over them, moving over at rest.

    build/venv/bin/python Testing/Benchmarks/moving_parts.py [--parts 1 20 1000] [--triangles 100 10000]
        [--modes steps continuous] [--threads 1 2] [--sampling adaptive 19] [--program build/bin/vtkhelios]

Spheres stand on a ground of 20,000 triangles, and drive at 10 m/s: in steps of 10 ms, or
continuously. A run is repeated in turn with one at rest; the least seconds of each count, of the
pulses alone (run_s of run_summary.json). Checks that both have points, and that as many
pulses were fired. Prints a row per case: seconds at rest and moving, their ratio and that of the
processor's time, loading included, and memory [MB].
"""

import argparse
import itertools
import json
import math
import os
import pathlib
import subprocess
import sys
import tempfile

ASSETS = """<document>
<platform id="plane" type="linearpath"><scannerMount z="0.7">
<rot axis="x" angle_deg="-90"/><rot axis="z" angle_deg="90"/></scannerMount></platform>
<scanner id="als" optics="rotating" pulseFreqs_Hz="200000" scanAngleMax_deg="30"
 scanFreqMax_Hz="100" beamDivergence_rad="0.0005" accuracy_m="0.01">{quality}</scanner></document>"""
SURVEY = """<document><survey name="s" scene="scene.xml#s" platform="assets.xml#plane" scanner="assets.xml#als">
<leg><platformSettings x="-20" z="40" movePerSec_m="40"/>
<scannerSettings scanFreq_hz="100" scanAngle_deg="30"/></leg>
<leg><platformSettings x="20" z="40" movePerSec_m="40"/><scannerSettings active="false"/></leg>
</survey></document>"""
MOTION = '<dmotion loop="0"><motion type="translation" vec="0.1;0;0"/></dmotion>'
LENGTH = 30.0  # m: parts stand on [-LENGTH, LENGTH] / 2 both ways


def write_sphere(path, triangles):
    """Writes a sphere of radius 0.6 m on the ground."""
    rows = max(2, round(math.sqrt(triangles / 4) + 0.5))
    columns = 2 * rows
    lines = []
    for i in range(rows + 1):
        a = math.pi * i / rows
        for k in range(columns):
            b = 2 * math.pi * k / columns
            x, y, z = math.sin(a) * math.cos(b), math.sin(a) * math.sin(b), 1.0 - math.cos(a)
            lines.append(f"v {0.6 * x:.9f} {0.6 * y:.9f} {0.6 * z:.9f}")
    for i in range(rows):
        for k in range(columns):
            p, q = 1 + i * columns + k, 1 + i * columns + (k + 1) % columns
            if i < rows - 1:
                lines.append(f"f {p} {p + columns} {q + columns}")
            if i > 0:
                lines.append(f"f {p} {q + columns} {q}")
    path.write_text("\n".join(lines) + "\n")


def write_ground(path):
    """Writes 100 x 100 slightly uneven squares."""
    lines = []
    for i, k in itertools.product(range(101), repeat=2):
        lines.append(f"v {i - 50} {k - 50} {-0.05 + 0.02 * math.sin(i) * math.sin(1.3 * k):.6f}")
    for i, k in itertools.product(range(100), repeat=2):
        p = 1 + 101 * i + k
        lines.append(f"f {p} {p + 101} {p + 1}\nf {p + 1} {p + 101} {p + 102}")
    path.write_text("\n".join(lines) + "\n")


def write_scene(folder, parts, mode):
    """Writes a scene of parts that are at rest, or move."""
    attributes = 'dynTimeStep="0.01"' + (' motion="continuous"' if mode == "continuous" else "")
    side = math.ceil(math.sqrt(parts))
    lines = [
        f'<document><scene id="s" {attributes}><part id="ground"><filter type="objloader">'
        '<param type="string" key="filepath" value="ground.obj"/></filter></part>'
    ]
    for n in range(parts):
        x, y = (LENGTH * ((c + 0.5) / side - 0.5) for c in (n % side, n // side))
        lines.append(
            f'<part id="p{n}"><filter type="objloader"><param type="string" key="filepath" '
            'value="part.obj"/></filter><filter type="translate"><param type="vec3" key="offset" '
            f'value="{x};{y};0"/></filter>{MOTION if mode != "rest" else ""}</part>'
        )
    (folder / "scene.xml").write_text("\n".join(lines) + "</scene></document>")


def run(program, folder, threads):
    """Runs the survey; returns seconds of the pulses, of the processor in all, memory [MB], counts."""
    command = [
        *program,
        "run",
        str(folder / "survey.xml"),
        "--output",
        str(folder / "out"),
        "--overwrite",
        "--quiet",
    ]
    command += ["--threads", str(threads), "--no-accuracy-report"]
    process = subprocess.Popen(command, stdout=subprocess.DEVNULL, stderr=subprocess.PIPE)
    errors = process.stderr.read().decode()
    _, status, usage = os.wait4(process.pid, 0)
    if status:
        sys.exit(f"{' '.join(command)} failed:\n{errors}")
    summary = json.loads((folder / "out" / "s" / "run_summary.json").read_text())
    counts = {key: summary["totals"][key] for key in ("pulses", "points")}
    if not counts["points"] or not counts["pulses"]:
        sys.exit(f"{folder}: no points: {counts}")
    return (
        summary["timings"]["run_s"],
        usage.ru_utime + usage.ru_stime,
        usage.ru_maxrss / 1024,
        counts,
    )


def main():
    parser = argparse.ArgumentParser(
        description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter
    )
    parser.add_argument("--parts", type=int, nargs="+", default=[1, 20, 1000])
    parser.add_argument("--triangles", type=int, nargs="+", default=[100, 10000, 1000000])
    parser.add_argument("--modes", nargs="+", default=["steps", "continuous"])
    parser.add_argument("--threads", type=int, nargs="+", default=[1, 2])
    parser.add_argument("--sampling", nargs="+", default=["adaptive", "19"])
    parser.add_argument("--repeat", type=int, default=3)
    parser.add_argument("--program", nargs="+", default=["build/bin/vtkhelios"])
    given = parser.parse_args()
    print(
        "parts triangles mode       sampling threads   rest_s moving_s ratio (processor) rest_MB moving_MB"
    )
    for sampling, triangles, parts in itertools.product(
        given.sampling, given.triangles, given.parts
    ):
        with tempfile.TemporaryDirectory() as name:
            folder = pathlib.Path(name)
            write_sphere(folder / "part.obj", triangles)
            write_ground(folder / "ground.obj")
            quality = '<FWFSettings beamSampleQuality="3"/>' if sampling == "19" else ""
            (folder / "assets.xml").write_text(ASSETS.format(quality=quality))
            (folder / "survey.xml").write_text(SURVEY)
            for threads, mode in itertools.product(given.threads, given.modes):
                results = {"rest": [], mode: []}
                for _ in range(given.repeat):
                    for each in results:
                        write_scene(folder, parts, each)
                        results[each].append(run(given.program, folder, threads))
                if len({r[3]["pulses"] for rows in results.values() for r in rows}) != 1:
                    sys.exit(f"not all fired the same pulses: {results}")
                # the least of each column: what others do at the time only adds to it
                rest, moving = (
                    [min(column) for column in list(zip(*rows))[:3]] for rows in results.values()
                )
                print(
                    f"{parts:5} {triangles:9} {mode:10} {sampling:8} {threads:7} {rest[0]:8.3f} {moving[0]:8.3f} "
                    f"{moving[0] / rest[0]:5.2f} {moving[1] / rest[1]:11.2f} {rest[2]:7.0f} {moving[2]:9.0f}",
                    flush=True,
                )


if __name__ == "__main__":
    main()
