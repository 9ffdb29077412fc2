# SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
# SPDX-License-Identifier: BSD-3-Clause
"""Boxes of the objects that a scan has echoes of: from the scene at rest and the motion of echoes."""

import dataclasses
import hashlib
import pathlib

import numpy as np
from vtkmodules.util.numpy_support import vtk_to_numpy

from ..array_names import (
    GPS_TIME, PART_IDS, PART_NAME, PART_ORIENTATION, PART_POSITION, PART_VELOCITY,
)  # fmt: skip
from ..formats import FormatError, Header
from ._parts import SLOWEST
from ..core.rotation import matrix_of

OBJECTS = {10, 11, 13, 15, 16, 18, 20, 30, 31, 32}  # labels that have boxes: vehicles and persons


@dataclasses.dataclass
class Box:
    """An object in the coordinates of the run, when its middle echo of the scan was made."""

    part: int
    label: int  #: at rest
    center: np.ndarray  #: [m]
    axes: np.ndarray  #: columns: forward, left, up; 3 x 3
    size: np.ndarray  #: length, width, height [m]
    moves: bool
    points: int  #: echoes of the scan

    def within(self, pose):
        """Returns the center and axes in the frame of a pose."""
        turn = pose[:3, :3].T
        return turn @ (self.center - pose[:3, 3]), turn @ self.axes


class Boxes:
    """The objects of a scene (vtkPolyData) at rest; parts: see Parts; moves: whether any of them does."""

    def __init__(self, scene, parts, labels, moves=False):
        self._parts, self._moves = parts, moves
        self._corners, self._centroids = {}, {}
        names = Header(scene.GetFieldData()).texts(PART_NAME)
        if names[: len(parts.names)] != parts.names:
            raise FormatError(
                f"the scene has {_first_unlike(names, parts.names)}; give the survey of the run"
            )
        points = vtk_to_numpy(scene.GetPoints().GetData()).astype(float)
        triangles = vtk_to_numpy(scene.GetPolys().GetConnectivityArray()).reshape(-1, 3)
        ids = vtk_to_numpy(scene.GetCellData().GetArray(PART_IDS))
        self._labels = {
            number: label
            for number in np.unique(ids).tolist()
            if number == parts.root_of(number)
            and (label := labels.find_part(number, parts)) in OBJECTS
        }
        roots = parts.find_roots({PART_IDS: ids})
        for number in self._labels:
            own = points[triangles[ids == number]]
            self._centroids[number] = _find_centroid(own)
            self._corners[number] = points[np.unique(triangles[roots == number])]

    def find(self, arrays):
        """Returns the boxes of the objects that have echoes, by part."""
        ids, roots = arrays.get(PART_IDS), self._parts.find_roots(arrays)
        if ids is None:
            raise FormatError(
                "boxes need PartIds, which the points do not have; run the survey again"
            )
        if self._moves and PART_POSITION not in arrays:
            raise FormatError(
                f"boxes of parts that move need {PART_POSITION}, which the points do not have; run the "
                "survey again with --format vtp --motion"
            )
        found = []
        for number in sorted(self._labels.keys() & set(np.unique(roots).tolist())):
            own = np.flatnonzero(ids == number)
            if len(own):
                middle = own[np.argsort(arrays[GPS_TIME][own], kind="stable")[len(own) // 2]]
                count = int(np.count_nonzero(roots == number))
                found.append(self._make_box(number, arrays, middle, count))
        return found

    def _make_box(self, number, arrays, row, count):
        turn, shift, velocity = np.eye(3), np.zeros(3), np.zeros(3)
        if PART_POSITION in arrays:
            turn = matrix_of(arrays[PART_ORIENTATION][row])
            shift, velocity = arrays[PART_POSITION][row], arrays[PART_VELOCITY][row]
        moves = bool(np.linalg.norm(velocity) > SLOWEST)
        axes = _find_axes(self._corners[number], turn.T @ velocity if moves else None)
        spans = self._corners[number] @ axes
        low, high = spans.min(axis=0), spans.max(axis=0)
        pivot = self._centroids[number]
        center = turn @ (axes @ ((low + high) / 2) - pivot) + pivot + shift
        label = self._labels[number]
        return Box(number, label, center, turn @ axes, high - low, moves, count)


def check_inputs(survey, summary):
    """Raises FormatError unless a survey file is that of a run, by its summary, and the files beside
    it are as they were."""
    survey = pathlib.Path(survey)
    inputs = {pathlib.Path(each["file"]): each["sha256"] for each in summary.get("inputs", [])}
    base = next((path.parent for path in inputs if path.name == survey.name), None)
    if base is None:
        raise FormatError(f"{survey}: is not the survey of the run; give that one")
    for path, digest in inputs.items():
        file = survey.parent / path.relative_to(base) if path.is_relative_to(base) else path
        if file.is_file() and hashlib.sha256(file.read_bytes()).hexdigest() != digest:
            raise FormatError(f"{file}: has changed since the run; run the survey again")


def _first_unlike(names, expected):
    """Describes the first part with another name."""
    for number, name in enumerate(expected):
        if number >= len(names):
            return f"no part {number}, which is {name} in the run"
        if names[number] != name:
            return f"part {number} {names[number]}, which is {name} in the run"
    return "other parts"


def _find_centroid(corners):
    """Returns the centroid of the area of triangles (n x 3 x 3)."""
    areas = np.linalg.norm(
        np.cross(corners[:, 1] - corners[:, 0], corners[:, 2] - corners[:, 0]), axis=1
    )
    return np.average(corners.mean(axis=1), axis=0, weights=areas)


def _find_axes(points, velocity):
    """Returns the axes forward, left, up of the upright box with the least area of its floor.

    Forward is the axis nearest to the velocity, of what does not move the longer one.
    """
    hull = _find_hull(points[:, :2])
    edges = np.diff(np.vstack([hull, hull[:1]]), axis=0)
    lengths = np.linalg.norm(edges, axis=1)
    edges = edges[lengths > 0] / lengths[lengths > 0, np.newaxis]
    if not len(edges):
        edges = np.array([[1.0, 0.0]])
    across = np.column_stack([-edges[:, 1], edges[:, 0]])
    along_span, across_span = np.ptp(hull @ edges.T, axis=0), np.ptp(hull @ across.T, axis=0)
    least = int(np.argmin(along_span * across_span))
    forward = edges[least] if along_span[least] >= across_span[least] else across[least]
    if velocity is not None and np.hypot(*velocity[:2]) > 0:
        turned = np.array([forward, [-forward[1], forward[0]]])
        turned = np.vstack([turned, -turned])
        forward = turned[int(np.argmax(turned @ velocity[:2]))]
    x, y = forward
    return np.array([[x, -y, 0.0], [y, x, 0.0], [0.0, 0.0, 1.0]])


def _find_hull(points):
    """Returns the convex hull of points in a plane, anticlockwise (Andrew's monotone chain)."""
    points = np.unique(points, axis=0)
    if len(points) < 3:
        return points
    return np.array(_half_hull(points)[:-1] + _half_hull(points[::-1])[:-1])


def _half_hull(points):
    kept = []
    for point in points:
        while len(kept) > 1 and _turns_right(kept[-2], kept[-1], point):
            kept.pop()
        kept.append(point)
    return kept


def _turns_right(a, b, c):
    return (b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0]) <= 0
