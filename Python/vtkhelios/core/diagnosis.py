# SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
# SPDX-License-Identifier: BSD-3-Clause
"""Parts of vtkHelios and of what it uses that are installed and work.

>>> from vtkhelios.core import diagnosis
>>> diagnosis.make_report()["packages of Python"]
"""

import concurrent.futures
import importlib.metadata
import importlib.util
import os
import pathlib
import platform
import shutil
import subprocess
import sys

from vtkmodules import vtkCommonCore

from . import packages
from .classes import version, vtk_classes
from .display import has_display
from .folders import data_directory

WORKS, MISSING, BROKEN = "works", "missing", "broken"
SECONDS = 60  # to import a package
AT_ONCE = 4

# Classes of modules that a build may leave out, and what they are for.
MODULES = {
    "vtkHeliosEmbreeRayCaster": "--ray-caster embree",
    "vtkHeliosCgalRayCaster": "--ray-caster cgal",
    "vtkHeliosObbTreeRayCaster": "--ray-caster obbtree",
    "vtkHeliosMeshSimplify": "simplified meshes",
    "vtkHeliosPCLFilter": "filters of the Point Cloud Library",
}


def make_report(viewer=None):
    """Returns lists of parts by title; a part is a dictionary of texts: name, state, version, place,
    for, cure. viewer is the path of the viewer, or None."""
    with concurrent.futures.ThreadPoolExecutor(AT_ONCE) as pool:
        optional = list(pool.map(_optional, packages.PACKAGES))
    return {
        "vtkHelios": [_package(), *_modules()],
        "what it needs": [_python(), _vtk(), _numpy()],
        "packages of Python": optional,
        "programs": [
            _program(
                "vtkhelios-viewer",
                viewer,
                "vtkhelios view",
                "this build has no viewer: see Docs/install.md",
            ),
            _program(
                "mpirun",
                shutil.which("mpirun"),
                "runs on several computers",
                "apt-get install openmpi-bin",
            ),
            _display(),
        ],
    }


def all_parts(report):
    """Returns all parts of a report."""
    return [part for parts in report.values() for part in parts]


def _part(name, state=WORKS, number="", place="", use="", cure=""):
    keys = ("name", "state", "version", "place", "for", "cure")
    return dict(zip(keys, (name, state, str(number), str(place), use, cure)))


def _package():
    shipped = data_directory()
    if not pathlib.Path(shipped, "Assets").is_dir():
        return _part(
            "vtkhelios", BROKEN, version(), shipped, "", "its data are missing: install it again"
        )
    return _part("vtkhelios", WORKS, version(), pathlib.Path(__file__).parents[1])


def _modules():
    known = vtk_classes()
    return [
        _part(name, WORKS if name in known else MISSING, use=use,
              cure="" if name in known else "this build has been made without its library")
        for name, use in MODULES.items()
    ]  # fmt: skip


def _python():
    return _part("Python", WORKS, platform.python_version(), sys.executable)


def _vtk():
    number = vtkCommonCore.vtkVersion.GetVTKVersion()
    return _part("VTK", WORKS, number, pathlib.Path(vtkCommonCore.__file__).parent)


def _numpy():
    return _imported("numpy", "arrays", packages.numpy_limit())


def _optional(name):
    package = packages.PACKAGES[name]
    if importlib.util.find_spec(name) is None:
        return _part(name, MISSING, use=package.use, cure=package.command)
    return _imported(name, package.use)


def _imported(name, use, limit=None):
    """Returns the part of an installed package, imported in another process."""
    code = f"import {name} as it; print(getattr(it, '__version__', '')); print(*it.__path__)"
    done = subprocess.run(
        [sys.executable, "-W", "ignore", "-c", code],
        capture_output=True,
        text=True,
        timeout=SECONDS,
        env={**os.environ, "PYTHONPATH": os.pathsep.join(filter(None, sys.path))},
    )
    lines = done.stdout.splitlines()
    if done.returncode == 0 and len(lines) >= 2:
        number = lines[-2] if lines[-2][:1].isdigit() else _version_of(name)
        return _part(name, WORKS, number, lines[-1], use)
    last = (done.stderr.strip().splitlines() or [f"ends with code {done.returncode}"])[-1]
    cure = (
        f"{packages.pip_install()} {limit}" if limit else packages.explain(name, ImportError(last))
    )
    return _part(name, BROKEN, _version_of(name), "", use, cure)


def _version_of(name):
    try:
        return importlib.metadata.version(name)
    except importlib.metadata.PackageNotFoundError:
        return ""


def _program(name, found, use, cure):
    return _part(name, WORKS if found else MISSING, "", found or "", use, "" if found else cure)


def _display():
    use = "pictures of plans, the viewer"
    if has_display():
        return _part("display", WORKS, place=os.environ.get("DISPLAY", ""), use=use)
    if found := shutil.which("xvfb-run"):
        return _part("display", WORKS, place=found, use=use)
    return _part("display", MISSING, use=use, cure="apt-get install xvfb xauth")
