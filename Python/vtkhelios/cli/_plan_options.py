# SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
# SPDX-License-Identifier: BSD-3-Clause
"""The options of vtkhelios plan."""

from ..core.files import find_unwritable
from ..plans.document import PLATFORM, SCANNER
from ..plans.files import has_plan
from ..plans.geo import FORMATS
from ..plans.kinds import Areas, Choice, Flag, Number, PlanString, Region, Setting
from ..plans.places import Places
from ..plans.settings import SETTINGS
from ._parser import number
from ._reading import add_assets_argument, add_threads_argument

METAVARS = {  # words for the numbers of each unit
    "1/m2": "N", "%": "PERCENT", "m": "M", "deg": "DEG", "m/s": "M/S", "s": "S", "Hz": "HZ",
    "MiB": "MIB",
}  # fmt: skip
WORDS = {
    "method": "NAME",
    "remove_order": "KEY",
    "ground": "WHERE",
    "on": "WHERE",
}  # for a choice; others have WHICH
TEXTS = {  # help of each setting, by group
    "coverage": {
        "method": "planning method: %(choices)s",
        "coverage": "fraction of the test points that must be covered (default: 100)",
        "coverage_of": "percent of the test points that any candidate sees, or of all (default: "
        "coverable)",
        "overlap": "overlap that connects the scans, in percent of common points, for "
        "registration (default: 0)",
        "objects": "share of the area of each part that must be covered, of what any candidate "
        "sees; without --coverage nothing else is required (default: 0)",
        "order": "order of the scans: gain, the largest first (default); walk, the shortest walk;"
        " round, the shortest that returns",
        "area_weights": "weight test points by the area that they represent",
        "remove_order": "reduce: removal criterion, %(choices)s (default: viewshedSize)",
        "remove_first": "reduce: values removed first (default: smallest)",
        "time_limit": "optimal: limit of the search, in wall time (default: 300 s)",
    },
    "scan positions": {
        "grid": "spacing of candidates along x and y",
        "grid_y": "spacing along y, if different",
        "region": "rectangle of the candidates (default: the scene's)",
        "region_of": "what --region limits: candidates, or all, which is test points, too (default: "
        "candidates)",
        "candidates": "places to choose from instead of a grid: a .csv with columns x, y and, if wanted, z"
        " of the ground, or a .geojson of points",
        "exclude": "excluded areas: polygons or closed lines",
        "max_slope": "exclude steeper places (default: 15)",
        "on": "where tripods stand: ground, not on roofs (default), or any surface",
        "ground": "--on in detail: positions on ground (helios_isGround of materials): true, false, open (with "
        "nothing above), auto (true if any material is ground, else not on roofs; default)",
        "enclosed": "include enclosed places, such as rooms (default: only if there are no "
        "others)",
        "height": "instrument height above the ground (default: that of the platform's mount)",
    },
    "visibility": {
        "test_grid": "spacing of test points (default: that of --grid)",
        "test_lines": "grid lines that carry test points: %(choices)s (default: all)",
        "tolerance": "a ray sees a test point if it ends at most this far before it (default: "
        "0.05)",
        "two_sided": "also limit the distance behind it: the test of the paper",
        "scanner_limits": "use the scanner's range gate and field of view where no limit is given",
        "moving_parts": "plan with the parts that move, where they are at the start (default: they are left out)",
        "range_min": "minimum range (default: 0)",
        "range_max": "maximum range (default: no limit)",
        "elevation_min": "vertical FOV, minimum (default: -90)",
        "elevation_max": "vertical FOV, maximum (default: 90)",
        "max_incidence": "maximum angle of incidence, from the surface normal (default: 90)",
        "min_density": "minimum point density on a surface from one position [points/m2] "
        "(default: 0)",
    },
    "field work": {
        "setup_time": "for setting up a tripod (default: 300)",
        "walking_speed": "between tripods (default: 1)",
        "crs": "coordinate system of a scene that has none, such as EPSG:25832, for the geo files",
    },
    "scan settings": {
        "platform": f"file.xml#id (default: the file's, else {PLATFORM}; --als: an aeroplane, of "
        "unmanned scanners a multicopter)",
        "scanner": f"file.xml#id (default: the file's, else {SCANNER}; --als: rotating_als)",
        "resolution": "angular step between pulses of a line and between lines, as near as the "
        "scanner allows (default: the file's, else 0.1)",
        "pulse_frequency": "pulse frequency (default: the file's, else the scanner's first)",
    },
}


def value_of(name):
    """Returns an argparse type: a number in the valid range of a setting."""
    return lambda text: number(*SETTINGS[name].limits())(text)


def given_settings(arguments):
    """Returns the settings among the arguments; None: not given."""
    return {name: getattr(arguments, name) for name in SETTINGS}


def option_of(name):
    """Returns the option of a setting."""
    return "--" + name.replace("_", "-")


def add_setting(group, name, text):
    """Adds the option of a setting; its kind says what it takes."""
    setting = SETTINGS[name]
    if isinstance(setting, Flag):
        takes = {"action": "store_true", "default": None}
    elif isinstance(setting, Number):
        takes = {
            "metavar": METAVARS[setting.unit],
            "type": value_of(name),
        }
    elif isinstance(setting, Choice):
        takes = {"metavar": WORDS.get(name, "WHICH"), "choices": list(setting.words)}
    elif isinstance(setting, Region):
        takes = {"metavar": ("X0", "X1", "Y0", "Y1"), "nargs": 4, "type": float}
    else:
        kinds = ((Areas, "FILE.vtp"), (Places, "FILE"), (PlanString, "CRS"), (Setting, "REF"))
        takes = {"metavar": next(word for kind, word in kinds if isinstance(setting, kind))}
    group.add_argument(option_of(name), help=text, **takes)


def add_plan_arguments(parser):
    """Adds all options."""
    parser.add_argument(
        "input", metavar="FILE", help="a planner, survey or scene (HELIOS XML), or a mesh"
    )
    add_assets_argument(parser)
    parser.add_argument(
        "--output",
        "-o",
        metavar="DIR",
        default="output",
        help="where the files go (default: %(default)s)",
    )
    parser.add_argument(
        "--overwrite",
        action="store_true",
        help="replace the files of an earlier plan (default: keep them and refuse to plan)",
    )
    for title, texts in TEXTS.items():
        group = parser.add_argument_group(title)
        for name, text in texts.items():
            add_setting(group, name, text)
    parser.add_argument(
        "--check",
        action="store_true",
        help="simulate the survey, without noise, and compare predicted with simulated coverage",
    )
    parser.add_argument(
        "--geo",
        metavar="FORMATS",
        help=f"files for maps and receivers: {','.join(FORMATS)}, or none (default: all that the "
        "coordinate system of the scene permits)",
    )
    parser.add_argument(
        "--no-picture", action="store_true", help="do not write plan.png and plan.html"
    )
    add_setting(parser, "memory", "memory limit of grids and viewsheds (default: 2048 MiB)")
    add_threads_argument(parser)
    parser.add_argument("--json", action="store_true", help="print the summary as JSON")
    parser.add_argument("--quiet", action="store_true", help="print errors only")


def find_unusable(folder, overwrite, files):
    """Why a plan cannot be written to a folder, or None."""
    if not overwrite and has_plan(folder, files):
        return (
            f"{folder}: holds the files of an earlier plan, which are kept; give --overwrite to "
            "replace them, or another --output"
        )
    return find_unwritable(folder, "--output")
