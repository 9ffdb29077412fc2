# SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
# SPDX-License-Identifier: BSD-3-Clause
"""Clouds as objects of pandas, PyVista and Open3D."""

import sys

import numpy as np
import pytest
from vtkmodules.vtkCommonCore import vtkStringArray

import vtkhelios
from vtkhelios.array_names import AMPLITUDE, CRS, GPS_TIME, NORMALS, ORIENTATION, RGB, TRUE_POINT


@pytest.fixture
def cloud():
    """Five points with arrays of one, three and four components, and field arrays."""
    rng = np.random.default_rng(1)
    columns = {
        GPS_TIME: np.linspace(0, 1, 5),
        AMPLITUDE: rng.random(5, dtype=np.float32),
        "ReturnNumber": np.arange(5, dtype=np.uint8),
        "PulseIds": np.arange(5) + 2**40,
        TRUE_POINT: rng.random((5, 3)),
        ORIENTATION: rng.random((5, 4)),
        NORMALS: rng.random((5, 3)),
        RGB: rng.random((5, 3), dtype=np.float32),
    }
    made = vtkhelios.Cloud.from_arrays(5e5 + rng.random((5, 3)), **columns)
    crs = vtkStringArray()
    crs.SetName(CRS)
    crs.InsertNextValue("EPSG:25832")
    made.data.GetFieldData().AddArray(crs)
    return made


@pytest.fixture
def survey_cloud():
    plane = vtkhelios.Scene([(-9, -9, 0), (9, -9, 0), (0, 9, 0)], [(0, 1, 2)])
    return vtkhelios.scan(
        plane, position=(0, 0), scan_frequency=10, vertical=(-40, 0), head=(0, 9), head_speed=60
    )


def test_pandas(cloud):
    pytest.importorskip("pandas")
    frame = cloud.to_pandas()
    assert list(frame.columns[:5]) == ["x", "y", "z", GPS_TIME, AMPLITUDE]
    assert list(frame.columns[5:]) == [
        "ReturnNumber", "PulseIds", "TruePointX", "TruePointY", "TruePointZ", "OrientationW",
        "OrientationX", "OrientationY", "OrientationZ", "NormalsX", "NormalsY", "NormalsZ", "RGBX",
        "RGBY", "RGBZ",
    ]  # fmt: skip
    assert np.array_equal(frame[["x", "y", "z"]], cloud.points)
    assert np.array_equal(frame.OrientationW, cloud[ORIENTATION][:, 0])
    for column, name in ((GPS_TIME, GPS_TIME), (AMPLITUDE, AMPLITUDE), ("PulseIds", "PulseIds")):
        assert frame[column].dtype == cloud[name].dtype
        assert np.shares_memory(frame[column].to_numpy(), cloud[name])
    assert np.shares_memory(frame.x.to_numpy(), cloud.points)
    assert frame.attrs["CRS"] == "EPSG:25832"
    assert frame.attrs["units"] == {
        **dict.fromkeys("xyz", "m"), GPS_TIME: "s", AMPLITUDE: "W",
        "TruePointX": "m", "TruePointY": "m", "TruePointZ": "m",
    }  # fmt: skip


def test_pandas_of_a_survey(survey_cloud):
    pytest.importorskip("pandas")
    frame = survey_cloud.to_pandas()
    assert len(frame) == len(survey_cloud) > 100
    ranges = frame.groupby("LegIds").Range.agg(["min", "max"])
    assert ranges.loc[0, "max"] == survey_cloud["Range"].max()
    assert frame.attrs["Material.Name"] == "material0"


def check_pyvista(mesh, cloud):
    assert mesh.n_points == mesh.n_cells == mesh.n_verts == len(cloud)
    assert mesh.points.dtype == np.float64 and np.shares_memory(mesh.points, cloud.points)
    for name in cloud.names:
        assert mesh.point_data[name].dtype == cloud[name].dtype
        assert np.shares_memory(mesh.point_data[name], cloud[name]), name
    assert mesh.active_scalars_name is None


def test_pyvista(cloud):
    pytest.importorskip("pyvista")
    mesh = cloud.to_pyvista()
    check_pyvista(mesh, cloud)
    assert list(mesh.field_data[CRS]) == ["EPSG:25832"]
    before = mesh.point_data[AMPLITUDE].copy()
    cloud[AMPLITUDE][:] += 1
    assert np.array_equal(mesh.point_data[AMPLITUDE], before + 1)


def test_pyvista_outlives_the_cloud(survey_cloud):
    pytest.importorskip("pyvista")
    mesh, expected = survey_cloud.to_pyvista(), survey_cloud.points.sum()
    del survey_cloud
    assert mesh.points.sum() == expected


def test_open3d(cloud):
    pytest.importorskip("open3d")
    result = cloud.to_open3d()
    assert np.shares_memory(result.point.positions.numpy(), cloud.points)
    assert np.array_equal(result.point.normals.numpy(), cloud[NORMALS])
    assert np.array_equal(result.point.colors.numpy(), cloud[RGB])
    assert np.array_equal(result.point[GPS_TIME].numpy()[:, 0], cloud[GPS_TIME])
    legacy = result.to_legacy()
    assert np.array_equal(np.asarray(legacy.points), cloud.points)


@pytest.mark.parametrize("name", ["pandas", "pyvista"])
def test_an_empty_cloud(name):
    pytest.importorskip(name)
    empty = getattr(vtkhelios.Cloud(), f"to_{name}")()
    assert (empty.n_points if name == "pyvista" else len(empty)) == 0


@pytest.mark.parametrize("name", ["pandas", "pyvista", "open3d"])
def test_a_library_that_is_missing(name, cloud, monkeypatch):
    monkeypatch.setitem(sys.modules, name, None)
    with pytest.raises(
        ImportError,
        match=rf"^to_{name}\(\) needs the package {name}, which is not installed: .*pip install",
    ):
        getattr(cloud, f"to_{name}")()
