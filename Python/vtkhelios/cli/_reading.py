# SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
# SPDX-License-Identifier: BSD-3-Clause
"""Readers of XML files, and where they look up what these name."""

import pathlib

import vtkhelios

from .._paths import to_vtk


def add_assets_argument(parser):
    parser.add_argument(
        "--assets",
        metavar="DIR",
        action="append",
        default=[],
        help="a folder to look up scenes, scanners and platforms in; may be repeated",
    )


def missing_folder(assets):
    """What is wrong with the folders of --assets, or None."""
    missing = (folder for folder in assets if not pathlib.Path(folder).is_dir())
    folder = next(missing, None)
    return None if folder is None else f"--assets {folder}: no such folder"


def make_reader(path, assets):
    """A reader of a survey."""
    return look_up(vtkhelios.vtkHeliosSurveyReader(), path, assets)


def look_up(reader, path, assets):
    """A reader, or writer, of a file that looks in the user's folders, beside it, then in what is shipped."""
    shipped = vtkhelios.data_directory()
    beside = str(pathlib.Path(path).parent)
    reader.SetFileName(to_vtk(path))
    for folder in dict.fromkeys([*assets, beside, ".", f"{shipped}", f"{shipped}/Assets"]):
        reader.AddAssetDirectory(to_vtk(folder))
    return reader
