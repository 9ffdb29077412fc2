# SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
# SPDX-License-Identifier: BSD-3-Clause
"""Formats of points: what is written comes back, here and in readers that are not ours."""

import builtins
import re

import numpy as np
import pytest

from vtkhelios import formats
from vtkhelios.formats import FormatError
from vtkhelios.formats._copc import gather, nodes_of, spread

COUNT = 5000
CRS = "EPSG:25832"
EPOCH = 1.4e9


def make_chunk(count=COUNT, seed=1):
    """Echoes at UTM coordinates, with all kinds of arrays."""
    random = np.random.default_rng(seed)
    number = random.integers(1, 4, count).astype(np.uint8)
    return {
        "points": np.round(random.uniform(0, 100, (count, 3)) + [476000.0, 5473000.0, 110.0], 4),
        "GpsTime": np.arange(count) * 1e-5 + 3.0,
        "PulseIds": np.arange(count, dtype=np.int64) // 2 + 2**40,
        "ReturnNumber": number,
        "NumberOfReturns": (number + random.integers(0, 2, count)).astype(np.uint8),
        "Range": random.uniform(1, 300, count),
        "Amplitude": 10.0 ** random.uniform(-12, -4, count),
        "EchoWidth": random.uniform(4, 6, count),
        "ScanAngle": np.round(random.uniform(-30, 30, count) / 0.006) * 0.006,
        "ClassificationIds": random.integers(0, 12, count).astype(np.int32),
        "PartIds": random.integers(0, 3, count).astype(np.int32),
        "LegIds": np.full(count, 2, np.int32),
        "ChannelIds": random.integers(0, 8, count).astype(np.int32),
        "RGB": (random.integers(0, 256, (count, 3)) / 255.0).astype(np.float32),
        "TruePoint": random.uniform(0, 100, (count, 3)),
    }


def make_header():
    header = formats.Header()
    header.crs, header.epoch = CRS, EPOCH
    return header


def write(path, chunk=None, header=None, rows=1700, scan=None):
    chunk = make_chunk() if chunk is None else chunk
    with formats.open_writer(path, header or make_header()) as writer:
        if scan:
            writer.begin(scan)
        for begin in range(0, len(chunk["points"]), rows):
            writer.write({name: values[begin : begin + rows] for name, values in chunk.items()})
    return writer


def read(path, rows=1234):
    with formats.open_reader(path) as reader:
        chunks = list(reader.chunks(rows))
        names = chunks[0]
        assert reader.count is None or reader.count >= sum(len(each["points"]) for each in chunks)
    return reader, {name: np.concatenate([each[name] for each in chunks]) for name in names}


@pytest.fixture(params=["las", "laz", "copc.laz", "pvtp", "vtp", "ply"])
def full_format(request):
    """The formats that hold every array."""
    if "laz" in request.param:
        pytest.importorskip("lazrs")
    if "copc" in request.param:
        pytest.importorskip("copclib")
    return request.param


# What is written comes back


def test_every_array_comes_back(tmp_path, full_format):
    chunk = make_chunk()
    writer = write(tmp_path / f"a.{full_format}", chunk)
    reader, back = read(tmp_path / f"a.{full_format}")
    order = np.argsort(back["GpsTime"])  # an octree has one of its own
    assert not writer.lost
    las = "la" in full_format
    for name, values in chunk.items():
        found = back[name][order]
        if name == "GpsTime" and las:
            continue  # counts from elsewhere; the next test
        assert found.dtype == values.dtype, name
        tolerance = {"points": 2e-9, "ScanAngle": 1e-9}.get(name, 0.0) if las else 0.0
        tolerance = 1e-6 if name == "RGB" else tolerance
        assert np.abs(found.astype(float) - values).max() <= tolerance, name
    assert reader.header.crs.startswith("PROJCS[") if las else reader.header.crs == CRS
    assert reader.header.epoch == (1e9 if las else EPOCH)
    assert [path.name for path in tmp_path.iterdir() if ".part" in path.name] == []


