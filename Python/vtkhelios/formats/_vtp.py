# SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
# SPDX-License-Identifier: BSD-3-Clause
"""VTK XML: .pvtp with pieces, streamed, and .vtp, in memory as a whole."""

import pathlib
import xml.etree.ElementTree as ElementTree

import numpy as np
from vtkmodules.util.numpy_support import numpy_to_vtkIdTypeArray
from vtkmodules.vtkCommonDataModel import vtkCellArray
from vtkmodules.vtkIOXML import vtkXMLPolyDataReader

from ..core.classes import vtk_class
from ..core.files import drop_part
from ..core.write import write_points

from ._base import (
    Header, Reader, StreamWriter, Writer, call, check_file, from_cloud, rows_of, select, to_cloud,
)  # fmt: skip


class VtpReader(Reader):
    kind = "VTK XML"

    def __init__(self, path):
        super().__init__(path)
        self._files = self._find_files()
        self._first = self._read(self._open(self._files[0]))
        self.count = sum(self._open(name).GetNumberOfPoints() for name in self._files)
        self.header = Header(self._first.GetFieldData())

    def _find_files(self):
        return [self.path]

    def _open(self, name):
        if not vtkXMLPolyDataReader().CanReadFile(name):
            self.fail(f"{name} is not a VTK XML file of points (vtkPolyData); convert it first")
        reader = vtk_class("vtkHeliosPointXMLReader")()
        reader.SetFileName(name)
        call(self, reader, reader.UpdateInformation)
        return reader

    def _read(self, reader):
        call(self, reader, reader.Update)
        return reader.GetOutput()

    def read_chunks(self, rows):
        for index, name in enumerate(self._files):
            chunk = from_cloud(self._read(self._open(name)) if index else self._first)
            for begin in range(0, rows_of(chunk), rows):
                yield select(chunk, slice(begin, begin + rows))


class PiecesReader(VtpReader):
    kind = "VTK XML in pieces"

    def _find_files(self):
        try:
            root = ElementTree.parse(self.path).getroot()
        except ElementTree.ParseError as error:
            self.fail(f"is not XML: {error}; write it again")
        if root.get("type") != "PPolyData":
            self.fail("is not a VTK XML file of points in pieces (PPolyData); give that file")
        folder = pathlib.Path(self.path).parent
        files = [str(folder / piece.get("Source", "")) for piece in root.iter("Piece")]
        if not files:
            self.fail("lists no pieces, so it has no points; give a file with points")
        for name in files:
            if not pathlib.Path(name).exists():
                self.fail(f"its piece {name} is missing; keep the pieces in the same folder")
            check_file(name)
        return files


class PiecesWriter(StreamWriter):
    """One piece per chunk."""

    def __init__(self, path, header):
        super().__init__(path, header, vtk_class("vtkHeliosPointXMLWriter")())
        self._pieces = 0

    def store(self, chunk):
        self._pieces += 1
        super().store(chunk)

    def abandon(self):
        super().abandon()
        path = pathlib.Path(self.path)
        for piece in range(self._pieces):
            path.with_name(f"{path.stem}_{piece:04}.vtp").unlink(missing_ok=True)


class VtpWriter(Writer):
    """All chunks at once."""

    def __init__(self, path, header):
        super().__init__(path, header)
        self._chunks = []

    def store(self, chunk):
        if self._chunks and set(chunk) != set(self._chunks[0]):
            odd = ", ".join(sorted(set(chunk) ^ set(self._chunks[0])))
            self.fail(f"not all points have {odd}; convert the files one by one")
        self._chunks.append({name: values.copy() for name, values in chunk.items()})
        self.count += rows_of(chunk)

    def close(self):
        if not self.count:
            self.fail("would have no points; change the selection")
        names = self._chunks[0]
        cloud = to_cloud(
            {n: np.concatenate([c[n] for c in self._chunks]) for n in names}, self.header
        )
        self._add_vertices(cloud)
        pathlib.Path(self.path).parent.mkdir(parents=True, exist_ok=True)
        try:
            write_points(cloud, self.path)
        except OSError as error:
            self.fail(f"cannot be written: {error.strerror}; free space on its disk")

    def _add_vertices(self, cloud):
        """A vertex per point, so that viewers show it."""
        places = np.arange(self.count + 1, dtype=np.int64)
        cells = vtkCellArray()
        cells.SetData(
            numpy_to_vtkIdTypeArray(places, deep=True),
            numpy_to_vtkIdTypeArray(places[:-1].copy(), deep=True),
        )
        cloud.SetVerts(cells)

    def abandon(self):
        self._chunks.clear()
        drop_part(self.path)
