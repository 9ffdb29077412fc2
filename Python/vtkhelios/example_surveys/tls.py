# SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
# SPDX-License-Identifier: BSD-3-Clause
"""The house and its yard of vtkhelios new --kind tls."""

import numpy as np

from ._meshes import Mesh, make_grid, write_house, write_tree

SIDE = 60.0  # side of the yard [m]
WALL = 2.0  # height [m]


def write_geometry(folder):
    ground = Mesh()
    x, y = make_grid(SIDE, SIDE, 31, 31)
    ground.add_grid("grass", x, y, height_at(x, y))
    ground.write(folder / "ground.obj")
    _make_path().write(folder / "path.obj")
    _make_wall().write(folder / "wall.obj")
    write_house(folder / "house.obj", 12.0, 8.0)
    write_tree(folder / "tree.obj", "Broadleaf", 1, 8.0, 1500)


def height_at(x, y):
    """Returns the height of the ground [m]: level near the house, which is at the origin."""
    distance = np.hypot(x, y)
    return 0.8 * np.clip((distance - 12.0) / 20.0, 0.0, 1.0) * np.sin(x / 9.0) * np.cos(y / 11.0)


def _make_path():
    """2 m wide, from the door to the east, 3 cm above the grass."""
    along, across = np.meshgrid(np.linspace(4.0, 29.0, 26), (-1.0, 1.0))
    path = Mesh()
    path.add_grid("paving", along, across, height_at(along, 0.0 * along) + 0.03)
    return path


def _make_wall():
    """Around the yard, open to the east, where the path leaves."""
    wall, half, gap = Mesh(), SIDE / 2 - 2.0, 2.0
    foot = -1.0  # below the ground
    west_east = ((-half, -0.15, foot), (half, 0.15, WALL))
    south_north = ((-0.15, -half, foot), (0.15, half, WALL))
    wall.add_box("brick", (0.0, half, 0.0), *west_east)
    wall.add_box("brick", (0.0, -half, 0.0), *west_east)
    wall.add_box("brick", (-half, 0.0, 0.0), *south_north)
    for low, high in ((-half, -gap), (gap, half)):
        wall.add_box("brick", (half, 0.0, 0.0), (-0.15, low, foot), (0.15, high, WALL))
    return wall
