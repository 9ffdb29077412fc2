# SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
# SPDX-License-Identifier: BSD-3-Clause
"""Clouds from files and into files, in all formats of points."""

import os
import pathlib
import warnings

import numpy as np

from .. import formats
from ..core.reading import is_document
from ..core.write import ENDINGS, write
from ..formats._base import from_cloud, rows_of, select
from ..formats._endings import is_mesh_ending
from ..formats._run import RunReader
from ..formats._union import fill, join_layouts, layout_of
from ..formats._waveforms import find_waveforms, read_waveforms


def read_chunks(path):
    """Returns the arrays of a file of points, or of the folder of a run, and its Header.

    Raises FormatError; what is skipped or read otherwise is a warning.
    """
    with formats.open_reader(_check(path)) as reader:
        chunks = list(reader.chunks(max(1, reader.count or formats.ROWS)))
        notes = reader.notes
        header = reader.header
    _warn(notes)
    return merge(chunks), header


def read_tables(path):
    """Returns the waveforms of a file of points, or of a run: a vtkTable each. Raises FormatError."""
    path = pathlib.Path(path)
    files = [path / name for name in RunReader(path).files] if path.is_dir() else [path]
    found = [find_waveforms(each) for each in files]
    if None in found:
        raise formats.FormatError(
            f"{files[found.index(None)]}: has no waveforms; read it without, or run the survey with them"
        )
    owner = formats.Reader(path)
    tables = [read_waveforms(owner, each) for each in found]
    _warn(owner.notes)
    return tables


def merge(chunks):
    """Returns chunks as one, with all arrays of any of them."""
    if len(chunks) == 1:
        return chunks[0]
    union = join_layouts((f"block {i}", layout_of(chunk)) for i, chunk in enumerate(chunks))
    full = [fill(chunk, union) for chunk in chunks]
    return {name: np.concatenate([chunk[name] for chunk in full]) for name in union}


def write_cloud(cloud, path):
    """Writes a Cloud; the ending of the path selects the format."""
    path = os.fspath(path)
    if path.lower().endswith(ENDINGS):
        write(cloud, path)
        return
    if not path.lower().endswith(formats.WRITTEN):
        known = ", ".join(formats.WRITTEN)
        raise formats.FormatError(
            f"{path}: is not of a format that is written; written are: {known}"
        )
    chunk = from_cloud(cloud.data)
    with formats.open_writer(path, formats.Header(cloud.data.GetFieldData())) as writer:
        for begin in range(0, rows_of(chunk), formats.ROWS):
            writer.write(select(chunk, slice(begin, begin + formats.ROWS)))
    lost = dict(writer.lost)
    if cloud.waveforms is not None:
        lost["waveforms"] = "Cloud.write() writes them to .las only"
    dropped = [f"{path}: {name} is dropped: {reason}" for name, reason in lost.items()]
    _warn([*writer.notes, *dropped])


def _warn(notes):
    """Warns where the user calls a method of Cloud, or read()."""
    for note in dict.fromkeys(notes):
        warnings.warn(note, RuntimeWarning, stacklevel=4)


def _check(path):
    """Returns the path as a text; FormatError, with the function to call, if it is not of points."""
    path = os.fspath(path)
    if is_document(path):
        raise formats.FormatError(f"{path}: is a document, not points; give it to read_survey()")
    if is_mesh_ending(path) and not path.lower().endswith(tuple(formats.FORMATS)):
        raise formats.FormatError(f"{path}: is a mesh, not points; give it to Scene.read()")
    return path
