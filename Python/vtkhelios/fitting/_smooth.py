# SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
# SPDX-License-Identifier: BSD-3-Clause
"""Piecewise linear functions of time whose slope changes little, fitted by least squares."""

import numpy as np

MOST = 800  # knots; of longer times they are farther apart


class Knots:
    """Knots at equal steps, about an interval apart, from the first to the last time [s]."""

    def __init__(self, first, last, interval):
        count = max(1, int(np.ceil((last - first) / interval)))
        self.times = np.linspace(first, last, count + 1)
        self.step = (last - first) / count

    def __len__(self):
        return len(self.times)

    def find(self, times):
        """Returns the number of the knot before each time, and the weight of the knot after it."""
        place = (times - self.times[0]) / self.step
        index = np.clip(place.astype(np.int64), 0, len(self) - 2)
        return index, place - index

    def evaluate(self, values, times):
        """Returns the function with values at the knots (by row), at times."""
        index, share = self.find(times)
        share = share.reshape(-1, *[1] * (values.ndim - 1))
        return (1 - share) * values[index] + share * values[index + 1]

    def add_smoothness(self, matrix, change, size=1):
        """Adds second differences of this standard deviation [unit/s²] to a normal matrix; size is
        the number of components at a knot."""
        weight = 1.0 / (change * self.step**2) ** 2
        pattern = np.outer([1, -2, 1], [1, -2, 1]) * weight
        for k in range(len(self) - 2):
            for i in range(size):
                rows = (k + np.arange(3)) * size + i
                matrix[np.ix_(rows, rows)] += pattern


def smooth(times, values, interval, noise, change):
    """Returns the Knots and values of a smooth function of noisy values; interval [s], standard
    deviations
    of the values and of the second derivative."""
    span = float(np.ptp(times))
    knots = Knots(times.min(), times.max(), max(interval, span / MOST))
    index, share = knots.find(times)
    matrix, vector = np.zeros((len(knots), len(knots))), np.zeros(len(knots))
    parts = (0, 1 - share), (1, share)
    for i, first in parts:
        np.add.at(vector, index + i, first * values / noise**2)
        for j, second in parts:
            np.add.at(matrix, (index + i, index + j), first * second / noise**2)
    knots.add_smoothness(matrix, change)
    matrix += 1e-12 * np.trace(matrix) / len(knots) * np.eye(len(knots))
    return knots, np.linalg.solve(matrix, vector)
