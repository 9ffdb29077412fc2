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
FORMATS (_endings.py), of which errors, vtkhelios view and Docs/files.md (Python/make_endings.py) know.
"""

from ._base import ROWS, Chunk, FormatError, Header, Reader, Scan, Writer, guarded
from ._endings import FORMATS
from ._las import check_waveforms
from ._open import TABLES, WRITTEN, ending, open_file, open_writer
from ._pulsewaves import PulseWaves, read_pulsewaves
from ._run import RunReader, is_run

__all__ = ["Chunk", "FormatError", "Header", "Reader", "Scan", "Writer"]
__all__ += ["FORMATS", "ROWS", "TABLES", "WRITTEN", "ending", "open_reader", "open_writer"]
__all__ += ["PulseWaves", "check_waveforms", "read_pulsewaves"]


def open_reader(path):
    """Returns the reader of a file, or of the folder of a run."""
    if is_run(path):
        with guarded(path):
            return RunReader(path)
    return open_file(path)
