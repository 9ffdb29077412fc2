# SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
# SPDX-License-Identifier: BSD-3-Clause
"""Readers of XML files, and where they look up what these name."""

import argparse
import pathlib
import re

from .. import data_directory
from .._paths import to_vtk
from ..vtkHeliosFiltersCore import vtkHeliosMemoryLimit
from ..vtkHeliosScannerSurvey import vtkHeliosSurveyReader

SIZES = {"": 1, "k": 1e3, "m": 1e6, "g": 1e9, "t": 1e12}
SIZES |= {f"{unit}i": 1024**power for power, unit in enumerate("kmgt", 1)}
MEBIBYTE = 1024**2


def add_assets_argument(parser):
    parser.add_argument(
        "--assets",
        metavar="DIR",
        action="append",
        default=[],
        help="a folder to search for scenes, scanners and platforms; may be repeated",
    )


def size(text):
    """An argparse type: a number of bytes, as 8G or 512MiB."""
    found = re.fullmatch(r"([0-9]{1,15}(?:\.[0-9]{1,15})?) ?((?:[kmgt]i?)?)b?", text.lower())
    if not found or float(found[1]) == 0.0:
        raise argparse.ArgumentTypeError(
            f"{text!r} is not a size; expected a number of bytes such as 8G or 512M"
        )
    return float(found[1]) * SIZES[found[2]]


def add_memory_argument(parser, more=""):
    parser.add_argument(
        "--memory",
        metavar="SIZE",
        type=size,
        default=0.0,
        help=f"{more}memory limit of the whole run, such as 8G: a scene that needs more is refused before "
        "it is loaded (default: the available memory)",
    )


def limit_memory(arguments):
    """Applies --memory from here on."""
    vtkHeliosMemoryLimit.SetLimit(arguments.memory / MEBIBYTE)


def missing_folder(assets):
    """The error in the folders of --assets, or None."""
    missing = (folder for folder in assets if not pathlib.Path(folder).is_dir())
    folder = next(missing, None)
    return None if folder is None else f"--assets {folder}: no such folder"


def make_reader(path, assets):
    """A reader of a survey."""
    return look_up(vtkHeliosSurveyReader(), path, assets)


def look_up(reader, path, assets):
    """A reader, or writer, that searches the user's folders, the file's own, then the shipped data."""
    shipped = data_directory()
    beside = str(pathlib.Path(path).parent)
    reader.SetFileName(to_vtk(path))
    for folder in dict.fromkeys([*assets, beside, ".", f"{shipped}", f"{shipped}/Assets"]):
        reader.AddAssetDirectory(to_vtk(folder))
    return reader
