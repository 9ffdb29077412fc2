# SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
# SPDX-License-Identifier: BSD-3-Clause
"""Metrics of pulses: returns, density, spacing along and across scan lines."""

import numpy as np

from ..array_names import (
    CHANNEL_IDS, GPS_TIME, LEG_IDS, NUMBER_OF_RETURNS, RETURN_NUMBER, SCAN_ANGLE,
    SCAN_DIRECTION_FLAG,
)  # fmt: skip
from ._inputs import SOURCE

PERIOD = 5  # percentile of the times between pulses that is the pulse period: few pulses are lost
NEXT = 1.5  # periods: pulses nearer in time are successive
GAP = 50  # periods without a point end a line
MINIMUM_IN_LINE = 5  # points of a line in a tile
LONG = 3.0  # ratio of the extents of a line
CROSSING = 0.5  # extent of a line in a tile over its side; shorter pieces are of broken lines
ENOUGH = 30  # pairs


class Missing(Exception):
    """A metric cannot be measured; the text says why."""


def need(side, *names):
    for name in names:
        if name not in side:
            raise Missing(f"{side.name} has no {name}")


def first_returns(side):
    """Returns the mask of the first returns; Missing without return numbers."""
    need(side, RETURN_NUMBER, NUMBER_OF_RETURNS)
    mask = (side[RETURN_NUMBER] == 1) & (side[NUMBER_OF_RETURNS] >= 1)
    if not mask.any():
        raise Missing(f"{side.name} has no point with {RETURN_NUMBER} 1")
    return mask


def returns_per_pulse(side, blocks, of=None):
    """Returns the mean of NumberOfReturns over the first returns, of the pulses with a return."""
    mask = _within(first_returns(side), of, side)
    tiles = side.tiles[mask]
    returns = blocks.sums(tiles, side[NUMBER_OF_RETURNS][mask])
    return blocks.ratio(returns, blocks.sums(tiles))


def multi_return_share(side, blocks, of=None):
    """The fraction of the pulses with a return that have several."""
    mask = _within(first_returns(side), of, side)
    tiles = side.tiles[mask]
    several = blocks.sums(tiles, side[NUMBER_OF_RETURNS][mask] > 1)
    return blocks.ratio(several, blocks.sums(tiles))


def _within(mask, of, side):
    mask = mask if of is None else mask & of
    if not mask.any():
        raise Missing(f"{side.name} has no first return of it")
    return mask


def density(side, blocks, areas, mask=None):
    """Returns the points/m² of the columns with points."""
    tiles = side.tiles if mask is None else side.tiles[mask]
    return blocks.ratio(blocks.sums(tiles), areas)


