# SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
# SPDX-License-Identifier: BSD-3-Clause
"""Periods of events of which many are missing: pulses, lines."""

import typing

import numpy as np

REGULAR = 0.15  # largest RMS of the events about equal steps, in periods
START = 40.0  # periods of the first window
GROWTH = 4.0  # growth of windows
EVENTS = 8  # events of a window that is fitted
SHORTEST = 5  # percentile of the steps that is about one period
ENOUGH = 30  # steps
APART = 0.03  # share of a period, between intervals that differ
SHARE = 0.1  # share of the steps, of an interval that counts


class Period(typing.NamedTuple):
    """A mean period [s], the half width of its 95 % interval, and the intervals if they differ."""

    value: float
    uncertainty: float
    is_regular: bool
    intervals: tuple = ()


def find_pulse_period(times):
    """Returns the Period of sorted times of pulses, or None: too few are successive."""
    steps = np.diff(times)
    steps = steps[steps > 0]
    if len(steps) < ENOUGH:
        return None
    value = np.percentile(steps, SHORTEST)
    for _ in range(5):
        single = steps[(steps > 0.5 * value) & (steps < 1.5 * value)]
        if len(single) < ENOUGH:
            return None
        value = single.mean()
    error = 2 * single.std() / np.sqrt(len(single))
    intervals = _find_intervals(single, value, np.spacing(np.abs(times).max()))
    found = refine_period(times, value, start=max(START, 0.1 * value / max(error, 1e-9 * value)))
    if found is None:
        return Period(float(value), float(error), False, intervals)
    return found._replace(is_regular=len(intervals) < 2, intervals=intervals)


def _find_intervals(steps, value, resolution):
    """Mean intervals that occur often, if there are several; less apart than times can be is one."""
    steps = np.sort(steps)
    apart = max(APART * value, 4 * resolution)
    groups = np.split(steps, np.flatnonzero(np.diff(steps) > apart) + 1)
    return tuple(float(each.mean()) for each in groups if len(each) > SHARE * len(steps))


def refine_period(times, value, tolerance=REGULAR, start=START):
    """Returns the Period of events at whole multiples of a period known roughly, or None if they
    are not.

    The window grows, so that the error of the last window is small against a period of the next.
    """
    times = times - times[0]
    window, spread = start * value, 0.0
    while True:
        inside = times <= window
        number = np.round(times[inside] / value)
        if len(number) >= EVENTS and number[-1] * value > window / 4:
            slope, offset = np.polyfit(number, times[inside], 1)
            rest = times[inside] - offset - slope * number
            rest = rest[np.abs(rest) <= 5 * np.median(np.abs(rest)) + 1e-12]
            spread = rest.std() / slope
            if spread > tolerance:
                return None
            value = float(slope)
        if window >= times[-1]:
            break
        window *= GROWTH
    return Period(value, _uncertainty(times, value, spread), True)


def _uncertainty(times, value, spread):
    """Twice the standard error, or half the difference of both halves."""
    number = np.round(times / value)
    error = 2 * spread * value / max(1.0, number.std() * np.sqrt(len(number)))
    halves = [
        np.polyfit(number[part], times[part], 1)[0]
        for part in (number <= number[-1] / 2, number > number[-1] / 2)
        if np.count_nonzero(part) >= ENOUGH and np.ptp(number[part]) > 2
    ]
    drift = abs(halves[0] - halves[1]) / 2 if len(halves) == 2 else 0.0
    return float(max(error, drift, 1e-9 * value))
