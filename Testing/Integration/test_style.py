# SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
# SPDX-License-Identifier: BSD-3-Clause
"""Formatting, spelling and licence lines of all tracked files."""

import pathlib
import shutil
import subprocess
import sys

import pytest

ROOT = pathlib.Path(__file__).resolve().parents[2]


def tracked(*suffixes):
    """The tracked files with these suffixes, without inputs of the fuzz tests."""
    if not shutil.which("git") or not (ROOT / ".git").exists():
        pytest.skip("not a git checkout")
    listing = subprocess.run(
        ["git", "ls-files", "-z"], cwd=ROOT, capture_output=True, check=True, text=True
    ).stdout
    files = [pathlib.Path(name) for name in listing.split("\0") if name]
    return [
        str(path)
        for path in files
        if path.suffix in suffixes and "seeds" not in path.parts and (ROOT / path).is_file()
    ]


def run(tool, *arguments):
    """What a tool prints, of the environment or of the system; skips if it is not installed."""
    program = shutil.which(tool, path=pathlib.Path(sys.executable).parent) or shutil.which(tool)
    if not program:
        pytest.skip(f"{tool} is not installed")
    done = subprocess.run(
        [program, *arguments],
        cwd=ROOT,
        stdout=subprocess.PIPE,
        stderr=subprocess.STDOUT,
        text=True,
    )
    return done.returncode, done.stdout


def test_clang_format():
    code, text = run("clang-format-14", "--dry-run", "-Werror", *tracked(".h", ".cxx"))
    assert code == 0, f"run clang-format-14 -i:\n{text}"


def test_black():
    code, text = run("black", "--check", "--quiet", *tracked(".py"))
    assert code == 0, f"run black on:\n{text}"


def test_ruff():
    code, text = run("ruff", "check", "--quiet", "--no-cache", *tracked(".py", ".ipynb"))
    assert code == 0, text


def test_spelling():
    code, text = run(
        "codespell", *tracked(".h", ".cxx", ".py", ".md", ".sh", ".cmake", ".xml", ".txt")
    )
    assert code == 0, text


def test_licence_lines():
    files = tracked(".h", ".cxx", ".py", ".sh", ".cmake", ".module") + [
        name for name in tracked(".txt") if name.endswith("CMakeLists.txt")
    ]
    missing = [name for name in files if "SPDX-License-Identifier" not in (ROOT / name).read_text()]
    assert missing == []


def test_errors_are_a_status():
    told = [
        name
        for name in tracked(".h", ".cxx")
        if "or an empty string" in " ".join((ROOT / name).read_text().replace("///", "").split())
    ]
    assert told == [], "return helios::Status (heliosStatus.h)"
