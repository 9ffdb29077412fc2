# SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
# SPDX-License-Identifier: BSD-3-Clause
"""The examples: notebooks as text and code, scripts as they are. Tests run them all."""

import ast
import json
import pathlib

from . import markdown

ROOT = pathlib.Path(__file__).resolve().parents[3]
FOLDER = "examples"


def make(folder):
    """Writes the pages and their index."""
    (folder / FOLDER).mkdir()
    sources = sorted((ROOT / "Python/examples").glob("*.ipynb"))
    sources += sorted((ROOT / "Python/examples").glob("[a-z]*.py"))
    pages = {path.stem: page(path) for path in sources}
    for name, text in pages.items():
        (folder / FOLDER / f"{name}.md").write_text(text)
    intro = "# Examples\n\nThe files are in `Python/examples`; tests run them.\n\n"
    (folder / FOLDER / "index.md").write_text(intro + markdown.contents(list(pages), hidden=False))
    return [f"{FOLDER}/index"]


def page(path):
    """An example as Markdown."""
    return _notebook(path) if path.suffix == ".ipynb" else _script(path)


def _notebook(path):
    cells = json.loads(path.read_text())["cells"]
    texts = ["".join(cell["source"]) for cell in cells]
    return "\n\n".join(
        text if cell["cell_type"] == "markdown" else f"```python\n{text}\n```"
        for cell, text in zip(cells, texts, strict=True)
    )


def _script(path):
    text = path.read_text()
    title, _, rest = (ast.get_docstring(ast.parse(text)) or path.stem).partition("\n")
    return f"# {path.stem}\n\n{markdown.line(title)}\n\n{markdown.prose(rest)}\n\n```python\n{text}```\n"
