# SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
# SPDX-License-Identifier: BSD-3-Clause
"""vtkhelios detect: re-runs echo detection on stored waveforms."""

import argparse
import json
import os
import pathlib
import sys

import numpy as np
from vtkmodules.vtkCommonCore import vtkSMPTools

import vtkhelios

from .. import formats
from ..array_names import CLASSIFICATION_IDS, PART_IDS
from ..core.arrays import numpy_to_vtk
from ..core.paths import to_vtk
from ..core.run_files import PART
from ..core.unfinished import set_unfinished
from ..formats._waveforms import count_pieces, make_waveform_reader
from ._messages import Messages
from ._parser import number, whole_number
from ._reading import add_plugin_argument, add_threads_argument
from ._standard import folder_of_standard, is_standard, write_output
from ._stopping import set_outcome
from .run import detectors

SUMMARY = "re-run echo detection on stored waveforms, with another detector or threshold"
STANDARD = ("output",)

EPILOG = """\
what it reads: legNNN_fullwave.pvtt or .txt as vtkhelios run --waveforms writes them, or with
--one-way the legNNN_fullwave.txt of HELIOS++, whose times are one-way. Also LAS or LAZ with waveforms
(point formats 4, 5, 9 and 10, with their .wdp) and PulseWaves 0.3 (.pls with .wvs), of vtkHelios or
of an instrument; these are read as a whole. Samples of an instrument are in a unit of its own, of
which 1 counts as 1 W: --threshold 8e9 is 8 of them.

what it writes: the same columns as a run. Waveforms do not identify the surface: in text the
object is -1 and the class 0.

For a run with a fixed number of sub-rays (beamSampleQuality, --sub-rays) the same detector gives
the same echoes again; for a run with adaptive sampling, the same within its tolerances.

examples:
  vtkhelios detect leg000_fullwave.pvtt --detector gaussian -o leg000_gaussian.xyz
  vtkhelios detect flight.las --detector gaussian --pulse-length 4.2 --threshold 8e9
                   --relative-threshold 0.1 --ringing-time 30 --fit-background -o flight.xyz
  vtkhelios detect leg000_fullwave.pvtt -o - | head
  vtkhelios detect leg000_fullwave.txt --threshold 0.2 --returns last -o last.pvtp --pulse-length 3

exit codes: 0 done, 1 failed or no echoes at all, 2 wrong usage.
"""


def return_selections():
    """Returns the names of the returns to keep, and the methods that select them."""
    start = "SetReturnSelectionTo"
    methods = [name for name in dir(vtkhelios.vtkHeliosEchoDetection) if name.startswith(start)]
    names = [method.removeprefix(start) for method in methods]
    return {name[0].lower() + name[1:]: method for name, method in zip(names, methods)}


def output_name(text):
    """Returns an argparse type: a file whose ending selects its format."""
    if pathlib.Path(text).suffix not in (".xyz", ".pvtp") and not is_standard(text):
        raise argparse.ArgumentTypeError(
            f"{text!r} is not valid: expected a name that ends in .xyz (text) or .pvtp (VTK), or -"
        )
    return text


def add_arguments(parser):
    parser.epilog = EPILOG
    parser.add_argument(
        "waveforms", metavar="FULLWAVE", help="the waveforms: .pvtt, .vtt, .las, .pls or text"
    )
    parser.add_argument(
        "-o",
        "--output",
        metavar="FILE",
        type=output_name,
        required=True,
        help="the echoes: .xyz, text columns, or .pvtp, VTK XML; an existing file is replaced; - is "
        "standard output, as text",
    )
    parser.add_argument(
        "--detector",
        metavar="NAME",
        choices=detectors(),
        default="peak",
        help="peak, gaussian, cfd, leadingEdge, photonCounting, or one of a plug-in (default: %(default)s)",
    )
    parser.add_argument(
        "--pulse-length",
        metavar="NS",
        type=number(1e-3, 1e6),
        default=0.0,
        help="emitted pulse, full width at half maximum [ns] "
        "(default: that of the .pvtt; text, LAS and PulseWaves do not store it)",
    )
    parser.add_argument(
        "--threshold",
        metavar="NW",
        type=number(0, 1e15),
        default=1e-4,
        help="the minimum amplitude of an echo [nW] (default: %(default)s)",
    )
    parser.add_argument(
        "--relative-threshold",
        metavar="F",
        type=number(0, 1),
        default=0.0,
        help="gaussian: maxima below this fraction of the largest sample of a waveform are no "
        "echoes; receivers ring after strong echoes (default: %(default)s)",
    )
    parser.add_argument(
        "--ringing-time",
        metavar="NS",
        type=number(0, 1e6),
        default=0.0,
        help="gaussian: --relative-threshold applies to maxima up to this time after a stronger one, "
        "as a fraction of it [ns]; 0: to all of a waveform (default: %(default)s)",
    )
    parser.add_argument(
        "--fit-background",
        action="store_true",
        help="gaussian: fit a constant under the echoes, such as sunlight or a digitizer's zero",
    )
    parser.add_argument(
        "--returns",
        metavar="WHICH",
        choices=list(return_selections()),
        default="all",
        help="returns to keep per pulse: all, first, last, strongest or firstAndLast (default: "
        "%(default)s)",
    )
    parser.add_argument(
        "--max-returns",
        metavar="N",
        type=whole_number(vtkhelios.vtkHeliosEchoDetection().GetMaximumNumberOfReturnsMaxValue()),
        default=0,
        help="maximum number of these, the nearest first; 0: all (default: %(default)s)",
    )
    parser.add_argument(
        "--one-way",
        action="store_true",
        help="the times of a text file are one-way (HELIOS++)",
    )
    add_plugin_argument(parser)
    add_threads_argument(parser)
    parser.add_argument("--json", action="store_true", help="print the results as JSON")
    parser.add_argument("--quiet", action="store_true", help="print errors only")


