# SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
# SPDX-License-Identifier: BSD-3-Clause
"""fit(): reads, divides into strips, finds the flight of each and the mirror of all."""

import numpy as np

from ..array_names import CLASSIFICATION_IDS, NUMBER_OF_RETURNS, SCAN_ANGLE
from ..formats import FormatError
from ._edges import find_footprint
from ._inputs import Pulses, find_strips, read_flight
from ._mirror import find_angles, find_mirror, share_law
from ._noise import find_planes, find_separation, find_threshold, noise_rows, noise_with_error
from ._periods import find_pulse_period
from ._trajectory import find_track
from ._values import Values
from .result import Fit, Strip

GROUND_CLASS = 2
PLACES = 100  # independent heights of the ground
STEP = 0.1  # step of the trajectories [s]
LONGEST = 20_000  # rows of a trajectory


class Found:
    """Findings about a strip."""

    def __init__(self, number, source, rows, pulses, period, track, by_lines, mirror):
        self.number, self.source, self.rows, self.pulses = number, source, rows, pulses
        self.period, self.track, self.by_lines, self.mirror = period, track, by_lines, mirror


def fit_watched(clouds, on_step, unit=None, points=20_000_000):
    """Fits like fit(); on_step(name, fraction done) is called during all work, and may raise."""
    _check_settings(clouds, unit, points)
    flight = read_flight(clouds, on_step, unit, points)
    strips, notes = find_strips(flight)
    found = []
    for index, (rows, source) in enumerate(strips):
        on_step(f"strip {index + 1} of {len(strips)}", 0.9 * index / len(strips))
        strip, why = _fit_strip(flight, index + 1, source, rows)
        if strip is None:
            notes.append(f"strip {index + 1} is left out: {why}")
        else:
            found.append(strip)
    if not found:
        raise FormatError(f"{flight.name}: nothing can be fitted: {notes[-1]}")
    on_step("noise", 0.9)
    return _make_fit(flight, found, [*flight.notes, *notes])


def _check_settings(clouds, unit, points):
    if not clouds:
        raise ValueError("no clouds; give one or more")
    if unit is not None and not 1e-6 <= unit <= 1e6:
        raise ValueError(f"unit is {unit!r}; give the unit of the coordinates [m], 0.3048 for feet")
    if not (isinstance(points, (int, np.integer)) and points >= 1000):
        raise ValueError(f"points is {points!r}; give a whole number, 1000 or more")


def _fit_strip(flight, number, source, rows):
    """Returns a Found, or None and the reason."""
    pulses = Pulses(flight, rows)
    period = find_pulse_period(pulses.times)
    if period is None:
        return None, "fewer than 30 pulses are successive, so that their frequency is not known"
    track = find_track(pulses)
    if track is None:
        angles = f"{SCAN_ANGLE} is constant" if SCAN_ANGLE in flight else f"it has no {SCAN_ANGLE}"
        return None, (
            f"{angles}, and fewer than 50 of its pulses have returns more than 1 m apart, so that "
            "its trajectory is not known; give a cloud with scan angles"
        )
    track, by_lines = track
    mirror = find_mirror(track, pulses, period.value)
    if mirror is None:
        return None, (
            "fewer than 10 of its scan lines are found, or their angles are not regular; give a "
            "longer strip"
        )
    return Found(number, source, rows, pulses, period, track, by_lines, mirror), ""


def _make_fit(flight, found, notes):
    points = flight["points"]
    random = np.random.default_rng(0)
    ground, relief = _find_ground(flight, found)
    pairs = [(strip.pulses, strip.track) for strip in found]
    noise, incidence, strength = find_planes(flight, pairs)
    share_law([strip.mirror for strip in found], [(strip.track, strip.pulses) for strip in found])
    values = Values()
    values.add_pulses([strip.period for strip in found])
    values.add_mirrors([strip.mirror for strip in found])
    values.add_noise(noise_with_error(noise, random) if len(noise) else None, len(noise))
    values.add_threshold(find_threshold(flight))
    values.add_returns(flight.get(NUMBER_OF_RETURNS), find_separation(flight, pairs))
    values.add_divergence(_footprints(found))
    for strip in found:
        values.add_strip(strip, ground, relief)
        if not strip.by_lines:
            notes.append(
                f"strip {strip.number}: its trajectory is from scan angles: if they do not include "
                "the roll, its heights and positions are wrong by more than stated"
            )
    return Fit(
        flight.name, flight.crs, ground, np.array([points.min(axis=0), points.max(axis=0)]),
        values.rows, noise_rows(noise, incidence, strength, random),
        [_make_strip(strip) for strip in found], list(dict.fromkeys(notes)),
    )  # fmt: skip


def _find_ground(flight, found):
    """Returns the median height of the ground (class 2; without it of the last returns), and the
    half width
    of its interval [m], for 100 independent places."""
    if CLASSIFICATION_IDS in flight and (flight[CLASSIFICATION_IDS] == GROUND_CLASS).any():
        heights = flight["points"][flight[CLASSIFICATION_IDS] == GROUND_CLASS, 2]
    else:
        heights = np.concatenate([strip.pulses.last[:, 2] for strip in found])
    ground = float(np.median(heights))
    spread = 1.4826 * float(np.median(np.abs(heights - ground)))
    return ground, 2 * 1.2533 * spread / np.sqrt(PLACES)


def _footprints(found):
    parts = []
    for strip in found:
        ranges = find_angles(strip.track, strip.pulses)[2]
        parts.append(find_footprint(strip.pulses, ranges, strip.period.value))
    return [part for part in parts if part is not None]


def _make_strip(found):
    pulses, track, mirror = found.pulses, found.track, found.mirror
    first, last = pulses.times[[0, -1]]
    count = int(min(LONGEST, max(2, np.ceil((last - first) / STEP) + 1)))
    times = np.linspace(first, last, count)
    ahead, _ = track.headings(times)
    roll = -mirror.roll(times)
    pitch = np.degrees(
        np.arctan(np.tan(np.radians(mirror.pitch(times))) * np.cos(np.radians(roll)))
    )
    yaw = (np.degrees(np.arctan2(ahead[:, 0], ahead[:, 1])) + mirror.yaw) % 360.0
    return Strip(
        found.number, found.source, len(found.rows), len(pulses), times, track.at(times),
        np.column_stack([roll, pitch, yaw]), track.method,
    )  # fmt: skip
