# SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
# SPDX-License-Identifier: BSD-3-Clause
"""The public names of the package: the thin layer, and every class of every module of this build."""

import importlib
import pkgutil

from . import __path__ as _folders
from . import data_directory
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


def _load_modules():
    """Imports every wrapped module of the build and returns the names of its classes."""
    names = []
    for info in pkgutil.iter_modules(_folders):
        if info.name.startswith("vtkHelios"):
            module = importlib.import_module(f"{__package__}.{info.name}")
            public = [name for name in vars(module) if name.startswith("vtkHelios")]
            globals().update({name: getattr(module, name) for name in public})
            names += public
    return sorted(names)


_classes = _load_modules()
extend(globals()[name] for name in _classes)
__all__ = _own + _classes
__version__ = globals()["vtkHeliosVersion"].GetVersion()
