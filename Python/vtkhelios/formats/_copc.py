# SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
# SPDX-License-Identifier: BSD-3-Clause
"""COPC: a LAZ file in octree order, by copclib.

A node of the octree has one point per cell of a grid of 128 x 128 x 128, or all if there are few;
the rest goes to its children. Points are sorted by the Morton codes of their positions, so that a
node is a range of them; they are stored in a scratch file meanwhile.
"""

import os
import pathlib
import struct
import tempfile

import numpy as np

from ._base import FileWriter, need
from ._las import Encoder, LasReader
from ._names import check_names, write_names
from ._records import RecordWriter

LEVELS = 21  # bits of a Morton code per direction
GRID = 7  # bits of a node's grid
FEW = 20_000  # points that are not divided further


INFO = 375 + 54  # offset of the record that locates the octree
TIMES = 56  # offset in it of the range of GPS times
# entry of a page: key, offset, bytes, points; -1 points: another page
ENTRY = struct.Struct("<4iQii")


class CopcReader(LasReader):
    """Read as LAZ; the octree is checked and not used."""

    def __init__(self, path):
        super().__init__(path)
        self.kind = self.kind.replace("LAZ", "COPC, LAZ")
        if problem := self._find_wrong_octree():
            self.notes.append(
                f"{path}: its octree is damaged: {problem}; all points are read without it; "
                "convert the file to make a new one"
            )

    def _find_wrong_octree(self):
        """Returns the error in the pages of the octree, or None."""
        size, count = os.path.getsize(self.path), 0
        with open(self.path, "rb") as file:
            file.seek(INFO + 40)
            pages, seen = [struct.unpack("<QQ", file.read(16))], set()
            while pages:
                place, length = pages.pop()
                if place in seen or length % ENTRY.size or place + length > size:
                    return f"a page of {length} bytes at byte {place} of {size}"
                seen.add(place)
                file.seek(place)
                for *_, place, length, points in ENTRY.iter_unpack(file.read(length)):
                    if points < -1 or length < 0 or (points and place + length > size):
                        return f"a node of {points} points in {length} bytes at byte {place}"
                    if points == -1:
                        pages.append((place, length))
                    count += max(points, 0)
        return None if count == self.count else f"it has {count} of {self.count} points"


def spread(values):
    """Inserts two zeros between the bits of integers below 2^21."""
    x = values.astype(np.uint64)
    for shift, mask in (
        (32, 0x1F00000000FFFF),
        (16, 0x1F0000FF0000FF),
        (8, 0x100F00F00F00F00F),
        (4, 0x10C30C30C30C30C3),
        (2, 0x1249249249249249),
    ):
        x = (x | (x << np.uint64(shift))) & np.uint64(mask)
    return x


def gather(code):
    """Returns the inverse of spread."""
    x = int(code) & 0x1249249249249249
    for shift, mask in (
        (2, 0x10C30C30C30C30C3),
        (4, 0x100F00F00F00F00F),
        (8, 0x1F0000FF0000FF),
        (16, 0x1F00000000FFFF),
        (32, 0x1FFFFF),
    ):
        x = (x | (x >> shift)) & mask
    return x


def nodes_of(codes, few=FEW):
    """Yields the nodes of an octree over sorted Morton codes: level, code, positions."""
    left = np.arange(len(codes))
    for level in range(LEVELS - GRID + 1):
        if not len(left):
            return
        ours = codes[left]
        nodes = ours >> np.uint64(3 * (LEVELS - level))
        starts = np.flatnonzero(np.r_[True, nodes[1:] != nodes[:-1]])
        counts = np.diff(np.r_[starts, len(left)])
        cells = ours >> np.uint64(3 * (LEVELS - GRID - level))
        taken = np.r_[True, cells[1:] != cells[:-1]]
        whole = counts <= few if level < LEVELS - GRID else np.ones(len(counts), bool)
        taken |= np.repeat(whole, counts)
        for start, count in zip(starts, counts):
            part = slice(start, start + count)
            yield level, nodes[start], left[part][taken[part]]
        left = left[~taken]


