# SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
# SPDX-License-Identifier: BSD-3-Clause
"""The processor time of vtkhelios.scan_many(), over that of the pulses alone.

    build/venv/bin/python Testing/Benchmarks/many_scans.py [SCANS [PULSES [TRIANGLES]]]

Pulses alone: scans of one scene, whose tree is there. Many scenes: as many scenes as scans, whose trees
are built. A step: one scan of 16 pulses, the call with everything around them.
"""

import resource
import statistics
import sys
import time

import numpy as np

import vtkhelios

RATE = 289351.851851852  # pulses per second of the scanner
SCANNER = "velodyne_vlp16"


def make_scene(seed, triangles):
    """Returns rough ground with a mound."""
    cells = int((triangles / 2) ** 0.5)
    x, y = np.meshgrid(*[np.linspace(-30, 30, cells + 1)] * 2)
    random = np.random.default_rng(seed)
    mound = 3 * (np.hypot(x - 8, y - random.uniform(-5, 5)) < 2)
    points = np.column_stack(
        [x.ravel(), y.ravel(), (mound - 2 + 0.3 * random.random(x.shape)).ravel()]
    )
    ids = np.arange((cells + 1) ** 2).reshape(cells + 1, cells + 1)
    a, b, c, d = (part.ravel() for part in (ids[:-1, :-1], ids[:-1, 1:], ids[1:, 1:], ids[1:, :-1]))
    return vtkhelios.Scene(points, np.vstack([np.stack([a, b, c], 1), np.stack([a, c, d], 1)]))


def measure(sensor, scenes, poses):
    """Returns the processor time and the time of scans [s]."""
    used, begin = resource.getrusage(resource.RUSAGE_SELF), time.perf_counter()
    sensor.scan(scenes, poses)
    after = resource.getrusage(resource.RUSAGE_SELF)
    processor = after.ru_utime + after.ru_stime - used.ru_utime - used.ru_stime
    return processor, time.perf_counter() - begin


def main(scans=200, pulses=10_000, triangles=10_000):
    poses = np.zeros((scans, 3))
    poses[:, 0] = np.linspace(-5, 5, scans)
    scenes = [make_scene(number, triangles) for number in range(scans)]
    for words, options in (("adaptive", {}), ("one ray a pulse", {"sub_rays": 1})):
        sensor = vtkhelios.Sensor(SCANNER, scan_frequency=10, duration=pulses / RATE, **options)
        sensor.scan(scenes[0], poses)  # builds the trees
        alone = measure(sensor, scenes[0], poses)
        many = measure(sensor, scenes, poses)
        print(
            f"{words}: {1e3 * alone[0] / scans:.2f} ms of processor time a scan in one scene, "
            f"{1e3 * many[0] / scans:.2f} ms in many scenes, {many[0] / alone[0]:.2f} times; "
            f"{alone[1]:.2f} s and {many[1]:.2f} s in all"
        )
    robot = vtkhelios.Sensor(SCANNER, scan_frequency=10, duration=16 / RATE, sub_rays=1)
    steps = [measure(robot, scenes[0], pose) for pose in poses for _ in range(5)]
    print(f"a step of 16 pulses: {1e3 * statistics.median(wall for _, wall in steps):.3f} ms")


if __name__ == "__main__":
    main(*map(int, sys.argv[1:]))
