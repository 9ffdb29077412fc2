# SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
# SPDX-License-Identifier: BSD-3-Clause
"""Samples of the pulses of a survey, run in different ways, compared and timed."""

import time
import typing

import numpy as np

from ..array_names import PULSE_IDS, RANGE
from ..clouds.join import join_clouds
from ..core.classes import vtk_class
from ..core.pipeline import PipelineError

PULSES_PER_WINDOW = 256  # pulses of the sample, between signs of progress
FEWER = 10  # the step of the sample, if nothing is hit
WINDOWS, SHORTEST, GROWTH = 4, 32, 4  # windows, and pulses, that are timed
REPEATS = 3  # rounds of the timing; the shortest counts: other work on the computer only adds
ENOUGH_SECONDS, LONGEST_WINDOW = 0.1, 16384
SHORTEST_SECONDS = 1e-4  # time that can be measured, of a survey of few pulses
MEASURES = (
    *("rangeP50_m", "rangeP95_m", "rangeRms_m", "missed", "invented", "missedAndInvented"),
    *("amplitudeRms", "widthRms_ns"),
)
POSITION = "positionP95_m"  # a measure of displacement()


class Estimate(typing.NamedTuple):
    """A value, and the ends of its 95 % confidence interval."""

    value: float
    lower: float
    upper: float


