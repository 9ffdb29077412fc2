# SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
# SPDX-License-Identifier: BSD-3-Clause
"""Contents that the point formats store: written here and read by other readers, and the reverse.

    build/venv/bin/python Testing/Integration/format_matrix.py          prints the tables
    build/venv/bin/python Testing/Integration/format_matrix.py --write  writes them to Docs/files.md

Other readers and writers: laspy, copclib, pye57, plyfile, VTK's own XML, and numpy for text and PCD.
A cell states the largest error of an attribute that is not exact, of coordinates in metres; a dash: the
format, or the program, does not store it. To add an attribute: a column in COLUMNS, its values in make(), and what the readers
and writers make of it.
"""

import pathlib
import sys
import tempfile

import numpy as np

from vtkhelios import formats
from vtkhelios.array_names import MATERIAL_NAME

DOCUMENT = pathlib.Path(__file__).resolve().parents[2] / "Docs" / "files.md"
BEGIN, END = "<!-- begin: format_matrix.py -->", "<!-- end: format_matrix.py -->"
COUNT = 1000
EPOCH = 1.4e9  # [s] of GPS time
NAMES = ["ground", "house", "tree"]
SURVEY_FOOT, DEGREE = 1200 / 3937, 111195.0  # [m]
COLUMNS = {
    "points": "coordinates [m]", "feet": "[us-ft]", "degrees": "[deg]", "rgb8": "colours of 8 bits", "rgb16": "colours of 16 bits",
    "times": "GPS times [s]", "returns": "returns", "classes": "classes", "names": "names",
}  # fmt: skip
SYSTEMS = {  # by column: the system, its units [m], and the steps of the coordinates
    "points": ("EPSG:25832", (1.0, 1.0, 1.0), (1e-4, 1e-4, 1e-4)),
    "feet": ("EPSG:2263", (SURVEY_FOOT,) * 3, (1e-4, 1e-4, 1e-4)),
    "degrees": ("EPSG:4326", (DEGREE, DEGREE, 1.0), (1e-9, 1e-9, 1e-4)),
}


def make():
    """The truth: attributes by their columns."""
    random = np.random.default_rng(7)
    number = random.integers(1, 4, COUNT)
    return {
        "points": np.round(random.uniform(0, 300, (COUNT, 3)) + [476000, 5473000, 110], 4),
        "rgb8": random.integers(0, 256, (COUNT, 3)) / 255,
        "rgb16": random.integers(0, 65536, (COUNT, 3)) / 65535,
        "times": EPOCH + np.sort(random.uniform(0, 3600, COUNT)),
        "returns": np.column_stack([number, number + random.integers(0, 3, COUNT)]),
        "classes": random.integers(1, 12, COUNT),
        "names": NAMES,
    }


def move(truth, column):
    """The truth with coordinates in the system of a column, near their first ones."""
    crs, units, steps = SYSTEMS[column]
    origin = {"points": [476000, 5473000, 110], "feet": [984000, 200000, 0]}
    points = (truth["points"] - origin["points"]) / units + origin.get(column, [8.7, 49.4, 110])
    points = points if column != "points" else truth["points"]
    digits = np.rint(-np.log10(steps)).astype(int)
    points = np.column_stack([np.round(points[:, i], digits[i]) for i in range(3)])
    return truth | {"points": points, "crs": crs, "steps": steps, "units": np.array(units)}


# Written here.


def write(path, truth, colours):
    header = formats.Header()
    header.crs, header.epoch = truth["crs"], EPOCH
    header.part_names = truth["names"]
    header.set_texts(MATERIAL_NAME, truth["names"])
    chunk = {
        "points": truth["points"],
        "RGB": truth[colours].astype(np.float32),
        "GpsTime": truth["times"] - EPOCH,
        "ReturnNumber": truth["returns"][:, 0].astype(np.uint8),
        "NumberOfReturns": truth["returns"][:, 1].astype(np.uint8),
        "ClassificationIds": truth["classes"].astype(np.int32),
        "PartIds": np.arange(COUNT, dtype=np.int32) % 3,
        "MaterialIds": np.arange(COUNT, dtype=np.int32) % 3,
    }
    with formats.open_writer(path, header) as writer:
        writer.write(chunk)


