# SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
# SPDX-License-Identifier: BSD-3-Clause
"""The mirror of a strip: its kind, line frequency, law of motion, angles, and the attitude.

Angles are those at which points are seen from the trajectory, to the vertical: along the scan lines,
positive to the right, and across them, positive forward. They include roll and pitch; the yaw is the
direction of the lines.
"""

import dataclasses

import numpy as np

from ..array_names import EDGE_OF_FLIGHT_LINE
from ._periods import refine_period
from ._smooth import smooth

ROTATING, OSCILLATING, CONIC = "rotating", "oscillating", "conic"
LEVELS = np.linspace(10, 90, 17)  # percentiles of angles whose crossings are counted
NEAR = 5.0  # pulse periods between successive pulses
JUMP = 10.0  # median steps of the angle; larger ones are no motion
BOTH = 0.3  # share of the crossings in the rarer direction, over the other
ROUND = 0.5  # largest mean of exp(2 i direction) of successive pulses, of a cone
ENOUGH = 10  # crossings, edges
MOST = 30_000  # pulses that are fitted
CYCLE = 0.1  # largest RMS of crossings about equal steps, in periods
FLYBACK = 0.6  # longest time between two lines, in periods
# interval, noise and change of attitudes: [s], [deg], [deg/s²]
INTERVAL, NOISE, CHANGE = 0.2, 0.05, 10.0
ROLL_RATE = 1.0  # rate that cannot be told from a change of the line frequency [deg/s]
TURNS = np.linspace(0.0, 1.0, 21)  # share of a line in which the mirror reverses
SINUSOIDAL = "sinusoidal"
BETTER, EXACT = 0.98, 1e-3  # RMS over a simpler law's, and below it [deg], to replace it
ENDS = 0.95  # share of the amplitude: pulses beyond show how the mirror turns
UNSEEN = 0.1  # share of the amplitude: error without them


@dataclasses.dataclass
class Mirror:
    """Findings about a mirror."""

    kind: str
    frequency: float  #: lines, mirror cycles or revolutions [Hz]
    frequency_error: float
    sweep: float = np.nan  #: rotating: angle of a period; oscillating: half the angle of a line
    sweep_error: float = np.nan
    limits: tuple = (np.nan, np.nan)  #: smallest and largest angle across [deg]
    reached: tuple = (False, False)  #: whether the mirror ends there, not the cloud
    turning: float = 0.0  #: oscillating: share of a line in which it reverses
    pattern: str = ""  #: oscillating: triangular or sinusoidal
    start: float = np.nan  #: oscillating: a time at the smallest angle [s]
    residual: float = np.nan  #: RMS of the angles about the law [deg]
    roll: object = None  #: functions of time [deg]
    pitch: object = None
    yaw: float = 0.0  #: of the line against the perpendicular of the flight [deg], clockwise


def find_angles(track, pulses, yaw=0.0):
    """Angles to the right and forward [deg] of the first returns, and their ranges [m], of an
    instrument that is turned clockwise from the course by yaw [deg]. The angle to the right is the
    angle to the vertical plane of the instrument, like a pitched mirror's."""
    away = pulses.points - track.at(pulses.times)
    ahead, right = track.headings(pulses.times)
    cosine, sine = np.cos(np.radians(yaw)), np.sin(np.radians(yaw))
    ahead, right = cosine * ahead + sine * right, cosine * right - sine * ahead
    depth = np.maximum(-away[:, 2], 1e-6)
    across = (away[:, :2] * right).sum(axis=1) / depth
    along = (away[:, :2] * ahead).sum(axis=1) / depth
    ranges = np.linalg.norm(away, axis=1)
    flat = across / np.hypot(1.0, along)
    return np.degrees(np.arctan(flat)), np.degrees(np.arctan(along)), ranges


def is_conic(pulses, period):
    """Returns whether the spots of successive pulses move in all directions."""
    near = np.diff(pulses.times) < 1.5 * period
    step = np.diff(pulses.points[:, :2], axis=0)[near]
    length = np.hypot(*step.T)
    some = (length > 0) & (length < 3 * np.median(length))
    turns = ((step[some, 0] + 1j * step[some, 1]) / length[some]) ** 2
    return bool(abs(turns.mean()) < ROUND)


def find_mirror(track, pulses, period):
    """Returns the Mirror of a strip, or None if its lines are not found. period: of pulses [s]."""
    across, along, _ = find_angles(track, pulses)
    if is_conic(pulses, period):
        return _find_cone(pulses.times, across, along)
    yaw = 0.0
    for _ in range(3):
        yaw += _fit_pitch(pulses.times, across, along)[1]
        across, along, _ = find_angles(track, pulses, yaw)
    mirror = _find_lines(pulses, across, period)
    if mirror is not None:
        depth = np.median(track.at(pulses.times)[:, 2] - pulses.points[:, 2])
        # error of angles by the height
        scale = mirror.sweep * track.height_error / max(depth, 1e-6)
        mirror.sweep_error = float(np.hypot(mirror.sweep_error, scale))
        mirror.pitch, mirror.yaw = _fit_pitch(pulses.times, across, along)[0], yaw
    return mirror


