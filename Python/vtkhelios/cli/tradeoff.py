# SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
# SPDX-License-Identifier: BSD-3-Clause
"""vtkhelios tradeoff: what accuracy costs on a survey, and what its scene requires."""

import argparse
import contextlib
import os
import pathlib
import re

from vtkmodules.vtkCommonCore import vtkSMPTools

import vtkhelios

from ..core.files import cannot_be_written, write_files
from ..core.words import duration
from ..plans.document import PLATFORM, SCANNER
from ..plans.settings import SettingError
from ..reports.tradeoff import megabytes, result_lines
from ..reports.tradeoff_pictures import make_parts_picture, make_picture
from ..surveys.items import change
from ..surveys.options import OPTIONS
from ..surveys.tradeoff_run import make_tradeoff
from ._messages import Messages, shown_problems
from ._parser import number, whole_number
from ._plan_options import option_of, value_of
from ._progress import make_progress
from ._reading import add_assets_argument, add_memory_argument, add_threads_argument, limit_memory
from ._stopping import set_outcome
from ._task import StepWatch
from ._tradeoff.input import open_input

SUMMARY = "measure accuracy against time on a survey, and what its scene requires of the model"

EPILOG = """\
input: a survey; or a scene (HELIOS XML) or a mesh (.obj, .tif, .ply, .stl, .gltf, .glb, .json: CityJSON),
which is scanned from the positions that vtkhelios plan finds with the same options.

what it does: draws pulses from all legs of the survey, computes them by adaptive sampling within
0.03 mm (the reference: its own error is at most its difference from 0.1 mm, and some pulses are
checked with 32,768 sub-rays), and then with
  fixed sub-rays       1, 7, 19 ... on circles (beamSampleQuality); other patterns: Vogel's spiral and
                       rings with the nodes of Gauss and Legendre
  tolerances           30 mm to 0.3 mm, with 10 times as many per cent of amplitude and echoes, and
                       a tenth of the range noise of the scanner
  bins, detectors, ray casters
  simplified meshes    within 10 and 50 mm, with CGAL, if that takes at most 10 s
For each it prints the range error (median, 95th percentile with its 95 % confidence interval, RMS),
missed and invented echoes, errors of amplitude and echo width, processor time per pulse, and the
memory of scene and ray caster. Values below three times the error of the reference have a ~.

Then it leaves out each part of the model:
  divergence    all beams are one ray
  waveform      a pulse has one echo, the mean of its returns
  specular      surfaces are Lambertian
  spectra       materials with a spectrum have the reflectance 0.5
  atmosphere    no extinction
  voxels        turbid voxels are air
  motion        the platform stands still during a scan line
  attitude      it has the orientation of the last sample of its trajectory
  scattering    light is scattered once; of surveys that have one order, three are added
  partMotion    parts of the scene stand where they are at the start
and adds the noise; and it leaves out, and simplifies, each of the six largest parts of the scene. The
differences from the survey as it is show what matters in this scene, and what it costs; a verdict says it
in words: what changes by more than 1 mm or 1 %, and the time that it takes.
Noise and turbid voxels are left out of all comparisons with the reference.

time: three times that of the run, and at least 10 s of processor time; --seconds gives more. Settings are
measured first, on fewer pulses if needed (their intervals are then wider); what does not fit is named.

recommendation:
  --range 5mm --missed 1%   the fastest setting with this 95th percentile of the range error and this
                            fraction of missed and invented echoes (upper ends of their intervals)
  --minutes 10              the most accurate setting with which the whole survey takes that long
  --memory 2GB              of those whose run needs no more; alone the most accurate of them. It also
                            limits this process, as in vtkhelios run: the scene has to fit
  --apply out.xml           writes the survey with the recommended setting. Names of files in it stay
                            as they are: write it into the folder of the survey

what it writes, into OUTPUT/<name of the survey>/:
  tradeoff.json         everything; --json prints it
  tradeoff.csv          a line per way
  tradeoff_parts.csv    a line per part of the model and of the scene
  tradeoff.png          error against time (needs matplotlib: apt-get install python3-matplotlib)
  tradeoff_parts.png    what each part changes and costs

examples:
  vtkhelios tradeoff survey.xml
  vtkhelios tradeoff survey.xml --range 5mm --missed 1%
  vtkhelios tradeoff survey.xml --minutes 10 --apply fast_survey.xml
  vtkhelios tradeoff survey.xml --pulses 500 --no-parts           quick
  vtkhelios tradeoff survey.xml --seconds 300                     all ways, parts and ray casters
  vtkhelios tradeoff survey.xml --accuracy instrument             of a run within a tenth of the noise
  vtkhelios tradeoff yard.obj --scanner scanners.xml#riegl_vz400

exit codes: 0 done, 1 failed, or no setting is as asked (the reason is on standard error),
2 wrong usage, 130 interrupted (nothing is written).
"""

