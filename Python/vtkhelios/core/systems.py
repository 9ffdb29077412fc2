# SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
# SPDX-License-Identifier: BSD-3-Clause
"""Coordinate systems: identity, units and metres, by vtkHeliosCoordinateSystem."""

import dataclasses
import functools

import numpy as np

from .classes import vtk_class
from .paths import text_from_vtk, to_vtk

HEIGHT_UNITS = {"m": 1.0, "ft": 0.3048, "us-ft": 1200 / 3937}
LONGEST = 60  # length of a text in messages


@dataclasses.dataclass(frozen=True)
class System:
    """A text and what it means; an unknown one has metres."""

    text: str
    problem: str = ""  # why it is not known
    code: str = ""  # EPSG:25832+7837
    short: str = ""  # the code, or the begin of the name
    name: str = ""  # code and name
    unit: float = 1.0  # unit of x and y [m]; 0: degrees
    height_unit: float = 1.0  # [m]
    has_height_unit: bool = False  # whether the system states it
    unit_name: str = ""
    resolution: tuple = (1e-4, 1e-4, 1e-4)  # steps of stored coordinates, in their units

    @property
    def is_known(self):
        return bool(self.name)

    @property
    def is_geographic(self):
        return self.unit == 0

    @property
    def label(self):
        """The code, or the begin of the name, for messages; "none" without a text."""
        shown = self.short or " ".join(self.text.split())
        return (shown if len(shown) <= LONGEST else f"{shown[:LONGEST]}...") or "none"

    def is_same(self, text):
        """Returns whether another text defines the same system; none is the same as none only."""
        if not self.text or not text or self.text == text:
            return self.text == text
        return self.is_known and _make(self.text).IsSame(to_vtk(text))

    def with_height_unit(self, metres):
        """Returns the text of the same map with heights in a unit [m]; ValueError for a local
        system."""
        system = _make(self.text)
        if not system.SetHeightUnit(metres):
            raise ValueError(f"heights of {self.label} have a fixed unit")
        return text_from_vtk(system.GetText())

    def find_metric(self, point):
        """Returns the code of the UTM zone of a point; empty if the point is not on the Earth."""
        return text_from_vtk(_make(self.text).FindMetric(*(float(value) for value in point)))


def _make(text):
    system = vtk_class("vtkHeliosCoordinateSystem")()
    system.SetText(to_vtk(text))
    return system


@functools.lru_cache(maxsize=64)
def find_system(text):
    """Returns the System of a text: EPSG:n, WKT ...; of an empty one an unknown system."""
    if not text:
        return System("")
    system = _make(text)
    if problem := text_from_vtk(system.GetProblem()):
        return System(text, problem)
    return System(
        text, "", text_from_vtk(system.GetCode()), text_from_vtk(system.GetLabel()),
        text_from_vtk(system.GetName()), system.GetUnit(), system.GetHeightUnit(),
        system.HasHeightUnit(), text_from_vtk(system.GetUnitName()),
        tuple(system.GetResolution(axis) for axis in range(3)),
    )  # fmt: skip


def find_difference(first, second):
    """How two known coordinate systems differ, with the cure, or None."""
    one, other = find_system(first or ""), find_system(second or "")
    if not one.is_known or not other.is_known or one.is_same(second):
        return None
    cure = f"--crs {one.code}" if one.code else "--crs"
    return f"{one.label} and {other.label}; convert one of them with vtkhelios convert {cure}"


class Metres:
    """Factors of x, y and z to metres, a note if they are not 1, and whether z is a guess."""

    def __init__(self, crs, height_unit=None):
        """height_unit: of z [m], in place of what the system states."""
        system = find_system(crs or "")
        vertical = height_unit or system.height_unit
        self.factors = np.array([system.unit, system.unit, vertical])
        self.is_geographic = system.is_geographic
        self.is_identity = bool((self.factors == 1).all())
        self.note = self.guess = ""
        if not self.is_identity and not self.is_geographic:
            heights = "" if vertical == system.unit else f", heights of {vertical:.9g} m"
            if not system.has_height_unit and height_unit is None:
                self.guess = (
                    "the unit of heights is not stated, and is taken to be that of x and y; if it "
                    "is not, give --height-unit (height_unit)"
                )
            self.note = (
                f"coordinates have units of {system.unit:.9g} m{heights}; they are converted to "
                f"metres{self.guess and '; '}{self.guess}"
            )
        self._system = system

    def refuse_degrees(self, point):
        """Why lengths of points in degrees are not measured, with the cure; None if they are."""
        if not self.is_geographic:
            return None
        zone = self._system.find_metric(point) or "a map projection"
        return (
            f"its coordinates are longitudes and latitudes ({self._system.label}); convert it "
            f"first: vtkhelios convert --crs {zone}"
        )

    def convert(self, points):
        """Returns the points (n, 3) in metres; the array itself if they are."""
        return points if self.is_identity else points * self.factors
