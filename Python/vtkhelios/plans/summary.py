# SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
# SPDX-License-Identifier: BSD-3-Clause
"""The result of a plan as plain data, as in plan_summary.json, and its positions on roofs."""

import math

import numpy as np
from vtkmodules.util.numpy_support import vtk_to_numpy
from vtkmodules.vtkCommonDataModel import vtkPolyData

from ..array_names import (
    AREA, COVERABLE, EXCLUSIVITY, MATERIAL_IS_GROUND, MEAN_INCIDENCE_ANGLE, NEWLY_COVERED,
    NUMBER_OF_SCANS, PART_IDS, PART_NAME, VIEWSHED_SIZE,
)  # fmt: skip
from ..core.arrays import arrays
from ..core.classes import version, vtk_class
from ..core.paths import from_vtk
from ..core.pipeline import update
from ..core.words import counted
from ..scenes.scene import has_instances
from .settings import report_settings

__all__ = ["make_report", "order_positions", "warn_of_roofs"]

HEADROOM = 1.8  # the least distance to a surface below that makes a roof of one [m]


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
        **({"walk": walk} if walk else {}),
        **_objects(task, planner.GetOutputDataObject(1)),
        "positions": list(_position_rows(positions)),
    }


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


def find_raised(scene, positions, height):
    """Returns the positions above another surface: (index, distance to the highest one below [m])
    each."""
    points = vtk_to_numpy(scene.GetPoints().GetData())
    corners = vtk_to_numpy(scene.GetPolys().GetConnectivityArray()).reshape(-1, 3)
    low, high = (
        find([points[corners[:, i], :2] for i in range(3)], axis=0) for find in (np.min, np.max)
    )
    raised = []
    for index, (x, y, z) in enumerate(np.asarray(positions)):
        foot = z - height
        near = ((low <= (x, y)) & (high >= (x, y))).all(axis=1)
        depths = foot - _heights_at(x, y, points[corners[near]])
        depths = depths[depths >= HEADROOM]
        if len(depths):
            raised.append((index, depths.min()))
    return raised


def _heights_at(x, y, triangles):
    """Returns the heights at which triangles (n x 3 x 3) cross a vertical line."""
    a, u, v = triangles[:, 0], *(triangles[:, k] - triangles[:, 0] for k in (1, 2))
    area = u[:, 0] * v[:, 1] - u[:, 1] * v[:, 0]
    dx, dy = x - a[:, 0], y - a[:, 1]
    with np.errstate(divide="ignore", invalid="ignore"):
        s, t = (dx * v[:, 1] - dy * v[:, 0]) / area, (dy * u[:, 0] - dx * u[:, 1]) / area
    inside = (area != 0) & (s >= 0) & (t >= 0) & (s + t <= 1)
    return (a[:, 2] + s * u[:, 2] + t * v[:, 2])[inside]


def has_ground(scene):
    """Returns whether any material of a scene is ground."""
    column = scene.GetFieldData().GetArray(MATERIAL_IS_GROUND)
    return column is not None and any(
        column.GetTuple1(i) for i in range(column.GetNumberOfTuples())
    )


def warn_of_roofs(plan):
    """Returns a warning of positions on roofs, or None. Scenes with ground materials have none
    there."""
    if (
        plan.task.settings["ground"] != "auto"
        or has_instances(plan.scene)
        or has_ground(plan.scene)
    ):
        return None
    raised = find_raised(plan.scene, plan.positions, plan.task.settings["height"])
    if not raised:
        return None
    index, distance = raised[0]
    x, y, z = plan.positions[index]
    count = f"{len(raised)} of {counted(len(plan.positions), 'position')}"
    return (
        f"{count} {'stand' if len(raised) > 1 else 'stands'} above another surface, as on a roof: "
        f"position {index + 1} at ({x:.2f}, {y:.2f}, {z:.2f}), {distance:.2f} m above it. No material "
        "of the scene is ground: give helios_isGround true to those of the ground in the .mtl file, or "
        "leave the roof out with --exclude (exclude=)"
    )