def test_times_are_the_same_moments(tmp_path, full_format):
    """A LAS file counts from elsewhere: epoch and time together are what is kept."""
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


def test_text_comes_back(tmp_path):
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


def test_pcd_comes_back(tmp_path):
    """What PCL's types have as float to a float, all else to the bit; the reader checks the rest."""
    chunk = make_chunk()
    write(tmp_path / "a.pcd", chunk)
    reader, back = read(tmp_path / "a.pcd")
    floats = {"points": 4e-6, "Amplitude": 6e-8 * 1e-4, "EchoWidth": 6e-8 * 6}
    assert set(back) == set(chunk)
    for name, values in chunk.items():
        error = np.abs(back[name].astype(float) - values).max()
        assert error <= floats.get(name, 0.0), name
        assert name in floats or back[name].dtype == values.dtype, name
    assert np.abs(back["points"] - chunk["points"]).max() > 0  # floats they are
    assert (reader.header.crs, reader.header.epoch, reader.count) == (CRS, EPOCH, COUNT)


def test_other_text(tmp_path):
    path = tmp_path / "a.xyz"
    path.write_text("# a comment\n1 2 3 4\n\n5 6 7 8 // another\n")
    reader, back = read(path)
    assert back["points"].tolist() == [[1, 2, 3], [5, 6, 7]] and set(back) == {"points"}
    assert "has 4 columns and not the 11" in reader.notes[0]


def test_ply_of_others(tmp_path):
    """Text, floats, colours of bytes, faces after the vertices."""
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


# Readers that are not ours


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


def test_copclib_reads_the_octree(tmp_path):
    copclib = pytest.importorskip("copclib")
    pytest.importorskip("lazrs")
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
    assert reader.copc_config.wkt.startswith("PROJCS[") and "25832" in reader.copc_config.wkt
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
        bounds = [header[f"cartesianBounds"][f"{a}Minimum"].value() for a in "xyz"]
    xyz = np.column_stack([world[f"cartesian{axis}"] for axis in "XYZ"])
    assert np.allclose(xyz, chunk["points"], rtol=0, atol=3e-9)
    moved = chunk["points"] - scan.translation  # a quarter turn about z: x from y, y from -x
    assert np.allclose(local["cartesianX"], moved[:, 1], rtol=0, atol=3e-9)
    assert np.allclose(local["cartesianY"], -moved[:, 0], rtol=0, atol=3e-9)
    assert np.allclose(bounds, [local[f"cartesian{a}"].min() for a in "XYZ"])  # in its own frame
    assert np.allclose(world["intensity"], chunk["Amplitude"], rtol=1e-6)
    assert np.array_equal(world["colorRed"], np.rint(chunk["RGB"][:, 0] * 255))


def test_e57_comes_back(tmp_path):
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


# The octree


def test_morton_codes():
    values = np.random.default_rng(3).integers(0, 2**21, 1000)
    codes = spread(values)
    assert all(gather(code) == value for code, value in zip(codes, values))
    assert int(spread(np.array([0b101]))[0]) == 0b1000001


def test_nodes_hold_every_point_once():
    random = np.random.default_rng(4)
    codes = np.sort(random.integers(0, 2**63, 50_000).astype(np.uint64))
    nodes = list(nodes_of(codes, few=100))
    places = np.concatenate([places for _, _, places in nodes])
    assert np.array_equal(np.sort(places), np.arange(50_000))
    for level, node, where in nodes:
        assert np.all(codes[where] >> np.uint64(3 * (21 - level)) == node)
    assert len({(level, int(node)) for level, node, _ in nodes}) == len(nodes)
    same = np.zeros(1000, np.uint64)  # no finer cell divides them
    assert sum(len(where) for _, _, where in nodes_of(same, few=10)) == 1000


# What is wrong


def cut(path, share):
    data = path.read_bytes()
    path.write_bytes(data[: int(len(data) * share)])


