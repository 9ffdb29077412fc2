# SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
# SPDX-License-Identifier: BSD-3-Clause
"""PCD of the Point Cloud Library, by vtkHeliosPCDReader and vtkHeliosPCDWriter.

Binary, x y z as floats relative to an origin in a comment, as in PCL's point types, unless that is
coarser than a resolution; rgb, intensity, label and normals as PCL has them.
"""


from ..array_names import INTENSITY
from ..core.classes import vtk_class
from ..core.paths import to_vtk
from ..core.systems import find_system
from ._base import Header, Reader, StreamWriter, call, from_cloud, rows_of, select
from ._intensity import IntensityScale

COARSEST = 1e-3  # [m] of points whose file is not known


class PcdReader(Reader):
    """Read into memory as a whole."""

    kind = "PCD"

    def __init__(self, path):
        super().__init__(path)
        reader = vtk_class("vtkHeliosPCDReader")()
        reader.SetFileName(to_vtk(self.path))
        call(self, reader, reader.Update)
        self._chunk = from_cloud(reader.GetOutput())
        self.header = Header(reader.GetOutput().GetFieldData())
        self.count = rows_of(self._chunk)
        if self.count == 0:
            self.fail("has no points; give a file with points")
        if INTENSITY in self._chunk and self._chunk[INTENSITY].dtype.kind == "f":
            scale = IntensityScale.of(self._chunk[INTENSITY])
            scale.apply(self._chunk)
            self.notes += [f"{self.path}: {scale.note}"] if scale.note else []

    def read_chunks(self, rows):
        for begin in range(0, self.count, rows):
            yield select(self._chunk, slice(begin, begin + rows))


class PcdWriter(StreamWriter):
    def __init__(self, path, header):
        super().__init__(path, header, vtk_class("vtkHeliosPCDWriter")())

    def store(self, chunk):
        if not self.stream.IsOpen():
            self.stream.SetResolution(self._find_resolution())
        super().store(chunk)

    def _find_resolution(self):
        """Returns the step that coordinates keep: of degrees, of the file they are from, or 1
        mm."""
        system = find_system(self.header.crs)
        if system.is_geographic:
            return system.resolution[0]
        steps = self.header.steps
        return min(steps) if steps else COARSEST / system.unit

    def close(self):
        super().close()
        self.notes.append(
            "coordinates are stored as floats relative to an origin"
            if self.stream.GetHasFloatPoints()
            else "coordinates are stored in 64 bits, since floats are too coarse: PCL's own point "
            "types do not have them, and open3d.io (not open3d.t.io) reads 0"
        )
