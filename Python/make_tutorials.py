# SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
# SPDX-License-Identifier: BSD-3-Clause
"""Writes the notebooks of Docs/tutorials from its pages.

    build/venv/bin/python Python/make_tutorials.py

Of a page, blocks of code are cells: ``python`` as they are, blocks without a language as commands of a
shell, and a block after a line that ends with its `name`: as a file. All between them is text, blocks of other
languages too. A test fails when a notebook is out of date.
"""

import json
import pathlib
import re

ROOT = pathlib.Path(__file__).resolve().parents[1]
PAGES = sorted((ROOT / "Docs/tutorials").glob("*.md"))
FENCE = re.compile(r"^```(\w*)\n(.*?)^```$", re.M | re.S)
FILE_NAME = re.compile(r"`([^`\n]+\.\w+)`:\s*\Z")


def read_cells(text):
    """The cells of a page in their order: (kind, text, name), with kind text, python, shell or file."""
    cells, begin = [], 0
    for block in FENCE.finditer(text):
        language, code = block[1], block[2].rstrip("\n")
        named = FILE_NAME.search(text, begin, block.start())
        kind = {"": "shell", "python": "python"}.get(language) or (named and "file")
        if kind:
            cells += [
                ("text", text[begin : block.start()].strip(), ""),
                (kind, code, named[1] if kind == "file" else ""),
            ]
            begin = block.end()
    return [cell for cell in [*cells, ("text", text[begin:].strip(), "")] if cell[1]]


def make_notebook(text):
    """The notebook of a page as JSON."""
    heads = {"python": "", "shell": "%%bash -e\n", "file": "%%writefile {}\n"}
    cells = []
    for number, (kind, code, name) in enumerate(read_cells(text)):
        cell = {"cell_type": "markdown", "id": f"cell{number}", "metadata": {}, "source": code}
        if kind != "text":
            code = heads[kind].format(name) + code
            cell |= {"cell_type": "code", "execution_count": None, "outputs": []}
        cells.append(cell | {"source": code.splitlines(keepends=True)})
    kernel = {"display_name": "Python 3", "language": "python", "name": "python3"}
    notebook = {
        "cells": cells,
        "metadata": {"kernelspec": kernel},
        "nbformat": 4,
        "nbformat_minor": 5,
    }
    return json.dumps(notebook, indent=1, ensure_ascii=False) + "\n"


if __name__ == "__main__":
    for page in PAGES:
        page.with_suffix(".ipynb").write_text(
            make_notebook(page.read_text(encoding="utf-8")), encoding="utf-8"
        )
