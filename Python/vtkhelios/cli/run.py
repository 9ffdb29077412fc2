# SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
# SPDX-License-Identifier: BSD-3-Clause
"""vtkhelios run: runs a survey and writes the echoes."""

import json
import os
import pathlib
import signal

from vtkmodules.vtkCommonCore import vtkSMPTools

from ..core.paths import from_vtk, text_from_vtk, to_vtk
from ..core.reading import make_reader, missing_folder
from ..core.run_files import FORMATS, JOURNAL_NAME, SUMMARY_NAME
from ..core.words import counted

from ..reports.run import (
    epochs_lines, estimate_lines, forecast_line, join_reports, summary_lines,
)  # fmt: skip
from ..vtkHeliosFiltersCore import vtkHeliosGpsTime
from ..vtkHeliosScannerRun import vtkHeliosRunOptions, vtkHeliosSurveyPlayer
from ._messages import Messages, say_error
from ._parser import part_of_run, whole_number
from ._progress import make_progress
from ._reading import add_assets_argument, add_memory_argument, add_threads_argument, limit_memory
from ._run.help import EPILOG
from ._run.options import add_option_arguments, set_options
from ._run.outputs import add_output_arguments, find_fault, set_outputs
from ._run.ranks import NoMpi, count_threads, start_ranks
from ._stopping import ESTIMATE, RUN, StopRequest, report_stop, run_player, set_outcome

SUMMARY = "run a survey: write the point cloud and the trajectory of every leg"


def detectors():
    """Returns the names of the echo detectors, the default one first."""
    return vtkHeliosRunOptions.GetEchoDetectorNames().split()


def add_arguments(parser):
    parser.epilog = EPILOG
    player = vtkHeliosSurveyPlayer()
    parser.add_argument("survey", metavar="SURVEY.xml", help="the survey (HELIOS XML, or YAML)")
    add_assets_argument(parser)
    parser.add_argument(
        "--output",
        "-o",
        metavar="DIR",
        default=player.GetOutputDirectory(),
        help="where the files go (default: %(default)s)",
    )
    add_earlier_run_arguments(parser)
    parser.add_argument(
        "--dry-run",
        action="store_true",
        help="estimate time, memory, points and bytes of the run from samples; write nothing",
    )
    parser.add_argument(
        "--epoch",
        metavar="N",
        type=whole_number(2**31 - 1),
        help="run only this epoch of a survey whose scene swaps parts; 0 is the first (default: "
        "all)",
    )
    parser.add_argument(
        "--part",
        metavar="K/N",
        type=part_of_run,
        help="run part K of N parts of the pulses, for vtkhelios join (default: the whole run)",
    )
    parser.add_argument(
        "--format",
        choices=FORMATS,
        default=player.GetFormat(),
        help="text columns, points as LAS 1.4, LAZ or COPC, or VTK XML (default: %(default)s)",
    )
    add_output_arguments(parser)
    add_option_arguments(parser)
    parser.add_argument(
        "--no-instances",
        action="store_true",
        help="copy the mesh of a file for each part that has it, instead of storing it once, and make "
        "meshes of height rasters",
    )
    add_threads_argument(parser)
    add_memory_argument(parser)
    parser.add_argument(
        "--pulses-per-block",
        metavar="N",
        type=whole_number(
            player.GetPulsesPerBlockMaxValue(), lowest=player.GetPulsesPerBlockMinValue()
        ),
        default=player.GetPulsesPerBlock(),
        help="pulses computed and written at a time: small blocks need less memory, and less is "
        "lost if a run is killed; large ones are faster; text, LAS and COPC are byte-identical, in laz "
        "a block is compressed by itself, in vtp it is a file (default: %(default)s)",
    )
    parser.add_argument(
        "--json",
        action="store_true",
        help="print the summary of the run, or the estimate of --dry-run, as JSON",
    )
    parser.add_argument("--quiet", action="store_true", help="print errors only")
    add_verbose_argument(parser)


def add_verbose_argument(parser):
    parser.add_argument(
        "--verbose",
        action="store_true",
        help="also print versions, how the pulses were sampled, and the accuracy in detail",
    )


def add_earlier_run_arguments(parser):
    group = parser.add_mutually_exclusive_group()
    group.add_argument(
        "--overwrite",
        action="store_true",
        help="replace the files of an earlier run (default: keep them and refuse to run)",
    )
    group.add_argument(
        "--resume",
        action="store_true",
        help="continue an earlier run that was killed, interrupted or failed",
    )
    parser.add_argument(
        "--check-all",
        action="store_true",
        help="with --resume: first compare all written bytes with their checksums, not only the "
        "last blocks (1 GiB)",
    )