class Lines:
    """First returns (all points without return numbers) in the order of their times, strip by
    strip and channel by channel."""

    def __init__(self, side, tile):
        need(side, GPS_TIME)
        self._side, self._tile = side, tile
        mask = first_returns(side) if RETURN_NUMBER in side else np.ones(len(side), bool)
        rows = np.flatnonzero(mask & np.isfinite(side[GPS_TIME]))
        strip = np.zeros(len(rows), np.int64)
        for name in (SOURCE, LEG_IDS, CHANNEL_IDS):
            if name in side:
                _, number = np.unique(side[name][rows], return_inverse=True)
                strip = strip * (number.max(initial=0) + 1) + number
        order = np.lexsort((side[GPS_TIME][rows], strip))
        self._rows, self._strip = rows[order], strip[order]
        self._xy = side.points[self._rows, :2]
        self._tiles = side.tiles[self._rows]
        steps = np.diff(side[GPS_TIME][self._rows])
        same = self._strip[1:] == self._strip[:-1]
        self._steps = np.where(same & (steps > 0), steps, np.inf)
        known = self._steps[np.isfinite(self._steps)]
        if len(known) < ENOUGH:
            raise Missing(f"{side.name} has fewer than {ENOUGH} points of different {GPS_TIME}")
        self.period = float(np.percentile(known, PERIOD))

    def along(self, blocks):
        """Returns the median distance of successive pulses in plan view [m]."""
        pairs = np.flatnonzero(self._steps <= NEXT * self.period)
        steps = np.linalg.norm(self._xy[pairs + 1] - self._xy[pairs], axis=1)
        return blocks.quantile(steps, self._tiles[pairs])

    def across(self, blocks):
        """Returns the median distance of successive lines in plan view, within a tile [m]."""
        spacing, tiles = self._spacings(self._number_lines())
        if len(spacing) < ENOUGH:
            raise Missing(f"{self._side.name} has fewer than {ENOUGH} pairs of lines side by side")
        return blocks.quantile(spacing, tiles)

    def _number_lines(self):
        """Returns the number of the line of each point, from changes of the scan direction."""
        ends = self._steps > GAP * self.period
        if SCAN_DIRECTION_FLAG in self._side:
            flags = self._side[SCAN_DIRECTION_FLAG][self._rows]
            if np.ptp(flags) > 0:
                return self._count(ends | (np.diff(flags.astype(np.int64)) != 0))
        need(self._side, SCAN_ANGLE)
        angle = self._side[SCAN_ANGLE][self._rows].astype(np.float64)
        turns = np.diff(angle)
        moves = np.flatnonzero((turns != 0) & np.isfinite(turns))
        if len(moves) < ENOUGH:
            raise Missing(f"{self._side.name} has a constant {SCAN_ANGLE}")
        up = turns[moves] > 0
        ends[moves[1:][up[1:] != up[:-1]]] = True
        return self._count(ends)

    def _count(self, ends):
        """Numbers lines, without lines of few points, which are turning points: -1."""
        number = np.r_[0, np.cumsum(ends)]
        counts = np.bincount(number)
        rank = np.cumsum(counts >= MINIMUM_IN_LINE) - 1
        return np.where(counts[number] >= MINIMUM_IN_LINE, rank[number], -1)

    def _spacings(self, line):
        """Distances of the centres of successive lines of a tile, across their mean direction."""
        rows = np.flatnonzero(line >= 0)
        pair = line[rows] * np.int64(self._tiles.max() + 1) + self._tiles[rows]
        groups, index, counts = np.unique(pair, return_inverse=True, return_counts=True)
        xy = self._xy[rows] - self._xy.mean(axis=0)
        centre = np.column_stack([np.bincount(index, xy[:, k]) / counts for k in (0, 1)])
        away = xy - centre[index]
        xx, yy, both = (
            np.bincount(index, away[:, i] * away[:, j]) for i, j in ((0, 0), (1, 1), (0, 1))
        )
        direction = 0.5 * np.arctan2(2 * both, xx - yy)
        root = np.hypot(xx - yy, 2 * both)
        is_long = xx + yy + root > LONG**2 * (xx + yy - root)
        is_long &= 6 * (xx + yy + root) >= counts * (CROSSING * self._tile) ** 2  # variance l²/12
        number, tile = np.divmod(groups, self._tiles.max() + 1)
        keep = np.flatnonzero(is_long & (counts >= MINIMUM_IN_LINE))
        keep = keep[np.lexsort((number[keep], tile[keep]))]
        strip = np.zeros(line.max(initial=0) + 1, np.int64)
        strip[line[rows]] = self._strip[rows]
        first, second = keep[:-1], keep[1:]
        near = (tile[first] == tile[second]) & (number[second] == number[first] + 1)
        near &= strip[number[first]] == strip[number[second]]
        first, second = first[near], second[near]
        turn = np.exp(2j * direction[first]) + np.exp(2j * direction[second])
        mean = 0.5 * np.angle(turn)
        step = centre[second] - centre[first]
        return np.abs(step[:, 1] * np.cos(mean) - step[:, 0] * np.sin(mean)), tile[first]


def mean(blocks, values, tiles):
    """Returns the mean of values."""
    return blocks.ratio(blocks.sums(tiles, values), blocks.sums(tiles))


def is_empty(sampled):
    """Returns whether a value is not known."""
    return not np.isfinite(sampled.value)
