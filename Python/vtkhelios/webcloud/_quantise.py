# SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
# SPDX-License-Identifier: BSD-3-Clause
"""Values as whole numbers: positions and arrays in steps of a power of ten."""

import dataclasses

import numpy as np

POSITION_STEP = 1e-4  # [m]
FINEST_STEP = 1e-9  # [m]
MAXIMUM_STEPS = 2**31  # along an axis
# steps of float arrays, by unit
STEPS = {"m": 1e-4, "s": 1e-7, "deg": 1e-4, "ns": 1e-4, "dB": 1e-3}
MAXIMUM_CODES = 2**52  # exact in JavaScript
MANTISSA = 8  # bits of a float32 that are dropped: relative error below 1.6e-5


@dataclasses.dataclass
class Codes:
    """Whole numbers from 0 (int64), and how they are decoded.

    kind "fixed": (base + code) * step, or (base + code) / round(1 / step) for steps below 1;
    kind "float": the bits of a float32 without the lowest 8. Code ``missing``, if set, is NaN.
    """

    values: np.ndarray
    kind: str
    base: int = 0
    step: float = 1.0
    missing: int | None = None

    def describe(self):
        """For JSON."""
        return {"kind": self.kind, "base": self.base, "step": self.step, "missing": self.missing}


def position_step(points):
    """Returns a power of ten [m]: 0.1 mm, less for clouds below 10 m, more for those beyond 200
    km."""
    extent = float(np.ptp(points, axis=0).max()) if len(points) else 0.0
    largest = float(np.abs(points).max()) if len(points) else 0.0
    step = POSITION_STEP
    while extent / step > MAXIMUM_STEPS or largest / step > MAXIMUM_CODES:
        step *= 10
    while (
        0 < extent / step < 1e5 and 10 * largest / step < MAXIMUM_CODES and step > 2 * FINEST_STEP
    ):
        step /= 10
    return float(f"{step:.0e}")


def quantise_points(points, step):
    """Steps from the lowest corner (n x 3), and this corner in steps from 0."""
    steps = _in_steps(points, step)
    corner = steps.min(axis=0) if len(steps) else np.zeros(3, np.int64)
    return steps - corner, [int(value) for value in corner]


def quantise(values, unit=None):
    """Returns the Codes of an array of numbers."""
    if values.dtype.kind in "iub":
        low, high = (int(values.min()), int(values.max())) if len(values) else (0, 0)
        if high - low < MAXIMUM_CODES and max(abs(low), abs(high)) < MAXIMUM_CODES:
            return Codes(values.astype(np.int64) - low, "fixed", base=low)
        return _as_float(values)
    step = STEPS.get(unit)
    return _as_float(values) if step is None else _as_fixed(values, step)


def _in_steps(values, step):
    """Whole numbers of steps; a division by the inverse is exact for decimals."""
    inverse = round(1 / step) if step < 1 else None
    return np.rint(values * inverse if inverse else values / step).astype(np.int64)


def _as_fixed(values, step):
    values = values.astype(np.float64)
    finite = np.isfinite(values)
    if not finite.all() and not np.isnan(values[~finite]).all():
        return _as_float(values)
    low, high = (values[finite].min(), values[finite].max()) if finite.any() else (0.0, 0.0)
    if max(abs(low), abs(high)) / step >= MAXIMUM_CODES:
        return _as_float(values)
    steps = _in_steps(np.where(finite, values, low), step)
    base = int(steps.min()) if len(steps) else 0
    if finite.all():
        return Codes(steps - base, "fixed", base, step)
    return Codes(np.where(finite, steps - base + 1, 0), "fixed", base - 1, step, missing=0)


def _as_float(values):
    with np.errstate(over="ignore"):
        bits = np.ascontiguousarray(values, np.float32).view(np.uint32).astype(np.int64)
    half = 1 << (MANTISSA - 1)
    ordinary = (bits & 0x7F800000) != 0x7F800000  # rounding must not change inf and NaN
    return Codes(
        np.where(ordinary, bits + half, bits | (1 << 22) * np.isnan(values)) >> MANTISSA, "float"
    )
