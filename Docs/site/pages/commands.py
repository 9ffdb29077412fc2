# SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
# SPDX-License-Identifier: BSD-3-Clause
"""A page for every command, from its --help, with an anchor for each option."""

import re
import subprocess
import sys

import vtkhelios.cli

from . import markdown

FOLDER = "commands"
SECTION = re.compile(r"^(\S[^\n]*):\n((?: {2}[^\n]*\n)+)", re.M)  # a title, and its lines indented
ITEM = re.compile(r"^ {2}(\S.*?)(?: {2,}(.*))?\n((?: {3,}.*\n)*)", re.M)  # a term, and its text


def make(folder):
    """Writes the pages and their index."""
    (folder / FOLDER).mkdir()
    modules = vtkhelios.cli.commands()
    for name in modules:
        (folder / FOLDER / f"{name}.md").write_text(page(name, help_of(name)))
    rows = [
        [f"[vtkhelios {name}]({name}.md)", markdown.line(modules[name].SUMMARY)] for name in modules
    ]
    (folder / FOLDER / "index.md").write_text(
        "# Commands\n\n"
        + markdown.table(["command", ""], rows)
        + f"\n```text\n{help_of()}\n```\n\n"
        + markdown.contents(list(modules))
    )
    return [f"{FOLDER}/index"]


def page(name, text):
    """The page of a command: what --help prints, its arguments as entries with anchors."""
    parts = [f"# vtkhelios {name}\n\n```{{program}} vtkhelios {name}\n```\n"]
    text, begin, known = text.rstrip("\n") + "\n", 0, set()
    for section in SECTION.finditer(text):
        items = [_entry(item) for item in ITEM.finditer(section[2])]
        names = {
            word for names, _ in items for word in re.findall(r"(?<![\w-])--?[a-z][\w-]*", names)
        }
        listed = section[1].lower() in ("positional arguments", "positionals")
        if listed or (items and all(names[0] == "-" for names, _ in items) and not names & known):
            known |= names
            title = markdown.escape(section[1][:1].upper() + section[1][1:])
            parts += [_plain(text[begin : section.start()]), f"## {title}\n", *map(_option, items)]
            begin = section.end()
    return "\n".join([*parts, _plain(text[begin:])])


def _entry(item):
    """The names and the text of an argument."""
    names = re.sub(r"^(-\w),(?=-)", r"\1, ", item[1]).replace("{false}", "")
    return names, " ".join(f"{item[2] or ''} {item[3]}".split())


def _option(item):
    return f"```{{option}} {item[0]}\n{markdown.line(item[1])}\n```\n"


def _plain(text):
    return f"```text\n{text.strip(chr(10))}\n```\n" if text.strip() else ""


def help_of(*words):
    """Returns the text of --help, for 100 columns."""
    done = subprocess.run(
        [sys.executable, "-P", "-m", "vtkhelios", *words, "--help"],
        capture_output=True,
        text=True,
        check=True,
        env={"COLUMNS": "100", "PYTHONPATH": ":".join(sys.path), "NO_COLOR": "1"},
    )
    return done.stdout.rstrip()
