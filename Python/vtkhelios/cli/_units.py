# SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
# SPDX-License-Identifier: BSD-3-Clause
"""Adds the option --height-unit."""

import argparse

from ..core.systems import HEIGHT_UNITS


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
