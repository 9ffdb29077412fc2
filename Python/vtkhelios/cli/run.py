# SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
# SPDX-License-Identifier: BSD-3-Clause
"""vtkhelios run: runs a survey and writes the echoes."""

import argparse
import os
import pathlib
import sys
import time

from vtkmodules.vtkCommonCore import vtkSMPTools

import vtkhelios

from ._interrupt import Interrupt
from ._messages import Messages
from ._progress import make_progress

SUMMARY = "run a survey: write the point cloud and the trajectory of every leg"

EPILOG = """\
what it writes, below OUTPUT/<name of the survey>/, for every active leg:
  legNNN_points.xyz       one echo a line: x y z [m], intensity [nW], echo width [ns],
                          return number, number of returns, pulse, object, class, GPS time [s]
  legNNN_trajectory.txt   x y z [m], GPS time [s], roll pitch yaw [deg]
  legNNN_fullwave.txt     the waveforms, with --waveforms: one pulse a line, pulse, origin x y z,
                          direction x y z, first and last time [ns, two-way], GPS time [s],
                          samples [nW]
With --format vtp: legNNN_points.pvtp and legNNN_fullwave.pvtt, with their pieces beside them.
While a run writes, files end in .part; they hold whole lines at any moment.

how the beam is sampled:
  A survey that gives beamSampleQuality has that many circles of sub-rays, always. Without it
  the run takes as few rays as the tolerances allow (1 mm in range, 1 % in amplitude, as root
  mean squares): few where a beam meets one surface, more where it meets edges, and bins only
  where echoes overlap. Leaves between all rays of a beam are not seen. --range-tolerance and
  --energy-tolerance, or --sub-rays, win over the survey. The end of a run says what it came to.
  Docs/instrument.md has the whole of it.

where files are looked up: absolute names as they are; then every --assets folder in
order, the folder of the survey, the working directory, what comes with vtkHelios.

examples:
  vtkhelios run survey.xml
  vtkhelios run survey.xml --assets scenes --assets my_scanners --output clouds
  vtkhelios run survey.xml --no-noise --seed 7 --threads 4 --overwrite
  vtkhelios run survey.xml --format vtp --waveforms      for ParaView and PyVista
  vtkhelios run survey.xml --range-tolerance 0.0002      a surface scanner: 0.2 mm
  vtkhelios run survey.xml --sub-rays 19 --detector gaussian

exit codes: 0 done, 1 failed or no points at all (the reason is on standard error),
2 wrong usage, 130 interrupted (Ctrl-C: what was written stays and is valid).
"""


def whole_number(highest):
    """An argparse type: an integer from 0 to highest."""

    def parse(text):
        if not text.isascii() or not text.isdigit() or int(text) > highest:
            raise argparse.ArgumentTypeError(f"{text!r} is not a whole number from 0 to {highest}")
        return int(text)

    return parse


def number(lowest, highest):
    """An argparse type: a number from lowest to highest."""

    def parse(text):
        try:
            value = float(text)
        except ValueError:
            value = float("nan")
        if not lowest <= value <= highest:
            raise argparse.ArgumentTypeError(
                f"{text!r} is not a number from {lowest:g} to {highest:g}"
            )
        return value

    return parse


DETECTORS = ["peak", "gaussian", "cfd", "leadingEdge"]


def ray_casters():
    """The names of the ray casters in this build, the default one first."""
    caster = vtkhelios.vtkHeliosRayCaster
    return [caster.GetBackendName(index) for index in range(caster.GetNumberOfBackends())]


