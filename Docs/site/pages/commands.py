# SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
# SPDX-License-Identifier: BSD-3-Clause
"""A page for every command, from its --help."""

import subprocess
import sys

import vtkhelios.cli

from . import markdown

FOLDER = "commands"


def make(folder):
    """Writes the pages and their index."""
    (folder / FOLDER).mkdir()
    modules = vtkhelios.cli.commands()
    for name in modules:
        text = f"# vtkhelios {name}\n\n```text\n{help_of(name)}\n```\n"
        (folder / FOLDER / f"{name}.md").write_text(text)
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
