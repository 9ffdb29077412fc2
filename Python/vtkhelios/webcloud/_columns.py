# SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
# SPDX-License-Identifier: BSD-3-Clause
"""The arrays of a cloud as columns of a page: codes, kind of colouring, range, categories."""

import dataclasses

import numpy as np

from ..array_names import (
    CHANNEL_IDS, CLASSIFICATION_IDS, CLUSTER_IDS, LEG_IDS, MATERIAL_IDS, NUMBER_OF_RETURNS,
    PART_IDS, PLANE_IDS, PULSE_IDS, RETURN_NUMBER, RGB, UNITS, WAVEFORM_IDS,
)  # fmt: skip
from ..formats._classes import CLASSES
from ._quantise import Codes, quantise

CATEGORIES = {
    CHANNEL_IDS, CLASSIFICATION_IDS, CLUSTER_IDS, LEG_IDS, MATERIAL_IDS, NUMBER_OF_RETURNS,
    PART_IDS, PLANE_IDS, RETURN_NUMBER,
}  # fmt: skip
FEW = 8  # other whole numbers with at most this many values are categories, too
MAXIMUM_CATEGORIES = 4096
OUTER = 0.02  # fraction of points beyond either end of the colour scale
DECADES = 2.0  # positive ranges of more are on a logarithmic scale
SKIPPED = {"points", "index", WAVEFORM_IDS}  # WaveformIds repeat PulseIds
MAXIMUM_COMPONENTS = 4


@dataclasses.dataclass
class Column:
    """An array with one value per point."""

    name: str
    codes: Codes
    role: str  # continuous, category or colour
    unit: str = ""
    limits: tuple = (0.0, 0.0)  # limits of the colour scale
    extremes: tuple = (0.0, 0.0)
    is_logarithmic: bool = False
    categories: list = dataclasses.field(default_factory=list)  # [value, label, points]

    def describe(self):
        """For JSON."""
        return {
            "name": self.name, "unit": self.unit, "role": self.role, **self.codes.describe(),
            "limits": self.limits, "extremes": self.extremes, "log": self.is_logarithmic,
            "categories": self.categories,
        }  # fmt: skip


def make_columns(arrays, names=None):
    """The columns of a dict of arrays; without those of more than MAXIMUM_COMPONENTS components.

    names are the texts of the numbers in an array, by its name: "0" is the first.
    """
    names = names or {}
    columns = []
    for name, values in arrays.items():
        if name in SKIPPED:
            continue
        if values.ndim == 1:
            columns.append(_make(name, values, UNITS.get(name, ""), names.get(name, ())))
        elif values.shape[1] == 3 and name.upper() == RGB:
            columns.append(Column(name, quantise(_pack_colours(values)), "colour"))
        elif values.shape[1] <= MAXIMUM_COMPONENTS:
            columns += [
                _make(label, part, UNITS.get(name, ""), ()) for label, part in _split(name, values)
            ]
    return columns


def make_scale(values):
    """Returns the limits, the extremes and whether the scale is logarithmic, of an array."""
    values = values[np.isfinite(values)].astype(np.float64)
    if len(values) == 0:
        return (0.0, 1.0), (0.0, 1.0), False
    low, high = (float(x) for x in np.quantile(values, [OUTER, 1 - OUTER]))
    extremes = float(values.min()), float(values.max())
    if low == high:
        low, high = extremes
    is_logarithmic = low > 0 and high / low > 10**DECADES
    return (low, high), extremes, bool(is_logarithmic)


def _make(name, values, unit, texts):
    if values.dtype.kind in "iub" and (categories := _categories(name, values, texts)):
        return Column(name, quantise(values), "category", unit, categories=categories)
    limits, extremes, is_logarithmic = make_scale(values)
    is_logarithmic &= values.dtype.kind == "f"
    return Column(
        name, quantise(values, unit), "continuous", unit, limits, extremes, is_logarithmic
    )


def _categories(name, values, texts):
    """Value, label and number of points of each; empty: not categories."""
    most = MAXIMUM_CATEGORIES if name in CATEGORIES else FEW
    if name == PULSE_IDS:
        return []
    found, counts = np.unique(values, return_counts=True)
    if len(found) > most:
        return []
    return [[int(v), _label(name, int(v), texts), int(n)] for v, n in zip(found, counts)]


def _label(name, value, texts):
    if name == CLASSIFICATION_IDS:
        return f"{value} {CLASSES.get(value, '')}".strip()
    if 0 <= value < len(texts) and texts[value] not in ("", str(value)):
        return f"{value} {texts[value]}"
    return str(value)


def _pack_colours(values):
    """Red, green and blue as one number; floats are fractions, whole numbers of their type's range."""
    full = np.iinfo(values.dtype).max if values.dtype.kind in "iu" else 1.0
    parts = np.rint(255 * np.clip(np.nan_to_num(values / full), 0, 1)).astype(np.int64)
    return parts @ np.array([65536, 256, 1])


def _split(name, values):
    axes = "xyz" if values.shape[1] == 3 else [str(i) for i in range(values.shape[1])]
    return [(f"{name}.{axis}", values[:, i]) for i, axis in enumerate(axes)]
