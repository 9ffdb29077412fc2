# SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
# SPDX-License-Identifier: BSD-3-Clause
"""Legs and parts of a survey as lists: read, changed, added and removed.

>>> survey.legs[0].scan_frequency = 50
>>> survey.parts.append("car.obj", dmotion={"loop": 0, "motion": {"type": "translation", "vec": (0.1, 0, 0)}})
"""

import collections.abc
import difflib
import functools
import os
import typing

from ..core.classes import vtk_class
from ..core.paths import text_from_vtk, to_vtk
from ..core.pipeline import MessageLog, PipelineError, conclude
from ..core.words import no_attribute

if typing.TYPE_CHECKING:  # dictionaries of keywords, made by Python/make_stubs.py
    from .keywords import LegAttributes, LegSettings

__all__ = ["SETTINGS", "Leg", "Legs", "Part", "Parts", "leg_values"]

# Settings of a leg, and their attributes in surveys (Docs/dialect.md); a pair of values has two.
SETTINGS = {
    "speed": "movePerSec_m",
    "stop_and_turn": "stopAndTurn",
    "smooth_turn": "smoothTurn",
    "yaw_at_departure": "yawAtDeparture_deg",
    "active": "active",
    "pulse_frequency": "pulseFreq_hz",
    "scan_frequency": "scanFreq_hz",
    "scan_angle": "scanAngle_deg",
    "vertical": ("verticalAngleMin_deg", "verticalAngleMax_deg"),
    "head": ("headRotateStart_deg", "headRotateStop_deg"),
    "head_speed": "headRotatePerSec_deg",
    "beam_divergence": "beamDivergence_rad",
    "duration": "maxDuration_s",
    "vertical_resolution": "verticalResolution_deg",
    "horizontal_resolution": "horizontalResolution_deg",
}


def change(survey, method, *arguments):
    """Calls a method of a vtkHeliosSurvey that returns whether it succeeded; raises PipelineError."""
    with MessageLog() as log:
        log.watch(survey)
        succeeded = getattr(survey, method)(*arguments)
    conclude(log)
    if succeeded is False or succeeded == -1:
        raise PipelineError([f"{method}{arguments}: is not valid"])
    return succeeded


@functools.cache
def attributes(kind):
    """The names of all attributes of a kind that have one value."""
    cls = vtk_class("vtkHeliosSurvey")
    return tuple(cls.GetAttributeName(kind, i) for i in range(cls.GetNumberOfAttributes(kind)))


def text_of(value):
    """A value as the text of an attribute; None removes it."""
    if value is None:
        return ""
    if isinstance(value, (str, os.PathLike)):
        return to_vtk(value)
    if isinstance(value, bool):
        return "true" if value else "false"
    if isinstance(value, int):
        return str(value)
    if hasattr(value, "__len__"):
        return ";".join(text_of(number) for number in value)
    return repr(float(value))


def value_of(text):
    """The text of an attribute as a number, a boolean or text; None: not given."""
    if text in ("true", "false"):
        return text == "true"
    try:
        return float(text)
    except ValueError:
        return text_from_vtk(text) or None


def paths_of(values, prefix=""):
    """Pairs of path and value; a dictionary is an element, and a list of them are several."""
    for name, value in values.items():
        if hasattr(value, "items"):
            yield from paths_of(value, f"{prefix}{name}/")
        elif isinstance(value, (list, tuple)) and value and hasattr(value[0], "items"):
            for index, one in enumerate(value):
                yield from paths_of(one, f"{prefix}{name}[{index}]/")
        else:
            yield prefix + name, value


def refuse(name, known, what):
    """Raises AttributeError for an unknown name, with the nearest one."""
    near = difflib.get_close_matches(name, known, 1, 0.6)
    hint = f"did you mean {near[0]}?" if near else f"known: {', '.join(known)}"
    raise no_attribute(None, name, f"{name} is not an attribute of {what}; {hint}")


def leg_values(settings, flies=False):
    """The attributes of a leg and their values; one that follows a trajectory has no position."""
    leg = dict(settings)
    if flies == ("position" in leg):
        raise TypeError(
            "a leg has a position, but the trajectory gives it; leave it out"
            if flies
            else "a leg has no position; give x, y, or x, y, z"
        )
    values = {} if flies else _position_values(leg.pop("position"))
    for name, value in leg.items():
        if name not in SETTINGS and name not in attributes("leg"):
            names = ", ".join(["position", *SETTINGS])
            raise TypeError(f"{name} is not a setting of a leg; known: {names}")
        values.update(_setting_values(name, value))
    return {"onGround": False, **values}


