# SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
# SPDX-License-Identifier: BSD-3-Clause
"""Flight lines that follow the ground."""

import math

import numpy as np
from vtkmodules.util.numpy_support import vtk_to_numpy
from vtkmodules.vtkCommonCore import vtkIdList
from vtkmodules.vtkCommonDataModel import vtkCellArray

from ..array_names import ACTIVE, LEG_IDS
from ..core.classes import vtk_class
from ..core.pipeline import update
from ._terrain import Grid, points_of

WAYPOINTS_PER_HEIGHT = 4  # their spacing is a quarter of the flying height
MAXIMUM_CELLS = 1_000_000  # cells of the ground that is followed


def follow_terrain(terrain, lines, height, max_climb, cell):
    """Waypoints (vtkPolyData with lines) at a height above the ground of a Terrain.

    The ground is sampled in cells; where it ends it continues as the nearest ground. Turns follow it,
    too.
    """
    places = points_of(lines)[:, :2]
    spacing = max(cell, height / WAYPOINTS_PER_HEIGHT)
    low, high = places.min(axis=0) - 2 * cell, places.max(axis=0) + 2 * cell
    cell = max(cell, math.sqrt(np.prod(high - low) / MAXIMUM_CELLS))
    follow = vtk_class("vtkHeliosTerrainFollow")()
    follow.SetInputData(0, lines)
    follow.SetInputData(1, terrain.mesh(Grid(low - cell, high + cell, cell)))
    follow.SetHeight(height)
    follow.SetSpacing(spacing)
    follow.SetMaximumSlope(max_climb)
    waypoints = update(follow)
    waypoints.SetLines(_make_cells(waypoints))
    return waypoints


def _make_cells(waypoints):
    """Returns a polyline per flight line: from its first waypoint to the first one that is not
    active."""
    data = waypoints.GetPointData()
    active = vtk_to_numpy(data.GetArray(ACTIVE))
    numbers = vtk_to_numpy(data.GetArray(LEG_IDS))
    cells = vtkCellArray()
    for number in np.unique(numbers):
        first = np.flatnonzero((numbers == number) & (active > 0))
        ids = range(first[0], first[-1] + 2)
        cells.InsertNextCell(len(ids))
        for index in ids:
            cells.InsertCellPoint(int(index))
    return cells


def line_waypoints(data):
    """Yields the waypoints of each line, n x 3 [m]."""
    points, cells, ids = points_of(data), data.GetLines(), vtkIdList()
    for number in range(cells.GetNumberOfCells()):
        cells.GetCellAtId(number, ids)
        yield points[[ids.GetId(i) for i in range(ids.GetNumberOfIds())]]


def line_lengths(data):
    """Returns the length of each line [m]."""
    return np.array(
        [np.linalg.norm(np.diff(each, axis=0), axis=1).sum() for each in line_waypoints(data)]
    )
