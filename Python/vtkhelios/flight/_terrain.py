# SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
# SPDX-License-Identifier: BSD-3-Clause
"""The ground of a flight plan: heights of a scene on a grid."""


import numpy as np
from vtkmodules.util.numpy_support import vtk_to_numpy
from vtkmodules.vtkCommonCore import vtkPoints
from vtkmodules.vtkCommonDataModel import vtkCellArray, vtkPolyData

from ..array_names import NORMAL, ON_GROUND
from ..core.arrays import arrays, numpy_to_vtk
from ..core.classes import vtk_class
from ..core.pipeline import update

MAXIMUM_CELLS = 250_000


class Grid:
    """Square cells over a box in x, y; arrays are rows from south to north."""

    def __init__(self, low, high, cell):
        self.low, self.cell = np.array(low[:2], dtype=float), float(cell)
        size = np.array(high[:2], dtype=float) - self.low
        self.columns, self.rows = (max(1, int(n)) for n in np.ceil(size / cell - 1e-9))

    @property
    def shape(self):
        return self.rows, self.columns

    @property
    def box(self):
        """West, east, south, north."""
        (x, y), cell = self.low, self.cell
        return x, x + self.columns * cell, y, y + self.rows * cell

    def centres(self):
        """Returns the centres of the cells, n x 2, row by row."""
        x = self.low[0] + (np.arange(self.columns) + 0.5) * self.cell
        y = self.low[1] + (np.arange(self.rows) + 0.5) * self.cell
        return np.stack(np.meshgrid(x, y), axis=-1).reshape(-1, 2)

    def count(self, places):
        """Returns the number of places (n x 2 or more) in each cell, and outside none."""
        index = np.floor((places[:, :2] - self.low) / self.cell).astype(np.int64)
        inside = ((index >= 0) & (index < (self.columns, self.rows))).all(axis=1)
        cells = index[inside, 1] * self.columns + index[inside, 0]
        return np.bincount(cells, minlength=self.rows * self.columns).reshape(self.shape)


class Terrain:
    """The heights of the ground of a scene: of the surfaces with a ground material, if it has any,
    else of the highest surface."""

    def __init__(self, scene):
        self.scene = scene

    def heights(self, places):
        """Returns the height at places (n x 2) [m]; NaN where there is no ground."""
        snap = vtk_class("vtkHeliosGroundSnap")()
        snap.SetInputData(0, make_points(np.column_stack([places, np.zeros(len(places))])))
        snap.SetInputDataObject(1, self.scene)
        snap.SetAllowMissing(True)
        found = arrays(update(snap))
        return np.where(found[ON_GROUND] > 0, found["points"][:, 2], np.nan)

    def grid_heights(self, grid):
        """Returns the heights at the centres of a grid; those without ground are as the nearest
        ones."""
        heights = self.heights(grid.centres()).reshape(grid.shape)
        return fill(heights), np.isfinite(heights)

    def mesh(self, grid):
        """Returns the heights of a grid as triangles between the centres of its cells."""
        heights, _ = self.grid_heights(grid)
        mesh = make_points(np.column_stack([grid.centres(), heights.ravel()]))
        rows, columns = grid.shape
        first = (np.arange(rows - 1)[:, None] * columns + np.arange(columns - 1)).ravel()
        corners = np.stack(
            [first, first + 1, first + columns + 1, first, first + columns + 1, first + columns],
            axis=1,
        ).reshape(-1, 3)
        cells = vtkCellArray()
        cells.SetData(3, numpy_to_vtk(corners.astype(np.int64).ravel(), deep=True))
        mesh.SetPolys(cells)
        return mesh


def fill(heights):
    """Heights with each NaN replaced by the mean of its neighbours, from the known ones outwards."""
    heights = heights.copy()
    if not np.isfinite(heights).any():
        return heights
    while (missing := np.isnan(heights)).any():
        around = np.pad(heights, 1, constant_values=np.nan)
        sides = np.stack([around[:-2, 1:-1], around[2:, 1:-1], around[1:-1, :-2], around[1:-1, 2:]])
        known = np.isfinite(sides)
        mean = np.where(known, sides, 0.0).sum(axis=0) / np.maximum(known.sum(axis=0), 1)
        grown = missing & known.any(axis=0)
        heights[grown] = mean[grown]
    return heights


def make_normals(heights, cell):
    """Returns the unit normals of the ground, by differences of neighbouring cells; n x 3."""

    def slope(axis):
        return (
            np.gradient(heights, cell, axis=axis)
            if heights.shape[axis] > 1
            else np.zeros_like(heights)
        )

    normals = np.stack([-slope(1), -slope(0), np.ones_like(heights)], axis=-1)
    return (normals / np.linalg.norm(normals, axis=-1, keepdims=True)).reshape(-1, 3)


def make_places(grid, heights, inside):
    """Returns the centres of cells on the ground, with normals, of the cells inside (a mask)."""
    points = np.column_stack([grid.centres(), heights.ravel()])[inside.ravel()]
    data = make_points(points)
    normals = numpy_to_vtk(make_normals(heights, grid.cell)[inside.ravel()], deep=True)
    normals.SetName(NORMAL)
    data.GetPointData().AddArray(normals)
    return data


def make_points(coordinates):
    points = vtkPoints()
    points.SetData(numpy_to_vtk(np.ascontiguousarray(coordinates, dtype=np.float64), deep=True))
    data = vtkPolyData()
    data.SetPoints(points)
    return data


def points_of(data):
    return vtk_to_numpy(data.GetPoints().GetData())
