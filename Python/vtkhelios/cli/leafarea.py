# SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
# SPDX-License-Identifier: BSD-3-Clause
"""vtkhelios leafarea: plant area density in voxels, from runs and real scans."""

import pathlib

from .. import formats
from ..core.files import cannot_be_written, write_whole
from ..core.pipeline import PipelineError
from ..leafarea import ESTIMATORS, LEAF_ANGLES, SHARES, plant_area
from ..reports.leaf_area import draw_profile, leaf_area_lines
from ._messages import Messages
from ._parser import number, whole_number
from ._progress import make_progress
from ._stopping import set_outcome
from ._task import StepWatch

SUMMARY = "plant area density in voxels, its profile and leaf area index, from scans"
ENDINGS = (".vox", ".vti", ".csv", ".json", ".png")
NAMED_ANGLES = [name for name in LEAF_ANGLES if name != "table"]

EPILOG = """\
input: folders of runs, best with the pulses that hit nothing (vtkhelios run --pulses) and, for
footprints that leaves fill in part, with --hits; PTX and E57 files, whose scans have positions and
pulses that hit nothing; other files of points with --origin (and --spacing) or --trajectory.

how: in every voxel the hits of plants over the path of the beams through it, in all scans, by the
estimator. What is not counted, such as ground and wood, ends a beam and is no hit. The standard error
is that of the beams, with --leaf-size of the leaves, too; clumps, wrong leaf angles and partial hits
are not in it. Voxels that all beams end before are shadowed, not empty; in the leaf area index they
have the mean of their layer. Heights are above the ground of class 2, if there is any.

output: a table; -o FILE, repeatable:
  .vox    voxels as AMAPVox writes them: a scene scans them again as turbid voxels
  .vti    all arrays, for ParaView
  .csv    the profile
  .json   what --json prints
  .png    a picture of the profile

examples:
  vtkhelios run stand.xml --pulses
  vtkhelios leafarea output/stand --voxel 0.5 -o stand.vox -o profile.png
  vtkhelios leafarea output/stand --material leaf --estimator beer-lambert
  vtkhelios leafarea plot.ptx --class 4 --class 5
  vtkhelios fit flight.laz --output fitted
  vtkhelios leafarea flight.laz --trajectory fitted/strip001.csv --voxel 2

exit codes: 0 done; 1 failed (the reason is on standard error), 2 wrong usage, 130 interrupted
(nothing is written). See Docs/forests.md.
"""


