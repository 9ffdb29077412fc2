# SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
# SPDX-License-Identifier: BSD-3-Clause
"""E57: limits, flags, times, poses and unlike scans, in files written by libE57Format alone."""

import numpy as np
import pytest
from _point_files import make_chunk, read, write

from vtkhelios import formats
from vtkhelios.formats import FormatError

pye57 = pytest.importorskip("pye57")
libe57 = pye57.libe57
XYZ = {f"cartesian{axis}": ("double", 0) for axis in "XYZ"}


def make_node(image, kind, value):
    """A number: double, single, (low, high) or (low, high, scale, offset)."""
    if kind == "double":
        return libe57.FloatNode(image, float(value), libe57.E57_DOUBLE)
    if kind == "single":
        return libe57.FloatNode(image, float(value), libe57.E57_SINGLE, 0.0, 1.0)
    if len(kind) == 2:
        return libe57.IntegerNode(image, int(value), *kind)
    low, high, scale, offset = kind
    return libe57.ScaledIntegerNode(image, int(value), low, high, scale, offset)


def make_structure(image, values):
    """Nested numbers: name to a dict, or to a pair of kind and value."""
    node = libe57.StructureNode(image)
    for name, value in values.items():
        child = (
            make_structure(image, value) if isinstance(value, dict) else make_node(image, *value)
        )
        node.set(name, child)
    return node


def write_scans(path, *scans):
    """Scans: pairs of fields (name to kind and numbers) and heads (nested numbers)."""
    with pye57.E57(str(path), "w") as file:
        image = file.image_file
        for fields, head in scans:
            prototype, buffers = libe57.StructureNode(image), libe57.VectorSourceDestBuffer()
            numbers = {name: np.array(values, float) for name, (_, values) in fields.items()}
            for name, values in numbers.items():
                kind = fields[name][0]
                prototype.set(name, make_node(image, kind, 0))
                buffers.append(
                    libe57.SourceDestBuffer(image, name, values, len(values), True, True)
                )
            node = make_structure(image, head)
            node.set("guid", libe57.StringNode(image, "{1}"))
            points = libe57.CompressedVectorNode(image, prototype, libe57.VectorNode(image, True))
            node.set("points", points)
            file.data3d.append(node)
            writer = points.writer(buffers)
            writer.write(len(values))
            writer.close()


def fields_of(count=3, **others):
    """Points 0, 1, 2 ... on the diagonal, with other fields."""
    numbers = np.arange(count, dtype=float)
    return {**dict.fromkeys(XYZ, ("double", numbers)), **others}


def limits_of(name, low, high, kind="double"):
    return {f"{name}Minimum": (kind, low), f"{name}Maximum": (kind, high)}


@pytest.mark.parametrize(
    ("kind", "values", "head", "expected"),
    [
        # Limits of any kind of number.
        ("double", [0.0, 0.5, 1.0], limits_of("intensity", 0, 1), [0, 32768, 65535]),
        ("double", [1.0, 2.0, 3.0], limits_of("intensity", 1, 3), [0, 32768, 65535]),
        ((0, 2047, 0.001, 0.0), [0, 1.0235, 2.047],
         limits_of("intensity", 0, 2047, (0, 2047, 0.001, 0.0)), [0, 32784, 65535]),
        ((0, 2047), [0, 2047, 0], limits_of("intensity", 0, 2047, (0, 2047)), [0, 65535, 0]),
        # without limits, or with limits that are equal: of the type
        ((0, 255), [0, 51, 255], None, [0, 13107, 65535]),
        ((-2048, 2047), [-2048, 2047, 0], None, [0, 65535, 32776]),
        ((0, 1000, 0.01, 5.0), [5.0, 15.0, 10.0], None, [0, 65535, 32768]),
        ("single", [0.0, 1.0, 0.5], None, [0, 65535, 32768]),
        ((0, 255), [0, 51, 255], limits_of("intensity", 7, 7), [0, 13107, 65535]),
        # numbers without any range: whole ones of 16 bits as they are
        ("double", [0.0, 7.0, 65535.0], None, [0, 7, 65535]),
    ],
)  # fmt: skip
def test_intensity(tmp_path, kind, values, head, expected):
    head = {"intensityLimits": head} if head else {}
    write_scans(tmp_path / "a.e57", (fields_of(intensity=(kind, values)), head))
    _, back = read(tmp_path / "a.e57")
    assert back["Intensity"].dtype == np.uint16 and back["Intensity"].tolist() == expected


