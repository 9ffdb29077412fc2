# SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
# SPDX-License-Identifier: BSD-3-Clause
"""The result of a plan: as JSON, as a table, as text."""

import math
import sys

import vtkhelios

from ._report import counted, readable
from ._streams import unfiltered

try:
    from rich import box
    from rich.console import Console
    from rich.table import Table
    from rich.text import Text
except ImportError:
    Table = None

MAXIMUM_ROWS = 50

COLUMNS = (  # of the table of positions: title, text
    ("scan", lambda row: str(row["scan"])),
    ("x [m]", lambda row: f"{row['x']:.3f}"),
    ("y [m]", lambda row: f"{row['y']:.3f}"),
    ("z [m]", lambda row: f"{row['z']:.3f}"),
    ("sees", lambda row: f"{row['sees']:,}"),
    ("adds", lambda row: f"{row['adds']:,}"),
    ("only it", lambda row: f"{row['onlyIt']:,}"),
    ("incidence [deg]", lambda row: degrees(row["meanIncidence_deg"])),
)


def make_report(plan, source):
    """A plan as plain data: its inputs and results."""
    planner, document = plan.planner, plan.document
    return {
        "vtkHelios": vtkhelios.__version__,
        "source": {"file": source, "kind": document.GetKind()},
        "name": document.GetPlanName(),
        "settings": plan.settings,
        "scan": {
            "platform": document.GetPlatformReference(),
            "scanner": document.GetScannerReference(),
            "pulseFrequency_Hz": document.GetLegPulseFrequency(),
            "scanFrequency_Hz": document.GetLegScanFrequency(),
            "headRotatePerSec_deg": document.GetLegHeadRotatePerSecond(),
            "angularStep_deg": document.GetLegAngularStep(),
        },
        "candidates": plan.candidates.GetOutput().GetNumberOfPoints(),
        "enclosed": plan.candidates.GetNumberOfEnclosed(),
        "testPoints": plan.test_points.GetOutput().GetNumberOfPoints(),
        "coverable": planner.GetNumberCoverable(),
        "rays": plan.viewsheds.GetNumberOfRays(),
        "result": {
            "scans": planner.GetNumberOfSelected(),
            "covered": planner.GetNumberCovered(),
            "coverage_percent": planner.GetCoverage(),
            "coverableCoverage_percent": planner.GetCoverableCoverage(),
            "lowerBound": planner.GetLowerBound(),
            "bestBound": planner.GetBestBound(),
            "gap_percent": planner.GetGap(),
            "isProvedOptimal": planner.GetIsProvedOptimal(),
            "worstIncidence_deg": number_or_none(planner.GetWorstIncidenceAngle()),
            "meanBestIncidence_deg": number_or_none(planner.GetMeanBestIncidenceAngle()),
        },
        "positions": list(position_rows(planner.GetOutputDataObject(2))),
    }


def position_rows(positions):
    """The selected positions, largest gain first."""
    columns = vtkhelios.arrays(positions)
    unknown = [math.nan] * positions.GetNumberOfPoints()
    for scan, (x, y, z) in enumerate(columns["points"]):
        yield {
            "scan": scan,
            "x": float(x),
            "y": float(y),
            "z": float(z),
            "sees": int(columns["ViewshedSize"][scan]),
            "adds": int(columns["NewlyCovered"][scan]),
            "onlyIt": int(columns["Exclusivity"][scan]),
            "meanIncidence_deg": number_or_none(columns.get("MeanIncidenceAngle", unknown)[scan]),
        }


def number_or_none(value):
    """JSON has no NaN."""
    return None if math.isnan(value) else float(value)


def degrees(value):
    return "-" if value is None else f"{value:.1f}"


def print_table(rows):
    """The positions on standard output."""
    if len(rows) > MAXIMUM_ROWS:
        rows, left = rows[:MAXIMUM_ROWS], len(rows) - MAXIMUM_ROWS
    else:
        left = 0
    cells = [[text(row) for _, text in COLUMNS] for row in rows]
    titles = [title for title, _ in COLUMNS]
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
    if left:
        print(f"and {left} more; all are in positions.vtp")


def result_lines(report):
    """The result, as text."""
    result = report["result"]
    points = report["testPoints"]
    yield (
        f"covered  {result['covered']:,} test points: "
        f"{result['coverableCoverage_percent']:.2f} % of the {report['coverable']:,} coverable "
        f"ones, {result['coverage_percent']:.2f} % of all {points:,}"
    )
    if result["worstIncidence_deg"] is not None:
        yield (
            f"angles   best incidence of a test point: at most {result['worstIncidence_deg']:.1f} "
            f"deg, {result['meanBestIncidence_deg']:.1f} deg on average"
        )
    yield f"scans    {describe_proof(result, report['settings'].get('timeLimit_s'))}"


def describe_proof(result, limit=None):
    """The count and its proof; limit is the search time of the exact method [s]."""
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


def file_lines(files):
    for index, path in enumerate(files):
        yield f"{'' if index else 'files':8} {path} ({readable(path.stat().st_size)})"
