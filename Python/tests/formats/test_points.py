# SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
# SPDX-License-Identifier: BSD-3-Clause
"""Clouds as input of the voxelizer: arrays, text in pieces, LAS and LAZ in pieces."""

import sys
import gc

import numpy as np
import pytest
from vtkmodules.util.numpy_support import vtk_to_numpy
from vtkmodules.vtkCommonCore import VTK_FLOAT

import vtkhelios
from vtkhelios import points


def lattice(n=20, low=(476000.0, 5473000.0, 110.0)):
    """Points 0.1 m apart at UTM coordinates, the doubles nearest to their decimals, shuffled."""
    index = np.indices((n, n, 3)).reshape(3, -1).T
    xyz = (np.asarray(low) * 10.0 + index) / 10.0
    return np.random.default_rng(5).permutation(xyz)


def voxelize(source, size=0.1, **properties):
    voxelizer = vtkhelios.vtkHeliosPointVoxelizer()
    if hasattr(source, "GetOutputPort"):
        voxelizer.SetInputConnection(source.GetOutputPort())
    else:
        voxelizer.SetInputData(source)
    voxelizer.SetVoxelSize(size)
    for name, value in properties.items():
        getattr(voxelizer, f"Set{name}")(value)
    vtkhelios.update(voxelizer)
    return voxelizer


def connectivity(scene):
    return vtk_to_numpy(scene.GetPolys().GetConnectivityArray())


def same_scene(a, b):
    a, b = a.GetOutput(), b.GetOutput()
    return np.array_equal(
        vtkhelios.arrays(a)["points"], vtkhelios.arrays(b)["points"]
    ) and np.array_equal(connectivity(a), connectivity(b))


def crs_of(data):
    array = data.GetFieldData().GetAbstractArray("CRS")
    return array.GetValue(0) if array else None


# Arrays


def test_arrays_are_not_copied():
    xyz = lattice()
    cloud = points.points_from_arrays(xyz)
    views = vtkhelios.arrays(cloud)
    assert np.shares_memory(views["points"], xyz)
    expected = xyz.copy()
    del xyz
    gc.collect()
    assert np.array_equal(vtkhelios.arrays(cloud)["points"], expected)


def test_arrays_of_other_types():
    cloud = points.points_from_arrays([[0, 0, 0], [1, 2, 3]])
    assert vtkhelios.arrays(cloud)["points"].dtype == np.float64
    cloud = points.points_from_arrays(np.zeros((4, 3), np.float32))
    assert cloud.GetPoints().GetDataType() == VTK_FLOAT  # decimals end at the array's precision
    every_second = lattice()[::2]
    assert np.array_equal(
        vtkhelios.arrays(points.points_from_arrays(every_second))["points"], every_second
    )
    swapped = lattice().astype(">f8")
    assert np.array_equal(vtkhelios.arrays(points.points_from_arrays(swapped))["points"], swapped)


def test_normals_colours_and_crs():
    rgb = np.array([[255, 0, 51], [0, 0, 0]], np.uint8)
    normals = [[0, 0, 2], [0, 3, 0]]
    cloud = points.points_from_arrays([[0, 0, 0], [5, 0, 0]], normals, rgb, crs="EPSG:32632")
    voxelizer = voxelize(cloud, 1.0)
    scene = voxelizer.GetOutput()
    assert crs_of(scene) == "EPSG:32632"
    normal = vtk_to_numpy(scene.GetCellData().GetArray("Normals"))
    assert np.array_equal(normal[[0, 12]], [[0, 0, 1], [0, 1, 0]])
    colour = vtk_to_numpy(scene.GetCellData().GetArray("RGB"))
    assert np.allclose(colour[0], [1.0, 0.0, 0.2], atol=1e-7)


