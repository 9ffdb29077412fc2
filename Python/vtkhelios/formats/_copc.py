# SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
# SPDX-License-Identifier: BSD-3-Clause
"""COPC: a LAZ file in octree order, by vtkHeliosCOPCWriter."""

import os
import struct

from .. import _native
from ..core.classes import vtk_class
from ..core.files import part_of
from ..core.pipeline import SECONDS_BETWEEN_SIGNS
from ..core.unfinished import set_unfinished
from ._las import LasReader, LasWriter

INFO = 375 + 54  # offset of the record that locates the octree
# entry of a page: key, offset, bytes, points; -1 points: another page
ENTRY = struct.Struct("<4iQii")


class CopcReader(LasReader):
    """Read as LAZ; the octree is checked and not used."""

    def __init__(self, path):
        super().__init__(path)
        self.kind = self.kind.replace("LAZ", "COPC, LAZ")
        if problem := self._find_wrong_octree():
            self.notes.append(
                f"{path}: its octree is damaged: {problem}; all points are read without it; "
                "convert the file to make a new one"
            )

    def _find_wrong_octree(self):
        """Returns the error in the pages of the octree, or None."""
        size, count = os.path.getsize(self.path), 0
        with open(self.path, "rb") as file:
            file.seek(INFO + 40)
            pages, seen = [struct.unpack("<QQ", file.read(16))], set()
            while pages:
                place, length = pages.pop()
                if place in seen or length % ENTRY.size or place + length > size:
                    return f"a page of {length} bytes at byte {place} of {size}"
                seen.add(place)
                file.seek(place)
                for *_, place, length, points in ENTRY.iter_unpack(file.read(length)):
                    if points < -1 or length < 0 or (points and place + length > size):
                        return f"a node of {points} points in {length} bytes at byte {place}"
                    if points == -1:
                        pages.append((place, length))
                    count += max(points, 0)
        return None if count == self.count else f"it has {count} of {self.count} points"


class CopcWriter(LasWriter):
    """LAZ until close(), which orders the points."""

    def __init__(self, path, header):
        super().__init__(path, header, vtk_class("vtkHeliosCOPCWriter")())

    def finish(self):
        octree = part_of(f"{self.path}.octree")
        set_unfinished(octree)
        _native.run(self.stream, 0, [self.stream], None, SECONDS_BETWEEN_SIGNS)
        set_unfinished(octree, False)