def test_intensities_without_a_range_are_kept(tmp_path):
    values = [-1.5, 0.25, 70000.0]
    write_scans(tmp_path / "a.e57", (fields_of(intensity=("double", values)), {}))
    _, back = read(tmp_path / "a.e57")
    assert back["Intensity"].tolist() == values
    write(tmp_path / "b.las", back)
    _, again = read(tmp_path / "b.las")
    assert again["Intensity"].tolist() == values  # in the Extra Bytes
    laspy = pytest.importorskip("laspy")
    assert laspy.read(tmp_path / "b.las").intensity.tolist() == [0, 0, 65535]


def test_intensities_outside_of_their_limits_are_counted(tmp_path):
    head = {"intensityLimits": limits_of("intensity", 0, 1)}
    fields = fields_of(intensity=("double", [-1.0, np.inf, 0.5]))
    write_scans(tmp_path / "a.e57", (fields, head))
    reader, back = read(tmp_path / "a.e57")
    assert back["Intensity"].tolist() == [0, 0, 32768]
    assert any("1 intensities are outside the limits" in note for note in reader.notes)
    assert any("1 intensities are not finite: read as 0" in note for note in reader.notes)


@pytest.mark.parametrize(
    ("kind", "full", "limits"),
    [
        ((0, 255), 255, None), ((0, 65535), 65535, None), ((0, 65535), 255, 255),
        ((0, 4095), 4095, 4095), ("double", 255, None), ("double", 1, None),
        ("double", 65535, None), ((-(2**63), 2**63 - 1), 255, None),
        ((0, 65535, 1 / 65535, 0.0), 1, None),
    ],
)  # fmt: skip
def test_colours(tmp_path, kind, full, limits):
    values = np.array([[0, 0.2, 1], [1, 0, 0.6], [0.4, 1, 0]]) * full
    if kind != "double" and len(kind) == 2:
        values = np.rint(values)
    names = ("colorRed", "colorGreen", "colorBlue")
    colours = {name: (kind, values[:, i]) for i, name in enumerate(names)}
    head = {}
    if limits:
        for name in names:
            head |= limits_of(name, 0, limits, (0, 65535))
        head = {"colorLimits": head}
    write_scans(tmp_path / "a.e57", (fields_of(**colours), head))
    _, back = read(tmp_path / "a.e57")
    assert np.allclose(back["RGB"], values / full, rtol=0, atol=1e-6)


def test_values_marked_as_invalid_are_counted(tmp_path):
    flag = (0, 1)
    fields = fields_of(
        6,
        cartesianInvalidState=((0, 2), [0, 1, 2, 2, 0, 0]),
        intensity=((0, 255), [255] * 6), isIntensityInvalid=(flag, [0, 0, 0, 0, 1, 0]),
        timeStamp=("double", [5.0] * 6), isTimeStampInvalid=(flag, [0, 1, 0, 0, 1, 1]),
        **{name: ((0, 255), [255] * 6) for name in ("colorRed", "colorGreen", "colorBlue")},
        isColorInvalid=(flag, [1, 0, 0, 0, 0, 0]), rowIndex=((0, 9), [0] * 6),
    )  # fmt: skip
    write_scans(tmp_path / "a.e57", (fields, {}))
    reader, back = read(tmp_path / "a.e57")
    assert back["points"][:, 0].tolist() == [0, 4, 5]
    assert back["Intensity"].tolist() == [65535, 0, 65535]
    assert back["GpsTime"].tolist() == [5, 0, 0]
    assert back["RGB"][:, 0].tolist() == [0, 1, 1]
    text = "\n".join(reader.notes)
    assert "3 points are marked as invalid (1 pulse without an echo, 2 without coord" in text
    assert "1 intensities are marked as invalid: read as 0" in text
    assert "2 time stamps are marked as invalid: read as 0" in text
    assert "1 colours are marked as invalid: read as 0" in text
    assert "these fields are dropped: rowIndex" in text


