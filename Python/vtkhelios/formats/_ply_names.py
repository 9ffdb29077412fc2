# SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
# SPDX-License-Identifier: BSD-3-Clause
"""The properties of PLY files of other programs as arrays, and text in ASCII for headers."""

import numpy as np

from ..array_names import (
    CHANNEL_IDS, CLASSIFICATION_FLAGS, CLASSIFICATION_IDS, EDGE_OF_FLIGHT_LINE, INTENSITY,
    NEAR_INFRARED, NORMALS, NUMBER_OF_RETURNS, RETURN_NUMBER, RGB, SCAN_DIRECTION_FLAG, USER_DATA,
)  # fmt: skip
from ..core.classes import vtk_class
from ._base import SCALARS
from ._intensity import IntensityScale

# Integers, which CloudCompare stores as floats.
WHOLE = {
    CLASSIFICATION_IDS: np.int32, CHANNEL_IDS: np.int32, NEAR_INFRARED: np.uint16,
    **dict.fromkeys((RETURN_NUMBER, NUMBER_OF_RETURNS, SCAN_DIRECTION_FLAG, EDGE_OF_FLIGHT_LINE,
                     USER_DATA, CLASSIFICATION_FLAGS), np.uint8),
}  # fmt: skip


def _find(name):
    """The array that a property is, and the component of it; None: not known."""
    finder = vtk_class("vtkHeliosPointTextReader")
    if name.lower().startswith("pointsource"):  # counts from 1: an array of its own
        return None, 0
    return finder.GetArrayOfColumn(name), finder.GetComponentOfColumn(name)


class PlyNames:
    """``kinds``: the types of the properties by name."""

    def __init__(self, kinds):
        self._kinds = kinds
        self.normals = self._find_three(NORMALS)
        self.colours = self._find_three(RGB)
        self.scalars = self._find_scalars()
        self._ranges = {}

    def _find_three(self, array):
        found = {}
        for name in self._kinds:
            target, component = _find(name)
            if target == array and name[-1] not in "XYZ":  # these are arrays of three components
                found.setdefault(component, name)
        return [found[k] for k in range(3)] if len(found) == 3 else []

    def _find_scalars(self):
        """Property to array, where these differ."""
        found = {}
        for name in self._kinds:
            target, _ = _find(name)
            if target in SCALARS and target not in (*self._kinds, *found.values()):
                found[name] = target
        return found

    def wants_scale(self, name):
        """Returns whether a property is intensities that are not of 8 or 16 bits."""
        return self.scalars.get(name) == INTENSITY and self._kinds[name] not in ("u1", "u2")

    def wanted(self):
        """Returns the properties whose range over the whole file decides on their type or scale."""
        names = [name for name, target in self.scalars.items() if self.wants_scale(name)
                 or (target in WHOLE and self._kinds[name][0] == "f")]  # fmt: skip
        names += [name for name in self.colours if self._kinds[name] not in ("u1", "u2")]
        return names

    def add_range(self, name, values):
        """Extends the range of a property by the values in a part of the file."""
        values = values[np.isfinite(values)]
        if len(values):
            low, high, whole = self._ranges.get(name, (np.inf, -np.inf, True))
            whole = whole and bool((np.rint(values) == values).all())
            self._ranges[name] = min(low, values.min()), max(high, values.max()), whole

    def scale(self, name):
        """Returns the scale of intensities."""
        return IntensityScale(*self._ranges.get(name, (0, 0, True)))

    def full_colour(self):
        """Returns the value of full colour."""
        kind = self._kinds[self.colours[0]]
        if kind in ("u1", "u2"):
            return np.iinfo(kind).max
        high = max(self._ranges.get(name, (0, 0, True))[1] for name in self.colours)
        return 1 if kind[0] == "f" and high <= 1 else 255 if high <= 255 else 65535

    def convert(self, name, values):
        """Returns an array with its name, from a property: floats that are whole numbers as
        integers."""
        target = self.scalars.get(name, name)
        if target not in WHOLE or values.dtype.kind != "f":
            return target, values
        low, high, whole = self._ranges.get(name, (0, 0, True))
        limits = np.iinfo(WHOLE[target])
        if not whole or low < limits.min or high > limits.max or not np.isfinite(values).all():
            return name, values
        return target, values.astype(WHOLE[target])


def to_ascii(text):
    """ASCII without backslashes: other characters as \\u and four digits, as in the headers of PCD."""
    units = text.encode("utf-16-be", "surrogatepass")
    codes = [256 * units[k] + units[k + 1] for k in range(0, len(units), 2)]
    return "".join(chr(c) if c < 128 and c != 92 else f"\\u{c:04x}" for c in codes)
