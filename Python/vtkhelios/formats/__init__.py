# SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
# SPDX-License-Identifier: BSD-3-Clause
"""Point files of many formats, read and written in chunks.

A chunk has the form of vtkhelios.arrays(): a dict of numpy arrays, ``points`` (n x 3, float64, [m])
and every array of the points by its name in vtkHeliosArrayNames.h.

>>> from vtkhelios import formats
>>> with formats.open_reader("leg000_points.laz") as reader:
...     with formats.open_writer("leg000_points.ply", reader.header) as writer:
...         for chunk in reader.chunks():
...             writer.write(chunk)

Writers write to a file whose name ends in .part, and rename it when they are closed; an exception
inside ``with`` removes it. Every error is a FormatError that names the file and the remedy.

To add a format: a module with a Reader and a Writer (see _base.py; None: not written), and its line in
FORMATS, of which errors, vtkhelios view and Docs/files.md (Python/make_endings.py) know.
"""

import importlib
import pathlib

from .._paths import require_utf8
from ._endings import explain_no_points
from ._base import Chunk, FormatError, Header, Reader, Scan, Writer, check_file, guarded
from ._las import check_waveforms
from ._pulsewaves import PulseWaves, read_pulsewaves
from ._run import RunReader, is_run

__all__ = ["Chunk", "FormatError", "Header", "Reader", "Scan", "Writer"]
__all__ += ["FORMATS", "TABLES", "WRITTEN", "ending", "open_reader", "open_writer"]
__all__ += ["PulseWaves", "check_waveforms", "read_pulsewaves"]

# By the end of a name, the longest first: module, reader, writer (None: it is read only).
FORMATS = {
    ".copc.laz": ("_copc", "CopcReader", "CopcWriter"),
    ".las": ("_las", "LasReader", "LasWriter"),
    ".laz": ("_las", "LazReader", "LazWriter"),
    ".xyz": ("_text", "TextReader", "TextWriter"),
    ".csv": ("_csv", "TextReader", "CsvWriter"),
    ".txt": ("_text", "TextReader", None),
    ".asc": ("_text", "TextReader", None),
    ".pts": ("_text", "TextReader", None),
    ".ptx": ("_text", "TextReader", None),
    ".pvtp": ("_vtp", "PiecesReader", "PiecesWriter"),
    ".vtp": ("_vtp", "VtpReader", "VtpWriter"),
    ".ply": ("_ply", "PlyReader", "PlyWriter"),
    ".pcd": ("_pcd", "PcdReader", "PcdWriter"),
    ".e57": ("_e57", "E57Reader", "E57Writer"),
}

WRITTEN = tuple(known for known, entry in FORMATS.items() if entry[2])
TABLES = (".txt", ".csv")  # often other tables than points

_ONLY_UTF8 = {".copc.laz", ".e57"}  # names accepted by their libraries


def ending(path):
    """The entry of FORMATS that a name ends in."""
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
    return getattr(importlib.import_module(f"{__name__}.{module[0]}"), module[index])


def open_reader(path):
    """The reader of a file, or of the folder of a run."""
    if is_run(path):
        with guarded(path):
            return RunReader(path)
    kind = _find(path, 1)
    check_file(path)
    with guarded(path):
        reader = kind(path)
        reader.check_system()
        return reader


def open_writer(path, header=None):
    """The writer of a file, which is created with the first chunk."""
    return _find(path, 2)(path, header or Header())
