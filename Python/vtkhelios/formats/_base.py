# SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
# SPDX-License-Identifier: BSD-3-Clause
"""Base classes of all formats."""

import contextlib
import dataclasses
import os
import pathlib
import re

import numpy as np
from vtkmodules.vtkCommonCore import vtkDoubleArray, vtkPoints, vtkStringArray
from vtkmodules.vtkCommonDataModel import vtkFieldData, vtkPolyData

from .. import _native

from ..array_names import (
    AMPLITUDE, CELL_IDS, CHANNEL_IDS, CLASSIFICATION_FLAGS, CLASSIFICATION_IDS, COORDINATE_SCALE,
    CRS, DEVIATION, ECHO_WIDTH, EDGE_OF_FLIGHT_LINE, GPS_EPOCH, GPS_TIME, INCIDENCE_ANGLE,
    INTENSITY, LEG_IDS, MATERIAL_IDS, NEAR_INFRARED, NUMBER_OF_RETURNS, PART_IDS, PART_NAME,
    PULSE_IDS, RANGE, RETURN_NUMBER, SCAN_ANGLE, SCAN_DIRECTION_FLAG, USER_DATA, WAVEFORM_IDS,
)  # fmt: skip
from ..core.arrays import arrays, numpy_to_vtk
from ..core import packages
from ..core.files import drop_part, keep_part, open_part, part_of
from ..core.pipeline import MessageLog
from ..core.systems import find_system
from ..core.unfinished import set_unfinished
from ..core.words import counted

ROWS = 500_000  # points of a chunk

NUMBERS = ("i1", "i2", "i4", "i8", "u1", "u2", "u4", "u8", "f4", "f8")  # types of arrays

# Arrays of clouds with one value per point.
SCALARS = frozenset((
    AMPLITUDE, CELL_IDS, CHANNEL_IDS, CLASSIFICATION_FLAGS, CLASSIFICATION_IDS, DEVIATION,
    ECHO_WIDTH, EDGE_OF_FLIGHT_LINE, GPS_TIME, INCIDENCE_ANGLE, INTENSITY, LEG_IDS,
    MATERIAL_IDS, NEAR_INFRARED, NUMBER_OF_RETURNS, PART_IDS, PULSE_IDS, RANGE, RETURN_NUMBER,
    SCAN_ANGLE, SCAN_DIRECTION_FLAG, USER_DATA, WAVEFORM_IDS,
))  # fmt: skip

Chunk = dict  # name: numpy array; includes "points"


class FormatError(ValueError):
    """A file that cannot be read or written, with the reason and the remedy."""


def check_file(path):
    """Raises FormatError unless a path is a regular file; others may have no end or no size."""
    path = os.fspath(path)
    try:
        os.stat(path)
    except FileNotFoundError:
        raise FormatError(f"{path}: no such file; check its name") from None
    except (OSError, ValueError) as error:  # ValueError: NUL in the name, in words of the version
        reason = getattr(error, "strerror", "embedded null byte")
        raise FormatError(f"{path}: cannot be read: {reason}; check its name") from None
    if problem := _native.check_input_file(os.fsencode(path)):
        raise FormatError(f"{path}: {problem}")


def memory_limit(size):
    """Maximum memory of one step of reading a file of a size [bytes]; some steps overlap."""
    return 4e8 + 8.0 * size


def is_failure(error):
    """Returns whether an exception is a failure of a library; a lazrs panic is not an Exception."""
    return isinstance(error, Exception) or type(error).__name__ == "PanicException"


@contextlib.contextmanager
def guarded(path):
    """Converts exceptions of a format's libraries to a FormatError that names the file."""
    try:
        yield
    except FormatError:
        raise
    except MemoryError as error:
        raise FormatError(f"{path}: not enough memory; split it, or use another machine") from error
    except OSError as error:
        raise FormatError(
            f"{path}: cannot be read: {error.strerror or error}; check the file and its folder"
        ) from error
    except BaseException as error:
        if not is_failure(error):
            raise
        words = " ".join(str(error).split())[:200] or type(error).__name__
        raise FormatError(
            f"{path}: cannot be read: {words}; it is damaged, or of an unknown form: copy "
            "or write it again"
        ) from error


