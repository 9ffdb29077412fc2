# SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
# SPDX-License-Identifier: BSD-3-Clause
"""The points of a side of a comparison: from files, runs, folders of these, clouds or arrays."""

import pathlib

import numpy as np

from .. import formats

from ..array_names import (
    AMPLITUDE, CHANNEL_IDS, CLASSIFICATION_IDS, ECHO_WIDTH, GPS_TIME, INTENSITY, LEG_IDS,
    NUMBER_OF_RETURNS, RETURN_NUMBER, SCAN_ANGLE, SCAN_DIRECTION_FLAG,
)  # fmt: skip
from ..core.run_files import POINTS, SUMMARY_NAME, kind_of
from ..core.systems import Metres, find_difference
from ..core.views import data_of
from ..core.words import counted
from ..formats import FormatError
from ..formats._base import Header, from_cloud, rows_of, select
from ..formats._endings import points

SOURCE = "Source"  # number of the file of a point
KEPT = (
    AMPLITUDE, CHANNEL_IDS, CLASSIFICATION_IDS, ECHO_WIDTH, GPS_TIME, INTENSITY, LEG_IDS,
    NUMBER_OF_RETURNS, RETURN_NUMBER, SCAN_ANGLE, SCAN_DIRECTION_FLAG,
)  # fmt: skip
SMALL = {ECHO_WIDTH: np.float32, AMPLITUDE: np.float32, SCAN_ANGLE: np.float32}
FARTHEST = 1e12  # limit of coordinates [m]; larger ones are damaged


class Side:
    """The points of a cloud, with the arrays that are compared, and where they are from.

    columns: points (n x 3) and arrays of n rows. total: points in the input, more than n if tiles
    were drawn or if tiles of the other cloud are empty.
    """

    def __init__(self, name, columns, crs="", notes=()):
        self.name, self.columns, self.crs, self.notes = name, columns, crs, list(notes)
        self.total = len(self)
        self.tiles = None  # number of the tile of each point

    def __len__(self):
        return len(self.columns["points"])

    def __contains__(self, name):
        return name in self.columns

    def __getitem__(self, name):
        return self.columns[name]

    @property
    def points(self):
        return self.columns["points"]

    def keep(self, mask):
        """Drops the other points."""
        self.columns = select(self.columns, mask)
        self.tiles = self.tiles[mask]


