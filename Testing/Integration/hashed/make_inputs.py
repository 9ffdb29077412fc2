# SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
# SPDX-License-Identifier: BSD-3-Clause
"""Meshes, voxels, a picture and a pulse shape for the surveys of this folder: always the same bytes."""

import random

_FACES = [(1, 3, 4, 2), (5, 6, 8, 7), (1, 2, 6, 5), (3, 7, 8, 4), (1, 5, 7, 3), (2, 4, 8, 6)]


def write_inputs(folder):
    """Writes the files that the surveys name into a folder with copies of them."""
    _write_ground(folder / "ground.obj")
    _write_obj(folder / "box.obj", [("paint", _box((-0.5, -0.5, 0), (0.5, 0.5, 1.2)))])
    walls = [((-10, 6, -1), (-2, 6.4, 3)), ((3, 7, -1), (10, 7.5, 4)), ((9, -9, -1), (9.5, 6, 2.5))]
    _write_obj(folder / "walls.obj", [("brick", _box(*corners)) for corners in walls])
    _write_bush(folder / "bush.obj")
    _write_obj(
        folder / "optics.obj",
        [
            ("mirror", [[(-3, 4, 0), (-1, 4.5, 0), (-1, 4.5, 2.5), (-3, 4, 2.5)]]),
            ("window", [[(3, 0, 0), (3, 3, 0), (3, 3, 3), (3, 0, 3)]]),
            ("pond", [[(-4, -4, 0.4), (4, -4, 0.4), (4, -2, 0.4), (-4, -2, 0.4)]]),
            ("sign", [[(5, 5, 1), (5.6, 4.8, 1), (5.6, 4.8, 1.6), (5, 5, 1.6)]]),
            ("leaf", [[(1, 4, 0), (2, 4, 0), (2, 4.2, 2), (1, 4.2, 2)]]),
        ],
    )
    _write_voxels(folder / "leaves.vox")
    tiles = [f"{20 * x} {255 - 15 * y} {(37 * x * y) % 256}" for y in range(8) for x in range(8)]
    (folder / "tiles.ppm").write_text("P3\n8 8\n255\n" + "\n".join(tiles) + "\n")
    power = [0, 0.05, 0.3, 0.8, 1, 0.9, 0.6, 0.35, 0.2, 0.1, 0.04, 0]
    (folder / "shape.csv").write_text("".join(f"{i},{value}\n" for i, value in enumerate(power)))


def _box(low, high):
    corners = [
        (x, y, z) for z in (low[2], high[2]) for y in (low[1], high[1]) for x in (low[0], high[0])
    ]
    return [[corners[i - 1] for i in face] for face in _FACES]


def _write_obj(path, surfaces):
    """Surfaces are pairs of a material and polygons; texture coordinates repeat on each polygon."""
    lines, count = ["mtllib surfaces.mtl", "vt 0 0", "vt 2 0", "vt 2 2", "vt 0 2"], 0
    for material, polygons in surfaces:
        lines.append(f"usemtl {material}")
        for polygon in polygons:
            lines += ["v {} {} {}".format(*point) for point in polygon]
            lines.append(
                "f " + " ".join(f"{count + i + 1}/{i % 4 + 1}" for i in range(len(polygon)))
            )
            count += len(polygon)
    path.write_text("\n".join(lines) + "\n")


def _write_ground(path):
    """24 m a side, in squares of 1 m, with steps of up to 0.4 m."""
    height = [[((7 * x + 3 * y + x * y) % 9) * 0.05 - 0.3 for x in range(25)] for y in range(25)]
    polygons = [
        [
            (x - 12 + i, y - 12 + j, height[y + j][x + i])
            for i, j in ((0, 0), (1, 0), (1, 1), (0, 1))
        ]
        for y in range(24)
        for x in range(24)
    ]
    _write_obj(path, [("grass", polygons)])


def _write_bush(path):
    values = random.Random(11)
    polygons = []
    for _ in range(300):
        place = [values.uniform(-0.6, 0.6), values.uniform(-0.6, 0.6), values.uniform(0, 1.4)]
        sides = [[values.uniform(-0.08, 0.08) for _ in range(3)] for _ in range(2)]
        polygons.append(
            [
                tuple(round(p + i * a + j * b, 4) for p, a, b in zip(place, *sides))
                for i, j in ((0, 0), (1, 0), (1, 1), (0, 1))
            ]
        )
    _write_obj(path, [("leaf", polygons)])


def _write_voxels(path):
    lines = ["VOXEL SPACE", "#min_corner: 0 0 0", "#max_corner: 4 4 3", "#split: 8 8 6", "#res: 0.5 #max_pad: 4",
             "i j k PadBVTotal transmittance"]  # fmt: skip
    for k in range(6):
        for j in range(8):
            lines += [f"{i} {j} {k} {((i + 2 * j + 3 * k) % 7) * 0.4:.1f} 0.8" for i in range(8)]
    path.write_text("\n".join(lines) + "\n")