def add_arguments(parser):
    parser.epilog = EPILOG
    parser.add_argument("survey", metavar="SURVEY.xml", help="the survey (HELIOS XML)")
    parser.add_argument(
        "--assets",
        metavar="DIR",
        action="append",
        default=[],
        help="a folder to look up scenes, scanners and platforms in; may be repeated",
    )
    parser.add_argument(
        "--output",
        metavar="DIR",
        default="output",
        help="where the files go (default: %(default)s)",
    )
    parser.add_argument(
        "--overwrite",
        action="store_true",
        help="replace the files of an earlier run; without it they are kept and the run refused",
    )
    parser.add_argument(
        "--format",
        choices=["xyz", "vtp"],
        default="xyz",
        help="text columns, or VTK XML (default: %(default)s)",
    )
    parser.add_argument(
        "--waveforms", action="store_true", help="write the waveforms, too (as text, or as VTK XML)"
    )
    add_sampling_arguments(parser)
    parser.add_argument(
        "--seed",
        metavar="N",
        type=whole_number(2**62),
        default=0,
        help="the key of all random numbers: the same seed gives the same bytes, "
        "for any number of threads (default: %(default)s)",
    )
    parser.add_argument(
        "--no-noise", action="store_true", help="ranges without the scanner's noise"
    )
    parser.add_argument(
        "--threads",
        metavar="N",
        type=whole_number(4096),
        default=0,
        help="how many processor cores to use; 0: all (default: %(default)s)",
    )
    parser.add_argument(
        "--ray-caster",
        metavar="NAME",
        choices=ray_casters(),
        help="how rays are cast: %(choices)s (default: the survey's rayCaster, else the first); "
        "the points are the same (obbtree: nearly); Docs/ray-casters.md says what each costs",
    )
    parser.add_argument("--quiet", action="store_true", help="print errors only")


def add_sampling_arguments(parser):
    parser.add_argument(
        "--range-tolerance",
        metavar="M",
        type=number(1e-6, 1),
        default=0.0,
        help="sample the beam so that ranges are within this many metres "
        "(default: the survey's, else 0.001)",
    )
    parser.add_argument(
        "--energy-tolerance",
        metavar="F",
        type=number(1e-4, 1),
        default=0.0,
        help="and amplitudes within this share (default: the survey's, else 0.01)",
    )
    parser.add_argument(
        "--sub-rays",
        metavar="N",
        type=whole_number(65536),
        default=0,
        help="or always with this many sub-rays: 1, 7, 19, 37, 62 ... on circles, "
        "as beamSampleQuality has them, other numbers on a spiral",
    )
    parser.add_argument(
        "--detector",
        metavar="NAME",
        choices=DETECTORS,
        help="what makes echoes of waveforms: peak (log-parabola), gaussian (decomposition), "
        "cfd (constant fraction), leadingEdge (default: the survey's, else peak)",
    )


def run(arguments):
    if arguments.sub_rays and (arguments.range_tolerance or arguments.energy_tolerance):
        print(
            "error: --sub-rays is always that many, and a tolerance chooses how many: "
            "give one of them",
            file=sys.stderr,
        )
        return 2
    with Messages(quiet=arguments.quiet) as messages:
        vtkSMPTools.Initialize(arguments.threads or len(os.sched_getaffinity(0)))
        survey = read_survey(arguments, messages)
        if survey is None:
            return 1
        player = make_player(arguments, survey, messages)
        progress = make_progress(player, messages, quiet=arguments.quiet)
        with progress, Interrupt(player, messages) as interrupt:
            start = time.monotonic()
            succeeded = player.Run()
            seconds = time.monotonic() - start
        return conclude(arguments, player, messages, succeeded, interrupt, seconds)


def asset_directories(arguments):
    """The user's folders, then what comes with vtkHelios."""
    shipped = vtkhelios.data_directory()
    beside = str(pathlib.Path(arguments.survey).parent)
    return list(dict.fromkeys([*arguments.assets, beside, ".", f"{shipped}", f"{shipped}/Assets"]))


def read_survey(arguments, messages):
    """The survey, or None after an error."""
    for folder in arguments.assets:
        if not pathlib.Path(folder).is_dir():
            messages.error(f"--assets {folder}: no such folder")
            return None
    reader = vtkhelios.vtkHeliosSurveyReader()
    messages.watch(reader)
    reader.SetFileName(arguments.survey)
    for folder in asset_directories(arguments):
        reader.AddAssetDirectory(folder)
    if not reader.Read():
        messages.error_unless_told(f"{arguments.survey}: cannot be read")
        return None
    return reader.GetSurvey()