UNITS = {"m": 1.0, "cm": 1e-2, "mm": 1e-3, "um": 1e-6}


def length(text):
    """Returns an argparse type: a length such as 5mm."""
    found = re.fullmatch(r"([0-9.eE+-]+) ?(um|mm|cm|m)", text)
    with contextlib.suppress(ValueError):
        if found and 0 < float(found[1]) * UNITS[found[2]] <= 100:
            return float(found[1]) * UNITS[found[2]]
    raise argparse.ArgumentTypeError(f"{text!r} is not a length; give one such as 5mm or 2cm")


def fraction(text):
    """Returns an argparse type: a fraction such as 1% or 0.01."""
    word = text.removesuffix("%")
    with contextlib.suppress(ValueError):
        value = float(word) / (100 if text.endswith("%") else 1)
        if 0 < value <= 1:
            return value
    raise argparse.ArgumentTypeError(f"{text!r} is not a fraction; give one such as 1% or 0.01")


def minutes(text):
    """Returns an argparse type: a positive number of minutes."""
    with contextlib.suppress(ValueError):
        if 0 < float(text) < 1e6:
            return float(text)
    raise argparse.ArgumentTypeError(f"{text!r} is not a time; give a number of minutes above 0")


def add_arguments(parser):
    parser.epilog = EPILOG
    parser.add_argument(
        "survey",
        metavar="FILE",
        help="a survey or scene (HELIOS XML), or a mesh (.obj, .tif, .ply, .stl, glTF, CityJSON)",
    )
    add_assets_argument(parser)
    parser.add_argument(
        "--output",
        "-o",
        metavar="DIR",
        default=vtkhelios.vtkHeliosSurveyPlayer().GetOutputDirectory(),
        help="where the files go; existing ones are replaced (default: %(default)s)",
    )
    parser.add_argument(
        "--pulses",
        metavar="N",
        type=whole_number(1_000_000, lowest=10),
        default=2000,
        help="pulses with an echo in the sample: more make narrower intervals (default: "
        "%(default)s)",
    )
    parser.add_argument(
        "--no-parts",
        action="store_true",
        help="do not leave out parts of the model and of the scene",
    )
    parser.add_argument(
        "--seconds",
        metavar="N",
        type=number(0, 1e9),
        help="processor time for all of it: what does not fit is not measured, and named (default: three times that "
        "of the run, and at least 10)",
    )
    add_accuracy_argument(parser)
    add_plan_arguments(parser.add_argument_group("the survey of a scene or a mesh, as in plan"))
    parser.add_argument(
        "--range", metavar="LENGTH", type=length, help="recommend: 95 %% of the ranges within 5mm"
    )
    parser.add_argument(
        "--missed",
        metavar="PART",
        type=fraction,
        help="recommend: at most this fraction of the echoes missed or invented, such as 1%%",
    )
    parser.add_argument(
        "--minutes", metavar="N", type=minutes, help="recommend: the whole survey in this time"
    )
    parser.add_argument(
        "--apply", metavar="FILE.xml", help="write the survey with the recommended setting"
    )
    add_threads_argument(parser)
    add_memory_argument(parser, "recommend: only settings whose run needs no more; ")
    parser.add_argument("--json", action="store_true", help="print all results as JSON")
    parser.add_argument("--quiet", action="store_true", help="print errors only")


