# SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
# SPDX-License-Identifier: BSD-3-Clause
"""vtkhelios plan --als: plans, prints, writes and checks a flight."""

import json
import pathlib

from ...core.files import cannot_be_written
from ...core.paths import require_utf8
from ...flight import FlightPlan
from ...flight._check import Counts

from ...flight._files import FILES, data_files, geo_files, page_file, picture_file
from ...plans.files import new_plan, summary_file
from ...plans.geo import check_formats
from ...reports.flight import check_lines, flight_lines, lacks, print_lines
from ...reports.plan import file_lines, run_lines
from .._geo_files import write_geo_files
from .._plan_check import read_strips, simulate
from .._plan_options import find_unusable
from .._stopping import set_outcome
from .options import given_flight_settings


def make_flight_plan(arguments, messages):
    """Makes, prints and writes the plan; returns an exit code."""
    formats = check_formats(arguments.geo or "all")
    plan = FlightPlan(arguments.input, arguments.assets, **given_flight_settings(arguments))
    require_utf8(plan.name)
    folder = pathlib.Path(arguments.output) / plan.name
    if problem := find_unusable(folder, arguments.overwrite, FILES):
        messages.error(problem)
        return 1
    messages.info(f"plan     {plan.name} ({arguments.input}), airborne")
    if messages.results:
        print_lines(plan.lines)
    for line in flight_lines(plan.report):
        messages.info(line)
    for problem in lacks(plan.report):
        messages.warning(problem)
    try:
        with new_plan(folder, FILES):
            return write(arguments, formats, plan, folder, messages)
    except OSError as error:
        messages.error(cannot_be_written(error, folder, "--output"))
        return 1


def write(arguments, formats, plan, folder, messages):
    """Writes the files of a plan, and the check; returns an exit code."""
    set_outcome(f"the plan in {folder} was not written")
    files = data_files(plan, folder)
    files += write_geo_files(arguments, geo_files(plan, folder, formats), messages)
    set_outcome("the plan itself is written, other files are not")
    report, code, counts = dict(plan.report), 0, None
    if arguments.check:
        summary_file({**report, "files": [path.name for path in files]}, folder)  # if it is stopped
        code, counts = check(arguments, plan, files[0], folder, messages)
        report |= {"check": counts.compare()} if counts else {}
        for line in check_lines(report["check"]) if counts else ():
            messages.info(line)
    files += draw(arguments, plan, counts, folder, messages)
    report["files"] = [path.name for path in files]
    for line in file_lines([*files, summary_file(report, folder)]):
        messages.info(line)
    for line in run_lines(files[0], arguments.assets):
        messages.info(line)
    if arguments.json:
        print(json.dumps(report, indent=2))
    return code


def draw(arguments, plan, counts, folder, messages):
    """Returns the picture and the page of a plan: their paths, without those that cannot be
    made."""
    if arguments.no_picture:
        return []
    try:
        return [picture_file(plan, folder), page_file(plan, folder, counts)]
    except RuntimeError as error:
        messages.warning(f"no plan.png and plan.html: {error}, or give --no-picture")
        return []


def check(arguments, plan, survey, folder, messages):
    """Simulates the survey; returns an exit code, and Counts or None."""
    code, simulated = simulate(survey, arguments, folder / "check", messages)
    if code:
        return code, None
    counts = Counts(plan)
    for points in read_strips(simulated, len(plan)):
        counts.add(points)
    return 0, counts
