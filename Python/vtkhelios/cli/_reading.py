# SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
# SPDX-License-Identifier: BSD-3-Clause
"""Options that several commands have: --assets, --memory and --height-unit."""

import argparse
import re

from ..core.systems import HEIGHT_UNITS
from ..vtkHeliosFiltersCore import vtkHeliosMemoryLimit

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
    """Returns an argparse type: a number of bytes, as 8G or 512MiB."""
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


def height_unit(text):
    """Returns the unit of heights of an option [m]."""
    if text in HEIGHT_UNITS:
        return HEIGHT_UNITS[text]
    try:
        value = float(text)
    except ValueError:
        value = 0.0
    if not 1e-6 <= value <= 1e6:
        raise argparse.ArgumentTypeError(
            f"{text!r} is no unit of heights: {', '.join(HEIGHT_UNITS)}, or its metres"
        )
    return value


def add_height_unit_argument(parser):
    parser.add_argument(
        "--height-unit",
        metavar="UNIT",
        type=height_unit,
        help="unit of the heights of the inputs: m, ft, us-ft, or metres (default: as their "
        "coordinate system states, else that of x and y)",
    )
