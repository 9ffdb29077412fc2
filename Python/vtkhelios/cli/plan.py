# SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
# SPDX-License-Identifier: BSD-3-Clause
"""vtkhelios plan: finds scan positions, and writes the survey of them."""

import json
import os
import pathlib

from vtkmodules.vtkCommonCore import vtkSMPTools

from ..core.files import cannot_be_written
from ..core.paths import from_vtk, require_utf8
from ..core.words import counted

from ..plans.files import (
    FILES, data_files, geo_files, new_plan, page_file, picture_file, summary_file,
)  # fmt: skip
from ..plans.geo import check_formats
from ..plans.plan import Plan, PlanTask
from ..plans.settings import SettingError
from ..reports.plan import file_lines, print_table, result_lines, run_lines
from ._flight.options import add_flight_arguments, find_misplaced
from ._flight.run import make_flight_plan
from ._geo_files import write_geo_files
from ._messages import Messages, shown_problems
from ._plan_check import check_lines, compare, explain_difference, read_clouds, simulate
from ._plan_options import add_plan_arguments, find_unusable, given_settings, option_of
from ._progress import make_progress
from ._stopping import set_outcome
from ._task import PlanWatch

SUMMARY = "find scan positions for a scene, and write the survey that scans from them"

EPILOG = """\
input: a file in HELIOS XML with a <surveyPlanner>, else with a <survey> (its scene, tripod,
scanner and scanner settings), else with a <scene>; or a mesh (.obj, .tif, .ply, .stl, .gltf, .glb,
.json: CityJSON). The default platform and scanner for scenes and meshes are a tripod and a VZ-400
class scanner; see --platform and --scanner. Options override the file.

how it plans:
  1 candidates: places on a grid (--grid) or of a file (--candidates) where a tripod can be set up: not
    too steep (--max-slope), on the ground and not on roofs (--on), outside excluded areas
    (--exclude), in a --region
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
  positions.csv      the tripods in the coordinates of the scene, with the name of the system
  positions.dxf      the same as a drawing (R12)
  positions.geojson, positions.kml, positions.gpx
                     the same in degrees (WGS 84), for maps and receivers; they need the coordinate
                     system of the scene, or --crs; --geo csv,kml writes some only, --geo none none
  plan.html          for the field: map, tripods, times (with matplotlib and Jinja2)
  plan.png           the test points by number of scans and by best incidence (without an X
                     display it needs Xvfb)
  plan_summary.json  settings, bounds, positions, timings; --json prints it
  check/             the simulated survey, with --check

examples:
  vtkhelios plan yard.obj --grid 2
  vtkhelios plan scene.xml --method optimal --coverage 98 --range-max 60
  vtkhelios plan planner.xml --output plans          a <surveyPlanner>
  vtkhelios plan scene.xml --scanner-limits --overlap 20 --max-incidence 75
  vtkhelios plan scene.xml --check --resolution 0.05      also simulate the survey
  vtkhelios plan scene.xml --objects 80 --order walk      80 % of the area of each part
  vtkhelios plan scene.xml --candidates stations.csv      the fewest of given places
  vtkhelios plan yard.obj --crs EPSG:25832 --geo csv,gpx  tripods for a receiver
  vtkhelios run output/yard/survey.xml               run the planned survey

airborne surveys, with --als: lines, speed, pulse and scan frequency with which a strip has the
density (--density) or spacing (--spacing) everywhere in the area (--area), and the shortest flight.
  vtkhelios plan scene.xml --als --flying-height 600 --density 8
  vtkhelios plan terrain.tif --als --area area.geojson --flying-height 90 --terrain-following \\
      --scanner copter_uls --check
  Of equally short flights it takes the one with the fewest pulses, and prints what the next lower and
  higher pulse frequency would cost. It writes survey.xml, lines.vtp, lines.csv, .geojson, .kml, .dxf and
  .gpx, cells.vtp (predicted density), plan.png, plan.html and plan_summary.json. See Docs/planning.md.

exit codes: 0 done, 1 failed (the reason is on standard error), 2 wrong usage,
130 interrupted (Ctrl-C: nothing is written before the plan is made).
"""


def add_arguments(parser):
    parser.epilog = EPILOG
    add_plan_arguments(parser)
    add_flight_arguments(parser)