def add_accuracy_argument(parser):
    """Adds the option of vtkhelios run."""
    option = next(option for option in OPTIONS if option.name == "accuracy")
    parser.add_argument(
        option.argument, metavar=option.metavar, choices=option.get_choices(), help=option.help
    )


def add_plan_arguments(group):
    group.add_argument(
        "--scanner", metavar="REF", help=f"file.xml#id (default: the file's, else {SCANNER})"
    )
    group.add_argument(
        "--platform", metavar="REF", help=f"file.xml#id (default: the file's, else {PLATFORM})"
    )
    group.add_argument(
        "--resolution",
        metavar="DEG",
        type=value_of("resolution"),
        help="angle between pulses and between lines (default: the file's, else 0.1)",
    )
    group.add_argument(
        "--grid",
        metavar="M",
        type=value_of("grid"),
        help="spacing of possible scan positions (default: a twentieth of the scene's diagonal)",
    )


def run(arguments):
    if problem := find_contradiction(arguments):
        with Messages() as messages:
            messages.error(problem)
        return 2
    with Messages(quiet=arguments.quiet, results=not arguments.json) as messages:
        vtkSMPTools.Initialize(count_threads(arguments))
        limit_memory(arguments)
        try:
            with shown_problems(messages):
                return make_and_report(arguments, messages)
        except SettingError as error:
            messages.error(error.format(option_of))
        return 1


def make_and_report(arguments, messages):
    """Measures, prints, writes and recommends; returns an exit code."""
    found = open_input(arguments, messages)
    if found is None:
        return 1
    set_outcome(" before all ways were measured; nothing was written")
    result = measure(found, arguments, messages)
    set_outcome("files with their final names are complete")
    for line in result_lines(result, count_threads(arguments)):
        messages.info(line)
    if arguments.json:
        print(result.to_json())
    good = write(result, pathlib.Path(arguments.output) / found.name, messages)
    return recommend(result, found, arguments, messages) if good else 1


def count_threads(arguments):
    return arguments.threads or len(os.sched_getaffinity(0))


def asks_for_accuracy(arguments):
    return arguments.range is not None or arguments.missed is not None


def find_contradiction(arguments):
    """Returns the contradiction in the options, or None."""
    asks = asks_for_accuracy(arguments)
    if asks and arguments.minutes is not None:
        return (
            "--minutes asks for the most accurate setting, and --range and --missed for the "
            "fastest: give one of them"
        )
    if arguments.apply and not (asks or arguments.minutes is not None or arguments.memory):
        return "--apply needs a recommendation: give --range, --missed, --minutes or --memory"
    return None


def measure(found, arguments, messages):
    watch = StepWatch()
    with make_progress(watch, messages, quiet=arguments.quiet):
        found.prepare(watch)
        messages.info(found.describe())
        return make_tradeoff(
            found.survey,
            arguments.pulses,
            not arguments.no_parts,
            watch.on_step,
            arguments.seconds,
            accuracy=arguments.accuracy,
        )


def write(result, folder, messages):
    """Writes the files; whether that succeeded."""
    files = {"tradeoff.json": result.to_json(), "tradeoff.csv": result.table.to_csv()}
    if result.parts:
        files["tradeoff_parts.csv"] = result.parts_table.to_csv()
    try:
        folder.mkdir(parents=True, exist_ok=True)
        write_files(folder, files)
        pictures = draw(result, messages)
        write_files(folder, pictures)
    except OSError as error:
        messages.error(cannot_be_written(error, folder, "--output"))
        return False
    messages.info("")
    for index, name in enumerate([*files, *pictures]):
        messages.info(f"{'' if index else 'files':8} {folder / name}")
    return True


def draw(result, messages):
    """Returns the pictures, by name; none without matplotlib."""
    try:
        pictures = {"tradeoff.png": make_picture(result)}
        if result.parts:
            pictures["tradeoff_parts.png"] = make_parts_picture(result)
    except ImportError as error:
        messages.warning(f"no tradeoff.png: {error}")
        return {}
    return pictures


