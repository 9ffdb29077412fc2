# SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
# SPDX-License-Identifier: BSD-3-Clause
"""The options of vtkhelios plan."""

from ._planning import GROUND, LINES, METHODS
from ._reading import add_assets_argument
from .run import number, whole_number

PLATFORM, SCANNER = "platforms.xml#tripod", "scanners.xml#vz400_class_tls"


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
        help="replace the files of an earlier plan; without it they are kept, and the plan refused",
    )
    add_method_arguments(parser.add_argument_group("what is enough"))
    add_candidate_arguments(parser.add_argument_group("where a scanner may stand"))
    add_sight_arguments(parser.add_argument_group("what it sees"))
    add_scan_arguments(parser.add_argument_group("how it scans"))
    parser.add_argument(
        "--check",
        action="store_true",
        help="simulate the survey, without noise, and compare predicted with simulated coverage",
    )
    parser.add_argument("--no-picture", action="store_true", help="no plan.png")
    parser.add_argument(
        "--memory",
        metavar="MIB",
        type=number(1, 1e9),
        default=2048.0,
        help="memory that grids and viewsheds may take (default: %(default)g MiB)",
    )
    parser.add_argument(
        "--threads",
        metavar="N",
        type=whole_number(4096),
        default=0,
        help="how many processor cores to use; 0: all (default: %(default)s)",
    )
    parser.add_argument("--json", action="store_true", help="print the summary as JSON")
    parser.add_argument("--quiet", action="store_true", help="print errors only")


def add_method_arguments(group):
    group.add_argument(
        "--method", metavar="NAME", choices=METHODS, help="how positions are chosen: %(choices)s"
    )
    group.add_argument(
        "--coverage",
        metavar="PERCENT",
        type=number(1e-6, 100),
        help="share of the test points that must be seen (default: 100)",
    )
    group.add_argument(
        "--coverage-of",
        metavar="WHICH",
        choices=["coverable", "all"],
        help="of those that any candidate sees, or of all (default: coverable)",
    )
    group.add_argument(
        "--overlap",
        metavar="PERCENT",
        type=number(0, 99.9),
        help="scans are connected by such shares of common points, for registration (default: 0)",
    )
    group.add_argument(
        "--area-weights",
        action="store_true",
        help="test points count by the area that they stand for",
    )
    group.add_argument(
        "--remove-order",
        metavar="KEY",
        choices=["viewshedSize", "meanIncidenceAngle"],
        help="reduce: %(choices)s (default: viewshedSize)",
    )
    group.add_argument(
        "--remove-first",
        metavar="WHICH",
        choices=["smallest", "largest"],
        help="reduce: which go first (default: smallest)",
    )
    group.add_argument(
        "--time-limit",
        metavar="S",
        type=number(0, 1e6),
        help="optimal: how long it may search, on the clock (default: 300 s)",
    )


def add_candidate_arguments(group):
    group.add_argument(
        "--grid", metavar="M", type=number(1e-6, 1e6), help="distance of candidates along x and y"
    )
    group.add_argument(
        "--grid-y", metavar="M", type=number(1e-6, 1e6), help="along y, where it is another"
    )
    group.add_argument(
        "--region",
        metavar=("X0", "X1", "Y0", "Y1"),
        nargs=4,
        type=float,
        help="candidates are in this rectangle (default: the scene's)",
    )
    group.add_argument(
        "--exclude", metavar="FILE.vtp", help="areas to keep out of: polygons or closed lines"
    )
    group.add_argument(
        "--max-slope",
        metavar="DEG",
        type=number(0, 90),
        help="steeper places are none to stand on (default: 15)",
    )
    group.add_argument(
        "--ground",
        metavar="WHERE",
        choices=list(GROUND),
        help="stand on ground, by helios_isGround of materials: true, false, open (with nothing "
        "above), auto (if any material is ground; default)",
    )
    group.add_argument(
        "--enclosed",
        action="store_true",
        help="stand in places that are closed all around, too (without it only where there are no "
        "others)",
    )
    group.add_argument(
        "--height",
        metavar="M",
        type=number(1e-6, 1e4),
        help="of the instrument above the place (default: as the platform carries it)",
    )


def add_sight_arguments(group):
    group.add_argument(
        "--test-grid",
        metavar="M",
        type=number(1e-6, 1e6),
        help="distance of test points (default: as --grid)",
    )
    group.add_argument(
        "--test-lines",
        metavar="WHICH",
        choices=list(LINES),
        help="test points are on these lines: %(choices)s (default: all)",
    )
    group.add_argument(
        "--tolerance",
        metavar="M",
        type=number(1e-6, 1e3),
        help="how far before a test point a ray may end that sees it (default: 0.05)",
    )
    group.add_argument(
        "--two-sided",
        action="store_true",
        help="a ray must not end farther behind it, either: the test of the paper",
    )
    group.add_argument(
        "--scanner-limits",
        action="store_true",
        help="ranges and field of view are those of the scanner, where not given",
    )
    group.add_argument("--range-min", metavar="M", type=number(0, 1e9), help="nearest (default: 0)")
    group.add_argument(
        "--range-max", metavar="M", type=number(0, 1e9), help="farthest (default: no limit)"
    )
    group.add_argument(
        "--elevation-min", metavar="DEG", type=number(-90, 90), help="lowest (default: -90)"
    )
    group.add_argument(
        "--elevation-max", metavar="DEG", type=number(-90, 90), help="highest (default: 90)"
    )
    group.add_argument(
        "--max-incidence",
        metavar="DEG",
        type=number(0, 90),
        help="largest angle from the normal of a surface (default: 90)",
    )
    group.add_argument(
        "--min-density",
        metavar="N",
        type=number(0, 1e12),
        help="points a square metre that a surface must get from one position (default: 0)",
    )


def add_scan_arguments(group):
    group.add_argument(
        "--platform", metavar="REF", help=f"file.xml#id (default: the file's, else {PLATFORM})"
    )
    group.add_argument(
        "--scanner", metavar="REF", help=f"file.xml#id (default: the file's, else {SCANNER})"
    )
    group.add_argument(
        "--resolution",
        metavar="DEG",
        type=number(1e-6, 90),
        default=0.0,
        help="between pulses of a line, and between lines, as near as the scanner can "
        "(default: the file's, else 0.1)",
    )
    group.add_argument(
        "--pulse-frequency",
        metavar="HZ",
        type=number(1e-3, 1e9),
        default=0.0,
        help="pulses a second (default: the file's, else the scanner's first)",
    )
