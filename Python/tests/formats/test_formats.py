# SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
# SPDX-License-Identifier: BSD-3-Clause
"""Point formats: written data are read back, here and by independent readers."""

import numpy as np
import pytest
from _point_files import COUNT, CRS, EPOCH, full_format, make_chunk, make_header, read, write

from vtkhelios import formats

__all__ = ["full_format"]  # a fixture

# Written data are read back


def test_every_array_is_restored(tmp_path, full_format):
    chunk = make_chunk()
    writer = write(tmp_path / f"a.{full_format}", chunk)
    reader, back = read(tmp_path / f"a.{full_format}")
    order = np.argsort(back["GpsTime"])  # an octree has its own order
    assert not writer.lost
    las = "la" in full_format
    for name, values in chunk.items():
        found = back[name][order]
        if name == "GpsTime" and las:
            continue  # a different epoch; see the next test
        assert found.dtype == values.dtype, name
        tolerance = {"points": 2e-9, "ScanAngle": 1e-9}.get(name, 0.0) if las else 0.0
        tolerance = 1e-6 if name == "RGB" else tolerance
        assert np.abs(found.astype(float) - values).max() <= tolerance, name
    assert reader.header.crs.startswith("PROJCS[") if las else reader.header.crs == CRS
    assert reader.header.epoch == (1e9 if las else EPOCH)
    assert [path.name for path in tmp_path.iterdir() if ".part" in path.name] == []


def test_times_are_equal_across_epochs(tmp_path, full_format):
    """A LAS file has its own epoch: epoch plus time is preserved."""
    write(tmp_path / f"a.{full_format}")
    reader, back = read(tmp_path / f"a.{full_format}")
    moments = np.sort(back["GpsTime"]) + reader.header.epoch
    assert np.allclose(moments, make_chunk()["GpsTime"] + EPOCH, rtol=0, atol=1e-6)


def test_laz_is_las_compressed(tmp_path):
    """The same header and the same records as vtkHeliosLASWriter's, chunk by chunk."""
    laspy = pytest.importorskip("laspy")
    pytest.importorskip("lazrs")
    write(tmp_path / "a.las")
    write(tmp_path / "a.laz")
    plain, packed = laspy.read(tmp_path / "a.las"), laspy.read(tmp_path / "a.laz")
    assert plain.points.array.tobytes() == packed.points.array.tobytes()
    for name in ("scales", "offsets", "mins", "maxs", "number_of_points_by_return", "vlrs"):
        ours, theirs = getattr(packed.header, name), getattr(plain.header, name)
        if name == "vlrs":
            ours, theirs = ([v.record_data_bytes() for v in each] for each in (ours, theirs))
        assert np.array_equal(ours, theirs), name


def test_text_is_restored(tmp_path):
    chunk = make_chunk()
    header = make_header()
    header.part_names = ["house", "big tree", "lawn"]
    writer = write(tmp_path / "a.xyz", chunk, header)
    assert set(writer.lost) == {"Range", "ScanAngle", "LegIds", "ChannelIds", "RGB", "TruePoint"}
    reader, back = read(tmp_path / "a.xyz")
    assert np.allclose(back["points"], chunk["points"], rtol=0, atol=5.1e-5)
    for name in ("PulseIds", "ReturnNumber", "NumberOfReturns", "ClassificationIds"):
        assert np.array_equal(back[name], chunk[name]) and back[name].dtype == chunk[name].dtype
    assert np.allclose(back["GpsTime"], chunk["GpsTime"], rtol=0, atol=1e-9)
    assert np.allclose(back["Amplitude"], chunk["Amplitude"], rtol=0, atol=1e-13)
    ours = np.array(header.part_names)[chunk["PartIds"]]
    theirs = np.array(reader.header.part_names)[back["PartIds"]]
    assert np.array_equal(np.char.replace(ours, " ", "_"), theirs)


def test_pcd_is_restored(tmp_path):
    """Fields of PCL's float types are equal as floats, all else to the bit; the reader checks the rest."""
    chunk = make_chunk()
    write(tmp_path / "a.pcd", chunk)
    reader, back = read(tmp_path / "a.pcd")
    floats = {"points": 4e-6, "Amplitude": 6e-8 * 1e-4, "EchoWidth": 6e-8 * 6}
    assert set(back) == set(chunk)
    for name, values in chunk.items():
        error = np.abs(back[name].astype(float) - values).max()
        assert error <= floats.get(name, 0.0), name
        assert name in floats or back[name].dtype == values.dtype, name
    assert np.abs(back["points"] - chunk["points"]).max() > 0  # stored as floats
    assert (reader.header.crs, reader.header.epoch, reader.count) == (CRS, EPOCH, COUNT)


