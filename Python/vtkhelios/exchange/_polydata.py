# SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
# SPDX-License-Identifier: BSD-3-Clause
"""Meshes of other libraries as a vtkPolyData of triangles; see Scene."""


import numpy as np
from vtkmodules.util.numpy_support import vtk_to_numpy
from vtkmodules.vtkCommonCore import VTK_DOUBLE, VTK_ID_TYPE, vtkPoints, vtkStringArray
from vtkmodules.vtkCommonDataModel import vtkCellArray, vtkPolyData
from vtkmodules.vtkFiltersCore import vtkAppendPolyData

from ..array_names import MATERIAL_IDS, MATERIAL_NAME, PART_IDS, PART_NAME
from ..core.arrays import numpy_to_vtk
from ..core.classes import vtk_class
from ..core.pipeline import update
from ._meshes import Mesh, read_parts

FACE_IDS = "FaceIds"  # ids of the polygons that triangles are made of, while a mesh is converted


def read_polydata(source):
    """Returns an object of another library as (vtkPolyData, polygon of each triangle); None: of no
    known kind.

    The polygons are None if they are the triangles themselves.
    """
    parts = read_parts(source)
    if parts is None:
        return None
    if not parts:
        raise ValueError(f"the {type(source).__name__} has no mesh; give one with points and faces")
    if list(parts) == [""]:
        return triangulate(_make_polydata(parts[""]))
    return _join(parts)


def triangulate(mesh):
    """(mesh of triangles, polygon of each triangle); the mesh itself and None if it has nothing else."""
    cutter = vtk_class("vtkHeliosTriangulate")()
    if cutter.HasOnlyTriangles(mesh):
        return mesh, None
    numbered = vtkPolyData()
    numbered.ShallowCopy(mesh)
    ids = numpy_to_vtk(np.arange(mesh.GetNumberOfCells()), deep=1)
    ids.SetName(FACE_IDS)
    numbered.GetCellData().AddArray(ids)
    cutter.SetInputDataObject(numbered)
    triangles = vtkPolyData()
    triangles.ShallowCopy(update(cutter))
    faces = vtk_to_numpy(triangles.GetCellData().GetArray(FACE_IDS)).copy()
    triangles.GetCellData().RemoveArray(FACE_IDS)
    return triangles, faces


def _make_polydata(source: Mesh):
    """Returns a vtkPolyData that shares points of double precision, and copies the rest."""
    points = np.ascontiguousarray(source.points, dtype=np.float64)
    if points.ndim != 2 or points.shape[1] != 3:
        raise ValueError(f"points has the shape {points.shape}; give an array of (n, 3)")
    if not np.isfinite(points).all():
        raise ValueError("points has NaN or infinity; give finite coordinates")
    corners = source.corners
    if corners.size and not 0 <= corners.min() <= corners.max() < len(points):
        raise ValueError(
            f"faces has indices from {corners.min()} to {corners.max()}; "
            f"the points are 0 to {len(points) - 1}"
        )
    mesh, holder, cells = vtkPolyData(), vtkPoints(), vtkCellArray()
    holder.SetDataType(VTK_DOUBLE)
    holder.SetData(numpy_to_vtk(points))
    mesh.SetPoints(holder)
    # Copies: the cells use the memory of these arrays, without a reference.
    cells.SetData(_to_ids(source.offsets), _to_ids(corners))
    mesh.SetPolys(cells)
    _check_materials(source)
    for arrays, held in (
        (source.cell_arrays, mesh.GetCellData()),
        (source.point_arrays, mesh.GetPointData()),
        (source.fields, mesh.GetFieldData()),
    ):
        for name, values in arrays.items():
            _add(held, name, values)
    return mesh


def _check_materials(source):
    """Names the materials of ids without a table of materials."""
    ids = source.cell_arrays.get(MATERIAL_IDS)
    if ids is None:
        return
    if ids.size and ids.min() < 0:
        raise ValueError(f"{MATERIAL_IDS} has {ids.min()}; material ids are 0 and more")
    source.cell_arrays[MATERIAL_IDS] = ids.astype(np.int32)
    if MATERIAL_NAME not in source.fields:
        count = int(ids.max(initial=-1)) + 1
        source.fields[MATERIAL_NAME] = [f"material{index}" for index in range(count)]


def _to_ids(values):
    return numpy_to_vtk(np.ascontiguousarray(values, dtype=np.int64), 1, VTK_ID_TYPE)


def _add(held, name, values):
    """Adds an array of numbers or texts; VTK has no type for others, such as objects."""
    if isinstance(values, list):
        array = vtkStringArray()
        for text in values:
            array.InsertNextValue(text)
    elif values.dtype.kind in "iufb" and values.ndim in (1, 2):
        values = values.view(np.uint8) if values.dtype.kind == "b" else values
        array = numpy_to_vtk(np.ascontiguousarray(values), deep=1)
    else:
        return
    array.SetName(name)
    held.AddArray(array)


def _join(parts):
    """Returns the meshes of several parts as one, with PartIds and the names of parts and
    materials."""
    joiner, faces, first, names = vtkAppendPolyData(), [], 0, []
    for number, mesh in enumerate(parts.values()):
        _move_materials(mesh, names)
        mesh.cell_arrays[PART_IDS] = np.full(len(mesh.offsets) - 1, number, np.int32)
        triangles, own = triangulate(_make_polydata(mesh))
        joiner.AddInputData(triangles)
        faces.append(first + (np.arange(triangles.GetNumberOfCells()) if own is None else own))
        first += len(mesh.offsets) - 1
    joiner.SetOutputPointsPrecision(1)  # double
    joiner.Update()
    whole = vtkPolyData()
    whole.ShallowCopy(joiner.GetOutput())
    whole.GetFieldData().Initialize()
    _add(whole.GetFieldData(), PART_NAME, list(parts))
    _add(whole.GetFieldData(), MATERIAL_NAME, names)
    faces = np.concatenate(faces)
    return whole, None if np.array_equal(faces, np.arange(first)) else faces


def _move_materials(mesh, names):
    """Numbers the materials of a mesh in the list of all; a mesh without is of "default"."""
    ids = mesh.cell_arrays.get(MATERIAL_IDS)
    if ids is None:
        ids, own = np.zeros(len(mesh.offsets) - 1, np.int32), ["default"]
    else:
        _check_materials(mesh)
        own = mesh.fields[MATERIAL_NAME]
    names += [name for name in dict.fromkeys(own) if name not in names]
    table = np.array([names.index(name) for name in own] or [0], np.int32)
    mesh.cell_arrays[MATERIAL_IDS] = table[ids]
    mesh.fields = {MATERIAL_NAME: names}
