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

read()
    the points of a file as a Cloud.
read_survey(), make_survey(), scan()
    surveys from files and of scenes in memory, which run in memory (Survey).
Sensor, scan_many()
    many scans of small scenes by one scanner (Scans).
plan()
    positions to scan a scene from (Plan).
compare()
    metrics of two clouds (Comparison).
fit()
    the instrument and the flight of an airborne cloud (Fit).
plant_area()
    plant area density in voxels, from scans (PlantArea).
Cloud, Scene
    thin views of vtkPolyData, and numpy arrays.
filter
    makes a filter from a function on data.
add_detector(), load_plugin()
    echo detectors that are functions, and files that register some, for surveys.

See Docs/python.md.

The classes work with the classes of stock vtkmodules in one process:

>>> import vtkhelios
>>> from vtkmodules.vtkFiltersSources import vtkLineSource
>>> waypoint = vtkLineSource()
"""

import importlib.util
import sys

from .core.folders import data_directory
from .core.start import handle_signals, is_command

if is_command(sys.argv, sys.orig_argv):
    handle_signals()

from .core.vtk_check import check_vtk

check_vtk()  # before any binary module

# Before _native, which links to its libraries.
from . import vtkHeliosScannerRun as _  # noqa: F401

_HOMES = {
    "clouds.cloud": ("Cloud", "Records", "read"),
    "clouds.filter": ("filter",),
    "comparison": ("Comparison", "compare"),
    "core.arrays": ("arrays",),
    "core.compose": ("Pipeline", "select_ports"),
    "core.detectors": ("add_detector",),
    "core.folders": ("data_directory",),
    "core.pipeline": ("PipelineError", "update"),
    "core.plugins": ("load_plugin",),
    "fitting": ("Fit", "fit"),
    "flight": ("plan_flight",),
    "leafarea": ("PlantArea", "plant_area"),
    "plans.plan": ("Plan", "plan"),
    "scenes.scene": ("Scene",),
    "surveys.scanning": ("make_survey", "scan"),
    "surveys.batch": ("Sensor", "scan_many"),
    "surveys.survey": ("Survey", "read_survey"),
}
_HOME = {name: module for module, names in _HOMES.items() for name in names}


def __getattr__(name):
    """A module, a class or a public name, once it is used: others are not imported."""
    if name in _HOME or name in ("__all__", "__version__") or name.startswith("vtkHelios"):
        classes = importlib.import_module(f"{__name__}.core.classes")
        found = classes.vtk_classes()
        if name == "__all__":
            return [*sorted(_HOME), *found]
        if name == "__version__":
            return classes.version()
        if name in _HOME:
            found = vars(importlib.import_module(f"{__name__}.{_HOME[name]}"))
        if name in found:
            globals()[name] = found[name]
            return found[name]
    elif not name.startswith("_") and importlib.util.find_spec(f"{__name__}.{name}"):
        return importlib.import_module(f"{__name__}.{name}")
    raise AttributeError(f"module {__name__!r} has no attribute {name!r}")


def __dir__():
    return sorted({*globals(), *__getattr__("__all__")})
