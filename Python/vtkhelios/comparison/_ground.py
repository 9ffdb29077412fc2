# SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
# SPDX-License-Identifier: BSD-3-Clause
"""Cells and tiles of the ground, the same for both clouds, and which tiles both have."""

import numpy as np

from ..formats import FormatError

POINTS_IN_CELL = 16  # median of the non-empty cells of the sparser cloud, by default
FINEST, COARSEST = 2.0**-7, 2.0**7  # default cells [m]
TILES = 250  # wished for in the box of both clouds
COLUMN = 5  # cells per side, at most
SHARED = 0.5  # fraction of the columns of a tile that both have
MAXIMUM_CELLS = 2**62


def cells_of(points, size, corner, shape, offset=0.0):
    """Returns the number of the cell of each point, by axis from the corner [cells] in a box of a
    shape."""
    index = np.floor(points / size + offset).astype(np.int64) - corner
    number = index[:, 0]
    for axis in range(1, index.shape[1]):
        number = number * shape[axis] + index[:, axis]
    return number


def box_of(clouds, size):
    """Returns the first cell and the number of cells by axis, with one to spare; FormatError if too
    many."""
    low = np.min([points.min(axis=0) for points in clouds], axis=0)
    high = np.max([points.max(axis=0) for points in clouds], axis=0)
    spans = (high - low) / size + 3
    if np.prod(spans) > MAXIMUM_CELLS or np.abs([low, high]).max() / size > MAXIMUM_CELLS:
        raise FormatError(
            f"the points span {spans[0]:.3g} x {spans[1]:.3g} cells of {size:g} m; give larger "
            "cells, or remove outliers"
        )
    corner = np.floor(low / size).astype(np.int64) - 1
    return corner, np.ceil(spans).astype(np.int64)


def choose_cell(clouds):
    """Returns the smallest power of two [m] with POINTS_IN_CELL points in the median cell, in plan
    view."""
    return max(_cell_of(points) for points in clouds)


def _cell_of(points):
    points = points[:, :2]
    area = max(np.prod(np.ptp(points, axis=0)), FINEST**2)
    guess = np.sqrt(POINTS_IN_CELL * area / len(points)) / 8
    size = float(np.clip(2.0 ** np.floor(np.log2(guess)), FINEST, COARSEST))
    while size < COARSEST:
        numbers = cells_of(points, size, *box_of([points], size))
        _, counts = np.unique(numbers, return_counts=True)
        if np.median(counts) >= min(POINTS_IN_CELL, len(points)):
            break
        size *= 2
    return size


def choose_tile(low, high, cell):
    """Returns the side of a tile, a multiple of the cell [m]: about TILES tiles in a box."""
    area = max(np.prod(np.maximum(high - low, cell)[:2]), cell**2)
    return cell * max(1, round(np.sqrt(area / TILES) / cell))


def is_between(core, rows, lines):
    """Which tiles are between the first and the last core tile of their row: a hole of one cloud."""
    _, rows = np.unique(rows, return_inverse=True)
    first = np.full(rows.max() + 1, np.iinfo(np.int64).max)
    last = np.full(rows.max() + 1, -1)
    np.minimum.at(first, rows[core], lines[core])
    np.maximum.at(last, rows[core], lines[core])
    return (first[rows] < lines) & (lines < last[rows])


class Ground:
    """Tiles and columns in plan view. Tiles are whole columns; both begin at multiples of the tile.

    Tiles are common if half of their columns have points of both clouds, or if such tiles are at
    all four sides of them.
    """

    def __init__(self, first, second, cell, tile):
        self.cell, self.tile = cell, tile
        self.column = tile / max(1, int(tile / (COLUMN * cell) + 1e-9))
        plans = [side.points[:, :2] for side in (first, second)]
        box = box_of(plans, self.column)
        numbers = [cells_of(plan, self.column, *box) for plan in plans]
        known, index = np.unique(np.concatenate(numbers), return_inverse=True)
        first.columns_of, second.columns_of = np.split(index, [len(first)])
        self.columns = len(known)
        x, y = np.divmod(known, box[1][1])
        middle = (np.column_stack([x, y]) + box[0] + 0.5) * self.column
        tile_corner, tile_shape = box_of([middle], tile)
        tiles = cells_of(middle, tile, tile_corner, tile_shape)
        numbers, self.tile_of = np.unique(tiles, return_inverse=True)  # numbers of columns
        self.tiles = int(self.tile_of.max()) + 1
        for side in (first, second):
            side.tiles = self.tile_of[side.columns_of]
        has = [np.bincount(side.columns_of, minlength=self.columns) > 0 for side in (first, second)]
        both = np.bincount(self.tile_of, has[0] & has[1], self.tiles)
        core = both >= SHARED * np.bincount(self.tile_of, minlength=self.tiles)
        rows, lines = np.divmod(numbers, tile_shape[1])
        self.common = core | (is_between(core, rows, lines) & is_between(core, lines, rows))
        self.is_shared = bool(self.common.any())

    def restrict(self, sides):
        """Keeps points in common tiles, if there are any."""
        if not self.is_shared:
            return
        for side in sides:
            mask = self.common[side.tiles]
            side.columns_of = side.columns_of[mask]
            side.keep(mask)

    def areas(self, sides):
        """Returns the area of the columns with points of any of the sides [m²], per tile."""
        seen = np.zeros(self.columns, bool)
        for side in sides:
            seen[side.columns_of] = True
        return np.bincount(self.tile_of[seen], minlength=self.tiles) * self.column**2

    def lowest(self, sides):
        """Returns the lowest point of the sides in each column [m]."""
        low = np.full(self.columns, np.inf)
        for side in sides:
            np.minimum.at(low, side.columns_of, side.points[:, 2])
        return low


def draw_tiles(tile, share, seed):
    """Returns a function from points to the mask of those in a random share of the tiles, the same
    for any
    cloud: SplitMix64 (Steele, Lea, Flood 2014) of the seed and the numbers of a tile."""

    def accepts(points):
        index = np.floor(points[:, :2] / tile).astype(np.int64).view(np.uint64)
        with np.errstate(over="ignore"):
            mixed = _mix(_mix(index[:, 0] + np.uint64(seed)) ^ index[:, 1])
        return mixed < np.uint64(min(share, 1.0) * (2.0**64 - 2048))

    return accepts


def _mix(value):
    value = value + np.uint64(0x9E3779B97F4A7C15)
    value = (value ^ (value >> np.uint64(30))) * np.uint64(0xBF58476D1CE4E5B9)
    value = (value ^ (value >> np.uint64(27))) * np.uint64(0x94D049BB133111EB)
    return value ^ (value >> np.uint64(31))
