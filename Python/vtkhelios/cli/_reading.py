# SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
# SPDX-License-Identifier: BSD-3-Clause
"""Options that several commands have: --assets, --plugin, --threads and --memory."""

import argparse
import re

from ..core.plugins import load_plugin
from ..vtkHeliosFiltersCore import vtkHeliosMemoryLimit
from ._parser import whole_number

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
    add_plugin_argument(parser)


def add_plugin_argument(parser):
    parser.add_argument(
        "--plugin",
        metavar="FILE",
        action="append",
        default=[],
        help="a file in Python (.py), or a shared library (.so), that registers echo detectors; may be "
        "repeated",
    )


def load_plugins(words):
    """Loads the plug-ins of --plugin in the words of a command, before its parser knows detectors."""
    parser = argparse.ArgumentParser(add_help=False, exit_on_error=False)
    add_plugin_argument(parser)
    try:
        files = parser.parse_known_args(words)[0].plugin
    except argparse.ArgumentError:
        return  # the command reports it
    for file in files:
        load_plugin(file)


def size(text):
    """Returns an argparse type: a number of bytes, as 8G or 512MiB."""
    found = re.fullmatch(r"([0-9]{1,15}(?:\.[0-9]{1,15})?) ?((?:[kmgt]i?)?)b?", text.lower())
    if not found or float(found[1]) == 0.0:
        raise argparse.ArgumentTypeError(
            f"{text!r} is not a size; expected a number of bytes such as 8G or 512M"
        )
    return float(found[1]) * SIZES[found[2]]


def add_threads_argument(parser):
    parser.add_argument(
        "--threads",
        metavar="N",
        type=whole_number(4096),
        default=0,
        help="number of threads; 0: one per processor core (default: %(default)s)",
    )


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
