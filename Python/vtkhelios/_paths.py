# SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
# SPDX-License-Identifier: BSD-3-Clause
"""Names of files, and texts, that need not be UTF-8, between Python and VTK."""

import os


def to_vtk(path):
    """A path as VTK's methods take it: text, or bytes where it is not UTF-8."""
    name = os.fspath(path)
    try:
        os.fsdecode(name).encode()
    except UnicodeEncodeError:
        return os.fsencode(name)
    return os.fsdecode(name)


def require_utf8(*paths):
    """Raises UnicodeEncodeError for a path that is not UTF-8, where a file is to name it."""
    for path in paths:
        os.fsdecode(path).encode()


def from_vtk(name):
    """A path, or a text with paths, that VTK returned; None is empty."""
    return os.fsdecode(name or "")


def text_from_vtk(text):
    """A text that VTK returned (bytes where it is not UTF-8), with \\xff for such a byte; None is empty."""
    return text.decode(errors="backslashreplace") if isinstance(text, bytes) else text or ""
