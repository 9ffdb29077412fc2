# SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
# SPDX-License-Identifier: BSD-3-Clause
"""The fields of the points of an E57 scan: what their numbers mean, by limits, types and flags."""

import numpy as np

from ..array_names import ORGAN_IDS, ORGAN_NAME, SPECIES_IDS, SPECIES_NAME, TREE_IDS

OURS = "vtkHelios, intensity: amplitude [W]"  # prefix of a scan's description
OTHERS = "vtkHelios"  # array of scans whose intensity is no power
DIRECTION_ONLY = 1  # value of cartesianInvalidState: x y z is the pulse direction
FULL = 65535.0  # full scale of intensities and colours

XYZ = ("cartesianX", "cartesianY", "cartesianZ")
POLAR = ("sphericalRange", "sphericalAzimuth", "sphericalElevation")
COLOURS = ("colorRed", "colorGreen", "colorBlue")
STATES = ("cartesianInvalidState", "sphericalInvalidState")
# Flags of values, not of points: the fields that they are about, and their name in a note.
FLAGS = {
    "isIntensityInvalid": (("intensity",), "intensities"),
    "isColorInvalid": (COLOURS, "colours"),
    "isTimeStampInvalid": (("timeStamp",), "time stamps"),
}
KNOWN = {*XYZ, *POLAR, *COLOURS, *STATES, *FLAGS, "intensity", "timeStamp", "returnIndex"}
KNOWN |= {"returnCount"}
# An extension of the standard: the fields of trees, and vectors of texts in the root, by number.
EXTENSION, EXTENSION_URI = "vtkhelios", "urn:vtkhelios:e57:trees:1"
TREES = {
    TREE_IDS: "vtkhelios:treeId",
    SPECIES_IDS: "vtkhelios:speciesId",
    ORGAN_IDS: "vtkhelios:organId",
}
TREE_TYPES = {TREE_IDS: np.int32, SPECIES_IDS: np.int32, ORGAN_IDS: np.uint8}
NAME_NODES = {SPECIES_NAME: "vtkhelios:speciesNames", ORGAN_NAME: "vtkhelios:organNames"}
KNOWN |= set(TREES.values())
UNBOUNDED = 2.0**52  # a range of a type beyond this says nothing


class Range:
    """A range of numbers of a field; low is above high if the numbers are used as they are."""

    def __init__(self, low=0.0, high=-1.0):
        self.low, self.high = float(low), float(high)

    @property
    def is_known(self):
        return self.high > self.low

    def to_unit(self, values):
        """From 0 to 1, and beyond for values outside."""
        with np.errstate(invalid="ignore", over="ignore"):
            return (values - self.low) / (self.high - self.low)


def number_of(node):
    """Returns the value of a node of any kind of number."""
    return float(node.scaledValue() if hasattr(node, "scaledValue") else node.value())


def _bounds(node):
    """Returns the range of a type of numbers."""
    if hasattr(node, "scaledMinimum"):
        return Range(node.scaledMinimum(), node.scaledMaximum())
    return Range(node.minimum(), node.maximum())


def find_range(scan, types, limits, ends, field):
    """Returns the range of a field: of the limits of its scan, else of its type, else unknown."""
    names = [f"{ends}Minimum", f"{ends}Maximum"]
    if scan.isDefined(limits) and all(scan[limits].isDefined(name) for name in names):
        found = Range(*(number_of(scan[limits][name]) for name in names))
        if found.is_known:
            return found
    found = _bounds(types[field])
    return found if found.is_known and found.high - found.low < UNBOUNDED else Range()


def full_colour(largest):
    """Returns the number of full brightness of colours without limits and without a range of their
    type."""
    return next((full for full in (1.0, 255.0, 65535.0) if largest <= full), largest)


def check_flags(data, counts):
    """Sets values that are marked as invalid to 0, and counts them by their name in a note."""
    for flag, (fields, words) in FLAGS.items():
        if flag not in data:
            continue
        bad = data.pop(flag) != 0
        found = [name for name in fields if name in data]
        if found and bad.any():
            counts[words] = counts.get(words, 0) + int(np.count_nonzero(bad))
            for name in found:
                data[name][bad] = 0.0
    return {words for _, words in FLAGS.values() if words in counts}


def rotation_matrix(quaternion):
    """Returns the matrix of a unit quaternion w x y z."""
    w, x, y, z = quaternion
    return np.array(
        [
            [1 - 2 * (y * y + z * z), 2 * (x * y - w * z), 2 * (x * z + w * y)],
            [2 * (x * y + w * z), 1 - 2 * (x * x + z * z), 2 * (y * z - w * x)],
            [2 * (x * z - w * y), 2 * (y * z + w * x), 1 - 2 * (x * x + y * y)],
        ]
    )
