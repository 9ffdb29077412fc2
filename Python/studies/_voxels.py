# SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
# SPDX-License-Identifier: BSD-3-Clause
"""Voxels, and the paths of rays through them."""

import numpy as np


class Grid:
    """Voxels: a box from low to high [m], divided into cubes of side cell at most."""

    def __init__(self, low, high, cell):
        self.low, high = np.asarray(low, float), np.asarray(high, float)
        self.shape = np.maximum(1, np.ceil((high - self.low) / cell - 1e-9).astype(int))
        self.size = (high - self.low) / self.shape
        self.high = high
        self.volume = self.size.prod()
        self.count = int(self.shape.prod())

    def find(self, points):
        """The number of the voxel of every point; -1: outside."""
        index = np.floor((points - self.low) / self.size).astype(int)
        inside = ((index >= 0) & (index < self.shape)).all(axis=1)
        return np.where(inside, self.number(index), -1)

    def number(self, index):
        return (index[:, 0] * self.shape[1] + index[:, 1]) * self.shape[2] + index[:, 2]

    def layers(self):
        """The heights of the centres of layers [m]."""
        return self.low[2] + (np.arange(self.shape[2]) + 0.5) * self.size[2]

    def enter(self, voxels, origins, directions):
        """The distance from its origin at which every ray enters the given voxel [m]."""
        low = self.low + np.column_stack(np.unravel_index(voxels, self.shape)) * self.size
        with np.errstate(divide="ignore", invalid="ignore"):
            ways = np.minimum(
                (low - origins) / directions, (low + self.size - origins) / directions
            )
        return np.maximum(np.nanmax(ways, axis=1), 0)

    def sum_paths(self, origins, directions, lengths):
        """Path length of all rays, up to their lengths, in every voxel [m] (Amanatides, Woo 1987)."""
        with np.errstate(divide="ignore", invalid="ignore"):
            a = (self.low - origins) / directions
            b = (self.high - origins) / directions
        enter = np.maximum(np.nanmax(np.minimum(a, b), axis=1), 0)
        leave = np.minimum(np.nanmin(np.maximum(a, b), axis=1), lengths)
        crosses = leave > enter
        origins, directions = origins[crosses], directions[crosses]
        now, leave = enter[crosses], leave[crosses]
        index = np.floor((origins + now[:, None] * directions - self.low) / self.size).astype(int)
        index = np.clip(index, 0, self.shape - 1)
        step = np.where(directions > 0, 1, -1)
        with np.errstate(divide="ignore", invalid="ignore"):
            width = self.size / np.abs(directions)
            border = (self.low + (index + (step > 0)) * self.size - origins) / directions
        border[directions == 0] = np.inf
        sums = np.zeros(self.count)
        while len(now):
            axis = border.argmin(axis=1)
            rows = np.arange(len(now))
            until = np.minimum(border[rows, axis], leave)
            sums += np.bincount(self.number(index), np.maximum(until - now, 0), self.count)
            index[rows, axis] += step[rows, axis]
            border[rows, axis] += width[rows, axis]
            now = until
            goes_on = (now < leave) & ((index >= 0) & (index < self.shape)).all(axis=1)
            now, leave, index, step, width, border = (
                values[goes_on] for values in (now, leave, index, step, width, border)
            )
        return sums
