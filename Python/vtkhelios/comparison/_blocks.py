# SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
# SPDX-License-Identifier: BSD-3-Clause
"""Confidence intervals by a block bootstrap: tiles of the ground are drawn, never single points.

Neighbouring points see the same surface in the same pass, so that they are not independent; a tile is
drawn with all its points, of both clouds at once. Reference: B. Efron, R. Tibshirani, An Introduction
to the Bootstrap, 1993, chapters 8 and 13 (percentile intervals).
"""

import typing

import numpy as np

from ..surveys.accuracy import Estimate

DRAWS = 400
FEWEST = 8  # tiles: fewer give no interval
LEVEL = 95  # [%]
MAXIMUM_VALUES = 20_000  # sample of a quantile; more are drawn at random


class Sampled(typing.NamedTuple):
    """A value, and what it is in each draw of the tiles."""

    value: float
    draws: np.ndarray
    tiles: int  #: with data

    def minus(self, other):
        return Sampled(
            self.value - other.value, self.draws - other.draws, min(self.tiles, other.tiles)
        )

    def estimate(self):
        """Returns the value and the ends of its interval; NaN for fewer than FEWEST tiles."""
        known = self.draws[np.isfinite(self.draws)]
        if self.tiles < FEWEST or len(known) < DRAWS // 2 or not np.isfinite(self.value):
            return Estimate(float(self.value), float("nan"), float("nan"))
        low, high = np.percentile(known, [(100 - LEVEL) / 2, (100 + LEVEL) / 2])
        return Estimate(
            float(self.value), float(min(low, self.value)), float(max(high, self.value))
        )


class Blocks:
    """Draws of tiles."""

    def __init__(self, count, seed):
        self.count = count
        self.random = np.random.Generator(np.random.Philox(seed))
        self._weights = self.random.multinomial(count, np.full(count, 1.0 / count), DRAWS).astype(
            np.float64
        )
        self._swaps = self.random.integers(0, 2, (DRAWS, count)).astype(np.float64)

    def sums(self, tiles, values=None):
        """Sums of values, or counts, per tile."""
        return np.bincount(tiles, values, self.count).astype(np.float64)

    def ratio(self, above, below, form=None):
        """Returns the ratio of two sums over tiles, or a function of it."""
        form = form or (lambda ratio: ratio)
        with np.errstate(invalid="ignore", divide="ignore"):
            value = form(above.sum() / below.sum())
            draws = form((self._weights @ above) / (self._weights @ below))
        return Sampled(float(value), draws, np.count_nonzero(below))

    def quantile(self, values, tiles, share=0.5):
        """Returns a quantile of values."""
        if len(values) > MAXIMUM_VALUES:
            rows = self.random.choice(len(values), MAXIMUM_VALUES, replace=False)
            values, tiles = values[rows], tiles[rows]
        order = np.argsort(values, kind="stable")
        values, tiles = values[order], tiles[order]
        found = np.empty(DRAWS)
        for draw, weights in enumerate(self._weights):
            total = np.cumsum(weights[tiles])
            if total[-1] == 0:
                found[draw] = np.nan
                continue
            found[draw] = values[np.searchsorted(total, share * total[-1])]
        return Sampled(float(np.quantile(values, share)), found, len(np.unique(tiles)))

    def solve(self, matrices, vectors):
        """Solutions of linear equations whose terms are sums over tiles: a Sampled per unknown."""
        size = vectors.shape[1]
        value = np.linalg.lstsq(matrices.sum(axis=0), vectors.sum(axis=0), rcond=None)[0]
        left = np.tensordot(self._weights, matrices, 1)
        right = np.tensordot(self._weights, vectors, 1)
        solvable = np.linalg.cond(left) < 1e6
        draws = np.full((DRAWS, size), np.nan)
        draws[solvable] = np.linalg.solve(left[solvable], right[solvable][:, :, None])[:, :, 0]
        count = np.count_nonzero(matrices.reshape(len(matrices), -1).any(axis=1))
        return [Sampled(float(value[i]), draws[:, i], count) for i in range(size)]

    def difference(self, first, second, measure):
        """How much two histograms differ, and what chance exceeds in 5 % of the cases.

        first, second: counts per tile and bin. measure: of the fractions of both in each bin.
        Chance: the same tiles, with both clouds exchanged in a random half of them.
        """
        tiles = np.count_nonzero(first.any(axis=1)), np.count_nonzero(second.any(axis=1))
        value = measure(fractions(first.sum(axis=0)), fractions(second.sum(axis=0)))
        draws = measure(fractions(self._weights @ first), fractions(self._weights @ second))
        first, second = first / max(1, first.sum()), second / max(1, second.sum())
        swapped = self._swaps @ first + (1 - self._swaps) @ second
        other = self._swaps @ second + (1 - self._swaps) @ first
        by_chance = measure(fractions(swapped), fractions(other))
        by_chance = by_chance[np.isfinite(by_chance)]
        is_known = min(tiles) >= FEWEST and len(by_chance)
        chance = float(np.percentile(by_chance, LEVEL)) if is_known else float("nan")
        return Sampled(float(value), draws, min(tiles)), chance


def fractions(counts):
    with np.errstate(invalid="ignore", divide="ignore"):
        return counts / counts.sum(axis=-1, keepdims=True)


def total_variation(first, second):
    """Half the sum of the differences: the fraction of points that would have to move."""
    return 0.5 * np.abs(first - second).sum(axis=-1)


def kolmogorov_smirnov(first, second):
    """Returns the largest difference of the cumulative fractions."""
    return np.abs(np.cumsum(first - second, axis=-1)).max(axis=-1)
