# SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
# SPDX-License-Identifier: BSD-3-Clause
"""Text, PLY and PCD as other programs write and read them."""

import numpy as np
import pytest
from _point_files import CRS, make_chunk, make_header, read, write

from vtkhelios import formats
from vtkhelios.formats import FormatError
from vtkhelios.formats._ply_names import to_ascii

DEGREES = 'LOCAL_CS["Zone 6°E 🛰 \\u00b0"]'  # not ASCII, and with an escape of its own

# Text


def test_csv_is_restored(tmp_path):
    """Every column that has a name is the same to the last bit."""
    chunk = make_chunk()
    chunk["Intensity"] = np.arange(len(chunk["points"]), dtype=np.uint16)
    chunk["Normals"] = np.tile([0.6, 0.0, 0.8], (len(chunk["points"]), 1))
    write(tmp_path / "a.csv", chunk)
    first = (tmp_path / "a.csv").read_text().split("\n")[0].split(",")
    assert first[:3] == ["X", "Y", "Z"] and {"Red", "Classification", "GpsTime"} < set(first)
    reader, back = read(tmp_path / "a.csv")
    assert set(chunk) == set(back) and not reader.notes
    for name, values in back.items():
        tolerance = 1e-7 if name == "RGB" else 0.0
        assert np.abs(values.astype(float) - chunk[name]).max() <= tolerance, name
        assert values.dtype == chunk[name].dtype, name


def test_csv_has_the_same_columns_in_all_chunks(tmp_path):
    chunk = {"points": np.zeros((3, 3)), "a,b": np.arange(3)}
    with formats.open_writer(tmp_path / "a.csv") as writer:
        writer.write(chunk)
    assert (tmp_path / "a.csv").read_text() == (
        "X,Y,Z,a_b\n0.0,0.0,0.0,0\n0.0,0.0,0.0,1\n0.0,0.0,0.0,2\n"
    )
    message = "points have the columns X, Y, Z, but those before X, Y, Z, a,b; convert the files"
    with pytest.raises(FormatError, match=message):
        with formats.open_writer(tmp_path / "b.csv") as writer:
            writer.write(chunk)
            writer.write({"points": np.zeros((3, 3))})
    with pytest.raises(FormatError, match="would have no points; change the selection"):
        with formats.open_writer(tmp_path / "b.csv"):
            pass
    assert [path.name for path in tmp_path.iterdir()] == ["a.csv"]


@pytest.mark.parametrize("ending", ["txt", "asc", "pts", "ptx"])
def test_formats_that_are_only_read(tmp_path, ending):
    with pytest.raises(FormatError, match=f"a.{ending}: .{ending} is read, not written; written "):
        formats.open_writer(tmp_path / f"a.{ending}")


@pytest.mark.parametrize("text, kind, expected, note", [
    ("x,y,z,intensity\n1,2,3,7\n4,5,6,65535\n", np.uint16, [7, 65535], None),
    ("x,y,z,intensity\n1,2,3,0.5\n4,5,6,1\n", np.uint16, [32768, 65535], "scaled to 16 bits"),
    ("x,y,z,intensity\n1,2,3,-3.5\n4,5,6,1\n", np.float64, [-3.5, 1], "from -3.5 to 1 are not whole"),
    ("2\n1 2 3 -2048\n4 5 6 2047\n", np.uint16, [0, 4095], "raised by 2048"),
    ("2\n1 2 3 120\n4 5 6 255\n", np.uint16, [120, 255], None),
])  # fmt: skip
def test_intensities_of_text(tmp_path, text, kind, expected, note):
    path = tmp_path / "a.pts"
    path.write_text(text)
    reader, back = read(path, rows=1)
    name = "Intensity" if kind == np.uint16 else "intensity"
    assert back[name].tolist() == expected and back[name].dtype == kind
    assert [note in each for each in reader.notes] == ([True] if note else [])


def test_counts_of_pts(tmp_path):
    path = tmp_path / "a.pts"
    path.write_text("5\n1 2 3\n4 5 6\n")
    reader, back = read(path, rows=1)
    assert len(back["points"]) == 2
    assert reader.notes == [f"{path}: has 2 points, but its lines of numbers count 5; is it whole?"]


SCAN = "2\n2\n{move}\n0 1 0\n-1 0 0\n0 0 1\n0 1 0 0\n-1 0 0 0\n0 0 1 0\n{move} 1\n"
ROWS = "1 2 3 0.5 255 0 51\n0 0 0 0.5 0 0 0\n4 5 6 1 0 0 0\n7 8 9 0 1 2 3\n"


