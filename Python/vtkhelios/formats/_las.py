# SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
# SPDX-License-Identifier: BSD-3-Clause
"""LAS and LAZ by vtkHeliosLASReader and vtkHeliosLASWriter."""

import struct

from ..core.classes import vtk_class
from ._base import FormatError, Header, Reader, StreamWriter, call, check_file, from_cloud
from ._las_check import HEADER_BYTES
from ._names import drop_part_names, watch_part


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
    def __init__(self, path, header, stream=None):
        super().__init__(path, header, stream or vtk_class("vtkHeliosLASWriter")())
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