def test_spherical_points_marked_as_invalid_are_dropped(tmp_path):
    fields = {
        "sphericalRange": ("double", [2.0, 3.0]),
        "sphericalAzimuth": ((0, 4000, 0.001, 0.0), [0.0, 1.0]),
        "sphericalElevation": ("double", [0.0, 0.0]),
        "sphericalInvalidState": ((0, 2), [0, 2]),
    }
    write_scans(tmp_path / "a.e57", (fields, {}))
    reader, back = read(tmp_path / "a.e57")
    assert back["points"].tolist() == [[2, 0, 0]]
    assert "1 point is marked as invalid" in reader.notes[0]


def start_of(seconds):
    return {"acquisitionStart": {"dateTimeValue": ("double", seconds)}}


def test_times_of_scans_count_from_their_starts(tmp_path):
    stamps = ((0, 10**9, 1e-6, 0.0), [0.0, 0.5, 1.0])
    scans = [(fields_of(timeStamp=stamps), start_of(start)) for start in (1e9, 1e9 + 3600)]
    write_scans(tmp_path / "a.e57", *scans)
    reader, back = read(tmp_path / "a.e57")
    assert reader.header.epoch == 1e9
    assert back["GpsTime"].tolist() == [0, 0.5, 1, 3600, 3600.5, 3601]
    write(tmp_path / "b.e57", back, reader.header)
    again, times = read(tmp_path / "b.e57")
    assert again.header.epoch == 1e9 and times["GpsTime"].tolist() == back["GpsTime"].tolist()
    scans[0] = (scans[0][0], {})
    write_scans(tmp_path / "c.e57", *scans)
    reader, _ = read(tmp_path / "c.e57")
    assert "1 of 2 scans have no acquisitionStart: their times count from 1000003600 s" in "".join(
        reader.notes
    )


@pytest.mark.parametrize("length", [1.0, 2.0, 1e-3])
def test_quaternions_are_normalised(tmp_path, length):
    """A quarter turn about z; the parts of the pose in any order."""
    half = np.sqrt(0.5) * length
    pose = {
        "translation": {"z": ("double", 30), "x": ("double", 10), "y": ((0, 99), 20)},
        "rotation": {"z": ("double", half), "x": ("double", 0), "y": ("double", 0),
                     "w": ("double", half)},
    }  # fmt: skip
    fields = fields_of(2)
    fields["cartesianY"] = fields["cartesianZ"] = ("double", [0.0, 0.0])
    write_scans(tmp_path / "a.e57", (fields, {"pose": pose}))
    reader, back = read(tmp_path / "a.e57")
    assert np.allclose(back["points"], [[10, 20, 30], [10, 21, 30]], rtol=0, atol=1e-12)
    assert np.linalg.norm(reader.scans[0].rotation) == pytest.approx(1.0, abs=1e-15)
    told = any(f"quaternion of length {length:.9g}; it is norm" in note for note in reader.notes)
    assert told == (length != 1.0)


def test_a_quaternion_without_direction_is_an_error(tmp_path):
    pose = {"rotation": dict.fromkeys("wxyz", ("double", 0))}
    write_scans(tmp_path / "a.e57", (fields_of(), {"pose": pose}))
    with pytest.raises(FormatError, match='a.e57: the rotation of scan "scan000" is the quat'):
        formats.open_reader(tmp_path / "a.e57")


