# SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
# SPDX-License-Identifier: BSD-3-Clause
"""E57 by pye57: a scan per leg or file, in scanner coordinates, with its pose."""

import pathlib
import uuid

import numpy as np

import vtkhelios

from ..array_names import (
    AMPLITUDE, GPS_TIME, INTENSITY, NUMBER_OF_RETURNS, PULSE_IDS, RETURN_NUMBER, RGB,
)  # fmt: skip
from ._base import ROWS, FileWriter, Reader, Scan, need, rows_of
from ._grid import find_grid

OURS = "vtkHelios, intensity: amplitude [W]"  # prefix of a scan's description
STANDARD = ("points", AMPLITUDE, INTENSITY, RETURN_NUMBER, NUMBER_OF_RETURNS, GPS_TIME, RGB)
XYZ = ("cartesianX", "cartesianY", "cartesianZ")
POLAR = ("sphericalRange", "sphericalAzimuth", "sphericalElevation")
COLOURS = ("colorRed", "colorGreen", "colorBlue")
LONG = np.dtype("q")  # 64 bits for pye57, which treats numpy's int64 as 32 bits
DIRECTION_ONLY = 1  # of cartesianInvalidState: x y z is the pulse direction


def rotation_matrix(quaternion):
    """Of a unit quaternion w x y z."""
    w, x, y, z = quaternion
    return np.array(
        [
            [1 - 2 * (y * y + z * z), 2 * (x * y - w * z), 2 * (x * z + w * y)],
            [2 * (x * y + w * z), 1 - 2 * (x * x + z * z), 2 * (y * z - w * x)],
            [2 * (x * z - w * y), 2 * (y * z + w * x), 1 - 2 * (x * x + y * y)],
        ]
    )


def _first_line(error):
    """The message of libE57Format, without source locations."""
    return (str(error).strip().splitlines() or [type(error).__name__])[0]