def test_other_text(tmp_path):
    path = tmp_path / "a.xyz"
    path.write_text("# a comment\n1 2 3 4\n\n5 6 7 8 // another\n")
    reader, back = read(path)
    assert back["points"].tolist() == [[1, 2, 3], [5, 6, 7]] and set(back) == {"points"}
    assert "has 4 columns instead of the 11" in reader.notes[0]


def test_parts_of_text_by_name_and_by_number(tmp_path):
    """A number stays that number, and no name gets it."""
    path = tmp_path / "a.xyz"
    rows = "".join(f"1 2 3 4 5 1 1 7 {part} 2 0.5\n" for part in ("1", "house", "tree", "1", "-1"))
    path.write_text(rows)
    reader, back = read(path)
    assert back["PartIds"].tolist() == [1, 0, 2, 1, -1]
    assert reader.header.part_names == ["house", "", "tree"]


def test_ply_of_other_programs(tmp_path):
    """Text, floats, byte colours, faces after the vertices."""
    path = tmp_path / "a.ply"
    path.write_text(
        "ply\nformat ascii 1.0\nelement vertex 2\nproperty float x\nproperty float y\n"
        "property float z\nproperty uchar red\nproperty uchar green\nproperty uchar blue\n"
        "element face 0\nproperty list uchar int vertex_indices\nend_header\n"
        "1 2 3 255 0 51\n4 5 6 0 0 0\n"
    )
    _, back = read(path)
    assert back["points"].tolist() == [[1, 2, 3], [4, 5, 6]]
    assert np.allclose(back["RGB"][0], [1.0, 0.0, 0.2])


# Independent readers


def test_laspy_reads_every_field(tmp_path):
    laspy = pytest.importorskip("laspy")
    pytest.importorskip("lazrs")
    chunk = make_chunk()
    write(tmp_path / "a.laz", chunk)
    las = laspy.read(tmp_path / "a.laz")
    assert np.allclose(las.xyz, chunk["points"], rtol=0, atol=2e-9)
    assert np.allclose(las.gps_time, chunk["GpsTime"] + EPOCH - 1e9, rtol=0, atol=1e-6)
    assert np.array_equal(las.return_number, chunk["ReturnNumber"])
    assert np.array_equal(las.number_of_returns, chunk["NumberOfReturns"])
    assert np.array_equal(las.classification, chunk["ClassificationIds"])
    assert np.array_equal(las.point_source_id, chunk["LegIds"] + 1)
    assert np.array_equal(las.scanner_channel, chunk["ChannelIds"] % 4)
    assert np.allclose(las.scan_angle * 0.006, chunk["ScanAngle"], rtol=0, atol=1e-9)
    assert np.array_equal(las.red, np.rint(chunk["RGB"][:, 0] * 65535))
    for name in ("PulseIds", "Range", "Amplitude", "EchoWidth", "PartIds", "ChannelIds"):
        assert np.array_equal(las[name], chunk[name]), name
    assert np.array_equal(las["TruePointZ"], chunk["TruePoint"][:, 2])
    assert las.header.global_encoding.wkt and las.header.point_format.id == 7
    assert any("25832" in v.string for v in las.header.vlrs.get("WktCoordinateSystemVlr"))


def test_laspy_queries_the_octree(tmp_path):
    """Queries by a box, and by a resolution."""
    laspy = pytest.importorskip("laspy")
    pytest.importorskip("lazrs")
    chunk = make_chunk(60_000)
    write(tmp_path / "a.copc.laz", chunk, rows=25_000)
    low, high = np.array([476020.0, 5473010.0, 110.0]), np.array([476045.0, 5473060.0, 210.0])
    inside = ((chunk["points"] >= low) & (chunk["points"] <= high)).all(axis=1)
    with laspy.CopcReader.open(tmp_path / "a.copc.laz") as reader:
        found = reader.query(laspy.copc.Bounds(low, high))
        order = np.argsort(found.gps_time)
        assert np.array_equal(found["Range"][order], chunk["Range"][inside])
        assert np.array_equal(found["PulseIds"][order], chunk["PulseIds"][inside])
        coarse = reader.query(resolution=reader.copc_info.spacing)
        assert 0 < len(coarse) < 60_000
        size = 2 * reader.copc_info.halfsize
        corner = reader.copc_info.center - reader.copc_info.halfsize
        cells = np.floor(
            (np.column_stack([coarse.x, coarse.y, coarse.z]) - corner) / size * 128
        ).astype(int)
        assert len(np.unique(cells, axis=0)) == len(coarse)  # a point a cell


