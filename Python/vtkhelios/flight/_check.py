# SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
# SPDX-License-Identifier: BSD-3-Clause
"""Predicted against simulated density: the first returns of the survey of a flight plan, in cells."""

import numpy as np

from ..array_names import PULSE_DENSITY
from ._summary import spread
from ._terrain import Grid

MINIMUM_PULSES = 100  # per cell of the comparison, on average
QUANTILE = 0.95


class Counts:
    """First returns of the strips of a plan, in two grids: of the comparison, and of the gaps."""

    def __init__(self, plan):
        self.plan = plan
        self.grid, self.factor = _coarsen(plan)
        (west, east, south, north), cell = plan.grid.box, gap_cell(plan)
        self.gap_grid = Grid((west, south), (east, north), cell)
        self.counts = np.zeros(self.grid.shape, dtype=np.int64)
        self.gap_counts = np.zeros(self.gap_grid.shape, dtype=np.int64)

    def add(self, points):
        """Adds the first returns of a strip, n x 3 [m]."""
        self.counts += self.grid.count(points)
        self.gap_counts += self.gap_grid.count(points)

    def compare(self):
        """Predicted and simulated pulse density of the cells that are wholly in the area."""
        predicted, whole = self._predict()
        simulated = self.counts / self.grid.cell**2
        expected, found = predicted[whole], simulated[whole]
        error = (found - expected) / np.maximum(expected, 1e-12)
        inside = self._gap_cells_inside()
        return {
            "cell_m": self.grid.cell,
            "cells": int(whole.sum()),
            "firstReturns": int(self.counts[whole].sum()),
            "predicted_1_m2": spread(expected),
            "simulated_1_m2": spread(found),
            "bias_percent": 100.0 * float(found.mean() / max(expected.mean(), 1e-12) - 1.0),
            "rms_percent": 100.0 * float(np.sqrt(np.mean(error**2))) if len(error) else 0.0,
            "within95_percent": 100.0 * float(np.quantile(abs(error), QUANTILE))
            if len(error)
            else 0.0,
            "gapCell_m": self.gap_grid.cell,
            "gapCells": int(inside.sum()),
            "empty": int((inside & (self.gap_counts == 0)).sum()),
        }

    def _predict(self):
        """Returns the mean predicted density of coarse cells, and which are wholly in the area."""
        plan, n = self.plan, self.factor
        density = np.zeros(plan.grid.shape)
        density[plan.inside] = plan.cells[PULSE_DENSITY]
        rows, columns = (n * size for size in self.grid.shape)

        def sums(values):
            padded = np.zeros((rows, columns))
            padded[: values.shape[0], : values.shape[1]] = values
            return padded.reshape(rows // n, n, columns // n, n).sum(axis=(1, 3))

        return sums(density) / n**2, sums(plan.inside) == n**2

    def spread_out(self, values):
        """Returns the values of coarse cells on the cells of the plan."""
        fine = np.repeat(np.repeat(values, self.factor, axis=0), self.factor, axis=1)
        rows, columns = self.plan.grid.shape
        return fine[:rows, :columns]

    def _gap_cells_inside(self):
        """The cells of the gaps whose corners are all in cells of the area."""
        grid, plan = self.gap_grid, self.plan
        half = 0.5 * grid.cell * (1 - 1e-9)
        inside = np.ones(grid.shape, dtype=bool)
        for dx in (-half, half):
            for dy in (-half, half):
                inside &= _look_up(plan, grid.centres() + (dx, dy)).reshape(grid.shape)
        return inside


def gap_cell(plan):
    """The side of the cells that must have a return: twice the largest spacing of pulses [m], or
    without lines twice the mean one; at least the side of the plan's cells."""
    design = plan.design
    if design.along is None:
        return 2.0 / np.sqrt(design.density)
    return 2.0 * max(design.along, design.across, 1.0 / np.sqrt(design.density))


def _coarsen(plan):
    """Returns a grid of whole multiples of the cells, with enough pulses per cell, and the
    multiple."""
    mean = float(plan.cells[PULSE_DENSITY].mean())
    wanted = np.sqrt(MINIMUM_PULSES / max(mean, 1e-9))
    factor = max(1, int(np.ceil(wanted / plan.grid.cell)))
    west, east, south, north = plan.grid.box
    return Grid((west, south), (east, north), factor * plan.grid.cell), factor


def _look_up(plan, places):
    index = np.floor((places - plan.grid.low) / plan.grid.cell).astype(int)
    rows, columns = plan.grid.shape
    known = ((index >= 0) & (index < (columns, rows))).all(axis=1)
    found = np.zeros(len(places), dtype=bool)
    found[known] = plan.inside[index[known, 1], index[known, 0]]
    return found
