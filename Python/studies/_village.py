# SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
# SPDX-License-Identifier: BSD-3-Clause
"""Buildings with known roof planes, and the geometry of convex polygons."""

import typing

import numpy as np

import vtkhelios

PITCH = 40.0  # m, between the centres of buildings

# The roofs: convex polygons, relative to a corner of the building, above its eaves; l long, w wide,
# t is the tangent of the slope.


def make_flat(l, w, t):
    return [[(0, 0, 0), (l, 0, 0), (l, w, 0), (0, w, 0)]]


def make_shed(l, w, t):
    return [[(0, 0, 0), (l, 0, 0), (l, w, t * w), (0, w, t * w)]]


def make_gable(l, w, t):
    a, b = (0, w / 2, t * w / 2), (l, w / 2, t * w / 2)
    return [[(0, 0, 0), (l, 0, 0), b, a], [(l, w, 0), (0, w, 0), a, b]]


def make_hip(l, w, t):
    a, b = (w / 2, w / 2, t * w / 2), (l - w / 2, w / 2, t * w / 2)
    corners = [(0, 0, 0), (l, 0, 0), (l, w, 0), (0, w, 0)]
    p, q, r, s = corners
    return [[p, q, b, a], [q, r, b], [r, s, a, b], [s, p, a]]


def make_ell(l, w, t):
    """Two gabled wings of the same width, both of length l, at a right angle."""
    w, k = w * 0.7, 0.35 * t * w
    outer, inner, corner = (0, 0, 0), (w, w, 0), (w / 2, w / 2, k)
    a, b = (l, w / 2, k), (w / 2, l, k)
    return [
        [outer, (l, 0, 0), a, corner],
        [(l, w, 0), inner, corner, a],
        [(0, l, 0), outer, corner, b],
        [inner, (w, l, 0), b, corner],
    ]


KINDS = {"flat": make_flat, "shed": make_shed, "gable": make_gable, "hip": make_hip, "L": make_ell}


class Village(typing.NamedTuple):
    """A scene of buildings on flat ground, and the planes of their roofs."""

    scene: vtkhelios.Scene
    polygons: list  # the corners of every plane [m]
    kinds: list  # building type of every plane
    cell_planes: np.ndarray  # the number of the plane for every triangle, -1: a wall or the ground
    half: float  # m, of its width


def make_village(rows=5, seed=1):
    """Rows of buildings, one of every kind per row; random sizes, slopes and headings."""
    random = np.random.default_rng(seed)
    half = PITCH * max(rows, len(KINDS)) / 2
    ground = np.array([(-1, -1, 0), (1, -1, 0), (1, 1, 0), (-1, 1, 0)]) * (half + 100.0)
    faces, planes, polygons, kinds = [ground], [-1], [], []
    for row, column in np.ndindex(rows, len(KINDS)):
        kind = list(KINDS)[column]
        place = PITCH * (np.array([column, row]) - [len(KINDS) / 2 - 0.5, rows / 2 - 0.5])
        roof = place_roof(KINDS[kind], place, random)
        for polygon in roof:
            faces.append(polygon)
            planes.append(len(polygons))
            polygons.append(polygon)
            kinds.append(kind)
        walls = make_walls(roof)
        faces += walls
        planes += [-1] * len(walls)
    points, triangles, cell_planes = np.concatenate(faces), [], []
    begin = 0
    for face, plane in zip(faces, planes):
        triangles += [(begin, begin + i, begin + i + 1) for i in range(1, len(face) - 1)]
        cell_planes += [plane] * (len(face) - 2)
        begin += len(face)
    is_ground = np.arange(len(triangles)) < 2
    scene = vtkhelios.Scene(points, triangles, reflectance=0.4, ground=is_ground)
    return Village(scene, polygons, kinds, np.array(cell_planes), half)


def place_roof(make, place, random):
    """The polygons of a roof at a position [m]."""
    length, width = random.uniform(14, 20), random.uniform(8, 12)
    slope, eaves, turn = random.uniform(20, 45), random.uniform(3.5, 8), random.uniform(0, 360)
    slope = 15.0 if make is make_shed else slope
    cos, sin = np.cos(np.radians(turn)), np.sin(np.radians(turn))
    rotation = np.array([(cos, -sin, 0), (sin, cos, 0), (0, 0, 1)])
    roof = [np.array(p, float) for p in make(length, width, np.tan(np.radians(slope)))]
    corners = np.concatenate(roof)
    middle = (corners.min(axis=0) + corners.max(axis=0)) / 2 * [1, 1, 0]
    return [(p - middle) @ rotation.T + [*place, eaves] for p in roof]


def make_walls(roof):
    """Walls below every edge with the roof on one side only."""
    edges = [(tuple(p[i - 1]), tuple(p[i])) for p in roof for i in range(len(p))]
    border = [(a, b) for a, b in edges if (b, a) not in edges]
    return [np.array([a, b, (*b[:2], 0), (*a[:2], 0)]) for a, b in border]


def normal_of(polygon):
    normal = np.cross(polygon[1] - polygon[0], polygon[2] - polygon[0])
    return normal / np.linalg.norm(normal) * np.sign(normal[2])


def find_inner(points, polygon, margin):
    """Returns whether points are inside a convex polygon by a margin, in plan view [m]."""
    inner = np.ones(len(points), bool)
    middle = polygon.mean(axis=0)[:2]
    for a, b in zip(np.roll(polygon, 1, axis=0)[:, :2], polygon[:, :2]):
        across = np.array([a[1] - b[1], b[0] - a[0]]) / np.linalg.norm(b - a)
        across *= np.sign((middle - a) @ across)
        inner &= (points[:, :2] - a) @ across > margin
    return inner


def cut(polygon, other):
    """Intersection of two convex polygons, counter-clockwise (I. Sutherland, G. Hodgman 1974)."""
    for a, b in zip(np.roll(other, 1, axis=0), other):
        side = np.cross(b - a, polygon - a)
        kept = []
        for i in range(len(polygon)):
            if side[i - 1] * side[i] < 0:
                share = side[i - 1] / (side[i - 1] - side[i])
                kept.append(polygon[i - 1] + share * (polygon[i] - polygon[i - 1]))
            if side[i] >= 0:
                kept.append(polygon[i])
        polygon = np.array(kept).reshape(-1, 2)
        if not len(polygon):
            break
    return polygon


def find_hull(points):
    """The convex hull of points in the plane, counter-clockwise (A. Andrew 1979)."""
    ordered = sorted(map(tuple, points.tolist()))
    hull = []
    for run in (ordered, ordered[::-1]):
        chain = []
        for x, y in run:
            while len(chain) > 1 and turn(*chain[-2:], (x, y)) <= 0:
                chain.pop()
            chain.append((x, y))
        hull += chain[:-1]
    return np.array(hull)


def turn(a, b, c):
    return (b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0])


def area_of(polygon):
    if len(polygon) < 3:
        return 0.0
    x, y = polygon[:, :2].T
    return 0.5 * float(np.roll(x, 1) @ y - np.roll(y, 1) @ x)


def outline(polygon):
    """A polygon in plan view, counter-clockwise."""
    flat = polygon[:, :2]
    return flat if area_of(flat) > 0 else flat[::-1]