def test_scans_of_ptx_have_poses(tmp_path):
    path = tmp_path / "a.ptx"
    path.write_text("".join(SCAN.format(move=move) + ROWS for move in ("1000 2000 30", "5 6 7")))
    reader = formats.open_reader(path)
    chunks = [(reader.scan, chunk) for chunk in reader.chunks(2)]
    assert [(scan, len(chunk["points"])) for scan, chunk in chunks] == [
        (0, 2),
        (0, 1),
        (1, 2),
        (1, 1),
    ]
    assert chunks[0][1]["points"][0].tolist() == [998.0, 2001.0, 33.0]
    assert chunks[2][1]["points"][0].tolist() == [3.0, 7.0, 10.0]
    assert chunks[0][1]["Intensity"].tolist() == [32768, 65535]
    assert [scan.name for scan in reader.scans] == ["a_1", "a_2"]
    half = np.sqrt(0.5)
    assert reader.scans[1].has_pose and reader.scans[1].translation == (5.0, 6.0, 7.0)
    assert np.allclose(reader.scans[1].rotation, (half, 0, 0, half))
    assert f"{path}: 2 points without a return (0 0 0) are dropped" in reader.notes


def test_ptx_becomes_scans_of_e57(tmp_path):
    pye57 = pytest.importorskip("pye57")
    from vtkhelios.cli import main

    (tmp_path / "a.ptx").write_text(
        "".join(SCAN.format(move=move) + ROWS for move in ("1000 2000 30", "5 6 7"))
    )
    assert main(["convert", str(tmp_path / "a.ptx"), str(tmp_path / "a.e57"), "--quiet"]) == 0
    with pye57.E57(str(tmp_path / "a.e57")) as file:
        assert file.scan_count == 2
        assert np.allclose(file.get_header(1).translation, [5, 6, 7])
        local = file.read_scan_raw(1)
        assert np.allclose(local["cartesianX"], [1, 4, 7])


def test_ptx_with_a_matrix_that_is_no_rotation(tmp_path):
    path = tmp_path / "a.ptx"
    path.write_text(SCAN.format(move="0 0 0").replace("0 0 1 0\n", "0 0 2 0\n") + ROWS)
    reader, back = read(path)
    assert back["points"][0].tolist() == [-2.0, 1.0, 6.0]
    assert not reader.scans[0].has_pose
    assert "the matrix of scan 1 is no rotation: points are placed by it" in reader.notes[0]


def test_folders_of_clouds_skip_tables(tmp_path):
    from vtkhelios.comparison._inputs import list_files

    for name in ("a.xyz", "b.pts", "readme.txt", "table.csv"):
        (tmp_path / name).write_text("1 2 3\n")
    assert [path.name for path in list_files(tmp_path)] == ["a.xyz", "b.pts"]


# PLY


def test_plyfile_reads_a_header_in_ascii(tmp_path):
    plyfile = pytest.importorskip("plyfile")
    chunk = {"points": np.zeros((3, 3)), "Höhe über Null": np.arange(3), "Intensity": np.arange(3, dtype=np.uint16)}  # fmt: skip
    header = formats.Header()
    header.crs = DEGREES
    write(tmp_path / "a.ply", chunk, header)
    vertices = plyfile.PlyData.read(str(tmp_path / "a.ply"))["vertex"]
    assert vertices["intensity"].tolist() == [0, 1, 2]
    assert vertices["intensity"].dtype == "<f4"  # Open3D does not read ushort
    reader, back = read(tmp_path / "a.ply")
    assert reader.header.crs == DEGREES
    assert back["Höhe_über_Null"].tolist() == [0, 1, 2]
    assert back["Höhe_über_Null"].dtype == np.int64
    assert back["Intensity"].dtype == np.uint16


def test_damaged_intensities_of_ply(tmp_path):
    write(tmp_path / "a.ply", {"points": np.zeros((1, 3)), "Intensity": np.ones(1, np.uint16)})
    data = (tmp_path / "a.ply").read_bytes()
    assert data.endswith(np.float32(1.0).tobytes())
    for value in (0.5, -1.0, 65536.0, np.nan):
        (tmp_path / "a.ply").write_bytes(data[:-4] + np.float32(value).tobytes())
        with pytest.raises(FormatError, match="vertex 0: intensity is .*, not of type uint16; cor"):
            read(tmp_path / "a.ply")


def test_escapes(tmp_path):
    """The reader restores the characters that the writer escapes."""
    for text in ("a", "ä\\u00e4\\", "🛰", "°" * 5, "\ud800"):
        assert to_ascii(text).isascii() and "\\" not in to_ascii(text).replace("\\u", "")
        write(tmp_path / "a.ply", {"points": np.zeros((1, 3)), text: np.zeros(1)})
        assert text.replace("\ud800", "\ufffd") in read(tmp_path / "a.ply")[1]


def write_ply(path, properties, rows, form="ascii"):
    path.write_text(
        f"ply\nformat {form} 1.0\nelement vertex {len(rows)}\n"
        + "".join(f"property {each}\n" for each in properties)
        + "end_header\n"
        + "".join(row + "\n" for row in rows)
    )


def test_ply_of_cloudcompare(tmp_path):
    """Scalar fields are floats with a prefix."""
    names = ["double x", "double y", "double z", "uchar red", "uchar green", "uchar blue"]
    names += ["float nx", "float ny", "float nz", "float scalar_Intensity"]
    names += ["float scalar_Classification", "float scalar_Number_Of_Returns", "float scalar_Own"]
    write_ply(
        tmp_path / "a.ply",
        names,
        ["1 2 3 255 0 51 0 0 1 40000 6 2 0.5", "1 2 3 0 0 0 0 0 1 2 7 1 9"],
    )
    _, back = read(tmp_path / "a.ply", rows=1)
    assert back["Intensity"].tolist() == [40000, 2] and back["Intensity"].dtype == np.uint16
    assert back["ClassificationIds"].tolist() == [6, 7]
    assert back["ClassificationIds"].dtype == np.int32
    assert back["NumberOfReturns"].dtype == np.uint8
    assert back["scalar_Own"].tolist() == [0.5, 9.0]
    assert back["Normals"][0].tolist() == [0, 0, 1]


