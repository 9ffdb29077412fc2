# SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
# SPDX-License-Identifier: BSD-3-Clause
"""Text: the eleven columns of vtkHeliosPointTextWriter, or any that start with x y z."""

import itertools
import pathlib

import numpy as np

import vtkhelios

from ._base import ROWS, FormatError, Reader, Writer, call, rows_of, to_cloud

COLUMNS = 11

# Arrays of the eleven columns: name, column, type.
ARRAYS = (
    ("EchoWidth", 4, np.float64),
    ("ReturnNumber", 5, np.uint8),
    ("NumberOfReturns", 6, np.uint8),
    ("PulseIds", 7, np.int64),
    ("ClassificationIds", 9, np.int32),
    ("GpsTime", 10, np.float64),
)
# Default values of columns without an array.
DEFAULTS = {
    "Amplitude": (0.0, np.float64),
    "EchoWidth": (0.0, np.float64),
    "GpsTime": (0.0, np.float64),
    "ReturnNumber": (1, np.uint8),
    "NumberOfReturns": (1, np.uint8),
    "PulseIds": (-1, np.int64),
    "PartIds": (-1, np.int32),
    "ClassificationIds": (0, np.int32),
}


class TextReader(Reader):
    kind = "text"

    def __init__(self, path, names=None):
        super().__init__(path)
        self._names = {} if names is None else names  # of objects: number, may span several files
        with open(self.path, "rb") as file:
            first = next((words for line in file if (words := _words(line))), None)
        if first is None:
            self.fail("has no points; give a file with points")
        self.columns = len(first)
        if self.columns < 3:
            self.fail(f"has {self.columns} columns; give x y z, or the {COLUMNS} of vtkhelios run")
        self.kind = f"text, {self.columns} columns"
        if self.columns not in (3, COLUMNS):
            self.notes.append(
                f"{self.path}: has {self.columns} columns instead of the {COLUMNS} of vtkhelios "
                "run: only the first three are read, as x y z"
            )

    def read_chunks(self, rows):
        line = 1
        with open(self.path, "rb") as file:
            while lines := list(itertools.islice(file, rows)):
                yield self._parse(lines, line)
                line += len(lines)

    def _parse(self, lines, first):
        data = b"".join(lines)
        if b"\0" in data:
            place = next(number for number, line in enumerate(lines, first) if b"\0" in line)
            self.fail_at(
                place, "has zero bytes, so it is not valid text: it is damaged, copy it again"
            )
        if b"#" in data or b"//" in data:
            lines = [b" ".join(_words(line)) + b"\n" for line in lines]
        table = self._table(lines, first)
        chunk = {"points": np.ascontiguousarray(table[:, :3])}
        if self.columns == COLUMNS:
            chunk["Amplitude"] = 1e-9 * table[:, 3]
            for name, column, kind in ARRAYS:
                chunk[name] = self._whole(table[:, column], kind, column, lines, first)
            chunk["PartIds"] = self._whole(table[:, 8], np.int32, 8, lines, first)
        return chunk

    def _table(self, lines, first):
        """The numbers; objects by name get new numbers."""
        named = self.columns == COLUMNS and (self._names or _has_names(lines))
        before = len(self._names)
        try:
            table = np.loadtxt(
                lines,
                comments=None,
                ndmin=2,
                usecols=range(3) if self.columns not in (3, COLUMNS) else None,
                converters={8: self._number} if named else None,
            )
        except ValueError:
            self._complain(lines, first)
        if len(self._names) > before:
            self.header.part_names = [name.decode(errors="replace") for name in self._names]
        return table

    def _number(self, name):
        """The number of a named object."""
        return self._names.setdefault(name, len(self._names))

    def _whole(self, values, kind, column, lines, first):
        if kind is np.float64:
            return np.ascontiguousarray(values)
        whole = values.astype(kind)
        if not np.array_equal(whole, values):
            row = int(np.flatnonzero(whole != values)[0])
            place = [i for i, line in enumerate(lines) if line.strip()][row]
            self.fail_at(
                first + place,
                f"{values[row]:g} in column {column + 1} is not a whole number from "
                f"{np.iinfo(kind).min} to {np.iinfo(kind).max}; correct it",
            )
        return whole

    def _complain(self, lines, first):
        """Raises the error of the first invalid line."""
        for number, line in enumerate(lines, first):
            words = line.split()
            if words and len(words) != self.columns:
                self.fail_at(
                    number,
                    f"has {len(words)} columns, but the first line has {self.columns}; correct it",
                )
            for column, word in enumerate(words, 1):
                if column == 9 or (column > 3 and self.columns != COLUMNS):
                    continue
                try:
                    float(word)
                except ValueError:
                    text = word.decode(errors="replace")
                    self.fail_at(number, f'"{text}" in column {column} is not a number; correct it')
        self.fail("cannot be read; correct it")

    def fail_at(self, line, problem):
        raise FormatError(f"{self.path}:{line}: {problem}")


def _has_names(lines):
    """Whether an object is not a number."""
    try:
        return not all(line.split(None, 9)[8].lstrip(b"-").isdigit() for line in lines)
    except IndexError:  # a line that is too short, reported later
        return False


def _words(line):
    """The words of a line before a comment."""
    for mark in (b"#", b"//"):
        line = line.split(mark)[0]
    return line.split()


class TextWriter(Writer):
    """The eleven columns."""

    def __init__(self, path, header):
        super().__init__(path, header)
        self._writer = vtkhelios.vtkHeliosPointTextWriter()
        self._writer.SetFileName(self.path)

    def put(self, chunk):
        if not self._writer.IsOpen():
            call(self, self._writer, self._writer.Open)
        cloud = to_cloud({"points": chunk["points"], **self._columns(chunk)}, self.header)
        call(self, self._writer, lambda: self._writer.Write(cloud))
        self.count += rows_of(chunk)

    def _columns(self, chunk):
        for name in chunk:
            if name not in DEFAULTS and name != "points":
                self.lost[name] = "text has no column for it"
        columns = {}
        for name, (value, kind) in DEFAULTS.items():
            if name in chunk:
                columns[name] = chunk[name]
            elif name == "Amplitude" and "Intensity" in chunk:
                columns[name] = 1e-9 * chunk["Intensity"]
                self.lost["Intensity"] = "it is the intensity column, unscaled, and not in nW"
            else:
                columns[name] = np.full(rows_of(chunk), value, kind)
        return columns

    def close(self):
        if not self.count:
            self.abandon()
            self.fail("would have no points; change the selection")
        call(self, self._writer, self._writer.Close)

    def abandon(self):
        if self._writer.IsOpen():
            self._writer.Abandon()
        pathlib.Path(f"{self.path}.part").unlink(missing_ok=True)
