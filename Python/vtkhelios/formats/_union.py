# SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
# SPDX-License-Identifier: BSD-3-Clause
"""Clouds with unlike arrays as one: every array of any of them, with values where one has none."""

import numpy as np

from ..array_names import (
    CELL_IDS, GPS_TIME, LEG_IDS, MATERIAL_IDS, NUMBER_OF_RETURNS, PART_IDS, PULSE_IDS,
    RETURN_NUMBER, RGB, SCAN_ANGLE, SPECIES_IDS, TREE_IDS, WAVEFORM_IDS,
)  # fmt: skip
from ._base import FormatError, rows_of

# Values of points without an array; of other arrays NaN, or 0 for integers.
MISSING = {RETURN_NUMBER: 1, NUMBER_OF_RETURNS: 1, GPS_TIME: 0, RGB: 0, SCAN_ANGLE: 0}
_IDS = (PULSE_IDS, LEG_IDS, PART_IDS, MATERIAL_IDS, CELL_IDS, WAVEFORM_IDS, SPECIES_IDS, TREE_IDS)
MISSING |= dict.fromkeys(_IDS, -1)


def layout_of(chunk):
    """Returns the arrays of a chunk: name to type and number of components, 0 for plain numbers."""
    return {
        name: (values.dtype, values.shape[1] if values.ndim == 2 else 0)
        for name, values in chunk.items()
    }


def missing_value(name, dtype, number=np.nan):
    """Returns the value of points without this array; a number for arrays of floats."""
    value = MISSING.get(name, number if dtype.kind == "f" else 0)
    return value if dtype.kind != "u" or value >= 0 else 0


def join_layouts(layouts):
    """Returns the union of pairs of a file (or scan) and its layout. FormatError if components
    differ."""
    union, owners = {}, {}
    for owner, layout in layouts:
        for name, (dtype, components) in layout.items():
            known, expected = union.get(name, (dtype, components))
            if components != expected:
                raise FormatError(
                    f"{owner}: {name} has {components or 1} values per point, and {expected or 1} "
                    f"in {owners[name]}; give the array another name in one of them"
                )
            union[name] = _common_type(known, dtype), components
            owners.setdefault(name, owner)
    return union


def _common_type(one, other):
    if one == other:
        return one
    if one.kind in "iu" and other.kind in "iu":
        common = np.result_type(one, other)  # float64 of int64 and uint64
        return common if common.kind in "iu" else np.dtype(np.int64)
    return np.result_type(one, other)


def fill(chunk, union, number=np.nan):
    """Returns a chunk with all arrays of a union, in its order."""
    count = rows_of(chunk)
    filled = {}
    for name, (dtype, components) in union.items():
        values = chunk.get(name)
        if values is None:
            shape = (count, components) if components else count
            filled[name] = np.full(shape, missing_value(name, dtype, number), dtype)
        elif name == RGB and values.dtype.kind in "iu" and dtype.kind == "f":
            filled[name] = (values / np.iinfo(values.dtype).max).astype(dtype)
        else:
            filled[name] = values.astype(dtype, copy=False)
    return filled


def explain_missing(owner, layout, union, number=np.nan):
    """A note on the arrays that a file (or scan) does not have, or None."""
    values = {}
    for name in sorted(union.keys() - layout.keys()):
        value = missing_value(name, union[name][0], number)
        values.setdefault("NaN" if value != value else f"{value:g}", []).append(name)
    if not values:
        return None
    words = "; ".join(f"{value} for {', '.join(names)}" for value, names in values.items())
    return f"{owner}: has not all arrays of the others; its points get {words}"