def _position_values(position):
    position = tuple(position)
    if len(position) not in (2, 3):
        raise ValueError(f"position is {position!r}; give x, y, or x, y, z")
    return dict(zip("xyz", position), onGround=len(position) == 2)


def _setting_values(name, value):
    target = SETTINGS.get(name, name)
    if not isinstance(target, tuple):
        return {target: value}
    low, high = value
    return dict(zip(target, (low, high)))


class Leg:
    """A leg of a survey: its settings are attributes that can be set.

    Names are those of make_survey() (scan_frequency, head, speed ...) or of platformSettings and
    scannerSettings in Docs/dialect.md; None restores the default. An unknown name is an error.
    position [m] and on_ground say where it is (z is not yet on the ground if on_ground); active is
    whether it fires pulses; pulse_frequency and scan_frequency [Hz] are those of the scan, within the
    limits of the scanner. Others are as given, and None if they are not.
    """

    __slots__ = ("_vtk", "index")

    def __init__(self, vtk_survey, index):
        object.__setattr__(self, "_vtk", vtk_survey)
        object.__setattr__(self, "index", index)

    @property
    def position(self):
        position = [0.0, 0.0, 0.0]
        self._vtk.GetLegPosition(self.index, position)
        return tuple(position)

    @property
    def on_ground(self):
        return self._vtk.IsLegOnGround(self.index)

    @property
    def active(self):
        return self._vtk.IsLegActive(self.index)

    @property
    def pulse_frequency(self):
        return self._vtk.GetLegPulseFrequency(self.index)

    @property
    def scan_frequency(self):
        return self._vtk.GetLegScanFrequency(self.index)

    def __getattr__(self, name):
        target = SETTINGS.get(name, name)
        if isinstance(target, tuple):
            return tuple(getattr(self, each) for each in target)
        if target not in attributes("leg"):
            refuse(name, self._names(), "a leg")
        return value_of(self._vtk.GetLegAttribute(self.index, target))

    def __setattr__(self, name, value):
        if name == "position":
            values = _position_values(value)
        elif name == "on_ground":
            values = {"onGround": value}
        elif name in SETTINGS or name in attributes("leg"):
            values = _setting_values(
                name, (None, None) if value is None and name in ("vertical", "head") else value
            )
        else:
            refuse(name, self._names(), "a leg")
        for attribute, each in values.items():
            change(self._vtk, "SetLegAttribute", self.index, attribute, text_of(each))

    @staticmethod
    def _names():
        return ["position", "on_ground", *SETTINGS, *attributes("leg")]

    def __repr__(self):
        x, y, z = self.position
        return (
            f"Leg({self.index}: {x:g}, {y:g}, {z:g} m{', on the ground' if self.on_ground else ''})"
        )


class Part:
    """A part of the scene of a survey: its attributes by name or, in brackets, by path.

    >>> part["translate/offset"] = (1, 2, 3)
    >>> part["dmotion[0]/motion[0]/angle"]
    """

    __slots__ = ("_vtk", "index")

    def __init__(self, vtk_survey, index):
        object.__setattr__(self, "_vtk", vtk_survey)
        object.__setattr__(self, "index", index)

    @property
    def name(self):
        return text_from_vtk(self._vtk.GetPartName(self.index))

    def __getitem__(self, path):
        return value_of(change(self._vtk, "GetPartAttribute", self.index, path))

    def __setitem__(self, path, value):
        for each, one in paths_of({path: value}):
            change(self._vtk, "SetPartAttribute", self.index, each, text_of(one))

    def __delitem__(self, path):
        change(self._vtk, "SetPartAttribute", self.index, path, "")

    def __getattr__(self, name):
        if name not in attributes("part"):
            refuse(name, attributes("part"), "a part")
        return self[name]

    def __setattr__(self, name, value):
        if name not in (*attributes("part"), *_PART_ELEMENTS):
            refuse(name, (*attributes("part"), *_PART_ELEMENTS), "a part")
        self[name] = value

    def rotate(self, axis, angle):
        """Rotates the part about x, y or z [deg], after its other rotations."""
        change(self._vtk, "RotatePart", self.index, axis, float(angle))

    def __repr__(self):
        return f"Part({self.index}: {self.name!r})"


