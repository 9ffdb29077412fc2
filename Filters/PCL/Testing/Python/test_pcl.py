# SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
# SPDX-License-Identifier: BSD-3-Clause
"""PCL clouds in Python: views without copies, which outlive their cloud; and the filters."""

import gc

import numpy as np
import pytest
from vtkmodules.util.numpy_support import numpy_to_vtk, vtk_to_numpy
from vtkmodules.vtkCommonCore import vtkPoints
from vtkmodules.vtkCommonDataModel import vtkImageData, vtkPolyData

import vtkhelios

pytest.importorskip("vtkhelios.pcl")
from vtkhelios import pcl  # noqa: E402

UTM = np.array([476123.4567, 5473987.6543, 312.3456])


def make_echoes(count=1000):
    random = np.random.default_rng(1)
    points = vtkPoints()
    points.SetData(numpy_to_vtk(UTM + random.uniform(-500, 500, (count, 3)), deep=1))
    echoes = vtkPolyData()
    echoes.SetPoints(points)
    columns = {
        "Amplitude": np.arange(count, dtype=np.float32),
        "GpsTime": 2.5e8 + 1e-6 * np.arange(count),
        "PulseIds": 2**60 + np.arange(count, dtype=np.int64),
        "ReturnNumber": np.full(count, 2, np.uint8),
    }
    for name, values in columns.items():
        array = numpy_to_vtk(values, deep=1)
        array.SetName(name)
        echoes.GetPointData().AddArray(array)
    return echoes


def address(array):
    return array.__array_interface__["data"][0]


def test_views_share_memory():
    cloud = pcl.CloudEcho.from_polydata(make_echoes())
    points, fields = cloud.points, cloud.array
    assert points.shape == (1000, 3) and points.dtype == np.float32
    assert not points.flags.owndata
    assert address(points) == address(fields) == address(cloud.points)
    assert points.strides == (fields.dtype.itemsize, 4)
    offset = fields.dtype.fields["GpsTime"][1]
    assert address(cloud["GpsTime"]) == address(points) + offset
    points[3] = [1, 2, 3]
    assert list(cloud.array[3])[:3] == [1, 2, 3]
    assert cloud.to_polydata().GetPoint(3) == tuple(cloud.origin + [1, 2, 3])


def test_fields_equal_the_arrays_of_the_echoes():
    echoes = make_echoes()
    cloud = pcl.CloudEcho.from_polydata(echoes)
    assert len(cloud) == 1000
    assert (cloud["PulseIds"] == 2**60 + np.arange(1000)).all()
    assert (cloud["GpsTime"] == 2.5e8 + 1e-6 * np.arange(1000)).all()
    assert (cloud["ReturnNumber"] == 2).all() and (cloud["EchoWidth"] == 0).all()
    assert "CloudEcho of 1000 points, origin [" in repr(cloud)
    truth = vtk_to_numpy(echoes.GetPoints().GetData())
    assert np.abs(cloud.points + cloud.origin - truth).max() < 1e-4
    back = cloud.to_polydata()
    assert np.abs(vtk_to_numpy(back.GetPoints().GetData()) - truth).max() < 1e-4
    assert back.GetPointData().GetArray("PulseIds").GetValue(7) == 2**60 + 7


def test_views_outlive_their_cloud():
    cloud = pcl.CloudXYZI.from_polydata(make_echoes(100000))
    points, intensity = cloud.points, cloud["intensity"]
    expected = points.copy()
    del cloud
    gc.collect()
    others = [np.full(100000, i, np.float64) for i in range(50)]  # reuses freed memory
    assert (points == expected).all() and (intensity == np.arange(100000)).all()
    del others


def test_memory_does_not_grow():
    import resource

    echoes = make_echoes(100000)
    sizes = []
    for i in range(120):
        cloud = pcl.CloudEcho.from_polydata(echoes)
        cloud.points, cloud.array, cloud.to_polydata()
        if i in (20, 119):
            sizes.append(resource.getrusage(resource.RUSAGE_SELF).ru_maxrss)
    assert sizes[1] - sizes[0] < 8000  # KiB; one cloud has 6 MB


