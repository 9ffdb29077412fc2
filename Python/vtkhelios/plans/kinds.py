# SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
# SPDX-License-Identifier: BSD-3-Clause
"""Kinds of settings of a plan: how each is checked, set on the filters, and read from them.

``objects`` are the planner document and the filters by name; a property is ``filter.name``.
"""

import difflib
import functools
import numbers
import os

import numpy as np
from vtkmodules.vtkIOXML import vtkXMLPolyDataReader

from ..core.classes import vtk_class
from ..core.paths import to_vtk
from ..scenes.scene import Scene

__all__ = [
    "Areas",
    "Choice",
    "Flag",
    "Number",
    "PlanNumber",
    "PlanOption",
    "PlanString",
    "Reference",
    "Region",
    "SettingError",
    "DocumentChoice",
]


class SettingError(ValueError):
    """A setting that is not valid. ``say(spell)`` is the message with the names as spelled by a
    function, such as options of the command line.

    The text is a format of the names, {0}, {1} ..., and of the values by keyword.
    """

    def __init__(self, text, *names, **values):
        self._text, self._names, self._values = text, names, values
        super().__init__(self.format())

    def format(self, spell=str):
        return self._text.format(*map(spell, self._names), **self._values)


class Setting:
    """A setting of some properties. ``reported`` is its name in reports, None if it has none."""

    def __init__(self, reported, *properties):
        self.reported, self.properties = reported, properties

    def is_of_document(self):
        """Returns whether the document is read with it."""
        return any(name.startswith("document.") for name in self.properties)

    def get(self, objects):
        """Returns the values of the properties."""
        return tuple(getattr(*_find(objects, name)) for name in self.properties)

    def assign(self, objects, values):
        for name, value in zip(self.properties, values, strict=True):
            setattr(*_find(objects, name), value)

    def read(self, objects):
        return self.get(objects)[0]

    def set(self, objects, value):
        self.assign(objects, [value] * len(self.properties))

    def report(self, value):
        """Returns the value in a report."""
        return value


class Number(Setting):
    """A number: ``scale`` times the properties, which have the valid range.

    ``low`` excludes the values that stand for "not given" there.
    """

    def __init__(self, reported, *properties, unit, low=None, scale=1.0):
        super().__init__(reported, *properties)
        self.unit, self.low, self.scale = unit, low, scale

    def read(self, objects):
        return self.scale * super().read(objects)

    def set(self, objects, value):
        for property_name in self.properties:
            owner, camel = _find_method(objects, property_name)
            getattr(owner, f"Set{camel}")(value / self.scale)  # clamps what rounding adds

    def limits(self):
        """Returns the valid range."""
        owner, camel = _find_method(_examples(), self.properties[0])
        low, high = (
            self.scale * getattr(owner, f"Get{camel}{end}Value")() for end in ("Min", "Max")
        )
        return low if self.low is None else self.low, high

    def check(self, name, value):
        if isinstance(value, bool) or not isinstance(value, numbers.Real):
            raise TypeError(f"{name} is {value!r}; give a number [{self.unit}]")
        low, high = self.limits()
        if not low <= value <= high:
            raise SettingError(
                "{0} is {value:g}; its valid range is [{low:g}, {high:g}] {unit}",
                name,
                value=float(value),
                low=low,
                high=high,
                unit=self.unit,
            )
        return float(value)


class Choice(Setting):
    """One of some words: a dictionary from each to the values of the properties."""

    def __init__(self, reported, *properties, words):
        super().__init__(reported, *properties)
        self.words = words

    def read(self, objects):
        values = self.get(objects)
        return next(word for word, known in self.words.items() if known == values)

    def set(self, objects, value):
        self.assign(objects, self.words[value])

    def check(self, name, value):
        word = str(value).lower() if isinstance(value, bool) else value  # ground=True
        if word in self.words:
            return word
        near = difflib.get_close_matches(str(value), self.words, 1, 0.5)
        words = f"expected one of: {', '.join(self.words)}"
        hint = f"did you mean {near[0]}? ({words})" if near else words
        raise SettingError("{0} is {value!r}; {hint}", name, value=value, hint=hint)


class DocumentChoice(Choice):
    """One of some words of the document that no property has alone: nothing is set."""

    def read(self, objects):
        return Setting.read(self, objects)

    def set(self, objects, value):
        pass


