# SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
# SPDX-License-Identifier: BSD-3-Clause
"""vtkhelios export: a run in the layout of a public data set."""

import argparse
import json
import pathlib

from .. import formats, learning
from ..core.files import cannot_be_written, new_folder
from ..core.pipeline import PipelineError
from ..core.run_files import find_epoch
from ..core.words import counted
from ..formats._run import RunReader, is_run
from ..surveys.survey import read_survey
from ._messages import Messages
from ._progress import make_progress
from ._stopping import set_outcome
from ._task import Task

SUMMARY = "write a run as KITTI, SemanticKITTI, nuScenes, S3DIS, MCAP or a ROS 2 bag"
WINDOW = 0.1  # [s], of the 10 Hz of KITTI

EPILOG = """\
layouts:
  --kitti          sequences/00/velodyne/000000.bin, times.txt, calib.txt; poses/00.txt
  --semantickitti  the same, with labels/000000.label (label and instance) and poses.txt
  --kitti-objects  training/velodyne, label_2 and calib: boxes of vehicles and persons; needs --survey
  --nuscenes       samples, lidarseg and tables with boxes of objects; needs --survey
  --s3dis          Area_1/ROOM/ROOM.txt and Annotations/CLASS_NUMBER.txt; a room is a scan
  --mcap           scans.mcap: PointCloud2 with ring, time offset, intensity, range and return number; the
                   pulses without an echo, of runs with --pulses; the poses of platform and sensor as /tf.
                   Needs mcap and rosbags: pip install mcap rosbags 'numpy<2' (of Debian 12)
  --rosbag         the same as a bag of ROS 2: metadata.yaml and scans_0.mcap

A scan is a time window of a leg, in the frame of the sensor at its middle: its origin is the mount of
the scanner, x forward (the y axis of the scanner), y left, z up. --frame platform: that of the platform.
(S3DIS: along the axes of the run.) Intensities have one scale in all scans.

Labels are those of SemanticKITTI: by words in the names of parts (car 10, bicycle 11, bus 13, person 30,
bicyclist 31, pole 80, sign 81, fence 51, house 50 ...), by words in the names of materials (bark, wood,
trunk ... are trunk 71, leaf, needle ... vegetation 70), and by class (terrain, vegetation, building,
road ...). With --motion of the run, what moves has its own (moving car 252, bicyclist 253, person 254
...). Instances are parts; parts mounted on others belong to their carriers. Runs as text do not store
the names of materials: give their numbers, or run with --format las, laz or vtp.

--labels FILE (JSON): {"parts": {"kiosk": 50, "7": 10}, "materials": {"bark": 71, "3": 70},
{indent}"classes": {"2": 72}, "moving": {"10": 252}}; it extends these tables.

--survey FILE: the survey of the run, whose scene has the boxes of objects: upright, of least floor area,
when the middle of their echoes of the scan was made. Of parts that move they need a run with --motion.

examples:
  vtkhelios export output/street kitti --semantickitti
  vtkhelios export output/street boxes --kitti-objects --survey street.xml
  vtkhelios export output/forest forest --s3dis --window leg
  vtkhelios export output/street street --rosbag --window 0.05

OUT appears when it is complete.

exit codes: 0 done, 1 failed (the reason is on standard error), 2 wrong usage, 130 interrupted.
""".replace(
    "{indent}", " " * 16
)


def window(text):
    """Returns an argparse type: seconds, or None for "leg"."""
    if text == "leg":
        return None
    try:
        seconds = float(text)
    except ValueError:
        seconds = 0.0
    if not 1e-6 <= seconds <= 1e6:
        raise argparse.ArgumentTypeError(
            f"{text} is not valid: expected seconds, 1e-6 to 1e6, or leg"
        )
    return seconds


def add_arguments(parser):
    parser.epilog = EPILOG
    parser.add_argument("folder", metavar="RUN", help="the folder of a run")
    parser.add_argument(
        "output", metavar="OUT", nargs="?", default=argparse.SUPPRESS, help="a new folder"
    )
    parser.add_argument("--output", "-o", metavar="FOLDER", help="OUT, by an option")
    layouts = parser.add_mutually_exclusive_group(required=True)
    for name in learning.WRITERS:
        layouts.add_argument(f"--{name}", dest="layout", action="store_const", const=name,
                             help="see below")  # fmt: skip
    parser.add_argument(
        "--window",
        metavar="S|leg",
        type=window,
        default=WINDOW,
        help=f"duration of a scan [s], or leg: a scan is a leg (default: {WINDOW})",
    )
    parser.add_argument(
        "--frame",
        choices=("sensor", "platform"),
        default="sensor",
        help="frame of points and poses (default: sensor)",
    )
    parser.add_argument(
        "--labels", metavar="FILE", help="labels of parts, materials and classes (JSON)"
    )
    parser.add_argument("--survey", metavar="FILE", help="survey of the run, for boxes of objects")
    parser.add_argument("--json", action="store_true", help="print the results as JSON")
    parser.add_argument("--quiet", action="store_true", help="print errors only")


def run(arguments):
    with Messages(quiet=arguments.quiet, results=not arguments.json) as messages:
        if arguments.output is None:
            messages.error("OUT is missing: give the name of a new folder")
            return 2
        try:
            return export(arguments, messages)
        except (formats.FormatError, ImportError, PipelineError) as error:
            messages.error(str(error))
        except OSError as error:
            messages.error(cannot_be_written(error, arguments.output, "OUT"))
        return 1


def export(arguments, messages):
    folder, output = pathlib.Path(arguments.folder), pathlib.Path(arguments.output)
    if not is_run(folder):
        raise formats.FormatError(f"{folder}: is not a folder; give the folder of a run")
    if output.exists() and (not output.is_dir() or any(output.iterdir())):
        raise formats.FormatError(f"{output}: already exists; give a new or empty folder")
    labels = learning.Labels.read(arguments.labels) if arguments.labels else learning.Labels()
    with RunReader(folder) as reader:
        task = Task("exporting", reader.count)
        set_outcome(f"{output} was not written")
        with new_folder(output) as new:
            survey = arguments.survey and find_survey(arguments.survey, reader)
            content = learning.Content.of(reader, labels, survey)
            writer = learning.WRITERS[arguments.layout](new, content)
            with make_progress(task, messages, quiet=arguments.quiet):
                frames = learning.read_scans(reader, arguments.window, arguments.frame)
                scans, points = writer.write(counted_scans(frames, task))
        set_outcome(f"{output} is written")
    messages.info(
        f"{arguments.layout} {output}: {counted(scans, 'scan')}, {counted(points, 'point')}"
    )
    if arguments.json:
        result = {
            "folder": str(output),
            "layout": arguments.layout,
            "scans": scans,
            "points": points,
        }
        print(json.dumps(result, indent=2))
    return 0


def find_survey(path, reader):
    """Returns the survey of a run, in its epoch."""
    learning.check_inputs(path, reader.summary)
    survey = read_survey(path)
    epoch = find_epoch(reader.folder)
    if epoch > 0:
        survey.source_of({"epoch": epoch})
    return survey


def counted_scans(scans, task):
    """Yields the scans; shows the progress. FormatError if there are none."""
    scan = None
    for scan in scans:
        yield scan
        task.advance(len(scan.arrays["points"]))
    if scan is None:
        raise formats.FormatError("the run has no points; run the survey again")