@pytest.mark.parametrize("kind, values, expected", [
    ("uchar", "255 0 51", [1.0, 0.0, 0.2]),
    ("ushort", "65535 0 13107", [1.0, 0.0, 0.2]),
    ("int", "255 0 51", [1.0, 0.0, 0.2]),
    ("int", "65535 0 13107", [1.0, 0.0, 0.2]),
    ("float", "1 0 0.2", [1.0, 0.0, 0.2]),
    ("float", "255 0 51", [1.0, 0.0, 0.2]),
])  # fmt: skip
@pytest.mark.parametrize("names", [("red", "green", "blue"), ("r", "g", "b"), ("Red", "Green", "Blue"),
                                   ("diffuse_red", "diffuse_green", "diffuse_blue")])  # fmt: skip
def test_colours_of_ply(tmp_path, kind, values, expected, names):
    properties = ["float X", "float Y", "float Z", *(f"{kind} {name}" for name in names)]
    write_ply(tmp_path / "a.ply", properties, [f"1 2 3 {values}", "1 2 3 0 0 0"])
    _, back = read(tmp_path / "a.ply", rows=1)
    assert back["points"][0].tolist() == [1, 2, 3]
    assert np.allclose(back["RGB"][0], expected) and back["RGB"].dtype == np.float32


def test_ply_values_that_are_no_integers_stay(tmp_path):
    properties = ["float x", "float y", "float z", "float classification", "float intensity"]
    write_ply(tmp_path / "a.ply", properties, ["1 2 3 0.5 -7", "1 2 3 1 9"])
    reader, back = read(tmp_path / "a.ply")
    assert back["classification"].tolist() == [0.5, 1.0]
    assert back["intensity"].tolist() == [-7, 9]
    assert "intensities from -7 to 9 are not whole numbers of 16 bits" in reader.notes[0]


def test_arrays_of_three_named_normal(tmp_path):
    """Normal of the scanner is not Normals."""
    chunk = {"points": np.zeros((2, 3)), "Normal": np.ones((2, 3)), "Normals": np.zeros((2, 3))}
    write(tmp_path / "a.ply", chunk)
    _, back = read(tmp_path / "a.ply")
    assert (
        back["Normal"].tolist() == [[1, 1, 1]] * 2 and back["Normals"].tolist() == [[0, 0, 0]] * 2
    )


# PCD

PCD = (
    "VERSION 0.7\nFIELDS x y z intensity\nSIZE 4 4 4 4\nTYPE F F F F\nWIDTH 2\nHEIGHT 1\nPOINTS 2\n"
)


@pytest.mark.parametrize("values, expected", [("7 255", [7, 255]), ("0.5 1", [32768, 65535])])
def test_intensities_of_pcl_become_those_of_las(tmp_path, values, expected):
    first, second = values.split()
    (tmp_path / "a.pcd").write_text(f"{PCD}DATA ascii\n1 2 3 {first}\n4 5 6 {second}\n")
    _, back = read(tmp_path / "a.pcd")
    write(tmp_path / "a.las", back)
    assert read(tmp_path / "a.las")[1]["Intensity"].tolist() == expected


def test_pcd_keeps_a_resolution(tmp_path):
    """Degrees do not fit floats; metres near an origin do."""
    points = np.random.default_rng(1).uniform([8.0, 48.0, 100.0], [8.5, 48.5, 300.0], (1000, 3))
    header = formats.Header()
    header.crs = "EPSG:4326"
    writer = write(tmp_path / "a.pcd", {"points": points}, header)
    assert "stored in 64 bits" in writer.notes[-1]
    assert np.array_equal(read(tmp_path / "a.pcd")[1]["points"], points)
    writer = write(tmp_path / "b.pcd", {"points": points}, make_header())
    assert "floats relative to an origin" in writer.notes[-1]
    header.crs = DEGREES
    write(tmp_path / "c.pcd", {"points": points}, header)
    assert (tmp_path / "c.pcd").read_bytes().split(b"DATA")[0].isascii()
    assert read(tmp_path / "c.pcd")[0].header.crs == DEGREES
    assert read(tmp_path / "b.pcd")[0].header.crs == CRS


@pytest.mark.parametrize("ending", ["xyz", "csv", "pts", "ptx", "asc", "txt", "pcd"])
def test_utf_16_is_named(tmp_path, ending):
    path = tmp_path / f"a.{ending}"
    path.write_text("1 2 3\n" * 10, encoding="utf-16")
    with pytest.raises(FormatError, match=f"a.{ending}: is text of UTF-16 or UTF-32; save it as"):
        read(path)