class PlanOption(Choice):
    """One of some words that neither the document nor a filter has; the first is the default."""

    def read(self, objects):
        return next(iter(self.words))

    def set(self, objects, value):
        pass


class PlanNumber(Number):
    """A number that neither the document nor a filter has."""

    def __init__(self, reported, *, unit, low, high, default):
        super().__init__(reported, unit=unit, low=low)
        self.high, self.default = high, default

    def read(self, objects):
        return self.default

    def set(self, objects, value):
        pass

    def limits(self):
        return self.low, self.high


class PlanString(Setting):
    """A text that neither the document nor a filter has."""

    def read(self, objects):
        return None

    def set(self, objects, value):
        pass

    def check(self, name, value):
        if not isinstance(value, str):
            raise TypeError(f"{name} is {value!r}; give a text")
        return value


class Flag(Setting):
    """True or False. The properties (``inverted``) or the report may have the opposite."""

    def __init__(self, reported, *properties, inverted=False, reports_opposite=False):
        super().__init__(reported, *properties)
        self.inverted, self.reports_opposite = inverted, reports_opposite

    def read(self, objects):
        return super().read(objects) != self.inverted

    def set(self, objects, value):
        super().set(objects, value != self.inverted)

    def check(self, name, value):
        if not isinstance(value, (bool, np.bool_)):
            raise TypeError(f"{name} is {value!r}; give True or False")
        return bool(value)

    def report(self, value):
        return value != self.reports_opposite


class Reference(Setting):
    """A platform or scanner: file.xml#id, or an id in a file of the catalogue."""

    def __init__(self, reported, name, file):
        super().__init__(reported, name)
        self.file = file

    def check(self, name, value):
        if not isinstance(value, str):
            raise TypeError(f"{name} is {value!r}; give file.xml#id, or an id in {self.file}")
        return value if "#" in value else f"{self.file}#{value}"


class Region(Setting):
    """A rectangle: x0, x1, y0, y1 [m]."""

    def read(self, objects):
        return None

    def set(self, objects, value):
        self.assign(objects, [value])

    def check(self, name, value):
        try:
            x0, x1, y0, y1 = region = [float(side) for side in value]
        except (TypeError, ValueError):
            raise TypeError(f"{name} is {value!r}; give 4 numbers: x0, x1, y0, y1 [m]") from None
        if not (x0 <= x1 and y0 <= y1):
            raise SettingError(
                "{0} is x {x0:g} to {x1:g}, y {y0:g} to {y1:g}; the first of each must not be above "
                "the second",
                name,
                x0=x0,
                x1=x1,
                y0=y0,
                y1=y1,
            )
        return region


class Areas(Setting):
    """Polygons, or a .vtp file of them."""

    def read(self, objects):
        return None

    def set(self, objects, value):
        """Connects them to port 1 of the candidates."""
        if isinstance(value, str):
            reader = vtk_class("vtkHeliosPointXMLReader")()
            reader.SetFileName(to_vtk(value))
            objects["candidates"].SetInputConnection(1, reader.GetOutputPort())
        else:
            objects["candidates"].SetInputDataObject(1, value)

    def check(self, name, value):
        if not isinstance(value, (str, os.PathLike)):
            return Scene(value).polydata
        path = os.fspath(value)
        if not vtkXMLPolyDataReader().CanReadFile(to_vtk(path)):
            raise SettingError(
                "{0} {path}: is not a VTK XML file of polygons; give a .vtp", name, path=path
            )
        return path

    def report(self, value):
        return value if value is None or isinstance(value, str) else "polygons"


def objects_of(plan):
    """Returns the document and the filters of a vtkHeliosScanPlan by name."""
    return {
        "document": plan.GetDocument(),
        "candidates": plan.GetCandidates(),
        "test_points": plan.GetTestPoints(),
        "viewsheds": plan.GetViewsheds(),
        "planner": plan.GetPlanner(),
    }


def _find(objects, name):
    """Returns the object and the name of a property."""
    owner, _, own = name.partition(".")
    return objects[owner], own


def _find_method(objects, name):
    """Returns the object of a property, and the property's name in its methods."""
    owner, own = _find(objects, name)
    return owner, getattr(type(owner), own).camel


@functools.cache
def _examples():
    """Objects that have the valid ranges of their properties."""
    return {
        **objects_of(vtk_class("vtkHeliosScanPlan")()),
        "document": vtk_class("vtkHeliosPlannerReader")(),
    }
