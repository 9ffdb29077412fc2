# SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
# SPDX-License-Identifier: BSD-3-Clause
"""Possible outcomes of a case, and the checks of accepted data."""

import numpy as np
from vtkmodules.util.numpy_support import vtk_to_numpy

ALLOWED = ("accepted", "refused")
FAILURES = ("crash", "hang", "traceback", "silent", "memory")

# Array names: full range of valid values.
RANGES = {
    "ReturnNumber": (0, 255),
    "NumberOfReturns": (0, 255),
    "ClassificationIds": (-(2**31), 2**31 - 1),
    "Hit": (0, 1),
}


class Refused(Exception):
    """The reader rejected the file: its message."""


class Silent(AssertionError):
    """A reader accepted a file with output that is wrong, incomplete or without a reason."""


def check(condition, message):
    if not condition:
        raise Silent(message)


def check_count(found, expected, warned, what="records"):
    """Equal to an independent count, unless a warning explains it."""
    if expected is not None and not warned:
        check(found == expected, f"{found} of {expected} {what}, and no warning")


def check_finite(name, values):
    values = np.asarray(values)
    if values.dtype.kind == "f" and not np.isfinite(values).all():
        row = int(np.argmin(np.isfinite(values.reshape(len(values), -1)).all(axis=1)))
        raise Silent(f"{name} of record {row} is {values[row]}, not finite")


def check_chunk(chunk, may_be_invalid=("Deviation",)):
    """Point arrays: of equal length, finite, in their ranges. An echo without a fit has no Deviation."""
    count = len(chunk["points"])
    for name, values in chunk.items():
        check(len(values) == count, f"{name} has {len(values)} rows for {count} points")
        if name not in may_be_invalid:
            check_finite(name, values)
        low, high = RANGES.get(name, (None, None))
        if low is not None and count:
            check(values.min() >= low and values.max() <= high, f"{name} is out of range")
    return count


def check_polydata(data):
    """Points finite, cell ids within bounds, arrays of equal length. Returns the cells."""
    points = data.GetPoints()
    count = data.GetNumberOfPoints()
    if points is not None:
        check_finite("points", vtk_to_numpy(points.GetData()))
    for kind in ("Verts", "Lines", "Polys", "Strips"):
        cells = getattr(data, f"Get{kind}")()
        if cells.GetNumberOfCells():
            ids = vtk_to_numpy(cells.GetConnectivityArray())
            check(
                len(ids) == 0 or (ids.min() >= 0 and ids.max() < count),
                f"{kind}: ids out of bounds",
            )
    check_fields(data.GetPointData(), count)
    check_fields(data.GetCellData(), data.GetNumberOfCells())
    return data.GetNumberOfCells()


def check_fields(fields, count):
    for index in range(fields.GetNumberOfArrays()):
        array = fields.GetArray(index)
        if array is None:
            continue
        name = array.GetName()
        check(
            array.GetNumberOfTuples() == count,
            f"{name} has {array.GetNumberOfTuples()} rows for {count}",
        )
        if count:
            check_finite(name, vtk_to_numpy(array))


def plain_lines(data, comments=(b"#", b"//")):
    """Non-empty lines without comments; None if ambiguous."""
    if b"\0" in data or b"\r" in data.replace(b"\r\n", b"\n") or not data.isascii():
        return None
    lines = []
    for line in data.split(b"\n"):
        for mark in comments:
            line = line.split(mark)[0]
        if line.strip():
            lines.append(line)
    return lines
