# SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
# SPDX-License-Identifier: BSD-3-Clause
"""Damaged point files: values that libraries would trust are errors, and nothing is silent."""

import io
import os
import random
import re
import struct

import numpy as np
import pytest
from _point_files import make_chunk, read, write

from vtkhelios import formats, points
from vtkhelios.formats import FormatError
from vtkhelios.formats._records import RecordReader, RecordWriter
from vtkhelios.formats._base import guarded

PLY = "ply\nformat ascii 1.0\nelement vertex 1\n{}end_header\n{}\n"
XYZ = "property double x\nproperty double y\nproperty double z\n"


def patch(path, place, form, value):
    with open(path, "r+b") as file:
        file.seek(place)
        file.write(struct.pack(form, value))


def fails(path, message):
    with pytest.raises(FormatError, match=message) as error:
        read(path)
    assert str(error.value).startswith(f"{path}:")


# LAZ


@pytest.fixture
def laz(tmp_path):
    """5000 points of format 7 or similar, in one chunk; their offset, and the offset of the chunk table."""
    path = tmp_path / "a.laz"
    write(path)
    data = path.read_bytes()
    begin = struct.unpack_from("<I", data, 96)[0]
    return path, begin, struct.unpack_from("<q", data, begin)[0]


@pytest.mark.parametrize(
    "place, form, value, message",
    [
        (24, "B", 7, r"is LAS 7.4; versions 1.0 to 1.5 can be read"),
        (94, "<H", 9, "has a header of 9 bytes; LAS 1.4 has 375"),
        (100, "<I", 2**32 - 1, "has a variable length record at byte"),
        (131, "<d", 0.0, "has a scale of 0 and an offset of .*, which give no valid coord"),
        (139, "<d", np.nan, "has a scale of nan and an offset"),
        (147, "<d", 1e300, r"has a scale of 1e\+300 and an offset"),
        (243, "<I", 2**32 - 1, "has an extended record of"),
        (247, "<Q", 2**40, r"bytes, too few for 1099511627776 points"),
        (247, "<Q", 10, "has chunks with 5000 points of the 10 that its header counts"),
    ],
)
def test_damaged_laz_headers(laz, place, form, value, message):
    patch(laz[0], place, form, value)
    fails(laz[0], message)


def test_damaged_laz_chunk_tables(laz):
    path, begin, table = laz
    whole = path.read_bytes()
    for place, form, value, message in (
        (
            begin,
            "<q",
            2**62,
            "has no table of its 5000 points at byte 4611686018427387904 of",
        ),
        (begin, "<q", -1, "has no table of its 5000 points at byte"),
        (table, "<I", 7, "has a table of chunks that is cut off or damaged"),
        (
            table + 4,
            "<I",
            2**32 - 1,
            "has a table of 4294967295 chunks for 5000 points in",
        ),
        (table + 8, "<I", 0xFFFFFF, "it is cut off or damaged, copy it again"),
    ):
        path.write_bytes(whole)
        patch(path, place, form, value)
        fails(path, message)
        with pytest.raises(ValueError, match="a.laz cannot be read: "):
            points.las_source(path)


def test_damaged_laz_chunks(laz):
    """The head of a chunk: LASzip allocates the sizes in its layers."""
    path, begin, _ = laz
    width = struct.unpack_from("<H", path.read_bytes(), 105)[0]
    patch(path, begin + 8 + width + 8, "<I", 2**32 - 1)
    fails(path, r"has a chunk with layers of 4\d+ bytes in \d+ bytes")


def test_damaged_laszip_records(laz):
    path, _, _ = laz
    whole = path.read_bytes()
    record = whole.find(b"laszip encoded") - 2 + 54
    for place, form, value, message in (
        (record, "<H", 1, "has a compressed item of type 10, version 3"),
        (record, "<H", 9, "is compressed by compressor 9, coder 0, which cannot be read"),
        (
            record,
            "<H",
            2,
            "has a compressed item of type 10, version 3, with 30 bytes, which cannot",
        ),
        (record + 12, "<I", 17, "has chunks with 17 points of the 5000 that its header counts"),
        (
            record + 36,
            "<H",
            31,
            "has a compressed item of type 10, version 3, with 31 bytes, which cannot",
        ),
        (
            record + 32,
            "<H",
            1,
            "has compressed items of 30 bytes that are not the fields of its points",
        ),
        (record - 52, "B", 0, "has compressed points, but no record of LASzip"),
    ):
        path.write_bytes(whole)
        patch(path, place, form, value)
        fails(path, message)


