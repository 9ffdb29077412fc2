# SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
# SPDX-License-Identifier: BSD-3-Clause
"""The result of a plan as plain data, as in plan_summary.json."""

import math

import numpy as np
from vtkmodules.vtkCommonDataModel import vtkPolyData

from ..array_names import (
    AREA, COVERABLE, EXCLUSIVITY, MEAN_INCIDENCE_ANGLE, NEWLY_COVERED, NUMBER_OF_SCANS,
    PART_IDS, PART_NAME, VIEWSHED_SIZE,
)  # fmt: skip
from ..core.arrays import arrays
from ..core.classes import version, vtk_class
from ..core.paths import from_vtk
from ..core.pipeline import update
from .settings import report_settings

__all__ = ["make_report", "order_positions"]


def order_positions(positions, order):
    """Returns the selected positions of a planner (vtkPolyData) in an order, and its walk for
    reports.

    "gain" leaves them as they are, and there is no walk; "walk" is the shortest one, "round" the
    shortest that returns to its beginning.
    """
    if order == "gain":
        return positions, None
    walk = vtk_class("vtkHeliosShortestWalk")()
    walk.SetInputData(positions)
    walk.SetClosed(order == "round")
    ordered = vtkPolyData()
    ordered.ShallowCopy(update(walk))
    length, bound = walk.GetLength(), walk.GetLowerBound()
    return ordered, {
        "length_m": length,
        "lowerBound_m": bound,
        "isProvedShortest": bound >= length * (1 - 1e-9),
    }


def make_report(task, positions, walk=None):
    """The inputs and results of a task that was run; positions and walk of order_positions()."""
    plan, document = task.filters, task.document
    candidates, test_points = plan.GetCandidates(), plan.GetTestPoints()
    planner = plan.GetPlanner()
    return {
        "vtkHelios": version(),
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
        **(
            {"places": _count_places(candidates)} if task.settings["candidates"] is not None else {}
        ),
        "onRoofs": candidates.GetNumberOnRoofs(),
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
        "crs": task.geography.label or None,
        "times": _times(task, positions),
        **({"walk": walk} if walk else {}),
        **_objects(task, planner.GetOutputDataObject(1)),
        "positions": list(_position_rows(positions)),
    }


def _count_places(candidates):
    """Returns the number of places that were given."""
    return candidates.GetInputDataObject(2, 0).GetNumberOfPoints()


def _times(task, positions):
    """The duration of the field work [s]; ways are straight lines in the order of the positions."""
    document, points = task.document, arrays(positions)["points"]
    turn = abs(document.GetLegHeadRotateStop() - document.GetLegHeadRotateStart())
    ends = [*points, *points[:1]] if task.settings["order"] == "round" else points
    way = float(np.linalg.norm(np.diff(ends, axis=0), axis=1).sum())
    times = {
        "setup_s": len(points) * task.settings["setup_time"],
        "scan_s": len(points) * turn / document.GetLegHeadRotatePerSecond(),
        "travel_s": way / task.settings["walking_speed"],
    }
    return {"way_m": way, **times, "total_s": sum(times.values())}


def _objects(task, test_points):
    """Coverage by part, if it was asked for."""
    columns = arrays(test_points)
    if not task.settings["objects"] or PART_IDS not in columns:
        return {}
    parts = columns[PART_IDS]
    weights = columns[AREA] if AREA in columns else np.ones(len(parts))
    coverable = weights * (columns[COVERABLE] > 0)
    covered = weights * (columns[NUMBER_OF_SCANS] > 0)
    names = _part_names(task.document.GetOutput())
    rows = []
    for part in np.unique(parts[parts >= 0]).tolist():
        mine = parts == part
        possible = float(coverable[mine].sum())
        rows.append(
            {
                "part": part,
                "name": names[part] if part < len(names) else "",
                "area": float(weights[mine].sum()),
                "coverable_percent": 100.0 * possible / max(float(weights[mine].sum()), 1e-300),
                "covered_percent": 100.0 * float(covered[mine].sum()) / possible
                if possible > 0
                else None,
            }
        )
    return {"objects": rows}


def _part_names(scene):
    names = scene.GetFieldData().GetAbstractArray(PART_NAME)
    return [from_vtk(names.GetValue(i)) for i in range(names.GetNumberOfValues())] if names else []


def _position_rows(positions):
    """Yields the selected positions, in their order."""
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
