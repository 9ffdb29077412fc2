# SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
# SPDX-License-Identifier: BSD-3-Clause
"""The public names of the package: the thin layer, and every class of every module of this build.

The classes get the features of VTK 9.4 and newer, and an informative repr.
"""

import importlib
import pkgutil

from vtkmodules.vtkCommonCore import vtkObjectBase
from vtkmodules.vtkCommonExecutionModel import vtkAlgorithm
from vtkmodules.vtkFiltersPython import vtkPythonAlgorithm  # noqa: F401  guard() looks for it

from . import __path__ as _folders
from . import _native, data_directory
from ._arrays import arrays
from ._compose import METHODS, Pipeline, compose, select_ports
from ._filter import filter
from ._pipeline import PipelineError, update
from ._properties import make_properties, properties, refuse, set_properties
from .cloud import Cloud, Records
from .comparison import Comparison, compare
from .fitting import Fit, fit
from .planning import Plan, plan, plan_flight
from .scanning import make_survey, scan
from .scene import Scene
from .survey import Survey, read_survey

_own = [
    "Cloud", "Comparison", "Fit", "Pipeline", "PipelineError", "Plan", "Records", "Scene", "Survey", "arrays",
    "compare", "data_directory", "filter", "fit", "make_survey", "plan", "plan_flight", "read_survey", "scan", "select_ports", "update",
]  # fmt: skip


def _load_modules():
    """Imports every wrapped module of the build and returns the names of its classes."""
    names = []
    for info in pkgutil.iter_modules(_folders):
        if info.name.startswith("vtkHelios") and info.name != "vtkHeliosScannerMpi":  # loads MPI
            module = importlib.import_module(f"{__package__}.{info.name}")
            public = [name for name in vars(module) if name.startswith("vtkHelios")]
            globals().update({name: getattr(module, name) for name in public})
            names += public
    return sorted(names)


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
    """The values of a new object; empty if none can be made."""
    if cls not in _known_defaults:
        try:
            _known_defaults[cls] = state(cls())
        except TypeError:  # abstract, or a Python class that requires arguments
            _known_defaults[cls] = {}
    return _known_defaults[cls]


def _short(value):
    """A value as short text."""
    if isinstance(value, vtkObjectBase):
        return value.GetClassName()
    if isinstance(value, float):
        return f"{value:.6g}"
    if type(value) is tuple:
        return f"({', '.join(map(_short, value))})"
    return repr(value)


_classes = _load_modules()
extend(globals()[name] for name in _classes)
__all__ = _own + _classes
__version__ = globals()["vtkHeliosVersion"].GetVersion()