def test_unlike_scans_become_one_cloud(tmp_path):
    """One with intensities, one with colours and times; as floats where one has floats."""
    colours = {name: ((0, 255), [255] * 3) for name in ("colorRed", "colorGreen", "colorBlue")}
    first = fields_of(intensity=((0, 255), [255] * 3))
    second = fields_of(intensity=("double", [0.5] * 3), timeStamp=("double", [1.0] * 3), **colours)
    write_scans(tmp_path / "a.e57", (first, {}), (second, {}))
    reader, back = read(tmp_path / "a.e57")
    assert back["Intensity"].tolist() == [65535] * 3 + [0.5] * 3
    assert back["RGB"][:, 0].tolist() == [0] * 3 + [1] * 3
    assert back["GpsTime"].tolist() == [0] * 3 + [1] * 3
    note = 'scan "scan000": has not all arrays of the others; its points get 0 for GpsTime, RGB'
    assert any(note in each for each in reader.notes)
    with formats.open_reader(tmp_path / "a.e57") as parts:
        parts.fills_missing = False
        found = [set(chunk) for chunk in parts.chunks()]
    assert found == [{"points", "Intensity"}, {"points", "Intensity", "GpsTime", "RGB"}]


def read_raw(path, names):
    with pye57.E57(str(path)) as file:
        header = file.get_header(0)
        data = {name: np.empty(header.point_count) for name in names}
        buffers = libe57.VectorSourceDestBuffer()
        for name, values in data.items():
            buffers.append(libe57.SourceDestBuffer(
                file.image_file, name, values, len(values), True, True))  # fmt: skip
        header.points.reader(buffers).read()
        limits = {
            name: header.node[path].value()
            for name, path in (("colour", "colorLimits/colorRedMaximum"),
                               ("intensity", "intensityLimits/intensityMaximum"))
            if header.node.isDefined(path)
        }  # fmt: skip
        return data, limits


def test_colours_have_as_many_bits_as_they_need(tmp_path):
    for bits in (8, 16):
        chunk = make_chunk(10)
        full = 2**bits - 1
        numbers = np.arange(30).reshape(10, 3) * 8 + 7
        chunk["RGB"] = (numbers / full).astype(np.float32)
        write(tmp_path / "a.e57", chunk)
        data, limits = read_raw(tmp_path / "a.e57", ["colorRed"])
        assert limits["colour"] == full and data["colorRed"].tolist() == numbers[:, 0].tolist()
        _, back = read(tmp_path / "a.e57")
        assert np.allclose(back["RGB"], chunk["RGB"], rtol=0, atol=1e-7)


def test_colours_of_16_bits_after_those_of_8_are_named(tmp_path):
    chunk = make_chunk(2)
    with formats.open_writer(tmp_path / "a.e57") as writer:
        for red in (1.0, 0.001):
            chunk["RGB"] = np.full((2, 3), red, np.float32)
            writer.write(dict(chunk))
    assert writer.lost["RGB of 16 bits"] == "colours at the beginning of the scan have 8"


def test_intensities_come_back(tmp_path):
    """Intensities of 16 bits come back with their limits, and not as amplitudes."""
    points = {"points": np.zeros((3, 3))}
    for values in (np.array([0, 7, 65535], np.uint16), np.array([0.5, 1.5, 2.5])):
        write(tmp_path / "a.e57", {**points, "Intensity": values})
        _, limits = read_raw(tmp_path / "a.e57", ["intensity"])
        assert limits == ({"intensity": 65535} if values.dtype == np.uint16 else {})
        _, back = read(tmp_path / "a.e57")
        assert set(back) == {"points", "Intensity"} and back["Intensity"].dtype == values.dtype
        assert back["Intensity"].tolist() == values.tolist()


def test_returns_alone_are_named(tmp_path):
    chunk = {"points": np.zeros((1, 3)), "ReturnNumber": np.ones(1, np.uint8)}
    writer = write(tmp_path / "a.e57", chunk)
    assert writer.lost == {"ReturnNumber": "E57 stores it together with NumberOfReturns"}
