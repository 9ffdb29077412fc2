# SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
# SPDX-License-Identifier: BSD-3-Clause
"""E57 by pye57: a scan per leg or file, in scanner coordinates, with its pose."""

import dataclasses
import pathlib
import uuid

import numpy as np

from ..array_names import (
    AMPLITUDE, GPS_TIME, INTENSITY, NUMBER_OF_RETURNS, PULSE_IDS, RETURN_NUMBER, RGB,
)  # fmt: skip
from ..core.classes import version
from ..core.systems import Metres
from ._base import ROWS, FileWriter, need, rows_of

from ._e57_fields import (
    COLOURS, DIRECTION_ONLY, EXTENSION, EXTENSION_URI, FULL, NAME_NODES, OTHERS, OURS, TREES, XYZ,
    rotation_matrix,
)  # fmt: skip
from ._grid import find_grid

STANDARD = ("points", AMPLITUDE, INTENSITY, RETURN_NUMBER, NUMBER_OF_RETURNS, GPS_TIME, RGB)
EIGHT_BITS = 1e-3  # maximum difference of colours of 8 bits from whole numbers
RETURNS = (RETURN_NUMBER, NUMBER_OF_RETURNS)
LONG = np.dtype("q")  # 64 bits for pye57, which treats numpy's int64 as 32 bits