def _find_cone(times, across, along):
    """Returns a conic mirror: the azimuth turns evenly, at a constant angle from the vertical."""
    ahead = np.tan(np.radians(along))
    right = np.tan(np.radians(across)) * np.hypot(1.0, ahead)
    away = right + 1j * ahead
    centre = _circle_centre(right, ahead)
    away = away - centre
    azimuth = np.angle(away)
    step = np.diff(azimuth)
    step = (step + np.pi) % (2 * np.pi) - np.pi
    rate = np.median(step / np.diff(times)) / (2 * np.pi)
    if rate == 0 or not np.isfinite(rate):
        return None
    crossing = _crossings(times, azimuth * np.sign(rate), 0.0, 0.25 / abs(rate), 1.0)[0]
    found = None
    if len(crossing) >= ENOUGH:
        found = refine_period(crossing, float(1 / abs(rate)), CYCLE)
    frequency = abs(rate) if found is None else 1 / found.value
    error = 0.05 * frequency if found is None else found.uncertainty * frequency**2
    angle = np.degrees(np.arctan(np.abs(away)))
    half = float(np.median(angle))
    mirror = Mirror(CONIC, float(frequency), float(error), half, float(2 * angle.std() / 10))
    mirror.limits, mirror.reached = (half, half), (True, True)
    mirror.residual = float(1.4826 * np.median(np.abs(angle - half)))
    mirror.roll = mirror.pitch = lambda at: np.zeros(len(at))
    return mirror


def _circle_centre(x, y):
    """Fits the centre of a circle by least squares (Kasa 1976), as a complex number."""
    design = np.column_stack([x, y, np.ones(len(x))])
    a, b, _ = np.linalg.lstsq(design, x * x + y * y, rcond=None)[0]
    return complex(a / 2, b / 2)


def _crossings(times, angles, level, near, jump):
    """Times at which angles cross a level upward, and downward [s]."""
    step, gap = np.diff(angles), np.diff(times)
    good = (gap < near) & (np.abs(step) < jump) & (step != 0)
    rise = good & (angles[:-1] < level) & (angles[1:] >= level)
    fall = good & (angles[:-1] >= level) & (angles[1:] < level)
    found = []
    for which in (rise, fall):
        rows = np.flatnonzero(which)
        found.append(times[rows] + gap[rows] * (level - angles[rows]) / step[rows])
    return found


def _find_lines(pulses, across, period):
    times = pulses.times
    near = NEAR * period
    steps = np.abs(np.diff(across))[np.diff(times) < near]
    jump = JUMP * np.median(steps)
    levels = np.percentile(across, LEVELS)
    options = [_crossings(times, across, level, near, jump) for level in levels]
    best = int(np.argmax([len(up) + len(down) for up, down in options]))
    sets = sorted(options[best], key=len)
    if len(sets[1]) < ENOUGH:
        return None
    both = len(sets[0]) >= max(ENOUGH, BOTH * len(sets[1]))
    found = [_period_of(each) for each in (sets if both else sets[1:])]
    if any(each is None for each in found):
        return None
    value = float(np.mean([each.value for each in found]))
    error = float(max(each.uncertainty for each in found)) / value**2
    step, gap = np.diff(across), np.diff(times)
    some = (gap < near) & (np.abs(step) < jump)
    step, gap = step[some], gap[some]
    rate = float(np.median(np.abs(step / gap)))
    if both:
        mirror = Mirror(OSCILLATING, 1 / value, error)
        _fit_oscillation(mirror, times, across, options[best])
    else:
        error = float(np.hypot(error, ROLL_RATE / rate / value))
        mirror = Mirror(ROTATING, 1 / value, error)
        if not _fit_rotation(mirror, times, across, sets[1], step, gap):
            return None
    _find_limits(mirror, pulses, across, sets[1])
    return mirror


def _period_of(times):
    gaps = np.diff(times)
    typical = np.median(gaps[gaps > 0.3 * np.median(gaps)])
    kept = times[np.r_[True, gaps > 0.3 * typical]]
    return refine_period(kept, float(typical), CYCLE)


def _sample(times):
    if len(times) <= MOST:
        return np.arange(len(times))
    return np.unique(np.linspace(0, len(times) - 1, MOST).astype(np.int64))


