# SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
# SPDX-License-Identifier: BSD-3-Clause
"""Distances to the nearest point, of the other cloud or of the same, and to a mesh.

They are of a random sample of points, against all points.
"""

import numpy as np
from vtkmodules.util.numpy_support import vtk_to_numpy
from vtkmodules.vtkCommonCore import vtkDoubleArray, vtkIdList, vtkPoints
from vtkmodules.vtkCommonDataModel import vtkPolyData, vtkStaticPointLocator
from vtkmodules.vtkFiltersCore import vtkImplicitPolyDataDistance

from ..core.arrays import numpy_to_vtk

STEP = 1000  # points between signs of progress


class Nearest:
    """Finds nearest points of a cloud."""

    def __init__(self, points):
        self._origin = points.mean(axis=0)
        self._points = np.ascontiguousarray(points - self._origin)
        holder, self._data = vtkPoints(), vtkPolyData()
        holder.SetData(numpy_to_vtk(self._points))
        self._data.SetPoints(holder)
        self._locator = vtkStaticPointLocator()
        self._locator.SetDataSet(self._data)
        self._locator.BuildLocator()

    def distances(self, points, on_step):
        """From points to the nearest of the cloud [m]."""
        places, found = points - self._origin, np.empty(len(points), np.int64)
        for row, place in enumerate(places):
            found[row] = self._locator.FindClosestPoint(place)
            if row % STEP == 0:
                on_step("nearest points", row / len(points))
        return np.linalg.norm(places - self._points[found], axis=1)

    def spacing(self, rows, on_step):
        """From points of the cloud to the nearest other point [m]."""
        ids, found = vtkIdList(), np.empty(len(rows), np.int64)
        for index, row in enumerate(rows):
            self._locator.FindClosestNPoints(2, self._points[row], ids)
            pair = ids.GetId(0), ids.GetId(1)
            found[index] = pair[0] if pair[1] == row else pair[1]  # also of equal points
            if index % STEP == 0:
                on_step("spacing", index / len(rows))
        return np.linalg.norm(self._points[rows] - self._points[found], axis=1)


class MeshDistance:
    """Signed distances to the nearest point of a mesh, positive on the side of its normals [m]."""

    def __init__(self, mesh):
        low = np.array(mesh.GetBounds()[::2])
        self._origin = low
        local, holder = vtkPolyData(), vtkPoints()
        local.DeepCopy(mesh)
        points = vtk_to_numpy(mesh.GetPoints().GetData()).astype(np.float64) - low
        holder.SetData(numpy_to_vtk(points, 1))
        local.SetPoints(holder)
        self._distance = vtkImplicitPolyDataDistance()
        self._distance.SetInput(local)

    def distances(self, points, on_step):
        parts = []
        for begin in range(0, len(points), STEP):
            on_step("distances to the mesh", begin / len(points))
            places = numpy_to_vtk(np.ascontiguousarray(points[begin : begin + STEP] - self._origin))
            found = vtkDoubleArray()
            self._distance.FunctionValue(places, found)
            parts.append(vtk_to_numpy(found).copy())
        return np.concatenate(parts)
