# SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
# SPDX-License-Identifier: BSD-3-Clause
"""Intensities of points from 0 to 1, on one scale in all scans of a run."""

import numpy as np

from ..array_names import AMPLITUDE, INTENSITY, RANGE, REFLECTANCE

SAMPLE = 1_000_000  # points that the scale is from


class IntensityScale:
    """The reflectance where stored, else the amplitude corrected for the range.

    The latter is relative to the 99th percentile of the run, as the gain of a receiver would be;
    without ranges it is the amplitude, or the intensity of 16 bits.
    """

    def __init__(self, full=1.0):
        self.full = full  # corrected amplitude of intensity 1

    @classmethod
    def measure(cls, reader):
        """Returns the scale of a run: reads its points, unless it does not need one."""
        step, found = max(1, reader.count // SAMPLE), []
        for chunk in reader.chunks():
            if REFLECTANCE in chunk or AMPLITUDE not in chunk:
                return cls()
            found.append(_correct(chunk)[::step])
        values = np.concatenate(found) if found else np.zeros(0)
        return cls((np.percentile(values, 99) if len(values) else 1.0) or 1.0)

    def find(self, arrays):
        """Returns the intensity of each point, float32."""
        if REFLECTANCE in arrays:
            return np.clip(10.0 ** (arrays[REFLECTANCE] / 10.0), 0, 1).astype(np.float32)
        if AMPLITUDE in arrays:
            return np.clip(_correct(arrays) / self.full, 0, 1).astype(np.float32)
        full = np.asarray(arrays.get(INTENSITY, np.zeros(len(arrays["points"]))), float)
        return (full / 65535).astype(np.float32)


def _correct(arrays):
    """Returns the amplitudes as of targets at 1 m."""
    return arrays[AMPLITUDE] * arrays.get(RANGE, 1.0) ** 2
