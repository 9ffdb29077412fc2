# SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
# SPDX-License-Identifier: BSD-3-Clause
"""Rotation matrices and unit quaternions w, x, y, z."""

import numpy as np


def matrix_of(turn):
    """Returns the rotation matrix of a unit quaternion."""
    w, x, y, z = turn
    return np.array([
        [1 - 2 * (y * y + z * z), 2 * (x * y - w * z), 2 * (x * z + w * y)],
        [2 * (x * y + w * z), 1 - 2 * (x * x + z * z), 2 * (y * z - w * x)],
        [2 * (x * z - w * y), 2 * (y * z + w * x), 1 - 2 * (x * x + y * y)],
    ])  # fmt: skip


def quaternions_of(matrices):
    """Returns the unit quaternions, w >= 0, of rotation matrices (n x 3 x 3): the eigenvectors of
    Bar-Itzhack (2000), which are always stable."""
    (a, b, c), (d, e, f), (g, h, i) = np.moveaxis(np.asarray(matrices, float), 0, -1)
    k = np.array([
        [a - e - i, d + b, g + c, h - f], [d + b, e - a - i, h + f, c - g],
        [g + c, h + f, i - a - e, d - b], [h - f, c - g, d - b, a + e + i],
    ]) / 3.0  # fmt: skip
    turns = np.linalg.eigh(np.moveaxis(k, -1, 0))[1][:, [3, 0, 1, 2], -1]
    return np.where(turns[:, :1] >= 0, turns, -turns)


def quaternion_of(matrix):
    """Returns the unit quaternion of a rotation matrix as a list."""
    return quaternions_of(np.asarray(matrix)[np.newaxis])[0].tolist()
