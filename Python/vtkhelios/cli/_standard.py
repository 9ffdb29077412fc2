# SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
# SPDX-License-Identifier: BSD-3-Clause
"""Standard input and output as files, named -: formats need files that can be searched."""

import contextlib
import os
import pathlib
import shutil
import sys
import tempfile

NAME = "-"
BLOCK = 1 << 20  # bytes copied at a time


def is_standard(path):
    """Returns whether a path is standard input or output."""
    return str(path) == NAME


def explain_unsupported(arguments, supported):
    """Returns the error if - is given to an argument that is not supported, by its name; else None."""
    for name, value in vars(arguments).items():
        is_given = is_standard(value) or (isinstance(value, (list, tuple)) and NAME in value)
        if is_given and name not in supported:
            return (
                f"{NAME}: vtkhelios {arguments.command} does not take standard input or output "
                "there; give the name of a file"
            )
    return None


@contextlib.contextmanager
def folder_of_standard():
    """Yields an empty folder, which is removed at the end."""
    with tempfile.TemporaryDirectory(prefix="vtkhelios-") as folder:
        yield pathlib.Path(folder)


def read_input(path):
    """Copies standard input to a file; returns its path."""
    with open(path, "wb") as file:
        shutil.copyfileobj(sys.stdin.buffer, file, BLOCK)
    return path


def write_output(path):
    """Copies a file to standard output; returns whether its reader has not closed it. Raises OSError."""
    sys.stdout.flush()
    try:
        with open(path, "rb") as file:
            shutil.copyfileobj(file, sys.stdout.buffer, BLOCK)
        sys.stdout.buffer.flush()
    except BrokenPipeError:
        null = os.open(
            os.devnull, os.O_WRONLY
        )  # the rest of the buffer would fail again at the end
        os.dup2(null, sys.stdout.fileno())
        os.close(null)
        return False
    return True