class CopcWriter(FileWriter):
    def __init__(self, path, header):
        super().__init__(path, header)
        need("laspy", "COPC files")
        self._copc = need("copclib", "COPC files")
        check_names(path, header)
        self._encoder = Encoder(self, header)
        self._scratch = None

    def store(self, chunk):
        self.write_records(self._encoder.encode(chunk))

    def write_records(self, records):
        if self._scratch is None:
            folder = pathlib.Path(self.path).parent
            folder.mkdir(parents=True, exist_ok=True)
            self._scratch = tempfile.TemporaryFile(dir=folder)  # noqa: SIM115
        self._scratch.write(np.ascontiguousarray(records))
        self.count += len(records)

    def close(self):
        if not self.count:
            self.abandon()
            self.fail("would have no points; change the selection")
        model = self._encoder.model
        records = np.memmap(self._scratch, model.header.point_format.dtype(), "r")
        low = np.array([records[axis].min() for axis in "XYZ"], np.int64)
        high = np.array([records[axis].max() for axis in "XYZ"], np.int64)
        size = self._cube_size(high - low, model.header.scales)
        codes = self._codes(records, low, model.header.scales, size)
        order = np.argsort(codes, kind="stable")
        writer = self._open_writer(model, records, low, high, size)
        try:
            for level, node, places in nodes_of(codes[order]):
                key = [level, *(gather(int(node) >> axis) for axis in range(3))]
                data = records[np.sort(order[places])]
                writer.AddNode(self._copc.VoxelKey(*key), self._copc.VectorChar(data.view(np.int8)))
            writer.Close()
            self._write_times(records["gps_time"])
        except RuntimeError as error:  # copclib raises it
            self.fail(f"cannot be written: {error}; free space on its disk")
        self._encoder.close()
        self._scratch.close()
        self.keep_part()
        write_names(self.path, self.count, self.header)

    def _write_times(self, times):
        """The range of the times in the record that locates the octree, which copclib leaves 0."""
        with open(self.part, "r+b") as file:
            file.seek(INFO + TIMES)
            file.write(struct.pack("<2d", times.min(), times.max()))

    def _cube_size(self, extent, scales):
        """Returns the side of the cube [m]: slightly more than the points need."""
        return max(float((extent * scales).max()), float(scales.max())) * (1 + 1e-6)

    def _codes(self, records, low, scales, size):
        codes = np.empty(len(records), np.uint64)
        for begin in range(0, len(records), 1 << 20):
            part = records[begin : begin + (1 << 20)]
            code = np.zeros(len(part), np.uint64)
            for axis, name in enumerate("XYZ"):
                steps = (part[name].astype(np.int64) - low[axis]) * scales[axis]
                cell = np.floor(steps * (2**LEVELS / size))
                code |= spread(np.clip(cell, 0, 2**LEVELS - 1)) << np.uint64(axis)
            codes[begin : begin + len(part)] = code
        return codes

    def _open_writer(self, model, records, low, high, size):
        copc, header = self._copc, model.header
        box = [low * header.scales + header.offsets, high * header.scales + header.offsets]
        config = copc.CopcConfigWriter(
            header.point_format.id, copc.Vector3(list(header.scales)),
            copc.Vector3(list(header.offsets)), self._wkt(model), self._extra_bytes(model),
        )  # fmt: skip
        las, info = config.las_header, config.copc_info
        las.min, las.max = (copc.Vector3([float(x) for x in corner]) for corner in box)
        las.global_encoding = model.encoding
        las.system_identifier = header.system_identifier
        las.generating_software = header.generating_software
        returns = np.bincount(records[records.dtype.names[4]] & 15, minlength=16)
        las.points_by_return = [int(count) for count in returns[1:16]]
        info.halfsize = size / 2
        info.center_x, info.center_y, info.center_z = (float(x) for x in box[0] + size / 2)
        info.spacing = size / 2**GRID
        return copc.FileWriter(self.part, config)

    def _wkt(self, model):
        found = model.header.vlrs.get("WktCoordinateSystemVlr")
        return found[0].string.rstrip("\0") if found else ""

    def _extra_bytes(self, model):
        """Extra Bytes known to copclib: it takes their names from a LAZ file only."""
        with tempfile.TemporaryDirectory(prefix="vtkhelios-") as folder:
            path = os.path.join(folder, "empty.laz")
            with open(path, "w+b") as file:
                writer = RecordWriter(file, model, compress=True)
                writer.write(np.zeros(1, model.header.point_format.dtype()))
                writer.close(bare=True)
            return self._copc.LazReader(path).laz_config.extra_bytes_vlr

    def abandon(self):
        self._encoder.close()
        if self._scratch is not None:
            self._scratch.close()
        super().abandon()
