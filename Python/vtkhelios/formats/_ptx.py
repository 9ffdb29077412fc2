# SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
# SPDX-License-Identifier: BSD-3-Clause
"""The pulses of PTX without a return: rows 0 0 0 of the grid of a scan."""

import itertools

import numpy as np

from ._base import ROWS, FormatError, check_file

HEAD = 8  # lines after the numbers of columns and rows


def read_misses(path, index, turn):
    """Yields the directions (n x 3) of the pulses of a scan without a return.

    Columns have one azimuth and rows one elevation, those of their points in the frame of the
    scanner; without points they are between their neighbours. turn is the rotation to the world.
    """
    points, columns, rows = _read_grid(path, index)
    has = (points != 0).any(axis=1).reshape(columns, rows)
    if has.all() or not has.any():
        return
    with np.errstate(invalid="ignore", divide="ignore"):
        ways = points / np.linalg.norm(points, axis=1)[:, None]
    ways = ways.reshape(columns, rows, 3)
    azimuth = _fill(_mean_angles(ways, has), has.any(axis=1), 2 * np.pi)
    heights = np.where(has, np.arcsin(np.clip(ways[..., 2], -1, 1)), 0).sum(axis=0)
    with np.errstate(invalid="ignore"):
        elevation = _fill(heights / has.sum(axis=0), has.any(axis=0), None)
    column, row = np.nonzero(~has)
    flat = np.cos(elevation[row])
    local = np.column_stack([
        flat * np.cos(azimuth[column]), flat * np.sin(azimuth[column]), np.sin(elevation[row])
    ])  # fmt: skip
    yield local @ turn.T


def _mean_angles(ways, has):
    """Returns the mean azimuth of each column, by the sum of its directions."""
    sums = np.where(has[..., None], ways, 0)[..., :2].sum(axis=1)
    return np.arctan2(sums[:, 1], sums[:, 0])


def _fill(angles, known, period):
    """Returns angles in which unknown ones are between their neighbours, or go on in equal steps."""
    places = np.arange(len(angles))
    good, where = angles[known], places[known]
    if period:
        good = np.unwrap(good, period=period)
    filled = np.interp(places, where, good)
    if len(where) > 1:
        step = (good[-1] - good[0]) / (where[-1] - where[0])
        filled[: where[0]] = good[0] + step * (places[: where[0]] - where[0])
        filled[where[-1] :] = good[-1] + step * (places[where[-1] :] - where[-1])
    return filled


def _read_grid(path, index):
    check_file(path)
    with open(path, encoding="latin-1") as file:
        lines = (line for line in file if line.strip())
        for number in range(index + 1):
            columns, rows = int(float(next(lines))), int(float(next(lines)))
            next(itertools.islice(lines, HEAD - 1, HEAD), None)
            body = itertools.islice(lines, columns * rows)
            if number < index:
                for _ in body:
                    pass
        parts = [np.empty((0, 3))]
        while part := list(itertools.islice(body, ROWS)):
            parts.append(np.loadtxt(part, usecols=(0, 1, 2), ndmin=2))
    points = np.concatenate(parts)
    if len(points) != columns * rows:
        raise FormatError(
            f"{path}: scan {index + 1} has {len(points)} of its {columns * rows} points, so that its "
            "pulses without a return are not known; copy it again"
        )
    return points, columns, rows
