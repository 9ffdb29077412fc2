# SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
# SPDX-License-Identifier: BSD-3-Clause
"""Meshes of the example surveys as OBJ files."""

import numpy as np

from ..core.paths import to_vtk
from ..core.pipeline import update
from ..vtkHeliosFiltersIO import vtkHeliosObjSceneWriter
from ..vtkHeliosFiltersScene import vtkHeliosSyntheticScene

# Colours of the materials of synthetic trees and houses: red, green, blue.
_COLOURS = {
    "bark": (0.36, 0.27, 0.19), "leaf": (0.27, 0.45, 0.17), "plaster": (0.85, 0.82, 0.75),
    "window": (0.20, 0.24, 0.28), "wood": (0.55, 0.42, 0.30), "roof": (0.55, 0.25, 0.20),
    "brick": (0.62, 0.33, 0.26),
}  # fmt: skip
_BOX = [(0, 2, 3, 1), (4, 5, 7, 6), (0, 1, 5, 4), (2, 6, 7, 3), (0, 4, 6, 2), (1, 3, 7, 5)]


class Mesh:
    """Polygons with materials of materials.mtl, in the order in which they are added."""

    def __init__(self):
        self._lines, self._count = ["mtllib materials.mtl"], 0

    def add(self, material, points, faces):
        """Adds points (n x 3) [m], and faces: indices of these points, anticlockwise from outside."""
        self._lines.append(f"usemtl {material}")
        self._lines += ["v {:.3f} {:.3f} {:.3f}".format(*point) for point in points]
        first = self._count + 1
        self._lines += ["f " + " ".join(str(first + corner) for corner in face) for face in faces]
        self._count += len(points)

    def add_grid(self, material, x, y, z):
        """Adds a surface of points in rows: x, y and z are arrays of one shape (rows, columns)."""
        rows, columns = x.shape
        corner = np.arange((rows - 1) * columns).reshape(rows - 1, columns)[:, :-1].ravel()
        faces = np.stack([corner, corner + 1, corner + columns + 1, corner + columns], axis=1)
        self.add(material, np.stack([x.ravel(), y.ravel(), z.ravel()], axis=1), faces)

    def add_box(self, material, place, low, high, heading=0.0):
        """Adds a box from low to high, rotated anticlockwise by heading [deg] and moved to place."""
        cosine, sine = np.cos(np.radians(heading)), np.sin(np.radians(heading))
        corners = [
            (place[0] + cosine * x - sine * y, place[1] + sine * x + cosine * y, place[2] + z)
            for z in (low[2], high[2])
            for y in (low[1], high[1])
            for x in (low[0], high[0])
        ]
        self.add(material, corners, _BOX)

    def write(self, path):
        path.write_text("\n".join(self._lines) + "\n", encoding="utf-8")


def make_grid(width, depth, columns, rows):
    """Returns the x and y of a grid about the origin, arrays of (rows, columns)."""
    return np.meshgrid(
        np.linspace(-width / 2, width / 2, columns), np.linspace(-depth / 2, depth / 2, rows)
    )


def write_tree(path, species, seed, height, leaves, crown=0.0):
    """Writes a tree with the given number of leaves; species is Broadleaf, Conifer or Shrub.

    height and diameter of the crown are in metres; a crown of 0 is in proportion to the height.
    """
    tree = vtkHeliosSyntheticScene()
    tree.SetKindToTree()
    getattr(tree, f"SetSpeciesTo{species}")()
    tree.SetSeed(seed)
    tree.SetHeight(height)
    tree.SetSize(crown)
    tree.SetNumberOfLeaves(leaves)
    _write_synthetic(path, tree)


def write_house(path, length, height):
    """Writes a house with a gabled roof: its length along y, and the height of the ridge [m]."""
    house = vtkHeliosSyntheticScene()
    house.SetKindToHouse()
    house.SetSize(length)
    house.SetHeight(height)
    _write_synthetic(path, house)


def _write_synthetic(path, source):
    writer = vtkHeliosObjSceneWriter()
    writer.SetFileName(to_vtk(path))
    writer.SetInputDataObject(update(source))
    if not writer.Write():
        raise OSError(f"{path}: cannot be written")
    _write_colours(path.with_suffix(".mtl"))


def _write_colours(path):
    """Sets Kd of the materials that have a colour; they have no specular lobe."""
    lines, name = [], None
    for line in path.read_text(encoding="utf-8").splitlines():
        name = line.split(" ", 1)[1] if line.startswith("newmtl ") else name
        if line.startswith("Kd ") and name in _COLOURS:
            line = "Kd {} {} {}".format(*_COLOURS[name])
        lines.append(line)
    path.write_text("\n".join(lines) + "\n", encoding="utf-8")
