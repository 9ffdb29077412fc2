# SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
# SPDX-License-Identifier: BSD-3-Clause
"""The orchard of vtkhelios new --kind uls."""

import numpy as np

from ._meshes import Mesh, make_grid, write_tree
from ._tables import write_table

WIDTH, DEPTH = 100.0, 80.0
ROWS, TREES = 9, 16  # rows 6 m apart, trees 4 m apart


def write_geometry(folder):
    ground = Mesh()
    x, y = make_grid(WIDTH, DEPTH, 51, 41)
    ground.add_grid("grass", x, y, height_at(x, y))
    ground.write(folder / "ground.obj")
    write_tree(folder / "apple_1.obj", "Broadleaf", 11, 4.0, 1200, 3.2)
    write_tree(folder / "apple_2.obj", "Broadleaf", 12, 3.6, 1200, 3.0)
    write_table(folder / "trees.csv", ("id", "x", "y"), _place_trees())
    _make_fence().write(folder / "fence.obj")


def height_at(x, y):
    """Returns the height of the ground [m]: a slope with a hollow."""
    return 0.06 * y - 1.5 * np.exp(-((x - 15.0) ** 2 + y**2) / 500.0)


def _place_trees():
    for row in range(ROWS):
        for tree in range(TREES):
            if (row, tree) not in {(3, 5), (3, 6), (7, 12)}:  # gaps
                x, y = 4.0 * (tree - (TREES - 1) / 2), 6.0 * (row - (ROWS - 1) / 2)
                yield f"row{row + 1}_tree{tree + 1}", x, y


def _make_fence():
    """Posts 4 m apart along the southern edge, with three wires."""
    fence, y = Mesh(), -DEPTH / 2 + 6.0
    for x in np.arange(-40.0, 41.0, 4.0):
        post = ((-0.05, -0.05, -0.3), (0.05, 0.05, 1.5))
        fence.add_box("wood", (x, y, height_at(x, y)), *post)
        if x < 40.0:
            for z in (0.5, 0.9, 1.3):
                wire = ((0.0, -0.002, z - 0.002), (4.0, 0.002, z + 0.002))
                fence.add_box("metal", (x, y, height_at(x + 2.0, y)), *wire)
    return fence
