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
import sys

from ._process.start import handle_signals, is_command

if is_command(sys.argv, sys.orig_argv):
    handle_signals()

from ._vtk import check_vtk

check_vtk()  # before any binary module

# Before _native, which links to its libraries.
from . import vtkHeliosScannerRun as _  # noqa: F401


def data_directory():
    """The folder with the scanners, platforms and surveys shipped with vtkHelios (a Path)."""
    return pathlib.Path(__file__).absolute().parent / "data"


def __getattr__(name):
    """A public name, once it is used: vtkhelios run starts without those that it does not use."""
    if not name.startswith("_") or name in ("__all__", "__version__"):
        public = importlib.import_module("._public", __name__)
        if name in ("__all__", *getattr(public, "__all__", ()), "__version__"):
            globals()[name] = getattr(public, name)
        if name in globals():  # else, while _public is imported, it may be a submodule
            return globals()[name]
    raise AttributeError(f"module {__name__!r} has no attribute {name!r}")


def __dir__():
    return sorted({*globals(), *importlib.import_module("._public", __name__).__all__})
