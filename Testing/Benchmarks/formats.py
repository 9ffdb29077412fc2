# SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
# SPDX-License-Identifier: BSD-3-Clause
"""Speed of point conversion, against bare laspy and lazrs.

    build/venv/bin/python Testing/Benchmarks/formats.py [MILLIONS]

Prints M points/s, CPU seconds per million points, and the peak memory of each conversion, which
runs in its own process, after comparing the points; the best of three. Default of MILLIONS: 3. The
ratios also use processor time, which a busy machine changes less.
"""

import argparse
import pathlib
import resource
import subprocess
import sys
import tempfile
import time

import numpy as np

REPEATS = 3


def make_chunk(count, seed):
    random = np.random.default_rng(seed)
    xyz = random.uniform(0, 500, (count, 3)) + [476000.0, 5473000.0, 100.0]
    xyz[:, 0] = np.sort(xyz[:, 0])  # order along a flight
    return {
        "points": np.round(xyz, 4),
        "GpsTime": np.arange(count) * 2e-6 + seed,
        "PulseIds": np.arange(count, dtype=np.int64) + seed * count,
        "ReturnNumber": np.ones(count, np.uint8),
        "NumberOfReturns": np.ones(count, np.uint8),
        "Range": random.uniform(290, 340, count),
        "Amplitude": random.uniform(1e-9, 1e-7, count),
        "EchoWidth": random.normal(4.0, 0.01, count),
        "ScanAngle": random.uniform(-30, 30, count),
        "ClassificationIds": random.integers(1, 7, count).astype(np.int32),
        "LegIds": np.zeros(count, np.int32),
    }


def work(what, source, target):
    """One conversion; prints its seconds and memory."""
    from vtkhelios import cli, formats

    if what == "laspy":
        import laspy

        start, begun = time.monotonic(), processor()
        with laspy.open(source) as reader:
            with laspy.open(target, "w", header=reader.header, do_compress=True) as writer:
                for points in reader.chunk_iterator(500_000):
                    writer.write_points(points)
    elif what == "arrays":
        with formats.open_reader(source) as reader:
            chunks, header = [dict(chunk) for chunk in reader.chunks()], reader.header
        start, begun = time.monotonic(), processor()
        with formats.open_writer(target, header) as writer:
            for chunk in chunks:
                writer.write(chunk)
    elif what == "records":
        import laspy

        with laspy.open(source) as reader:
            header = reader.header
            chunks = list(reader.chunk_iterator(500_000))
        start, begun = time.monotonic(), processor()
        with laspy.open(target, "w", header=header, do_compress=True) as writer:
            for points in chunks:
                writer.write_points(points)
    else:
        start, begun = time.monotonic(), processor()
        assert cli.main(["convert", source, target, "--quiet", "--overwrite"]) == 0
    wall, spent = time.monotonic() - start, processor() - begun
    print(wall, spent, resource.getrusage(resource.RUSAGE_SELF).ru_maxrss / 1024)


def processor():
    """Seconds of all threads."""
    usage = resource.getrusage(resource.RUSAGE_SELF)
    return usage.ru_utime + usage.ru_stime


def run(what, source, target):
    best = None
    for _ in range(REPEATS):
        pathlib.Path(target).unlink(missing_ok=True)
        done = subprocess.run([sys.executable, __file__, "--work", what, source, target],
                              capture_output=True, text=True, check=True)  # fmt: skip
        told = tuple(map(float, done.stdout.split()))
        best = tuple(map(min, best or told, told))
    check(source, target)
    return best


def check(source, target):
    """Checks that two files have the same points, in some order."""
    from vtkhelios import formats

    sums = []
    for path in (source, target):
        with formats.open_reader(path) as reader:
            total = np.zeros(3)
            count = 0
            for chunk in reader.chunks():
                total += (chunk["points"] - [476000.0, 5473000.0, 100.0]).sum(axis=0)
                count += len(chunk["points"])
        sums.append((count, *total))
    assert np.allclose(*sums, rtol=1e-6), (source, target, sums)


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("millions", nargs="?", type=float, default=3.0)
    parser.add_argument("--work", nargs=3, help=argparse.SUPPRESS)
    arguments = parser.parse_args()
    if arguments.work:
        work(*arguments.work)
        return
    from vtkhelios import formats

    count = int(1e6 * arguments.millions)
    with tempfile.TemporaryDirectory() as folder:
        start = f"{folder}/start.pvtp"
        with formats.open_writer(start) as writer:
            for seed in range(-(-count // 500_000)):
                writer.write(make_chunk(min(500_000, count - seed * 500_000), seed))
        cases = [
            ("arrays to LAS", "arrays", "start.pvtp", "a.las"),
            ("pvtp to LAS", "convert", "start.pvtp", "b.las"),
            ("LAS to LAZ", "convert", "b.las", "c.laz"),
            ("LAS to LAZ, bare laspy", "laspy", "b.las", "d.laz"),
            ("arrays to LAZ", "arrays", "start.pvtp", "e.laz"),
            ("records to LAZ, bare laspy", "records", "b.las", "f.laz"),
            ("LAZ to LAS", "convert", "c.laz", "g.las"),
            ("LAZ to PLY", "convert", "c.laz", "h.ply"),
            ("LAS to text", "convert", "b.las", "i.xyz"),
            ("text to LAS", "convert", "i.xyz", "j.las"),
            ("LAS to E57", "convert", "b.las", "k.e57"),
            ("LAS to COPC", "convert", "b.las", "l.copc.laz"),
        ]
        times = {}
        for name, what, source, target in cases:
            seconds, spent, memory = run(what, f"{folder}/{source}", f"{folder}/{target}")
            times[name] = seconds, spent
            print(f"{name:28} {count / seconds / 1e6:7.2f} M points/s "
                  f"{1e6 * spent / count:7.2f} s/M {memory:8.0f} MB", flush=True)  # fmt: skip
        for ours, bare in (("LAS to LAZ", "LAS to LAZ, bare laspy"),
                           ("arrays to LAZ", "records to LAZ, bare laspy")):  # fmt: skip
            ratios = [100 * b / a for a, b in zip(times[ours], times[bare])]
            print(f"{ours}: {ratios[0]:.0f} % of {bare}, {ratios[1]:.0f} % by processor time")


if __name__ == "__main__":
    main()
