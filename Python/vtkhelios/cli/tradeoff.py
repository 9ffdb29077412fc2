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

from .._paths import text_from_vtk
from .._pipeline import PipelineError
from .._survey_text import with_sampling
from ..survey import Survey
from ..tradeoff import make_tradeoff
from ._files import cannot_be_written
from ._interrupt import Interrupt
from ._messages import Messages
from ._progress import duration, make_progress
from ._reading import add_assets_argument, add_memory_argument, limit_memory
from ._task import Interrupted, Watched
from ._tradeoff_report import make_picture, result_lines
from .plan import shown_warnings
from .run import read_survey, whole_number

SUMMARY = "measure accuracy against time on a survey, and what its scene requires of the model"

EPILOG = """\
what it does: draws pulses from all legs of the survey, computes them with 4096 sub-rays in fine
bins (the reference, whose own error is its difference from half as many), and then with
  fixed sub-rays       1, 7, 19 ... on circles (beamSampleQuality)
  tolerances           30 mm to 0.3 mm, with 10 times as many per cent of amplitude and echoes
  bins, detectors, ray casters
For each it prints the range error (median, 95th percentile with its 95 % confidence interval, RMS),
missed and invented echoes, errors of amplitude and echo width, and processor time per pulse. Values
below three times the error of the reference have a ~.
Then it leaves out each part of the model that a run can leave out: divergence, atmosphere, specular
lobe, turbid voxels; and adds the noise. The differences from the survey as it is show what matters
in this scene, and what it costs.
Noise and turbid voxels are left out of all comparisons with the reference.

recommendation:
  --range 5mm --missed 1%   the fastest setting with this 95th percentile of the range error and this
                            fraction of missed and invented echoes (upper ends of their intervals)
  --minutes 10              the most accurate setting with which the whole survey takes that long
  --apply out.xml           writes the survey with the recommended setting. Names of files in it stay
                            as they are: write it into the folder of the survey

what it writes, into OUTPUT/<name of the survey>/:
  tradeoff.json   everything; --json prints it
  tradeoff.csv    a line per way
  tradeoff.png    error against time (needs matplotlib: apt-get install python3-matplotlib)

examples:
  vtkhelios tradeoff survey.xml
  vtkhelios tradeoff survey.xml --range 5mm --missed 1%
  vtkhelios tradeoff survey.xml --minutes 10 --apply fast_survey.xml
  vtkhelios tradeoff survey.xml --pulses 500 --no-parts           quick

exit codes: 0 done, 1 failed, or no setting is as asked (the reason is on standard error),
2 wrong usage, 130 interrupted (nothing is written).
"""

UNITS = {"m": 1.0, "cm": 1e-2, "mm": 1e-3, "um": 1e-6}


def length(text):
    """An argparse type: a length such as 5mm."""
    found = re.fullmatch(r"([0-9.eE+-]+) ?(um|mm|cm|m)", text)
    with contextlib.suppress(ValueError):
        if found and 0 < float(found[1]) * UNITS[found[2]] <= 100:
            return float(found[1]) * UNITS[found[2]]
    raise argparse.ArgumentTypeError(f"{text!r} is not a length; give one such as 5mm or 2cm")


def fraction(text):
    """An argparse type: a fraction such as 1% or 0.01."""
    word = text.removesuffix("%")
    with contextlib.suppress(ValueError):
        value = float(word) / (100 if text.endswith("%") else 1)
        if 0 < value <= 1:
            return value
    raise argparse.ArgumentTypeError(f"{text!r} is not a fraction; give one such as 1% or 0.01")


def minutes(text):
    """An argparse type: a positive number of minutes."""
    with contextlib.suppress(ValueError):
        if 0 < float(text) < 1e6:
            return float(text)
    raise argparse.ArgumentTypeError(f"{text!r} is not a time; give a number of minutes above 0")


def add_arguments(parser):
    parser.epilog = EPILOG
    parser.add_argument("survey", metavar="SURVEY.xml", help="the survey (HELIOS XML)")
    add_assets_argument(parser)
    parser.add_argument(
        "--output",
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
        "--no-parts", action="store_true", help="do not leave out parts of the model"
    )
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
    parser.add_argument(
        "--threads",
        metavar="N",
        type=whole_number(4096),
        default=0,
        help="number of threads; 0: one per processor core (default: %(default)s)",
    )
    add_memory_argument(parser)
    parser.add_argument("--json", action="store_true", help="print all results as JSON")
    parser.add_argument("--quiet", action="store_true", help="print errors only")


class TradeoffWatch(Watched):
    """The current step as a player: what shows progress and what interrupts can watch it."""

    def __init__(self):
        super().__init__()
        self._name, self._share = "loading", 0.0

    def on_step(self, name, share):
        self._name, self._share = name, share
        self.report()

    def GetProgress(self):
        return self._share

    def GetMessage(self):
        return self._name


