# SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
# SPDX-License-Identifier: BSD-3-Clause
"""Clouds: views of VTK's memory, tables of records, files."""

import gc
import os
import shutil
import subprocess
import sys
import traceback

import numpy as np
import pytest
from vtkmodules.vtkCommonCore import vtkFloatArray
from vtkmodules.vtkCommonDataModel import vtkPolyData, vtkTable
from vtkmodules.vtkIOXML import vtkXMLPolyDataReader

import vtkhelios
from vtkhelios import Cloud, formats


@pytest.fixture
def cloud():
    """Five points with arrays."""
    points = np.arange(15.0).reshape(5, 3)
    return Cloud.from_arrays(
        points, Range=np.arange(5.0), PulseIds=np.arange(5) * 2, Normal=points.copy()
    )


def address(array):
    """The address of an array in VTK, without its prefix."""
    return int(array.GetVoidPointer(0).split("_")[1], 16)


def test_arrays_are_not_copied():
    points, ranges = np.random.default_rng(1).random((7, 3)), np.arange(7.0)
    cloud = Cloud.from_arrays(points, Range=ranges)
    inside = cloud.polydata
    assert address(inside.GetPoints().GetData()) == points.ctypes.data == cloud.points.ctypes.data
    column = inside.GetPointData().GetArray("Range")
    assert address(column) == ranges.ctypes.data == cloud["Range"].ctypes.data
    records = cloud.records
    assert records["Range"].ctypes.data == ranges.ctypes.data
    assert records["z"].ctypes.data == points.ctypes.data + 16
    assert records[2:]["y"].ctypes.data == points.ctypes.data + 2 * 24 + 8
    records["Range"][3] = 99
    assert ranges[3] == 99


def test_echoes_of_a_scanner_are_not_copied():
    scene = vtkhelios.vtkHeliosSyntheticScene(kind="blocks")()
    cloud = Cloud(scene)
    assert cloud.polydata is scene
    assert cloud.points.ctypes.data == address(scene.GetPoints().GetData())


def test_memory_outlives_its_source():
    def make():
        return Cloud.from_arrays(np.full((1000, 3), 7.0), Range=np.full(1000, 3.0)).polydata

    data = make()
    gc.collect()
    np.full((1000, 3), 1.0)  # would reuse the memory
    assert (Cloud(data).points == 7).all() and (Cloud(data)["Range"] == 3).all()
    view = Cloud(make()).points
    gc.collect()
    assert (view == 7).all()


def test_to_structured(cloud):
    table = cloud.to_structured()
    assert table.dtype.names == ("x", "y", "z", "Range", "PulseIds", "Normal")
    assert table["PulseIds"].dtype == np.int64 and table["Normal"].shape == (5, 3)
    assert np.array_equal(table["y"], cloud.points[:, 1])
    assert cloud.to_structured(["Range", "x"]).dtype.names == ("Range", "x")
    table["Range"] = -1
    assert cloud["Range"][1] == 1  # a copy
    with pytest.raises(KeyError, match="there is no field Rang; it has: x, y, z, Range"):
        cloud.to_structured(["Rang"])


def test_records(cloud):
    records = cloud.records
    assert len(records) == 5 and records.dtype == cloud.to_structured().dtype
    assert records[3]["Range"] == 3 and records[3]["Normal"].tolist() == [9, 10, 11]
    assert records[[0, 2]]["x"].tolist() == [0, 6]
    assert records[cloud["Range"] > 2].shape == (2,)
    assert [row["PulseIds"] for row in records] == [0, 2, 4, 6, 8]
    assert np.asarray(records)["z"].tolist() == [2, 5, 8, 11, 14]
    assert repr(records) == "Records(5 rows: x, y, z, Range, PulseIds, Normal)"


