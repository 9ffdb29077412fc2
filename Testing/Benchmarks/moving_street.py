#!/usr/bin/env python3
# SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
# SPDX-License-Identifier: BSD-3-Clause
"""A street of 22 M triangles of which 9 M move, scanned from a car by a head of 128 beams.

    build/venv/bin/python Testing/Benchmarks/moving_street.py [--seconds 10] [--threads 1 2]
        [--sampling single adaptive] [--modes rest continuous] [--cars 200] [--program build/bin/vtkhelios]

Road and houses are a mesh of 3 M triangles, 100 trees of 100,000 triangles have 5 models. 200 cars
of 41,000 triangles (5 models) drive along trajectories at 8 to 13 m/s in four lanes; each carries four wheels of
1,000 triangles, which turn: 1,000 parts that move. The head is an Ouster OS1-128 at 10 Hz of 1024
columns (1.31 M pulses/s) on a car at 7 m/s. Sampling: single rays, or the default accuracy.

Each case is a run, at rest and moving, and one of 0.01 s of the sensor, whose time is that of the start:
loading and trees. Checks the number of triangles and pulses, that no echo is below the road or above the
houses, and that about as many are on cars at rest as on those that drive. Prints a row per case: pulses,
echoes, their share on cars, seconds of the start and of the pulses after it, peak memory [MB], and
pulses (rays, if each is one) a second, and a second of the processor; then moving over at rest.
"""

import argparse
import itertools
import json
import os
import pathlib
import subprocess
import sys
import tempfile

import laspy
import numpy as np

LENGTH = 600.0  # length of the street [m]
HALF = 8.0  # half the width of the road, with its sidewalks [m]
LANES = ((-5.25, 1, 13.0), (-1.75, 1, 8.0), (1.75, -1, 10.0), (5.25, -1, 12.0))  # y, way, speed
WHEEL = 0.33  # radius [m]
START = 0.01  # window of a run whose time is that of loading and building [s]
COLUMNS, BEAMS, RATE = 1024, 128, 10  # columns and beams of the head; revolutions/s
FILES = 'tIndex="0" rollIndex="1" pitchIndex="2" yawIndex="3" xIndex="4" yIndex="5" zIndex="6"'


def write_ply(path, points, triangles):
    """Writes triangles as a binary PLY."""
    header = (
        f"ply\nformat binary_little_endian 1.0\nelement vertex {len(points)}\n"
        "property double x\nproperty double y\nproperty double z\n"
        f"element face {len(triangles)}\nproperty list uchar int vertex_indices\nend_header\n"
    )
    faces = np.empty(len(triangles), dtype=[("n", "u1"), ("corners", "<i4", 3)])
    faces["n"], faces["corners"] = 3, triangles
    with open(path, "wb") as file:
        file.write(header.encode())
        file.write(np.ascontiguousarray(points, "<f8").tobytes() + faces.tobytes())
    return len(triangles)


def make_grid(rows, columns):
    """Returns the triangles of a grid of rows x columns quadrangles."""
    corner = np.arange(rows * (columns + 1)).reshape(rows, columns + 1)[:, :-1].ravel()
    above = corner + columns + 1
    return np.concatenate(
        [np.stack([corner, corner + 1, above + 1], 1), np.stack([corner, above + 1, above], 1)]
    )


def write_sheet(path, rows, columns, shape):
    """Writes a sheet: shape(u, v) gives its points for u, v of [0, 1]."""
    v, u = np.meshgrid(np.linspace(0, 1, rows + 1), np.linspace(0, 1, columns + 1), indexing="ij")
    points = np.stack([x + 0 * u for x in shape(u, v)], -1).reshape(-1, 3)
    return write_ply(path, points, make_grid(rows, columns))


def write_body(path, triangles, size, power):
    """Writes a superellipsoid of a size [m], on its lowest point."""
    columns = 2 * round(np.sqrt(triangles / 4))
    rows = round(triangles / 2 / columns)

    def shape(u, v):
        def bend(x):
            return np.sign(x) * np.abs(x) ** power

        a, b = 2 * np.pi * u, np.pi * (v - 0.5)
        across = bend(np.cos(b))
        return [
            0.5 * s * x
            for s, x in zip(
                size, (across * bend(np.cos(a)), across * bend(np.sin(a)), 1 + bend(np.sin(b)))
            )
        ]

    return write_sheet(path, rows, columns, shape)


def write_tree(path, triangles, random):
    """Writes a tree of single leaves in a ball."""
    middle = random.normal(size=(triangles, 1, 3))
    middle *= (
        2.2
        * np.cbrt(random.uniform(size=(triangles, 1, 1)))
        / np.linalg.norm(middle, axis=2, keepdims=True)
    )
    points = middle + (0, 0, 5.0) + random.uniform(-0.05, 0.05, size=(triangles, 3, 3))
    return write_ply(path, points.reshape(-1, 3), np.arange(3 * triangles).reshape(-1, 3))


