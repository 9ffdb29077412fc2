# SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
# SPDX-License-Identifier: BSD-3-Clause
"""The stand of vtkhelios new --kind forest: trees from a table, undergrowth as turbid voxels."""

import numpy as np

from ._meshes import Mesh, make_grid, write_tree
from ._tables import scatter, write_table

SIDE = 70.0
POSITIONS = ((0.0, 0.0), (14.0, 9.0), (-12.0, 11.0))  # positions of the scanner
MODELS = {
    "spruce_1": ("Conifer", 21, 18.0, 1200),
    "spruce_2": ("Conifer", 22, 15.0, 1200),
    "beech": ("Broadleaf", 23, 16.0, 1200),
}
VOXEL = 0.5  # [m]
CORNER = (-31.0, -29.0, -5.0)  # corner of the grid
CELLS = (40, 32, 14)


def write_geometry(folder):
    ground = Mesh()
    x, y = make_grid(SIDE, SIDE, 71, 71)
    ground.add_grid("soil", x, y, height_at(x, y))
    ground.write(folder / "ground.obj")
    for name, (species, seed, height, leaves) in MODELS.items():
        write_tree(folder / f"{name}.obj", species, seed, height, leaves)
    places = scatter(90, SIDE - 6.0, SIDE - 6.0, 3.8, 4, _is_free)
    rows = ((f"tree{number:02d}", x, y) for number, (x, y) in enumerate(places, 1))
    write_table(folder / "stand.csv", ("id", "x", "y"), rows)
    _write_undergrowth(folder / "undergrowth.vox")


def height_at(x, y):
    """Returns the height of the ground [m]: a slope, with bumps."""
    return 0.08 * x + 0.4 * np.sin(x / 3.1) * np.cos(y / 2.7) + 0.8 * np.sin(y / 13.0)


def _is_free(x, y):
    return all(np.hypot(x - px, y - py) > 2.5 for px, py in POSITIONS)


def _write_undergrowth(path):
    """Leaves up to 1.2 m above the ground, in patches; PAD falls with the height."""
    index = np.stack(np.meshgrid(*map(np.arange, CELLS), indexing="ij"), axis=-1).reshape(-1, 3)
    x, y, z = (np.array(CORNER) + VOXEL * (index + 0.5)).T
    above = z - height_at(x, y)
    patch = np.sin(x / 2.3 + 1.0) * np.sin(y / 1.9) > 0.1
    density = np.where(patch & (above > -VOXEL / 2) & (above < 1.2), 2.5 * (1.2 - above), 0.0)
    lines = [
        "VOXEL SPACE",
        "#min_corner: {} {} {}".format(*CORNER),
        "#max_corner: {} {} {}".format(*(low + VOXEL * cells for low, cells in zip(CORNER, CELLS))),
        "#split: {} {} {}".format(*CELLS),
        f"#res: {VOXEL} #max_pad: {density.max():.3f}",
        "i j k PadBVTotal",
        *(f"{i} {j} {k} {pad:.3f}" for (i, j, k), pad in zip(index, density) if pad > 0.0),
    ]
    path.write_text("\n".join(lines) + "\n", encoding="utf-8")