def make_player(arguments, survey, messages):
    player = vtkhelios.vtkHeliosSurveyPlayer()
    messages.watch(player)
    player.SetSurvey(survey)
    player.SetOutputDirectory(arguments.output)
    player.SetOverwrite(arguments.overwrite)
    player.SetFormat(arguments.format)
    player.SetWriteWaveforms(arguments.waveforms)
    player.SetRangeTolerance(arguments.range_tolerance)
    player.SetEnergyTolerance(arguments.energy_tolerance)
    player.SetNumberOfSubRays(arguments.sub_rays)
    player.SetEchoDetector(arguments.detector)
    player.SetSeed(arguments.seed)
    player.SetNoise(not arguments.no_noise)
    player.SetRayCaster(arguments.ray_caster)
    messages.info(
        f"survey   {survey.GetName()} ({arguments.survey}), seed {arguments.seed}"
        f"{', without noise' if arguments.no_noise else ''}"
    )
    return player


def conclude(arguments, player, messages, succeeded, interrupt, seconds):
    """Says how the run ended and returns the exit code."""
    folder = pathlib.Path(arguments.output) / player.GetSurvey().GetName()
    if interrupt.signal and not succeeded:
        points = player.GetNumberOfEchoes()
        kept = f"the {points:,} points so far are kept in {folder}" if points else "no points yet"
        messages.error(f"interrupted at {100 * player.GetProgress():.0f} %: {kept}")
        return 128 + interrupt.signal
    if not succeeded:
        messages.error_unless_told(player.GetMessage())
        return 1
    summarise(player, folder, messages, seconds)
    return 0


def summarise(player, folder, messages, seconds):
    pulses, points = player.GetNumberOfPulsesFired(), player.GetNumberOfEchoes()
    threads = vtkSMPTools.GetEstimatedNumberOfThreads()
    messages.info(f"sub-rays {player.GetSampling()}")
    messages.info(f"pulses   {pulses:,}: {describe_paths(player)}")
    messages.info(f"points   {points:,} ({player.GetNumberOfFirstReturns():,} first returns)")
    messages.info(
        f"time     {seconds:.2f} s with {threads} thread{'s'[:threads != 1]}: "
        f"{pulses / seconds / 1e6:.2f} M pulses/s, {points / seconds / 1e6:.2f} M points/s"
    )
    files = sorted(path for path in folder.iterdir() if path.is_file())
    for index, path in enumerate(files[:MAXIMUM_FILES]):
        messages.info(
            f"{'files   ' if index == 0 else '        '} {path} ({readable(path.stat().st_size)})"
        )
    if len(files) > MAXIMUM_FILES:
        messages.info(f"         and {len(files) - MAXIMUM_FILES} more in {folder}")


def describe_paths(player):
    """Which way the pulses went, and what they cost."""
    pulses = max(1, player.GetNumberOfPulsesFired())
    ways = {
        "on one plane": player.GetNumberOfPulsesOnPlane(),
        "without bins": player.GetNumberOfPulsesWithoutBins(),
        "binned": player.GetNumberOfPulsesBinned(),
    }
    ways["met nothing"] = pulses - sum(ways.values())
    said = ", ".join(f"{count:,} {way}" for way, count in ways.items() if count > 0)
    return f"{said}; {player.GetNumberOfSubRaysTraced() / pulses:.1f} rays a pulse"


MAXIMUM_FILES = 12


def readable(size):
    """A number of bytes for people: 1.2 MB."""
    for unit in ("B", "kB", "MB", "GB"):
        if size < 1000:
            return f"{size:.0f} {unit}" if unit == "B" else f"{size:.1f} {unit}"
        size /= 1000
    return f"{size:.1f} TB"