def write_geometry(folder):
    """Writes the meshes; returns the triangles of each."""
    random = np.random.default_rng(1)
    count = {
        "road": write_sheet(
            folder / "road.ply",
            100,
            5000,
            lambda u, v: (
                LENGTH * (u - 0.5),
                2 * HALF * (v - 0.5),
                0.01 * np.sin(300 * u) * np.sin(7 * v),
            ),
        )
    }
    for side in (-1, 1):
        count[f"houses{side}"] = write_sheet(
            folder / f"houses{side}.ply",
            100,
            5000,
            lambda u, v, side=side: (
                LENGTH * (u - 0.5),
                side * (HALF + 2.0 + 0.2 * (np.sin(400 * u) > 0) * (np.sin(25 * v) > 0)),
                12.0 * v,
            ),
        )
    for k in range(5):
        count[f"car{k}"] = write_body(
            folder / f"car{k}.ply", 41000, (1.8, 4.2 + 0.1 * k, 1.2 + 0.1 * k), 0.3 + 0.1 * k
        )
        count[f"tree{k}"] = write_tree(folder / f"tree{k}.ply", 100000, random)
    count["wheel"] = write_body(folder / "wheel.ply", 1000, (0.2, 2 * WHEEL, 2 * WHEEL), 0.8)
    return count


def write_track(path, x, y, way, speed, seconds):
    """Writes a trajectory straight on: t, roll, pitch, yaw clockwise from north, x, y, z."""
    lines = [
        f"{t:.1f}, 0, 0, {90 * way}, {x + way * speed * t:.4f}, {y}, 0"
        for t in np.arange(0.0, seconds + 0.25, 0.1)
    ]
    path.write_text('#HEADER: "t", "roll", "pitch", "yaw", "x", "y", "z"\n' + "\n".join(lines))


def make_part(name, file, place=None, turn=0.0, inside="", mount=""):
    """Returns a part of a file."""
    lines = [
        f'<part id="{name}"{mount}><filter type="plyloader"><param type="string" key="filepath" '
        f'value="{file}.ply"/></filter>'
    ]
    if turn:
        lines.append(
            '<filter type="rotate"><param key="rotation" type="rotation"><rot axis="z" '
            f'angle_deg="{turn}"/></param></filter>'
        )
    if place:
        offset = ";".join(f"{x:.4f}" for x in place)
        lines.append(
            f'<filter type="translate"><param type="vec3" key="offset" value="{offset}"/></filter>'
        )
    return "".join(lines) + inside + "</part>"


