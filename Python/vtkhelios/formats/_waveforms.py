# SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
# SPDX-License-Identifier: BSD-3-Clause
"""Files of waveforms, read in pieces by the readers of Filters/IO."""

import pathlib

from vtkmodules.vtkCommonDataModel import vtkTable
from vtkmodules.vtkCommonExecutionModel import vtkTrivialProducer

from ..core.arrays import arrays
from ..core.classes import vtk_class
from ..core.paths import to_vtk
from ..core.run_files import POINTS, WAVEFORMS, beside, file_of_leg, kind_of
from ._base import FormatError, call
from ._las import check_waveforms, has_waveforms
from ._pulsewaves import read_pulsewaves

WITHOUT = (".ply", ".pcd", ".e57", ".vtp", ".pvtp")  # kinds of points
PIECE_SIZE = 64_000_000  # bytes of text in memory at a time


def is_las(path):
    return pathlib.Path(path).suffix.lower() in (".las", ".laz")


def make_waveform_reader(path, one_way=False):
    """Returns the reader of a file of waveforms, which are its last output; one_way: times of
    HELIOS++ text."""
    if pathlib.Path(path).suffix.lower() == ".pls":
        reader = vtkTrivialProducer()
        reader.SetOutput(read_pulsewaves(path).returning)
        return reader
    if is_las(path):
        check_waveforms(path)
        reader = vtk_class("vtkHeliosLASReader")()
        reader.ReadWaveformsOn()
    elif {".pvtt", ".vtt"} & set(pathlib.Path(path).suffixes):
        reader = vtk_class("vtkHeliosWaveformXMLReader")()
    elif str(path).lower().endswith(WITHOUT):
        raise FormatError(
            f"{path}: files of this kind have no waveforms; give those of a run, such as "
            f"{file_of_leg(0, WAVEFORMS, 'xyz')} or {file_of_leg(0, WAVEFORMS, 'vtp')}, LAS or LAZ with "
            "waveforms, or PulseWaves (.pls)"
        )
    else:
        reader = vtk_class("vtkHeliosWaveformTextReader")()
        reader.SetOneWayTimes(one_way)
    reader.SetFileName(to_vtk(path))
    return reader


def count_pieces(reader, path):
    """Number of pieces in which waveforms are read, so that memory does not grow with the file.

    The points of a pulse in LAS need not be neighbours, but refer to one waveform: one piece.
    """
    if is_las(path) or reader.IsA("vtkTrivialProducer"):
        return 1
    reader.UpdateInformation()
    if reader.IsA("vtkHeliosWaveformXMLReader"):
        return max(1, reader.GetNumberOfPieces())
    size = pathlib.Path(path).stat().st_size if pathlib.Path(path).is_file() else 0
    return 1 + size // PIECE_SIZE


def find_waveforms(path):
    """Returns the file with the waveforms of a point file: the one beside it, or itself; None:
    neither."""
    path = pathlib.Path(path)
    if kind_of(path) == POINTS:
        found = next((each for each in beside(path, WAVEFORMS) if each.is_file()), None)
        if found:
            return found
    return path if is_las(path) and has_waveforms(path) else None


def waveform_tables(owner, path):
    """Yields the waveforms of a file, a dict of arrays per piece; warnings become notes of the owner."""
    reader = make_waveform_reader(path)
    port = reader.GetNumberOfOutputPorts() - 1
    pieces = count_pieces(reader, path)
    for piece in range(pieces):
        call(owner, reader, lambda piece=piece: reader.UpdatePiece(piece, pieces, 0))
        yield arrays(reader.GetOutputDataObject(port))


def read_waveforms(owner, path):
    """Returns the waveforms of a file, a vtkTable; warnings become notes of the owner."""
    reader = make_waveform_reader(path)
    call(owner, reader, reader.Update)
    table = vtkTable()
    table.ShallowCopy(reader.GetOutputDataObject(reader.GetNumberOfOutputPorts() - 1))
    return table
