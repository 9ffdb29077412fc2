# SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
# SPDX-License-Identifier: BSD-3-Clause
"""Writes all pages into a folder, which is emptied first."""

import pathlib
import shutil
import sys

from . import classes, commands, documents, examples, functions, gallery


def main(folder):
    """Writes all pages; returns the number of files."""
    shutil.rmtree(folder, ignore_errors=True)
    folder.mkdir(parents=True)
    reference = {
        "Reference": [
            *commands.make(folder),
            *functions.make(folder),
            *classes.make(folder),
        ],
        "Examples": [*examples.make(folder), *gallery.make(folder)],
    }
    documents.make(folder, reference)
    first = folder / documents.page_of(documents.HOME)
    first.write_text(gallery.make_cards(folder, first.read_text()))
    return sum(path.is_file() for path in folder.rglob("*"))


if __name__ == "__main__":
    print(main(pathlib.Path(sys.argv[1])), "files")
