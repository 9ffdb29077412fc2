# SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
# SPDX-License-Identifier: BSD-3-Clause
"""VTK data as numpy arrays without a copy."""

from vtkmodules.util.numpy_support import vtk_to_numpy


def arrays(data):
    """Returns the arrays of a data object as numpy arrays that share its memory.

    Of a point set: ``points`` (n x 3) and every point array; of a table: every column and every
    array of the field data (waveforms keep their samples there); of an image: every point array.
    String arrays are skipped.

    Nothing is copied: writing to a view writes to the data object, and a view stays valid as long
    as it exists, also after the data object is deleted. (A filter that runs again creates new
    arrays; a view keeps showing the old ones.)

    >>> echoes = vtkhelios.arrays(vtkhelios.update(scanner))
    >>> echoes["points"][echoes["ReturnNumber"] == 1]
    """
    views = {}
    if data.IsA("vtkTable"):
        _add_views(views, data.GetFieldData())
        _add_views(views, data.GetRowData())
    elif data.IsA("vtkDataSet"):
        _add_views(views, data.GetPointData())
    else:
        raise TypeError(f"arrays() takes a data set or a table, not a {data.GetClassName()}")
    if data.IsA("vtkPointSet") and data.GetPoints():
        views["points"] = vtk_to_numpy(data.GetPoints().GetData())
    return views


def _add_views(views, attributes):
    for index in range(attributes.GetNumberOfArrays()):
        array = attributes.GetArray(index)  # None for strings
        if array is not None and array.GetName():
            name = array.GetName()
            if isinstance(name, bytes):  # VTK returns bytes if not UTF-8
                name = name.decode(errors="backslashreplace")
            views[name] = vtk_to_numpy(array)
