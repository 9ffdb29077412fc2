# SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
# SPDX-License-Identifier: BSD-3-Clause
"""Files of a PlantArea."""

import csv
import io
import os
import pathlib

from vtkmodules.vtkCommonCore import vtkCommand
from vtkmodules.vtkIOXML import vtkXMLImageDataWriter

from ..core.classes import vtk_class
from ..core.files import drop_part, keep_part, make_part, naming, write_whole
from ..core.paths import to_vtk
from ..core.pipeline import MessageLog, conclude


def write(found, path):
    """Writes a file; its ending selects the content."""
    ending = os.path.splitext(os.fspath(path))[1].lower()
    if ending not in WRITERS:
        raise ValueError(f"{path} ends in {ending!r}; give one of: {', '.join(WRITERS)}")
    WRITERS[ending](found, os.fspath(path))


def _write_image(found, path):
    with naming(path):
        writer = vtkXMLImageDataWriter()
        writer.SetFileName(to_vtk(make_part(path)))
        writer.SetInputData(found.grid)
        for reporter in (writer, writer.GetExecutive()):
            reporter.AddObserver(vtkCommand.ErrorEvent, lambda *_: None)
        writer.SetHeaderTypeToUInt64()
        if writer.Write() and not writer.GetErrorCode():
            keep_part(path)
            return
        drop_part(path)
        raise OSError(28, "No space left on device")


def _write_voxels(found, path):
    pathlib.Path(path).parent.mkdir(parents=True, exist_ok=True)
    with MessageLog() as log:
        writer = vtk_class("vtkHeliosVoxelWriter")()
        log.watch(writer)
        writer.SetFileName(to_vtk(path))
        writer.SetInputData(found.grid)
        writer.Write()
    conclude(log)


def _write_table(found, path):
    text = io.StringIO()
    rows = found.profile()
    writer = csv.DictWriter(text, list(rows[0]) if rows else ["height"], lineterminator="\n")
    writer.writeheader()
    writer.writerows(rows)
    write_whole(path, text.getvalue())


def _write_json(found, path):
    write_whole(path, found.to_json() + "\n")


WRITERS = {
    ".vti": _write_image,
    ".vox": _write_voxels,
    ".csv": _write_table,
    ".json": _write_json,
}