@pytest.mark.parametrize("name", ["CloudXYZ", "CloudXYZI", "CloudXYZINormal", "CloudEcho"])
def test_every_type(name):
    cloud = getattr(pcl, name).from_polydata(make_echoes(10), origin=UTM)
    assert (cloud.origin == UTM).all()
    assert cloud.array.dtype.names[:3] == ("x", "y", "z")
    assert cloud.to_polydata().GetNumberOfPoints() == 10
    empty = getattr(pcl, name).from_polydata(vtkPolyData())
    assert len(empty) == 0 and empty.points.shape == (0, 3)


def test_bad_input():
    with pytest.raises(TypeError, match="a cloud needs a vtkPolyData, not vtkImageData"):
        pcl.CloudXYZ.from_polydata(vtkImageData())
    with pytest.raises(TypeError, match="not list"):
        pcl.CloudXYZ.from_polydata([1, 2, 3])
    with pytest.raises(ValueError, match="an origin is three numbers, x y z"):
        pcl.CloudXYZ.from_polydata(make_echoes(3), origin=[1, 2])
    echoes = make_echoes(3)
    short = numpy_to_vtk(np.zeros(2), deep=1)
    short.SetName("GpsTime")
    echoes.GetPointData().AddArray(short)
    with pytest.raises(ValueError, match=r"GpsTime holds 2 x 1 values \(double\), not 3 x 1"):
        pcl.CloudEcho.from_polydata(echoes)
    cloud = pcl.CloudXYZ.from_polydata(make_echoes(3))
    with pytest.raises(ValueError):
        cloud["GpsTime"]


def test_filters_in_a_pipeline():
    voxels = vtkhelios.vtkHeliosPCLVoxelGrid()
    voxels.SetInputData(make_echoes())
    voxels.SetVoxelSize(100.0)
    clusters = vtkhelios.vtkHeliosPCLClusters()
    clusters.SetInputConnection(voxels.GetOutputPort())
    clusters.SetTolerance(200.0)
    vtkhelios.update(clusters)
    found = clusters.GetOutput()
    assert 500 < found.GetNumberOfPoints() < 1000
    assert found.GetPointData().GetArray("ClusterIds") and clusters.GetNumberOfClusters() >= 1
    clusters.SetMinimumClusterSize(9)
    clusters.SetMaximumClusterSize(3)
    with pytest.raises(vtkhelios.PipelineError, match="set a smaller one"):
        vtkhelios.update(clusters)


def test_pcd_round_trip(tmp_path):
    writer = vtkhelios.vtkHeliosPCDWriter()
    writer.SetFileName(str(tmp_path / "a.pcd"))
    writer.SetPrecision(writer.Double)
    echoes = make_echoes()
    assert writer.Open() and writer.Write(echoes) and writer.Close()
    reader = vtkhelios.vtkHeliosPCDReader()
    reader.SetFileName(str(tmp_path / "a.pcd"))
    vtkhelios.update(reader)
    for get in (
        lambda data: data.GetPoints().GetData(),
        lambda data: data.GetPointData().GetArray("PulseIds"),
    ):
        assert (vtk_to_numpy(get(reader.GetOutput())) == vtk_to_numpy(get(echoes))).all()


def test_planes_print_nothing(capfd):
    """Collinear points are not a plane: PCL would report each sample of three to stderr."""
    random = np.random.default_rng(1)
    line = np.linspace(0, 10, 1000)[:, None] * [1.0, 0.0, 0.0]
    some = random.uniform(0, 10, (60, 3)) * [1.0, 1.0, 0.0]
    cloud, points = vtkPolyData(), vtkPoints()
    points.SetData(numpy_to_vtk(np.concatenate([line, some]), deep=1))
    cloud.SetPoints(points)
    planes = vtkhelios.vtkHeliosPCLPlanes()
    planes.SetInputData(cloud)
    planes.Update()
    assert planes.GetOutput().GetNumberOfPoints() == 1060
    assert capfd.readouterr().err == ""