def run(arguments):
    require_utf8(arguments.input, arguments.output)  # the survey stores them as XML
    set_outcome(" before the plan was made; nothing was written")
    with Messages(quiet=arguments.quiet, results=not arguments.json) as messages:
        vtkSMPTools.Initialize(arguments.threads or len(os.sched_getaffinity(0)))
        try:
            with shown_problems(messages):
                return make_plan(arguments, messages)
        except SettingError as error:
            messages.error(error.format(option_of))
        return 1


def make_plan(arguments, messages):
    """Makes, prints and writes the plan; returns an exit code."""
    if problem := find_misplaced(arguments):
        messages.error(problem)
        return 2
    if arguments.als:
        return make_flight_plan(arguments, messages)
    formats = check_formats(arguments.geo or "all")
    task = PlanTask(arguments.input, arguments.assets, **given_settings(arguments))
    for name in ("SceneReference", "PlatformReference", "ScannerReference"):
        require_utf8(from_vtk(getattr(task.document, f"Get{name}")()))  # same cure
    require_utf8(task.name)
    folder = pathlib.Path(arguments.output) / task.name
    if problem := find_unusable(folder, arguments.overwrite, FILES):
        messages.error(problem)
        return 1
    messages.info(f"plan     {task.name} ({arguments.input}), {task.settings['method']}")
    plan = run_steps(task, arguments, messages)
    print_plan(plan, messages)
    try:
        with new_plan(folder):
            return write_plan(arguments, formats, plan, folder, messages)
    except OSError as error:
        messages.error(cannot_be_written(error, folder, "--output"))
        return 1


def run_steps(task, arguments, messages):
    """Returns the Plan of a task."""
    watch, seconds = PlanWatch(), {}
    with make_progress(watch, messages, quiet=arguments.quiet):
        for step in task.steps():
            watch.begin(step)
            step.run(seconds, watch.on_progress)
    return Plan(task, seconds)


def print_plan(plan, messages):
    """Prints the result of a plan."""
    report = plan.report
    messages.info(
        f"from     {counted(report['candidates'], 'candidate')} and {counted(report['testPoints'], 'test point')}, "
        f"{report['coverable']:,} of them coverable"
    )
    if left := report.get("places", report["candidates"]) - report["candidates"]:
        messages.info(
            f"         without {counted(left, 'place')} of --candidates: off the scene, too steep, excluded, "
            "or on roofs"
        )
    elif report["onRoofs"]:
        messages.info(
            f"         without {counted(report['onRoofs'], 'place')} on roofs (--on any includes them)"
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


def write_plan(arguments, formats, plan, folder, messages):
    """Writes the files of a plan, and the check; returns an exit code."""
    set_outcome(f"the plan in {folder} was not written")
    files = data_files(plan, folder)
    survey = files[0]
    set_outcome("the plan itself is written, other files are not")
    files += write_geo_files(arguments, geo_files(plan, folder, formats), messages)
    files += draw(arguments, plan, folder, messages)
    report = dict(plan.report)
    timings, code = report.pop("timings"), 0
    if arguments.check:
        whole = {**report, "timings": timings, "files": [path.name for path in files]}
        summary_file(whole, folder)  # complete, if the check is stopped
        code = check(arguments, plan, survey, folder, report, messages)
    report["timings"] = timings
    report["files"] = [path.name for path in files]
    for line in file_lines([*files, summary_file(report, folder)]):
        messages.info(line)
    for line in run_lines(survey, arguments.assets):
        messages.info(line)
    if arguments.json:
        print(json.dumps(report, indent=2))
    return code


def draw(arguments, plan, folder, messages):
    """Returns the picture and the page of a plan: their paths, without those that cannot be made."""
    files = []
    for name, make in (("plan.png", picture_file), ("plan.html", page_file)):
        if arguments.no_picture:
            break
        try:
            files.append(make(plan, folder))
        except RuntimeError as error:
            messages.warning(f"no {name}: {error}, or give --no-picture")
    return files


def check(arguments, plan, survey, folder, report, messages):
    """Simulates the survey and compares; returns an exit code."""
    settings = report["settings"]
    code, simulated = simulate(
        survey, arguments, folder / "check", messages, settings["movingParts"]
    )
    if code:
        return code
    clouds = read_clouds(simulated, len(plan))
    report["check"] = compare(clouds, plan, settings, report["scan"]["angularStep_deg"])
    for line in check_lines(report["check"], settings["hitTolerance_m"]):
        messages.info(line)
    if problem := explain_difference(report["check"], settings):
        messages.warning(problem)
    return 0
