# SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
# SPDX-License-Identifier: BSD-3-Clause
"""Checks that Python finds the VTK that vtkHelios was built with.

Two VTKs in one process cause a segmentation fault. The files that Python would load are checked
before any of them, or of ours, is loaded. A wheel has a VTK of its own, whose libraries, symbols and
Python modules (vtkhelios.vtkmodules) have other names: it works beside another VTK.
"""

import importlib.machinery
import importlib.util
import pathlib
import re
import sys

from .._built_with import VTK_LIBRARY, VTK_PACKAGE, VTK_SONAME, VTK_VERSION

_CURE = (
    f"Remove it ({sys.executable} -m pip uninstall vtk), or use vtkHelios in an environment without "
    "it; Docs/python.md names the PyVista versions without a VTK of their own"
)


def check_vtk():
    """Raises ImportError if vtkmodules are missing, or belong to another VTK."""
    if VTK_PACKAGE != "vtkmodules":
        return  # a VTK of our own
    folder = _find_folder()
    if folder is None:
        raise ImportError(
            f"vtkHelios needs the Python modules of VTK {VTK_VERSION}, which it was built with; "
            "this Python finds no vtkmodules; install them (Debian: apt-get install python3-vtk9, "
            "and a virtual environment with --system-site-packages)"
        )
    if not _is_own(folder):
        loaded = "has loaded" if "vtkmodules.vtkCommonCore" in sys.modules else "would load"
        raise ImportError(
            f"vtkHelios was built with VTK {VTK_VERSION} ({VTK_LIBRARY}), but this Python {loaded} "
            f"VTK {_version(folder) or 'of unknown version'} ({folder}), and two VTKs in one process "
            f"crash it. {_CURE}"
        )


def _find_folder():
    """Returns the folder of the loaded or importable vtkmodules; None if there are none."""
    if "vtkmodules" in sys.modules:
        folders = getattr(sys.modules["vtkmodules"], "__path__", [])
    else:
        spec = importlib.util.find_spec("vtkmodules")  # loads nothing
        folders = spec.submodule_search_locations if spec else []
    return next(map(pathlib.Path, folders or []), None)


def _is_own(folder):
    """Returns whether the modules of a folder link to the same library as ours."""
    spec = importlib.machinery.PathFinder.find_spec("vtkCommonCore", [str(folder)])
    binary = pathlib.Path(spec.origin).read_bytes() if spec and spec.origin else b""
    if binary.startswith(b"\x7fELF"):
        return b"\0" + VTK_SONAME.encode() + b"\0" in binary
    return (_version(folder) or "").split(".")[:2] == VTK_VERSION.split(".")[:2]


def _version(folder):
    """Returns the version in vtkmodules/__init__.py, or None."""
    try:
        text = (folder / "__init__.py").read_text(encoding="utf-8", errors="replace")
    except OSError:
        return None
    found = re.search(r"^__version__ = [\"']([^\"']+)", text, re.M)
    return found[1] if found else None