@pytest.mark.parametrize(
    "arguments, message",
    [
        (([1, 2, 3],), r"xyz has the shape \(3,\); give an array of \(n, 3\)"),
        (([[1, 2]],), r"xyz has the shape \(1, 2\)"),
        (([[1, 2, 3]], [[0, 0, 1]] * 2), r"normals has the shape \(2, 3\); .* \(1, 3\)"),
        (([[1, 2, 3]], None, [[1, 2, 3]]), "rgb is int64; give uint8, uint16, or floats"),
    ],
)
def test_bad_arrays(arguments, message):
    with pytest.raises(ValueError, match=message):
        points.points_from_arrays(*arguments)


def test_points_that_are_not_finite():
    message = r"point 1 is \(1, nan, 0\), which is not finite"
    with pytest.raises(vtkhelios.PipelineError, match=message):
        voxelize(points.points_from_arrays([[0, 0, 0], [1, np.nan, 0]]))


# Text in pieces, through the reader


@pytest.mark.parametrize("pieces", [0, 1, 2, 7, 1000])
def test_text_in_pieces(tmp_path, pieces):
    xyz = lattice()
    path = tmp_path / "cloud.xyz"
    np.savetxt(path, xyz, fmt="%.1f", delimiter=";", header="x;y;z", comments="// ")
    reader = vtkhelios.vtkHeliosXyzReader()
    reader.SetFileName(str(path))
    reader.SetSeparators(";")
    voxelizer = voxelize(reader, NumberOfPieces=pieces)
    assert voxelizer.GetNumberOfVoxels() == voxelizer.GetNumberOfPoints() == 20 * 20 * 3
    assert voxelizer.GetOutput().GetNumberOfPolys() == 2 * (2 * 400 + 4 * 60)
    assert same_scene(voxelizer, voxelize(points.points_from_arrays(xyz)))


def test_large_text_streams(tmp_path):
    xyz = np.random.default_rng(1).integers(0, 100, (40000, 3))
    path = tmp_path / "cloud.xyz"
    np.savetxt(path, xyz, fmt="%d")
    reader = vtkhelios.vtkHeliosXyzReader()
    reader.SetFileName(str(path))
    voxelizer = voxelize(reader, 10.0, PointsPerPiece=2000)
    assert voxelizer.GetNumberOfPoints() == 40000
    assert voxelizer.GetNumberOfVoxels() == 1000
    assert 500 < reader.GetOutput().GetNumberOfPoints() < 4000  # the last piece


def test_errors_of_text_are_raised(tmp_path):
    path = tmp_path / "cloud.xyz"
    path.write_text("1 2 3\n" * 5000 + "1 2 x\n" + "1 2 3\n" * 5000)
    reader = vtkhelios.vtkHeliosXyzReader()
    reader.SetFileName(str(path))
    with pytest.raises(vtkhelios.PipelineError, match='cloud.xyz:5001: "x" in column 2'):
        voxelize(reader, NumberOfPieces=10)


# LAS and LAZ


@pytest.fixture(params=["las", "laz"])
def las_file(request, tmp_path):
    """Writes a file of lattice points, with colours and a coordinate system if requested."""
    laspy = pytest.importorskip("laspy")
    if request.param == "laz":
        pytest.importorskip("lazrs")

    def write(xyz=None, version="1.4", wkt=None, epsg=None, colors=False):
        xyz = lattice() if xyz is None else xyz
        new = version == "1.4"
        form = (7 if colors else 6) if new else (3 if colors else 1)
        header = laspy.LasHeader(version=version, point_format=form)
        header.scales, header.offsets = [0.001] * 3, [400000.0, 5000000.0, 0.0]
        if wkt:
            header.vlrs.append(laspy.vlrs.known.WktCoordinateSystemVlr(wkt))
        if epsg:
            keys = np.array([1, 1, 0, 1, 3072, 0, 1, epsg], "<u2").tobytes()
            header.vlrs.append(laspy.VLR("LASF_Projection", 34735, "", keys))
        las = laspy.LasData(header)
        las.x, las.y, las.z = np.asarray(xyz, float).reshape(-1, 3).T
        if colors:
            las.red, las.green, las.blue = [
                np.full(len(xyz), c, np.uint16) for c in (65535, 0, 6553)
            ]
        path = tmp_path / f"cloud.{request.param}"
        las.write(path)
        return path

    return write