def test_filter(cloud):
    kept = cloud[cloud["Range"] >= 3]
    assert kept["PulseIds"].tolist() == [6, 8] and kept.points.tolist() == [
        [9, 10, 11],
        [12, 13, 14],
    ]
    assert cloud[[4, 0]]["Range"].tolist() == [4, 0] and len(cloud[1:3]) == 2
    assert len(cloud.filter(np.zeros(5, bool))) == 0
    with pytest.raises(ValueError, match="the mask has 4 rows; give one per point: 5"):
        cloud.filter(np.ones(4, bool))
    with pytest.raises(TypeError, match="indexed by a boolean mask or by indices, not by float64"):
        cloud.filter(np.ones(5))


def test_arrays_are_added(cloud):
    cloud["Near"] = cloud["Range"] < 2
    assert cloud["Near"].dtype == np.uint8 and "Near" in cloud
    with pytest.raises(ValueError, match=r"Far has the shape \(3,\); give 5 rows"):
        cloud["Far"] = [1, 2, 3]
    with pytest.raises(TypeError, match="Name is of <U1; give numbers"):
        cloud["Name"] = list("abcde")
    with pytest.raises(KeyError, match="has no array Rnge; did you mean Range?"):
        cloud["Rnge"]


def test_objects_that_are_not_clouds():
    with pytest.raises(
        TypeError, match="made of a vtkPolyData, not of ndarray; see Cloud.from_arrays"
    ):
        Cloud(np.zeros((3, 3)))
    with pytest.raises(
        ValueError, match=r"points has the shape \(3, 2\); give an array of \(n, 3\)"
    ):
        Cloud.from_arrays(np.zeros((3, 2)))


def test_a_cloud_is_a_sequence_of_points(cloud):
    assert len(cloud) == 5 and cloud[3]["Range"] == 3 and cloud[-1]["x"] == 12
    assert [point["PulseIds"] for point in cloud] == [0, 2, 4, 6, 8]
    with pytest.raises(IndexError, match="index 5 is out of bounds .* size 5"):
        cloud[5]
    assert np.asarray(cloud) is not None and np.shares_memory(np.asarray(cloud), cloud.points)
    assert np.asarray(cloud, np.float32).dtype == np.float32 and np.asarray(cloud).shape == (5, 3)
    assert cloud.bounds == (0, 12, 1, 13, 2, 14) and np.isnan(Cloud().bounds).all()
    cloud.z = 7
    assert cloud.x.tolist() == [0, 3, 6, 9, 12] and set(cloud.z) == {7} and cloud.y[1] == 4


def test_sums(cloud):
    other = Cloud.from_arrays(np.full((2, 3), 50.0), Range=[1.0, 2.0], ReturnNumber=[1, 2])
    joined = cloud + other
    assert len(joined) == 7 and joined.points[5:].tolist() == [[50, 50, 50], [50, 50, 50]]
    assert joined["Range"].tolist() == [0, 1, 2, 3, 4, 1, 2]
    assert joined["PulseIds"].tolist() == [
        0,
        2,
        4,
        6,
        8,
        -1,
        -1,
    ]  # vtkhelios convert --merge gives -1, too
    assert joined["ReturnNumber"].tolist() == [1, 1, 1, 1, 1, 1, 2]
    assert np.isnan(joined["Normal"][5:]).all() and len(sum([cloud, other, other])) == 9
    with pytest.raises(TypeError, match="unsupported operand"):
        cloud + 1
    with pytest.raises(TypeError, match="unsupported operand"):
        1 + cloud


def with_fields(crs="", epoch=0.0, names=()):
    header = formats.Header()
    header.crs, header.epoch, header.part_names = crs, epoch, list(names)
    cloud = Cloud.from_arrays(np.zeros((1, 3)), GpsTime=[5.0], PartIds=[0])
    cloud.data.GetFieldData().ShallowCopy(header.fields)
    return cloud


def test_sums_have_one_system_one_epoch_and_one_table_of_names():
    joined = with_fields("EPSG:25832", 100.0, ["oak"]) + with_fields("EPSG:25832", 130.0, ["fir"])
    assert joined["GpsTime"].tolist() == [5, 35] and joined["PartIds"].tolist() == [0, 1]
    header = formats.Header(joined.data.GetFieldData())
    assert (header.crs, header.epoch) == ("EPSG:25832", 100.0)
    assert header.part_names == ["oak", "fir"]
    with pytest.raises(ValueError, match="the coordinate systems EPSG:25832 and EPSG:32632; move"):
        with_fields("EPSG:25832") + with_fields("EPSG:32632")
    with pytest.raises(ValueError, match="counts from a known epoch, and of the other not; set"):
        with_fields(epoch=100.0) + with_fields()


