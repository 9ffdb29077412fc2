# SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
# SPDX-License-Identifier: BSD-3-Clause
"""Names of the files of a run come from vtkHeliosRunFiles only."""

import ast
import pathlib
import re

import pytest

from vtkhelios.core import run_files as files

PACKAGE = pathlib.Path(__file__).resolve().parents[2] / "Python/vtkhelios"
NAMES = re.compile(
    r"^_(points|fullwave|pulse|trajectory)$|(?<!test)_(points|fullwave|pulse|trajectory)(\.|\*|_dev)"
    r"|run\.journal|run_summary|\.part$"
)


def short_texts(text):
    """The texts of one line in Python code, without docstrings and arguments of help."""
    tree = ast.parse(text)
    left_out = {
        id(node.value)
        for node in ast.walk(tree)
        if isinstance(node, ast.Expr) or isinstance(node, ast.keyword) and node.arg == "help"
    }
    for node in ast.walk(tree):
        is_text = isinstance(node, ast.Constant) and isinstance(node.value, str)
        if is_text and id(node) not in left_out and "\n" not in node.value:
            yield node.lineno, node.value


@pytest.mark.parametrize("path", sorted(PACKAGE.rglob("*.py")), ids=lambda path: path.name)
def test_library_has_no_names_of_its_own(path):
    found = [
        f"{path.name}:{line}: {text}"
        for line, text in short_texts(path.read_text())
        if NAMES.search(text)
    ]
    assert found == [], "use vtkhelios.core.run_files"


def test_names_are_found():
    code = (
        'a = "leg000_points.xyz"\nb = f"{x}_trajectory.txt"\nc(help="run.journal")\nd = ".part"\n'
    )
    found = sorted(line for line, text in short_texts(code) if NAMES.search(text))
    assert found == [1, 2, 4]


def test_names_of_any_encoding():
    name = "strip\udcff\udcfe\udcfd_points_dev1.xyz"  # not UTF-8
    assert files.kind_of(name) == files.POINTS
    assert files.stem_of(name) == "strip\udcff\udcfe\udcfd"
    assert files.number_of(name) == -1
    folder = pathlib.Path("folder")
    assert files.beside(folder / name, files.TRAJECTORY) == [
        folder / "strip\udcff\udcfe\udcfd_trajectory.txt",
        folder / "strip\udcff\udcfe\udcfd_trajectory.pvtp",
    ]
    assert files.beside(folder / "a.xyz", files.TRAJECTORY) == []
    assert files.kind_of(folder / "\udcff.xyz") == -1


def test_facts_of_a_run():
    assert files.FORMATS == ("xyz", "las", "laz", "copc", "vtp")
    assert (files.SUMMARY_NAME, files.JOURNAL_NAME, files.PART) == (
        "run_summary.json",
        "run.journal",
        ".part",
    )
    assert files.is_epoch(pathlib.Path("a/epoch012")) and not files.is_epoch(
        pathlib.Path("a/epoch")
    )
