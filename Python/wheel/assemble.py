#!/usr/bin/env python3
# SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
# SPDX-License-Identifier: BSD-3-Clause
"""Adds to a wheel of vtkHelios what it otherwise finds on Debian: the Python modules of VTK and the
database of PROJ. build.sh runs it.

The modules of VTK become the package vtkhelios.vtkmodules, and the package vtkhelios imports them by
that name. The libraries are added by auditwheel.
"""

import argparse
import pathlib
import re
import shutil
import subprocess
import sys
import tempfile

VTK_MODULES = pathlib.Path("/usr/lib/python3/dist-packages/vtkmodules")
# Python files of VTK that work without its modules for drawing.
UTILITIES = (
    "__init__", "keys", "misc", "numpy_support", "vtkAlgorithm", "vtkConstants", "vtkVariant",
)  # fmt: skip

DRAWING = ("picture.py",)  # with the VTK of PyPI, which draws, if it is installed

_IMPORT = re.compile(r"\b(from|import) vtkmodules\b")


def parse():
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("wheel", type=pathlib.Path, help="changed in place")
    parser.add_argument("--proj", type=pathlib.Path, required=True, help="where PROJ is installed")
    return parser.parse_args()


def add_vtk_modules(package):
    """Adds the Python files of VTK to vtkhelios/vtkmodules, which has its wrapped modules."""
    folder = package / "vtkmodules"
    (folder / "util").mkdir()
    for name in UTILITIES:
        shutil.copy(VTK_MODULES / f"util/{name}.py", folder / "util")
    version = re.search(r"VTK_VERSION = \"(.*)\"", (package / "_built_with.py").read_text())[1]
    (folder / "__init__.py").write_text(  # was another name for the VTK of a system
        f'"""The VTK of vtkHelios: vtkmodules under another name."""\n\n__version__ = "{version}"\n'
    )


def add_proj_data(package, proj):
    """vtkhelios/share/proj: where PROJ searches, from its library in vtkhelios/lib."""
    folder = package / "share/proj"
    folder.mkdir(parents=True)
    for name in ("proj.db", "proj.ini"):
        shutil.copy(proj / "share/proj" / name, folder)


def rename_imports(package):
    """vtkmodules is vtkhelios.vtkmodules in all Python files and stubs but those of DRAWING."""
    for path in [*package.rglob("*.py"), *package.rglob("*.pyi")]:
        if path.name in DRAWING:
            continue
        text = path.read_text(encoding="utf-8")
        path.write_text(_IMPORT.sub(r"\1 vtkhelios.vtkmodules", text), encoding="utf-8")


def wheel_tool(*arguments):
    subprocess.run([sys.executable, "-m", "wheel", *map(str, arguments)], check=True)


def main():
    given = parse()
    with tempfile.TemporaryDirectory() as scratch:
        wheel_tool("unpack", given.wheel, "--dest", scratch)
        tree = next(pathlib.Path(scratch).iterdir())
        package = tree / "vtkhelios"
        add_vtk_modules(package)
        add_proj_data(package, given.proj)
        rename_imports(package)
        given.wheel.unlink()
        wheel_tool("pack", tree, "--dest-dir", given.wheel.parent)


if __name__ == "__main__":
    main()