def test_laz_texts_beyond_ascii(laz):
    """Names of people and programs do not invalidate a file."""
    path, _, _ = laz
    patch(path, 26, "<4s", b"M\xfcll")  # the system, and the program
    patch(path, 58, "<4s", b"\xff\xcb\xfce")
    data = path.read_bytes()
    patch(path, data.find(b"LASF_Projection") + 15 + 1 + 4, "<3s", b"\xe4\xf6\xfc")  # a description
    patch(path, data.find(b"PROJ") if b"PROJ" in data else 400, "<2s", b"\xff\xfe")
    reader, back = read(path)
    assert len(back["points"]) == 5000
    assert isinstance(reader.header.crs, str)


def test_laz_of_a_version_without_its_format(laz):
    path, _, _ = laz
    patch(path, 25, "B", 0)
    patch(path, 107, "<I", 5000)
    assert len(read(path)[1]["points"]) == 5000


def test_laz_that_laspy_does_not_write(laz, monkeypatch):
    import laspy

    def refuse(*_, **__):
        raise laspy.errors.FileVersionNotSupported("1.0")

    path, _, _ = laz
    monkeypatch.setattr(laspy, "LasWriter", refuse)
    message = "its records cannot be copied by laspy: FileVersionNotSupported 1.0; convert it with"
    with pytest.raises(FormatError, match=message):
        RecordWriter(io.BytesIO(), RecordReader(path), compress=True)


# PLY


@pytest.mark.parametrize(
    "properties, line, message",
    [
        (
            XYZ + "property int x\n",
            "1 2 3 4",
            'property "x" of "vertex" is given twice; remove one',
        ),
        (
            XYZ + "property int points\n",
            "1 2 3 4",
            '"points", which is reserved for coordinates; rename',
        ),
        (
            XYZ
            + "property float red\nproperty float green\nproperty float blue\nproperty int RGB\n",
            "1 2 3 0 0 0 1",
            'has a property "RGB" in addition to RGB; leave one out',
        ),
        (
            XYZ + "property int a\nproperty int aX\nproperty int aY\nproperty int aZ\n",
            "1 2 3 4 5 6 7",
            'has a property "aX" beside a; leave one out',
        ),
        (
            XYZ + "property uchar n\n",
            "1 2 3 300",
            "a.ply:9: n is 300, not of type uchar; correct it",
        ),
        (
            XYZ + "property int n\n",
            "1 2 3 nan",
            'a.ply:9: "nan" is not a whole number; correct it',
        ),
        (XYZ + "element vertex 1\n", "1 2 3", 'element "vertex" is given twice; remove one'),
        (
            XYZ + "comment vtkhelios epoch x\n",
            "1 2 3",
            'gives "x" as the origin of its times, which is not a num',
        ),
        (
            XYZ + "property double n\ncomment vtkhelios type:n int64\n",
            "1 2 3 1.5",
            "n is 1.5, not of type int64; correct it",
        ),
    ],
)
def test_damaged_ply_properties(tmp_path, properties, line, message):
    path = tmp_path / "a.ply"
    path.write_text(PLY.format(properties, line))
    fails(path, message)


def test_ply_of_too_many_points(tmp_path):
    path = tmp_path / "a.ply"
    path.write_text(PLY.format(XYZ, "1 2 3").replace("vertex 1", "vertex 999999999999"))
    fails(
        path,
        "need 5999999999994 bytes or more, and 6 follow, so it is cut off; copy or write it again",
    )
    path.write_text(PLY.format(XYZ, "1 2 3").replace("vertex 1", "vertex " + "9" * 5000))
    fails(path, "expected a whole number from 0 to 2.40")
    path.write_text(PLY.format(XYZ + "comment vtkhelios\n", "1 2 3"))
    assert read(path)[1]["points"].tolist() == [[1, 2, 3]]


# Numbers that are not finite


@pytest.mark.parametrize("ending", ["ply", "vtp", "pvtp"])
def test_points_that_are_not_finite(tmp_path, ending):
    chunk = make_chunk(10)
    chunk["points"][3, 1], chunk["points"][4, 2] = np.nan, np.inf
    chunk["Amplitude"][5] = np.inf
    path = tmp_path / f"a.{ending}"
    write(path, chunk, rows=4)
    reader, back = read(path, rows=7)
    assert np.array_equal(back["points"], np.delete(chunk["points"], [3, 4], axis=0))
    assert np.array_equal(back["Range"], np.delete(chunk["Range"], [3, 4]))
    assert sorted(reader.notes) == [
        f"{path}: 2 of 10 points are not finite; they are dropped",
        f"{path}: Amplitude is not finite at 1 of 10 points, and is kept so",
    ]
    with formats.open_reader(path) as reader:
        reader.keeps_invalid = True
        assert sum(len(each["points"]) for each in reader.chunks()) == 10
        assert [note for note in reader.notes if "left out" in note] == []


