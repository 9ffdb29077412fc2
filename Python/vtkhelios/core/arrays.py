# SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
# SPDX-License-Identifier: BSD-3-Clause
"""VTK data as numpy arrays without a copy."""

import gc
import sys
import threading

import numpy
from vtkmodules.util import numpy_support
from vtkmodules.util.numpy_support import vtk_to_numpy
from vtkmodules.vtkCommonCore import vtkObjectBase


_kept = []  # pairs of an array of VTK and the values that it has the memory of
_lock = threading.RLock()


def numpy_to_vtk(values, deep=0, array_type=None):
    """Returns VTK's numpy_to_vtk() of values that may be views of arrays of VTK.

    VTK keeps the values by an attribute of its array in Python, which VTK 9.1 releases while it iterates
    over all of them: if an array of VTK ends thereby, it releases others in between and damages its list.
    Views are kept here instead, as long as VTK or Python uses the array.
    """
    array = numpy_support.numpy_to_vtk(values, deep, array_type)
    if not deep and _is_view(values):
        with _lock:
            _release()
            _kept.append((array, vars(array).pop("_numpy_reference")))
    return array


def _is_view(values):
    """Returns whether values have the memory of an array of VTK."""
    while isinstance(values, numpy.ndarray):
        values = values.base
    return isinstance(getattr(values, "obj", values), vtkObjectBase)


def _count(array):
    return sys.getrefcount(array)


_pair = (object(), None)
_COUNT = _count(_pair[0])  # references of an array that only a pair has


def _release(*_):
    """Ends arrays that nothing uses."""
    with _lock:
        _kept[:] = [
            pair for pair in _kept if pair[0].GetReferenceCount() > 1 or _count(pair[0]) > _COUNT
        ]


gc.callbacks.append(_release)


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
