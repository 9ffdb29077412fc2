# SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
# SPDX-License-Identifier: BSD-3-Clause
"""vtkhelios plan: finds scan positions, and writes the survey of them."""

import errno
import json
import os
import pathlib
import shlex
import shutil

from vtkmodules.vtkCommonCore import vtkSMPTools
from vtkmodules.vtkCommonDataModel import vtkPolyData
from vtkmodules.vtkIOXML import vtkXMLPolyDataReader, vtkXMLPolyDataWriter

import vtkhelios

from .._paths import from_vtk, require_utf8
from ._files import cannot_be_written, write_whole
from ._interrupt import Interrupt
from ._plan_check import check_lines, compare, explain_difference, read_clouds, simulate
from ._plan_options import PLATFORM, SCANNER, add_plan_arguments
from ._plan_report import file_lines, make_report, print_table, result_lines
from ._planning import Plan, PlanMessages, Steps
from ._progress import make_progress
from ._reading import look_up, missing_folder
from ._report import counted

SUMMARY = "find scan positions for a scene, and write the survey that scans from them"

EPILOG = """\
input: a file in HELIOS XML with a <surveyPlanner>, else with a <survey> (its scene, tripod,
scanner and scanner settings), else with a <scene>; or a mesh (.obj, .tif). The default platform and
scanner for scenes and meshes are a tripod and a VZ-400 class scanner; see --platform and
--scanner. Options override the file.

how it plans:
  1 candidates: places on a grid (--grid) where a tripod can be set up: not too steep (--max-slope),
    on the ground (--ground), outside excluded areas (--exclude), in a --region
  2 test points: where vertical and horizontal lines of a grid (--test-grid) meet a surface
  3 viewsheds: the test points that each candidate sees, unoccluded up to --tolerance before the
    point, and within the given limits (--scanner-limits, --range-max ...)
  4 positions: the fewest candidates that see all that any candidate sees, or --coverage percent of it
  The default grid spacing is a twentieth of the scene's diagonal. Halve it until the plan stays the
  same.

methods, for step 4:
  reduce    removes redundant candidates, those with the smallest viewshed or mean incidence first
            (--remove-order): Bechtold and Hoefle 2016; the default for a <surveyPlanner>
  greedy    adds the candidate that gains most, then removes redundant ones (bestcoverage is the same)
  best      removes dominated candidates, weights test points by how few candidates see them, then
            searches further; the default for scenes and surveys
  optimal   proves the minimum, within --time-limit; otherwise it prints the gap to the lower bound
  All print a lower bound of the number of scans. See Docs/planning.md.

what it writes, below OUTPUT/<name>/:
  survey.xml         one leg per position, largest gain first; for vtkhelios run
  positions.vtp      the positions: ViewshedSize (test points seen), NewlyCovered, Exclusivity (seen
                     from this one only), MeanIncidenceAngle [deg]
  candidates.vtp     all candidates, with the same arrays and Selected
  test_points.vtp    Coverable, NumberOfScans (that see it), BestIncidenceAngle [deg]
  plan.png           the test points by number of scans and by best incidence (needs an X display:
                     xvfb-run -a vtkhelios plan ... makes one)
  plan_summary.json  settings, bounds, positions, timings; --json prints it
  check/             the simulated survey, with --check

examples:
  vtkhelios plan yard.obj --grid 2
  vtkhelios plan scene.xml --method optimal --coverage 98 --range-max 60
  vtkhelios plan planner.xml --output plans          a <surveyPlanner>
  vtkhelios plan scene.xml --scanner-limits --overlap 20 --max-incidence 75
  vtkhelios plan scene.xml --check --resolution 0.05      also simulate the survey
  vtkhelios run output/yard/survey.xml               run the planned survey

exit codes: 0 done, 1 failed (the reason is on standard error), 2 wrong usage,
130 interrupted (Ctrl-C: nothing is written before the plan is made).
"""

FILES = (
    "survey.xml",
    "positions.vtp",
    "candidates.vtp",
    "test_points.vtp",
    "plan.png",
    "plan_summary.json",
)


def add_arguments(parser):
    parser.epilog = EPILOG
    add_plan_arguments(parser)