def run(arguments):
    if arguments.detector != "gaussian" and (
        arguments.relative_threshold or arguments.fit_background
    ):
        print(
            "error: --relative-threshold and --fit-background need --detector gaussian: give it",
            file=sys.stderr,
        )
        return 2
    if not is_standard(arguments.output):
        return run_to_file(arguments)
    if arguments.json:
        print("error: -: standard output has the points; leave --json out", file=sys.stderr)
        return 2
    with folder_of_standard() as folder:
        arguments.output = str(folder / "standard-output.xyz")
        arguments.quiet = True
        code = run_to_file(arguments)
        return code if code or write_output(arguments.output) else 1


def run_to_file(arguments):
    """Writes the echoes to a file; returns the exit code."""
    with Messages(quiet=arguments.quiet, results=not arguments.json) as messages:
        vtkSMPTools.Initialize(arguments.threads or len(os.sched_getaffinity(0)))
        try:
            reader = make_waveform_reader(arguments.waveforms, arguments.one_way)
        except formats.FormatError as error:
            messages.error(str(error))
            return 1
        messages.watch(reader)
        pieces = count_pieces(reader, arguments.waveforms)
        detection = make_detection(arguments, reader)
        messages.watch(detection)
        name_options(messages)
        writer = make_writer(arguments.output)
        messages.watch(writer)
        set_outcome(f"{arguments.output} was not written")
        set_unfinished(part_name(arguments))
        if messages.errors or not writer.Open():
            return 1
        try:
            return detect(arguments, pieces, detection, writer, messages)
        except KeyboardInterrupt:
            give_up(arguments, writer)
            raise


def detect(arguments, pieces, detection, writer, messages):
    """Writes the echoes piece by piece; returns the exit code."""
    for piece in range(pieces):
        detection.UpdatePiece(piece, pieces, 0)
        if messages.errors:
            return give_up(arguments, writer)
        if not writer.Write(complete(detection.GetOutput())):
            writer.Abandon()  # its error says what is kept
            return 1
    return conclude(arguments, writer, messages)


def make_detection(arguments, reader):
    detector = vtkhelios.vtkHeliosEchoDetection.MakeDetector(arguments.detector)
    detector.SetDetectionThreshold(1e-9 * arguments.threshold)
    detection = vtkhelios.vtkHeliosEchoDetection()
    if arguments.detector == "gaussian":
        detector.SetRelativeThreshold(arguments.relative_threshold)
        detector.SetRingingTime(arguments.ringing_time)
        detector.SetFitBackground(arguments.fit_background)
    detection.SetInputConnection(reader.GetOutputPort(reader.GetNumberOfOutputPorts() - 1))
    detection.SetEchoDetector(detector)
    detection.SetPulseLength(arguments.pulse_length)
    getattr(detection, return_selections()[arguments.returns])()
    detection.SetMaximumNumberOfReturns(arguments.max_returns)
    return detection


def name_options(messages):
    """Errors of the filter name the options of the command, not the properties of the class."""
    write = messages.write_error
    messages.write_error = lambda text: write(
        text.replace("set the property PulseLength", "give --pulse-length")
    )


def make_writer(path):
    kind = "XML" if pathlib.Path(path).suffix == ".pvtp" else "Text"
    writer = getattr(vtkhelios, f"vtkHeliosPoint{kind}Writer")()
    writer.SetFileName(to_vtk(path))
    return writer


def complete(echoes):
    """Adds the echo columns that require a scene."""
    data = echoes.GetPointData()
    for name, value in ((PART_IDS, -1), (CLASSIFICATION_IDS, 0)):
        if not data.HasArray(name):
            values = numpy_to_vtk(np.full(echoes.GetNumberOfPoints(), value, np.int32), deep=True)
            values.SetName(name)
            data.AddArray(values)
    return echoes


def part_name(arguments):
    return f"{arguments.output}{PART}"


def give_up(arguments, writer):
    """Removes the incomplete output; returns the exit code."""
    if writer.IsOpen():
        writer.Abandon()
    pathlib.Path(part_name(arguments)).unlink(missing_ok=True)
    return 1


def conclude(arguments, writer, messages):
    count = writer.GetNumberOfRecords()
    if count == 0:
        messages.error(
            f"{arguments.waveforms}: no echo reaches {arguments.threshold:g} nW; "
            "give a lower --threshold"
        )
        return give_up(arguments, writer)
    if not writer.Close():
        return 1
    set_outcome(f"{arguments.output} is written")
    set_unfinished(part_name(arguments), False)
    messages.info(f"points   {count:,} by {arguments.detector} in {arguments.output}")
    if arguments.json:
        result = {"file": arguments.output, "points": count, "detector": arguments.detector}
        print(json.dumps(result, indent=2))
    return 0
