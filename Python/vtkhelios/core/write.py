# SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
# SPDX-License-Identifier: BSD-3-Clause
"""Writes a cloud to a file of our own formats, also without points, and with waveforms."""

import errno
import os

from vtkmodules.vtkCommonCore import vtkCommand
from vtkmodules.vtkCommonMisc import vtkErrorCode
from vtkmodules.vtkIOXML import vtkXMLPolyDataWriter

from .classes import vtk_class
from .files import drop_part, keep_part, make_part, naming
from .paths import to_vtk
from .pipeline import MessageLog, conclude


def write(cloud, path):
    """Writes a Cloud to a file with one of ENDINGS; raises PipelineError and OSError."""
    with MessageLog() as log:
        succeeded = _WRITERS[os.path.splitext(path)[1].lower()](cloud, path, log)
    conclude(log)
    if not succeeded:
        raise OSError(f"{path} cannot be written; is its folder there?")


def _write_text(cloud, path, log):
    writer = vtk_class("vtkHeliosPointTextWriter")(fill_missing=True)
    return _write_block(writer, cloud, path, log)


def _write_las(cloud, path, log):
    writer = vtk_class("vtkHeliosLASWriter")()
    if cloud.waveforms is not None:
        writer.SetWriteWaveforms(True)
        writer.SetWaveforms(cloud.waveforms)
    return _write_block(writer, cloud, path, log)


def _write_block(writer, cloud, path, log):
    log.watch(writer)
    writer.SetFileName(to_vtk(path))
    if writer.Open() and writer.Write(cloud.data) and writer.Close():
        return True
    writer.Abandon()
    return False


def _write_vtp(cloud, path, _log):
    write_points(cloud.with_vertices().data, path)
    return True


_WRITERS = {".xyz": _write_text, ".las": _write_las, ".vtp": _write_vtp}
ENDINGS = tuple(_WRITERS)


def write_points(data, path):
    """Writes a vtkPolyData as VTK XML; returns its path. Raises OSError."""
    with naming(path):
        writer = vtkXMLPolyDataWriter()
        writer.SetFileName(to_vtk(make_part(path)))
        writer.SetInputData(data)
        for reporter in (writer, writer.GetExecutive()):  # many lines about one reason
            reporter.AddObserver(vtkCommand.ErrorEvent, lambda *_: None)
        writer.SetHeaderTypeToUInt64()
        succeeded, number = writer.Write(), writer.GetErrorCode()
        if succeeded and not number:
            keep_part(path)
            return path
        drop_part(path)
        # A writer that cannot write more removes its file: ENOENT is of what it does then.
        if number >= vtkErrorCode.FirstVTKErrorCode or number in (0, errno.ENOENT):
            number = errno.ENOSPC
        raise OSError(number, os.strerror(number))
