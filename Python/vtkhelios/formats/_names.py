# SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
# SPDX-License-Identifier: BSD-3-Clause
"""Names of parts and materials: beside LAS, LAZ and COPC by vtkHeliosPointNames; of merged clouds."""

import contextlib
import pathlib

import numpy as np

from ..array_names import (
    MATERIAL_IDS, MATERIAL_NAME, ORGAN_IDS, ORGAN_NAME, PART_IDS, PART_NAME, SPECIES_IDS,
    SPECIES_NAME,
)  # fmt: skip
from ..core.files import part_of
from ..core.paths import from_vtk, to_vtk
from ..core.unfinished import set_unfinished
from ..vtkHeliosFiltersIO import vtkHeliosPointNames
from ._base import FormatError

# Names for the numbers in an array.
NAMES = {
    PART_IDS: PART_NAME, MATERIAL_IDS: MATERIAL_NAME, SPECIES_IDS: SPECIES_NAME,
    ORGAN_IDS: ORGAN_NAME,
}  # fmt: skip
NAME_KEYS = ("parts", "materials", "species", "organs")  # keys of their tables in JSON
TREE_NAMES = (SPECIES_NAME, ORGAN_NAME)  # names that PLY and E57 store, too


def names_file(path):
    """Returns the file of the names of a file of points."""
    return pathlib.Path(from_vtk(vtkHeliosPointNames.GetFileName(to_vtk(path))))


def add_names(path, count, header):
    """Adds the names beside a file with this number of points to a header; returns a note, or ''."""
    names = vtkHeliosPointNames()
    is_read = names.Read(to_vtk(path), count, header.fields)
    return "" if is_read else from_vtk(names.GetMessage())


def check_names(path, header):
    """Raises FormatError if a file that is something else is where names would be written."""
    names = vtkHeliosPointNames()
    if names.CountNames(header.fields) and not names.Check(to_vtk(path)):
        raise FormatError(from_vtk(names.GetMessage()))


def write_names(path, count, header):
    """Writes the names in a header beside a file, or removes the names of an earlier file."""
    names = vtkHeliosPointNames()
    if not names.Write(to_vtk(path), count, header.fields):
        raise FormatError(from_vtk(names.GetMessage()))


def watch_part(path, is_unfinished=True):
    """Has a signal remove the names of the .part of a file, or not any more."""
    set_unfinished(names_file(part_of(path)), is_unfinished)


def drop_part_names(path):
    """Removes the names of the .part of a file."""
    with contextlib.suppress(OSError):
        names_file(part_of(path)).unlink()
    watch_part(path, False)


def tables_of(header):
    """Returns the names in a header by the array of their numbers."""
    return {ids: header.texts(name) for ids, name in NAMES.items() if header.texts(name)}


class NameUnion:
    """The names of several clouds, whose numbers differ, as one table."""

    def __init__(self):
        self._tables = {}

    def add(self, header):
        """Adds the names of a cloud; returns its new numbers, by array, where they differ."""
        moved = {}
        for ids, names in tables_of(header).items():
            table = self._tables.setdefault(ids, list(names))
            if names == table[: len(names)]:
                continue
            if table == names[: len(table)]:
                table[:] = names
                continue
            moved[ids] = np.array([self._find(table, name) for name in names], np.int64)
        return moved

    def _find(self, table, name):
        if name not in table:
            table.append(name)
        return table.index(name)

    def set_names(self, header):
        """Gives a header the names of all clouds."""
        for ids, table in self._tables.items():
            header.set_texts(NAMES[ids], table)


def renumber(chunk, moved):
    """Returns a chunk with new numbers of parts and materials; numbers without a name stay."""
    changed = {}
    for ids, numbers in moved.items():
        values = chunk.get(ids)
        if values is not None:
            known = (values >= 0) & (values < len(numbers))
            changed[ids] = values.copy()
            changed[ids][known] = numbers[values[known]]
    return {**chunk, **changed}
