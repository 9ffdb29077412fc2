# SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
# SPDX-License-Identifier: BSD-3-Clause
"""Properties of wrapped classes as attributes, named as in VTK 9.4 and newer.

``SetBeamDivergence()`` and ``GetBeamDivergence()`` make ``beam_divergence``. Properties come from
the methods of a class; valid values from trying them.
"""

import difflib
import functools
import math
import re

from .pipeline import MessageLog
from .views import data_of
from .words import no_attribute

__all__ = ["Choice", "make_properties", "properties", "set_properties", "snake_case"]

_WORD_ENDS = re.compile(r"(?<=[a-z0-9])(?=[A-Z])|(?<=[A-Z])(?=[A-Z][a-z])")
# Properties of every VTK object, not specific to LiDAR.
_LEFT_OUT = set(
    "abort_output address_as_string class_name command container_algorithm debug executive global_warning_display information input "
    "input_algorithm input_data_object input_executive input_information is_in_memkind is_python "
    "object_description object_name output output_data_object output_information output_port "
    "progress_observer progress_scale progress_shift reference_count release_data_flag "
    "total_number_of_input_connections update_extent update_ghost_level update_number_of_pieces "
    "update_piece using_memkind".split()
)
_NOT_SET = {"Progress"}  # not set by users
# "Valid range: (0, 1e6]. ", with only the numbers.
_NUMBER = r"([-+]?(?:infinity|[\d.]+(?:e[-+]?\d+)?))"
_INTERVAL = re.compile(rf"Valid\s+range:\s*([\[(]){_NUMBER},\s*{_NUMBER}([\])])\.(?:\s|$)")
_KINDS = {
    "float": "a number",
    "int": "a whole number",
    "bool": "True or False",
    "str": "text",
}


def snake_case(name):
    """``BeamDivergence`` -> ``beam_divergence``, ``MTime`` -> ``m_time``."""
    return _WORD_ENDS.sub("_", name).lower()


class Choice(int):
    """A value of an enumeration that also compares with its name: ``scanner.sampling == "fixed"``."""

    def __new__(cls, value, name):
        self = super().__new__(cls, value)
        self.name = name
        return self

    def __eq__(self, other):
        return self.name == other if isinstance(other, str) else int(self) == other

    def __ne__(self, other):
        return not self == other

    __hash__ = int.__hash__

    def __repr__(self):
        return repr(self.name)

    def __str__(self):
        return self.name

    def __format__(self, spec):
        return format(self.name, spec)


class Property:
    """A pair of Set and Get, or a Get alone: a descriptor that reads texts on demand."""

    def __init__(self, cls, camel):
        self.cls, self.camel = cls, camel
        can_set = hasattr(cls, f"Set{camel}") and camel not in _NOT_SET
        self.setter_name = f"Set{camel}" if can_set else None

    def __get__(self, vtk_object, _cls=None):
        return self if vtk_object is None else self.read(vtk_object)

    def __set__(self, vtk_object, value):
        if self.setter_name is None:
            raise AttributeError(f"{self._where(vtk_object)} is read only")
        if isinstance(value, str) and self.choices:
            self._choose(vtk_object, value)
        else:
            self._set(vtk_object, value)

    @property
    def __doc__(self):
        return _doc(self.cls, self.camel)

    @functools.cached_property
    def choices(self):
        """Name: (number, method) of its values, if it has SetXToName()."""
        return _choices(self.cls, self.camel)

    @property
    def name(self):
        return snake_case(self.camel)

    def read(self, vtk_object):
        """Returns the value; of an enumeration, a Choice."""
        value = getattr(vtk_object, f"Get{self.camel}")()
        if isinstance(value, int) and self.choices:
            name = next(
                (name for name, (number, _) in self.choices.items() if number == value), None
            )
            return value if name is None else Choice(value, name)
        return value

    def _choose(self, vtk_object, name):
        if name not in self.choices:
            names = ", ".join(self.choices)
            raise ValueError(f"{self._where(vtk_object)} is {name!r}; give one of: {names}")
        getattr(vtk_object, self.choices[name][1])()

    def _set(self, vtk_object, value):
        before, setter = self.read(vtk_object), getattr(vtk_object, self.setter_name)
        try:
            with MessageLog() as log:
                log.watch(vtk_object)
                setter(_plain(value, before))
        except (TypeError, ValueError, OverflowError) as error:
            told = f"{self._where(vtk_object)} is {value!r}; give {self.kind}"
            raise type(error)(told) from error
        if log.errors:
            raise ValueError(f"{self._where(vtk_object)}: {log.errors[0]}")
        now, is_valid = self.read(vtk_object), self._is_told_valid(value)
        if not (_is_as_given(now, value) and is_valid):
            setter(_plain(before, before))
            problem = self.valid_range(vtk_object)
            if is_valid and _INTERVAL.search(self.__doc__ or "") and not self.choices:
                problem = f"other properties determine it, {now!r} (see its documentation); set them first"
            raise ValueError(
                f"{self._where(vtk_object)} is {value!r}; {problem}; {before!r} is kept"
            )

    @property
    def kind(self):
        """Accepted values, as text."""
        if self.choices:
            return f"one of: {', '.join(self.choices)}"
        kind = self.annotation
        if kind.startswith("("):
            return f"{kind.count(',') + 1} numbers"
        return _KINDS.get(kind, f"a {kind} or None" if kind.startswith("vtk") else kind)

    @property
    def annotation(self):
        """The type from VTK's wrapper, of the setter, or else of the getter."""
        if self.setter_name:
            found = re.findall(
                r"\(self, \w+:(.+?)\)\s*->", self._signatures(self.setter_name), re.S
            )
        else:
            found = re.findall(r"\(self\) ->\s*(.+)", self._signatures(f"Get{self.camel}"))
        return found[-1] if found else "object"

    def _signatures(self, method):
        return getattr(self.cls, method).__doc__ or ""

    def valid_range(self, vtk_object):
        """Returns the valid range as text, from the class."""
        if self.choices:
            return f"give {self.kind}"
        told = re.search(r"Valid\s+range:\s*(.*?)\.(?:\s|$)", self.__doc__ or "", re.S)
        text = " ".join(told.group(1).split()) if told else ""
        limits = [
            getattr(vtk_object, f"Get{self.camel}{end}Value", lambda: None)()
            for end in ("Min", "Max")
        ]
        if None not in limits and ", or " not in text:  # a value with a meaning of its own
            return f"its valid range is [{limits[0]:g}, {limits[1]:g}]"
        return f"its valid range is {text}" if text else "it is out of range"

    def _is_told_valid(self, value):
        """Returns whether a number is within the documented range, if there is one."""
        told = _INTERVAL.search(self.__doc__ or "")
        if not told or not isinstance(value, (int, float)) or isinstance(value, bool):
            return True
        low, high = float(told.group(2)), float(told.group(3))
        return (low < value or told.group(1) == "[" and value == low) and (
            value < high or told.group(4) == "]" and value == high
        )

    def _where(self, vtk_object):
        return f"{vtk_object.GetClassName()}.{self.name}"


