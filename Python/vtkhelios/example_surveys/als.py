# SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
# SPDX-License-Identifier: BSD-3-Clause
"""The hamlet in the hills of vtkhelios new --kind als, in UTM coordinates."""

import numpy as np

from ._geotiff import write_geotiff
from ._meshes import write_house, write_tree
from ._tables import scatter, write_table

WEST, SOUTH = 478_000.0, 5_472_000.0  # [m], UTM zone 32
WIDTH, DEPTH, PIXEL = 400.0, 320.0, 2.0
EPSG = 25832


def write_geometry(folder):
    columns, rows = int(WIDTH / PIXEL), int(DEPTH / PIXEL)
    x = (np.arange(columns) + 0.5) * PIXEL
    y = DEPTH - (np.arange(rows) + 0.5) * PIXEL
    heights = height_at(*np.meshgrid(x, y))
    write_geotiff(folder / "terrain.tif", heights, WEST, SOUTH + DEPTH, PIXEL, EPSG)
    write_house(folder / "house.obj", 12.0, 8.0)
    write_house(folder / "barn.obj", 20.0, 9.0)
    write_tree(folder / "broadleaf.obj", "Broadleaf", 1, 12.0, 1500)
    write_tree(folder / "conifer.obj", "Conifer", 2, 16.0, 1500)
    houses = scatter(9, 150.0, 110.0, 30.0, 7)
    write_table(folder / "buildings.csv", ("model", "x", "y", "yaw_deg"), _place_houses(houses))
    write_table(folder / "trees.csv", ("x", "y"), _place_trees(houses))


def height_at(x, y):
    """Returns the height of the terrain [m] at metres from the south-western corner."""
    hills = 9.0 * np.sin(x / 61.0 + 0.4) * np.cos(y / 47.0) + 4.0 * np.sin((x + y) / 29.0)
    return 212.0 + 0.03 * x + hills


def _place_houses(places):
    for number, (x, y) in enumerate(places):
        model = "barn" if number % 4 == 3 else "house"
        yield model, WEST + WIDTH / 2 + x, SOUTH + DEPTH / 2 + y, 40.0 * number % 180.0


def _place_trees(houses):
    def is_free(x, y):
        return all(abs(x - hx) > 15.0 or abs(y - hy) > 15.0 for hx, hy in houses)

    for x, y in scatter(120, WIDTH - 20.0, DEPTH - 20.0, 7.0, 8, is_free):
        yield WEST + WIDTH / 2 + x, SOUTH + DEPTH / 2 + y