@pytest.mark.parametrize(
    "ending, message",
    [
        ("las", "is cut off"),
        ("laz", "is cut off or damaged, copy it again"),
        ("ply", "is cut off: it has .* whole points of the 5000 that its header counts"),
        ("vtp", "a.vtp"),
        ("e57", "is no E57 file, or is damaged"),
    ],
)
def test_files_that_are_cut_off(tmp_path, ending, message):
    pytest.importorskip({"laz": "lazrs", "e57": "pye57"}.get(ending, "numpy"))
    path = tmp_path / f"a.{ending}"
    write(path)
    cut(path, 0.6)
    with pytest.raises(FormatError, match=message) as error:
        read(path)
    assert str(path) in str(error.value)


@pytest.mark.parametrize("ending", [kind for kind in formats.FORMATS])
def test_files_of_something_else(tmp_path, ending):
    needed = {".laz": "lazrs", ".copc.laz": "lazrs", ".e57": "pye57"}.get(ending, "numpy")
    pytest.importorskip(needed)
    for content in (b"", b"PK\3\4 no points at all\n" * 200):
        path = tmp_path / f"a{ending}"
        path.write_bytes(content)
        with pytest.raises(FormatError, match=re.escape(str(path))):
            read(path)


def test_laz_with_wrong_counts(tmp_path):
    pytest.importorskip("lazrs")
    path = tmp_path / "a.laz"
    write(path)
    data = bytearray(path.read_bytes())
    data[247:255] = (COUNT + 100_000).to_bytes(8, "little")
    path.write_bytes(data)
    with pytest.raises(FormatError, match=r"points 0 to \d+ of 105000 cannot be read"):
        read(path, 200_000)


@pytest.mark.parametrize(
    "text, message",
    [
        ("1 2 3\n4 5\n", "a.xyz:2: has 2 columns and the first line 3; correct it"),
        ("1 2 3\n4 x 6\n", 'a.xyz:2: "x" in column 2 is no number; correct it'),
        ("1 2\n", "a.xyz: has 2 columns; give x y z"),
        ("\n# nothing\n", "a.xyz: has no points"),
        (
            "1 2 3 4 5 1 1 7 wall 2 0.5\n1 2 3 4 5 1.5 1 7 wall 2 0.5\n",
            "a.xyz:2: 1.5 in column 6 is no whole number of 0 to 255; correct it",
        ),
        ("1 2 3 4 5 1 1 7 0 2 0.5\n1 2 3 4 5 1 1 7 0 2\n", "a.xyz:2: has 10 columns"),
    ],
)
def test_text_that_is_wrong(tmp_path, text, message):
    path = tmp_path / "a.xyz"
    path.write_text(text)
    with pytest.raises(FormatError, match=re.escape(message)):
        read(path)


PLY = "ply\nformat {form} 1.0\nelement vertex {count}\n{properties}end_header\n"
XYZ = "property double x\nproperty double y\nproperty double z\n"


@pytest.mark.parametrize(
    "head, message",
    [
        ({"form": "binary", "count": 1, "properties": XYZ}, 'has the format "binary"'),
        ({"form": "ascii", "count": 0, "properties": XYZ}, "has no points"),
        ({"form": "ascii", "count": "x", "properties": XYZ}, 'counts "x" elements'),
        ({"form": "ascii", "count": 1, "properties": XYZ[:18]}, "has no vertices with x, y and z"),
        (
            {"form": "ascii", "count": 1, "properties": XYZ + "property list uchar int n\n"},
            "only plain numbers can be read",
        ),
        (
            {"form": "ascii", "count": 1, "properties": "element face 2\n" + XYZ},
            "has no vertices with x, y and z",
        ),
        ({"form": "ascii", "count": 3, "properties": XYZ}, "2 whole points of 3"),
    ],
)
def test_ply_that_is_wrong(tmp_path, head, message):
    path = tmp_path / "a.ply"
    path.write_text(PLY.format(**head) + "1 2 3\n4 5 6\n")
    with pytest.raises(FormatError, match=re.escape(message)):
        read(path)


