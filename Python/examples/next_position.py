# SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
# SPDX-License-Identifier: BSD-3-Clause
"""Scan, evaluate the array, choose the next position: without XML and without files.

A square with houses is scanned from one corner. The next scan position is the place with most
ground without echoes around it. Run it with

    build/venv/bin/python Python/examples/next_position.py
"""

import numpy as np

import vtkhelios

CELL = 1.0  # m, of the coverage raster
SIZE = 40  # m, half of the square
SETTINGS = dict(
    scanner="vz400_class_tls", scan_frequency=60, vertical=(-40, 60), head=(0, 360), head_speed=60
)


def make_box(x, y, width, height):
    """The corners and triangles of a house without a floor."""
    corners = [(x + i * width, y + j * width, k * height) for i, j, k in np.ndindex(2, 2, 2)]
    quads = [(0, 1, 3, 2), (4, 5, 7, 6), (0, 1, 5, 4), (2, 3, 7, 6), (1, 3, 7, 5)]
    return corners, [t for a, b, c, d in quads for t in ((a, b, c), (a, c, d))]


def make_scene(houses):
    """The square and its houses, as arrays."""
    s = SIZE
    points = [[(-s, -s, 0), (s, -s, 0), (s, s, 0), (-s, s, 0)]]
    triangles = [(0, 1, 2), (0, 2, 3)]
    for house in houses:
        corners, faces = make_box(*house)
        begin = sum(map(len, points))
        points.append(corners)
        triangles += [(a + begin, b + begin, c + begin) for a, b, c in faces]
    ground = np.arange(len(triangles)) < 2
    return vtkhelios.Scene(
        np.concatenate(points), triangles, reflectance=np.where(ground, 0.3, 0.6), ground=ground
    )


def cells_of(points):
    """The raster cells of the points on the ground, as a mask."""
    low = points[np.abs(points[:, 2]) < 0.1]
    n = int(2 * SIZE / CELL)
    index = np.clip(((low[:, :2] + SIZE) / CELL).astype(int), 0, n - 1)
    mask = np.zeros((n, n), bool)
    mask[index[:, 0], index[:, 1]] = True
    return mask


def next_position(missing):
    """The centre of the missing (free) cell with the most missing cells within 10 m."""
    x, y = np.nonzero(missing)
    near = (x[:, None] - x) ** 2 + (y[:, None] - y) ** 2 < (10 / CELL) ** 2
    best = near.sum(axis=1).argmax()
    return float((x[best] + 0.5) * CELL - SIZE), float((y[best] + 0.5) * CELL - SIZE)


def main():
    houses = [(-20, -20, 12, 6), (5, -15, 10, 8), (-10, 10, 15, 5), (15, 15, 8, 10)]
    scene = make_scene(houses)
    free = np.ones((int(2 * SIZE / CELL),) * 2, bool)  # ground outside houses
    for x, y, width, _ in houses:
        begin = [int((v + SIZE) / CELL) for v in (x, y)]
        free[begin[0] : begin[0] + int(width), begin[1] : begin[1] + int(width)] = False

    position, seen, shares = (-35.0, -35.0), np.zeros_like(free), []
    for scan in range(5):
        cloud = vtkhelios.scan(scene, position, seed=scan, **SETTINGS)
        seen |= cells_of(cloud.points)
        shares.append((seen & free).sum() / free.sum())
        x, y = position
        print(f"scan {scan} from {x:5.1f} {y:5.1f}: {len(cloud):,} points, {shares[-1]:.1%} seen")
        position = next_position(free & ~seen)
    return shares


if __name__ == "__main__":
    main()