def run(arguments):
    require_utf8(arguments.input, arguments.output)  # the survey stores them as XML
    with PlanMessages(quiet=arguments.quiet, results=not arguments.json) as messages:
        vtkSMPTools.Initialize(arguments.threads or len(os.sched_getaffinity(0)))
        document = read_document(arguments, messages)
        if document is None:
            return 1
        for name in ("PlanName", "SceneReference", "PlatformReference", "ScannerReference"):
            require_utf8(from_vtk(getattr(document, f"Get{name}")()))  # as above
        folder = pathlib.Path(arguments.output) / document.GetPlanName()
        if problem := find_earlier_plan(folder, arguments.overwrite):
            messages.error(problem)
            return 1
        if problem := find_unusable(arguments, folder):
            messages.error(problem)
            return 1
        plan = Plan(arguments, document)
        if problem := find_contradiction(plan.settings):
            messages.error(problem)
            return 1
        messages.info(
            f"plan     {document.GetPlanName()} ({arguments.input}), {plan.settings['method']}"
        )
        steps = Steps(messages)
        with Interrupt(steps, messages) as interrupt:
            with make_progress(steps, messages, quiet=arguments.quiet):
                succeeded = plan.run(steps)
        if interrupt.signal:
            messages.interrupted = False
            messages.error("interrupted before the plan was made; nothing was written")
            return 128 + interrupt.signal
        if not succeeded:
            messages.error_unless_told("no plan was found")
            return 1
        return conclude(arguments, plan, steps, folder, messages)


def read_document(arguments, messages):
    """The plan document, or None after an error."""
    if problem := missing_folder(arguments.assets):
        messages.error(problem)
        return None
    document = vtkhelios.vtkHeliosPlannerReader()
    look_up(document, arguments.input, arguments.assets)
    document.SetPlatform(arguments.platform)
    document.SetScanner(arguments.scanner)
    document.SetDefaultPlatform(PLATFORM)
    document.SetDefaultScanner(SCANNER)
    document.SetUseScannerLimits(arguments.scanner_limits)
    document.SetResolution(arguments.resolution)
    document.SetPulseFrequency(arguments.pulse_frequency)
    messages.watch(document)
    if document.Read():
        return document
    messages.error_unless_told(f"{arguments.input}: cannot be read")
    return None


def find_earlier_plan(folder, overwrite):
    """Why a plan must not be written to a folder, or None."""
    if overwrite or not any((folder / name).exists() for name in FILES):
        return None
    return (
        f"{folder}: holds the files of an earlier plan, which are kept; give --overwrite to replace "
        "them, or another --output"
    )


def find_unusable(arguments, folder):
    """The error in the named files, or None."""
    if arguments.exclude and not vtkXMLPolyDataReader().CanReadFile(arguments.exclude):
        return f"--exclude {arguments.exclude}: is not a VTK XML file of polygons; give a .vtp"
    try:
        folder.mkdir(parents=True, exist_ok=True)
        (folder / "survey.xml.part").touch()
        (folder / "survey.xml.part").unlink()
    except OSError as error:
        return cannot_be_written(error, folder, "--output")
    return None


def find_contradiction(settings):
    """Why nothing can be visible, or None."""
    for low, high, options in (
        (settings["rangeMin_m"], settings["rangeMax_m"], "--range-min, --range-max"),
        (
            settings["elevationMin_deg"],
            settings["elevationMax_deg"],
            "--elevation-min, --elevation-max",
        ),
    ):
        if low >= high:
            return f"the range from {low:g} to {high:g} is empty: give a larger one ({options})"
    return None


def conclude(arguments, plan, steps, folder, messages):
    """Writes and prints the result of a plan; returns an exit code."""
    report = make_report(plan, arguments.input)
    messages.info(
        f"from     {report['candidates']:,} candidates and {report['testPoints']:,} test points, "
        f"{report['coverable']:,} of them coverable"
    )
    if report["enclosed"]:
        messages.info(
            f"         without {counted(report['enclosed'], 'enclosed place')} (--enclosed "
            "includes them)"
        )
    if messages.results:
        print_table(report["positions"])
    for line in result_lines(report):
        messages.info(line)
    try:
        return write_plan(arguments, plan, steps, folder, report, messages)
    except OSError as error:
        messages.error(cannot_be_written(error, folder, "--output"))
        return 1


def write_plan(arguments, plan, steps, folder, report, messages):
    """Writes the files of a plan, and the check; returns an exit code."""
    clear(folder)
    files = write_data(plan.planner, folder)
    survey = write_survey(arguments, plan, folder, messages)
    if survey is None:
        return 1
    files.insert(0, survey)
    picture = draw(arguments, plan, folder, messages)
    files += [picture] if picture else []
    code = 0
    if arguments.check:
        code = check(arguments, plan, survey, folder, report, messages)
    report["timings"] = {**steps.seconds}
    report["files"] = [path.name for path in files]
    path = folder / "plan_summary.json"
    write_whole(path, json.dumps(report, indent=2) + "\n")
    for line in file_lines([*files, path]):
        messages.info(line)
    folders = [word for folder in arguments.assets for word in ("--assets", folder)]
    messages.info(f"run it   {shlex.join(['vtkhelios', 'run', str(survey), *folders])}")
    if arguments.json:
        print(json.dumps(report, indent=2))
    return code


