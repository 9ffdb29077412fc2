# SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
# SPDX-License-Identifier: BSD-3-Clause
"""Names of arrays are literals in the headers of array names only."""

import ast
import importlib.util
import pathlib
import re

import pytest

from vtkhelios import array_names

ROOT = pathlib.Path(__file__).resolve().parents[2]
PACKAGE = ROOT / "Python/vtkhelios"
NAMES = {value for name, value in vars(array_names).items() if name.isupper() and name != "UNITS"}
# Other meanings of the same words.
OTHERS = {
    ("cli/convert.py", "CRS"),  # an option's metavar
    ("cli/_plan_options.py", "CRS"),
    ("flight/_survey.py", "ScanAngle"),  # a property of a writer
    ("plans/files.py", "ScanAngle"),
}


@pytest.fixture(scope="module")
def stubs():
    spec = importlib.util.spec_from_file_location("make_stubs", ROOT / "Python/make_stubs.py")
    module = importlib.util.module_from_spec(spec)
    spec.loader.exec_module(module)
    return module


def literals(text):
    """Names of arrays in the texts of Python code, also in lists of words; not in docstrings."""
    tree = ast.parse(text)
    docs = {
        id(node.value)
        for node in ast.walk(tree)
        if isinstance(node, ast.Expr) and isinstance(node.value, ast.Constant)
    }
    for node in ast.walk(tree):
        if isinstance(node, ast.Constant) and isinstance(node.value, str) and id(node) not in docs:
            words = node.value.split()
            if words and NAMES.issuperset(words):
                yield node.lineno, node.value


@pytest.mark.parametrize("path", sorted(PACKAGE.rglob("*.py")), ids=lambda path: path.name)
def test_library_has_no_literals(path):
    name = path.relative_to(PACKAGE).as_posix()
    found = [
        f"{name}:{line}: {text}"
        for line, text in literals(path.read_text())
        if name != "array_names.py" and (name, text) not in OTHERS
    ]
    assert found == [], "import the name from vtkhelios.array_names"


def test_literals_are_found():
    code = '"""GpsTime"""\nx["GpsTime"]\n"Range Amplitude".split()\nf"{x}"\n"a Range"\n'
    assert list(literals(code)) == [(2, "GpsTime"), (3, "Range Amplitude")]


def test_file_is_current(stubs):
    text = stubs.make_array_names()
    assert text == stubs.ARRAY_NAMES.read_text(), "run build/venv/bin/python Python/make_stubs.py"


def test_every_name_of_the_headers_is_there(stubs):
    headers = "".join((ROOT / header).read_text() for header in stubs.NAME_HEADERS)
    assert set(re.findall(r'=\s*"(.+)";', headers)) == NAMES
    assert array_names.MATERIAL_SPECULAR_EXPONENT == "Material.SpecularExponent"


def test_comments_and_units_are_those_of_the_header(stubs, tmp_path):
    header = tmp_path / "names.h"
    header.write_text(
        "/** @class x */\n#define x\n\nnamespace x\n{\n\n///@{\n/** Scene:\n * one. */\n"
        'inline constexpr const char* TrueRange = "Range"; // [m], true\n'
        '// bits\ninline constexpr const char* PAD =\n  "PAD"; // [0..1]\n///@}\n'
    )
    text = stubs.make_array_names([header])
    assert text == stubs.NAMES_HEAD + (
        '\n# Scene: one.\nTRUE_RANGE = "Range"  # [m], true\n# bits\nPAD = "PAD"  # [0..1]\n\n'
        '# Units of the arrays that have one.\nUNITS = {\n    TRUE_RANGE: "m",\n}\n'
    )