def _as_text(value):
    """Returns a VTK string; VTK returns bytes if it is not UTF-8."""
    return value.decode("utf-8", "replace") if isinstance(value, bytes) else value


class Header:
    """Values common to all points of a file: field arrays, as in VTK."""

    def __init__(self, fields=None):
        self.fields = vtkFieldData()
        if fields is not None:
            self.fields.ShallowCopy(fields)

    @property
    def crs(self):
        """The coordinate system: WKT or EPSG:n; empty: unknown."""
        array = self.fields.GetAbstractArray(CRS)
        return _as_text(array.GetValue(0)) if array and array.GetNumberOfValues() else ""

    @crs.setter
    def crs(self, text):
        self.set_texts(CRS, [text] if text else [])

    @property
    def epoch(self):
        """Zero of GpsTime [s], GPS time since 6 January 1980; 0: unknown."""
        array = self.fields.GetArray(GPS_EPOCH)
        return array.GetTuple1(0) if array and array.GetNumberOfValues() else 0.0

    @epoch.setter
    def epoch(self, seconds):
        self.fields.RemoveArray(GPS_EPOCH)
        if seconds:
            array = vtkDoubleArray()
            array.SetName(GPS_EPOCH)
            array.InsertNextValue(seconds)
            self.fields.AddArray(array)

    @property
    def steps(self):
        """The steps of x, y and z in the file, in their units, or None."""
        array = self.fields.GetArray(COORDINATE_SCALE)
        return tuple(array.GetValue(axis) for axis in range(3)) if array else None

    def set_steps(self, steps):
        """Sets the steps of x, y and z that writers keep at least, in their units."""
        array = vtkDoubleArray()
        array.SetName(COORDINATE_SCALE)
        for step in steps:
            array.InsertNextValue(float(step))
        self.fields.AddArray(array)

    @property
    def part_names(self):
        """The names of scene parts, by PartIds."""
        return self.texts(PART_NAME)

    @part_names.setter
    def part_names(self, names):
        self.set_texts(PART_NAME, names)

    def texts(self, name):
        """Returns the texts in a field array."""
        array = self.fields.GetAbstractArray(name)
        values = range(array.GetNumberOfValues() if array else 0)
        return [_as_text(array.GetValue(i)) for i in values]

    def set_texts(self, name, values):
        """Replaces a field array by texts, or removes it."""
        self.fields.RemoveArray(name)
        if values:
            array = vtkStringArray()
            array.SetName(name)
            for value in values:
                array.InsertNextValue(value)
            self.fields.AddArray(array)


@dataclasses.dataclass
class Scan:
    """Source of points: a leg, or a file."""

    name: str
    translation: tuple = (0.0, 0.0, 0.0)  # position of the scanner or platform [m]
    rotation: tuple = (1.0, 0.0, 0.0, 0.0)  # w x y z, body to world
    has_pose: bool = False
    pulses: object = None  # a function of an iterator over chunks of pulses; None: unknown
    # a function of an iterator over directions (n x 3) of pulses without an echo; None: unknown
    misses: object = None
    has_all: bool = False  # whether misses are all pulses without an echo, even if there are none


class _Closing:
    def __enter__(self):
        return self