@pytest.mark.parametrize(
    "content, message",
    [
        ("solid x", "is no PLY file: it does not start with ply; check its name"),
        ("ply\nformat ascii 1.0\n", "ends within its header; copy it again"),
        ("ply\nformat ascii 1.0\nelement face 2\n", 'has "face" before its vertices'),
        (PLY.format(form="ascii", count=1, properties=XYZ) + "1 x 3\n", "0 to 1 cannot be read"),
    ],
)
def test_ply_that_is_none(tmp_path, content, message):
    (tmp_path / "a.ply").write_text(content)
    with pytest.raises(FormatError, match=message):
        read(tmp_path / "a.ply")


INDEX = '<VTKFile type="{kind}"><PPolyData>{pieces}</PPolyData></VTKFile>'


@pytest.mark.parametrize(
    "content, message",
    [
        ("<VTKFile>", "is no XML: .*; write it again"),
        (INDEX.format(kind="PImageData", pieces=""), r"in pieces \(PPolyData\); name that one"),
        (INDEX.format(kind="PPolyData", pieces=""), "names no pieces, so it has no points"),
        (
            INDEX.format(kind="PPolyData", pieces='<Piece Source="b.vtp"/>'),
            "b.vtp is missing; keep",
        ),
        (
            INDEX.format(kind="PPolyData", pieces='<Piece Source="c.vtp"/>'),
            "c.vtp is no VTK XML fi",
        ),
    ],
)
def test_pieces_that_are_wrong(tmp_path, content, message):
    (tmp_path / "a.pvtp").write_text(content)
    (tmp_path / "c.vtp").write_text("<VTKFile type='ImageData'/>")
    with pytest.raises(FormatError, match=message):
        read(tmp_path / "a.pvtp")


def write_e57(path, fields):
    """A scan of any fields, by libE57Format alone."""
    pye57 = pytest.importorskip("pye57")
    libe57 = pye57.libe57
    with pye57.E57(str(path), "w") as file:
        image = file.image_file
        prototype, buffers = libe57.StructureNode(image), libe57.VectorSourceDestBuffer()
        for name, values in fields.items():
            prototype.set(name, libe57.FloatNode(image))
            buffers.append(libe57.SourceDestBuffer(image, name, values, len(values), True, True))
        node = libe57.StructureNode(image)
        points = libe57.CompressedVectorNode(image, prototype, libe57.VectorNode(image, True))
        node.set("guid", libe57.StringNode(image, "{1}"))
        node.set("points", points)
        file.data3d.append(node)
        writer = points.writer(buffers)
        writer.write(len(next(iter(fields.values()))))
        writer.close()


def test_e57_of_others(tmp_path):
    """Ranges and angles, no pose; intensities of any scale become 16 bits."""
    fields = {
        "sphericalRange": np.array([2.0, 10.0]),
        "sphericalAzimuth": np.radians([0.0, 90.0]),
        "sphericalElevation": np.radians([30.0, 0.0]),
        "intensity": np.array([0.0, 65535.0]),
    }
    write_e57(tmp_path / "a.e57", fields)
    _, back = read(tmp_path / "a.e57")
    assert np.allclose(back["points"], [[np.sqrt(3.0), 0.0, 1.0], [0.0, 10.0, 0.0]])
    assert back["Intensity"].tolist() == [0, 65535] and back["Intensity"].dtype == np.uint16


def test_e57_without_coordinates(tmp_path):
    write_e57(tmp_path / "a.e57", {"intensity": np.array([1.0])})
    with pytest.raises(FormatError, match="has a scan without coordinates; leave that scan out"):
        read(tmp_path / "a.e57")


def test_e57_without_scans(tmp_path):
    pye57 = pytest.importorskip("pye57")
    pye57.E57(str(tmp_path / "a.e57"), "w").close()
    with pytest.raises(FormatError, match="a.e57: has no points; give a file with points"):
        read(tmp_path / "a.e57")


def test_ply_of_large_numbers(tmp_path):
    chunk = {"points": np.zeros((1, 3)), "PulseIds": np.array([2**60])}
    with pytest.raises(FormatError, match=r"whole numbers to 2\^53, and PulseIds has larger ones"):
        write(tmp_path / "a.ply", chunk)
    assert list(tmp_path.iterdir()) == []