def get_start(k, cars):
    """Returns the x of a car at the start."""
    return LENGTH * ((k // 4 + 0.5) / -(-cars // 4) - 0.5)


def write_scene(folder, cars, moves):
    """Writes the scene; returns the files of its parts."""
    parts = [("road", "road"), ("houses-1", "houses-1"), ("houses1", "houses1")]
    texts = [make_part(*part) for part in parts]
    files = [file for _, file in parts]
    for k in range(100):
        x, side = LENGTH * ((k // 2 + 0.5) / 50 - 0.5), 1 if k % 2 else -1
        texts.append(make_part(f"tree{k}", f"tree{k % 5}", (x, side * HALF, 0.0), 36.0 * k))
        files.append(f"tree{k % 5}")
    for k in range(cars):
        y, way, speed = LANES[k % 4]
        x, file = get_start(k, cars), f"car{k % 5}"
        place, turn = ((x, y, 0.15), -90.0 * way) if not moves else ((0.0, 0.0, 0.15), 0.0)
        track = f'<trajectory file="track{k}.csv" {FILES}/>'
        texts.append(make_part(f"car{k}", file, place, turn, track if moves else ""))
        files.append(file)
        for n, (right, forward) in enumerate(itertools.product((-0.75, 0.75), (-1.3, 1.3))):
            place = (right, forward, 0.0)
            roll, mount = "", ""
            if moves:
                angle = np.degrees(0.01 * speed / WHEEL)
                roll = (
                    f'<dmotion loop="0"><motion type="rotation" axis="-1;0;0" angle="{angle:.4f}" '
                    'selfMode="true"/></dmotion>'
                )
                mount = f' mount="car{k}"'
            else:
                place = (x + way * forward, y - way * right, 0.0)
            texts.append(make_part(f"car{k}wheel{n}", "wheel", place, turn, roll, mount))
            files.append("wheel")
    text = "\n".join(texts)
    (folder / "scene.xml").write_text(
        f'<document><scene id="s" dynTimeStep="0.01" motion="continuous">\n{text}\n</scene></document>'
    )
    return files


def write_survey(folder, seconds):
    """Writes the survey of the head on a car."""
    (folder / "platform.xml").write_text(
        '<document><platform id="car" type="linearpath"><scannerMount z="2.2"/></platform></document>'
    )
    (folder / "survey.xml").write_text(
        '<document><survey name="s" scene="scene.xml#s" platform="interpolated" '
        'basePlatform="platform.xml#car" scanner="instruments/ouster.xml#ouster_os1_128"><leg>'
        f'<platformSettings trajectory="head.csv" {FILES} tEnd="{seconds}"/>'
        f'<scannerSettings active="true" pulseFreq_hz="{COLUMNS * BEAMS * RATE}" '
        f'scanFreq_hz="{RATE}" trajectoryTimeInterval_s="0.1"/></leg></survey></document>'
    )
    write_track(folder / "head.csv", -3.5 * seconds, -1.75, 1, 7.0, seconds)


def run(given, folder, threads, sampling):
    """Runs the survey; returns its counts, seconds, those of the processor, and peak memory [MB]."""
    output = folder / "out"
    command = [*given.program, "run", str(folder / "survey.xml"), "--output", str(output)]
    command += ["--overwrite", "--quiet", "--threads", str(threads), "--no-accuracy-report"]
    command += ["--no-noise", "--format", "las"] + (
        ["--sub-rays", "1"] if sampling == "single" else []
    )
    process = subprocess.Popen(command, stdout=subprocess.DEVNULL, stderr=subprocess.PIPE)
    errors = process.stderr.read().decode()
    _, status, usage = os.wait4(process.pid, 0)
    if status:
        sys.exit(f"{' '.join(command)} failed:\n{errors}")
    summary = json.loads((output / "s" / "run_summary.json").read_text())
    return {
        "totals": summary["totals"],
        "seconds": summary["timings"]["load_s"] + summary["timings"]["run_s"],
        "processor": usage.ru_utime + usage.ru_stime,
        "memory": usage.ru_maxrss / 1024,
    }


def count_on_cars(folder, cars):
    """Returns the share of the echoes that are on cars or wheels; checks where all are."""
    path = next((folder / "out" / "s").glob("*.las"))
    with laspy.open(path) as file:
        points = file.read()
    z = np.asarray(points.z)
    if z.min() < -0.05 or z.max() > 12.1:
        sys.exit(f"echoes from {z.min()} m to {z.max()} m: below the road, or above the houses")
    first = 103  # road, houses and trees
    parts = np.asarray(points["PartIds"])
    if parts.max() >= first + 5 * cars:
        sys.exit(f"there is no part {parts.max()}")
    return np.mean(parts >= first)


def main():
    parser = argparse.ArgumentParser(
        description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter
    )
    parser.add_argument("--seconds", type=float, default=10.0)
    parser.add_argument("--cars", type=int, default=200)
    parser.add_argument("--threads", type=int, nargs="+", default=[1, 2])
    parser.add_argument("--sampling", nargs="+", default=["single", "adaptive"])
    parser.add_argument("--modes", nargs="+", default=["rest", "continuous"])
    parser.add_argument("--program", nargs="+", default=["build/bin/vtkhelios"])
    parser.add_argument("--folder", type=pathlib.Path, help="keeps the scene there")
    given = parser.parse_args()
    with tempfile.TemporaryDirectory() as name:
        measure(given, given.folder or pathlib.Path(name))


def measure(given, folder):
    """Runs all cases."""
    folder.mkdir(exist_ok=True)
    count = write_geometry(folder)
    for k in range(given.cars):
        y, way, speed = LANES[k % 4]
        write_track(
            folder / f"track{k}.csv", get_start(k, given.cars), y, way, speed, given.seconds
        )
    files = write_scene(folder, given.cars, True)
    moving = sum(count[file] for file in files if file.startswith(("car", "wheel")))
    print(f"{sum(count[file] for file in files)} triangles, of which {moving} move")
    print(
        "sampling threads mode        pulses   echoes on_cars start_s pulses_s peak_MB  Mpulse/s   "
        "Mray/s (a second of the processor)"
    )
    for sampling, threads in itertools.product(given.sampling, given.threads):
        shares, costs = [], []
        for mode in given.modes:
            write_scene(folder, given.cars, mode != "rest")
            write_survey(folder, START)
            start = run(given, folder, threads, sampling)
            write_survey(folder, given.seconds)
            whole = run(given, folder, threads, sampling)
            totals = whole["totals"]
            if totals["pulses"] != round(given.seconds * COLUMNS * BEAMS * RATE):
                sys.exit(f"{totals['pulses']} pulses")
            shares.append(count_on_cars(folder, given.cars))
            seconds, processor = (whole[key] - start[key] for key in ("seconds", "processor"))
            costs.append(processor)
            pulses = 1e-6 * (totals["pulses"] - start["totals"]["pulses"])
            rays = pulses * (1.0 if sampling == "single" else np.nan)
            print(
                f"{sampling:8} {threads:7} {mode:10} {totals['pulses']:8} {totals['points']:8} "
                f"{shares[-1]:7.3f} {start['seconds']:7.1f} {seconds:8.1f} {whole['memory']:7.0f} "
                f"{pulses / seconds:9.2f} {rays / seconds:8.2f} "
                f"({pulses / processor:.2f}, {rays / processor:.2f})",
                flush=True,
            )
        if max(shares) > 2.0 * min(shares):
            sys.exit(f"shares of the echoes on cars: {shares}")
        print(
            f"processor time of the pulses, {given.modes[-1]} over {given.modes[0]}: "
            f"{costs[-1] / costs[0]:.2f}",
            flush=True,
        )


if __name__ == "__main__":
    main()
