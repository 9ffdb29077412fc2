# SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
# SPDX-License-Identifier: BSD-3-Clause
"""vtkhelios view without a viewer reports the reason, and how to build one."""

import pathlib
import re

import pytest

import vtkhelios
from vtkhelios import cli
from vtkhelios.cli import view

ROOT = pathlib.Path(__file__).resolve().parents[3]


@pytest.fixture
def explain(monkeypatch, tmp_path, capsys):
    """The error of a build, or an installation, in tmp_path."""

    def call(has_viewer, is_build):
        package = tmp_path / "lib/python3/dist-packages/vtkhelios"
        package.mkdir(parents=True)
        if is_build:
            (tmp_path / "CMakeCache.txt").write_text("")
        monkeypatch.setattr(vtkhelios, "__file__", str(package / "__init__.py"))
        monkeypatch.setattr(view, "HAS_VIEWER", has_viewer)
        monkeypatch.setenv("PATH", str(tmp_path))
        assert cli.main(["view", "--help"]) == 1
        return capsys.readouterr().err

    return call


def test_not_built_yet(explain, tmp_path):
    assert explain(True, True) == (
        "error: vtkhelios-viewer is not built yet; build it: "
        f"cmake --build {tmp_path} --target vtkhelios-viewer\n"
    )


def test_disabled_in_the_build(explain, tmp_path):
    assert explain(False, True) == (
        "error: vtkhelios-viewer is left out of this build (VTKHELIOS_BUILD_VIEWER is OFF); build it: "
        f"cmake -DVTKHELIOS_BUILD_VIEWER=ON {tmp_path} && "
        f"cmake --build {tmp_path} --target vtkhelios-viewer\n"
    )


def test_not_installed(explain, tmp_path):
    assert explain(True, False) == (
        f"error: vtkhelios-viewer is not installed in {tmp_path / 'bin'}; install it: "
        "cmake --install BUILD\n"
    )


def test_disabled_in_the_installation(explain):
    assert explain(False, False) == (
        "error: vtkhelios-viewer was left out when vtkHelios was built; build it with "
        "-DVTKHELIOS_BUILD_VIEWER=ON\n"
    )


def test_wheel(explain, monkeypatch):
    monkeypatch.setattr(view, "VTK_PACKAGE", "vtkhelios.vtkmodules")
    assert explain(False, False) == (
        "error: the wheel has no vtkhelios-viewer, which needs X11 and OpenGL; show clouds with PyVista "
        "(vtkhelios.Cloud.to_pyvista), or build vtkHelios from its sources: Docs/install.md\n"
    )


def test_flag_equals_that_of_the_build():
    cache = pathlib.Path(vtkhelios.__file__).absolute().parents[4] / "CMakeCache.txt"
    if not cache.is_file():
        pytest.skip("this is no build tree")
    is_on = "VTKHELIOS_BUILD_VIEWER:BOOL=ON\n" in cache.read_text()
    assert view.HAS_VIEWER is is_on


def test_demo_builds_what_the_readme_shows():
    """README.md refers new users to vtkhelios view after Apps/demo.sh: it builds the viewer, last."""
    script = (ROOT / "Apps/demo.sh").read_text()
    assert "build/bin/vtkhelios view" in (ROOT / "README.md").read_text()
    built = re.findall(r"^helios_build release ([\w -]*\w)", script, re.M)
    assert built == ["vtkhelios_core", f"vtkhelios_package {view.PROGRAM}"]
    assert script.index("vtkhelios.picture") < script.index(f"helios_build release {built[1]}")