def read_las(path):
    import json

    import laspy

    las = laspy.read(path)
    names = json.loads((path.parent / "a.names.json").read_text())["parts"]
    return {
        "points": np.asarray(las.xyz),
        "rgb": np.column_stack([las.red, las.green, las.blue]) / 65535,
        "times": las.gps_time + 1e9,
        "returns": np.column_stack([las.return_number, las.number_of_returns]),
        "classes": np.asarray(las.classification),
        "names": names,
    }


def read_copc(path):
    import copclib

    import laspy

    points = list(copclib.FileReader(str(path)).GetAllPoints())
    points.sort(key=lambda point: point.gps_time)  # an octree has its own order
    with laspy.CopcReader.open(path) as reader:  # by the octree, too
        times = np.sort(reader.query().gps_time)
    assert np.array_equal(times, [point.gps_time for point in points])
    return {
        "points": np.array([[p.x, p.y, p.z] for p in points]),
        "rgb": np.array([[p.red, p.green, p.blue] for p in points]) / 65535,
        "times": np.array([p.gps_time for p in points]) + 1e9,
        "returns": np.array([[p.return_number, p.number_of_returns] for p in points]),
        "classes": np.array([p.classification for p in points]),
        "names": read_las(path)["names"],
    }


def read_e57(path):
    import pye57

    names = [f"cartesian{axis}" for axis in "XYZ"] + ["colorRed", "colorGreen", "colorBlue"]
    names += ["timeStamp", "returnIndex", "returnCount"]
    with pye57.E57(str(path)) as file:
        header = file.get_header(0)
        data = {name: np.empty(COUNT) for name in names}
        buffers = pye57.libe57.VectorSourceDestBuffer()
        for name, values in data.items():
            buffers.append(pye57.libe57.SourceDestBuffer(
                file.image_file, name, values, COUNT, True, True))  # fmt: skip
        header.points.reader(buffers).read()
        full = header["colorLimits"]["colorRedMaximum"].value()
        start = header["acquisitionStart"]["dateTimeValue"].value()
    values = list(data.values())
    return {
        "points": np.column_stack(values[:3]),
        "rgb": np.column_stack(values[3:6]) / full,
        "times": values[6] + start,
        "returns": np.column_stack([values[7] + 1, values[8]]),
    }


def read_ply(path):
    import plyfile

    rows = plyfile.PlyData.read(str(path))["vertex"]
    return {
        "points": np.column_stack([rows[name] for name in "xyz"]),
        "rgb": np.column_stack([rows[name] for name in ("red", "green", "blue")]) / 255,
        "times": rows["GpsTime"] + EPOCH,
        "returns": np.column_stack([rows["ReturnNumber"], rows["NumberOfReturns"]]),
        "classes": rows["ClassificationIds"],
    }


def read_vtp(path):
    from vtkmodules.util.numpy_support import vtk_to_numpy
    from vtkmodules.vtkIOXML import vtkXMLPolyDataReader

    reader = vtkXMLPolyDataReader()
    reader.SetFileName(str(path))
    reader.Update()
    cloud = reader.GetOutput()
    get = lambda name: vtk_to_numpy(cloud.GetPointData().GetArray(name))  # noqa: E731
    names = cloud.GetFieldData().GetAbstractArray("Part.Name")
    return {
        "points": vtk_to_numpy(cloud.GetPoints().GetData()),
        "rgb": get("RGB"),
        "times": get("GpsTime") + cloud.GetFieldData().GetArray("GpsEpoch").GetTuple1(0),
        "returns": np.column_stack([get("ReturnNumber"), get("NumberOfReturns")]),
        "classes": get("ClassificationIds"),
        "names": [names.GetValue(i) for i in range(names.GetNumberOfValues())],
    }


