# SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
# SPDX-License-Identifier: BSD-3-Clause
"""The trajectory of a strip: the points in which its beams meet.

A beam through a point x with the slopes s = (dx/dz, dy/dz) meets the sensor P(t) if
s = (P - x)_xy / (P - x)_z. Slopes are measured by the first and the last return of a pulse, or by
the scan angle; their residuals are minimized, not the distances from P: the error is in the slopes,
and distances of steep lines would pull P towards the ground. P is piecewise linear, and its
acceleration is small. Lines of returns: Gatziolis and McGaughey 2019, Remote Sensing 11, 2258.
"""

import typing

import numpy as np

from ..array_names import SCAN_ANGLE
from ..core.words import counted
from ._smooth import Knots

FEWEST = 50  # lines of a strip
MOST = 20_000  # lines of a strip; of more, those with returns far apart
SHORTEST = 1.0  # between first and last return, in height [m]
STEEPEST = 2.0  # slope of a beam
INTERVAL = 1.0  # distance of knots [s]
MAXIMUM_KNOTS = 400
ACCELERATION = 0.5  # standard deviation [m/s²]
HEIGHTS = 50.0 * 1.25 ** np.arange(24)  # above the points that are tried first, to 8.5 km [m]
LARGEST_STEP = 0.3  # share of the height
ROUNDS, FEWER_ROUNDS = 12, 4
TUNING = 3.0  # residuals of Cauchy weights, over the standard deviation
GROUPS = 5  # groups of the jackknife
BLOCK = 0.02  # length of successive pulses in a group [s]
WHOLE, FINE = 0.29, 0.05  # standard deviation of scan angles in whole degrees, and of others [deg]
SHIFT, FINE_SHIFT = 0.5, 0.1  # offset that scan angles may have in common [deg]
ROLL_OF_HEIGHT, ROLL_OF_SPEED = 0.02, 0.005  # errors by a roll of 1.5 degrees that scan angles omit
PART = 200  # lines of a part of the time, at least


class Beams(typing.NamedTuple):
    """Beams with measured slopes."""

    times: np.ndarray
    points: np.ndarray  #: on the beams [m]
    slopes: np.ndarray  #: (n, 2)
    weights: np.ndarray  #: (n, 2, 2), inverse covariances but for a factor
    scale: np.ndarray  #: of residuals, to be compared with each other


class Track(typing.NamedTuple):
    """A trajectory with its uncertainties, half widths of 95 % intervals."""

    knots: Knots
    positions: np.ndarray  #: at the knots [m]
    method: str
    height_error: float  #: [m]
    speed_error: float  #: [m/s]
    shift_error: float  #: in plan view [m]

    def at(self, times):
        return self.knots.evaluate(self.positions, times)

    def velocity(self):
        """Returns the mean horizontal velocity: regression of the position on the time [m/s]."""
        away = self.knots.times - self.knots.times.mean()
        return away @ self.positions[:, :2] / (away @ away)

    def headings(self, times):
        """Unit vectors forward and to the right at times, from positions 1 s apart."""
        low, high = self.knots.times[[0, -1]]
        reach = max(INTERVAL, 2 * self.knots.step)
        later, sooner = np.minimum(times + reach, high), np.maximum(times - reach, low)
        ahead = (self.at(later) - self.at(sooner))[:, :2]
        length = np.linalg.norm(ahead, axis=1, keepdims=True)
        mean = self.velocity() / max(np.linalg.norm(self.velocity()), 1e-12)
        ahead = np.where(length > 0, ahead / np.maximum(length, 1e-12), mean)
        return ahead, np.column_stack([ahead[:, 1], -ahead[:, 0]])


def beams_of_returns(pulses):
    """Returns the lines through first and last returns as Beams, or None if there are too few."""
    away = pulses.points - pulses.last
    rows = np.flatnonzero(pulses.is_whole & (away[:, 2] >= SHORTEST))
    slopes = away[rows, :2] / away[rows, 2:]
    rows = rows[np.hypot(*slopes.T) < STEEPEST]
    if len(rows) > MOST:
        rows = _farthest(rows, pulses.times[rows], away[rows, 2])
    if len(rows) < FEWEST:
        return None
    depth = away[rows, 2]
    weights = depth[:, None, None] ** 2 * np.eye(2)
    middle = 0.5 * (pulses.points[rows] + pulses.last[rows])
    return Beams(pulses.times[rows], middle, away[rows, :2] / depth[:, None], weights, depth)


