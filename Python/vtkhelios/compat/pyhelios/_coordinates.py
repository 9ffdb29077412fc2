# SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
# SPDX-License-Identifier: BSD-3-Clause
"""Spherical coordinates, and angles of an attitude."""

import numpy as np


def cartesianToSpherical(points):
    """x, y, z [m] (n x 3) as radius [m], angle from the z axis and azimuth from the x axis [rad]."""
    x, y, z = np.asarray(points, dtype=np.float64).T
    distance = np.hypot(x, y)
    return np.stack([np.hypot(distance, z), np.arctan2(distance, z), np.arctan2(y, x)], axis=1)


def sphericalToCartesian(coordinates):
    """Returns the inverse of cartesianToSpherical(): n x 3."""
    radius, angle, azimuth = np.asarray(coordinates, dtype=np.float64).T
    distance = radius * np.sin(angle)
    return np.stack(
        [distance * np.cos(azimuth), distance * np.sin(azimuth), radius * np.cos(angle)], axis=1
    )


def find_angles(orientation):
    """Roll, pitch and yaw [rad], n each, of unit quaternions w, x, y, z (n x 4), body to world.

    The attitude is Rz(-yaw) Ry(roll) Rx(pitch): ARINC 705, the convention of trajectory files.
    """
    w, x, y, z = np.asarray(orientation, dtype=np.float64).T
    roll = -np.arcsin(np.clip(2.0 * (x * z - w * y), -1.0, 1.0))
    pitch = np.arctan2(2.0 * (y * z + w * x), 1.0 - 2.0 * (x * x + y * y))
    yaw = -np.arctan2(2.0 * (x * y + w * z), 1.0 - 2.0 * (y * y + z * z))
    return roll, pitch, yaw


def find_rotations(w, x, y, z):
    """Returns a rotation by a quaternion as angles [deg] about x, then y, then z, axes that do not
    move."""
    norm = np.sqrt(w * w + x * x + y * y + z * z)
    if not norm > 0.0:
        raise ValueError(f"the quaternion ({w}, {x}, {y}, {z}) is no rotation; its norm is 0")
    roll, pitch, yaw = find_angles(np.array([[w, x, y, z]]) / norm)
    return tuple(float(np.degrees(angle[0])) for angle in (pitch, roll, -yaw))
