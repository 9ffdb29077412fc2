# SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
# SPDX-License-Identifier: BSD-3-Clause
"""Texts of the code as Markdown."""

import inspect
import re

SPECIAL = re.compile(r"([\\*_<>\[\]|`#~$])")
DEFINITION = re.compile(r"^(\S.*)\n((?: {4}.*(?:\n|$))+)", re.M)  # a term, and its text indented
DEFINITIONS = re.compile(rf"(?:{DEFINITION.pattern})+", re.M)
CODE = re.compile(r"``(.+?)``", re.S)


def escape(text):
    """Plain text, whose characters have no meaning in Markdown."""
    return SPECIAL.sub(r"\\\1", text)


def code(text):
    """Text in the font of code, within a line or a cell of a table."""
    fence = "``" if "`" in text else "`"
    return f"{fence}{text}{fence}".replace("|", "\\|")


def line(text):
    """A docstring, or a part of one, as one line."""
    return _inline(" ".join(text.split()))


def prose(text):
    """A docstring as Markdown: paragraphs, lists, and indented or ``>>>`` blocks as code."""
    blocks = re.split(r"\n\s*\n", inspect.cleandoc(text or ""))
    return "\n\n".join(_block(block) for block in blocks if block.strip())


def table(head, rows):
    """A table of cells that are Markdown already."""
    lines = [head, ["---"] * len(head), *rows]
    return "".join(f"| {' | '.join(cells)} |\n" for cells in lines) if rows else ""


def contents(names, caption=None, hidden=True):
    """A table of contents for Sphinx."""
    options = [":maxdepth: 1", *([":hidden:"] if hidden else [])]
    options += [f":caption: {caption}"] if caption else []
    return "\n".join(["```{toctree}", *options, "", *names, "```", ""])


def _block(block):
    lines = block.split("\n")
    if lines[0].startswith(">>>"):
        return f"```pycon\n{block}\n```"
    if all(part.startswith("    ") for part in lines):
        return f"```\n{inspect.cleandoc(block)}\n```"
    if any(re.match(r"\S+ {2,}\S", part) for part in lines):  # columns: a term and its text
        return f"```\n{block}\n```"
    if DEFINITIONS.fullmatch(block):
        return "\n".join(
            f"- {code(term)}: {line(text)}" for term, text in DEFINITION.findall(block)
        )
    before, *items = re.split(r"(?:^|\n)\s*[-*] ", block)
    paragraph = [line(before)] + [""] * bool(items) if before else []
    return "\n".join([*paragraph, *(f"- {line(item)}" for item in items)])


def _inline(text):
    """Escapes text, but for what is ``code``."""
    parts = CODE.split(text)
    return "".join(code(part) if i % 2 else escape(part) for i, part in enumerate(parts))
