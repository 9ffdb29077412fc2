# SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
# SPDX-License-Identifier: BSD-3-Clause
"""Plug-ins: files in Python, or shared libraries, that register echo detectors."""

import importlib.machinery
import importlib.util
import os
import pathlib
import sys
import traceback

from ..vtkHeliosFiltersCore import vtkHeliosVersion
from ..vtkHeliosScannerDetectors import vtkHeliosEchoDetection
from .paths import to_vtk
from .pipeline import PipelineError

_loaded = {}  # by file: the names of its detectors


class PluginError(PipelineError):
    """A plug-in that cannot be loaded."""

    def __init__(self, message):
        super().__init__([message])


def load_plugin(path):
    """Loads a plug-in and returns the names of the echo detectors that it registers.

    path
        a file in Python (.py), which calls vtkhelios.add_detector(), or a shared library (.so) with
        ``extern "C" bool vtkhelios_register_plugin()``, which returns whether
        vtkHeliosEchoDetection::AddDetector() did. A file that is loaded already is not loaded again.

    Raises PluginError. The file is an input of the runs that use its detectors: summaries have its
    SHA-256, and a run does not resume with another one.
    """
    path = os.path.abspath(path)
    if path not in _loaded:
        _loaded[path] = _load(path)
    return list(_loaded[path])


def loaded_plugins():
    """Returns the files of the plug-ins of this process."""
    return list(_loaded)


def _load(path):
    loaders = {".py": _load_module, ".so": _load_library}
    load = loaders.get(pathlib.Path(path).suffix)
    if not os.path.isfile(path):
        raise PluginError(f"{path}: no such file; give a plug-in")
    if load is None:
        raise PluginError(f"{path}: is no plug-in; give a file in Python (.py) or a library (.so)")
    before = _known()
    try:
        load(path)
        added = [name for name in _known() if name not in before]
        if not added:
            raise PluginError(
                f"{path}: registers no echo detector of vtkHelios {vtkHeliosVersion.GetVersion()}; "
                "call add_detector() in it"
            )
    except BaseException:
        for name in set(_known()) - set(before):
            vtkHeliosEchoDetection.RemoveDetector(name)
        raise
    for name in added:
        vtkHeliosEchoDetection.SetDetectorFile(name, to_vtk(path))
    return added


def _known():
    """Returns the names of the echo detectors."""
    count = vtkHeliosEchoDetection.GetNumberOfDetectors()
    return [vtkHeliosEchoDetection.GetDetectorName(i) for i in range(count)]


def _load_module(path):
    name = f"vtkhelios_plugin_{len(_loaded)}_{pathlib.Path(path).stem}"
    loader = importlib.machinery.SourceFileLoader(name, path)
    module = importlib.util.module_from_spec(importlib.util.spec_from_loader(name, loader))
    sys.modules[name] = module  # dataclasses and pickle look there
    try:
        loader.exec_module(module)
    except Exception as error:
        del sys.modules[name]
        lines = [
            each.lineno
            for each in traceback.extract_tb(error.__traceback__)
            if each.filename == path
        ]
        line = error.lineno if isinstance(error, SyntaxError) else lines[-1] if lines else 1
        raise PluginError(f"{path}:{line}: {type(error).__name__}: {error}") from error


def _load_library(path):
    if fault := vtkHeliosEchoDetection.LoadPlugin(to_vtk(path)):
        raise PluginError(os.fsdecode(fault))
