# SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
# SPDX-License-Identifier: BSD-3-Clause
"""The beam divergence, by pulses that are divided at sharp edges.

Along a scan line over the edge of a roof, pulses hit the roof, then roof and ground, then the
ground. A pulse is divided if the edge is within its footprint, so that the mean number of divided
pulses at an edge is the width of the footprint over the step from pulse to pulse. Objects of few
pulses give too small a width: they have no place for three whole pulses and a divided one.
"""

import numpy as np

from ..array_names import NUMBER_OF_RETURNS

JUMP = 2.5  # smallest height of an edge [m]
BESIDE = 3  # pulses on either side, with one return each
FLAT = 0.1  # largest second difference of their heights [m]
MOST = 3  # divided pulses at an edge
ENOUGH, DIVIDED = 50, 20  # edges, and those with divided pulses
CHORD = np.pi / 2  # mean of the step over that normal to the edge, for edges of all directions


def find_footprint(pulses, ranges, period):
    """Width of the part of the beam that gives echoes over the range [rad], its uncertainty, and the
    number of edges; or None: there are too few."""
    returns = pulses.get(NUMBER_OF_RETURNS)
    if returns is None:
        return None
    height, times = pulses.points[:, 2], pulses.times
    plain = returns == 1
    size = len(height)
    divided, steps, far = [], [], []
    for between in range(MOST + 1):
        first = np.arange(0, size - 2 * BESIDE - between)
        left, right = first + BESIDE - 1, first + BESIDE + between
        good = np.abs(height[left] - height[right]) >= JUMP
        first, left, right = (each[good] for each in (first, left, right))
        span = 2 * BESIDE + between - 1
        good = times[first + span] - times[first] < (span + 0.7) * period
        for k in range(BESIDE):
            good &= plain[first + k] & plain[right + k]
        for k in range(between):
            good &= returns[left + 1 + k] == 2
            good &= _is_between(pulses, left, right, left + 1 + k)
        for start in (first, right):
            good &= np.abs(np.diff(height[start[:, None] + np.arange(3)], 2, axis=1)[:, 0]) < FLAT
        first, left, right = (each[good] for each in (first, left, right))
        divided.append(np.full(len(first), between))
        steps.append(_step_of(pulses, first, right))
        far.append(ranges[left])
    divided, steps, far = (np.concatenate(each) for each in (divided, steps, far))
    if len(divided) < ENOUGH or np.count_nonzero(divided) < DIVIDED:
        return None
    width = divided.mean() * np.median(steps) / CHORD
    error = 2 * divided.std() / np.sqrt(len(divided)) * np.median(steps) / CHORD
    distance = np.median(far)
    return float(width / distance), float(error / distance), len(divided)


def _is_between(pulses, left, right, row):
    """Returns whether the returns of a divided pulse are on both levels."""
    height = pulses.points[:, 2]
    top, low = np.maximum(height[left], height[right]), np.minimum(height[left], height[right])
    return (np.abs(height[row] - top) < 0.5) & (np.abs(pulses.last[row, 2] - low) < 0.5)


def _step_of(pulses, first, right):
    """Returns the mean distance of successive pulses on either side, in plan view [m]."""
    plan = pulses.points[:, :2]
    steps = [np.linalg.norm(plan[start + 1] - plan[start], axis=1) for start in (first, right)]
    return 0.5 * (steps[0] + steps[1])