class Reader(_Closing):
    """Points of a file. ``count`` is their number, None if only known after reading."""

    kind = ""  # for display

    def __init__(self, path):
        self.path = str(path)
        self.header = Header()
        self.count = None
        self.scans = [Scan(pathlib.Path(path).name.split(".")[0])]
        self.scan = 0  # scan of the points of the latest chunk
        self.has_waveforms = False  # not included in chunks
        self.notes = []  # skipped or reinterpreted data
        self.keeps_invalid = False  # whether chunks include points that are not finite

    def chunks(self, rows=ROWS):
        """Yields the points, at most this many at a time. Points that are not finite are skipped,
        unless keeps_invalid; the notes count them, and other values that are not finite.
        """
        invalid, seen = {}, 0
        with guarded(self.path):
            for chunk in self.read_chunks(rows):
                self._check_shapes(chunk)
                seen += rows_of(chunk)
                yield self._drop_invalid(chunk, invalid)
        self._note_invalid(invalid, seen)

    def read_chunks(self, rows):
        """Yields the points as stored in the file; of subclasses."""
        raise NotImplementedError

    def _check_shapes(self, chunk):
        for name in SCALARS.intersection(chunk):
            if chunk[name].ndim != 1:
                self.fail(
                    f"{name} has {chunk[name].shape[1]} values per point, expected one; give the "
                    "array another name, or write the file again"
                )

    def _drop_invalid(self, chunk, invalid):
        """Returns the finite points of a chunk; counts values that are not finite by array name."""
        finite = np.isfinite(chunk["points"]).all(axis=1)
        for name, values in chunk.items():
            if values.dtype.kind == "f" and name != "points" and not np.isfinite(values).all():
                bad = ~np.isfinite(values).reshape(len(values), -1).all(axis=1)
                invalid[name] = invalid.get(name, 0) + int(np.count_nonzero(bad & finite))
        if self.keeps_invalid or finite.all():
            return chunk
        invalid["points"] = invalid.get("points", 0) + int(np.count_nonzero(~finite))
        return select(chunk, finite)

    def _note_invalid(self, invalid, seen):
        for name, count in invalid.items():
            if name == "points":
                note = f"{count:,} of {counted(seen, 'point')} are not finite; they are dropped"
            else:
                note = (
                    f"{name} is not finite at {count:,} of {counted(seen, 'point')}, and is kept so"
                )
            if count and f"{self.path}: {note}" not in self.notes:
                self.notes.append(f"{self.path}: {note}")

    def check_system(self):
        """Ignores a coordinate system that PROJ does not know, with a note."""
        if problem := find_system(self.header.crs).problem:
            self.notes.append(
                f"{self.path}: its coordinate system is not known and is ignored: {problem}"
            )
            self.header.crs = ""

    def close(self):
        """Ends the reading."""

    def fail(self, problem):
        raise FormatError(f"{self.path}: {problem}")

    def __exit__(self, *_):
        self.close()


class Writer(_Closing):
    """Writes points to a file."""

    def __init__(self, path, header):
        self.path = str(path)
        self.header = header
        self.count = 0  # number of points written
        self.lost = {}  # not storable in the format: name to reason
        self.notes = []
        self.scan = Scan(pathlib.Path(path).name.split(".")[0])

    def begin(self, scan):
        """Sets the scan of the next chunks; formats with scans start a new one."""
        self.scan = scan

    def write(self, chunk):
        """Appends points."""
        if problem := find_problem(chunk):
            self.fail(problem)
        self.store(chunk)

    def store(self, chunk):
        """Appends checked points; of subclasses."""
        raise NotImplementedError

    def close(self):
        """Ends the file and renames it. Without any points: an error, and no file."""
        raise NotImplementedError

    def abandon(self):
        """Removes the output."""
        raise NotImplementedError

    def names(self):
        """Returns the files left by close(), as far as names are known."""
        return [self.path]

    def fail(self, problem):
        raise FormatError(f"{self.path}: {problem}")

    def __exit__(self, kind, *_):
        if kind is not None:
            self.abandon()
            return
        try:
            self.close()
        except BaseException:
            self.abandon()
            raise


class FileWriter(Writer):
    """A writer of a single binary file. Subclasses write to ``file``."""

    def __init__(self, path, header):
        super().__init__(path, header)
        self.part = str(part_of(path))
        self.file = None

    def open_part(self):
        try:
            pathlib.Path(self.part).parent.mkdir(parents=True, exist_ok=True)
            self.file = open_part(self.path)  # closed by close() and abandon()
        except OSError as error:
            self.fail(f"cannot be written: {error.strerror}; choose another folder")

    def keep_part(self):
        """Renames the finished file."""
        keep_part(self.path)

    def abandon(self):
        if self.file is not None and not self.file.closed:
            with contextlib.suppress(OSError):  # error of a full disk, already reported
                self.file.close()
        drop_part(self.path)


