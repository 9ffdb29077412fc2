# SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
# SPDX-License-Identifier: BSD-3-Clause
"""The river of vtkhelios new --kind river: terrain, a bed of gravel, water and a bridge."""

import numpy as np

from ._geotiff import write_geotiff
from ._meshes import Mesh, write_tree
from ._tables import scatter, write_table

WEST, SOUTH = 432_000.0, 5_405_000.0  # [m], UTM zone 32
WIDTH, DEPTH, PIXEL = 300.0, 160.0, 1.0
WATER = 250.0  # height of its surface [m]
HALF = 11.0  # half the width of the river
BRIDGE = 190.0  # its x
EPSG = 25832


def write_geometry(folder):
    x = (np.arange(int(WIDTH / PIXEL)) + 0.5) * PIXEL
    y = DEPTH - (np.arange(int(DEPTH / PIXEL)) + 0.5) * PIXEL
    heights = height_at(*np.meshgrid(x, y))
    write_geotiff(folder / "terrain.tif", heights, WEST, SOUTH + DEPTH, PIXEL, EPSG)
    _make_water().write(folder / "water.obj")
    _make_bed().write(folder / "bed.obj")
    _make_bridge().write(folder / "bridge.obj")
    write_tree(folder / "willow.obj", "Broadleaf", 31, 7.0, 1800, 6.0)
    write_tree(folder / "bush.obj", "Shrub", 32, 1.6, 600)
    write_table(folder / "willows.csv", ("x", "y"), _place(26, 8.0, 1, HALF + 4.0, HALF + 22.0))
    write_table(folder / "bushes.csv", ("x", "y"), _place(70, 2.5, 2, HALF + 2.0, HALF + 10.0))


def middle_at(x):
    """Returns the y of the middle of the river [m]."""
    return DEPTH / 2 + 16.0 * np.sin(x / 45.0)


def distance_at(x, y):
    """From the middle of the river, approximately [m]."""
    slope = 16.0 / 45.0 * np.cos(x / 45.0)
    return np.abs(y - middle_at(x)) / np.hypot(1.0, slope)


def height_at(x, y):
    """Returns the height of the terrain [m]: the bed, 2 m below the water, banks, and a valley that
    rises to its sides."""
    distance = distance_at(x, y)
    bank = -2.0 + 3.6 / (1.0 + np.exp(-(distance - HALF) / 1.2))
    valley = 0.0025 * np.maximum(distance - 20.0, 0.0) ** 2
    return WATER + bank + valley + 0.15 * np.sin(x / 3.0) * np.cos(y / 4.0)


def _make_water():
    """Returns a level surface, whose edges are inside the banks."""
    x = np.linspace(0.5, WIDTH - 0.5, 120)
    across = np.linspace(-HALF - 5.0, HALF + 5.0, 9)[:, None]
    water = Mesh()
    y = middle_at(x) + across
    x, z = np.broadcast_to(x, y.shape), np.full(y.shape, WATER)
    water.add_grid("water", WEST + x, SOUTH + y, z)
    return water


def _make_bed():
    """Gravel over the terrain between the banks, with stones; its edges are below the terrain."""
    random = np.random.default_rng(3)
    x = np.linspace(0.5, WIDTH - 0.5, 300)
    across = np.linspace(-HALF, HALF, 23)[:, None]
    y = middle_at(x) + across
    x = np.broadcast_to(x, y.shape)
    rise = 0.12 - 0.4 * (np.abs(across) / HALF) ** 8
    z = height_at(x, y) + rise + random.uniform(-0.05, 0.05, y.shape)
    bed = Mesh()
    bed.add_grid("gravel", WEST + x, SOUTH + y, z)
    for _ in range(60):
        along, aside = random.uniform(5.0, WIDTH - 5.0), random.uniform(-0.8, 0.8) * HALF
        size, heading = random.uniform(0.2, 0.7), random.uniform(0.0, 90.0)
        y = middle_at(along) + aside
        place = (WEST + along, SOUTH + y, height_at(along, y))
        bed.add_box("gravel", place, (-size, -size, 0.0), (size, size, size), heading)
    return bed


def _make_bridge():
    """Returns a road on a slab with two piers and railings, along y."""
    bridge, place = Mesh(), (WEST + BRIDGE, SOUTH + float(middle_at(BRIDGE)), WATER)
    reach = HALF + 14.0
    bridge.add_box("asphalt", place, (-3.0, -reach, 4.0), (3.0, reach, 4.1))
    bridge.add_box("concrete", place, (-3.6, -reach, 3.3), (3.6, reach, 4.0))
    for y in (-5.0, 5.0):
        bridge.add_box("concrete", place, (-2.5, y - 0.5, -3.0), (2.5, y + 0.5, 3.3))
    for y in (-reach, reach):
        bridge.add_box("concrete", place, (-3.6, y - 1.5, -2.0), (3.6, y + 1.5, 3.3))
    for x in (-3.4, 3.4):
        bridge.add_box("metal", place, (x - 0.03, -reach, 4.95), (x + 0.03, reach, 5.0))
        for y in np.arange(-reach, reach + 0.1, 2.5):
            bridge.add_box("metal", place, (x - 0.03, y - 0.03, 4.0), (x + 0.03, y + 0.03, 4.95))
    return bridge


def _place(count, spacing, seed, nearest, farthest):
    """Places on the banks, at these distances from the middle, and not below the bridge."""

    def is_free(x, y):
        distance = distance_at(x + WIDTH / 2, y + DEPTH / 2)
        return nearest < distance < farthest and abs(x + WIDTH / 2 - BRIDGE) > 8.0

    for x, y in scatter(count, WIDTH - 12.0, DEPTH - 12.0, spacing, seed, is_free):
        yield WEST + WIDTH / 2 + x, SOUTH + DEPTH / 2 + y