def test_copclib_reads_the_octree(tmp_path):
    copclib = pytest.importorskip("copclib")
    chunk = make_chunk(60_000)
    write(tmp_path / "a.copc.laz", chunk, rows=25_000)
    reader = copclib.FileReader(str(tmp_path / "a.copc.laz"))
    assert reader.ValidateSpatialBounds()
    nodes = reader.GetAllNodes()
    assert sum(node.point_count for node in nodes) == 60_000
    assert max(node.key.d for node in nodes) >= 1
    header = reader.copc_config.las_header
    assert header.point_count == 60_000
    assert sum(header.points_by_return) == 60_000
    assert "25832" in reader.copc_config.wkt
    points = reader.GetAllPoints()
    order = np.lexsort(np.array([points.x, points.y, points.z]))
    found = np.array([points.x, points.y, points.z]).T[order]
    expected = chunk["points"][np.lexsort(chunk["points"].T)]
    assert np.allclose(found, expected, rtol=0, atol=2e-9)
    assert len(reader.copc_config.extra_bytes_vlr.items) == 9  # Range, Amplitude, TruePointX ...


def test_plyfile_reads_every_property(tmp_path):
    plyfile = pytest.importorskip("plyfile")
    chunk = make_chunk()
    write(tmp_path / "a.ply", chunk)
    vertices = plyfile.PlyData.read(str(tmp_path / "a.ply"))["vertex"]
    for axis, name in enumerate("xyz"):
        assert vertices[name].dtype == "<f8"
        assert np.array_equal(vertices[name], chunk["points"][:, axis])
        assert np.array_equal(vertices["TruePoint" + name.upper()], chunk["TruePoint"][:, axis])
    assert np.array_equal(vertices["red"], np.rint(chunk["RGB"][:, 0] * 255))
    for name, values in chunk.items():
        if values.ndim == 1:
            assert np.array_equal(vertices[name], values), name
            assert vertices[name].dtype.itemsize == values.dtype.itemsize


def test_pye57_reads_the_scan(tmp_path):
    pye57 = pytest.importorskip("pye57")
    chunk = make_chunk()
    chunk["RGB"] = np.rint(chunk["RGB"] * 255) / np.float32(255)  # it reads no others
    half = np.sqrt(0.5)
    scan = formats.Scan("tripod", (476050.0, 5473050.0, 120.0), (half, 0.0, 0.0, half), True)
    writer = write(tmp_path / "a.e57", chunk, scan=scan)
    assert "PulseIds" in writer.lost and "ReturnNumber" not in writer.lost
    with pye57.E57(str(tmp_path / "a.e57")) as file:
        header = file.get_header(0)
        assert file.scan_count == 1 and header.point_count == COUNT
        assert header["name"].value() == "tripod"
        assert np.allclose(header.translation, scan.translation)
        assert np.allclose(header.rotation, scan.rotation)
        assert file.root["coordinateMetadata"].value() == CRS
        assert header["acquisitionStart"]["dateTimeValue"].value() == EPOCH
        world = file.read_scan(0, intensity=True, colors=True, ignore_missing_fields=True)
        local = file.read_scan_raw(0, ignore_unsupported_fields=True)
        bounds = [header["cartesianBounds"][f"{a}Minimum"].value() for a in "xyz"]
    xyz = np.column_stack([world[f"cartesian{axis}"] for axis in "XYZ"])
    assert np.allclose(xyz, chunk["points"], rtol=0, atol=3e-9)
    moved = chunk["points"] - scan.translation  # a quarter turn about z: x from y, y from -x
    assert np.allclose(local["cartesianX"], moved[:, 1], rtol=0, atol=3e-9)
    assert np.allclose(local["cartesianY"], -moved[:, 0], rtol=0, atol=3e-9)
    assert np.allclose(bounds, [local[f"cartesian{a}"].min() for a in "XYZ"])  # in its own frame
    assert np.allclose(world["intensity"], chunk["Amplitude"], rtol=1e-6)
    assert np.array_equal(world["colorRed"], np.rint(chunk["RGB"][:, 0] * 255))


def test_e57_is_restored(tmp_path):
    pytest.importorskip("pye57")
    chunk = make_chunk()
    turn = np.array([0.8, -0.2, 0.4, np.sqrt(1 - 0.84)])
    scan = formats.Scan("tripod", (476050.0, 5473050.0, 120.0), tuple(turn), True)
    write(tmp_path / "a.e57", chunk, scan=scan)
    reader, back = read(tmp_path / "a.e57")
    assert np.allclose(reader.scans[0].rotation, turn) and reader.scans[0].name == "tripod"
    assert reader.header.crs == CRS and reader.header.epoch == EPOCH
    assert np.allclose(back["points"], chunk["points"], rtol=0, atol=3e-9)
    for name in ("GpsTime", "Amplitude", "ReturnNumber", "NumberOfReturns"):
        assert np.array_equal(back[name], chunk[name]), name
