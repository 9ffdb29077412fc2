# SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
# SPDX-License-Identifier: BSD-3-Clause
"""The result of a plan: as a table, as text."""

import shlex
import sys

from ..core.streams import unfiltered
from ..core.words import counted, time_span
from .run import readable

try:
    from rich import box
    from rich.console import Console
    from rich.table import Table
    from rich.text import Text
except ImportError:
    Table = None

MAXIMUM_ROWS = 50

COLUMNS = (  # columns of the table of positions: title, text
    ("scan", lambda row: str(row["scan"])),
    ("x [m]", lambda row: f"{row['x']:.3f}"),
    ("y [m]", lambda row: f"{row['y']:.3f}"),
    ("z [m]", lambda row: f"{row['z']:.3f}"),
    ("sees", lambda row: f"{row['sees']:,}"),
    ("adds", lambda row: f"{row['adds']:,}"),
    ("only it", lambda row: f"{row['onlyIt']:,}"),
    ("incidence [deg]", lambda row: degrees(row["meanIncidence_deg"])),
)


def degrees(value):
    return "-" if value is None else f"{value:.1f}"


def print_table(rows):
    """The positions on standard output."""
    if len(rows) > MAXIMUM_ROWS:
        rows, left = rows[:MAXIMUM_ROWS], len(rows) - MAXIMUM_ROWS
    else:
        left = 0
    print_rows(rows, COLUMNS)
    if left:
        print(f"and {left} more; all are in positions.vtp")


def print_rows(rows, columns):
    """A table on standard output; columns: title, and the text of a row."""
    cells = [[text(row) for _, text in columns] for row in rows]
    titles = [title for title, _ in columns]
    if Table:
        table = Table(box=box.SIMPLE_HEAD, pad_edge=False)
        for title in titles:
            table.add_column(Text(title), justify="right", no_wrap=True)
        for row in cells:
            table.add_row(*row)
        Console(file=unfiltered(sys.stdout), highlight=False, width=120).print(table)
    else:
        widths = [max(map(len, column)) for column in zip(titles, *cells)]
        for row in [titles, *cells]:
            print("  ".join(f"{cell:>{width}}" for cell, width in zip(row, widths)))


def result_lines(report):
    """Yields the result, as text."""
    result = report["result"]
    points = report["testPoints"]
    yield (
        f"covered  {counted(result['covered'], 'test point')}: "
        f"{result['coverableCoverage_percent']:.2f} % of the {report['coverable']:,} coverable "
        f"ones, {result['coverage_percent']:.2f} % of all {points:,}"
    )
    if result["worstIncidence_deg"] is not None:
        yield (
            f"angles   best incidence of a test point: at most {result['worstIncidence_deg']:.1f} "
            f"deg, {result['meanBestIncidence_deg']:.1f} deg on average"
        )
    yield f"scans    {describe_proof(result, report['settings'].get('timeLimit_s'))}"
    times = report["times"]
    yield (
        f"time     {time_span(times['total_s'])}: setting up {time_span(times['setup_s'])}, scanning "
        f"{time_span(times['scan_s'])}, walking {time_span(times['travel_s'])}"
    )
    if "objects" in report:
        yield describe_objects(report["objects"])
    if "walk" in report:
        yield describe_walk(report["walk"])


def describe_objects(objects):
    """Returns the least covered part."""
    seen = [row for row in objects if row["covered_percent"] is not None]
    unseen = len(objects) - len(seen)
    least = min(seen, key=lambda row: row["covered_percent"])
    name = f" ({least['name']})" if least["name"] else ""
    more = f"; {counted(unseen, 'part')} that no candidate sees" if unseen else ""
    return (
        f"objects  {counted(len(seen), 'part')} covered to {least['covered_percent']:.2f} % or more: "
        f"part {least['part']}{name}{more}"
    )


def describe_walk(walk):
    text = f"walk     {walk['length_m']:.1f} m in straight lines, "
    if walk["isProvedShortest"]:
        return text + "the shortest"
    gap = 100 * (walk["length_m"] / walk["lowerBound_m"] - 1)
    return text + f"at least {walk['lowerBound_m']:.1f} m (gap {gap:.1f} %)"


def describe_proof(result, limit=None):
    """Returns the count and its proof; limit is the search time of the exact method [s]."""
    scans = counted(result["scans"], "scan")
    bound = f"linear bound {result['lowerBound']:.2f}"
    if result["isProvedOptimal"]:
        return f"{scans}, proved to be the minimum for these candidates ({bound})"
    cure = "--method optimal searches further"
    if limit is not None:
        cure = f"the proof was not finished in {limit:g} s; give a longer --time-limit"
    return (
        f"{scans}; lower bound: {counted(result['bestBound'], 'scan')} ({bound}, gap "
        f"{result['gap_percent']:.0f} %); {cure}"
    )


def run_lines(survey, assets):
    """Yields the command that runs a planned survey."""
    folders = [word for folder in assets for word in ("--assets", str(folder))]
    yield f"run it   {shlex.join(['vtkhelios', 'run', str(survey), *folders])}"
    yield "         with --dry-run: an estimate of its time and points"


def file_lines(files):
    for index, path in enumerate(files):
        yield f"{'' if index else 'files':8} {path} ({readable(path.stat().st_size)})"