def _choices(cls, camel):
    """Name: (number, method) of the values of a property that has SetXToName()."""
    prefix = f"Set{camel}To"
    found = {}
    for method in dir(cls):
        if method.startswith(prefix):
            name = snake_case(method[len(prefix) :])
            found[name] = (getattr(cls, name.upper(), None), method)
    return found


def _doc(cls, camel):
    """Returns the C++ documentation of a property, its own or its group's."""
    told = _texts(cls)
    return told.get(f"Set{camel}") or told.get(f"Get{camel}") or None


@functools.cache
def _texts(cls):
    """Returns the text of every method; one without text is in the group of the one above."""
    texts, last = {}, ""
    for base in reversed(cls.__mro__):
        for name, method in vars(base).items():
            if isinstance(method, Property):
                continue
            text = getattr(method, "__doc__", None) or ""
            last = text.split("\n\n", 1)[1].strip() if "\n\n" in text else ""
            if not last and base.__module__.startswith("vtkhelios."):
                last = texts.get("", "")
            texts[name] = texts[""] = last
    return texts


def _plain(value, before):
    """Returns the value as accepted by the wrapper: numpy's scalars and arrays, paths, views."""
    if hasattr(value, "tolist"):
        value = value.tolist()
    if isinstance(value, Choice):
        return int(value)
    if isinstance(before, bool) and not isinstance(value, int):
        raise TypeError("expected True or False")
    if hasattr(value, "__fspath__"):
        return value.__fspath__()
    return data_of(value)  # a Cloud or a Scene


def _is_as_given(value, given):
    if hasattr(given, "tolist"):
        given = given.tolist()
    if isinstance(value, (tuple, list)):
        return len(value) == len(given) and all(map(_is_as_given, value, given))
    if isinstance(value, float) and isinstance(given, (int, float)):
        return math.isclose(value, given, rel_tol=1e-6) or value == given or given != given
    if isinstance(value, int) and isinstance(given, (int, float)):
        return value == given
    return True


@functools.cache
def properties(cls):
    """Returns the properties of a class by name, including its bases' properties, sorted by
    name."""
    found = {}
    for name in dir(cls):
        attribute = getattr(cls, name, None)
        if isinstance(attribute, Property):
            found[name] = attribute
    return found


def make_properties(cls):
    """Adds to a class a Property for every getter without arguments."""
    own = vars(cls)
    bases = [base for base in cls.__mro__[1:] if not base.__module__.startswith("vtkhelios.")]
    inherited = dir(bases[0]) if cls.__mro__[1] is bases[0] else ()
    made = {}
    for method in dict.fromkeys([*own, *inherited]):
        if method[:3] != "Get" or method.endswith(("MinValue", "MaxValue", "AsString")):
            continue
        camel = method[3:]
        name = snake_case(camel)
        if (
            name
            and name not in _LEFT_OUT
            and not hasattr(cls, name)
            and _takes_nothing(cls, method)
        ):
            made[name] = Property(cls, camel)
    return made


def _takes_nothing(cls, method):
    signatures = getattr(cls, method).__doc__ or ""
    return f"{method}(self) ->" in signatures or f"{method}() ->" in signatures


def set_properties(vtk_object, values):
    """Sets properties by name, in the order given."""
    for name, value in values.items():
        if not hasattr(type(vtk_object), name):
            refuse(vtk_object, name)
        setattr(vtk_object, name, value)


def refuse(vtk_object, name):
    """Raises AttributeError for an unknown name."""
    cls = type(vtk_object)
    settable = [key for key, value in properties(cls).items() if value.setter_name]
    near = difflib.get_close_matches(snake_case(name), settable, 1, 0.6)
    hint = f"; did you mean {near[0]}?" if near else f"; it has: {', '.join(settable)}"
    raise no_attribute(
        vtk_object, name, f"{vtk_object.GetClassName()} has no property {name}{hint}"
    )
