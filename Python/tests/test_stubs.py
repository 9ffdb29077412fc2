# SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
# SPDX-License-Identifier: BSD-3-Clause
"""__init__.pyi matches the classes, and is valid Python."""

import ast
import importlib.util
import os
import pathlib
import subprocess
import sys

import pytest

import vtkhelios
from vtkhelios._built_with import VTK_VERSION
from vtkhelios.core.properties import snake_case

ROOT = pathlib.Path(__file__).resolve().parents[2]
CURE = "run build/venv/bin/python Python/make_stubs.py"


@pytest.fixture(scope="module")
def stubs():
    spec = importlib.util.spec_from_file_location("make_stubs", ROOT / "Python/make_stubs.py")
    module = importlib.util.module_from_spec(spec)
    spec.loader.exec_module(module)
    return module


def own_members(tree, cls):
    """Names in a class of a stub, without names of VTK's classes, which differ by its version."""
    mine = {name for name in vars(cls) if name[0].isupper()}  # methods in C++; not of its bases
    mine |= {snake_case(name[3:]) for name in mine if name.startswith("Get")}
    names = (
        getattr(node, "name", getattr(getattr(node, "target", 0), "id", "")) for node in tree.body
    )
    return mine.intersection(names)


def test_stub_is_current(stubs):
    text = stubs.STUB.read_text()
    trees = {getattr(node, "name", ""): node for node in ast.parse(text).body}
    head, blocks = stubs.make_blocks(vtkhelios)
    for name, block in blocks.items():  # classes of optional modules may be missing here, not there
        if VTK_VERSION.startswith("9.1."):  # version of the stub
            assert f"\n{block}" in text, f"{name} has changed: {CURE}"
        cls = getattr(vtkhelios, name)
        made = own_members(ast.parse(block).body[0], cls)
        assert made == own_members(trees[name], cls), f"{name} has changed: {CURE}"
    assert stubs.THIN_LAYER in text, CURE


def test_keywords_are_current(stubs):
    assert stubs.make_keywords(vtkhelios) == stubs.KEYWORDS.read_text(), CURE


USER = """\
import numpy as np
import vtkhelios

survey = vtkhelios.read_survey("survey.xml")
cloud = survey.run(tolerance=0.001, waveforms=True)
near: vtkhelios.Cloud = cloud[cloud["Range"] < 50] + vtkhelios.read("a.laz")
first: np.void = cloud[0]
survey.legs[0].scan_frequency = 50
survey.legs.append((10, 0), head=(0, 360))
scene = vtkhelios.Scene(np.zeros((3, 3)), np.zeros((1, 3), int))
made: vtkhelios.Survey = vtkhelios.make_survey(scene, [(0, 0)], scan_frequency=100)
lowest: float = vtkhelios.scan(scene, position=(0, 0), vertical=(-40, 60), seed=3).bounds[4]
sites = vtkhelios.plan(scene, grid=2).positions.shape
"""
WRONG = {
    "survey.run(tolerancy=1)": 'Unexpected keyword argument "tolerancy"',
    "survey.legs[0].scan_frequenz = 5": '"LegAttributes" has no attribute "scan_frequenz"',
    "cloud.pints": '"Cloud" has no attribute "pints"',
    "vtkhelios.scan(scene, position=(0, 0), seeds=3)": 'Unexpected keyword argument "seeds"',
    "bad: int = vtkhelios.read('a.las')": 'has type "Cloud", variable has type "int"',
}


def test_a_type_checker_finds_what_is_misspelt(tmp_path):
    pytest.importorskip("mypy")
    (tmp_path / "user.py").write_text(USER + "\n".join(WRONG) + "\n")
    options = ["--follow-imports=silent", "--ignore-missing-imports", f"--cache-dir={tmp_path}"]
    done = subprocess.run(
        [sys.executable, "-m", "mypy", *options, "user.py"],
        cwd=tmp_path,
        env={**os.environ, "MYPYPATH": str(pathlib.Path(vtkhelios.__file__).parents[1])},
        capture_output=True,
        text=True,
        timeout=300,
    )
    first = USER.count("\n") + 1
    lines = [line for line in done.stdout.splitlines() if ": error:" in line]
    assert len(lines) == len(WRONG), done.stdout + done.stderr
    for number, (line, message) in enumerate(zip(lines, WRONG.values()), first):
        assert line.startswith(f"user.py:{number}: error:") and message in line


def test_stub_is_python_and_types_are_known(stubs):
    tree = ast.parse(stubs.STUB.read_text())
    classes = {node.name: node for node in tree.body if isinstance(node, ast.ClassDef)}
    mirror = classes["vtkHeliosConicMirror"].body
    fields = {node.target.id: node for node in mirror if isinstance(node, ast.AnnAssign)}
    assert fields["scan_frequency"].annotation.id == "float"
    at = mirror.index(fields["scan_frequency"])
    assert "[Hz]" in mirror[at + 1].value.value
    imported = {
        alias.asname or alias.name
        for node in tree.body
        if isinstance(node, ast.ImportFrom)
        for alias in node.names
    }
    public = {name for name in vtkhelios.__all__ if not name.startswith("vtkHelios")}
    defined = imported | {node.name for node in tree.body if isinstance(node, ast.FunctionDef)}
    assert public <= defined | {"data_directory"}


def test_package_is_marked_as_typed():
    assert (pathlib.Path(vtkhelios.__file__).parent / "py.typed").is_file()
    assert (pathlib.Path(vtkhelios.__file__).parent / "__init__.pyi").is_file()