class Sampler:
    """Runs the same pulses of a survey with any options of Survey.run(), without noise.

    on_step is called during all work, and may raise an exception to end it.
    """

    def __init__(self, survey, pulses, on_step, options):
        self._survey, self._on_step, self._options = survey, on_step, options
        self.total = survey.source_of(options).GetNumberOfPulses()
        self.step = max(1, self.total // pulses)
        cloud, fired = self.run()
        hits = _count_pulses(cloud)
        while hits == 0 and self.step > 1:  # few are fired, or few hit
            self.step = max(1, self.step // FEWER)
            cloud, fired = self.run()
            hits = _count_pulses(cloud)
        if hits == 0:
            raise PipelineError(
                [
                    f"none of {fired} pulses of the survey has an echo, so that nothing can be "
                    "compared; check the survey with vtkhelios run"
                ]
            )
        if hits < pulses and self.step > 1:  # others hit nothing, or are not fired
            self.step = max(1, self.step * hits // pulses)
            _, fired = self.run()
        self.fired = fired
        self.share_fired = fired / max(1, self.total / self.step)

    def run(self, every=1, **options):
        """Returns the echoes of the sample, or of about every n-th of its pulses; the number of
        pulses fired."""
        step = every * self.step
        options = {"noise": False, **self._options, **options}
        options |= {"pulse_step": step, "pulses": True}
        count = max(1, self.total // step // PULSES_PER_WINDOW)
        ends = [i * self.total // count for i in range(count + 1)]
        clouds = [
            self._survey.run_window(options, window, self._on_step)
            for window in zip(ends, ends[1:])
        ]
        fired = sum(len(cloud.pulses) for cloud in clouds)
        return clouds[0] if count == 1 else join_clouds(clouds), fired

    def compare(self, cloud, reference):
        """Returns the measures of a cloud against another: a dict of Estimates, and the counts."""
        comparison = self.make_comparison()
        comparison.SetInputData(0, cloud.polydata)
        comparison.SetInputData(1, reference.polydata)
        comparison.Update()
        table = comparison.GetOutput()
        rows = {}
        for row in range(table.GetNumberOfRows()):
            name, *values = (table.GetValue(row, column) for column in range(4))
            rows[name.ToString()] = Estimate(*(value.ToDouble() for value in values))
        return rows

    def displacement(self, cloud, reference):
        """Returns the 95th percentile of the distances of echoes from another cloud's [m].

        It counts echoes of a pulse that are nearest to each other in range, and as near as compare() matches.
        """
        first, second = _match(cloud, reference, self.make_comparison().GetMatchingDistance())
        away = np.linalg.norm(cloud.points[first] - reference.points[second], axis=1)
        return _quantile(np.sort(away), 0.95)

    def memory(self, **options):
        """Returns the size of the scene and of the trees of its ray caster, after run() [bytes]."""
        return self._survey.source_of({**self._options, **options}).GetSceneSize()

    def make_comparison(self):
        """Returns a vtkHeliosEchoComparison for the survey's scanner."""
        comparison = vtk_class("vtkHeliosEchoComparison")()
        source, leg = self._first_leg()
        source.SetUpComparison(comparison, leg)
        return comparison

    def pulse_length(self):
        """Full width at half maximum [ns]."""
        source, leg = self._first_leg()
        return source.GetLegPulseLength(leg)

    def _first_leg(self):
        """Returns the loaded source, and the first leg that fires pulses."""
        source = self._survey.source_of(self._options)
        legs = [leg.index for leg in self._survey.legs if leg.active]
        return source, next(leg for leg in legs if source.GetLegPulseLength(leg) > 0)

    def time_pair(self, first, second):
        """Processor times per pulse index [s] with two sets of options, measured in turn."""
        times = [(self.time(1, **first), self.time(1, **second)) for _ in range(REPEATS)]
        return tuple(min(each) for each in zip(*times))

    def time(self, repeats=REPEATS, **options):
        """Processor time per pulse index [s]: of consecutive pulses, in windows of all the survey."""
        options = {"noise": False, **self._options, **options}
        places = [(2 * i + 1) * self.total // (2 * WINDOWS) for i in range(WINDOWS)]
        idle = min(self._time_window(place, 1, options) for place in places)
        length = SHORTEST

        def measure():
            busy = sum(self._time_window(place, length, options) for place in places)
            return max(0.0, busy - WINDOWS * idle)

        while True:
            length = min(length, max(1, self.total // (2 * WINDOWS)))
            seconds = measure()
            if seconds > ENOUGH_SECONDS or length >= min(LONGEST_WINDOW, self.total // 8):
                seconds = min([seconds, *(measure() for _ in range(repeats - 1))])
                return max(SHORTEST_SECONDS, seconds) / (WINDOWS * length)
            length *= GROWTH

    def _time_window(self, first, length, options):
        start = time.process_time()
        self._survey.run_window(options, (first, first + length), self._on_step)
        return time.process_time() - start


def _match(cloud, reference, distance):
    """The indices of pairs of echoes that are nearest to each other in range."""
    if not (len(cloud) and len(reference)):
        return np.empty((2, 0), dtype=np.int64)
    ids = np.unique(np.concatenate([cloud[PULSE_IDS], reference[PULSE_IDS]]))
    far = 1.0 + max(cloud[RANGE].max(), reference[RANGE].max()) + 2.0 * distance
    keys = [
        far * np.searchsorted(ids, each[PULSE_IDS]) + each[RANGE] for each in (cloud, reference)
    ]
    forth, back = _nearest(keys[0], keys[1]), _nearest(keys[1], keys[0])
    own = np.arange(len(cloud))
    fits = (back[forth] == own) & (np.abs(keys[0] - keys[1][forth]) <= distance)
    return own[fits], forth[fits]


def _nearest(keys, others):
    """Returns the index of the nearest of other keys, for each key."""
    order = np.argsort(others)
    right = np.searchsorted(others[order], keys).clip(0, len(others) - 1)
    left = (right - 1).clip(0)
    is_left = np.abs(keys - others[order][left]) <= np.abs(keys - others[order][right])
    return order[np.where(is_left, left, right)]


def _quantile(values, share):
    """Returns a quantile of sorted values; order statistics give its interval."""
    count = len(values)
    if count == 0:
        return Estimate(0.0, 0.0, 0.0)
    reach = 1.96 * (count * share * (1.0 - share)) ** 0.5
    ranks = (count * share + offset for offset in (0.0, -reach, reach))
    return Estimate(*(float(values[min(count - 1, max(0, int(rank)))]) for rank in ranks))


def _count_pulses(cloud):
    ids = cloud[PULSE_IDS] if len(cloud) else ()
    return len(set(map(int, ids)))
