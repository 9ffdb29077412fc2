# SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
# SPDX-License-Identifier: BSD-3-Clause
"""The options of vtkhelios plan."""

from ..plans.document import PLATFORM, SCANNER
from ..plans.settings import SETTINGS
from ._parser import number, whole_number
from ._reading import add_assets_argument


def value_of(name):
    """Returns an argparse type: a number in the valid range of a setting."""

    def parse(text):
        return number(*SETTINGS[name].limits())(text)

    return parse


def words_of(name):
    """Returns the words of a setting."""
    return list(SETTINGS[name].words)


def given_settings(arguments):
    """Returns the settings among the arguments; None: not given."""
    return {name: getattr(arguments, name) for name in SETTINGS}


def option_of(name):
    """Returns the option of a setting."""
    return "--" + name.replace("_", "-")


def add_plan_arguments(parser):
    """Adds all options."""
    parser.add_argument(
        "input", metavar="FILE", help="a planner, survey or scene (HELIOS XML), or a mesh"
    )
    add_assets_argument(parser)
    parser.add_argument(
        "--output",
        metavar="DIR",
        default="output",
        help="where the files go (default: %(default)s)",
    )
    parser.add_argument(
        "--overwrite",
        action="store_true",
        help="replace the files of an earlier plan (default: keep them and refuse to plan)",
    )
    add_method_arguments(parser.add_argument_group("coverage"))
    add_candidate_arguments(parser.add_argument_group("scan positions"))
    add_sight_arguments(parser.add_argument_group("visibility"))
    add_scan_arguments(parser.add_argument_group("scan settings"))
    parser.add_argument(
        "--check",
        action="store_true",
        help="simulate the survey, without noise, and compare predicted with simulated coverage",
    )
    parser.add_argument("--no-picture", action="store_true", help="do not write plan.png")
    parser.add_argument(
        "--memory",
        metavar="MIB",
        type=value_of("memory"),
        help="memory limit of grids and viewsheds (default: 2048 MiB)",
    )
    parser.add_argument(
        "--threads",
        metavar="N",
        type=whole_number(4096),
        default=0,
        help="number of threads; 0: one per processor core (default: %(default)s)",
    )
    parser.add_argument("--json", action="store_true", help="print the summary as JSON")
    parser.add_argument("--quiet", action="store_true", help="print errors only")


def add_method_arguments(group):
    group.add_argument(
        "--method", metavar="NAME", choices=words_of("method"), help="planning method: %(choices)s"
    )
    group.add_argument(
        "--coverage",
        metavar="PERCENT",
        type=value_of("coverage"),
        help="fraction of the test points that must be covered (default: 100)",
    )
    group.add_argument(
        "--coverage-of",
        metavar="WHICH",
        choices=words_of("coverage_of"),
        help="percent of the test points that any candidate sees, or of all (default: coverable)",
    )
    group.add_argument(
        "--overlap",
        metavar="PERCENT",
        type=value_of("overlap"),
        help="overlap that connects the scans, in percent of common points, for registration "
        "(default: 0)",
    )
    group.add_argument(
        "--objects",
        metavar="PERCENT",
        type=value_of("objects"),
        help="share of the area of each part that must be covered, of what any candidate sees; without "
        "--coverage nothing else is required (default: 0)",
    )
    group.add_argument(
        "--order",
        metavar="WHICH",
        choices=words_of("order"),
        help="order of the scans: gain, the largest first (default); walk, the shortest walk; round, the "
        "shortest that returns",
    )
    group.add_argument(
        "--area-weights",
        action="store_true",
        default=None,
        help="weight test points by the area that they represent",
    )
    group.add_argument(
        "--remove-order",
        metavar="KEY",
        choices=words_of("remove_order"),
        help="reduce: removal criterion, %(choices)s (default: viewshedSize)",
    )
    group.add_argument(
        "--remove-first",
        metavar="WHICH",
        choices=words_of("remove_first"),
        help="reduce: values removed first (default: smallest)",
    )
    group.add_argument(
        "--time-limit",
        metavar="S",
        type=value_of("time_limit"),
        help="optimal: limit of the search, in wall time (default: 300 s)",
    )


