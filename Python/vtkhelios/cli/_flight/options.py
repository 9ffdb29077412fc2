# SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
# SPDX-License-Identifier: BSD-3-Clause
"""The options of vtkhelios plan --als."""

from ...flight._settings import ALL, NUMBERS
from ...plans.settings import SETTINGS as TRIPOD_SETTINGS
from .._parser import number
from .._plan_options import METAVARS, option_of

SHARED = ("scanner", "platform", "pulse_frequency", "crs")  # with plans of scan positions
OWN = tuple(name for name in ALL if name not in SHARED)
TEXTS = {
    "density": "least pulse density of a strip [points/m2] (default: 4)",
    "side_overlap": "overlap of neighbouring strips (default: 20)",
    "flying_height": "height of the lines above the highest ground of the area, or with "
    "--terrain-following above the ground below",
    "min_flying_height": "lowest height that may be chosen (default: as --nohd and the scanner require)",
    "max_flying_height": "largest height that may be chosen (default: as the scanner's range permits)",
    "nohd": "nominal ocular hazard distance: least height above any ground of the area (default: 0)",
    "max_climb": "steepest climb of --terrain-following (default: 10)",
    "speed": "speed over the ground (default: the largest that meets the density)",
    "min_speed": "lowest speed that may be chosen (default: 40, unmanned: 3)",
    "max_speed": "largest speed that may be chosen (default: 80, unmanned: 15)",
    "turn_time": "time of a turn to the next line (default: that of --turn-radius)",
    "turn_radius": "radius of turns (default: 20 degrees of bank, unmanned: 30)",
    "heading": "heading of the first line, clockwise from north (default: that of the shortest flight)",
    "scan_frequency": "lines or revolutions per second (default: equal spacing along and across)",
    "scan_angle": "half the scan angle (default: the scanner's largest, at most 45)",
    "cell": "cells of the predicted density (default: twice the nominal pulse spacing)",
}


def add_flight_arguments(parser):
    """Adds --als and its options."""
    group = parser.add_argument_group("airborne surveys")
    group.add_argument(
        "--als", action="store_true", help="plan the flight lines of an airborne survey instead"
    )
    group.add_argument(
        "--area",
        metavar="AREA",
        help="what to scan, in the coordinates of the scene: POLYGON ((x y, ...)), or a file (.geojson "
        "and .json, also in degrees, .wkt, .vtp, .txt or .csv with x y per line; default: the box of the "
        "scene)",
    )
    group.add_argument(
        "--spacing",
        metavar=("ALONG", "ACROSS"),
        nargs=2,
        type=number(1e-3, 1e4),
        help="instead of --density: largest distance of pulses in a strip [m]",
    )
    for name, each in NUMBERS.items():
        if name in SHARED:
            continue
        least = 1e-6 if each.positive else each.least
        group.add_argument(
            option_of(name),
            metavar=METAVARS[each.unit],
            type=number(least, each.most),
            help=TEXTS[name],
        )
    group.add_argument(
        "--terrain-following",
        action="store_true",
        default=None,
        help="follow the ground below, instead of a constant altitude",
    )


def find_misplaced(arguments):
    """Returns the error of an option that belongs to the other kind of plan, or None."""
    names = [each for each in TRIPOD_SETTINGS if each not in (*SHARED, "memory")]
    kind = "is of plans of scan positions; leave it out, or --als"
    if not arguments.als:
        names, kind = OWN, "is of flight plans; add --als, or leave it out"
    for name in names:
        if getattr(arguments, name) is not None:
            return f"{option_of(name)} {kind}"
    return None


def given_flight_settings(arguments):
    """Returns the settings among the arguments; None: not given."""
    return {name: getattr(arguments, name) for name in ALL}