def contradiction(arguments):
    """Which arguments exclude each other, or are not valid; or None."""
    if arguments.gps_start and (fault := vtkHeliosGpsTime.GetFault(to_vtk(arguments.gps_start))):
        return f'--gps-start "{arguments.gps_start}" {fault}'
    if arguments.sub_rays and (arguments.range_tolerance or arguments.energy_tolerance):
        return (
            "--sub-rays is a fixed number, and a tolerance makes the number adaptive: "
            "give one of them"
        )
    if arguments.waveforms_in_points and not (
        arguments.waveforms and arguments.format in ("las", "laz")
    ):
        return "--waveforms-in-points needs --format las or laz, and --waveforms: give all three"
    if fault := find_fault(arguments):
        return fault
    if arguments.check_all and not arguments.resume:
        return "--check-all needs --resume: give both"
    if arguments.dry_run and arguments.part:
        return "--dry-run estimates the whole run: leave --part out"
    return None


def run(arguments):
    if problem := contradiction(arguments):
        say_error(problem)
        return 2
    return run_survey(arguments)


def run_survey(arguments, parts=None):
    """Runs the survey, or joins the folders of its parts, by epoch; returns the exit code."""
    try:
        ranks = start_ranks()
    except NoMpi as error:
        say_error(str(error))
        return 1
    if ranks is None:
        return run_here(arguments, parts)
    code = serve(arguments, ranks) if ranks.GetRank() else run_here(arguments, parts, ranks)
    if code < 128:  # else MPI ends the other ranks
        ranks.Finalize()
    return code


def run_here(arguments, parts, ranks=None):
    """Runs the survey, with other ranks if there are any."""
    with Messages(quiet=arguments.quiet, results=not arguments.json) as messages:
        vtkSMPTools.Initialize(arguments.threads or count_threads())
        limit_memory(arguments)
        survey = read_survey(arguments, messages)
        code = 1
        if survey is not None:
            player = make_player(arguments, survey, messages)
            player.SetRanks(ranks)
            code = run_epochs(arguments, player, parts, messages)
        if ranks and not code and not arguments.dry_run:
            messages.info(describe_traffic(ranks, player))
        if ranks and code < 128:
            ranks.Dismiss()
        return code


def describe_traffic(ranks, player):
    """Returns the ranks of a run, and what rank 0 has received."""
    per_pulse = ranks.GetNumberOfBytes() / max(1, player.GetNumberOfPulses())
    return (
        f"ranks    {ranks.GetNumberOfRanks()}, which sent {ranks.GetNumberOfBytes():,} bytes, "
        f"{per_pulse:.1f} bytes per pulse"
    )


def serve(arguments, ranks):
    """Computes blocks for rank 0, which reports errors, and ends this when it is interrupted."""
    for each in (signal.SIGINT, signal.SIGTERM):
        signal.signal(each, signal.SIG_IGN)
    with Messages(quiet=True) as messages:
        messages.write_error = lambda text: None
        vtkSMPTools.Initialize(arguments.threads or count_threads())
        limit_memory(arguments)
        survey = read_survey(arguments, messages)
        player = vtkHeliosSurveyPlayer()
        if survey is not None:
            player = make_player(arguments, survey, messages)
        player.SetRanks(ranks)
        return 0 if player.Serve() else 1


def run_epochs(arguments, player, parts, messages):
    """Runs all epochs; returns the exit code."""
    epochs = sorted(parts) if parts else epochs_to_run(arguments, player, messages)
    reports = []
    with StopRequest(player) as request:
        for epoch in epochs:
            set_parts(player, parts[epoch] if parts else [])
            code = run_epoch(arguments, player, epoch, messages, request, reports)
            if code:
                return code
    if reports:
        conclude(arguments, epochs, reports, messages)
    return 0 if reports else 1


def read_survey(arguments, messages):
    """Returns the survey, or None after an error."""
    if problem := missing_folder(arguments.assets):
        messages.error(problem)
        return None
    reader = make_reader(arguments.survey, arguments.assets)
    messages.watch(reader)
    if not reader.Read():
        messages.error_unless_told(f"{arguments.survey}: cannot be read")
        return None
    return reader.GetSurvey()


def make_player(arguments, survey, messages):
    player = vtkHeliosSurveyPlayer()
    messages.watch(player)
    player.SetSurvey(survey)
    player.SetOutputDirectory(to_vtk(arguments.output))
    player.SetOverwrite(arguments.overwrite)
    player.SetResume(arguments.resume)
    if arguments.check_all:
        player.SetBytesToCheck(player.GetBytesToCheckMaxValue())
    player.GetSource().SetInstances(not arguments.no_instances)
    player.SetPulsesPerBlock(arguments.pulses_per_block)
    player.SetFormat(arguments.format)
    player.SetForecast(messages.results)
    set_outputs(player, arguments)
    if arguments.part:
        player.SetPart(arguments.part[0])
        player.SetNumberOfParts(arguments.part[1])
        player.SetPartCommand(to_vtk(command_of_part(arguments)))
    seed = max(0, survey.GetSeed()) if arguments.seed is None else arguments.seed
    options = player.GetOptions()
    set_options(options, arguments)
    options.SetSeed(seed)
    messages.info(
        f"survey   {text_from_vtk(survey.GetName())} ({arguments.survey}), seed {seed}"
        f"{', without noise' if arguments.no_noise else ''}"
    )
    return player


