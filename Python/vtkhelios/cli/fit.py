# SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
# SPDX-License-Identifier: BSD-3-Clause
"""vtkhelios fit: the instrument and the flight of a real airborne cloud."""

import pathlib

from .. import formats
from ..core.files import cannot_be_written
from ..fitting import POINTS
from ..fitting._fit import fit_watched
from ..fitting._write import FILES, write_fit
from ..reports.fit import fit_lines
from ._messages import Messages
from ._parser import number, whole_number
from ._progress import make_progress
from ._stopping import set_outcome
from ._task import StepWatch

FIT_FILE = "fit.json"
SUMMARY = "find the instrument and the flight of an airborne cloud, and write them as a survey"

EPILOG = """\
input: clouds of one flight: files of points (see vtkhelios convert --help), folders of files. They
need GpsTime, and ScanAngle or pulses of several returns; point source ids (LegIds), scan directions,
edge flags, classes and intensities are used where there are any.

what it finds, each number with the half width of its 95 % interval and how it was found:
  pulse frequency      times of pulses as whole multiples of a period; intervals, if they alternate
  trajectory           of each strip: where the beams meet, the lines through the first and the last
                       return of a pulse. Without such pulses: by scan angles, which are taken to
                       include the roll
  height, speed        of the trajectory; the height is above the median of the ground (class 2)
  mirror               rotating, oscillating or conic; line frequency; sweep, law of motion, angles
                       of the points as seen from the trajectory
  attitude             what the law of the mirror leaves of the angles: roll, pitch, yaw
  range noise          on planes within a strip, by incidence and intensity
  threshold            smallest intensities; they are not calibrated
  beam divergence      from pulses that edges of roofs divide
"not known" is followed by the reason.

output: a table; --output FOLDER writes
  scanner.xml          a <scanner> with what is known; all else is the default of vtkHelios
  survey.xml           a leg for each strip, along its trajectory
  strip001.csv ...     the trajectories: time, roll, pitch, yaw, x, y, z
  ground.obj           a level plane at the height of the ground, without --scene
  fit.json             what --json prints

examples:
  vtkhelios fit real.laz
  vtkhelios fit strips --output fitted --scene city.xml#city
  vtkhelios run fitted/survey.xml --format las
  vtkhelios compare real.laz output/fitted

exit codes: 0 done; 1 failed (the reason is on standard error), 2 wrong usage, 130 interrupted
(nothing is written). See Docs/fit.md.
"""


def add_arguments(parser):
    parser.epilog = EPILOG
    parser.add_argument("clouds", metavar="CLOUD", nargs="+", help="a file, or a folder of files")
    parser.add_argument(
        "--output", "-o", metavar="FOLDER", help="write the scanner and the survey there"
    )
    parser.add_argument(
        "--scene",
        metavar="FILE.xml#ID",
        help="the scene of the survey (default: a level plane, which is written)",
    )
    parser.add_argument(
        "--unit",
        metavar="M",
        type=number(1e-6, 1e6),
        help="unit of the coordinates [m], 0.3048 for feet (default: that of the coordinate "
        "system, else 1)",
    )
    parser.add_argument(
        "--points",
        metavar="N",
        type=whole_number(10**10, lowest=1000),
        default=POINTS,
        help="maximum number of points, of about 150 bytes each (default: %(default)s)",
    )
    parser.add_argument("--overwrite", action="store_true", help="replace existing files")
    parser.add_argument("--json", action="store_true", help="print the results as JSON")
    parser.add_argument("--quiet", action="store_true", help="print errors only")


def run(arguments):
    with Messages(quiet=arguments.quiet, results=not arguments.json) as messages:
        try:
            return fit_clouds(arguments, messages)
        except formats.FormatError as error:
            messages.error(str(error))
        except MemoryError:
            messages.error("not enough memory; give fewer strips")
        return 1


def fit_clouds(arguments, messages):
    folder = find_output(arguments)
    watch = StepWatch()
    set_outcome("nothing was written")
    with make_progress(watch, messages, quiet=arguments.quiet):
        result = fit_watched(arguments.clouds, watch.on_step, arguments.unit, arguments.points)
    for note in result.notes:
        messages.warning(note)
    for line in fit_lines(result):
        messages.info(line)
    if arguments.json:
        print(result.to_json())
    if folder:
        set_outcome(f"the files in {folder} may be of several runs; give --overwrite")
        write(result, folder, arguments.scene)
        set_outcome(f"{folder} is written")
        messages.info(f"written  {folder}; fly it: vtkhelios run {folder / 'survey.xml'}")
    return 0


def find_output(arguments):
    """Returns the folder to write to, or None; FormatError if it has a file that would be
    replaced."""
    if not arguments.output:
        if arguments.scene:
            raise formats.FormatError("--scene is of the survey that --output writes; give it, too")
        return None
    if arguments.scene and "#" not in arguments.scene:
        raise formats.FormatError(
            f"--scene {arguments.scene}: has no id; give the file and the id of the scene, as in "
            f"{arguments.scene}#scene"
        )
    folder = pathlib.Path(arguments.output)
    there = [path for name in (*FILES, FIT_FILE) for path in sorted(folder.glob(name))]
    if there and not arguments.overwrite:
        raise formats.FormatError(f"{there[0]}: already exists; give --overwrite to replace it")
    return folder


def write(result, folder, scene):
    try:
        write_fit(result, folder, scene, **{FIT_FILE: result.to_json()})
    except OSError as error:
        raise formats.FormatError(cannot_be_written(error, folder, "--output")) from error