def test_names_of_laspy_and_pdal_are_known():
    zeros = np.zeros((3, 3))
    cloud = Cloud.from_arrays(zeros, ClassificationIds=[1, 2, 3], GpsTime=[0.0, 1, 2],
                              Amplitude=[1.0, 2, 3], ScanAngle=[0.0, 1, 2], LegIds=[0, 0, 1])  # fmt: skip
    with pytest.warns(UserWarning, match=r"gps_time is GpsTime here: cloud\['GpsTime'\]"):
        assert cloud["gps_time"].tolist() == [0, 1, 2]
    with pytest.warns(UserWarning, match="classification is ClassificationIds here"):
        cloud.classification[0] = 9
    with pytest.warns(UserWarning, match="Classification is ClassificationIds here"):
        cloud["Classification"] = [6, 6, 6]
    assert cloud["ClassificationIds"].tolist() == [6, 6, 6] and "Classification" not in cloud
    with pytest.warns(UserWarning):
        cloud.classification = [2, 2, 2]
    assert cloud["ClassificationIds"].tolist() == [2, 2, 2]
    cloud["X"] = [7, 8, 9]
    assert cloud.points[:, 0].tolist() == cloud["x"].tolist() == [7, 8, 9]
    assert np.shares_memory(cloud.xyz, cloud.points) and len(cloud.names) == 5


@pytest.mark.parametrize(
    "name, message",
    [
        ("intensity", r"it has Amplitude, the received power \[W\], which no writer has scaled"),
        ("scan_angle", "it has ScanAngle, in degrees, not in steps of 0.006 degrees"),
        (
            "point_source_id",
            "it has LegIds, the number of the leg, which is the point source less 1",
        ),
        ("red", "it has RGB, red, green and blue from 0 to 1"),
        ("Amplituda", r"did you mean Amplitude\?"),
    ],
)
def test_names_for_other_values_are_errors_with_one_hint(name, message):
    cloud = Cloud.from_arrays(np.zeros((1, 3)), Amplitude=[1.0], ScanAngle=[1.0], LegIds=[0],
                              RGB=np.zeros((1, 3)))  # fmt: skip
    with pytest.raises(KeyError, match=f"the cloud has no array {name}; {message}"):
        cloud[name]
    with pytest.raises(AttributeError, match=message) as caught:
        getattr(cloud, name)
    shown = "".join(traceback.format_exception(caught.value))
    assert shown.lower().count("did you mean") <= 1 and "Did you mean" not in shown


ENDINGS = {".las": 1e-3, ".laz": 1e-3, ".copc.laz": 1e-3, ".xyz": 1e-3, ".csv": 0, ".vtp": 0, ".pvtp": 0,
           ".ply": 0, ".pcd": 1e-5, ".e57": 0}  # fmt: skip
NEEDS = {".e57": "pye57"}


@pytest.mark.parametrize("ending", ENDINGS)
@pytest.mark.filterwarnings("ignore::RuntimeWarning")
def test_every_format_is_written_and_read(ending, tmp_path):
    pytest.importorskip(NEEDS.get(ending, "numpy"))
    points = np.arange(30.0).reshape(10, 3)
    ones = np.ones(10, np.uint8)
    cloud = Cloud.from_arrays(points, ReturnNumber=ones, NumberOfReturns=ones)
    for _ in range(3):  # memory of one array under another one is released in order
        (cloud + cloud).write(tmp_path / f"cloud{ending}")
        read = vtkhelios.read(tmp_path / f"cloud{ending}")
    order = np.argsort(read.x, kind="stable")
    assert np.allclose(read.points[order], np.repeat(points, 2, axis=0), atol=ENDINGS[ending])
    assert (read["ReturnNumber"] == 1).all()