@pytest.mark.parametrize("ending", ["ply", "vtp", "las"])
def test_chunks_of_other_arrays(tmp_path, ending):
    chunk = make_chunk(10)
    with pytest.raises(FormatError, match=f"a.{ending}.*(Range|other arrays)"):
        with formats.open_writer(tmp_path / f"a.{ending}", make_header()) as writer:
            writer.write(chunk)
            del chunk["Range"]
            writer.write(chunk)
            writer.close()
    assert list(tmp_path.iterdir()) == []


@pytest.mark.parametrize(
    "arrays, message",
    [
        ({"points": np.zeros((2, 2))}, r"points has the shape \(2, 2\); give an array of \(n, 3\)"),
        ({"points": np.zeros(3)}, r"points has the shape \(3,\)"),
        ({}, r"points has the shape \(\); give"),
        ({"points": np.array([["a", "b", "c"]])}, "points is of the type <U1; give whole or real"),
        (
            {"Range": np.zeros(3)},
            r"Range has the shape \(3,\), and there are 2 points; give one row",
        ),
        ({"Range": np.zeros((2, 1, 1))}, r"Range has the shape \(2, 1, 1\)"),
        ({"Range": [1.0, 2.0]}, "Range is of the type list; give whole or real numbers"),
        ({"Range": np.zeros(2, complex)}, "Range is of the type complex128"),
        ({"Range": np.zeros(2, np.float16)}, "Range is of the type float16"),
        ({"Range": np.zeros(2, ">f8")}, "Range is of the type >f8"),
    ],
)
def test_arrays_that_are_wrong(tmp_path, arrays, message):
    chunk = {"points": np.zeros((2, 3)), **arrays} if arrays else {}
    with pytest.raises(FormatError, match="a.ply: " + message):
        write(tmp_path / "a.ply", chunk) if chunk else formats.open_writer(
            tmp_path / "a.ply"
        ).write(chunk)
    assert list(tmp_path.iterdir()) == []


def test_no_points(tmp_path, full_format):
    with pytest.raises(FormatError, match="would have no points"):
        with formats.open_writer(tmp_path / f"a.{full_format}", make_header()):
            pass
    assert list(tmp_path.iterdir()) == []


def test_points_that_are_not_finite(tmp_path):
    chunk = make_chunk(10)
    chunk["points"][3, 1] = np.nan
    with pytest.raises(FormatError, match="a.las.*nan"):
        write(tmp_path / "a.las", chunk)
    assert list(tmp_path.iterdir()) == []


def test_names(tmp_path):
    with pytest.raises(FormatError, match="cloud.txt: its ending is of no format that is known; "):
        formats.open_reader(tmp_path / "cloud.txt")
    with pytest.raises(FormatError, match="none.las: no such file; check its name"):
        formats.open_reader(tmp_path / "none.las")
    (tmp_path / "file").write_text("")
    with pytest.raises((FormatError, OSError), match="file"):
        write(tmp_path / "file" / "a.ply")


@pytest.mark.parametrize(
    "missing, ending, command",
    [
        ("laspy", "laz", "pip install --no-deps laspy lazrs"),
        ("copclib", "copc.laz", "pip install --no-deps copclib laspy lazrs"),
        ("pye57", "e57", "pip install --no-deps pye57 pyquaternion"),
    ],
)
def test_packages_that_are_missing(tmp_path, monkeypatch, missing, ending, command):
    import importlib

    real_import, real_module = builtins.__import__, importlib.import_module

    def refuse(call):
        def without(name, *arguments, **options):
            if name == missing:
                raise ImportError(name)
            return call(name, *arguments, **options)

        return without

    if missing == "copclib":
        pytest.importorskip("lazrs")
    monkeypatch.setattr(builtins, "__import__", refuse(real_import))
    monkeypatch.setattr(importlib, "import_module", refuse(real_module))
    with pytest.raises(FormatError, match=re.escape(command)):
        formats.open_writer(tmp_path / f"a.{ending}")
