# SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
# SPDX-License-Identifier: BSD-3-Clause
"""Result of fit()."""

import dataclasses
import json
import math
import typing

import numpy as np

from ..surveys.tradeoff import Table
from ._write import write_fit


@dataclasses.dataclass
class Value:
    """A number of an instrument or a strip."""

    name: str
    unit: str
    value: float | None  #: None: not known
    uncertainty: float | None  #: half width of a 95 % interval; None: none is known
    how: str  #: how it was found; of a value that is not known: why
    strip: int | None = None  #: number of the strip; None: of the instrument
    text: str = ""  #: of a value that is no number, as a kind of mirror

    def as_dict(self):
        """Plain values; what is not known is None."""
        row = dataclasses.asdict(self)
        for name in ("value", "uncertainty"):
            row[name] = plain(row[name])
        return row


class Row(typing.NamedTuple):
    """A row of a table of noise: the range noise of the points of some planes."""

    of: str  #: incidence [deg] or intensity
    lower: float
    upper: float
    cells: int  #: planes
    noise: float  #: standard deviation of ranges [m]
    uncertainty: float  #: half width of a 95 % interval [m]


@dataclasses.dataclass
class Strip:
    """A flight line. Positions in the coordinates of the cloud, in metres."""

    number: int
    source: int | None  #: LegIds of its points: the point source id of LAS files
    points: int
    pulses: int  #: with a point
    times: np.ndarray  #: of the trajectory [s], as GpsTime
    positions: np.ndarray  #: (n, 3) [m]
    angles: np.ndarray  #: roll, pitch, yaw (n, 3) [deg], by ARINC 705 (Docs/trajectories.md)
    method: str  #: how the trajectory was recovered

    def as_dict(self):
        """Plain values, without the trajectory."""
        names = ("number", "source", "points", "pulses", "method")
        row = {name: getattr(self, name) for name in names}
        return row | {"start_s": float(self.times[0]), "end_s": float(self.times[-1])}


@dataclasses.dataclass
class Fit:
    """Findings about an instrument and its flight from a cloud."""

    name: str
    crs: str  #: coordinate system of the cloud, empty: unknown
    ground: float  #: median height of the last returns [m]
    box: np.ndarray  #: low and high corner of the points (2, 3) [m]
    values: list  #: Values of the instrument, then of the strips
    noise: list  #: Rows
    strips: list
    notes: list

    @property
    def table(self):
        """The values as a Table: ``table["name"]``, ``pandas.DataFrame(table.rows)``."""
        return Table([value.as_dict() for value in self.values])

    def __getitem__(self, name):
        """Returns the Value of the instrument with a name."""
        return self.of_strip(name, None)

    def of_strip(self, name, strip):
        """Returns the Value of a strip by its name; raises KeyError for an unknown name."""
        for value in self.values:
            if value.name == name and value.strip == strip:
                return value
        names = ", ".join(value.name for value in self.values if value.strip == strip)
        raise KeyError(f"no value {name}; there are: {names}")

    def write(self, folder, scene=None):
        """Writes scanner.xml, survey.xml and the trajectories as CSV, and returns their paths.

        folder
            is created if it does not exist; its files of these names are replaced.
        scene
            of the survey: "file.xml#id". Default: a level plane at the height of the ground, which
            is written, too.

        Raises OSError if a file cannot be written.
        """
        return write_fit(self, folder, scene)

    def _repr_html_(self):
        return self.table._repr_html_()

    def to_dict(self):
        """Returns all results as plain values; numbers that are not known are None."""
        return {
            "name": self.name,
            "coordinateSystem": self.crs,
            "ground_m": self.ground,
            "values": [value.as_dict() for value in self.values],
            "noise": [row._asdict() for row in self.noise],
            "strips": [strip.as_dict() for strip in self.strips],
            "notes": self.notes,
        }

    def to_json(self):
        """Returns all results as JSON."""
        return json.dumps(self.to_dict(), indent=2, allow_nan=False)


def plain(value):
    """A number that JSON has, or None."""
    return None if value is None or not math.isfinite(value) else float(value)
