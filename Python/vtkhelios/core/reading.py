# SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
# SPDX-License-Identifier: BSD-3-Clause
"""Readers of XML files, and where they look up what these name."""

import pathlib

from ..vtkHeliosScannerSurvey import vtkHeliosSurveyReader
from .folders import data_directory
from .paths import to_vtk


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
    beside = str(pathlib.Path(path).parent)
    reader.SetFileName(to_vtk(path))
    for folder in dict.fromkeys([*assets, beside, ".", f"{shipped}", f"{shipped}/Assets"]):
        reader.AddAssetDirectory(to_vtk(folder))
    return reader
