# SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
# SPDX-License-Identifier: BSD-3-Clause
"""Planes found in both clouds: their noise, their signed offset, and the shift that explains it.

Of each cell both clouds give equally many points, drawn at random from the denser one: few points
find a plane more easily than many, so that the metrics would hang on the density otherwise. Two grids of cubes, one half a cell from the other along each axis; a plane counts in the grid in
whose cell it is central, so that no cell face cuts its noise off.
"""

import typing

import numpy as np

from ._ground import box_of, cells_of

FEWEST = 10  # points of a cell
FLAT = 0.2  # largest RMS normal to the plane over that along its shorter side
WIDE = 0.15  # smallest RMS along the shorter side over the cell; of a whole cell it is 0.289
PARALLEL = np.cos(np.radians(15.0))  # normals of both clouds
DETERMINED = 0.01  # smallest mean square of a component of the normals, for the shift
OUTLIER = 3.0 * 1.4826  # multiple of the median absolute residual
ROUNDS = 5


class Cells(typing.NamedTuple):
    """Cells with enough points of both clouds."""

    numbers: np.ndarray
    counts: np.ndarray
    centre: np.ndarray  #: of the points, from the centre of the cell [m]
    normal: np.ndarray
    squares: np.ndarray  #: sum of the squared distances from the plane [m²]
    is_flat: np.ndarray
    is_central: np.ndarray  #: whether the plane is in the middle half of the cell
    tiles: np.ndarray


class Planes(typing.NamedTuple):
    """Cells that are planar in both clouds."""

    tiles: np.ndarray
    squares: tuple  #: of both [m²]
    freedom: tuple  #: points less three
    offset: np.ndarray  #: from A to B along the normal [m]
    normal: np.ndarray  #: upward; of vertical planes to larger y, or x
    planar: tuple  #: of the cells with enough points in both: whether planar, by cloud
    cells: np.ndarray  #: tiles of these cells

    @property
    def rms(self):
        """RMS normal to the plane [m], so that its median equals Gaussian noise."""
        found = []
        for squares, freedom in zip(self.squares, self.freedom):
            median = (1 - 2 / (9 * freedom)) ** 1.5  # median of chi over the root of the freedom
            found.append(np.sqrt(squares / freedom) / median)
        return found


def draw_equal(numbers, random):
    """Rows of equally many points of both clouds in each cell that has FEWEST of both."""
    known, index = np.unique(np.concatenate(numbers), return_inverse=True)
    parts = np.split(index, [len(numbers[0])])
    counts = np.minimum(*(np.bincount(part, minlength=len(known)) for part in parts))
    counts[counts < FEWEST] = 0
    found = []
    for part in parts:
        rows = random.permutation(np.flatnonzero(counts[part] > 0))
        rows = rows[np.argsort(part[rows], kind="stable")]
        cells = part[rows]
        rank = np.arange(len(rows)) - np.searchsorted(cells, cells)
        found.append(rows[rank < counts[cells]])
    return found


def find_cells(side, rows, numbers, size, offset):
    """Returns the Cells of some points, sorted by their cells."""
    known, first, index, counts = np.unique(
        numbers[rows], return_index=True, return_inverse=True, return_counts=True
    )
    points, total = side.points[rows], len(known)
    local = points - (np.floor(points / size + offset) + 0.5 - offset) * size
    centre = np.column_stack([np.bincount(index, local[:, k], total) for k in range(3)])
    centre = centre / counts[:, None]
    away = local - centre[index]
    moments = np.empty((total, 3, 3))
    for i in range(3):
        for j in range(i, 3):
            moments[:, i, j] = moments[:, j, i] = np.bincount(index, away[:, i] * away[:, j], total)
    spread, axes = np.linalg.eigh(moments / counts[:, None, None])
    normal = axes[:, :, 0]
    steep = np.abs(normal).argmax(axis=1)
    is_central = np.abs(centre[np.arange(total), steep]) <= size / 4
    flat = (spread[:, 0] <= FLAT**2 * spread[:, 1]) & (spread[:, 1] >= (WIDE * size) ** 2)
    squares = np.maximum(spread[:, 0], 0.0) * counts
    return Cells(known, counts, centre, normal, squares, flat, is_central,
                 side.tiles[rows[first]])  # fmt: skip