def add_candidate_arguments(group):
    group.add_argument(
        "--grid", metavar="M", type=value_of("grid"), help="spacing of candidates along x and y"
    )
    group.add_argument(
        "--grid-y", metavar="M", type=value_of("grid_y"), help="spacing along y, if different"
    )
    group.add_argument(
        "--region",
        metavar=("X0", "X1", "Y0", "Y1"),
        nargs=4,
        type=float,
        help="rectangle of the candidates (default: the scene's)",
    )
    group.add_argument(
        "--exclude", metavar="FILE.vtp", help="excluded areas: polygons or closed lines"
    )
    group.add_argument(
        "--max-slope",
        metavar="DEG",
        type=value_of("max_slope"),
        help="exclude steeper places (default: 15)",
    )
    group.add_argument(
        "--ground",
        metavar="WHERE",
        choices=words_of("ground"),
        help="positions on ground (helios_isGround of materials): true, false, open (with nothing "
        "above), auto (true if any material is ground; default)",
    )
    group.add_argument(
        "--enclosed",
        action="store_true",
        default=None,
        help="include enclosed places, such as rooms (default: only if there are no others)",
    )
    group.add_argument(
        "--height",
        metavar="M",
        type=value_of("height"),
        help="instrument height above the ground (default: that of the platform's mount)",
    )


def add_sight_arguments(group):
    group.add_argument(
        "--test-grid",
        metavar="M",
        type=value_of("test_grid"),
        help="spacing of test points (default: that of --grid)",
    )
    group.add_argument(
        "--test-lines",
        metavar="WHICH",
        choices=words_of("test_lines"),
        help="grid lines that carry test points: %(choices)s (default: all)",
    )
    group.add_argument(
        "--tolerance",
        metavar="M",
        type=value_of("tolerance"),
        help="a ray sees a test point if it ends at most this far before it (default: 0.05)",
    )
    group.add_argument(
        "--two-sided",
        action="store_true",
        default=None,
        help="also limit the distance behind it: the test of the paper",
    )
    group.add_argument(
        "--scanner-limits",
        action="store_true",
        default=None,
        help="use the scanner's range gate and field of view where no limit is given",
    )
    group.add_argument(
        "--range-min", metavar="M", type=value_of("range_min"), help="minimum range (default: 0)"
    )
    group.add_argument(
        "--range-max",
        metavar="M",
        type=value_of("range_max"),
        help="maximum range (default: no limit)",
    )
    group.add_argument(
        "--elevation-min",
        metavar="DEG",
        type=value_of("elevation_min"),
        help="vertical FOV, minimum (default: -90)",
    )
    group.add_argument(
        "--elevation-max",
        metavar="DEG",
        type=value_of("elevation_max"),
        help="vertical FOV, maximum (default: 90)",
    )
    group.add_argument(
        "--max-incidence",
        metavar="DEG",
        type=value_of("max_incidence"),
        help="maximum angle of incidence, from the surface normal (default: 90)",
    )
    group.add_argument(
        "--min-density",
        metavar="N",
        type=value_of("min_density"),
        help="minimum point density on a surface from one position [points/m2] (default: 0)",
    )


def add_scan_arguments(group):
    group.add_argument(
        "--platform",
        metavar="REF",
        help=f"file.xml#id (default: the file's, else {PLATFORM}; --als: an aeroplane, of "
        "unmanned scanners a multicopter)",
    )
    group.add_argument(
        "--scanner",
        metavar="REF",
        help=f"file.xml#id (default: the file's, else {SCANNER}; --als: rotating_als)",
    )
    group.add_argument(
        "--resolution",
        metavar="DEG",
        type=value_of("resolution"),
        help="angular step between pulses of a line and between lines, as near as the scanner "
        "allows (default: the file's, else 0.1)",
    )
    group.add_argument(
        "--pulse-frequency",
        metavar="HZ",
        type=value_of("pulse_frequency"),
        help="pulse frequency (default: the file's, else the scanner's first)",
    )