def recommend(result, found, arguments, messages):
    """Prints, and applies, what was asked for; returns an exit code."""
    threads, memory = count_threads(arguments), arguments.memory or None
    if asks_for_accuracy(arguments):
        row = result.cheapest(arguments.range, arguments.missed, memory)
    elif arguments.minutes is not None or memory:
        seconds = None if arguments.minutes is None else 60 * arguments.minutes
        row = result.most_accurate(seconds, threads, memory)
    else:
        return 0
    if row is None:
        messages.error(explain_none(result, arguments, threads))
        return 1
    messages.info(
        f"recommended: {row.name}, at most {1e3 * row.range_error:.2g} mm and "
        f"{100 * row.lost:.2g} % missed and invented echoes, about "
        f"{duration(result.run_time(row, threads))} and {megabytes(result.run_memory(row))} MB"
    )
    return apply(row, found, arguments, messages) if arguments.apply else 0


def explain_none(result, arguments, threads):
    """Why no setting is as asked, and what helps."""
    if arguments.memory and not result.has_setting(arguments.memory):
        least = result.smallest
        return (
            f"--memory {megabytes(arguments.memory)} MB: no setting needs so little; {least.name} needs about "
            f"{megabytes(result.run_memory(least))} MB: give more, or simplify the scene"
        )
    within = " in this memory" if arguments.memory else ""
    if arguments.minutes is not None:
        fastest = result.fastest
        return (
            f"--minutes {arguments.minutes:g}: no setting is that fast{within}; {fastest.name} takes "
            f"{duration(result.run_time(fastest, threads))}: give more time or threads"
        )
    if untold := find_untold(result, arguments):
        return untold
    best = result.frontier[-1]
    return (
        f"no setting is as accurate as asked{within}; {best.name} has a range error of at most "
        f"{1e3 * best.range_error:.2g} mm and at most {100 * best.lost:.2g} % missed and "
        "invented echoes: ask for less, or narrow the intervals with more --pulses"
    )


def find_untold(result, arguments):
    """Why the reference cannot tell whether a setting is as accurate as asked, or None."""
    own_range, own_lost = result.limits
    if arguments.range is not None and arguments.range < own_range:
        return (
            f"--range {1e3 * arguments.range:g} mm: the error of ranges cannot be told to better than "
            f"{1e3 * own_range:.2g} mm here, the error of the reference: give a larger length"
        )
    if arguments.missed is not None and arguments.missed < own_lost:
        return (
            f"--missed {100 * arguments.missed:g} %: missed and invented echoes cannot be told to better "
            f"than {100 * own_lost:.2g} % here, the error of the reference: give a larger fraction"
        )
    return None


def apply(row, found, arguments, messages):
    """Writes the survey with the settings of a way; returns an exit code."""
    target = pathlib.Path(arguments.apply)
    try:
        survey = found.make_survey(target)
        set_options(survey, row.options)
        survey.write(target)
    except OSError as error:
        messages.error(cannot_be_written(error, target, "--apply"))
        return 1
    messages.info(f"written  {target}")
    return 0


def set_options(survey, options):
    """Sets the options of a way as attributes of a Survey; an empty text removes one."""
    if "ray_caster" in options:
        values = {"rayCaster": options["ray_caster"]}
    elif options:
        circles = circles_of(options["sub_rays"]) if "sub_rays" in options else ""
        values = {
            "FWFSettings/beamSampleQuality": circles,
            "rangeTolerance_m": options.get("tolerance", ""),
            "energyTolerance": options.get("energy_tolerance", ""),
        }
    else:
        values = {}
    for path, value in values.items():
        change(survey.vtk, "SetSurveyAttribute", path, str(value))


def circles_of(sub_rays):
    """Returns the number of circles with this many sub-rays."""
    sampler = vtkhelios.vtkHeliosBeamSampler
    return sampler.FindPatternSize(sampler.CIRCLES, sub_rays)
