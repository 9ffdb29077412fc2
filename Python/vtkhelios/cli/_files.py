# SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
# SPDX-License-Identifier: BSD-3-Clause
"""Files of text that have their names when they are whole."""

import contextlib
import errno
import os

from .._run_files import PART

_FULL = {errno.ENOSPC: "free space on its disk or ", errno.EDQUOT: "free space of your quota or "}


def write_whole(path, text):
    """Writes a file (a Path) via a .part; on failure the part is removed, and the error names the file."""
    part = path.with_name(f"{path.name}{PART}")
    try:
        part.write_text(text, encoding="utf-8")
        os.replace(part, path)
    except OSError as error:
        with contextlib.suppress(OSError):
            part.unlink()
        raise OSError(error.errno, error.strerror, str(path)) from error


def cannot_be_written(error, file, option):
    """The message of an OSError: the file, by default the given one, and the remedy."""
    cure = f"{_FULL.get(error.errno, '')}give another {option}"
    return f"{error.filename or file}: cannot be written: {error.strerror}; {cure}"
