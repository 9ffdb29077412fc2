# SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
# SPDX-License-Identifier: BSD-3-Clause
"""Opens files by their endings."""

import importlib
import pathlib

from ..core.paths import require_utf8
from ._base import FormatError, Header, check_file, guarded
from ._endings import FORMATS, explain_no_points

WRITTEN = tuple(known for known, entry in FORMATS.items() if entry[2])
TABLES = (".txt", ".csv")  # often other tables than points

_ONLY_UTF8 = {".e57"}  # names accepted by its library


def ending(path):
    """Returns the entry of FORMATS that a name ends in."""
    name = pathlib.Path(path).name.lower()
    for known in FORMATS:
        if name.endswith(known):
            return known
    raise FormatError(explain_no_points(path))


def _find(path, index):
    module = FORMATS[ending(path)]
    if ending(path) in _ONLY_UTF8:
        try:
            require_utf8(path)
        except UnicodeEncodeError as error:
            raise FormatError(
                f"{path}: its name is not UTF-8, and {ending(path)} files need that; give it another name"
            ) from error
    if module[index] is None:
        raise FormatError(
            f"{path}: {ending(path)} is read, not written; written are: {', '.join(WRITTEN)}"
        )
    return getattr(importlib.import_module(f"{__package__}.{module[0]}"), module[index])


def open_file(path):
    """The reader of a file."""
    kind = _find(path, 1)
    check_file(path)
    with guarded(path):
        reader = kind(path)
        reader.check_system()
        return reader


def open_writer(path, header=None):
    """Returns the writer of a file, which is created with the first chunk."""
    return _find(path, 2)(path, header or Header())