def _farthest(rows, times, depth):
    """MOST rows, equally many of equal parts of the time, with returns far apart."""
    parts = max(1, min(MOST // PART, int((times[-1] - times[0]) / INTERVAL)))
    part = ((times - times[0]) / (times[-1] - times[0]) * parts).astype(np.int64).clip(0, parts - 1)
    order = np.lexsort((-depth, part))
    rank = np.arange(len(rows)) - np.searchsorted(part[order], part[order])
    return np.sort(rows[order[rank < MOST // parts]])


def find_track(pulses):
    """The Track of a strip and whether it is from lines of returns, or None."""
    beams = beams_of_returns(pulses)
    if beams is not None:
        knots = make_knots(pulses.times)
        return track_of(beams, knots, f"lines through first and last return of "
                        f"{counted(len(beams.times), 'pulse')}"), True  # fmt: skip
    track = track_by_angles(pulses)
    return None if track is None else (track, False)


def make_knots(times):
    interval = max(INTERVAL, (times[-1] - times[0]) / MAXIMUM_KNOTS)
    return Knots(times[0], times[-1], interval)


def track_of(beams, knots, method, shift=0.0):
    """Returns a Track; shift: what heights may be off for a common error of the slopes [m]."""
    positions, weights = solve(beams, knots, None, ROUNDS)
    group = ((beams.times - beams.times[0]) / BLOCK).astype(np.int64) % GROUPS
    parts = [group != k for k in range(GROUPS)]
    parts = [part for part in parts if part.any()]
    found = [_refit(beams, knots, positions, weights, part) for part in parts]
    values = np.array([_summary(knots, each) for each in found])
    jackknife = (len(parts) - 1) / len(parts) * ((values - values.mean(axis=0)) ** 2).sum(axis=0)
    far = beams.scale > np.median(beams.scale)
    halves = np.zeros(4)
    if far.any() and not far.all():
        both = [_refit(beams, knots, positions, weights, part) for part in (far, ~far)]
        halves = 0.5 * np.abs(np.subtract(*(_summary(knots, each) for each in both)))
    error = 2 * np.sqrt(jackknife + halves**2)
    return Track(
        knots, positions, method, float(np.hypot(error[2], shift)), float(error[3]),
        float(np.hypot(*error[:2])),
    )  # fmt: skip


def _refit(beams, knots, positions, weights, part):
    some = Beams(*(each[part] for each in beams))
    return solve(some, knots, positions, FEWER_ROUNDS)[0]


def _summary(knots, positions):
    """Mean position and speed."""
    track = Track(knots, positions, "", 0.0, 0.0, 0.0)
    return np.array([*positions.mean(axis=0), np.linalg.norm(track.velocity())])


def solve(beams, knots, start, rounds):
    """Positions at the knots [m] and the last weights: Gauss-Newton with Cauchy weights."""
    centre = beams.points.mean(axis=0)
    points = beams.points - centre
    index, share = knots.find(beams.times)
    if start is None:
        positions = _start(points, beams.slopes, beams.times, knots)
    else:
        positions = start - centre
    for _ in range(rounds):
        sensor = knots.evaluate(positions, beams.times)
        height = sensor[:, 2] - points[:, 2]
        height = np.maximum(height, 1.0)
        slopes = (sensor - points)[:, :2] / height[:, None]
        rest = beams.slopes - slopes
        squares = np.einsum("ni,nij,nj->n", rest, beams.weights, rest)
        # median of chi-square with two degrees of freedom is 1.386
        scale = max(np.median(squares) / 1.386, 1e-24)
        weights = beams.weights / (scale * (1 + squares / (scale * TUNING**2)))[:, None, None]
        slant = np.zeros((len(rest), 2, 3))
        slant[:, 0, 0] = slant[:, 1, 1] = 1 / height
        slant[:, :, 2] = -slopes / height[:, None]
        change = _step(knots, index, share, positions, slant, weights, rest)
        limit = LARGEST_STEP * np.median(height)
        positions = positions + change * min(1.0, limit / max(np.abs(change[:, 2]).max(), 1e-9))
    return positions + centre, weights


def _start(points, slopes, times, knots):
    """Positions at the knots for the best of some heights: the medians of where beams are there."""
    index, _ = knots.find(times)
    middle = 0.5 * (knots.times[1:] + knots.times[:-1])
    best, least = None, np.inf
    for height in HEIGHTS:
        ends = points[:, :2] + slopes * (height - points[:, 2:])
        some = [k for k in range(len(middle)) if np.any(index == k)]
        medians = np.array([np.median(ends[index == k], axis=0) for k in some])
        place = [np.interp(times, middle[some], medians[:, k]) for k in (0, 1)]
        rest = np.abs(ends - np.column_stack(place)).sum(axis=1) / height
        if np.median(rest) < least:
            least = np.median(rest)
            best = [np.interp(knots.times, middle[some], medians[:, k]) for k in (0, 1)]
            best = np.column_stack([*best, np.full(len(knots), height)])
    return best


def _step(knots, index, share, positions, slant, weights, rest):
    """Returns the change of the positions that reduces the residuals."""
    count = len(knots)
    matrix, vector = np.zeros((count, 3, count, 3)), np.zeros((count, 3))
    product = np.einsum("nia,nij->naj", slant, weights)
    blocks = product @ slant
    pull = np.einsum("naj,nj->na", product, rest)
    parts = (0, 1 - share), (1, share)
    for i, first in parts:
        np.add.at(vector, index + i, first[:, None] * pull)
        for j, second in parts:
            sums = np.zeros((count, 3, 3))
            np.add.at(sums, index, (first * second)[:, None, None] * blocks)
            for k in range(count - 1):
                matrix[k + i, :, k + j] += sums[k]
    matrix = matrix.reshape(3 * count, 3 * count)
    smoothness = np.zeros_like(matrix)
    knots.add_smoothness(smoothness, ACCELERATION, 3)
    vector = vector.ravel() - smoothness @ positions.ravel()
    matrix = matrix + smoothness
    matrix += 1e-12 * np.trace(matrix) / len(matrix) * np.eye(len(matrix))
    return np.linalg.solve(matrix, vector).reshape(count, 3)


# By scan angles


def track_by_angles(pulses):
    """The Track for scan angles that are those to the vertical; None if they do not vary.

    The plane of a line is taken to be vertical and across the flight.
    """
    angles = pulses.get(SCAN_ANGLE)
    if angles is None or np.ptp(angles) < 1.0:
        return None
    rows = np.arange(len(pulses))
    if len(rows) > MOST:
        rows = np.unique(np.linspace(0, len(rows) - 1, MOST).astype(np.int64))
    times, points, angles = pulses.times[rows], pulses.points[rows], angles[rows].astype(np.float64)
    is_whole = bool((angles == np.rint(angles)).all())
    velocity = _find_velocity(times, points, angles)
    knots = make_knots(pulses.times)
    tangent = np.tan(np.radians(angles))
    for _ in range(4):
        ahead = velocity / np.linalg.norm(velocity)
        right = np.array([ahead[1], -ahead[0]])
        along = points[:, :2] @ right
        away = times - times.mean()
        side = np.sign(np.cov(along - away * (velocity @ right), tangent)[0, 1]) or 1.0
        noise = np.radians(WHOLE if is_whole else FINE) * (1 + tangent**2)
        flat = np.radians(FINE)
        weights = (np.outer(right, right)[None] / noise[:, None, None] ** 2
                   + np.outer(ahead, ahead)[None] / flat**2)  # fmt: skip
        slopes = -side * tangent[:, None] * right[None]
        beams = Beams(times, points, slopes, weights, np.ones(len(rows)))
        positions, _ = solve(beams, knots, None, ROUNDS)
        track = Track(knots, positions, "", 0.0, 0.0, 0.0)
        if np.linalg.norm(velocity - track.velocity()) < 1e-4:
            break
        velocity = track.velocity()
    height = float(np.median(positions[:, 2]) - np.median(points[:, 2]))
    shift = np.radians(SHIFT if is_whole else FINE_SHIFT)
    shift *= 2 * abs(np.median(tangent)) * height
    shift = np.hypot(shift, ROLL_OF_HEIGHT * height)
    if is_whole:  # the outermost degrees are not whole ones: 1.5 / range² of the slope
        shift = np.hypot(shift, 1.5 * height / np.ptp(angles) ** 2)
    step = "whole degrees" if is_whole else "fractions of a degree"
    track = track_of(
        beams, knots, f"scan angles in {step}, taken to include the roll", float(shift)
    )
    slow = ROLL_OF_SPEED * np.linalg.norm(track.velocity())
    return track._replace(speed_error=float(np.hypot(track.speed_error, slow)))


def _find_velocity(times, points, angles):
    """Returns the velocity at which points of equal angles move [m/s]."""
    _, group = np.unique(np.rint(angles), return_inverse=True)
    counts = np.bincount(group)
    away = times - (np.bincount(group, times) / counts)[group]
    moved = [points[:, k] - (np.bincount(group, points[:, k]) / counts)[group] for k in (0, 1)]
    velocity = np.array([away @ each for each in moved]) / max(away @ away, 1e-30)
    return velocity if np.linalg.norm(velocity) > 0 else np.array([0.0, 1.0])
