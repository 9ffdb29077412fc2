# SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
# SPDX-License-Identifier: BSD-3-Clause
"""Text: the columns of vtkHeliosPointTextWriter, or any that start with x y z."""

import vtkhelios

from .._paths import to_vtk
from ..array_names import AMPLITUDE, INTENSITY
from ._base import Header, Reader, StreamWriter, call, check_file, from_cloud

COLUMNS = (11, 13, 15)  # the basic ones, with flags of scan lines, with decibels


class TextReader(Reader):
    kind = "text"

    def __init__(self, path, reader=None):
        """reader: one that has read other files of the run; names of parts keep their numbers."""
        super().__init__(path)
        check_file(path)
        self._reader = reader or vtkhelios.vtkHeliosPointTextReader()
        columns = self._reader.CountColumns(to_vtk(self.path))
        self.kind = f"text, {columns} columns"
        if columns < 3:
            self._update(0, 1)  # says what is wrong
        if columns not in (3, *COLUMNS):
            self.notes.append(
                f"{self.path}: has {columns} columns instead of the {COLUMNS[0]} of vtkhelios run: "
                "only the first three are read, as x y z"
            )

    def read_chunks(self, rows):
        begin, size = 0, 1
        while begin < size:
            cloud = self._update(begin, rows)
            begin, size = self._reader.GetEnd(), self._reader.GetFileSize()
            names = Header(cloud.GetFieldData()).part_names
            if names:
                self.header.part_names = names
            if cloud.GetNumberOfPoints() > 0:
                yield from_cloud(cloud)

    def _update(self, begin, rows):
        self._reader.SetFileName(to_vtk(self.path))
        self._reader.SetBegin(begin)
        self._reader.SetMaximumNumberOfPoints(rows)
        self._reader.KeepInvalidOn()  # chunks() handles them
        call(self, self._reader, self._reader.Update)
        return self._reader.GetOutput()


class TextWriter(StreamWriter):
    """The eleven columns."""

    def __init__(self, path, header):
        super().__init__(path, header, vtkhelios.vtkHeliosPointTextWriter(fill_missing=True))
        arrays = range(self.stream.GetNumberOfArrays())
        self._names = {self.stream.GetArrayName(index) for index in arrays}

    def put(self, chunk):
        self.lost |= {
            name: "text has no column for it"
            for name in chunk
            if name not in self._names and name != "points"
        }
        if AMPLITUDE not in chunk and INTENSITY in chunk:
            chunk = {**chunk, AMPLITUDE: 1e-9 * chunk[INTENSITY]}
            self.lost[INTENSITY] = "it is the intensity column, unscaled, and not in nW"
        super().put(chunk)