def clear(folder):
    """Makes a folder without the files of an earlier plan."""
    folder.mkdir(parents=True, exist_ok=True)
    for name in reversed(FILES):  # the summary, which marks them complete, first
        (folder / name).unlink(missing_ok=True)
    shutil.rmtree(folder / "check", ignore_errors=True)


def write_data(planner, folder):
    """Candidates, test points and positions as VTK XML; returns their names."""
    files = []
    for port, name in ((2, "positions.vtp"), (0, "candidates.vtp"), (1, "test_points.vtp")):
        data = vtkPolyData()
        data.ShallowCopy(planner.GetOutputDataObject(port))
        data.GetPointData().RemoveArray("Visibility")  # a bit per pair: as large as all else
        part = folder / f"{name}.part"
        writer = vtkXMLPolyDataWriter()
        writer.SetFileName(str(part))
        writer.SetInputData(data)
        if not writer.Write() or writer.GetErrorCode():
            part.unlink(missing_ok=True)
            raise OSError(errno.ENOSPC, "the disk may be full", str(folder / name))
        os.replace(part, folder / name)
        files.append(folder / name)
    return files


def write_survey(arguments, plan, folder, messages):
    """The survey of a plan: its path, or None after an error."""
    document = plan.document
    path = folder / "survey.xml"
    writer = vtkhelios.vtkHeliosSurveyWriter()
    messages.watch(writer)
    look_up(writer, str(path), arguments.assets)
    writer.SetInputConnection(plan.planner.GetOutputPort(2))
    writer.SetSurveyName(document.GetPlanName())
    writer.SetScene(refer(document.GetSceneReference() or arguments.input, folder))
    writer.SetPlatform(refer(document.GetPlatformReference(), folder))
    writer.SetScanner(refer(document.GetScannerReference(), folder))
    writer.SetPulseFrequency(document.GetLegPulseFrequency())
    writer.SetScanFrequency(document.GetLegScanFrequency())
    if document.HasRotatingMirror():
        writer.SetVerticalAngleMin(document.GetLegVerticalAngleMin())
        writer.SetVerticalAngleMax(document.GetLegVerticalAngleMax())
    elif document.GetLegScanAngle() > 0:
        writer.SetScanAngle(document.GetLegScanAngle())
    writer.SetHeadRotateStart(document.GetLegHeadRotateStart())
    writer.SetHeadRotateStop(document.GetLegHeadRotateStop())
    writer.SetHeadRotatePerSecond(document.GetLegHeadRotatePerSecond())
    return path if writer.Write() else None


def refer(reference, folder):
    """A reference as written to a file of a folder: shipped files by name."""
    path, mark, name = reference.partition("#")
    absolute = pathlib.Path(path).resolve()
    if absolute.is_relative_to(vtkhelios.data_directory().resolve() / "Assets"):
        return f"{absolute.name}{mark}{name}"
    return f"{os.path.relpath(absolute, folder.resolve())}{mark}{name}"


def draw(arguments, plan, folder, messages):
    """The picture of a plan: its path, or None without one."""
    if arguments.no_picture:
        return None
    from vtkhelios import plan_picture

    path = folder / "plan.png"
    try:
        plan_picture.save_picture(
            plan.document.GetOutput(),
            plan.planner.GetOutputDataObject(1),
            plan.planner.GetOutputDataObject(2),
            path,
            title=plan.document.GetPlanName(),
        )
    except RuntimeError as error:
        messages.warning(f"no plan.png: {error}, or give --no-picture")
        return None
    return path


def check(arguments, plan, survey, folder, report, messages):
    """Simulates the survey and compares; returns an exit code."""
    tolerance = plan.settings["hitTolerance_m"]
    code, simulated = simulate(survey, arguments, folder / "check", messages)
    if code:
        return code
    clouds = read_clouds(simulated, len(report["positions"]))
    step = plan.document.GetLegAngularStep()
    report["check"] = compare(clouds, plan.planner, plan.settings, step)
    for line in check_lines(report["check"], tolerance):
        messages.info(line)
    if problem := explain_difference(report["check"], plan.settings):
        messages.warning(problem)
    return 0