class E57Reader(Reader):
    def __init__(self, path):
        super().__init__(path)
        self._pye57 = need("pye57", "E57 files")
        try:
            self._file = self._pye57.E57(self.path)
            headers = [self._file.get_header(i) for i in range(self._file.scan_count)]
            self.header.crs = self._text(self._file.root, "coordinateMetadata")
        except Exception as error:  # of libE57Format, whose type varies between releases
            self.fail(f"is not an E57 file, or is damaged: {_first_line(error)}; copy it again")
        self.count = sum(header.point_count for header in headers)
        self.kind = f"E57, {len(headers)} scan{'s'[: len(headers) != 1]}"
        if self.count == 0:
            self.fail("has no points; give a file with points")
        self.scans = [self._scan(header, i) for i, header in enumerate(headers)]
        self._headers = headers
        start = headers[0].node
        self._is_ours = self._text(start, "description").startswith(OURS)
        if start.isDefined("acquisitionStart"):
            self.header.epoch = start["acquisitionStart"]["dateTimeValue"].value()
        self.skipped = 0

    def _text(self, node, name):
        return node[name].value() if node.isDefined(name) else ""

    def _scan(self, header, index):
        name = self._text(header.node, "name") or f"scan{index:03}"
        if not header.has_pose():
            return Scan(name)
        pose = header.node["pose"]
        turn = tuple(header.rotation) if pose.isDefined("rotation") else (1.0, 0.0, 0.0, 0.0)
        move = tuple(header.translation) if pose.isDefined("translation") else (0.0, 0.0, 0.0)
        return Scan(name, move, turn, True)

    def read_chunks(self, rows):
        for self.scan, header in enumerate(self._headers):
            yield from self._chunks_of(header, rows)
        if self.skipped:
            self.notes.append(
                f"{self.path}: {self.skipped:,} points are marked as invalid (pulses without an "
                "echo); they are dropped"
            )

    def _chunks_of(self, header, rows):
        libe57 = self._pye57.libe57
        fields = set(header.point_fields)
        known = {*XYZ, *POLAR, *COLOURS, "intensity", "timeStamp", "returnIndex", "returnCount"}
        known |= {"cartesianInvalidState", "sphericalInvalidState"}
        if not (fields.issuperset(XYZ) or fields.issuperset(POLAR)):
            self.fail("has a scan without coordinates; leave that scan out")
        data = {name: np.empty(rows) for name in known & fields}
        buffers = libe57.VectorSourceDestBuffer()
        for name, values in data.items():
            buffers.append(libe57.SourceDestBuffer(
                self._file.image_file, name, values, rows, True, True))  # fmt: skip
        try:
            reader = header.points.reader(buffers)
            while count := reader.read():
                yield self._to_chunk({name: v[:count].copy() for name, v in data.items()}, header)
            reader.close()
        except self._pye57.libe57.E57Exception as error:
            self.fail(
                f"its points cannot be read: {_first_line(error)}; it is damaged, copy it again"
            )

    def _to_chunk(self, data, header):
        state = data.get("cartesianInvalidState", data.get("sphericalInvalidState"))
        if state is not None:
            valid = state == 0
            self.skipped += int(np.count_nonzero(~valid))
            data = {name: values[valid] for name, values in data.items()}
        chunk = {"points": self._place(data)}
        if "timeStamp" in data:
            chunk[GPS_TIME] = data["timeStamp"]
        if "returnIndex" in data:
            chunk[RETURN_NUMBER] = (data["returnIndex"] + 1).astype(np.uint8)
        if "returnCount" in data:
            chunk[NUMBER_OF_RETURNS] = data["returnCount"].astype(np.uint8)
        if "intensity" in data:
            self._add_intensity(chunk, data["intensity"], header)
        if all(name in data for name in COLOURS):
            colours = np.column_stack([data[name] for name in COLOURS])
            chunk[RGB] = (colours / 255.0).astype(np.float32)
        return chunk

    def _place(self, data):
        """World coordinates; values that are not finite stay so."""
        with np.errstate(invalid="ignore", over="ignore"):
            return self._move_to_world(data)

    def _move_to_world(self, data):
        if all(name in data for name in XYZ):
            xyz = np.column_stack([data[name] for name in XYZ])
        else:
            r, azimuth, elevation = (data[name] for name in POLAR)
            flat = r * np.cos(elevation)
            xyz = np.column_stack(
                [flat * np.cos(azimuth), flat * np.sin(azimuth), r * np.sin(elevation)]
            )
        scan = self.scans[self.scan]
        if scan.has_pose:
            xyz = xyz @ rotation_matrix(scan.rotation).T + np.asarray(scan.translation)
        return xyz

    def _add_intensity(self, chunk, values, header):
        if self._is_ours:
            chunk[AMPLITUDE] = values
            return
        low, high = 0.0, 65535.0
        if header.node.isDefined("intensityLimits"):
            limits = header.node["intensityLimits"]
            low, high = (limits[f"intensity{end}"].value() for end in ("Minimum", "Maximum"))
        with np.errstate(invalid="ignore", over="ignore"):
            scaled = (values - low) * (65535.0 / (high - low) if high > low else 0.0)
        finite = np.isfinite(scaled)
        if not finite.all():
            count = np.count_nonzero(~finite)
            self.notes.append(f"{self.path}: {count:,} intensities are not finite: read as 0")
            scaled = np.where(finite, scaled, 0.0)
        chunk[INTENSITY] = np.clip(np.rint(scaled), 0, 65535).astype(np.uint16)

    def close(self):
        self._file.close()


