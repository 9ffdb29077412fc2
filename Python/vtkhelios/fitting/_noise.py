# SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
# SPDX-License-Identifier: BSD-3-Clause
"""Range noise on planes, by incidence and intensity; the threshold, and the echo separation.

A range error moves a point along its beam, so that the standard deviation normal to a plane is that
of the ranges times the cosine of the incidence. Planes are found within a strip, in cubes.
"""

import types

import numpy as np

from ..array_names import AMPLITUDE, GPS_TIME, INTENSITY, NUMBER_OF_RETURNS
from ..comparison._ground import box_of, cells_of, choose_cell
from ..comparison._planes import find_cells
from .result import Row

FEWEST = 10  # points of a plane
ENOUGH = 30  # planes of a row
INCIDENCES = np.arange(0.0, 90.0, 10.0)
QUARTERS = 4  # classes of the intensities
DRAWS = 200
LOWEST = 0.1  # percentile of intensities that counts as the smallest
BINS = 60  # bins of distances of echoes
LARGEST_CELL = 4.0  # [m]; surfaces are not planar over more


def find_planes(flight, strips):
    """Range noise [m], incidence [deg] and median intensity of the planes of all strips.

    strips: pairs of Pulses and Track.
    """
    parts = [_planes_of(flight, *strip) for strip in strips]
    return tuple(np.concatenate(each) for each in zip(*parts))


def _planes_of(flight, pulses, track):
    """Finds the planes of both grids of cubes: a plane counts in the grid in whose cube it is
    central."""
    single = np.ones(len(pulses), bool)
    if NUMBER_OF_RETURNS in flight:
        single = pulses.get(NUMBER_OF_RETURNS) == 1
    points, times = pulses.points[single], pulses.times[single]
    strength = _strength(flight, pulses)[single]
    parts = [(np.empty(0),) * 3]
    if len(points) >= FEWEST:
        size = min(choose_cell([points]), LARGEST_CELL)
        beams = points - track.at(times)
        beams /= np.linalg.norm(beams, axis=1, keepdims=True)
        parts += [_planes_of_grid(points, beams, strength, size, offset) for offset in (0.0, 0.5)]
    return tuple(np.concatenate(each) for each in zip(*parts))


def _planes_of_grid(points, beams, strength, size, offset):
    corner, shape = box_of([points], size)
    numbers = cells_of(points, size, corner, shape + 2, offset)
    _, index, counts = np.unique(numbers, return_inverse=True, return_counts=True)
    rows = np.flatnonzero(counts[index] >= FEWEST)
    if not len(rows):
        return (np.empty(0),) * 3
    side = types.SimpleNamespace(points=points, tiles=np.zeros(len(points), np.int64))
    cells = find_cells(side, rows, numbers, size, offset)
    _, index = np.unique(numbers[rows], return_inverse=True)
    count = len(cells.numbers)
    mean = np.column_stack([np.bincount(index, beams[rows, k], count) for k in range(3)])
    mean /= np.linalg.norm(mean, axis=1, keepdims=True)
    cosine = np.abs((mean * cells.normal).sum(axis=1))
    freedom = cells.counts - 3.0
    median = (1 - 2 / (9 * freedom)) ** 1.5  # median of chi over the root of the freedom
    noise = np.sqrt(cells.squares / freedom) / median / np.maximum(cosine, 1e-3)
    order = np.lexsort((strength[rows], index))
    middle = np.searchsorted(index[order], np.arange(count)) + cells.counts // 2
    good = cells.is_flat & cells.is_central & (cosine > 0.05)
    return (noise[good], np.degrees(np.arccos(np.minimum(cosine, 1.0)))[good],
            strength[rows][order][middle][good])  # fmt: skip


def _strength(flight, pulses):
    for name in (INTENSITY, AMPLITUDE):
        if name in flight:
            return pulses.get(name).astype(np.float64)
    return np.full(len(pulses), np.nan)


def most_frequent(values):
    """Returns the middle of the shortest interval with half of the values (the shorth; Andrews et
    al. 1972):
    half of the surfaces may be rough."""
    ordered = np.sort(values)
    half = len(ordered) // 2
    start = int(np.argmin(ordered[half:] - ordered[: len(ordered) - half]))
    return float(0.5 * (ordered[start] + ordered[start + half]))


def noise_with_error(values, random):
    """Returns the most frequent noise and the half width of its 95 % interval, by a bootstrap over
    planes."""
    draws = [most_frequent(random.choice(values, len(values))) for _ in range(DRAWS)]
    return most_frequent(values), float(2 * np.std(draws))


def noise_rows(noise, incidence, strength, random):
    """Returns the rows by incidence and by quarter of the intensity."""
    rows = []
    for low, high in zip(INCIDENCES, INCIDENCES[1:]):
        rows += _row("incidence", low, high, noise[(incidence >= low) & (incidence < high)], random)
    known = np.isfinite(strength)
    if known.any() and np.ptp(strength[known]) > 0:
        ends = np.unique(np.percentile(strength[known], np.linspace(0, 100, QUARTERS + 1)))
        for low, high in zip(ends, ends[1:]):
            inside = known & (strength >= low) & ((strength < high) | (high == ends[-1]))
            rows += _row("intensity", low, high, noise[inside], random)
    return rows


def _row(of, low, high, values, random):
    if len(values) < ENOUGH:
        return []
    return [Row(of, float(low), float(high), len(values), *noise_with_error(values, random))]


def find_threshold(flight):
    """The smallest intensities that are common (0.1 %), the array, and the smallest of all; or None."""
    for name in (INTENSITY, AMPLITUDE):
        if name in flight and np.ptp(flight[name]) > 0:
            values = flight[name].astype(np.float64)
            values = values[np.isfinite(values) & (values > 0)]
            if len(values):
                return float(np.percentile(values, LOWEST)), name, float(values.min())
    return None


def find_separation(flight, strips):
    """The distance of successive echoes of a pulse [m] from which on they are half as frequent as
    they are at most, and the number of pairs; or None."""
    found = []
    for pulses, _ in strips:
        times, points = flight[GPS_TIME][pulses.rows], flight["points"][pulses.rows]
        same = np.diff(times) == 0
        found.append(np.linalg.norm(np.diff(points, axis=0)[same], axis=1))
    found = np.concatenate(found)
    if len(found) < ENOUGH:
        return None
    bins = np.linspace(0.0, 3 * np.percentile(found, 20), BINS + 1)
    counts, _ = np.histogram(found, bins)
    first = int(np.argmax(counts >= 0.5 * counts.max()))
    return float(bins[first]), float(bins[1]), len(found)
