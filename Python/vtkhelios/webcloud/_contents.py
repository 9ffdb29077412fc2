# SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
# SPDX-License-Identifier: BSD-3-Clause
"""Contents of a page for a run, a file of points, or a cloud."""

import os
import pathlib

import numpy as np

from ..core.arrays import arrays
from ..core.systems import Metres, find_system
from ..formats._base import FormatError, Header, rows_of, select
from ..formats._names import tables_of
from ..formats._run import RunReader
from ..formats._waveforms import find_waveforms, waveform_tables
from ._columns import make_columns
from ._page import make_page
from ._sample import LIMIT, Sample


class Contents:
    """A sample of points with what is common to them. Add chunks, then call make_page()."""

    def __init__(self, title, limit=LIMIT, names=None):
        self.title = os.fsencode(title).decode("utf-8", "replace")
        self.sample = Sample(limit, names)
        self.header = Header()
        self.tables = ()

    @classmethod
    def of_cloud(cls, cloud, title="cloud", limit=LIMIT, names=None):
        """Makes the contents of a Cloud and its waveforms; points that are not finite are left
        out."""
        contents = cls(title, limit, names)
        contents.header = Header(cloud.data.GetFieldData())
        chunk = {"points": cloud.points, **arrays(cloud.data)}
        finite = np.isfinite(cloud.points).all(axis=1)
        contents.add(chunk if finite.all() else select(chunk, finite))
        if cloud.waveforms is not None:
            contents.tables = [arrays(cloud.waveforms)]
        return contents

    @classmethod
    def of_reader(cls, reader, limit=LIMIT, names=None):
        """Makes the contents of a reader of vtkhelios.formats: pass its chunks to add()."""
        contents = cls(pathlib.Path(reader.path).name, limit, names)
        contents.header = reader.header
        contents.tables = _tables(reader)
        return contents

    @property
    def note(self):
        """Describes the unit of the coordinates, or returns an empty text."""
        return Metres(self.header.crs).note

    def add(self, chunk):
        """Adds the points of a chunk of a reader, in metres; returns their number."""
        metres = Metres(self.header.crs)
        if rows_of(chunk) and (problem := metres.refuse_degrees(chunk["points"][0])):
            raise FormatError(f"{self.title}: {problem}")
        self.sample.add({**chunk, "points": metres.convert(chunk["points"])})
        return rows_of(chunk)

    def column_names(self):
        """Returns the names of the arrays that the page shows, besides Height."""
        return [column.name for column in make_columns(self.sample.columns())]

    def _describe_system(self):
        name = find_system(self.header.crs).name
        return f"{name}, in metres" if self.note else name

    def make_page(self, colour_by=None):
        """Returns the HTML text; FormatError without points, KeyError without that array."""
        columns = self.sample.columns()
        if len(columns["points"]) == 0:
            raise FormatError(f"{self.title}: has no points; give a cloud with points")
        return make_page(
            columns, self.title, total=self.sample.count, crs=self._describe_system(),
            names=tables_of(self.header), tables=self.tables, colour_by=colour_by,
        )  # fmt: skip


def _tables(reader):
    """Yields the waveforms of a run or of a file, when they are used."""
    is_run = isinstance(reader, RunReader)
    paths = [reader.folder / name for name in reader.files] if is_run else [reader.path]
    for path in dict.fromkeys(filter(None, map(find_waveforms, paths))):
        yield from waveform_tables(reader, path)
