# SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
# SPDX-License-Identifier: BSD-3-Clause
"""LAS by vtkHeliosLASReader and vtkHeliosLASWriter; LAZ as LAS compressed by laspy and lazrs.

A chunk of LAZ passes through a small LAS file in a temporary folder, so that arrays and fields are
converted in one place only: in C++.
"""

import pathlib
import struct
import tempfile

import numpy as np

from ..core.classes import vtk_class
from ..core.run_files import PART

from ._base import (
    FileWriter, FormatError, Header, Reader, StreamWriter, call, check_file, from_cloud, need,
    to_cloud,
)  # fmt: skip
from ._las_check import HEADER_BYTES
from ._names import add_names, check_names, drop_part_names, watch_part, write_names
from ._records import EXTENDED_HEAD, RecordReader, RecordWriter

OWN_SOFTWARE = b"vtkHelios "  # colours of its files have 16 bits
COLOURS = ("red", "green", "blue")
SCALE_OF_8 = 257  # factor of colours of 8 bits, see heliosLasColors.h
ROWS_OF_SEARCH = 50_000
WKT = (b"LASF_Projection", 2112)  # the record of a coordinate system


def _head(path):
    """Header data: number of points, version and format as text, whether waveforms."""
    with open(path, "rb") as file:
        start = file.read(HEADER_BYTES).ljust(HEADER_BYTES, b"\0")
    old, new = struct.unpack_from("<I", start, 107)[0], struct.unpack_from("<Q", start, 247)[0]
    form = start[104] & 63
    count = new if start[25] >= 4 and (new or form >= 6) else old
    return count, f"{start[24]}.{start[25]}, point format {form}", form in (4, 5, 9, 10)


def check_waveforms(path):
    """Raises FormatError unless a LAS file has waveforms that vtkHeliosLASReader can read."""
    check_file(path)
    _, words, has_packets = _head(path)
    if not has_packets:
        raise FormatError(
            f"{path}: is LAS {words}, which has no waveforms; give a file of point format 4, 5, 9 "
            "or 10"
        )


def has_waveforms(path):
    """Returns whether the point format of a LAS file has waveforms."""
    return _head(path)[2]