@pytest.mark.parametrize("format", ["las", "xyz", "vtp"])
def test_runs_are_read_with_their_waveforms(format, make_survey, tmp_path):
    survey = vtkhelios.read_survey(make_survey())
    made = survey.run(waveforms=True)
    folder = survey.run_to(tmp_path, format=format, waveforms=True)["folder"]
    read = vtkhelios.read(folder, waveforms=True)
    assert len(read) == len(made) and (read["LegIds"] == 0).all()
    rows = made.waveforms.GetNumberOfRows()
    assert rows > 10 and read.waveforms.GetNumberOfRows() == rows
    assert vtkhelios.read(folder).waveforms is None
    if format == "las":
        made.write(tmp_path / "again.las")
        assert vtkhelios.read(tmp_path / "again.las", True).waveforms.GetNumberOfRows() == rows
        made.write(tmp_path / "without.vtp")
        with pytest.raises(
            ValueError, match="without.vtp: has no waveforms; read it without, or run"
        ):
            vtkhelios.read(tmp_path / "without.vtp", waveforms=True)


def test_reading_errors_name_the_function_to_call(tmp_path):
    for name, message in {
        "a.obj": r"is a mesh, not points; give it to Scene.read\(\)",
        "a.yaml": r"is a document, not points; give it to read_survey\(\)",
        "a.las": "no such file; check its name",
        "a.odd": "its ending is not of a known format; known: .copc.laz, .las",
    }.items():
        with pytest.raises(ValueError, match=f"{name}: {message}"):
            vtkhelios.read(tmp_path / name)


def test_repr(cloud):
    assert repr(cloud) == "Cloud(5 points, 0 to 12, 1 to 13, 2 to 14 m; Range, PulseIds, Normal)"
    assert repr(Cloud()) == "Cloud(no points)" and Cloud().points.shape == (0, 3)
    shown = cloud._repr_html_()
    assert "<b>Cloud</b>, 5 points" in shown
    assert "<td>Range</td><td>float64</td><td>0 to 4</td><td>m</td>" in shown
    assert "<td>Normal</td><td>float64 x 3</td>" in shown


def test_single_precision_is_kept():
    data = vtkPolyData()
    cloud = Cloud.from_arrays(np.zeros((2, 3)))
    data.ShallowCopy(cloud.polydata)
    column = vtkFloatArray()
    column.SetName("Samples")
    column.InsertNextValue(0.5)
    column.InsertNextValue(1.5)
    data.GetPointData().AddArray(column)
    assert Cloud(data)["Samples"].dtype == np.float32


def test_write(cloud, tmp_path):
    cloud.write(tmp_path / "cloud.vtp")
    reader = vtkXMLPolyDataReader()
    reader.SetFileName(str(tmp_path / "cloud.vtp"))
    reader.Update()
    read = Cloud(reader.GetOutput())
    assert np.array_equal(read.points, cloud.points)
    assert np.array_equal(read["PulseIds"], cloud["PulseIds"])
    assert reader.GetOutput().GetNumberOfVerts() == 5
    assert cloud.data.GetNumberOfVerts() == 0
    cloud.write(tmp_path / "cloud.las")
    las = vtkhelios.vtkHeliosLASReader(file_name=tmp_path / "cloud.las")
    assert np.allclose(Cloud(las()).points, cloud.points, atol=1e-3)


def test_write_text(tmp_path):
    zeros = np.zeros(2)
    whole = np.zeros(2, np.int64)
    names = ("ReturnNumber", "NumberOfReturns", "PulseIds", "PartIds", "ClassificationIds")
    cloud = Cloud.from_arrays(
        np.array([[1, 2, 3], [4, 5, 6.5]]), Amplitude=zeros, EchoWidth=zeros, GpsTime=zeros,
        **dict.fromkeys(names, whole),
    )  # fmt: skip
    cloud.write(str(tmp_path / "cloud.xyz"))
    rows = np.loadtxt(tmp_path / "cloud.xyz")
    assert rows[:, :3].tolist() == [[1, 2, 3], [4, 5, 6.5]]


