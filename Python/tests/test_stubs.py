# SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
# SPDX-License-Identifier: BSD-3-Clause
"""__init__.pyi matches the classes, and is valid Python."""

import ast
import importlib.util
import pathlib

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
