# SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
# SPDX-License-Identifier: BSD-3-Clause
"""LiDAR surveys as VTK pipelines.

Every class of every vtkHelios module of this build is available by name, with a thin layer that
makes pipelines Pythonic:

update(algorithm)
    Update() that raises PipelineError with the message if a filter fails,
    and turns VTK's warnings into Python's.
arrays(data)
    the points and arrays of a data object as numpy arrays, without a copy.

Properties of all classes are attributes and keywords, and ``>>`` connects:

>>> scanner = vtkhelios.vtkHeliosScanner(range_max=600)
>>> cloud = vtkhelios.Cloud(((scene, trajectory) >> scanner)())

read_survey(), make_survey(), scan()
    surveys from files and of scenes in memory, which run in memory (Survey).
plan()
    positions to scan a scene from (Plan).
compare()
    metrics of two clouds (Comparison).
fit()
    the instrument and the flight of an airborne cloud (Fit).
Cloud, Scene
    thin views of vtkPolyData, and numpy arrays.
filter
    makes a filter from a function on data.

See Docs/python.md.

The classes work with those of stock vtkmodules in one process:

>>> import vtkhelios
>>> from vtkmodules.vtkFiltersSources import vtkLineSource
>>> waypoint = vtkLineSource()
"""

import importlib
import pathlib
import pkgutil

from ._vtk import check_vtk

check_vtk()  # before any binary module

# Before _native, which links to its libraries.
from . import vtkHeliosScannerSurvey as _  # noqa: F401
from ._arrays import arrays
from ._compose import Pipeline, select_ports
from ._extend import extend
from ._filter import filter
from ._pipeline import PipelineError, update
from .cloud import Cloud, Records
from .comparison import Comparison, compare
from .fitting import Fit, fit
from .planning import Plan, plan
from .scanning import make_survey, scan
from .scene import Scene
from .survey import Survey, read_survey

_own = [
    "Cloud", "Comparison", "Fit", "Pipeline", "PipelineError", "Plan", "Records", "Scene", "Survey", "arrays",
    "compare", "data_directory", "filter", "fit", "make_survey", "plan", "read_survey", "scan", "select_ports", "update",
]  # fmt: skip


def data_directory():
    """The folder with the scanners, platforms and surveys shipped with vtkHelios (a Path)."""
    return pathlib.Path(__file__).absolute().parent / "data"


def _load_modules():
    """Imports every wrapped module of the build and returns the names of its classes."""
    names = []
    for info in pkgutil.iter_modules(__path__):
        if info.name.startswith("vtkHelios") and info.name != "vtkHeliosScannerMpi":  # loads MPI
            module = importlib.import_module(f"{__name__}.{info.name}")
            public = [name for name in vars(module) if name.startswith("vtkHelios")]
            globals().update({name: getattr(module, name) for name in public})
            names += public
    return sorted(names)


_classes = _load_modules()
extend(globals()[name] for name in _classes)
__all__ = _own + _classes
__version__ = globals()["vtkHeliosVersion"].GetVersion()