# Attributes that are no single value, and elements of a part, which are given as dictionaries.
_PART_ELEMENTS = (
    "dynStep",
    "dynTimeStep",
    "kdtDynStep",
    "kdtDynTimeStep",
    "motion",
    "mount",
    "crs",
    "repair",
    "simplify",
    "frames",
)
_PART_ELEMENTS += ("rotate", "scale", "translate", "dmotion", "trajectory", "swap")


class _Items(collections.abc.Sequence):
    """A list of items of a survey, by their indices."""

    def __init__(self, vtk_survey):
        self._vtk = vtk_survey

    def __getitem__(self, index):
        if isinstance(index, slice):
            return [self._item(self._vtk, i) for i in range(len(self))[index]]
        return self._item(self._vtk, range(len(self))[index])

    def __delitem__(self, index):
        chosen = range(len(self))[index]
        for i in sorted([chosen] if isinstance(chosen, int) else chosen, reverse=True):
            self._remove(i)

    def __repr__(self):
        return repr(list(self))


class Legs(_Items):
    """The legs of a survey, including inactive ones: a list whose items can be changed."""

    _item = Leg
    if typing.TYPE_CHECKING:

        @typing.overload
        def __getitem__(self, index: int) -> "LegAttributes":
            ...

        @typing.overload
        def __getitem__(self, index: slice) -> list["LegAttributes"]:
            ...

        def __iter__(self) -> typing.Iterator["LegAttributes"]:
            ...

    def __len__(self):
        return self._vtk.GetNumberOfLegs()

    def _remove(self, index):
        change(self._vtk, "RemoveLeg", index)

    def append(
        self, position=None, scanner=0, platform=0, **settings: "typing.Unpack[LegSettings]"
    ) -> Leg:
        """Adds a leg at a position with the settings of make_survey(), and returns it.

        position may be a dictionary of all settings, as in make_survey(). scanner and platform are
        indices of those of the survey.
        """
        given = dict(position) if hasattr(position, "items") else {"position": position}
        given = {**given, **settings}
        flies = given.get("position") is None
        flies and given.pop("position", None)
        values = leg_values(given, flies)
        leg = Leg(self._vtk, change(self._vtk, "AddLeg", scanner, platform))
        try:
            for name, value in values.items():
                change(self._vtk, "SetLegAttribute", leg.index, name, text_of(value))
        except Exception:
            self._remove(leg.index)
            raise
        return leg

    def move(self, index: int, to: int) -> None:
        """Moves a leg to another place in the list."""
        change(self._vtk, "MoveLeg", range(len(self))[index], range(len(self))[to])


class Parts(_Items):
    """The parts of the scene of a survey that are not of tables: a list whose items can be changed."""

    _item = Part
    if typing.TYPE_CHECKING:

        @typing.overload
        def __getitem__(self, index: int) -> Part:
            ...

        @typing.overload
        def __getitem__(self, index: slice) -> list[Part]:
            ...

        def __iter__(self) -> typing.Iterator[Part]:
            ...

    def __len__(self):
        return self._vtk.GetNumberOfSingleParts()

    def _remove(self, index):
        change(self._vtk, "RemovePart", index)

    def append(self, file, loader=None, **values) -> Part:
        """Adds a part from a file, and returns it.

        loader is objloader, xyzloader ...; None: by the ending of the file. Other values are attributes
        of the part and of elements inside, which are dictionaries, or lists of them, with the names of
        Docs/dialect.md: ``id="car"``, ``translate={"offset": (1, 2, 3)}``, ``rotate=("z", 30)``,
        ``scale=2``, ``dmotion=[{"loop": 0, "motion": {"type": "rotation", "axis": (0, 0, 1), "angle": 3}}]``.
        """
        loader = loader or vtk_class("vtkHeliosDialect").FindLoader(to_vtk(file))
        if not loader:
            raise ValueError(f"{file}: is not a mesh of a known format; give its loader")
        part = Part(self._vtk, change(self._vtk, "AddPart", loader, to_vtk(file)))
        try:
            for name, value in values.items():
                if name == "rotate" and not hasattr(value, "items"):
                    part.rotate(*value)
                elif name == "scale" and not hasattr(value, "items"):
                    part["scale/scale"] = value
                elif name == "translate" and not hasattr(value, "items"):
                    part["translate/offset"] = value
                else:
                    part[name] = value
        except Exception:
            self._remove(part.index)
            raise
        return part