class E57Writer(FileWriter):
    def __init__(self, path, header):
        super().__init__(path, header)
        self._libe57 = need("pye57", "E57 files").libe57
        self._image = None  # of libE57Format
        self._writer = None  # of the points of a scan
        self._rows = 0  # capacity of the buffers

    def begin(self, scan):
        self._try(self._end_scan)
        self.scan = scan

    def put(self, chunk):
        self._try(lambda: self._write(chunk))

    def _try(self, action):
        """Errors of libE57Format, including a full disk, name the file."""
        try:
            action()
        except self._libe57.E57Exception as error:
            words = str(error).strip().splitlines()[0]
            self.fail(f"cannot be written: {words}; free space on its disk")

    def _write(self, chunk):
        if self._image is None:
            self._open()
        for name in chunk:
            if name not in STANDARD:
                self.lost[name] = "E57 has no field for it"
        if AMPLITUDE in chunk and INTENSITY in chunk:
            self.lost[INTENSITY] = "the amplitude is the intensity"
        if self._writer is None:
            self._begin_scan(chunk)
        for begin in range(0, rows_of(chunk), ROWS):
            part = {name: values[begin : begin + ROWS] for name, values in chunk.items()}
            self._put(self._fields(part))
        self.count += rows_of(chunk)

    def _open(self):
        self.open_part()  # checks that it is writable
        self.file.close()
        libe57 = self._libe57
        self._image = image = libe57.ImageFile(self.part, "w")
        image.extensionsAdd("", libe57.E57_V1_0_URI)
        root = image.root()
        root.set("formatName", libe57.StringNode(image, "ASTM E57 3D Imaging Data File"))
        root.set("guid", libe57.StringNode(image, f"{{{uuid.uuid4()}}}"))
        root.set("versionMajor", libe57.IntegerNode(image, libe57.E57_FORMAT_MAJOR))
        root.set("versionMinor", libe57.IntegerNode(image, libe57.E57_FORMAT_MINOR))
        root.set("e57LibraryVersion", libe57.StringNode(image, libe57.E57_LIBRARY_ID))
        root.set("coordinateMetadata", libe57.StringNode(image, self.header.crs))
        self._scans = libe57.VectorNode(image, True)
        root.set("data3D", self._scans)
        root.set("images2D", libe57.VectorNode(image, True))

    def _begin_scan(self, chunk):
        scan = self.scan
        self._turn = rotation_matrix(scan.rotation)
        self._move = np.asarray(scan.translation, float)
        self._pulses = find_grid(scan.pulses(), self._turn) if scan.pulses else None
        self._bounds = {}  # of fields: lowest, highest
        fields = self._fields({name: values[:1] for name, values in chunk.items()})
        self._node = self._make_scan(scan)
        image, libe57 = self._image, self._libe57
        prototype = libe57.StructureNode(image)
        self._buffers, vector = {}, libe57.VectorSourceDestBuffer()
        for name, values in fields.items():
            prototype.set(name, self._prototype(name, values))
            kind = LONG if values.dtype == np.int64 else values.dtype
            self._buffers[name] = np.empty(ROWS, kind)
            vector.append(
                libe57.SourceDestBuffer(image, name, self._buffers[name], ROWS, True, True)
            )
        codecs = libe57.VectorNode(image, True)
        points = libe57.CompressedVectorNode(image, prototype, codecs)
        self._node.set("points", points)
        self._scans.append(self._node)
        self._bounds = {}
        self._writer = points.writer(vector)

    def _prototype(self, name, values):
        libe57, image = self._libe57, self._image
        if values.dtype.kind == "f":
            return libe57.FloatNode(image, 0.0, libe57.E57_DOUBLE)
        highest = {"cartesianInvalidState": 2, "rowIndex": 2**32 - 1, "columnIndex": 2**32 - 1}
        highest = highest.get(name, np.iinfo(values.dtype).max)
        return libe57.IntegerNode(image, 0, 0, int(highest))

    def _fields(self, chunk):
        local = (chunk["points"] - self._move) @ self._turn
        fields = {name: np.ascontiguousarray(local[:, i]) for i, name in enumerate(XYZ)}
        if AMPLITUDE in chunk or INTENSITY in chunk:
            values = chunk.get(AMPLITUDE, chunk.get(INTENSITY))
            fields["intensity"] = values.astype(np.float64)
        if RETURN_NUMBER in chunk and NUMBER_OF_RETURNS in chunk:
            number = chunk[RETURN_NUMBER].astype(np.int32)
            fields["returnIndex"] = np.maximum(number - 1, 0).astype(np.uint8)
            fields["returnCount"] = chunk[NUMBER_OF_RETURNS].astype(np.uint8)
        if GPS_TIME in chunk:
            fields["timeStamp"] = chunk[GPS_TIME].astype(np.float64)
        if RGB in chunk:
            colours = np.rint(np.clip(chunk[RGB], 0, 1) * 255).astype(np.uint8)
            fields |= {name: colours[:, i] for i, name in enumerate(COLOURS)}
        if self._pulses is not None and PULSE_IDS in chunk:
            fields |= self._pulses.place(chunk[PULSE_IDS])
            fields["cartesianInvalidState"] = np.zeros(rows_of(chunk), np.uint8)
            self._pulses.note(chunk[PULSE_IDS])
        return fields

    def _put(self, fields):
        count = len(fields["cartesianX"])
        valid = fields.get("cartesianInvalidState", np.zeros(count, np.uint8)) == 0
        for name, values in fields.items():
            self._buffers[name][:count] = values
            seen = values[valid] if name in XYZ or name == "intensity" else values
            if len(seen):
                low, high = self._bounds.get(name, (np.inf, -np.inf))
                self._bounds[name] = min(low, seen.min()), max(high, seen.max())
        if count:
            self._writer.write(count)

    def _put_misses(self):
        """Writes pulses without echoes, as directions."""
        for miss in self._pulses.misses(self.scan.pulses(), self._turn, ROWS):
            count = len(miss["cartesianX"])
            fields = {
                name: miss.get(name, np.zeros(count, buffer.dtype))
                for name, buffer in self._buffers.items()
            }
            fields["cartesianInvalidState"] = np.full(count, DIRECTION_ONLY, np.uint8)
            self._put(fields)

    def _make_scan(self, scan):
        node = self._structure()
        libe57, image = self._libe57, self._image
        node.set("guid", libe57.StringNode(image, f"{{{uuid.uuid4()}}}"))
        node.set("name", libe57.StringNode(image, scan.name))
        words = f"{OURS} ({vtkhelios.__version__})"
        node.set("description", libe57.StringNode(image, words))
        pose = self._structure()
        node.set("pose", pose)
        pose.set("rotation", self._structure(dict(zip("wxyz", scan.rotation))))
        pose.set("translation", self._structure(dict(zip("xyz", scan.translation))))
        start = self._structure({"dateTimeValue": self.header.epoch})
        start.set("isAtomicClockReferenced", libe57.IntegerNode(image, 0))
        node.set("acquisitionStart", start)
        return node

    def _structure(self, numbers=()):
        """A structure of floats."""
        image = self._image
        node = self._libe57.StructureNode(image)
        for name, value in dict(numbers).items():
            node.set(name, self._libe57.FloatNode(image, float(value)))
        return node

    def _end_scan(self):
        if self._writer is None:
            return
        if self._pulses is not None and "cartesianInvalidState" in self._buffers:
            self._put_misses()
        self._writer.close()
        self._writer = None
        bounds = self._bounds
        box = {}
        for name in XYZ:
            low, high = bounds[name]
            box |= {f"{name[-1].lower()}Minimum": low, f"{name[-1].lower()}Maximum": high}
        self._node.set("cartesianBounds", self._structure(box))
        if "intensity" in bounds:
            low, high = bounds["intensity"]
            limits = {"intensityMinimum": low, "intensityMaximum": high}
            self._node.set("intensityLimits", self._structure(limits))
        self._set_index_bounds(bounds)

    def _set_index_bounds(self, bounds):
        image, node = self._image, self._structure()
        for name, field in (
            ("row", "rowIndex"),
            ("column", "columnIndex"),
            ("return", "returnIndex"),
        ):
            for end, value in zip(("Minimum", "Maximum"), bounds.get(field, ())):
                node.set(f"{name}{end}", self._libe57.IntegerNode(image, int(value)))
        if node.childCount():
            self._node.set("indexBounds", node)

    def close(self):
        if not self.count:
            self.abandon()
            self.fail("would have no points; change the selection")
        self._try(self._end_scan)
        self._try(self._image.close)
        self.keep_part()

    def abandon(self):
        if self._image is not None:
            self._image.cancel()
        pathlib.Path(self.part).unlink(missing_ok=True)