class StreamWriter(Writer):
    """A writer by a vtkHeliosStreamWriter, one block per chunk."""

    def __init__(self, path, header, stream):
        super().__init__(path, header)
        self.stream = stream
        self.stream.SetFileName(self.path)

    def store(self, chunk):
        if not self.stream.IsOpen():
            set_unfinished(part_of(self.path))
            call(self, self.stream, self.stream.Open)
        cloud = to_cloud(chunk, self.header)
        call(self, self.stream, lambda: self.stream.Write(cloud))
        self.count += rows_of(chunk)

    def close(self):
        if not self.count:
            self.abandon()
            self.fail("would have no points; change the selection")
        call(self, self.stream, self.finish)
        set_unfinished(part_of(self.path), False)

    def finish(self):
        """Gives the complete file its name."""
        self.stream.Close()

    def abandon(self):
        if self.stream.IsOpen():
            self.stream.Abandon()
        drop_part(self.path)


def find_problem(chunk):
    """Returns the error in the shapes and types of a chunk, or None."""
    points = chunk.get("points")
    shape = np.shape(points)
    if len(shape) != 2 or shape[1] != 3:
        return f"points has the shape {shape}; give an array of (n, 3)"
    for name, values in chunk.items():
        known = isinstance(values, np.ndarray) and values.dtype.str[1:] in NUMBERS
        if not known or not values.dtype.isnative:
            kind = getattr(values, "dtype", type(values).__name__)
            return f"{name} is of the type {kind}; give integers or floats of 8 to 64 bits"
        if values.ndim not in (1, 2) or len(values) != shape[0]:
            return (
                f"{name} has the shape {values.shape}, but there are {shape[0]} points; give one "
                "row per point"
            )
    return None


def rows_of(chunk):
    """Returns the number of points of a chunk."""
    return len(chunk["points"])


def select(chunk, rows):
    """Some points of a chunk: a mask, indices or a slice."""
    return {name: values[rows] for name, values in chunk.items()}


def to_cloud(chunk, header=None):
    """Returns a chunk as vtkPolyData that shares its memory."""
    cloud = vtkPolyData()
    holder = vtkPoints()
    holder.SetData(numpy_to_vtk(np.ascontiguousarray(chunk["points"], np.float64)))
    cloud.SetPoints(holder)
    for name, values in chunk.items():
        if name != "points":
            array = numpy_to_vtk(np.ascontiguousarray(values))
            array.SetName(name)
            cloud.GetPointData().AddArray(array)
    if header is not None:
        cloud.GetFieldData().ShallowCopy(header.fields)
    return cloud


def from_cloud(cloud):
    """vtkPolyData as a chunk that shares its memory."""
    chunk = arrays(cloud)
    if "points" not in chunk:
        chunk["points"] = np.empty((0, 3))
    elif chunk["points"].dtype != np.float64:
        chunk["points"] = chunk["points"].astype(np.float64)
    return chunk


# Messages of a writer of blocks about its .part, which is removed here.
KEPT = re.compile(r"; (?:the first )?\d+ records are safe in .*?(?=; make room)")


def call(owner, vtk_object, action):
    """Returns the result of an action of a VTK object; its errors become FormatErrors of owner.path."""
    with MessageLog() as log:
        log.watch(vtk_object)
        if hasattr(vtk_object, "GetExecutive"):
            log.watch(vtk_object.GetExecutive())
        result = action()
    owner.notes += [note for note in dict.fromkeys(log.warnings) if note not in owner.notes]
    if log.errors:
        message = KEPT.sub("", "; ".join(log.root_errors()))
        raise FormatError(message if owner.path in message else f"{owner.path}: {message}")
    return result


def need(module, what):
    """Imports an optional package, or explains how to get it."""
    try:
        return packages.load(module, f"{what} need")
    except ImportError as error:
        raise FormatError(str(error)) from error
