# SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
# SPDX-License-Identifier: BSD-3-Clause
"""Readers of documents, XML and YAML, and where they look up what these name."""

import pathlib

from ..vtkHeliosScannerSurvey import vtkHeliosDialect, vtkHeliosSurveyReader
from .folders import data_directory
from .paths import to_vtk
from .pipeline import MessageLog

YAML = (".yaml", ".yml")


def is_document(path):
    """Returns whether the ending of a name belongs to a document."""
    return vtkHeliosDialect.IsDocument(to_vtk(path))


def read_xml(path):
    """Returns the bytes of a document; one in YAML as XML. Raises ValueError if this cannot be read,
    and OSError."""
    path = pathlib.Path(path)
    if path.suffix.lower() in YAML:
        return _use_dialect("ReadXml", to_vtk(path)).encode()
    return path.read_bytes()


def convert(source, target):
    """Converts a document into another one, by their endings. Raises ValueError."""
    _use_dialect("Convert", to_vtk(source), to_vtk(target))


def _use_dialect(method, *arguments):
    dialect = vtkHeliosDialect()
    with MessageLog() as log:
        log.watch(dialect)
        result = getattr(dialect, method)(*arguments)
    if log.errors:
        raise ValueError("\n".join(log.root_errors()))
    return result


def missing_folder(assets):
    """Returns the error in the folders of --assets, or None."""
    missing = (folder for folder in assets if not pathlib.Path(folder).is_dir())
    folder = next(missing, None)
    return None if folder is None else f"--assets {folder}: no such folder"


def make_reader(path, assets):
    """Returns a reader of a survey."""
    return look_up(vtkHeliosSurveyReader(), path, assets)


def look_up(reader, path, assets):
    """Returns a reader, or writer, that searches the user's folders, the file's own, then the
    shipped data."""
    shipped = data_directory()
    beside = [str(pathlib.Path(path).parent)] if path else []
    reader.SetFileName(to_vtk(path) if path else None)
    for folder in dict.fromkeys([*assets, *beside, ".", f"{shipped}", f"{shipped}/Assets"]):
        reader.AddAssetDirectory(to_vtk(folder))
    return reader
