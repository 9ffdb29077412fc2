# SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
# SPDX-License-Identifier: BSD-3-Clause
"""Wrapped classes, with the features of VTK 9.4 and newer and an informative repr."""

import functools
import importlib
import pathlib
import pkgutil

from vtkmodules.vtkCommonCore import vtkObjectBase
from vtkmodules.vtkCommonExecutionModel import vtkAlgorithm
from vtkmodules.vtkFiltersPython import vtkPythonAlgorithm  # noqa: F401  guard() looks for it

from .. import _native
from .compose import METHODS, compose
from .properties import make_properties, properties, refuse, set_properties

__all__ = ["describe", "extend", "state", "version", "vtk_class", "vtk_classes"]


_ROOT = __package__.rpartition(".")[0]


@functools.cache
def vtk_classes():
    """Every wrapped class of every module of the build: a dict by name, sorted."""
    found = {}
    for info in pkgutil.iter_modules([str(pathlib.Path(__file__).parents[1])]):
        if info.name.startswith("vtkHelios") and info.name != "vtkHeliosScannerMpi":  # loads MPI
            module = importlib.import_module(f"{_ROOT}.{info.name}")
            found |= {
                name: cls for name, cls in vars(module).items() if name.startswith("vtkHelios")
            }
    extend(found.values())
    return dict(sorted(found.items()))


def vtk_class(name):
    """A wrapped class by its name; AttributeError if its module is not in this build."""
    try:
        return vtk_classes()[name]
    except KeyError:
        raise AttributeError(f"this build of vtkHelios has no class {name}") from None


def version():
    """The version of vtkHelios."""
    return vtk_class("vtkHeliosVersion").GetVersion()


def extend(classes):
    """Extends the wrapped classes, bases before derived classes."""
    _native.guard()
    if hasattr(vtkAlgorithm, "abort_execute"):
        return  # a VTK with these features
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
    """Sets properties from keywords; for classes derived in Python."""
    set_properties(self, keywords)


def describe(vtk_object):
    """One line: the class, and its non-default properties."""
    values = state(vtk_object)
    defaults = _defaults(type(vtk_object))
    told = [f"{key}={text}" for key, text in values.items() if text != defaults.get(key)]
    return f"{vtk_object.GetClassName()}({', '.join(told)})"


def state(vtk_object):
    """Settable properties and values, as text."""
    return {
        name: _short(value.read(vtk_object))
        for name, value in properties(type(vtk_object)).items()
        if value.setter_name and name not in _NOT_STATE
    }


_NOT_STATE = {"abort_execute", "progress", "progress_text"}
_known_defaults = {}


def _defaults(cls):
    """Returns the values of a new object; empty if none can be made."""
    if cls not in _known_defaults:
        try:
            _known_defaults[cls] = state(cls())
        except TypeError:  # abstract, or a Python class that requires arguments
            _known_defaults[cls] = {}
    return _known_defaults[cls]


def _short(value):
    """Returns a value as short text."""
    if isinstance(value, vtkObjectBase):
        return value.GetClassName()
    if isinstance(value, float):
        return f"{value:.6g}"
    if type(value) is tuple:
        return f"({', '.join(map(_short, value))})"
    return repr(value)