class E57Writer(FileWriter):
    def __init__(self, path, header):
        super().__init__(path, header)
        self._libe57 = need("pye57", "E57 files").libe57
        self._image = None  # image of libE57Format
        self._writer = None  # writer of the points of a scan
        self._rows = 0  # capacity of the buffers
        self._metres = Metres(header.crs)  # the unit of all E57 files
        if self._metres.note:
            self.notes.append(f"{self.path}: {self._metres.note}, as E57 stores them")

    def begin(self, scan):
        self._try(self._end_scan)
        place = np.asarray(scan.translation, float)
        self.scan = dataclasses.replace(scan, translation=tuple(self._metres.convert(place)))

    def store(self, chunk):
        self._try(lambda: self._write(chunk))

    def _try(self, action):
        """Errors of libE57Format, including a full disk, name the file."""
        try:
            action()
        except self._libe57.E57Exception as error:
            words = str(error).strip().splitlines()[0]
            self.fail(f"cannot be written: {words}; free space on its disk")

    def _write(self, chunk):
        if rows_of(chunk) and (problem := self._metres.refuse_degrees(chunk["points"][0])):
            self.fail(f"E57 stores metres: {problem}")
        chunk = {**chunk, "points": self._metres.convert(chunk["points"])}
        if self._image is None:
            self._open(not TREES.keys().isdisjoint(chunk))
        for name in chunk:
            if name not in STANDARD and name not in TREES:
                self.lost[name] = "E57 has no field for it"
        if AMPLITUDE in chunk and INTENSITY in chunk:
            self.lost[INTENSITY] = "the amplitude is the intensity"
        for name, other in (RETURNS, RETURNS[::-1]):
            if name in chunk and other not in chunk:
                self.lost[name] = f"E57 stores it together with {other}"
        if self._writer is None:
            self._begin_scan(chunk)
        for begin in range(0, rows_of(chunk), ROWS):
            part = {name: values[begin : begin + ROWS] for name, values in chunk.items()}
            self._put(self._fields(part))
        self.count += rows_of(chunk)

    def _open(self, has_trees):
        self.open_part()  # checks that it is writable
        self.file.close()
        libe57 = self._libe57
        self._image = image = libe57.ImageFile(self.part, "w")
        image.extensionsAdd("", libe57.E57_V1_0_URI)
        root = image.root()
        if has_trees:
            image.extensionsAdd(EXTENSION, EXTENSION_URI)
            self._add_names(root)
        root.set("formatName", libe57.StringNode(image, "ASTM E57 3D Imaging Data File"))
        root.set("guid", libe57.StringNode(image, f"{{{uuid.uuid4()}}}"))
        root.set("versionMajor", libe57.IntegerNode(image, libe57.E57_FORMAT_MAJOR))
        root.set("versionMinor", libe57.IntegerNode(image, libe57.E57_FORMAT_MINOR))
        root.set("e57LibraryVersion", libe57.StringNode(image, libe57.E57_LIBRARY_ID))
        root.set("coordinateMetadata", libe57.StringNode(image, self.header.crs))
        self._scans = libe57.VectorNode(image, True)
        root.set("data3D", self._scans)
        root.set("images2D", libe57.VectorNode(image, True))

    def _add_names(self, root):
        """Adds the names of species and organs, as vectors of texts."""
        for name, node in NAME_NODES.items():
            vector = self._libe57.VectorNode(self._image, True)
            root.set(node, vector)
            for text in self.header.texts(name):
                vector.append(self._libe57.StringNode(self._image, text))

    def _begin_scan(self, chunk):
        scan = self.scan
        self._is_amplitude = AMPLITUDE in chunk
        self._turn = rotation_matrix(scan.rotation)
        self._move = np.asarray(scan.translation, float)
        self._pulses = find_grid(scan.pulses(), self._turn) if scan.pulses else None
        self._bounds = {}  # bounds of fields: lowest, highest
        self._are_short = True
        fields = self._fields(chunk)
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
        if name in TREES.values():
            return libe57.IntegerNode(image, 0, -1, 2**31 - 1)
        highest = {"cartesianInvalidState": 2, "rowIndex": 2**32 - 1, "columnIndex": 2**32 - 1}
        highest = highest.get(name, np.iinfo(values.dtype).max)
        return libe57.IntegerNode(image, 0, 0, int(highest))

    def _fields(self, chunk):
        local = (chunk["points"] - self._move) @ self._turn
        fields = {name: np.ascontiguousarray(local[:, i]) for i, name in enumerate(XYZ)}
        if AMPLITUDE in chunk or INTENSITY in chunk:
            values = chunk.get(AMPLITUDE, chunk.get(INTENSITY))
            is_number = AMPLITUDE in chunk or values.dtype not in (np.uint8, np.uint16)
            fields["intensity"] = values.astype(np.float64 if is_number else np.uint16)
        if RETURN_NUMBER in chunk and NUMBER_OF_RETURNS in chunk:
            number = chunk[RETURN_NUMBER].astype(np.int32)
            fields["returnIndex"] = np.maximum(number - 1, 0).astype(np.uint8)
            fields["returnCount"] = chunk[NUMBER_OF_RETURNS].astype(np.uint8)
        if GPS_TIME in chunk:
            fields["timeStamp"] = chunk[GPS_TIME].astype(np.float64)
        if RGB in chunk:
            colours = self._scale_colours(chunk[RGB])
            fields |= {name: colours[:, i] for i, name in enumerate(COLOURS)}
        for name, field in TREES.items():
            if name in chunk:
                fields[field] = chunk[name].astype(np.int64)
        if self._pulses is not None and PULSE_IDS in chunk:
            fields |= self._pulses.place(chunk[PULSE_IDS])
            fields["cartesianInvalidState"] = np.zeros(rows_of(chunk), np.uint8)
            self._pulses.note(chunk[PULSE_IDS])
        return fields

    def _scale_colours(self, rgb):
        """Scales colours to 8 bits if the first chunk of a scan has 8 bits, else to 16."""
        full = np.iinfo(rgb.dtype).max if rgb.dtype.kind in "iu" else 1.0
        unit = np.clip(rgb / full, 0.0, 1.0)
        if self._are_short:
            short = np.rint(unit * 255)
            if np.abs(unit * 255 - short).max(initial=0.0) < EIGHT_BITS:
                return short.astype(np.uint8)
            self._are_short = self._writer is not None
            if self._are_short:
                self.lost["RGB of 16 bits"] = "colours at the beginning of the scan have 8"
                return short.astype(np.uint8)
        note = "colours are stored in 16 bits, which read_scan() of pye57 does not read"
        if f"{self.path}: {note}" not in self.notes:
            self.notes.append(f"{self.path}: {note}")
        return np.rint(unit * FULL).astype(np.uint16)

    def _put(self, fields):
        count = len(fields["cartesianX"])
        valid = fields.get("cartesianInvalidState", np.zeros(count, np.uint8)) == 0
        for name, values in fields.items():
            self._buffers[name][:count] = values
            seen = values[valid] if name in XYZ or name == "intensity" else values
            if len(seen):
                low, high = self._bounds.get(name, (np.inf, -np.inf))
                self._bounds[name] = np.fmin(low, np.fmin.reduce(seen)), np.fmax(
                    high, np.fmax.reduce(seen)
                )
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
        words = f"{OURS if self._is_amplitude else OTHERS} ({version()})"
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
        """Returns a structure of floats."""
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
        if "intensity" in bounds and self._is_amplitude:
            low, high = bounds["intensity"]
            limits = {"intensityMinimum": low, "intensityMaximum": high}
            self._node.set("intensityLimits", self._structure(limits))
        elif self._buffers.get("intensity", np.empty(0)).dtype == np.uint16:
            self._set_limits("intensityLimits", ["intensity"], int(FULL))
        if COLOURS[0] in self._buffers:
            full = int(np.iinfo(self._buffers[COLOURS[0]].dtype).max)
            self._set_limits("colorLimits", COLOURS, full)
        self._set_index_bounds(bounds)

    def _set_limits(self, name, fields, full):
        """Limits of fields of whole numbers from 0."""
        image, node = self._image, self._structure()
        for field in fields:
            for end, value in (("Minimum", 0), ("Maximum", full)):
                node.set(f"{field}{end}", self._libe57.IntegerNode(image, value, 0, full))
        self._node.set(name, node)

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
