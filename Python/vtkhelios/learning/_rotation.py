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


def quaternion_of(matrix):
    """Returns the unit quaternion, w >= 0, of a rotation matrix: the eigenvector of Bar-Itzhack
    (2000), which is always stable."""
    (a, b, c), (d, e, f), (g, h, i) = matrix
    k = np.array([
        [a - e - i, d + b, g + c, h - f], [d + b, e - a - i, h + f, c - g],
        [g + c, h + f, i - a - e, d - b], [h - f, c - g, d - b, a + e + i],
    ]) / 3.0  # fmt: skip
    x, y, z, w = np.linalg.eigh(k)[1][:, -1]
    return [float(value) for value in (np.array([w, x, y, z]) if w >= 0 else -np.array([w, x, y, z]))]
