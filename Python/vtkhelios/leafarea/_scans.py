# SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
# SPDX-License-Identifier: BSD-3-Clause
"""A scan: what the filter needs of it, and pulses made of what a file tells."""

import dataclasses

import numpy as np

from ..array_names import DIRECTION, NUMBER_OF_RETURNS, PULSE_IDS, RETURN_NUMBER
from ..formats import FormatError
from ..formats._base import rows_of, to_cloud


@dataclasses.dataclass
class Scan:
    """The echoes of a scan position, a leg or a strip; all are vtkPolyData or None."""

    name: str
    echoes: object
    pulses: object = None
    hits: object = None
    trajectory: object = None
    origin: object = None
    knows_misses: bool = False


def add_pulses(scan, chunk, header, misses):
    """Adds pulses to a scan of one origin: those of its echoes, and directions without one."""
    origin = np.asarray(scan.origin, float)
    ids = chunk.get(PULSE_IDS)
    if ids is None:
        ids = _number_pulses(chunk)
    ids = np.unique(ids, return_inverse=True)[1].astype(np.int64)
    chunk = {**chunk, PULSE_IDS: ids}
    first = np.unique(ids, return_index=True)[1]
    ways = chunk["points"][first] - origin
    lengths = np.linalg.norm(ways, axis=1)
    if (lengths == 0).any():
        raise FormatError(
            f"{scan.name}: has points at the origin of its beams, {tuple(map(float, origin))}; "
            "correct the origin, or drop them"
        )
    directions = np.concatenate([ways / lengths[:, None], misses])
    count = len(directions)
    pulses = {
        "points": np.repeat(origin[None], count, axis=0),
        DIRECTION: directions,
        PULSE_IDS: np.arange(count),
    }
    scan.echoes, scan.pulses = to_cloud(chunk, header), to_cloud(pulses)


def _number_pulses(chunk):
    """Returns the pulse of each echo: returns after each other with rising numbers share one."""
    if RETURN_NUMBER not in chunk or NUMBER_OF_RETURNS not in chunk:
        return np.arange(rows_of(chunk))
    number = chunk[RETURN_NUMBER].astype(int)
    same = (np.diff(number) > 0) & (np.diff(chunk[NUMBER_OF_RETURNS].astype(int)) == 0)
    return np.concatenate([[0], np.cumsum(~same)])[: rows_of(chunk)]


CELLS = 4  # spacings of a cell of the pattern


def find_misses(directions, spacing):
    """Returns the directions (n x 3) in which pulses of a regular pattern have no echo.

    The pattern is a grid of azimuths and elevations. Cells of 4 by 4 pulses with fewer directions
    have misses in those places of the grid that are farthest from any; nothing is assumed outside
    the azimuths and elevations that have points.
    """
    azimuth = np.degrees(np.arctan2(directions[:, 1], directions[:, 0]))
    elevation = np.degrees(np.arcsin(np.clip(directions[:, 2], -1, 1)))
    angles = np.column_stack([azimuth, elevation])
    low, high = angles.min(axis=0), angles.max(axis=0)
    counts = np.maximum(np.rint((high - low) / spacing).astype(int) + 1, 1)
    if counts.prod() > 2e9:
        raise FormatError(
            f"the scan pattern would have {counts[0]} x {counts[1]} pulses; give a larger --spacing"
        )
    cells = -(-counts // CELLS)
    place = np.minimum(
        ((angles - low + 0.5 * np.asarray(spacing)) / spacing).astype(int), counts - 1
    )
    full = np.zeros(counts, bool)
    full[tuple(place.T)] = True
    rows = place // CELLS
    found = np.bincount(rows[:, 0] * cells[1] + rows[:, 1], minlength=cells.prod())
    free = np.argwhere(~full)
    cell = free[:, 0] // CELLS * cells[1] + free[:, 1] // CELLS
    sizes = [np.minimum(CELLS, count - CELLS * np.arange(n)) for count, n in zip(counts, cells)]
    wanted = np.maximum(np.outer(*sizes).ravel() - found, 0)
    order = np.argsort(cell, kind="stable")
    rank = np.arange(len(order)) - np.searchsorted(cell[order], cell[order])
    chosen = free[order][rank < wanted[cell[order]]]
    azimuth, elevation = np.radians(low + chosen * np.asarray(spacing)).T
    flat = np.cos(elevation)
    return np.column_stack([flat * np.cos(azimuth), flat * np.sin(azimuth), np.sin(elevation)])