@pytest.mark.parametrize("pieces", [0, 1, 7])
def test_las_in_pieces(las_file, pieces):
    source = points.las_source(las_file())
    voxelizer = voxelize(source, NumberOfPieces=pieces)
    assert voxelizer.GetNumberOfVoxels() == voxelizer.GetNumberOfPoints() == 20 * 20 * 3
    assert voxelizer.GetOutput().GetNumberOfPolys() == 2 * (2 * 400 + 4 * 60)


def test_las_is_read_piece_by_piece(las_file):
    xyz = np.round(np.random.default_rng(2).uniform(0, 99, (40000, 3)) + [4e5, 5e6, 0], 3)
    source = points.las_source(las_file(xyz))
    voxelizer = voxelize(source, 10.0, PointsPerPiece=2000)
    assert voxelizer.GetNumberOfPoints() == 40000
    assert source.GetOutputDataObject(0).GetNumberOfPoints() == 2000
    rows = []
    for piece in range(3):
        source.UpdatePiece(piece, 3, 0)
        rows.append(vtkhelios.arrays(source.GetOutputDataObject(0))["points"].copy())
    assert np.allclose(np.concatenate(rows), xyz, rtol=0.0, atol=1e-9)


def test_las_carries_its_coordinate_system(las_file):
    wkt = 'LOCAL_CS["a system"]'
    assert crs_of(voxelize(points.las_source(las_file(wkt=wkt))).GetOutput()) == wkt
    source = points.las_source(las_file(version="1.2", epsg=25832))
    assert crs_of(voxelize(source).GetOutput()) == "EPSG:25832"
    assert crs_of(voxelize(points.las_source(las_file())).GetOutput()) is None


def test_las_colours(las_file):
    path = las_file(colors=True)
    scene = voxelize(points.las_source(path, colors=True)).GetOutput()
    colour = vtk_to_numpy(scene.GetCellData().GetArray("RGB"))
    assert np.allclose(colour[0], [1.0, 0.0, 6553 / 65535], atol=1e-7)
    scene = voxelize(points.las_source(path)).GetOutput()
    assert scene.GetCellData().GetArray("RGB") is None  # only requested data
    with pytest.raises(ValueError, match="has no colours; leave colors off"):
        points.las_source(las_file(), colors=True)


def test_bad_las_files(las_file, tmp_path):
    with pytest.raises(ValueError, match="has no points"):
        points.las_source(las_file(np.empty((0, 3))))
    with pytest.raises(FileNotFoundError):
        points.las_source(tmp_path / "none.las")
    path = las_file()
    whole = path.read_bytes()
    path.write_bytes(b"PK" + whole[2:])
    with pytest.raises(ValueError, match="cannot be read"):
        points.las_source(path)


def test_truncated_las(las_file):
    path = las_file()
    whole = path.read_bytes()
    source = points.las_source(path)
    path.write_bytes(whole[: len(whole) * 2 // 3])
    with pytest.raises(vtkhelios.PipelineError, match="cloud.la[sz]: points .* cannot be read"):
        voxelize(source, NumberOfPieces=3)


def test_las_without_laspy(monkeypatch, tmp_path):
    monkeypatch.setitem(sys.modules, "laspy", None)
    with pytest.raises(ImportError, match="pip install --no-deps laspy"):
        points.las_source(tmp_path / "cloud.las")


def test_las_coordinates_that_are_not_finite(las_file):
    path = las_file()
    data = bytearray(path.read_bytes())
    data[131:139] = np.float64(1e308).tobytes()  # the scale of x
    path.write_bytes(data)
    with pytest.raises((ValueError, vtkhelios.PipelineError), match="scale|finite"):
        vtkhelios.update(points.las_source(path))
