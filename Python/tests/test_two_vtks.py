# SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
# SPDX-License-Identifier: BSD-3-Clause
"""With another VTK the import fails with a message, before anything crashes.

The tests create their own vtkmodules; they also run with PyPI's, if installed:
build/venv/bin/python -m pip install --no-deps --target build/other-vtk vtk
"""

import os
import pathlib
import re
import subprocess
import sys

import pytest

from vtkhelios.core import vtk_check as _vtk
from vtkhelios._built_with import VTK_LIBRARY, VTK_VERSION

PYPI = pathlib.Path(__file__).resolve().parents[2] / "build/other-vtk"


def make_other(folder, version="9.0.3", library=None):
    """A package that looks like VTK's; with a library, its binary module links to that."""
    modules = folder / "vtkmodules"
    modules.mkdir()
    version = f'__version__ = "{version}"\n' if version else ""
    (modules / "__init__.py").write_text(f"# VTK\n{version}")
    (modules / "vtkCommonCore.py").write_text("")
    if library:
        (modules / "vtkCommonCore.py").unlink()
        (modules / "vtkCommonCore.so").write_bytes(b"\x7fELF\0" + library.encode() + b"\0")
    (folder / "vtk.py").write_text("import vtkmodules.vtkCommonCore\n")
    return folder


def do(code, *folders):
    return subprocess.run(
        [sys.executable, "-P", "-c", code],
        capture_output=True,
        text=True,
        env={**os.environ, "PYTHONPATH": ":".join(map(str, [*folders, *sys.path]))},
    )


def expect_refusal(done, folder, version, verb):
    assert done.returncode == 1, done
    error = done.stderr.splitlines()[-1]
    assert error == (
        f"ImportError: vtkHelios was built with VTK {VTK_VERSION} ({VTK_LIBRARY}), but this Python "
        f"{verb} VTK {version} ({folder}/vtkmodules), and two VTKs in one process crash it. "
        f"Remove it ({sys.executable} -m pip uninstall vtk), or use vtkHelios in an environment "
        "without it; Docs/python.md names the PyVista versions without a VTK of their own"
    )


@pytest.fixture(params=["made", "PyPI"])
def other(request, tmp_path):
    """A folder with another VTK, and its version."""
    if request.param == "made":
        return make_other(tmp_path), "9.0.3"
    if not (PYPI / "vtkmodules").is_dir():
        pytest.skip("PyPI's vtk is not in build/other-vtk")
    text = (PYPI / "vtkmodules/__init__.py").read_text()
    return PYPI, re.search('__version__ = "(.*)"', text)[1]


@pytest.mark.parametrize("code", ["import vtkhelios, vtk", "import vtkhelios.cli"])
def test_vtkhelios_first(other, code):
    expect_refusal(do(code, other[0]), *other, "would load")


@pytest.mark.parametrize("first", ["vtk", "vtkmodules.vtkCommonCore"])
def test_other_vtk_first(other, first):
    expect_refusal(do(f"import {first}, vtkhelios", other[0]), *other, "has loaded")


def test_only_the_package_is_loaded(other):
    expect_refusal(do("import vtkmodules, vtkhelios", other[0]), *other, "would load")


def test_command_line(other):
    done = do("import runpy; runpy.run_module('vtkhelios', run_name='__main__')", other[0])
    expect_refusal(done, *other, "would load")


def test_binaries_are_compared_before_versions(tmp_path):
    """The same version with other libraries, like PyPI's 9.1.0."""
    make_other(tmp_path, VTK_VERSION, "libvtkCommonCore-9.1.so")
    expect_refusal(do("import vtkhelios", tmp_path), tmp_path, VTK_VERSION, "would load")


def test_unknown_version(tmp_path):
    make_other(tmp_path, version=None)
    expect_refusal(do("import vtkhelios", tmp_path), tmp_path, "of unknown version", "would load")


def test_no_vtk():
    hidden = "import importlib.util as util; find = util.find_spec; "
    hidden += "util.find_spec = lambda name, *more: name != 'vtkmodules' and find(name, *more); "
    done = do(hidden + "import vtkhelios")
    assert done.returncode == 1
    assert f"ImportError: vtkHelios needs the Python modules of VTK {VTK_VERSION}" in done.stderr
    assert "apt-get install python3-vtk9" in done.stderr


def test_standard_import_of_the_same_vtk():
    assert do("import vtkmodules.all, vtkhelios").returncode == 0
    assert (
        do("import vtkhelios, vtk; vtk.vtkObject(), vtkhelios.vtkHeliosScanner()").returncode == 0
    )


def test_other_name_of_the_modules():
    """vtkhelios.vtkmodules names the modules themselves, so that classes are the same."""
    import vtkmodules.util.numpy_support as stock
    from vtkmodules.vtkCommonCore import vtkPoints as Stock

    import vtkhelios.vtkmodules.util.numpy_support as other
    from vtkhelios.vtkmodules import vtkCommonDataModel
    from vtkhelios.vtkmodules.vtkCommonCore import vtkPoints

    assert other is stock and stock.__spec__.name == "vtkmodules.util.numpy_support"
    assert vtkPoints is Stock
    assert vtkCommonDataModel is sys.modules["vtkmodules.vtkCommonDataModel"]
    with pytest.raises(ModuleNotFoundError, match=r"vtkhelios\.vtkmodules\.vtkNothing"):
        import vtkhelios.vtkmodules.vtkNothing  # noqa: F401


def test_a_vtk_of_its_own_works_beside_others(monkeypatch):
    monkeypatch.setattr(_vtk, "_find_folder", lambda: None)
    with pytest.raises(ImportError):
        _vtk.check_vtk()
    monkeypatch.setattr(_vtk, "VTK_PACKAGE", "vtkhelios.vtkmodules")
    _vtk.check_vtk()
