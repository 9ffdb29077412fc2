# SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
# SPDX-License-Identifier: BSD-3-Clause
"""File names and texts that may not be UTF-8, between Python and VTK."""

import os


def to_vtk(path):
    """Returns a path for VTK's methods: text, or bytes if it is not UTF-8."""
    name = os.fspath(path)
    try:
        os.fsdecode(name).encode()
    except UnicodeEncodeError:
        return os.fsencode(name)
    return os.fsdecode(name)


def require_utf8(*paths):
    """Raises UnicodeEncodeError for a path that is not UTF-8 and must be written to a file."""
    for path in paths:
        os.fsdecode(path).encode()


def from_vtk(name):
    """Returns a path, or a text with paths, returned by VTK; None is empty."""
    return os.fsdecode(name or "")


def text_from_vtk(text):
    """Returns a text returned by VTK (bytes if not UTF-8), with \\xff for invalid bytes; None is
    empty."""
    return text.decode(errors="backslashreplace") if isinstance(text, bytes) else text or ""
