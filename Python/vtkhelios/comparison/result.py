# SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
# SPDX-License-Identifier: BSD-3-Clause
"""Result of compare()."""

import dataclasses
import json
import math

import numpy as np

from ..surveys.accuracy import Estimate
from ..surveys.tradeoff import Table

ROUNDING = 1e-9  # smaller numbers are rounding errors


def contains_zero(estimate):
    """Returns whether 0 is in an interval, but for rounding errors."""
    return estimate.lower <= ROUNDING and estimate.upper >= -ROUNDING


@dataclasses.dataclass
class Row:
    """A metric of both clouds."""

    name: str
    unit: str  #: "" for fractions and counts
    a: Estimate | None  #: of the first cloud; None: the metric is of both at once
    b: Estimate | None
    difference: Estimate  #: b - a; or the value of a metric of both at once
    chance: float | None = None  #: what a distance of histograms exceeds by chance in 5 % of cases
    by_density: bool = False  #: whether the metric changes with the density of a cloud
    of_class: int | None = None  #: None: all points
    note: str = ""

    @property
    def agrees(self):
        """Whether the clouds agree in this metric: 0 is in the interval of the difference, or the
        distance is below chance. None: there is no interval, or it is no comparison."""
        if self.chance is not None:
            return (
                None if math.isnan(self.chance) else self.difference.value <= self.chance + ROUNDING
            )
        if math.isnan(self.difference.lower):
            return None
        return contains_zero(self.difference)

    def as_dict(self):
        """Plain values; ends of intervals with _lower and _upper, None if there are none."""
        row = {"metric": self.name, "unit": self.unit, "class": self.of_class}
        for name in ("a", "b", "difference"):
            values = getattr(self, name) or (None, None, None)
            keys = (name, f"{name}_lower", f"{name}_upper")
            row |= {key: _plain(value) for key, value in zip(keys, values)}
        return row | {
            "chance": _plain(self.chance),
            "agrees": self.agrees,
            "byDensity": self.by_density,
            "note": self.note,
        }


@dataclasses.dataclass
class Histogram:
    """Fractions of the points of both clouds in the same bins."""

    name: str
    unit: str
    edges: np.ndarray  #: one more than fractions
    a: np.ndarray
    b: np.ndarray

    def as_dict(self):
        arrays = {name: getattr(self, name).tolist() for name in ("edges", "a", "b")}
        return {"name": self.name, "unit": self.unit, **arrays}


@dataclasses.dataclass
class Comparison:
    """The metrics of two clouds."""

    a: dict  #: name, points (of the input), compared (points), coordinateSystem
    b: dict
    settings: dict  #: cell_m, tile_m, tiles, commonTiles, sampledShare, seed, draws
    registration: str  #: what is known of a shift between the clouds
    shift: list  #: Estimates of x, y, z of B against A [m], as far as determined; else None
    rows: list
    histograms: list
    absent: list  #: what was not measured, and why
    notes: list

    @property
    def table(self):
        """The metrics as a Table: ``table["metric"]``, ``pandas.DataFrame(table.rows)``."""
        return Table([row.as_dict() for row in self.rows])

    def __getitem__(self, name):
        """Returns the row of a metric of all points, by its name."""
        for row in self.rows:
            if row.name == name and row.of_class is None:
                return row
        why = [text for text in self.absent if text.startswith(name)]
        names = ", ".join(row.name for row in self.rows if row.of_class is None)
        raise KeyError(
            f"not measured: {why[0]}" if why else f"no metric {name}; there are: {names}"
        )

    def _repr_html_(self):
        return self.table._repr_html_()

    def to_dict(self):
        """Returns all results as plain values; numbers that are not known are None."""
        return {
            "a": self.a,
            "b": self.b,
            "settings": self.settings,
            "registration": self.registration,
            "shift_m": [each and [_plain(value) for value in each] for each in self.shift],
            "metrics": [row.as_dict() for row in self.rows],
            "histograms": [each.as_dict() for each in self.histograms],
            "notMeasured": self.absent,
            "notes": self.notes,
        }

    def to_json(self):
        """Returns all results as JSON."""
        return json.dumps(self.to_dict(), indent=2, allow_nan=False)


def _plain(value):
    return None if value is None or not math.isfinite(value) else float(value)
