# SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
# SPDX-License-Identifier: BSD-3-Clause
"""Files and folders that have their names when they are whole.

A file is written under a name that ends in .part, and renamed. The .part is always a new file: one of
that name is removed, and never written to, since it may be a link to another file. A signal that ends
the process removes it.
"""

import contextlib
import errno
import os
import pathlib
import tempfile

from .run_files import PART
from .unfinished import set_unfinished

_FULL = {errno.ENOSPC: "free space on its disk or ", errno.EDQUOT: "free space of your quota or "}


def part_of(path):
    """The name of a file that is not whole yet."""
    return pathlib.Path(f"{path}{PART}")


def open_part(path):
    """Returns the .part of a file, new, open for reading and writing bytes."""
    part = part_of(path)
    part.unlink(missing_ok=True)
    set_unfinished(part)
    try:
        return open(str(part), "x+b")
    except BaseException:
        set_unfinished(part, False)
        raise


def make_part(path):
    """Makes the empty .part of a file, for those who open files by name; returns its name."""
    open_part(path).close()
    return part_of(path)


def keep_part(path):
    """Gives a whole .part its name."""
    os.replace(part_of(path), path)
    set_unfinished(part_of(path), False)


def drop_part(path):
    """Removes the .part of a file, if there is one."""
    with contextlib.suppress(OSError):
        part_of(path).unlink()
    set_unfinished(part_of(path), False)


def write_whole(path, content):
    """Writes a file, text or bytes; on failure an existing one is kept, and the error names the file."""
    write_files(pathlib.Path(path).parent, {pathlib.Path(path).name: content})


def write_files(folder, files):
    """Writes files that belong together, by name; returns their paths. On failure none is there, and
    existing ones are kept."""
    paths = [pathlib.Path(folder, name) for name in files]
    try:
        for path, content in zip(paths, files.values()):
            with naming(path), open_part(path) as file:
                file.write(content.encode() if isinstance(content, str) else content)
        for path in paths:
            with naming(path):
                keep_part(path)
    except BaseException:
        for path in paths:
            drop_part(path)
        raise
    return paths


@contextlib.contextmanager
def naming(path):
    """Errors of the operating system name this file."""
    try:
        yield
    except OSError as error:
        number = error.errno or errno.EIO
        raise OSError(number, error.strerror or str(error), str(path)) from error


@contextlib.contextmanager
def new_folder(folder):
    """Yields an empty folder; at the end its content moves to the given folder, which is new or
    empty. After an exception nothing is there, and errors name the files by their final names."""
    folder = pathlib.Path(os.path.abspath(folder))
    exists = folder.is_dir()
    try:
        folder.parent.mkdir(parents=True, exist_ok=True)
    except FileExistsError as error:
        raise NotADirectoryError(errno.ENOTDIR, "is not a folder", error.filename) from None
    within = folder if exists else folder.parent
    with naming(folder):
        scratch = tempfile.TemporaryDirectory(prefix=".vtkhelios", dir=within)
    with scratch as name:
        unfinished = pathlib.Path(name, "content")
        try:
            unfinished.mkdir()
            yield unfinished
        except OSError as error:
            with naming(_find_final(error.filename, unfinished, folder)):
                raise
        for path in sorted(unfinished.iterdir()) if exists else ():
            os.rename(path, folder / path.name)
        if not exists:
            with naming(folder):
                os.rename(unfinished, folder)


def _find_final(name, unfinished, folder):
    """Returns the final name of a file that an error names; without one, of the folder."""
    path = pathlib.Path(os.fsdecode(name) if isinstance(name, (str, bytes)) else folder)
    return folder / path.relative_to(unfinished) if path.is_relative_to(unfinished) else path


def find_unwritable(folder, option):
    """Why no file can be written to a folder, which is made, or None."""
    probe = pathlib.Path(folder, "survey.xml")
    try:
        probe.parent.mkdir(parents=True, exist_ok=True)
        make_part(probe).unlink()
    except OSError as error:
        return cannot_be_written(error, folder, option)
    return None


def cannot_be_written(error, file, option):
    """Returns the message of an OSError: the file, by default the given one, and the remedy."""
    cure = f"{_FULL.get(error.errno, '')}give another {option}"
    reason = error.strerror or str(error)
    return f"{error.filename or file}: cannot be written: {reason}; {cure}"
