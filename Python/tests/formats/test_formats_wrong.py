# SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
# SPDX-License-Identifier: BSD-3-Clause
"""Point formats: invalid files and arrays, and their messages."""

import builtins
import re

import numpy as np
import pytest
from _point_files import COUNT, full_format, make_chunk, make_header, read, write

from vtkhelios import formats
from vtkhelios.formats import FormatError

__all__ = ["full_format"]  # a fixture


def cut(path, share):
    data = path.read_bytes()
    path.write_bytes(data[: int(len(data) * share)])


@pytest.mark.parametrize(
    "ending, message",
    [
        ("las", "is cut off"),
        ("laz", "is cut off or damaged, copy it again"),
        ("ply", "need .* bytes or more, and .* follow, so it is cut off"),
        ("vtp", "a.vtp"),
        ("e57", "is not an E57 file, or is damaged"),
    ],
)
def test_truncated_files(tmp_path, ending, message):
    pytest.importorskip({"laz": "lazrs", "e57": "pye57"}.get(ending, "numpy"))
    path = tmp_path / f"a.{ending}"
    write(path)
    cut(path, 0.6)
    with pytest.raises(FormatError, match=message) as error:
        read(path)
    assert str(path) in str(error.value)


@pytest.mark.parametrize("ending", list(formats.FORMATS))
def test_files_of_another_kind(tmp_path, ending):
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
    with pytest.raises(
        FormatError, match="has chunks with 5000 points of the 105000 that its header counts"
    ):
        read(path, 200_000)


@pytest.mark.parametrize(
    "text, message",
    [
        ("1 2 3\n4 5 \0 6\n", "a.xyz:2: has zero bytes, so it is not valid text: it is damaged"),
        (
            "1 2 3\n4 5\n",
            "a.xyz:2: has 2 columns, but the first row has 3; correct or remove the row",
        ),
        (
            "1 2 3\n4 x 6\n",
            'a.xyz:2: "x" in column 2 (y) is not a number; correct or remove the row',
        ),
        ("1 2\n", "a.xyz: has 2 columns; give x y z"),
        ("\n# nothing\n", "a.xyz: has no points"),
        (
            "1 2 3 4 5 1 1 7 wall 2 0.5\n1 2 3 4 5 1.5 1 7 wall 2 0.5\n",
            'a.xyz:2: "1.5" in column 6 (return number) is not a whole number from 0 to 255; correct',
        ),
        ("1 2 3 4 5 1 1 7 0 2 0.5\n1 2 3 4 5 1 1 7 0 2\n", "a.xyz:2: has 10 columns"),
    ],
)
def test_bad_text(tmp_path, text, message):
    path = tmp_path / "a.xyz"
    path.write_text(text)
    with pytest.raises(FormatError, match=re.escape(message)):
        read(path)


PLY = "ply\nformat {form} 1.0\nelement vertex {count}\n{properties}end_header\n"
XYZ = "property double x\nproperty double y\nproperty double z\n"


@pytest.mark.parametrize(
    "head, message",
    [
        ({"form": "binary", "count": 1, "properties": XYZ}, 'format "binary" is not known'),
        ({"form": "ascii", "count": 0, "properties": XYZ}, "has no points"),
        ({"form": "ascii", "count": "x", "properties": XYZ}, 'has the count "x"; expected a whole'),
        ({"form": "ascii", "count": 1, "properties": XYZ[:18]}, "element vertex has no number y"),
        (
            {"form": "ascii", "count": 1, "properties": XYZ + "property list uchar int n\n"},
            "is a list; points have plain numbers only",
        ),
        (
            {"form": "ascii", "count": 1, "properties": "element face 2\n" + XYZ},
            "element vertex has no number x; vertices need x, y and z",
        ),
        ({"form": "ascii", "count": 3, "properties": XYZ}, "so it is cut off; copy or write it"),
    ],
)
def test_bad_ply(tmp_path, head, message):
    path = tmp_path / "a.ply"
    path.write_text(PLY.format(**head) + "1 2 3\n4 5 6\n")
    with pytest.raises(FormatError, match=re.escape(message)):
        read(path)


@pytest.mark.parametrize(
    "content, message",
    [
        ("solid x", "is not a PLY file: its first line is not ply; check its name"),
        ("ply\nformat ascii 1.0\n", "the file ends before end_header; it is not a PLY file"),
        (PLY.format(form="ascii", count=1, properties=XYZ) + "1 x 3\n", ':8: "x" is not a number'),
    ],
)
def test_files_that_are_not_ply(tmp_path, content, message):
    (tmp_path / "a.ply").write_text(content)
    with pytest.raises(FormatError, match=message):
        read(tmp_path / "a.ply")


INDEX = '<VTKFile type="{kind}"><PPolyData>{pieces}</PPolyData></VTKFile>'


@pytest.mark.parametrize(
    "content, message",
    [
        ("<VTKFile>", "is not XML: .*; write it again"),
        (INDEX.format(kind="PImageData", pieces=""), r"in pieces \(PPolyData\); give that file"),
        (INDEX.format(kind="PPolyData", pieces=""), "lists no pieces, so it has no points"),
        (
            INDEX.format(kind="PPolyData", pieces='<Piece Source="b.vtp"/>'),
            "b.vtp is missing; keep",
        ),
        (
            INDEX.format(kind="PPolyData", pieces='<Piece Source="c.vtp"/>'),
            "c.vtp is not a VTK XML fi",
        ),
    ],
)
def test_bad_pieces(tmp_path, content, message):
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


def test_e57_of_other_programs(tmp_path):
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
    with pytest.raises(FormatError, match=r"whole numbers to 2\^53, but PulseIds has larger ones"):
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
        (
            {"points": np.array([["a", "b", "c"]])},
            "points is of the type <U1; give integers or floats",
        ),
        (
            {"Range": np.zeros(3)},
            r"Range has the shape \(3,\), but there are 2 points; give one row",
        ),
        ({"Range": np.zeros((2, 1, 1))}, r"Range has the shape \(2, 1, 1\)"),
        ({"Range": [1.0, 2.0]}, "Range is of the type list; give integers or floats"),
        ({"Range": np.zeros(2, complex)}, "Range is of the type complex128"),
        ({"Range": np.zeros(2, np.float16)}, "Range is of the type float16"),
        ({"Range": np.zeros(2, ">f8")}, "Range is of the type >f8"),
    ],
)
def test_bad_arrays(tmp_path, arrays, message):
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
    with pytest.raises(FormatError, match="cloud.dat: its ending is not of a known format; "):
        formats.open_reader(tmp_path / "cloud.dat")
    with pytest.raises(FormatError, match="none.las: no such file; check its name"):
        formats.open_reader(tmp_path / "none.las")
    (tmp_path / "file").write_text("")
    with pytest.raises((FormatError, OSError), match="file"):
        write(tmp_path / "file" / "a.ply")


@pytest.mark.parametrize(
    "missing, ending, command",
    [
        ("pye57", "e57", "pip install --no-deps pye57 pyquaternion"),
    ],
)
def test_missing_packages(tmp_path, monkeypatch, missing, ending, command):
    import importlib

    real_import, real_module = builtins.__import__, importlib.import_module

    def refuse(call):
        def without(name, *arguments, **options):
            if name == missing:
                raise ImportError(name)
            return call(name, *arguments, **options)

        return without

    monkeypatch.setattr(builtins, "__import__", refuse(real_import))
    monkeypatch.setattr(importlib, "import_module", refuse(real_module))
    with pytest.raises(FormatError, match=re.escape(command)):
        formats.open_writer(tmp_path / f"a.{ending}")
