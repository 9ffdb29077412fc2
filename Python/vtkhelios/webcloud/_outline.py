# SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
# SPDX-License-Identifier: BSD-3-Clause
"""Points that the first view must show: the extremes of the cloud in many directions."""

import numpy as np

OUTLIERS = 0.003  # fraction of points at either end of an axis that may be left out
MARGIN = 0.2  # margin of the extent of the others, within which points are no outliers
DIRECTIONS = 256


def find_outline(points):
    """Returns the extreme points in directions evenly over the sphere [m], as lists; without
    outliers."""
    main = points[_is_main(points)]
    main = points if len(main) == 0 else main
    rows = np.unique([int((main @ direction).argmax()) for direction in _directions()])
    return np.round(main[rows], 4).tolist()


def _is_main(points):
    """Returns a mask of the points in the box of most, with a margin."""
    low, high = np.quantile(points, [OUTLIERS, 1 - OUTLIERS], axis=0)
    margin = MARGIN * (high - low)
    return ((points >= low - margin) & (points <= high + margin)).all(axis=1)


def _directions():
    """Unit vectors on a spiral from pole to pole (Fibonacci's lattice)."""
    index = np.arange(DIRECTIONS)
    z = 1 - (2 * index + 1) / DIRECTIONS
    angle = np.pi * (3 - np.sqrt(5)) * index
    radius = np.sqrt(1 - z**2)
    return np.column_stack([radius * np.cos(angle), radius * np.sin(angle), z])
