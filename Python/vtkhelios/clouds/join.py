# SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
# SPDX-License-Identifier: BSD-3-Clause
"""Concatenates clouds and tables of waveforms."""

import numpy as np
from vtkmodules.util.numpy_support import numpy_to_vtk, vtk_to_numpy
from vtkmodules.vtkCommonDataModel import vtkTable

from ..array_names import OFFSET, SAMPLES
from ..core.arrays import arrays
from .cloud import Cloud


def join_clouds(clouds):
    """One cloud of all points, with the arrays common to all. A copy."""
    full = [cloud for cloud in clouds if len(cloud)] or clouds[:1]
    names = [name for name in full[0].names if all(name in cloud for cloud in full)]
    columns = {name: np.concatenate([cloud[name] for cloud in full]) for name in names}
    joined = Cloud.from_arrays(np.concatenate([cloud.points for cloud in full]), **columns)
    joined.data.GetFieldData().ShallowCopy(full[0].data.GetFieldData())
    return joined


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
