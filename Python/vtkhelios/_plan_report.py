# SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
# SPDX-License-Identifier: BSD-3-Clause
"""The result of a plan as plain data, as in plan_summary.json."""

import importlib
import math

from ._arrays import arrays
from ._plan_settings import report_settings
from .array_names import EXCLUSIVITY, MEAN_INCIDENCE_ANGLE, NEWLY_COVERED, VIEWSHED_SIZE

__all__ = ["make_report"]


def make_report(task):
    """The inputs and results of a task that was run."""
    plan, document = task.filters, task.document
    candidates, test_points = plan.GetCandidates(), plan.GetTestPoints()
    planner = plan.GetPlanner()
    return {
        "vtkHelios": importlib.import_module(__package__).__version__,
        "source": {"file": task.source, "kind": document.GetKind()},
        "name": task.name,
        "settings": report_settings(task.settings),
        "scan": {
            "platform": document.GetPlatformReference(),
            "scanner": document.GetScannerReference(),
            "pulseFrequency_Hz": document.GetLegPulseFrequency(),
            "scanFrequency_Hz": document.GetLegScanFrequency(),
            "headRotatePerSec_deg": document.GetLegHeadRotatePerSecond(),
            "angularStep_deg": document.GetLegAngularStep(),
        },
        "candidates": candidates.GetOutput().GetNumberOfPoints(),
        "enclosed": candidates.GetNumberOfEnclosed(),
        "testPoints": test_points.GetOutput().GetNumberOfPoints(),
        "coverable": planner.GetNumberCoverable(),
        "rays": plan.GetViewsheds().GetNumberOfRays(),
        "result": {
            "scans": planner.GetNumberOfSelected(),
            "covered": planner.GetNumberCovered(),
            "coverage_percent": planner.GetCoverage(),
            "coverableCoverage_percent": planner.GetCoverableCoverage(),
            "lowerBound": planner.GetLowerBound(),
            "bestBound": planner.GetBestBound(),
            "gap_percent": planner.GetGap(),
            "isProvedOptimal": planner.GetIsProvedOptimal(),
            "worstIncidence_deg": _number_or_none(planner.GetWorstIncidenceAngle()),
            "meanBestIncidence_deg": _number_or_none(planner.GetMeanBestIncidenceAngle()),
        },
        "positions": list(_position_rows(planner.GetOutputDataObject(2))),
    }


def _position_rows(positions):
    """The selected positions, largest gain first."""
    columns = arrays(positions)
    unknown = [math.nan] * positions.GetNumberOfPoints()
    for scan, (x, y, z) in enumerate(columns["points"]):
        yield {
            "scan": scan,
            "x": float(x),
            "y": float(y),
            "z": float(z),
            "sees": int(columns[VIEWSHED_SIZE][scan]),
            "adds": int(columns[NEWLY_COVERED][scan]),
            "onlyIt": int(columns[EXCLUSIVITY][scan]),
            "meanIncidence_deg": _number_or_none(columns.get(MEAN_INCIDENCE_ANGLE, unknown)[scan]),
        }


def _number_or_none(value):
    """JSON has no NaN."""
    return None if math.isnan(value) else float(value)
