# SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
# SPDX-License-Identifier: BSD-3-Clause
"""Names of arrays as laspy, PDAL and others have them: those that vtkHeliosPointTextReader knows."""

import difflib

from ..array_names import AMPLITUDE, CHANNEL_IDS, INTENSITY, LEG_IDS, RGB, SCAN_ANGLE
from ..core.classes import vtk_class

XYZ = "xyz"  # laspy calls all coordinates so
COORDINATES = "points"

# Arrays whose values are others than those of the name that is given, and how they differ.
UNLIKE = {
    AMPLITUDE: "the received power [W], which no writer has scaled to 16 bits",
    LEG_IDS: "the number of the leg, which is the point source less 1",
    RGB: "red, green and blue from 0 to 1",
    SCAN_ANGLE: "in degrees, not in steps of 0.006 degrees",
}
EXACT = {"scananglerank": SCAN_ANGLE, "scannerchannel": CHANNEL_IDS}


def find_array(name, known):
    """Returns what a name of another program stands for, and its component (None: all of them).

    (COORDINATES, component), (an array, None), or (None, None): none of the known arrays.
    """
    if name.lower() == XYZ:
        return COORDINATES, None
    reader = vtk_class("vtkHeliosPointTextReader")
    array = reader.GetArrayOfColumn(name)
    if array == "":
        return COORDINATES, reader.GetComponentOfColumn(name)
    is_same = array not in UNLIKE or _plain(name) in EXACT
    return (array, None) if array in known and is_same else (None, None)


def explain_missing(name, known, more=()):
    """Why a cloud has no array of a name, with one suggestion, of an array or of more names."""
    array = vtk_class("vtkHeliosPointTextReader").GetArrayOfColumn(name)
    array = AMPLITUDE if array == INTENSITY else array
    if array in known and array in UNLIKE:
        hint = f"it has {array}, {UNLIKE[array]}"
    elif near := difflib.get_close_matches(name, [*known, *more], 1, 0.5):
        hint = f"did you mean {near[0]}?"
    else:
        hint = f"it has: {', '.join(known) or 'none'}"
    return f"the cloud has no array {name}; {hint}"


def _plain(name):
    return name.replace("_", "").lower()
