# SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
# SPDX-License-Identifier: BSD-3-Clause
"""The street of vtkhelios new --kind mls, and the trajectory of the car."""

import numpy as np

from ._meshes import Mesh, write_tree
from ._tables import write_table

LENGTH = 90.0  # length of the street, along x [m]
KERB = 3.5  # half the width of the roadway
FRONT = 7.0  # front of the houses
CARS = [(-28.0, -1), (-12.0, 1), (-6.0, 1), (9.0, -1), (21.0, 1)]  # x, side


def write_geometry(folder):
    make_street().write(folder / "street.obj")
    make_houses().write(folder / "houses.obj")
    _make_furniture().write(folder / "furniture.obj")
    write_tree(folder / "tree.obj", "Broadleaf", 3, 6.0, 1200, 3.5)
    write_table(
        folder / "trees.csv", ("x", "y"), ((x, 5.8) for x in np.arange(-32.0, 40.0, 16.0).tolist())
    )
    names = ("t", "roll", "pitch", "yaw", "x", "y", "z")
    rows = [f'#HEADER: {", ".join(f"{chr(34)}{name}{chr(34)}" for name in names)}']
    rows += [", ".join(f"{value:.4f}" for value in row) for row in make_trajectory()]
    (folder / "trajectory.csv").write_text("\n".join(rows) + "\n", encoding="utf-8")


def make_trajectory():
    """Returns the rows t [s], roll, pitch, yaw [deg], x, y, z [m], 100 per second.

    The car changes the lane with a cosine, at 15 m/s along the street. It heads along its way; the
    road's unevenness is a roll and a pitch of some tenths of a degree.
    """
    time = np.arange(0.0, 4.0 + 1e-9, 0.01)
    x = -30.0 + 15.0 * time
    y = -1.6 + 0.8 * (1.0 - np.cos(np.pi * time / 4.0))
    slope = 0.8 * np.pi / 4.0 * np.sin(np.pi * time / 4.0) / 15.0
    yaw = 90.0 - np.degrees(np.arctan(slope))  # clockwise from north
    roll, pitch = 0.3 * np.sin(2.1 * time), 0.2 * np.sin(5.3 * time)
    return np.stack([time, roll, pitch, yaw, x, y, 0.0 * time], axis=1)


def make_street():
    street, half = Mesh(), LENGTH / 2
    x, y = np.meshgrid((-half, half), (-KERB, 0.0, KERB))
    street.add_grid("asphalt", x, y, np.array([[0.0, 0.0], [0.05, 0.05], [0.0, 0.0]]))
    for side in (-1, 1):
        low, high = sorted((side * KERB, side * (FRONT + 14.0)))
        street.add_box("paving", (0.0, 0.0, 0.0), (-half, low, -0.2), (half, high, 0.12))
    return street


def make_houses():
    """Two rows of houses; each front has windows 0.15 m deep."""
    houses = Mesh()
    for side in (-1, 1):
        for number, x in enumerate(np.arange(-LENGTH / 2, LENGTH / 2 - 1.0, 15.0)):
            material = ("plaster", "brick")[(number + (side > 0)) % 2]
            floors = 2 + (number * 3 + side) % 3
            _add_house(houses, material, float(x) + 0.1, 14.8, side, floors)
    return houses


def _add_house(houses, material, x, width, side, floors):
    top = 3.2 * floors + 0.5
    near, far = side * (FRONT + 0.15), side * (FRONT + 11.0)
    low, high = sorted((near, far))
    houses.add_box(material, (x, 0.0, 0.0), (0.0, low, 0.0), (width, high, top))
    low, high = sorted((near - side * 0.02, near))
    houses.add_box("glass", (x, 0.0, 0.0), (0.5, low, 0.5), (width - 0.5, high, top - 0.5))
    for left, right, bottom, upper in _find_walls(width, floors, top):
        front = sorted((side * FRONT, near))
        houses.add_box(material, (x, 0.0, 0.0), (left, front[0], bottom), (right, front[1], upper))
    middle, ridge = (near + far) / 2, top + 3.5
    near = side * (FRONT - 0.4)
    points = [
        (x + a, b, c) for a in (0.0, width) for b, c in ((near, top), (middle, ridge), (far, top))
    ]
    houses.add("tiles", points, [(0, 3, 4, 1), (1, 4, 5, 2), (0, 1, 2), (3, 5, 4)])


def _find_walls(width, floors, top):
    """Yields the boxes of a front: pillars beside windows of 1.4 m by 1.6 m, and bands between the
    floors."""
    sills = [3.2 * floor + 1.1 for floor in range(floors)]
    levels = [0.0, *(level for sill in sills for level in (sill, sill + 1.6)), top]
    for bottom, upper in zip(levels[::2], levels[1::2]):
        yield 0.0, width, bottom, upper
    edges = [0.0, *(e for k in range(4) for e in (1.4 + 3.5 * k, 2.8 + 3.5 * k)), width]
    for sill in sills:
        for left, right in zip(edges[::2], edges[1::2]):
            yield left, right, sill, sill + 1.6


def _make_furniture():
    """Parked cars and lamp posts."""
    furniture = Mesh()
    for x, side in CARS:
        place = (x, side * (KERB - 1.0), 0.0)
        furniture.add_box("metal", place, (-2.1, -0.85, 0.25), (2.1, 0.85, 0.85))
        furniture.add_box("glass", place, (-1.3, -0.75, 0.85), (0.9, 0.75, 1.45))
        for wheel in (-1.35, 1.35):
            furniture.add_box("metal", place, (wheel - 0.3, -0.8, 0.0), (wheel + 0.3, 0.8, 0.3))
    for x in np.arange(-40.0, 41.0, 20.0):
        place = (float(x), -KERB - 0.6, 0.12)
        furniture.add_box("metal", place, (-0.06, -0.06, 0.0), (0.06, 0.06, 6.0))
        furniture.add_box("metal", place, (-0.12, -0.1, 5.9), (0.12, 1.3, 6.05))
    return furniture