def add_arguments(parser):
    parser.epilog = EPILOG
    parser.add_argument("clouds", metavar="RUN", nargs="+", help="a run, or a file of points")
    parser.add_argument(
        "--voxel",
        metavar="M",
        type=number(0.001, 10000),
        default=0.5,
        help="edge of a voxel [m], larger than footprints (default: %(default)s)",
    )
    parser.add_argument(
        "--estimator",
        choices=ESTIMATORS,
        default=ESTIMATORS[-1],
        help="formula of the density, see Docs/forests.md (default: %(default)s)",
    )
    parser.add_argument(
        "--leaf-angles",
        choices=NAMED_ANGLES,
        default="spherical",
        help="distribution of the leaf normals; incidence: each hit weighs by its own angle of "
        "incidence, in simulations of triangles (default: %(default)s)",
    )
    parser.add_argument(
        "--leaf-ratio",
        metavar="X",
        type=number(0.01, 100),
        default=1.0,
        help="ratio of the horizontal to the vertical axis, for ellipsoidal leaf angles "
        "(default: %(default)s)",
    )
    parser.add_argument(
        "--leaf-size",
        metavar="M2",
        type=number(0, 100),
        default=0.0,
        help="area of one side of a leaf [m²], for the standard error and the effective path "
        "(default: small)",
    )
    parser.add_argument(
        "--shares",
        choices=SHARES,
        default="energy",
        help="shares of the returns of a pulse in its energy, without --hits (default: %(default)s)",
    )
    parser.add_argument(
        "--leaf-reflectance",
        metavar="R",
        type=number(0.001, 1),
        default=0.5,
        help="reflectance of a leaf at normal incidence, for --shares reflectance "
        "(default: %(default)s)",
    )
    parser.add_argument(
        "--class",
        dest="classes",
        metavar="N",
        type=whole_number(255, lowest=0),
        action="append",
        default=[],
        help="count this class; repeatable (default: all but ground, water and noise)",
    )
    parser.add_argument(
        "--material",
        dest="materials",
        metavar="NAME",
        action="append",
        default=[],
        help="count this material; repeatable (default: all)",
    )
    parser.add_argument(
        "--bounds",
        metavar=("X1", "X2", "Y1", "Y2", "Z1", "Z2"),
        nargs=6,
        type=number(-1e12, 1e12),
        help="bounds of the grid [m] (default: those of the counted points)",
    )
    parser.add_argument(
        "--min-beams",
        metavar="N",
        type=number(1e-6, 1e6),
        default=1.0,
        help="beams without which a voxel is shadowed: their path over its edge (default: %(default)s)",
    )
    parser.add_argument(
        "--max-range",
        metavar="M",
        type=number(0, 1e6),
        help="range beyond which nothing is detected [m] (default: none)",
    )
    parser.add_argument(
        "--origin",
        metavar=("X", "Y", "Z"),
        nargs=3,
        type=number(-1e12, 1e12),
        help="origin of the beams of files [m]",
    )
    parser.add_argument(
        "--spacing",
        metavar=("AZ", "EL"),
        nargs=2,
        type=number(1e-4, 10),
        help="angles between the pulses of the scan pattern of files [deg]: directions without a "
        "point are pulses that hit nothing",
    )
    parser.add_argument(
        "--trajectory",
        metavar="FILE",
        action="append",
        help="trajectory of files with times: text, or SBET (.sbet, .out); repeatable, one for each "
        "strip",
    )
    parser.add_argument(
        "-o",
        "--output",
        metavar="FILE",
        action="append",
        default=[],
        help=f"write a file, by its ending: {' '.join(ENDINGS)}; repeatable",
    )
    parser.add_argument("--overwrite", action="store_true", help="replace existing files")
    parser.add_argument("--json", action="store_true", help="print the results as JSON")
    parser.add_argument("--quiet", action="store_true", help="print errors only")


def run(arguments):
    with Messages(quiet=arguments.quiet, results=not arguments.json) as messages:
        try:
            return estimate(arguments, messages)
        except (ValueError, PipelineError, ImportError) as error:
            messages.error(str(error))
        except MemoryError:
            messages.error("not enough memory; give larger voxels, or fewer scans")
        return 1


def estimate(arguments, messages):
    files = find_outputs(arguments)
    watch = StepWatch()
    set_outcome("nothing was written")
    with make_progress(watch, messages, quiet=arguments.quiet):
        found = plant_area(
            *arguments.clouds,
            trajectory=arguments.trajectory,
            origin=arguments.origin,
            spacing=arguments.spacing,
            on_step=watch.on_step,
            voxel=arguments.voxel,
            estimator=arguments.estimator,
            leaf_angles=arguments.leaf_angles,
            leaf_ratio=arguments.leaf_ratio,
            leaf_size=arguments.leaf_size,
            shares=arguments.shares,
            leaf_reflectance=arguments.leaf_reflectance,
            classes=arguments.classes,
            materials=arguments.materials,
            bounds=arguments.bounds,
            minimum_beams=arguments.min_beams,
            maximum_range=arguments.max_range,
        )
    for note in found.notes:
        messages.warning(note)
    for line in leaf_area_lines(found):
        messages.info(line)
    if arguments.json:
        print(found.to_json())
    for path in files:
        write(found, path)
        set_outcome(f"{path} is written")
        messages.info(f"written  {path}")
    return 0


def find_outputs(arguments):
    """Returns the files to write; FormatError for names that cannot be used."""
    paths = [pathlib.Path(name) for name in arguments.output]
    for path in paths:
        if path.suffix.lower() not in ENDINGS:
            raise formats.FormatError(
                f"{path}: ends in {path.suffix!r}; give --output one of: {', '.join(ENDINGS)}"
            )
        if path.exists() and not arguments.overwrite:
            raise formats.FormatError(f"{path}: already exists; give --overwrite to replace it")
    return paths


def write(found, path):
    try:
        path.parent.mkdir(parents=True, exist_ok=True)
        if path.suffix.lower() == ".png":
            write_whole(path, draw_profile(found))
        else:
            found.write(path)
    except OSError as error:
        raise formats.FormatError(cannot_be_written(error, path, "--output")) from error
