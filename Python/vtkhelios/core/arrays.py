# SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
# SPDX-License-Identifier: BSD-3-Clause
"""VTK data as numpy arrays without a copy."""

from vtkmodules.util import numpy_support
from vtkmodules.util.numpy_support import vtk_to_numpy
from vtkmodules.vtkCommonCore import vtkCommand


def numpy_to_vtk(values, deep=0, array_type=None):
    """Returns VTK's numpy_to_vtk(), whose array keeps the memory of the values by an observer.

    VTK keeps it by an attribute of the array in Python, which VTK 9.1 releases while it iterates over such
    attributes: memory of another array of VTK is then freed in between, and its list is damaged.
    """
    array = numpy_support.numpy_to_vtk(values, deep, array_type)
    kept = vars(array).pop("_numpy_reference", None)
    if kept is not None:
        array.AddObserver(vtkCommand.DeleteEvent, lambda *_, kept=kept: None)
    return array


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