def test_write_errors(cloud, tmp_path):
    with pytest.raises(ValueError, match="not of a format that is written; written are: .copc.laz"):
        cloud.write(tmp_path / "cloud.e58")
    cloud.waveforms = vtkTable()
    with pytest.warns(
        RuntimeWarning, match=r"waveforms is dropped: Cloud.write\(\) writes them to"
    ):
        cloud.write(tmp_path / "cloud.ply")
    (tmp_path / "file").write_text("")
    with pytest.raises((vtkhelios.PipelineError, OSError), match="file"):
        cloud.write(tmp_path / "file" / "cloud.las")


def test_vertices_are_added_on_access(cloud):
    assert cloud.data.GetNumberOfCells() == 0
    shown = cloud.polydata
    assert shown is cloud.data is cloud.polydata  # the same, now with vertices
    assert shown.GetNumberOfVerts() == shown.GetNumberOfCells() == 5
    assert [shown.GetCell(k).GetPointId(0) for k in range(5)] == [0, 1, 2, 3, 4]
    assert Cloud().polydata.GetNumberOfCells() == 0
    scene = vtkhelios.vtkHeliosSyntheticScene(kind="blocks")()
    assert Cloud(scene).polydata.GetNumberOfVerts() == 0  # existing cells are kept


def test_vertices_are_small_and_kept_with_the_data():
    points = np.zeros((100_000, 3))
    data = Cloud.from_arrays(points).data
    bare = data.GetActualMemorySize()
    data = Cloud(data).polydata
    gc.collect()
    np.full(100_001, 7, np.int32)  # would reuse the memory
    assert 0.7 < (data.GetActualMemorySize() - bare) / 800 < 1.3  # relative to 8 bytes/point [kB]
    assert [data.GetCell(k).GetPointId(0) for k in (0, 1, 99_999)] == [0, 1, 99_999]


def test_pipelines_add_no_vertices(cloud):
    @vtkhelios.filter
    def same(cloud):
        return cloud

    result = (cloud >> same())()
    assert result.GetNumberOfPoints() == 5 and result.GetNumberOfCells() == 0
    assert cloud[[0, 1]].data.GetNumberOfCells() == cloud.data.GetNumberOfCells() == 0
    assert vtkhelios.Scene(cloud).polydata is cloud.data
    assert cloud.data.GetNumberOfCells() == 0


def test_pyvista_wraps_it(cloud):
    pyvista = pytest.importorskip("pyvista")
    wrapped = pyvista.wrap(cloud.polydata)
    assert np.shares_memory(wrapped.points, cloud.points)


DRAW = """
import numpy as np, pyvista, sys
from vtkhelios import Cloud
x, y = np.meshgrid(np.arange(20.0), np.arange(20.0))
cloud = Cloud.from_arrays(np.column_stack([x.ravel(), y.ravel(), 0 * x.ravel()]))
plotter = pyvista.Plotter(off_screen=True, window_size=(400, 400))
plotter.disable_anti_aliasing()
plotter.set_background("black")
plotter.add_mesh(pyvista.wrap(eval(sys.argv[1])), color="white", point_size=5, lighting=False)
plotter.view_xy()
print(np.count_nonzero(plotter.screenshot(return_img=True).max(axis=2) > 128))
"""


def draw(what):
    """The bright pixels of a PyVista plot of 400 points, 5 pixels wide each."""
    pytest.importorskip("pyvista")
    if not shutil.which("xvfb-run"):
        pytest.skip("xvfb-run is missing")
    done = subprocess.run(
        ["xvfb-run", "-a", "-s", "-screen 0 800x600x24", sys.executable, "-c", DRAW, what],
        env={**os.environ, "PYTHONPATH": ":".join(sys.path)},
        capture_output=True,
        text=True,
        timeout=120,
    )
    assert done.returncode == 0, done.stderr
    return int(done.stdout.split()[-1])


def test_pyvista_draws_it():
    assert 400 * 12 < draw("cloud.polydata") < 400 * 30
    assert draw("cloud.data") == 0  # only vertices are drawn