class LasReader(Reader):
    def __init__(self, path):
        super().__init__(path)
        self._reader = vtk_class("vtkHeliosLASReader")()
        self._reader.SetFileName(self.path)
        self.count, words, self.has_waveforms = _head(self.path)
        self.kind = f"LAS {words}"
        some = self._piece(0, min(max(1, self.count), 2**31 - 1))  # also finds errors
        self.header = Header(some.GetFieldData())
        if self.count == 0:
            self.fail("has no points; give a file with points")

    def _piece(self, piece, pieces):
        _call(self, self._reader, lambda: self._reader.UpdatePiece(piece, pieces, 0))
        return self._reader.GetOutput()

    def read_chunks(self, rows):
        pieces = -(-self.count // rows)
        for piece in range(pieces):
            yield from_cloud(self._piece(piece, pieces))


def _call(owner, reader, action):
    """Calls like call(), without notes on values that are not finite: Reader counts them."""
    known = len(owner.notes)
    call(owner, reader, action)
    owner.notes[known:] = [note for note in owner.notes[known:] if "is not finite at" not in note]


class LazReader(Reader):
    def __init__(self, path):
        super().__init__(path)
        self.records = RecordReader(path)
        self.count, words, self.has_waveforms = _head(self.path)
        self.kind = f"LAZ {words}"
        if self.count == 0:
            self.fail("has no points; give a file with points")
        self._folder = tempfile.TemporaryDirectory(prefix="vtkhelios-")
        self._short = None  # fields of 8 bits
        first = next(RecordReader(path).chunks(1))
        self.header = Header(self._to_cloud(first).GetFieldData())
        self.header.crs = self.header.crs or self._find_crs()
        if note := add_names(self.path, self.count, self.header):
            self.notes.append(note)

    def _find_crs(self):
        """Returns the WKT of an extended record, or an empty text."""
        for user, number, place, size in self.records.extended:
            if (user, number) == WKT:
                with open(self.path, "rb") as file:
                    file.seek(place + EXTENDED_HEAD)
                    text = file.read(size - EXTENDED_HEAD)
                return text.split(b"\0")[0].decode("utf-8", "replace")
        return ""

    def _to_cloud(self, records):
        path = pathlib.Path(self._folder.name) / "points.las"
        with open(path, "w+b") as file:
            writer = RecordWriter(file, self.records, compress=False)
            writer.write(records)
            writer.close(bare=True)
            file.seek(58)
            file.write(OWN_SOFTWARE)  # colours are scaled here
        reader = vtk_class("vtkHeliosLASReader")()
        reader.SetFileName(str(path))
        known = len(self.notes)
        _call(self, reader, reader.Update)
        new = [note.replace(str(path), self.path) for note in self.notes[known:]]
        self.notes[known:] = [note for note in new if note not in self.notes[:known]]
        return reader.GetOutput()

    def read_chunks(self, rows):
        if self._short is None:
            self._short = self._find_short()
        reader = RecordReader(self.path)
        for records in reader.chunks(rows):
            for name in self._short:
                records[name] *= SCALE_OF_8
            yield from_cloud(self._to_cloud(records))
        reader.close()

    def _find_short(self):
        """Returns the fields of colours of 8 bits: none of the whole file is above 255."""
        names = self.records.header.point_format.dtype().names
        if "red" not in names or self.records.start[58:].startswith(OWN_SOFTWARE):
            return []
        reader, colours, infrared = RecordReader(self.path), 0, 0
        for records in reader.chunks(ROWS_OF_SEARCH):
            colours = max(colours, *(int(records[name].max()) for name in COLOURS))
            infrared = max(infrared, int(records["nir"].max()) if "nir" in names else 0)
            if colours > 255:
                break
        reader.close()
        if not 0 < colours <= 255:
            return []
        self.notes.append(
            f"{self.path}: its colours have 8 bits: they are scaled by 257 to the 16 bits of LAS"
        )
        return [*COLOURS, "nir"] if 0 < infrared <= 255 else list(COLOURS)

    def close(self):
        self.records.close()
        self._folder.cleanup()


class LasWriter(StreamWriter):
    def __init__(self, path, header):
        super().__init__(path, header, vtk_class("vtkHeliosLASWriter")())
        watch_part(path)

    def close(self):
        super().close()
        watch_part(self.path, False)

    def abandon(self):
        super().abandon()
        drop_part_names(self.path)


class Encoder:
    """Chunks as the LAS records of vtkHeliosLASWriter. One header for all of them."""

    def __init__(self, owner, header):
        self._owner = owner
        self._header = header
        self._folder = tempfile.TemporaryDirectory(prefix="vtkhelios-")
        self._las = pathlib.Path(self._folder.name) / "points.las"
        self._part = pathlib.Path(f"{self._las}{PART}")
        self._writer = vtk_class("vtkHeliosLASWriter")()
        self._writer.SetFileName(str(self._las))
        self._begin = 0  # first of the points in the file
        self.model = None  # a RecordReader of the first chunk: the head

    def encode(self, chunk):
        """Returns a chunk as a structured array."""
        writer = self._writer
        opened = (lambda: writer.Reopen(self._begin, 0, 0)) if self._begin else writer.Open
        call(self._owner, writer, opened)
        cloud = to_cloud(chunk, self._header)
        try:
            call(self._owner, writer, lambda: writer.Write(cloud))
        finally:
            writer.Abandon()
        if self.model is None:
            self.model = RecordReader(self._part)
            self._begin = self.model.header.offset_to_point_data
        return np.fromfile(self._part, self.model.header.point_format.dtype(), offset=self._begin)

    def close(self):
        self._folder.cleanup()


class LazWriter(FileWriter):
    def __init__(self, path, header):
        super().__init__(path, header)
        need("laspy", "LAZ files")
        need("lazrs", "LAZ files")
        check_names(path, header)
        self._encoder = Encoder(self, header)
        self._records = None

    def store(self, chunk):
        records = self._encoder.encode(chunk)
        if self._records is None:
            self.open_part()
            self._records = RecordWriter(self.file, self._encoder.model, compress=True)
        self._records.write(records)
        self.count += len(records)

    def close(self):
        if not self.count:
            self.abandon()
            self.fail("would have no points; change the selection")
        self._records.close(bare=True)
        self.file.close()
        self._encoder.close()
        self.keep_part()
        write_names(self.path, self.count, self.header)

    def abandon(self):
        self._encoder.close()
        super().abandon()
