# SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
# SPDX-License-Identifier: BSD-3-Clause
"""The points of LAS and LAZ as records, by the library of vtkHeliosLASReader and vtkHeliosLASWriter.

laspy has headers and records only: it gets a writer of compressed points from here.
"""

import os
import struct

import numpy as np

from .. import _native

CHUNK = 50_000  # points compressed together
ROUND = 16 * CHUNK  # points collected before they are compressed in parallel


def read_records(path, first, records):
    """Reads points from an index on into an array of records; ValueError names the file."""
    if problem := _native.read_las_records(os.fsencode(path), first, memoryview(records).cast("B")):
        raise ValueError(problem)


def make_backend(laspy):
    """Returns what laspy takes as laz_backend, to write."""
    from laspy._pointwriter import IPointWriter
    from laspy.vlrs.known import LasZipVlr

    class PointWriter(IPointWriter):
        def __init__(self, file, header):
            self._file = file
            self._form = header.point_format.id, header.point_format.size
            self._pending, self._chunks = [], []

        @property
        def destination(self):
            return self._file

        def write_initial_header_and_vlrs(self, header, encoding_errors):
            header.vlrs.append(LasZipVlr(_native.laz_record(*self._form)))
            super().write_initial_header_and_vlrs(header, encoding_errors)
            self._begin = self._file.tell()
            self._file.write(struct.pack("<q", self._begin))  # no table yet

        def write_points(self, points):
            self._pending.append(np.frombuffer(points.memoryview(), np.uint8).copy())
            size = sum(map(len, self._pending)) // self._form[1]
            if size >= ROUND:
                self._append(size // CHUNK * CHUNK)

        def _append(self, count):
            data = np.concatenate([*self._pending, np.empty(0, np.uint8)])
            end = count * self._form[1]
            for points, chunk in _native.encode_laz(*self._form, data[:end]):
                self._file.write(chunk)
                self._chunks.append((points, len(chunk)))
            self._pending = [data[end:]]

        def done(self):
            self._append(sum(map(len, self._pending)) // self._form[1])
            place = self._file.tell()
            self._file.write(_native.encode_laz_table(self._chunks))
            end = self._file.tell()
            self._file.seek(self._begin)
            self._file.write(struct.pack("<q", place))
            self._file.seek(end)

    class Backend:
        is_available = staticmethod(lambda: True)
        create_writer = PointWriter

    return Backend
