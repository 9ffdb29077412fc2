# SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
# SPDX-License-Identifier: BSD-3-Clause
"""Concatenates clouds and tables of waveforms."""

import numpy as np
from vtkmodules.util.numpy_support import vtk_to_numpy
from vtkmodules.vtkCommonDataModel import vtkTable

from ..array_names import GPS_TIME, OFFSET, SAMPLES
from ..core.arrays import arrays, numpy_to_vtk
from ..core.systems import find_system
from ..formats import Header
from ..formats._base import from_cloud
from ..formats._names import NameUnion, renumber
from .files import merge


def join_clouds(clouds):
    """One cloud of all points, with the arrays common to all. A copy."""
    full = [cloud for cloud in clouds if len(cloud)] or clouds[:1]
    names = [name for name in full[0].names if all(name in cloud for cloud in full)]
    columns = {name: np.concatenate([cloud[name] for cloud in full]) for name in names}
    joined = type(full[0]).from_arrays(np.concatenate([cloud.points for cloud in full]), **columns)
    joined.data.GetFieldData().ShallowCopy(full[0].data.GetFieldData())
    return joined


def add_clouds(clouds):
    """Returns the points of clouds of any origin as a chunk with all their arrays, and a Header.

    Times count from the epoch of the first, and parts and materials with equal names are the same.
    ValueError for different coordinate systems or epochs.
    """
    headers = [Header(cloud.data.GetFieldData()) for cloud in clouds]
    chunks = [from_cloud(cloud.data) for cloud in clouds]
    header, names = Header(headers[0].fields), NameUnion()
    for number, (chunk, other) in enumerate(zip(chunks, headers)):
        shift = _find_shift(header, other, GPS_TIME in chunks[0] and GPS_TIME in chunk)
        chunk = renumber(chunk, names.add(other))
        chunks[number] = {**chunk, GPS_TIME: chunk[GPS_TIME] + shift} if shift else chunk
    names.set_names(header)
    return merge(chunks), header


def _find_shift(header, other, are_timed):
    """Returns what is added to times of the other cloud [s]."""
    one, another = find_system(header.crs), find_system(other.crs)
    if not one.is_same(another.text):
        raise ValueError(
            f"the clouds have the coordinate systems {one.label} and {another.label}; move one with "
            "vtkHeliosReproject"
        )
    if not are_timed or header.epoch == other.epoch:
        return 0.0
    if 0.0 in (header.epoch, other.epoch):
        raise ValueError(
            "GpsTime of one cloud counts from a known epoch, and of the other not; set GpsEpoch of "
            "both, or run the survey with gps_start"
        )
    return other.epoch - header.epoch


def join_tables(tables):
    """One table of waveforms, with all samples concatenated. A copy."""
    joined = vtkTable()
    joined.GetFieldData().ShallowCopy(tables[0].GetFieldData())
    samples = [vtk_to_numpy(table.GetFieldData().GetArray(SAMPLES)) for table in tables]
    starts = np.cumsum([0] + [len(part) for part in samples])
    _add(joined.GetFieldData(), SAMPLES, np.concatenate(samples))
    rows = [arrays(table) for table in tables]
    for index in range(tables[0].GetNumberOfColumns()):
        name = tables[0].GetColumn(index).GetName()
        parts = [row[name] for row in rows]
        if name == OFFSET:
            parts = [part + start for part, start in zip(parts, starts)]
        _add(joined.GetRowData(), name, np.concatenate(parts))
    return joined


def _add(attributes, name, values):
    array = numpy_to_vtk(np.ascontiguousarray(values))
    array.SetName(name)
    attributes.AddArray(array)