def find_planes(sides, size, random, on_step):
    """Returns the Planes of both grids."""
    parts = []
    box = box_of([side.points for side in sides], size)
    box = box[0], box[1] + 2
    for offset in (0.0, 0.5):
        on_step("planes", offset)
        numbers = [cells_of(side.points, size, *box, offset) for side in sides]
        rows = draw_equal(numbers, random)
        cells = [find_cells(*each, size, offset) for each in zip(sides, rows, numbers)]
        parts.append(_match(*cells))
    joined = [np.concatenate(each) for each in zip(*parts)]
    return Planes(joined[0], tuple(joined[1:3]), tuple(joined[3:5]), joined[5], joined[6],
                  tuple(joined[7:9]), joined[9])  # fmt: skip


def _match(first, second):
    """Returns the same cells of both clouds."""
    planar = first.is_flat, second.is_flat
    central = first.is_central & second.is_central
    cosine = (first.normal * second.normal).sum(axis=1)
    good = np.flatnonzero(planar[0] & planar[1] & central & (np.abs(cosine) >= PARALLEL))
    normal = first.normal[good] + np.sign(cosine[good])[:, None] * second.normal[good]
    normal /= np.linalg.norm(normal, axis=1, keepdims=True)
    normal *= _sign_of(normal)[:, None]
    offset = (normal * (second.centre[good] - first.centre[good])).sum(axis=1)
    return (
        first.tiles[good], first.squares[good], second.squares[good], first.counts[good] - 3.0,
        second.counts[good] - 3.0, offset, normal, *planar, first.tiles,
    )  # fmt: skip


def _sign_of(normal):
    """-1 for normals that point down; of vertical ones to smaller y, or x."""
    sign = np.sign(np.where(np.abs(normal[:, 2]) > 0.1, normal[:, 2], 0.0))
    for axis in (1, 0):
        other = np.sign(np.where(np.abs(normal[:, axis]) > 0.1, normal[:, axis], 0.0))
        sign = np.where(sign == 0, other, sign)
    return np.where(sign == 0, 1.0, sign)


def find_shift(planes, blocks):
    """Returns the shift of B against A by axis (Sampled, None: not determined), and the remaining
    RMS [m].

    Least squares of normal . shift = offset over the cells, without outliers.
    """
    normal = planes.normal
    axes = [k for k in range(3) if np.mean(normal[:, k] ** 2) >= DETERMINED]
    part = normal[:, axes]
    keep = np.ones(len(part), bool)
    for _ in range(ROUNDS):
        shift = np.linalg.lstsq(part[keep], planes.offset[keep], rcond=None)[0]
        rest = planes.offset - part @ shift
        spread = OUTLIER * np.median(np.abs(rest - np.median(rest)))
        keep = np.abs(rest) <= max(spread, 1e-9)
        if np.count_nonzero(keep) < max(FEWEST, len(keep) // 4):
            keep[:] = True
    tiles = planes.tiles[keep]
    products = part[keep][:, :, None] * part[keep][:, None, :]
    matrices = np.zeros((blocks.count, len(axes), len(axes)))
    vectors = np.zeros((blocks.count, len(axes)))
    np.add.at(matrices, tiles, products)
    np.add.at(vectors, tiles, part[keep] * planes.offset[keep][:, None])
    found = dict(zip(axes, blocks.solve(matrices, vectors)))
    return [found.get(k) for k in range(3)], float(np.sqrt(np.mean(rest[keep] ** 2)))
