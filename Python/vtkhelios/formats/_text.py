# SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
# SPDX-License-Identifier: BSD-3-Clause
"""Text: the columns of vtkHeliosPointTextWriter, named columns, PTS and PTX, or any that start with
x y z, by vtkHeliosPointTextReader.
"""

import functools
import pathlib

import numpy as np
from vtkmodules.vtkCommonCore import vtkMath

from ..array_names import AMPLITUDE, INTENSITY
from ..core.classes import vtk_class
from ..core.paths import to_vtk
from ..core.words import counted
from ._base import Header, Reader, Scan, StreamWriter, call, check_file, from_cloud, rows_of
from ._intensity import IntensityScale
from ._ptx import read_misses

COLUMNS = (11, 13, 15)  # the basic ones, with flags of scan lines, with decibels
PLAIN, ECHOES, PTS, PTX = "x y z", "echoes", "PTS", "PTX"
RIGID = 1e-4  # error of a rotation in text


class TextReader(Reader):
    kind = "text"

    def __init__(self, path, reader=None):
        """reader: one that has read other files of the run; names of parts keep their numbers."""
        super().__init__(path)
        check_file(path)
        self._reader = reader or vtk_class("vtkHeliosPointTextReader")()
        self._reader.SetFileName(to_vtk(self.path))
        call(self, self._reader, self._reader.ReadLayout)
        columns, self._layout = self._reader.GetNumberOfColumns(), self._reader.GetKind()
        plain = (PLAIN, ECHOES)
        self.kind = f"text, {'' if self._layout in plain else self._layout + ', '}{columns} columns"
        if self._layout == PLAIN and columns > 3:
            self.notes.append(
                f"{self.path}: has {columns} columns instead of the {COLUMNS[0]} of vtkhelios run, "
                "and no line of names: only the first three are read, as x y z"
            )
        if self._layout == PTX:
            self.scans = [
                self._make_scan(index) for index in range(self._reader.GetNumberOfScans())
            ]
        self._scale = IntensityScale(
            *self._reader.GetIntensityRange(),
            self._reader.GetHasWholeIntensities(),
            self._layout == PTS,
        )

    def _make_scan(self, index):
        """Returns a scan of PTX, with the pose of its scanner."""
        name = f"{pathlib.Path(self.path).stem}_{index + 1}"
        matrix = np.eye(4)
        rows = matrix.ravel().tolist()
        self._reader.GetScanMatrix(index, rows)
        matrix = np.reshape(rows, (4, 4))
        turn = matrix[:3, :3]
        if np.abs(turn @ turn.T - np.eye(3)).max() > RIGID or np.linalg.det(turn) < 0:
            self.notes.append(
                f"{self.path}: the matrix of scan {index + 1} is no rotation: points are placed by "
                "it, the scan has no pose"
            )
            return Scan(name)
        rotation = [0.0] * 4
        vtkMath.Matrix3x3ToQuaternion(turn.tolist(), rotation)
        misses = functools.partial(read_misses, self.path, index, turn)
        return Scan(name, tuple(matrix[:3, 3]), tuple(rotation), True, misses=misses, has_all=True)

    def read_chunks(self, rows):
        begin, size, told, seen, dropped = 0, 1, 0, 0, 0
        while begin < size:
            cloud = self._update(begin, rows)
            begin, size = self._reader.GetEnd(), self._reader.GetFileSize()
            told += self._reader.GetNumberOfCounted()
            dropped += self._reader.GetNumberOfDropped()
            self.scan = self._reader.GetScan()
            names = Header(cloud.GetFieldData()).part_names
            if names:
                self.header.part_names = names
            if cloud.GetNumberOfPoints() > 0:
                chunk = from_cloud(cloud)
                seen += rows_of(chunk)
                if INTENSITY in chunk:
                    self._scale.apply(chunk)
                yield chunk
        self._note_counts(told, seen, dropped)

    def _note_counts(self, told, seen, dropped):
        notes = [self._scale.note] if self._scale.note else []
        if told and told != seen:
            notes.append(
                f"has {counted(seen, 'point')}, but its lines of numbers count {told:,.0f}; is it whole?"
            )
        if dropped:
            notes.append(f"{counted(dropped, 'point')} without a return (0 0 0) are dropped")
        self.notes += [
            f"{self.path}: {note}" for note in notes if f"{self.path}: {note}" not in self.notes
        ]

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
        super().__init__(path, header, vtk_class("vtkHeliosPointTextWriter")(fill_missing=True))
        arrays = range(self.stream.GetNumberOfArrays())
        self._names = {self.stream.GetArrayName(index) for index in arrays}

    def store(self, chunk):
        self.lost |= {
            name: "text has no column for it"
            for name in chunk
            if name not in self._names and name != "points"
        }
        if AMPLITUDE not in chunk and INTENSITY in chunk:
            chunk = {**chunk, AMPLITUDE: 1e-9 * chunk[INTENSITY]}
            self.lost[INTENSITY] = "it is the intensity column, unscaled, and not in nW"
        super().store(chunk)
