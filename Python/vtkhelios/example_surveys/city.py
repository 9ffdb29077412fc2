# SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
# SPDX-License-Identifier: BSD-3-Clause
"""The blocks of houses of vtkhelios new --kind city, as CityJSON 2.0 (LoD 2)."""

import json

import numpy as np

from ._meshes import write_tree
from ._tables import write_table

WEST, SOUTH, HEIGHT = 500_000.0, 5_480_000.0, 110.0  # corner and height of the ground [m]
BLOCKS = (3, 2)  # along x and y
BLOCK = (48.0, 40.0)  # size of a block [m]
STREET = 14.0
DEPTH, WIDTH = 11.0, 12.0  # size of a house


class City:
    """City objects that share their vertices."""

    def __init__(self):
        self._objects, self._indices = {}, {}

    def add(self, name, kind, geometry, **attributes):
        """Adds an object; geometry is made by make_surfaces() or make_solid()."""
        self._objects[name] = {"type": kind, "attributes": attributes, "geometry": [geometry]}

    def index(self, points):
        """Returns the numbers of points [m], in whole millimetres from the south-western corner."""
        keys = [tuple(round(1000 * value) for value in point) for point in points]
        return [self._indices.setdefault(key, len(self._indices)) for key in keys]

    def make_surfaces(self, kind, polygons):
        """Returns a MultiSurface of one kind of surface."""
        return {
            "type": "MultiSurface",
            "lod": "2",
            "boundaries": [[self.index(polygon)] for polygon in polygons],
            "semantics": {"surfaces": [{"type": kind}], "values": [0] * len(polygons)},
        }

    def make_solid(self, polygons):
        """Returns a Solid of (kind, polygon) pairs."""
        kinds = sorted({kind for kind, _ in polygons})
        return {
            "type": "Solid",
            "lod": "2",
            "boundaries": [[[self.index(polygon)] for _, polygon in polygons]],
            "semantics": {
                "surfaces": [{"type": kind} for kind in kinds],
                "values": [[kinds.index(kind) for kind, _ in polygons]],
            },
        }

    def write(self, path):
        document = {
            "type": "CityJSON",
            "version": "2.0",
            "transform": {"scale": [0.001, 0.001, 0.001], "translate": [WEST, SOUTH, HEIGHT]},
            "metadata": {
                "referenceSystem": "https://www.opengis.net/def/crs/EPSG/0/25832",
                "title": "Example of vtkHelios",
            },
            "CityObjects": self._objects,
            "vertices": [list(key) for key in self._indices],
        }
        path.write_text(json.dumps(document, indent=1) + "\n", encoding="utf-8")


def write_geometry(folder):
    city = City()
    width, depth = (count * size + (count + 1) * STREET for count, size in zip(BLOCKS, BLOCK))
    ground = [(0, 0, 0), (width, 0, 0), (width, depth, 0), (0, depth, 0)]
    city.add("streets", "Road", city.make_surfaces("TrafficArea", [ground]))
    random_numbers = np.random.default_rng(6)
    trees = []
    for column in range(BLOCKS[0]):
        for row in range(BLOCKS[1]):
            x = STREET + column * (BLOCK[0] + STREET)
            y = STREET + row * (BLOCK[1] + STREET)
            _add_block(city, f"block{column + 1}{row + 1}", x, y, random_numbers)
            trees += [(WEST + x + t, SOUTH + y + BLOCK[1] / 2) for t in (10.0, 20.0, 33.0)]
    city.write(folder / "city.city.json")
    write_tree(folder / "tree.obj", "Broadleaf", 5, 9.0, 1500)
    write_table(folder / "trees.csv", ("x", "y"), trees)


def _add_block(city, name, x, y, random_numbers):
    """A courtyard with grass, and rows of four houses along its northern and southern sides."""
    court = [(x, y), (x + BLOCK[0], y), (x + BLOCK[0], y + BLOCK[1]), (x, y + BLOCK[1])]
    grass = [[(a, b, 0.1) for a, b in court]]
    city.add(f"{name}_court", "LandUse", city.make_surfaces("LandUse", grass))
    for side, south in (("south", y), ("north", y + BLOCK[1] - DEPTH)):
        for number in range(4):
            floors = int(random_numbers.integers(3, 7))
            solid = city.make_solid(
                _make_house(x + number * WIDTH, south, 3.2 * floors, 3.0 + 0.5 * (number % 3))
            )
            city.add(f"{name}_{side}{number + 1}", "Building", solid, storeysAboveGround=floors)


def _make_house(x, y, eaves, roof):
    """Returns the surfaces of a house with a gabled roof, its ridge along x; polygons face
    outwards."""
    east, north, middle, ridge = x + WIDTH, y + DEPTH, y + DEPTH / 2, eaves + roof
    return [
        ("GroundSurface", [(x, y, 0), (x, north, 0), (east, north, 0), (east, y, 0)]),
        ("WallSurface", [(x, y, 0), (east, y, 0), (east, y, eaves), (x, y, eaves)]),
        ("WallSurface", [(east, north, 0), (x, north, 0), (x, north, eaves), (east, north, eaves)]),
        (
            "WallSurface",
            [(x, north, 0), (x, y, 0), (x, y, eaves), (x, middle, ridge), (x, north, eaves)],
        ),
        (
            "WallSurface",
            [
                (east, y, 0),
                (east, north, 0),
                (east, north, eaves),
                (east, middle, ridge),
                (east, y, eaves),
            ],
        ),
        (
            "RoofSurface",
            [(x, y, eaves), (east, y, eaves), (east, middle, ridge), (x, middle, ridge)],
        ),
        (
            "RoofSurface",
            [(east, north, eaves), (x, north, eaves), (x, middle, ridge), (east, middle, ridge)],
        ),
    ]