def run(arguments):
    wishes = arguments.range, arguments.missed
    if problem := find_contradiction(arguments, wishes):
        with Messages() as messages:
            messages.error(problem)
        return 2
    with Messages(quiet=arguments.quiet, results=not arguments.json) as messages:
        threads = arguments.threads or len(os.sched_getaffinity(0))
        vtkSMPTools.Initialize(threads)
        limit_memory(arguments)
        read = read_survey(arguments, messages)
        if read is None:
            return 1
        survey = Survey(read, arguments.survey)
        messages.info(f"survey   {survey.name} ({arguments.survey})")
        try:
            with shown_warnings(messages):
                result, signal = measure(survey, arguments, messages)
        except PipelineError as error:
            for text in error.messages:
                messages.error(text)
            return 1
        if signal:
            messages.error("interrupted before all ways were measured; nothing was written")
            return 128 + signal
        for line in result_lines(result, threads):
            messages.info(line)
        if arguments.json:
            print(result.to_json())
        folder = pathlib.Path(arguments.output) / text_from_vtk(read.GetName())
        good = write(result, folder, messages)
        return recommend(result, arguments, wishes, threads, messages) if good else 1


def find_contradiction(arguments, wishes):
    """What is wrong with the options, or None."""
    asks = any(wish is not None for wish in wishes)
    if asks and arguments.minutes is not None:
        return (
            "--minutes asks for the most accurate setting, and --range and --missed for the "
            "fastest: give one of them"
        )
    if arguments.apply and not asks and arguments.minutes is None:
        return "--apply needs a recommendation: give --range, --missed or --minutes"
    return None


def measure(survey, arguments, messages):
    """The result, and the signal that ended it or 0."""
    watch, result = TradeoffWatch(), None
    with Interrupt(watch, messages) as interrupt, contextlib.suppress(Interrupted):
        with make_progress(watch, messages, quiet=arguments.quiet):
            result = make_tradeoff(survey, arguments.pulses, not arguments.no_parts, watch.on_step)
    return result, interrupt.signal


def write(result, folder, messages):
    """Writes the files; whether that succeeded."""
    files = {
        "tradeoff.json": result.to_json().encode(),
        "tradeoff.csv": result.table.to_csv().encode(),
    }
    try:
        files["tradeoff.png"] = make_picture(result)
    except ImportError:
        messages.warning(
            "no tradeoff.png: matplotlib is missing; apt-get install python3-matplotlib"
        )
    try:
        folder.mkdir(parents=True, exist_ok=True)
        for name, content in files.items():
            (folder / name).write_bytes(content)
    except OSError as error:
        messages.error(cannot_be_written(error, folder, "--output"))
        return False
    messages.info("")
    for index, name in enumerate(files):
        messages.info(f"{'' if index else 'files':8} {folder / name}")
    return True


def recommend(result, arguments, wishes, threads, messages):
    """Prints, and applies, what was asked for; returns an exit code."""
    if arguments.minutes is not None:
        row = result.most_accurate(60 * arguments.minutes, threads)
        if row is None:
            fastest = min(result.frontier, key=lambda row: row.seconds)
            messages.error(
                f"--minutes {arguments.minutes:g}: no setting is that fast; {fastest.name} takes "
                f"{duration(result.run_time(fastest, threads))}: give more time or threads"
            )
    elif any(wish is not None for wish in wishes):
        row = result.cheapest(*wishes)
        if row is None:
            best = result.frontier[-1]
            messages.error(
                f"no setting is as accurate as asked; {best.name} has a range error of at most "
                f"{1e3 * best.range_error:.2g} mm and at most {100 * best.lost:.2g} % missed and "
                "invented echoes: ask for less, or narrow the intervals with more --pulses"
            )
    else:
        return 0
    if row is None:
        return 1
    messages.info(
        f"recommended: {row.name}, at most {1e3 * row.range_error:.2g} mm and "
        f"{100 * row.lost:.2g} % missed and invented echoes, about "
        f"{duration(result.run_time(row, threads))}"
    )
    return apply(row, arguments, messages) if arguments.apply else 0


def apply(row, arguments, messages):
    """Writes the survey with the settings of a way; returns an exit code."""
    source, target = pathlib.Path(arguments.survey), pathlib.Path(arguments.apply)
    options = row.options
    settings = {name: options.get(name) for name in ("tolerance", "energy_tolerance")}
    try:
        data = source.read_bytes()
        if options:
            circles = circles_of(options["sub_rays"]) if "sub_rays" in options else None
            data = with_sampling(data, circles=circles, **settings)
        target.write_bytes(data)
    except OSError as error:
        messages.error(cannot_be_written(error, target, "--apply"))
        return 1
    except ValueError as error:
        messages.error(f"{source}: {error}")
        return 1
    messages.info(f"written  {target}")
    return 0


def circles_of(sub_rays):
    """The number of circles with this many sub-rays."""
    sampler = vtkhelios.vtkHeliosBeamSampler()
    sampler.SetPatternToCircles()
    for circles in range(1, 65):
        sampler.SetNumberOfCircles(circles)
        if sampler.GetNumberOfSubRays() == sub_rays:
            return circles
    raise ValueError(f"{sub_rays} sub-rays are no circles")
