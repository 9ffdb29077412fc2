# SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
# SPDX-License-Identifier: BSD-3-Clause
"""Writes the table of endings and commands of Docs/files.md, from vtkhelios.formats._endings.

    build/venv/bin/python Python/make_endings.py

A test fails when it is out of date.
"""

import pathlib
import sys

ROOT = pathlib.Path(__file__).resolve().parents[1]
PAGE = ROOT / "Docs/files.md"
BEGIN, END = "<!-- endings: begin -->\n", "<!-- endings: end -->\n"


def make_page(text):
    """The text of the page with the table of today."""
    from vtkhelios.formats import _endings

    before, rest = text.split(BEGIN)
    return before + BEGIN + _endings.make_table() + END + rest.split(END)[1]


if __name__ == "__main__":
    sys.path.insert(0, str(ROOT / "build/lib/python3/dist-packages"))
    PAGE.write_text(make_page(PAGE.read_text(encoding="utf-8")), encoding="utf-8")