def command_of_part(arguments):
    """Returns the values that determine the output, as JSON: for vtkhelios join."""
    host = "command run part epoch output overwrite resume check_all dry_run threads memory json quiet verbose"
    host += "" if arguments.plugin else " plugin"
    options = {name: value for name, value in vars(arguments).items() if name not in host.split()}
    return json.dumps({"folder": os.getcwd(), "options": options})


def set_parts(player, folders):
    """Sets the folders of parts that the player joins."""
    player.ClearPartFolders()
    for folder in folders:
        player.AddPartFolder(to_vtk(folder))


def epochs_to_run(arguments, player, messages):
    """Returns the epochs to run; empty after an error."""
    count = player.GetSurvey().GetNumberOfEpochs()
    if arguments.epoch is not None:
        return [arguments.epoch]  # the player reports a missing one
    if count > 1 and not (arguments.dry_run or arguments.overwrite or arguments.resume):
        for epoch in range(count):  # before a long first run
            player.GetOptions().SetEpoch(epoch)
            folder = pathlib.Path(from_vtk(player.GetRunFolder()))
            if any((folder / name).exists() for name in (JOURNAL_NAME, SUMMARY_NAME)):
                messages.error(
                    f"{folder}: holds the files of an earlier run, which are kept; give --resume to "
                    "continue it, --overwrite to replace them, or another --output"
                )
                return []
    return range(count)


def run_epoch(arguments, player, epoch, messages, request, reports):
    """Runs an epoch and adds its report to the others; returns an exit code."""
    if request.signal:
        line = f"error: interrupted before epoch {epoch}: --resume continues with it"
        return report_stop(request, line)
    player.GetOptions().SetEpoch(epoch)
    if player.GetSurvey().GetNumberOfEpochs() > 1:
        messages.info(
            f"epoch    {epoch} of {player.GetSurvey().GetNumberOfEpochs()}, counted from 0"
        )
    folder = pathlib.Path(from_vtk(player.GetRunFolder()))
    observer = watch_run(arguments, player, folder, messages)
    with make_progress(player, messages, quiet=arguments.quiet):
        succeeded = run_player(player, ESTIMATE if arguments.dry_run else RUN)
    player.RemoveObserver(observer)
    set_outcome("")
    if request.signal and not succeeded:
        points = player.GetCount("points")
        kept = (
            f"the {counted(points, 'point')} so far are kept in {folder}; --resume continues the run"
            if points
            else "no points yet"
        )
        line = f"error: interrupted at {100 * player.GetProgress():.0f} %: {kept}"
        return report_stop(request, line)
    if not succeeded:
        messages.error_unless_told(from_vtk(player.GetMessage()))
        return 1
    report = read_report(player, folder, messages)
    if report is None:
        return 1
    if player.GetWasFinished():
        messages.info(from_vtk(player.GetMessage()))
    verbose = arguments.verbose
    lines = summary_lines(report, folder, verbose)
    for line in estimate_lines(report, verbose) if arguments.dry_run else lines:
        messages.info(line)
    reports.append(report)
    if request.signal:
        return report_stop(
            request, f"error: interrupted; all points are written, and complete in {folder}"
        )
    return 0


def watch_run(arguments, player, folder, messages):
    """Sets what is said if the process is ended before the player stops, and prints the forecast, with the
    progress; returns an observer's tag."""
    kept = f" before its end: the points so far are kept in {folder}; --resume continues the run"
    set_outcome(kept if arguments.resume else " at 0 %: no points yet")

    forecasts = []

    def update(*_):
        if player.GetCount("points"):
            set_outcome(kept)
        forecast = player.GetForecastReport()
        if forecast and not forecasts:
            forecasts.append(json.loads(forecast))
            if line := forecast_line(forecasts[0]):
                messages.note(line)

    return player.AddObserver("ProgressEvent", update)


def read_report(player, folder, messages):
    """Returns the report of a run, or of an earlier one; None after an error."""
    text = from_vtk(player.GetReport())
    if not player.GetWasFinished():
        return json.loads(text)
    from ..formats._summary import FINISHED, FormatError, parse_summary  # slow to import

    try:
        return parse_summary(text, folder / SUMMARY_NAME, FINISHED)
    except FormatError as error:
        messages.error(str(error))
        return None


def conclude(arguments, epochs, reports, messages):
    """The result as JSON; of several epochs also their sums."""
    report = reports[0]
    if len(reports) > 1:
        report = join_reports(epochs, reports)
        for line in epochs_lines(report):
            messages.info(line)
    if arguments.json:
        print(json.dumps(report, indent=2))
