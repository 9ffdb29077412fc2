# SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
# SPDX-License-Identifier: BSD-3-Clause
"""Intensities of other programs as Intensity, which has 16 bits."""

import numpy as np

from ..array_names import INTENSITY

KEPT = "intensity"  # the array of intensities that 16 bits cannot hold
FULL = 65535
PTS_LOW, PTS_HIGH = -2048, 2047  # range of Leica


class IntensityScale:
    """How the intensities of a file become 16 bits, from all of them: whole numbers in 16 bits are
    kept, fractions up to 1 are times 65535, PTS is raised by 2048 as in PDAL. Others are kept as they
    are, in another array. ``note`` says so.
    """

    def __init__(self, low, high, is_whole, is_pts=False):
        self.offset, self.factor, self.note = 0, 1, ""
        self.name = INTENSITY
        if is_whole and low >= 0 and high <= FULL:
            return
        if low >= 0 and high <= 1:
            self.factor = FULL
            self.note = "intensities from 0 to 1 are scaled to 16 bits"
        elif is_pts and is_whole and low >= PTS_LOW and high <= PTS_HIGH:
            self.offset = -PTS_LOW
            self.note = "intensities from -2048 to 2047 are raised by 2048"
        else:
            self.name = KEPT
            self.note = (
                f"intensities from {low:g} to {high:g} are not whole numbers of 16 bits: "
                f"they are the array {KEPT}"
            )

    @classmethod
    def of(cls, values):
        """Returns the scale of an array of all intensities."""
        finite = values[np.isfinite(values)] if values.dtype.kind == "f" else values
        if not len(finite):
            return cls(0, 0, True)
        return cls(finite.min(), finite.max(), bool((np.rint(finite) == finite).all()))

    def apply(self, chunk, name=INTENSITY):
        """Replaces the intensities of a chunk, in an array of a name; those not finite are 0."""
        values = chunk.pop(name)
        if self.name == INTENSITY:
            scaled = (values.astype(np.float64) + self.offset) * self.factor
            values = np.rint(np.nan_to_num(scaled, nan=0.0, posinf=FULL, neginf=0.0))
            values = values.clip(0, FULL).astype(np.uint16)
        chunk[self.name] = values
