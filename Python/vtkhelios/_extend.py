# SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
# SPDX-License-Identifier: BSD-3-Clause
"""Gives the wrapped classes what VTK 9.4 and newer have by themselves, and a repr that tells."""

from vtkmodules.vtkCommonCore import vtkObjectBase
from vtkmodules.vtkCommonExecutionModel import vtkAlgorithm
from vtkmodules.vtkFiltersPython import vtkPythonAlgorithm  # noqa: F401  guard() looks for it

from . import _native
from ._compose import METHODS, compose
from ._properties import make_properties, properties, refuse, set_properties


def extend(classes):
    """Extends the wrapped classes, bases before what is made of them."""
    _native.guard()
    if hasattr(vtkAlgorithm, "abort_execute"):
        return  # a VTK that has all of it
    _native.set_hooks(set_properties, refuse, compose, describe)
    for cls in sorted(set(classes), key=lambda cls: len(cls.__mro__)):
        if not issubclass(cls, vtkObjectBase):
            continue  # a struct
        is_algorithm = issubclass(cls, vtkAlgorithm)
        attributes = {**make_properties(cls), "__init__": _init}
        if is_algorithm:
            attributes |= METHODS
        _native.extend(cls, attributes, is_algorithm)


def _init(self, *_, **keywords):
    """Keywords are properties; for classes written in Python on top."""
    set_properties(self, keywords)


def describe(vtk_object):
    """One line: the class, and what is not as it was made."""
    values = state(vtk_object)
    defaults = _defaults(type(vtk_object))
    told = [f"{key}={text}" for key, text in values.items() if text != defaults.get(key)]
    return f"{vtk_object.GetClassName()}({', '.join(told)})"


def state(vtk_object):
    """What can be set, and is, as words."""
    return {
        name: _short(value.read(vtk_object))
        for name, value in properties(type(vtk_object)).items()
        if value.setter_name and name not in _NOT_STATE
    }


_NOT_STATE = {"abort_execute", "progress", "progress_text"}
_known_defaults = {}


def _defaults(cls):
    """What a new object has; nothing where none can be made."""
    if cls not in _known_defaults:
        try:
            _known_defaults[cls] = state(cls())
        except TypeError:  # abstract, or a class written in Python that wants arguments
            _known_defaults[cls] = {}
    return _known_defaults[cls]


def _short(value):
    """A value in a few words."""
    if isinstance(value, vtkObjectBase):
        return value.GetClassName()
    if isinstance(value, float):
        return f"{value:.6g}"
    if type(value) is tuple:
        return f"({', '.join(map(_short, value))})"
    return repr(value)