def _fit_rotation(mirror, times, across, crossings, step, gap):
    """Fits the angle of a period: its rate over the frequency; the roll is the rest. The rate is
    the sum of the steps over the sum of their times, in which rounded coordinates and times cancel.
    False if the
    angles do not follow it."""
    rates = step / gap
    middle = np.median(rates)
    spread = 1.4826 * np.median(np.abs(rates - middle))
    good = np.abs(rates - middle) <= 5 * spread + 1e-9 * abs(middle)
    rate = float(step[good].sum() / gap[good].sum())
    mirror.sweep = abs(rate) / mirror.frequency
    error = 2 * rates[good].std() / np.sqrt(np.count_nonzero(good))
    mirror.sweep_error = float(np.hypot(error, ROLL_RATE) / mirror.frequency)
    rows = _sample(times)
    phase = _phase(times[rows], crossings[0], 1 / mirror.frequency)
    centre = np.angle(np.exp(2j * np.pi * phase).mean()) / (2 * np.pi)
    phase = (phase - centre + 0.5) % 1.0 - 0.5
    rest = across[rows] - rate / mirror.frequency * phase
    good = np.abs(rest - np.median(rest)) < 5.0
    if np.count_nonzero(good) < ENOUGH:
        return False
    _set_roll(mirror, times[rows][good], rest[good] - np.median(rest[good]))
    return True


def _phase(times, start, period):
    place = (times - start) / period
    return place - np.floor(place)


def oscillation(phase, turning):
    """Returns the angle over the half sweep of an oscillating mirror at phases [cycles], from its
    smallest;
    turning: share of a line in which it reverses, or SINUSOIDAL. As vtkHeliosOscillatingMirror."""
    phase = phase % 1.0
    if turning == SINUSOIDAL:
        return -np.cos(2 * np.pi * phase)
    half = np.where(phase <= 0.5, phase, 1 - phase) * 2  # 0..1 along a line
    if turning == 0:
        return 2 * half - 1
    edge = turning / 2
    speed = 2 / (1 - edge)
    parabola = speed / (2 * edge) * np.minimum(half, 1 - half) ** 2
    middle = speed * (half - edge) + speed * edge / 2
    return np.where(half < edge, parabola, np.where(half > 1 - edge, 2 - parabola, middle)) - 1


def _fit_oscillation(mirror, times, across, crossings):
    """Amplitude, turn and roll by least squares, for each law; the best law is kept."""
    rows = _sample(times)
    period = 1 / mirror.frequency
    up, down = (np.exp(2j * np.pi * each / period) for each in
                (crossings[0] - times[0], crossings[1] - times[0]))  # fmt: skip
    up, down = (np.angle(each.mean()) / (2 * np.pi) for each in (up, down))
    top = up + 0.5 * ((down - up) % 1.0)  # the turn between them
    start = top - 0.5
    mirror.start = float(times[0] + start * period)
    phase = _phase(times[rows], mirror.start, period)
    best = None
    for turning in [*TURNS, SINUSOIDAL]:
        law = oscillation(phase, turning)
        found = _fit_law(times[rows], across[rows], law)
        if best is None or found[2] < BETTER * best[0][2] - EXACT:
            best = found, turning
    (mirror.sweep, mirror.sweep_error, mirror.residual, roll), turning = best
    mirror.pattern = SINUSOIDAL if turning == SINUSOIDAL else "triangular"
    mirror.turning = 0.0 if turning == SINUSOIDAL else float(turning)
    if np.abs(oscillation(phase, turning)).max() < ENDS:
        mirror.pattern += ", assumed: no turns are in the cloud"
        mirror.sweep_error = float(np.hypot(mirror.sweep_error, UNSEEN * mirror.sweep))
    _set_roll(mirror, times[rows], roll)


def share_law(mirrors, flights):
    """Gives oscillating mirrors of one instrument one law, with the smallest residual, with the
    joint amplitude, and finds the roll anew: a strip that shows one side of the lines does not
    determine both. flights: Track and Pulses of each mirror."""
    some = [each for each in mirrors if each.kind == OSCILLATING]
    if len(some) < 2:
        return
    best = min(some, key=lambda each: each.residual)
    sweep, _ = join([each.sweep for each in some], [each.sweep_error for each in some])
    turning = SINUSOIDAL if best.pattern.startswith(SINUSOIDAL) else best.turning
    for mirror, (track, pulses) in zip(mirrors, flights):
        if mirror.kind == OSCILLATING:
            rows = _sample(pulses.times)
            times = pulses.times[rows]
            across = find_angles(track, pulses, mirror.yaw)[0][rows]
            law = oscillation(_phase(times, mirror.start, 1 / mirror.frequency), turning)
            mirror.residual = np.nan
            _set_roll(mirror, times, across - sweep * law)
            middle = float(np.mean(mirror.roll(times)))
            mirror.limits = middle - sweep, middle + sweep


