# SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
# SPDX-License-Identifier: BSD-3-Clause
"""Positions of a plan that stand on a roof: above another surface, in a scene without ground."""

import numpy as np
from vtkmodules.util.numpy_support import vtk_to_numpy

from ..array_names import MATERIAL_IS_GROUND
from ..scene import has_instances

HEADROOM = 1.8  # the least distance to a surface below that makes a roof of one [m]


def find_raised(scene, positions, height):
    """The positions above another surface: (index, distance to the highest one below [m]) each."""
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
    """The heights at which triangles (n x 3 x 3) cross a vertical line."""
    a, u, v = triangles[:, 0], *(triangles[:, k] - triangles[:, 0] for k in (1, 2))
    area = u[:, 0] * v[:, 1] - u[:, 1] * v[:, 0]
    dx, dy = x - a[:, 0], y - a[:, 1]
    with np.errstate(divide="ignore", invalid="ignore"):
        s, t = (dx * v[:, 1] - dy * v[:, 0]) / area, (dy * u[:, 0] - dx * u[:, 1]) / area
    inside = (area != 0) & (s >= 0) & (t >= 0) & (s + t <= 1)
    return (a[:, 2] + s * u[:, 2] + t * v[:, 2])[inside]


def has_ground(scene):
    """Whether any material of a scene is ground."""
    column = scene.GetFieldData().GetArray(MATERIAL_IS_GROUND)
    return column is not None and any(
        column.GetTuple1(i) for i in range(column.GetNumberOfTuples())
    )


def warn_of_roofs(plan):
    """A warning of positions on roofs, or None. Scenes with ground materials have none there."""
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
    count = f"{len(raised)} of {len(plan.positions)} positions"
    return (
        f"{count} {'stand' if len(raised) > 1 else 'stands'} above another surface, as on a roof: "
        f"position {index + 1} at ({x:.2f}, {y:.2f}, {z:.2f}), {distance:.2f} m above it. No material "
        "of the scene is ground: give helios_isGround true to those of the ground in the .mtl file, or "
        "leave the roof out with --exclude (exclude=)"
    )