def read_text(path):
    rows = [line.split() for line in path.read_text().splitlines()]
    numbers = np.array([row[:3] + row[5:7] + row[9:11] for row in rows], float)
    return {
        "points": numbers[:, :3],
        "times": numbers[:, 6] + EPOCH,  # it has no epoch
        "returns": numbers[:, 3:5],
        "classes": numbers[:, 5],
        "names": [rows[i][8] for i in range(3)],
    }


def read_pcd(path):
    """Reads the layout of PCD: rgb packed as PCL does, or three floats."""
    data = path.read_bytes()
    begin = data.index(b"DATA binary\n") + len(b"DATA binary\n")
    head = [line.split() for line in data[:begin].decode().splitlines()]
    rows = {line[0]: line[1:] for line in head}
    origins = [line[3:] for line in head if line[:3] == ["#", "vtkHelios", "origin:"]]
    origin = origins[0] if origins else [0, 0, 0]  # floats only
    kinds = zip(rows["FIELDS"], rows["TYPE"], rows["SIZE"], map(int, rows["COUNT"]))
    dtype = [(name, f"({count},){kind.lower()}{size}") for name, kind, size, count in kinds]
    table = np.frombuffer(data, np.dtype(dtype), COUNT, begin)
    xyz = np.column_stack([table[name] for name in "xyz"]).astype(float)
    classes = "label" if "label" in table.dtype.names else "ClassificationIds"
    if "rgb" in table.dtype.names:
        packed = table["rgb"].view(np.uint32).ravel()
        rgb = np.column_stack([packed >> shift & 255 for shift in (16, 8, 0)]) / 255
    else:
        rgb = table["RGB"]
    return {
        "points": xyz + np.array(origin, float),
        "rgb": rgb,
        "times": table["GpsTime"].ravel() + EPOCH,
        "returns": np.column_stack([table["ReturnNumber"], table["NumberOfReturns"]]),
        "classes": table[classes].ravel(),
    }


# Reader of another program by ending, and its name.
READERS = {
    "las": (read_las, "laspy"),
    "laz": (read_las, "laspy, lazrs"),
    "copc.laz": (read_copc, "copclib, laspy"),
    "e57": (read_e57, "pye57"),
    "ply": (read_ply, "plyfile"),
    "pcd": (read_pcd, "numpy"),
    "vtp": (read_vtp, "VTK"),
    "xyz": (read_text, "text"),
}


# Written by other programs.


def write_las(path, truth, colours):
    """LAS 1.2 with colours of 8 bits as they are, as many programs write them, else LAS 1.4."""
    import laspy

    short = colours == "rgb8"
    header = laspy.LasHeader(version="1.2" if short else "1.4", point_format=3 if short else 7)
    header.scales, header.offsets = truth["steps"], np.rint(truth["points"][0])
    header.global_encoding.gps_time_type = laspy.header.GpsTimeType.STANDARD
    las = laspy.LasData(header)
    las.xyz = truth["points"]
    full = 255 if short else 65535
    las.red, las.green, las.blue = np.rint(truth[colours].T * full).astype(np.uint16)
    las.gps_time = truth["times"] - 1e9
    las.return_number, las.number_of_returns = truth["returns"].T.astype(np.uint8)
    las.classification = truth["classes"].astype(np.uint8)
    las.write(path)