# Libraries


class PanicException(BaseException):  # noqa: N818  the name that panics of Rust have
    pass


@pytest.mark.parametrize("ending", ["vtp", "pcd"])
def test_arrays_of_one_value_per_point(tmp_path, ending):
    chunk = make_chunk(10)
    chunk["ReturnNumber"] = np.ones((10, 3), np.uint8)
    path = tmp_path / f"a.{ending}"
    with formats.open_writer(path) as writer:
        writer.write(chunk)
    fails(path, "ReturnNumber has 3 values per point, expected one")


@pytest.mark.parametrize(
    "error, message",
    [
        (MemoryError(), "a.laz: not enough memory; split it"),
        (OSError(5, "Input/output error"), "a.laz: cannot be read: Input/output error; check"),
        (
            OverflowError("too\n large"),
            "a.laz: cannot be read: too large; it is damaged, or of an unknown form",
        ),
        (AssertionError(), "a.laz: cannot be read: AssertionError; it is damaged"),
        (struct.error("unpack requires"), "a.laz: cannot be read: unpack requires; it is damaged"),
        (
            PanicException("index out of bounds"),
            "a.laz: cannot be read: index out of bounds; it is",
        ),
    ],
)
def test_errors_of_libraries(error, message):
    with pytest.raises(FormatError, match=re.escape(message)), guarded("a.laz"):
        raise error


def test_other_errors_are_not_caught():
    for error in (KeyboardInterrupt, SystemExit, FormatError):
        with pytest.raises(error), guarded("a.laz"):
            raise error


def test_damaged_octrees(tmp_path):
    """All points are read, and a note describes the error."""
    path = tmp_path / "a.copc.laz"
    write(path)
    assert read(path)[0].notes == []
    whole = path.read_bytes()
    page = struct.unpack_from("<Q", whole, 469)[0]
    for place, form, value, message in (
        (469, "<Q", 2**63, "a page of "),
        (477, "<Q", 31, "a page of 31 bytes at byte"),
        (page + 28, "<i", -7, "a node of -7 points in"),
        (page + 28, "<i", 7, "it has 7 of 5000 points"),
        (page + 16, "<Qii", (page, 32, -1), f"a page of 32 bytes at byte {page} of"),  # itself
    ):
        path.write_bytes(whole)
        with open(path, "r+b") as file:
            file.seek(place)
            file.write(struct.pack(form, *(value if isinstance(value, tuple) else (value,))))
        reader, back = read(path)
        assert len(back["points"]) == 5000
        assert len(reader.notes) == 1 and f"its octree is damaged: {message}" in reader.notes[0]


# Bytes


def damage(data, chance):
    """Changes bytes, replaces numbers, truncates."""
    data = bytearray(data)
    for _ in range(chance.randint(1, 3)):
        place = chance.randrange(chance.choice([400, len(data)])) % len(data)
        what = chance.randrange(4)
        if what == 0:
            data[place] = chance.randrange(256)
        elif what == 1:
            number = chance.choice([0, 1, 2**15, 2**31, 2**32 - 1, 2**40, 2**64 - 1])
            data[place : place + 8] = number.to_bytes(8, "little")
        elif what == 2:
            number = chance.choice([np.nan, np.inf, 0.0, 1e300])
            data[place : place + 8] = struct.pack("<d", number)
        else:
            del data[chance.choice([place, len(data) - chance.randrange(60)]) :]
        data = data or bytearray(b"x")
    return bytes(data)


@pytest.mark.parametrize("ending", ["vtp", "pvtp", "ply", "laz", "copc.laz", "e57"])
def test_damaged_bytes(tmp_path, ending):
    """An error that names the file, or finite points."""
    pytest.importorskip("pye57" if ending == "e57" else "numpy")
    path = tmp_path / f"a.{ending}"
    write(path, make_chunk(60))
    whole = path.read_bytes()
    chance, errors = random.Random(20261), 0
    for _ in range(int(os.environ.get("HELIOS_MUTATIONS", "150"))):
        path.write_bytes(damage(whole, chance))
        try:
            _, back = read(path)
            assert np.isfinite(back["points"]).all()
        except FormatError as error:
            errors += 1
            assert str(path) in str(error)
    assert errors > 20