def join(values, errors):
    """Returns the mean of strips weighted by their errors, and its uncertainty: not less than the
    spread."""
    values, errors = np.asarray(values), np.asarray(errors)
    weights = 1 / np.maximum(errors, 1e-12) ** 2
    value = float(np.average(values, weights=weights))
    error = float(1 / np.sqrt(weights.sum()))
    if len(values) > 1:
        spread = float(np.sqrt(np.average((values - value) ** 2, weights=weights)))
        error = max(error, spread)
    return value, error


def _fit_law(times, across, law):
    """Amplitude, its error, the RMS [deg], and what the law leaves of the angles."""
    base = np.polynomial.chebyshev.chebvander(
        2 * (times - times[0]) / np.ptp(times) - 1, int(min(10, 2 + np.ptp(times)))
    )
    design = np.column_stack([law, base])
    solution, *_ = np.linalg.lstsq(design, across, rcond=None)
    rest = across - design @ solution
    good = np.abs(rest) < 5 * 1.4826 * np.median(np.abs(rest)) + 1e-9
    solution, *_ = np.linalg.lstsq(design[good], across[good], rcond=None)
    rest = (across - design @ solution)[good]
    rms = float(np.sqrt(np.mean(rest**2)))
    inverse = np.linalg.pinv(design[good].T @ design[good])
    error = 2 * rms * np.sqrt(inverse[0, 0]) * 10  # residuals of a line are not independent
    return float(abs(solution[0])), float(error), rms, across - solution[0] * law


def _set_roll(mirror, times, values):
    knots, found = smooth(times, values, INTERVAL, NOISE, CHANGE)
    mirror.roll = lambda at: knots.evaluate(found, at)
    if np.isnan(mirror.residual):
        rest = values - mirror.roll(times)
        mirror.residual = float(1.4826 * np.median(np.abs(rest)))


def _find_limits(mirror, pulses, across, crossings):
    """The smallest and the largest angle, and whether the lines end there by the edge flags; without
    them the end may be the border of the cloud."""
    if mirror.kind == OSCILLATING:
        middle = float(np.mean(mirror.roll(pulses.times)))
        mirror.limits = middle - mirror.sweep, middle + mirror.sweep
        mirror.reached = True, True
        return
    flat = across - mirror.roll(pulses.times)
    line = np.floor((pulses.times - crossings[0]) * mirror.frequency + 0.5).astype(np.int64)
    starts = np.r_[0, np.flatnonzero(np.diff(line)) + 1]
    low, high = (function.reduceat(flat, starts) for function in (np.minimum, np.maximum))
    edges = pulses.get(EDGE_OF_FLIGHT_LINE)
    rows = np.flatnonzero(edges) if edges is not None else np.empty(0, np.int64)
    limits, reached = [], []
    for middle, sign in ((float(np.percentile(low, 5)), -1), (float(np.percentile(high, 95)), 1)):
        flagged = _flagged(pulses, flat, rows, sign, mirror.frequency)
        if len(flagged) >= ENOUGH and abs(np.median(flagged) - middle) < 2.0:
            limits.append(float(np.median(flagged)))
            reached.append(True)
            continue
        limits.append(middle)
        reached.append(False)
    mirror.limits, mirror.reached = tuple(limits), tuple(reached)


def _flagged(pulses, angles, rows, sign, frequency):
    """Angles of the ends of lines with an edge flag, on a side; the pulse after an edge starts the
    next line."""
    if not len(rows):
        return np.empty(0)
    after = rows[rows < len(angles) - 1] + 1
    after = after[pulses.times[after] - pulses.times[after - 1] < FLYBACK / frequency]
    both = angles[np.union1d(rows, after)]
    middle = 0.5 * (angles.min() + angles.max())
    return both[(both - middle) * sign > 0]


def _fit_pitch(times, across, along):
    """Returns the pitch as a function of time [deg], and the clockwise turn of the lines [deg]: the
    tangent
    forward is a smooth function of time, plus a slope of that to the right."""
    rows = _sample(times)
    times, across, along = times[rows], across[rows], along[rows]
    slope = np.tan(np.radians(along))
    side = np.tan(np.radians(across)) * np.hypot(1.0, slope)
    turn = 0.0
    for _ in range(4):
        knots, found = smooth(times, np.degrees(slope - turn * side), INTERVAL, NOISE, CHANGE)
        rest = slope - np.radians(knots.evaluate(found, times))
        turn = float(np.cov(side, rest)[0, 1] / max(np.var(side), 1e-12))
    found = np.degrees(np.arctan(np.radians(found)))
    return (lambda at: knots.evaluate(found, at)), float(-np.degrees(np.arctan(turn)))