def write_e57(path, truth, colours):
    import pye57

    libe57, full = pye57.libe57, 255 if colours == "rgb8" else 65535
    fields = {f"cartesian{axis}": truth["points"][:, i] for i, axis in enumerate("XYZ")}
    fields["timeStamp"] = truth["times"] - EPOCH
    whole = {f"color{name}": np.rint(truth[colours][:, i] * full)
             for i, name in enumerate(("Red", "Green", "Blue"))}  # fmt: skip
    whole["returnIndex"], whole["returnCount"] = (
        truth["returns"][:, 0] - 1.0,
        truth["returns"][:, 1],
    )
    with pye57.E57(str(path), "w") as file:
        image, prototype = file.image_file, libe57.StructureNode(file.image_file)
        buffers, held = libe57.VectorSourceDestBuffer(), []
        for name, values in {**fields, **whole}.items():
            held.append(np.array(values, float))
            node = (libe57.FloatNode(image, 0.0, libe57.E57_DOUBLE) if name in fields
                    else libe57.IntegerNode(image, 0, 0, full))  # fmt: skip
            prototype.set(name, node)
            buffers.append(libe57.SourceDestBuffer(image, name, held[-1], COUNT, True, True))
        scan, start = libe57.StructureNode(image), libe57.StructureNode(image)
        start.set("dateTimeValue", libe57.FloatNode(image, EPOCH))
        scan.set("guid", libe57.StringNode(image, "{1}"))
        scan.set("acquisitionStart", start)
        points = libe57.CompressedVectorNode(image, prototype, libe57.VectorNode(image, True))
        scan.set("points", points)
        file.data3d.append(scan)
        writer = points.writer(buffers)
        writer.write(COUNT)
        writer.close()


def write_ply(path, truth, colours):
    import plyfile

    kind, full = ("u1", 255) if colours == "rgb8" else ("u2", 65535)
    rows = np.empty(COUNT, [(name, "f8") for name in "xyz"]
                    + [(name, kind) for name in ("red", "green", "blue")])  # fmt: skip
    for i, (axis, name) in enumerate(zip("xyz", ("red", "green", "blue"))):
        rows[axis], rows[name] = truth["points"][:, i], np.rint(truth[colours][:, i] * full)
    plyfile.PlyData([plyfile.PlyElement.describe(rows, "vertex")]).write(str(path))


def write_vtp(path, truth, colours):
    from vtkmodules.util.numpy_support import numpy_to_vtk
    from vtkmodules.vtkCommonCore import vtkPoints
    from vtkmodules.vtkCommonDataModel import vtkPolyData
    from vtkmodules.vtkIOXML import vtkXMLPolyDataWriter

    cloud, points = vtkPolyData(), vtkPoints()
    points.SetData(numpy_to_vtk(truth["points"], deep=True))
    cloud.SetPoints(points)
    columns = {"RGB": truth[colours], "GpsTime": truth["times"], "ClassificationIds": truth["classes"],
               "ReturnNumber": truth["returns"][:, 0], "NumberOfReturns": truth["returns"][:, 1]}  # fmt: skip
    for name, values in columns.items():
        array = numpy_to_vtk(np.ascontiguousarray(values), deep=True)
        array.SetName(name)
        cloud.GetPointData().AddArray(array)
    writer = vtkXMLPolyDataWriter()
    writer.SetFileName(str(path))
    writer.SetInputData(cloud)
    writer.Write()


def write_text(path, truth, colours):
    np.savetxt(path, truth["points"], fmt="%.9f")


WRITERS = {
    "las": (write_las, "laspy"),
    "laz": (write_las, "laspy, lazrs"),
    "e57": (write_e57, "pye57"),
    "ply": (write_ply, "plyfile"),
    "vtp": (write_vtp, "VTK"),
    "xyz": (write_text, "numpy"),
}


