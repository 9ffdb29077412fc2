# SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
# SPDX-License-Identifier: BSD-3-Clause
"""A Cloud as an object of pandas, PyVista or Open3D; see the methods of Cloud."""

import numpy as np
from vtkmodules.util.numpy_support import vtk_to_numpy

from ..array_names import NORMALS, ORIENTATION, RGB, UNITS
from ..core.paths import text_from_vtk
from . import load

_AXES = {3: "XYZ", 4: "XYZW"}


def to_pandas(cloud):
    """Returns the table of Cloud.to_pandas()."""
    pandas = load("pandas", "to_pandas() needs")
    columns = {axis: cloud.points[:, index] for index, axis in enumerate("xyz")}
    units = dict.fromkeys("xyz", "m")
    for name in cloud.names:
        for column, values in _split(name, cloud[name]):
            columns[column] = values
            if name in UNITS:
                units[column] = UNITS[name]
    frame = pandas.DataFrame(columns, copy=False)
    fields = read_fields(cloud.data)
    frame.attrs = {"units": units, **{name: _plain(values) for name, values in fields.items()}}
    return frame


def _split(name, values):
    """Returns the names and columns of an array; an array of three components has the columns NameX
    to NameZ."""
    if values.ndim == 1:
        return [(name, values)]
    width = values.shape[1]
    axes = "WXYZ" if name == ORIENTATION else _AXES.get(width, range(width))
    return [(f"{name}{axis}", values[:, index]) for index, axis in enumerate(axes)]


def _plain(values):
    """Returns the values of a field array as Python's own, which attrs of pandas can be compared
    and saved with."""
    values = values if isinstance(values, list) else values.tolist()
    return values[0] if len(values) == 1 else values


def to_pyvista(cloud):
    """Returns the mesh of Cloud.to_pyvista()."""
    pyvista = load("pyvista", "to_pyvista() needs")
    mesh = pyvista.PolyData(cloud.points) if len(cloud) else pyvista.PolyData()
    if len(cloud):
        for name in cloud.names:
            mesh.point_data[name] = cloud[name]
        mesh.set_active_scalars(None)
    add_fields(mesh, cloud.data)
    return mesh


def add_fields(mesh, data):
    """Copies the field arrays of VTK data to a mesh of PyVista."""
    for name, values in read_fields(data).items():
        if len(values):
            mesh.field_data[name] = values


def scene_to_pyvista(mesh):
    """Returns the mesh of Scene.to_pyvista()."""
    pyvista, polys = load("pyvista", "to_pyvista() needs"), mesh.GetPolys()
    if not mesh.GetNumberOfPolys():
        return pyvista.PolyData()
    corners = vtk_to_numpy(polys.GetConnectivityArray()).reshape(-1, 3)
    faces = np.column_stack([np.full(len(corners), 3, np.int64), corners])
    result = pyvista.PolyData(vtk_to_numpy(mesh.GetPoints().GetData()), faces)
    data = mesh.GetCellData()
    for index in range(data.GetNumberOfArrays()):
        if (array := data.GetArray(index)) is not None:  # None for texts
            result.cell_data[array.GetName()] = vtk_to_numpy(array)
    result.set_active_scalars(None)
    add_fields(result, mesh)
    return result


def to_open3d(cloud):
    """Returns the point cloud of Cloud.to_open3d()."""
    open3d = load("open3d", "to_open3d() needs")
    tensor = open3d.core.Tensor.from_numpy
    result = open3d.t.geometry.PointCloud()
    if not len(cloud):
        return result
    result.point["positions"] = tensor(cloud.points)
    for name in cloud.names:
        values = cloud[name]
        values = values.reshape(len(values), -1)
        result.point[_OPEN3D.get(name, name)] = tensor(values)
    return result


_OPEN3D = {NORMALS: "normals", RGB: "colors"}  # names that its own functions expect


def read_fields(data):
    """Returns the field arrays of VTK data by name: numpy arrays without a copy, and lists of
    texts."""
    held, fields = data.GetFieldData(), {}
    for index in range(held.GetNumberOfArrays()):
        array = held.GetAbstractArray(index)
        name = text_from_vtk(array.GetName())
        if array.IsA("vtkStringArray"):
            texts = [text_from_vtk(array.GetValue(i)) for i in range(array.GetNumberOfValues())]
            fields[name] = texts
        elif name:
            fields[name] = np.asarray(vtk_to_numpy(array))
    return fields