class Source:
    """An input that can be read repeatedly."""

    def __init__(self, given, limit, on_step, height_unit=None):
        self._limit, self._on_step, self._height_unit = limit, on_step, height_unit
        self._paths = list_files(given) if is_path(given) else None
        self._chunk, self._header = (None, None) if self._paths else chunk_of(given)
        self.name = str(given) if self._paths else describe(given)
        self.low, self.high = np.full(3, np.inf), np.full(3, -np.inf)
        self.total, self.crs, self.notes = 0, None, []

    def read(self, accepts=None):
        """Returns a Side, or None if there are more points than the limit: then only their number
        and
        bounds are known. accepts is a function from points (n x 3) to a mask."""
        kept, fits = [], True
        self.total = 0
        for source, chunk in self._chunks():
            points = self._to_metres(self._check(chunk))
            chunk = {**chunk, "points": points}
            self.total += len(points)
            if len(points):
                self.low = np.minimum(self.low, points.min(axis=0))
                self.high = np.maximum(self.high, points.max(axis=0))
            fits = fits and (accepts is not None or self.total <= self._limit)
            if fits:
                kept.append(reduce(chunk, source, accepts))
            else:
                kept.clear()
            self._on_step(f"reading {self.name}, {self.total / 1e6:.2f} M points", 0.0)
        if self.total == 0:
            raise FormatError(f"{self.name}: has no points; give a cloud with points")
        return self._join(kept) if fits else None

    def _chunks(self):
        if self._paths is None:
            self._add_crs(self._header.crs)
            yield 0, self._chunk
            return
        for index, path in enumerate(self._paths):
            with formats.open_reader(path) as reader:
                self._add_crs(reader.header.crs)
                for chunk in reader.chunks():
                    yield index, chunk
                self.notes += [note for note in reader.notes if note not in self.notes]

    def _add_crs(self, crs):
        if self.crs is None:
            self.crs = crs
        elif problem := find_difference(self.crs, crs):
            raise FormatError(
                f"{self.name}: its files have different coordinate systems: {problem}"
            )

    def _to_metres(self, points):
        metres = Metres(self.crs, self._height_unit)
        if len(points) and (problem := metres.refuse_degrees(points[0])):
            raise FormatError(f"{self.name}: {problem}")
        note = f"{self.name}: {metres.note}"
        if metres.note and note not in self.notes:
            self.notes.append(note)
        return metres.convert(points)

    def _check(self, chunk):
        points = chunk["points"]
        if len(points) and not (np.abs(points) <= FARTHEST).all():
            row = int(np.flatnonzero(~(np.abs(points) <= FARTHEST).all(axis=1))[0])
            place = ", ".join(f"{value:g}" for value in points[row])
            raise FormatError(
                f"{self.name}: point {self.total + row} is ({place}), expected numbers within "
                f"{FARTHEST:g} m; correct it, or drop it with vtkhelios convert"
            )
        return points

    def _join(self, kept):
        names = [name for name in kept[0] if all(name in chunk for chunk in kept)]
        some = {name for chunk in kept for name in chunk} - set(names)
        self.notes += [
            f"{self.name}: not all of its files have {name}; it is not compared"
            for name in sorted(some)
        ]
        columns = {name: np.concatenate([chunk[name] for chunk in kept]) for name in names}
        side = Side(self.name, columns, self.crs or "", self.notes)
        side.total = self.total
        return side


def reduce(chunk, source, accepts):
    """The arrays that are compared, of the accepted points."""
    points = np.ascontiguousarray(chunk["points"], np.float64)
    mask = slice(None) if accepts is None else accepts(points)
    part = {"points": points[mask]}
    for name in KEPT:
        if name in chunk and chunk[name].ndim == 1:
            part[name] = chunk[name][mask].astype(SMALL.get(name, chunk[name].dtype), copy=False)
    part[SOURCE] = np.full(len(part["points"]), source, np.int32)
    return part


def is_path(given):
    return isinstance(given, (str, pathlib.Path))


def list_files(given):
    """Returns the files and runs of a path, as paths."""
    path = pathlib.Path(given)
    if not path.exists():
        raise FormatError(f"{path}: no such file or folder; check its name")
    if not path.is_dir() or (path / SUMMARY_NAME).exists():
        return [path]
    found = [each for each in sorted(path.iterdir()) if is_cloud(each)]
    if not found:
        formats.open_reader(path)  # an unfinished run, or epochs: this error knows
    return found


def is_cloud(path):
    """Returns whether a member of a folder is a run, or a file of points."""
    if path.is_dir():
        return (path / SUMMARY_NAME).exists()
    known = path.name.lower().endswith(points()) and path.suffix.lower() not in formats.TABLES
    return known and kind_of(path) in (POINTS, -1)


def chunk_of(given):
    """Returns the points in memory, and their header."""
    if isinstance(given, np.ndarray):
        if given.ndim != 2 or given.shape[1] != 3:
            raise ValueError(f"points has the shape {given.shape}; give an array of (n, 3)")
        return {"points": given.astype(np.float64, copy=False)}, Header()
    data = data_of(given)
    if not (hasattr(data, "IsA") and data.IsA("vtkPolyData")):
        raise TypeError(
            f"clouds are compared, not {type(given).__name__}; give a path, a Cloud, a vtkPolyData "
            "or an array of (n, 3)"
        )
    chunk = from_cloud(data)
    finite = np.isfinite(chunk["points"]).all(axis=1)
    return (chunk if finite.all() else select(chunk, finite)), Header(data.GetFieldData())


def describe(given):
    chunk, _ = chunk_of(given)
    return f"{type(given).__name__} of {counted(rows_of(chunk), 'point')}"