def read(path):
    with formats.open_reader(path) as reader:
        chunks = list(reader.chunks())
    chunk = {name: np.concatenate([each[name] for each in chunks]) for name in chunks[0]}
    found = {"points": chunk["points"], "names": reader.header.part_names or None}
    if "RGB" in chunk:
        rgb = chunk["RGB"]
        found["rgb"] = rgb / np.iinfo(rgb.dtype).max if rgb.dtype.kind in "iu" else rgb
    if "GpsTime" in chunk:
        found["times"] = chunk["GpsTime"] + reader.header.epoch
    if "ReturnNumber" in chunk and "NumberOfReturns" in chunk:
        found["returns"] = np.column_stack([chunk["ReturnNumber"], chunk["NumberOfReturns"]])
    found["classes"] = chunk.get("ClassificationIds")
    return found


# The tables.


def classify(column, truth, found):
    """A cell: exact, the largest error, or a dash."""
    if column in SYSTEMS:
        return classify_points(truth, found["points"])
    values = found.get("rgb" if column.startswith("rgb") else column)
    if values is None:
        return "–"
    if column == "names":
        return "yes" if list(values) == truth[column] else "wrong"
    error = float(np.abs(np.asarray(values, float) - truth[column]).max())
    if column.startswith("rgb"):
        return "exact" if error < 1e-6 else "8 bits" if error < 0.5 / 255 + 1e-6 else "wrong"
    limits = {"times": 5e-7}  # limits of double precision
    if error <= limits.get(column, 0.0):
        return "exact"
    return f"{error:.0e}" if column in limits and error < 1 else "wrong"


def classify_points(truth, points):
    """The largest error [m]; metres of feet are told."""
    is_metric = np.allclose(points, truth["points"] * truth["units"], atol=0.01)
    if truth["crs"] == SYSTEMS["feet"][0] and is_metric:
        return "as metres"
    error = float((np.abs(points - truth["points"]) * truth["units"]).max())
    return "exact" if error < 1e-6 else f"{error:.0e}" if error < 1 else "wrong"


def convert_one(ending, program, truth, colours, convert):
    """Returns the contents of a converted file, or None if it is refused."""
    with tempfile.TemporaryDirectory() as folder:
        try:
            return convert(pathlib.Path(folder) / f"a.{ending}", program, truth, colours)
        except formats.FormatError:
            return None


def make_rows(programs, convert):
    """A row per format: its cells by column, of two files with unlike colours."""
    truth = make()
    for ending, (program, name) in programs.items():
        cells = {}
        metres = move(truth, "points")
        for colours in ("rgb8", "rgb16"):
            found = convert_one(ending, program, metres, colours, convert)
            columns = [colours] if cells else [each for each in COLUMNS if each != "rgb16"]
            cells |= {each: classify(each, metres, found) for each in columns}
        for column in ("feet", "degrees"):
            moved = move(truth, column)
            found = convert_one(ending, program, moved, "rgb8", convert)
            cells[column] = "refused" if found is None else classify(column, moved, found)
        yield [f"`.{ending}`", name, *(cells[column] for column in COLUMNS)]


def write_here(path, reader, truth, colours):
    write(path, truth, colours)
    return reader(path)


def write_there(path, writer, truth, colours):
    writer(path, truth, colours)
    return read(path)


def make_text():
    """Both tables, as Markdown."""
    lines = [BEGIN, ""]
    for words, programs, convert in (
        ("Written by vtkHelios, read by another program:", READERS, write_here),
        ("Written by another program, read by vtkHelios:", WRITERS, write_there),
    ):
        lines += [words, "", "| format | program | " + " | ".join(COLUMNS.values()) + " |"]
        lines += ["|---" * (2 + len(COLUMNS)) + "|"]
        lines += ["| " + " | ".join(row) + " |" for row in make_rows(programs, convert)]
        lines.append("")
    return "\n".join([*lines, END])


def main():
    text = make_text()
    if "--write" not in sys.argv:
        print(text)
        return
    document = DOCUMENT.read_text(encoding="utf-8")
    start, end = document.index(BEGIN), document.index(END) + len(END)
    DOCUMENT.write_text(document[:start] + text + document[end:], encoding="utf-8")


if __name__ == "__main__":
    main()
