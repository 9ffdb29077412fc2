# SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
# SPDX-License-Identifier: BSD-3-Clause
"""The installed package in other projects: find_package(vtkHelios), and pip install."""

import json
import os
import pathlib
import re
import subprocess

import pytest

import vtkhelios

HERE = pathlib.Path(__file__).resolve().parent
ROOT = HERE.parents[1]
BUILD = pathlib.Path(vtkhelios.__file__).absolute().parents[4]  # <build>/lib/python3/dist-packages


def call(*command, **options):
    """Runs a command, without the PYTHONPATH of this build, and returns its output."""
    environment = {key: value for key, value in os.environ.items() if key != "PYTHONPATH"}
    done = subprocess.run(
        [str(word) for word in command],
        env=environment,
        text=True,
        stdout=subprocess.PIPE,
        stderr=subprocess.STDOUT,
        **options,
    )
    if "Could not find a version that satisfies the requirement scikit-build-core" in done.stdout:
        pytest.skip("pip cannot reach the package index")
    assert done.returncode == 0, done.stdout
    return done.stdout


@pytest.fixture(scope="module")
def prefix(tmp_path_factory):
    folder = tmp_path_factory.mktemp("prefix")
    call("cmake", "--install", BUILD, "--prefix", folder)
    return folder


@pytest.fixture(scope="module")
def project(prefix, tmp_path_factory):
    folder = tmp_path_factory.mktemp("project")
    settings = [f"-DCMAKE_PREFIX_PATH={prefix}", "-DCMAKE_BUILD_TYPE=Release"]
    call("cmake", "-S", HERE, "-B", folder, "-G", "Ninja", *settings)
    call("cmake", "--build", folder)
    return folder


def test_separate_project_with_its_own_deflector(project):
    output = call(project / "own_deflector")
    assert output.startswith("1000 echoes, largest error")


def test_installed_command_line_with_a_plugin_in_cpp(prefix, project, tmp_path):
    program = prefix / "bin/vtkhelios"
    call(program, "new", tmp_path / "yard", "--kind", "tls")
    survey = tmp_path / "yard/yard.xml"
    plugin = ["--plugin", project / "libown_detector.so", "--detector", "firstSample"]
    call(program, "run", survey, *plugin, "--output", tmp_path / "out", "--no-accuracy-report")
    (summary,) = (tmp_path / "out").rglob("run_summary.json")
    report = json.loads(summary.read_text())
    assert report["options"]["detector"] == "firstSample"
    assert report["totals"]["points"] > 1000
    assert str(project / "libown_detector.so") in [each["file"] for each in report["inputs"]]
    if (BUILD / "bin/vtkhelios-viewer").exists():
        text = survey.read_text().replace("<survey ", '<survey echoDetector="firstSample" ', 1)
        survey.write_text(text)
        still = tmp_path / "still.png"
        call(program, "view", survey, *plugin[:2], "--offscreen", "--still", still)
        assert still.stat().st_size > 1000


def test_missing_component_is_reported(prefix, tmp_path):
    (tmp_path / "CMakeLists.txt").write_text(
        "cmake_minimum_required(VERSION 3.25)\nproject(p C CXX)\n"
        "find_package(vtkHelios COMPONENTS ScannerCore Nonesuch)\n"
    )
    output = call("cmake", "-S", tmp_path, "-B", tmp_path / "b", f"-DCMAKE_PREFIX_PATH={prefix}")
    assert "there is no module Nonesuch; built are" in " ".join(output.split())


def test_installed_command_line(prefix, tmp_path):
    output = call(prefix / "bin/vtkhelios", "--version", cwd=tmp_path)
    assert output.strip() == f"vtkhelios {vtkhelios.__version__}"


def test_installed_viewer(prefix, tmp_path):
    if not (BUILD / "bin/vtkhelios-viewer").exists():
        pytest.skip("built without the viewer")
    assert call(prefix / "bin/vtkhelios", "view", "--version", cwd=tmp_path).split()[-1] == (
        vtkhelios.__version__
    )


def test_installed_files_do_not_name_the_build_folder(prefix):
    for path in prefix.rglob("*"):
        if path.suffix in (".cmake", ".py", ".h", "") and path.is_file():
            assert str(BUILD) not in path.read_text(errors="replace"), path


@pytest.mark.slow
def test_pip_install(tmp_path):
    call("/usr/bin/python3", "-m", "venv", "--system-site-packages", tmp_path / "venv")
    python = tmp_path / "venv/bin/python"
    pip = [python, "-m", "pip", "--quiet", "--disable-pip-version-check"]
    build_tool = [*pip, "download", "--no-deps", "-d", tmp_path, "scikit-build-core"]
    if subprocess.run(build_tool, capture_output=True, check=False).returncode:
        pytest.skip("no package index that has scikit-build-core can be reached")
    call(*pip, "install", ROOT)
    assert call(tmp_path / "venv/bin/vtkhelios", "--version", cwd=tmp_path).strip() == (
        f"vtkhelios {vtkhelios.__version__}"
    )
    assert call(tmp_path / "venv/bin/vtkhelios", "view", "--version", cwd=tmp_path).split()[-1] == (
        vtkhelios.__version__
    )
    names = call(
        python,
        "-c",
        "import vtkhelios; print(*vtkhelios.__all__, vtkhelios.__file__)",
        cwd=tmp_path,
    ).split()
    under_gpl = {"vtkHeliosCgalRayCaster", "vtkHeliosMeshSimplify"}  # omitted unless requested
    assert names[:-1] == [name for name in vtkhelios.__all__ if name not in under_gpl]
    assert names[-1].startswith(str(tmp_path))


def test_version_is_one():
    version = re.search(
        r"project\(vtkHelios VERSION ([\d.]+)", (ROOT / "CMakeLists.txt").read_text()
    )
    assert version.group(1) == vtkhelios.__version__
