# SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
# SPDX-License-Identifier: BSD-3-Clause
"""arrays(): views of VTK data that share its memory."""

import gc
import pathlib
import re

import numpy as np
import pytest
from vtkmodules.vtkCommonCore import (
    VTK_DOUBLE,
    vtkDoubleArray,
    vtkIdTypeArray,
    vtkPoints,
    vtkStringArray,
)
from vtkmodules.vtkCommonDataModel import vtkDataObject, vtkPolyData, vtkTable
from vtkmodules.util.numpy_support import vtk_to_numpy

import vtkhelios
from vtkhelios.core.arrays import numpy_to_vtk


def address(array):
    return array.__array_interface__["data"][0]


def vtk_address(data_array):
    return int(data_array.GetVoidPointer(0).split("_")[1], 16)


@pytest.fixture
def cloud():
    data = vtkPolyData()
    points = vtkPoints()
    points.SetDataType(VTK_DOUBLE)
    for x in range(5):
        points.InsertNextPoint(500000.123456789 + x, 5500000.0, 300.0)
    data.SetPoints(points)
    ids = vtkIdTypeArray()
    ids.SetName("PulseIds")
    for i in range(5):
        ids.InsertNextValue(2**40 + i)
    data.GetPointData().AddArray(ids)
    return data


def test_views_share_memory(cloud):
    views = vtkhelios.arrays(cloud)
    assert sorted(views) == ["PulseIds", "points"]
    assert address(views["points"]) == vtk_address(cloud.GetPoints().GetData())
    assert address(views["PulseIds"]) == vtk_address(cloud.GetPointData().GetArray("PulseIds"))
    views["points"][2, 0] = -1.0
    assert cloud.GetPoint(2)[0] == -1.0


def test_types_and_shapes(cloud):
    views = vtkhelios.arrays(cloud)
    assert views["points"].shape == (5, 3) and views["points"].dtype == np.float64
    assert views["PulseIds"].dtype == np.int64
    assert views["PulseIds"][4] == 2**40 + 4


def test_views_outlive_the_data(cloud):
    views = vtkhelios.arrays(cloud)
    before = views["points"].copy()
    cloud.Initialize()
    del cloud
    gc.collect()
    assert (views["points"] == before).all()


def test_empty_cloud():
    assert vtkhelios.arrays(vtkPolyData()) == {}
    data = vtkPolyData()
    data.SetPoints(vtkPoints())
    assert vtkhelios.arrays(data)["points"].shape == (0, 3)


def test_table_with_samples():
    table = vtkTable()
    column = vtkIdTypeArray()
    column.SetName("Offset")
    column.InsertNextValue(7)
    table.AddColumn(column)
    samples = vtkIdTypeArray()
    samples.SetName("Samples")
    table.GetFieldData().AddArray(samples)
    names = vtkStringArray()
    names.SetName("Part.Name")
    table.GetFieldData().AddArray(names)
    views = vtkhelios.arrays(table)
    assert sorted(views) == ["Offset", "Samples"]
    assert address(views["Offset"]) == vtk_address(column)


def test_other_data_is_refused():
    with pytest.raises(TypeError, match="not a vtkDataObject"):
        vtkhelios.arrays(vtkDataObject())


def test_same_as_stock_vtk(cloud):
    assert (vtkhelios.arrays(cloud)["points"] == vtk_to_numpy(cloud.GetPoints().GetData())).all()


def test_names_that_are_not_utf8():
    from vtkmodules.vtkCommonCore import vtkFloatArray
    from vtkmodules.vtkCommonDataModel import vtkPolyData

    cloud = vtkPolyData()
    array = vtkFloatArray()
    array.SetName(b"\xfdum")
    cloud.GetPointData().AddArray(array)
    assert list(vtkhelios.arrays(cloud)) == ["\\xfdum"]


@pytest.mark.parametrize("user", ["python", "vtk", "numpy"])
def test_views_of_vtk_are_kept_as_long_as_they_are_used(user):
    first = vtkDoubleArray()
    first.SetNumberOfValues(1000)
    vtk_to_numpy(first)[:] = np.arange(1000.0)
    ended = []
    first.AddObserver("DeleteEvent", lambda *_: ended.append(1))
    array = numpy_to_vtk(vtk_to_numpy(first)[500:])
    assert not hasattr(array, "_numpy_reference")
    data = vtkPolyData()
    data.GetPointData().AddArray(array)
    used = {"python": array, "vtk": data, "numpy": vtk_to_numpy(array)}[user]
    del first, array, data
    gc.collect()
    assert not ended
    if user == "vtk":
        values = vtk_to_numpy(used.GetPointData().GetArray(0))
    else:
        values = vtk_to_numpy(used) if user == "python" else used
    assert values[0] == 500 and values[-1] == 999
    del used, values
    gc.collect()
    assert ended


def test_the_package_gives_memory_to_vtk_in_one_way():
    """See numpy_to_vtk() in core/arrays.py."""
    root = pathlib.Path(__file__).resolve().parents[1] / "vtkhelios"
    direct = re.compile(r"numpy_support import .*\bnumpy_to_vtk\b")
    users = [path.name for path in root.rglob("*.py") if direct.search(path.read_text())]
    assert users == [], "import numpy_to_vtk from core.arrays"
