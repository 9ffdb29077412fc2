# SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
# SPDX-License-Identifier: BSD-3-Clause
"""LAS and LAZ by vtkHeliosLASReader and vtkHeliosLASWriter."""

import pathlib
import struct
import tempfile

import numpy as np

from ..core.classes import vtk_class
from ..core.run_files import PART

from ._base import (
    FormatError, Header, Reader, StreamWriter, call, check_file, from_cloud, to_cloud,
)  # fmt: skip
from ._las_check import HEADER_BYTES
from ._names import drop_part_names, watch_part
from ._records import RecordReader


def _head(path):
    """Header data: number of points, version and format as text, whether waveforms, whether LAZ."""
    with open(path, "rb") as file:
        start = file.read(HEADER_BYTES).ljust(HEADER_BYTES, b"\0")
    old, new = struct.unpack_from("<I", start, 107)[0], struct.unpack_from("<Q", start, 247)[0]
    form = start[104] & 63
    count = new if start[25] >= 4 and (new or form >= 6) else old
    words = f"{start[24]}.{start[25]}, point format {form}"
    return count, words, form in (4, 5, 9, 10), bool(start[104] & 0xC0)


def check_waveforms(path):
    """Raises FormatError unless a LAS file has waveforms that vtkHeliosLASReader can read."""
    check_file(path)
    _, words, has_packets, _ = _head(path)
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
        self.count, words, self.has_waveforms, is_compressed = _head(self.path)
        self.kind = f"{'LAZ' if is_compressed else 'LAS'} {words}"
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


class LazWriter(LasWriter):
    def __init__(self, path, header):
        super().__init__(path, header)
        self.stream.SetWriteCompressed(True)


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
