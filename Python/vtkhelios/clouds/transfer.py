# SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
# SPDX-License-Identifier: BSD-3-Clause
"""Polygonal data and tables as numpy arrays and texts, which can be pickled."""

import numpy as np
from vtkmodules.util.numpy_support import vtk_to_numpy
from vtkmodules.vtkCommonCore import vtkPoints, vtkStringArray, vtkTypeInt64Array
from vtkmodules.vtkCommonDataModel import vtkCellArray, vtkPolyData, vtkTable

from ..core.arrays import numpy_to_vtk

_CELLS = ("Verts", "Lines", "Polys", "Strips")


def pack(data):
    """Returns a vtkPolyData or vtkTable as (points, cells, attributes); None: None. Shares its
    memory."""
    if data is None:
        return None
    if data.IsA("vtkTable"):
        return None, None, [_pack_arrays(data.GetRowData()), _pack_arrays(data.GetFieldData())]
    points = data.GetPoints()
    cells = {name: getattr(data, f"Get{name}")() for name in _CELLS}
    return (
        _pack_array(points.GetData()) if points else None,
        {name: _pack_cells(held) for name, held in cells.items() if held.GetNumberOfCells()},
        [
            _pack_arrays(attributes)
            for attributes in (data.GetPointData(), data.GetCellData(), data.GetFieldData())
        ],
    )


def unpack(packed):
    """Returns the data of pack(); shares the memory of its arrays."""
    if packed is None:
        return None
    points, cells, attributes = packed
    if cells is None:
        data = vtkTable()
        places = (data.GetRowData(), data.GetFieldData())
    else:
        data = _unpack_geometry(points, cells)
        places = (data.GetPointData(), data.GetCellData(), data.GetFieldData())
    for place, arrays in zip(places, attributes):
        _unpack_arrays(place, arrays)
    return data


def _unpack_geometry(points, cells):
    data = vtkPolyData()
    if points is not None:
        array = _unpack_array(points)
        holder = vtkPoints()
        holder.SetDataType(array.GetDataType())
        holder.SetData(array)
        data.SetPoints(holder)
    for name, held in cells.items():
        getattr(data, f"Set{name}")(_unpack_cells(held))
    return data


def _pack_cells(cells):
    return [
        vtk_to_numpy(array).astype(np.int64, copy=False)
        for array in (cells.GetOffsetsArray(), cells.GetConnectivityArray())
    ]


def _unpack_cells(packed):
    arrays = []
    for values in packed:
        array = vtkTypeInt64Array()
        array.SetNumberOfValues(len(values))
        vtk_to_numpy(array)[:] = values
        arrays.append(array)
    cells = vtkCellArray()
    cells.SetData(*arrays)
    return cells


def _pack_arrays(attributes):
    """Returns all arrays, each with its role (scalars, normals ...)."""
    packed = []
    for index in range(attributes.GetNumberOfArrays()):
        role = getattr(attributes, "IsArrayAnAttribute", lambda _: -1)(index)
        packed.append((role, _pack_array(attributes.GetAbstractArray(index))))
    return packed


def _unpack_arrays(attributes, packed):
    for role, array in packed:
        index = attributes.AddArray(_unpack_array(array))
        if role >= 0:
            attributes.SetActiveAttribute(index, role)


def _pack_array(array):
    """(name, VTK's type, values); texts are a list of tuples' values with the width."""
    if array.IsA("vtkStringArray"):
        texts = [array.GetValue(index) for index in range(array.GetNumberOfValues())]
        return array.GetName(), array.GetNumberOfComponents(), texts
    return array.GetName(), array.GetDataType(), vtk_to_numpy(array)


def _unpack_array(packed):
    name, kind, values = packed
    if isinstance(values, list):
        array = vtkStringArray()
        array.SetNumberOfComponents(kind)
        for text in values:
            array.InsertNextValue(text)
    else:
        array = numpy_to_vtk(np.require(values, requirements="CW"), array_type=kind)
    if name is not None:
        array.SetName(name)
    return array
