# SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
# SPDX-License-Identifier: BSD-3-Clause
"""LiDAR surveys as VTK pipelines.

Every class of every vtkHelios module that was built is here by its name, beside
a thin layer that makes pipelines Pythonic:

update(algorithm)
    Update() that raises PipelineError with the message where a filter fails,
    and turns VTK's warnings into Python's.
arrays(data)
    the points and arrays of a data object as numpy arrays, without a copy.

The classes work with those of stock vtkmodules in one process:

>>> import vtkhelios
>>> from vtkmodules.vtkFiltersSources import vtkLineSource
>>> waypoint = vtkLineSource()
"""

import importlib
import pathlib
import pkgutil

from ._arrays import arrays
from ._pipeline import PipelineError, update

_own = ["PipelineError", "arrays", "data_directory", "update"]


def data_directory():
    """The folder with the scanners, platforms and surveys that come with vtkHelios (a Path)."""
    return pathlib.Path(__file__).absolute().parent / "data"


def _load_modules():
    """Imports every wrapped module that was built and returns the names of its classes."""
    names = []
    for info in pkgutil.iter_modules(__path__):
        if info.name.startswith("vtkHelios"):
            module = importlib.import_module(f"{__name__}.{info.name}")
            public = [name for name in vars(module) if name.startswith("vtkHelios")]
            globals().update({name: getattr(module, name) for name in public})
            names += public
    return sorted(names)


__all__ = _own + _load_modules()
__version__ = globals()["vtkHeliosVersion"].GetVersion()
