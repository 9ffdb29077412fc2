# SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
# SPDX-License-Identifier: BSD-3-Clause
"""The VTK that vtkHelios works with, under a name that is the same in every installation.

>>> from vtkhelios.vtkmodules.vtkCommonDataModel import vtkPolyData

Here these are the modules of vtkmodules, the VTK of the system. A wheel has a VTK of its own in this
package (Python/wheel).
"""

import importlib
import importlib.abc
import importlib.util
import sys

__path__ = []  # has no files: its modules come from _Finder


class _Finder(importlib.abc.MetaPathFinder):
    """Finds vtkhelios.vtkmodules.NAME."""

    def find_spec(self, name, path=None, target=None):
        if not name.startswith(f"{__name__}.") or importlib.util.find_spec(_in_vtk(name)) is None:
            return None
        return importlib.util.spec_from_loader(name, _Loader())


class _Loader(importlib.abc.Loader):
    """Loads vtkhelios.vtkmodules.NAME: the module vtkmodules.NAME itself, not a copy."""

    def create_module(self, spec):
        module = importlib.import_module(_in_vtk(spec.name))
        self.spec = module.__spec__  # the import system replaces it
        return module

    def exec_module(self, module):
        module.__spec__ = self.spec


def _in_vtk(name):
    """vtkhelios.vtkmodules.NAME as vtkmodules.NAME."""
    return name.removeprefix(f"{__package__.rpartition('.')[0]}.")


sys.meta_path.insert(0, _Finder())  # before the finder of the files of VTK, which makes copies
