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
WINDOWS, SHORTEST, GROWTH = 8, 4, 16  # windows, and pulses, that are timed; growth of them, at most
REPEATS = 3  # rounds of the timing; the shortest counts: other work on the computer only adds
ENOUGH_SECONDS, LONGEST_WINDOW = 0.02, 16384
LONG_SECONDS = 0.2  # a round of this time is the only one
SHORTEST_SECONDS = 1e-4  # time that can be measured, of a survey of few pulses
MEASURES = (
    *("rangeP50_m", "rangeP95_m", "rangeRms_m", "missed", "invented", "missedAndInvented"),
    *("amplitudeRms", "widthRms_ns"),
)
ADAPTIVE = ("tolerance", "energy_tolerance", "accuracy")
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
        self._fired_ids, self._fired_in = (), {}  # ids of the sample, counts of windows
        self._length = SHORTEST  # length of the windows that were timed last
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
            self.run()
        self._set_fired()

    def _set_fired(self):
        """Sets the pulses of the sample, those of the latest run."""
        self.fired = len(self._fired_ids)
        self.share_fired = self.fired / max(1, self.total / self.step)

    def thin(self, factor):
        """Leaves about one of that many pulses in the sample."""
        self.step = min(self.total, self.step * factor)
        self.run()
        self._set_fired()

    def run(self, every=1, **options):
        """Returns the echoes of the sample, or of about every n-th of its pulses; the number of
        pulses fired."""
        step = every * self.step
        options = self._complete(options)
        options |= {"pulse_step": step, "pulses": True}
        count = max(1, self.total // step // PULSES_PER_WINDOW)
        ends = [i * self.total // count for i in range(count + 1)]
        clouds = [
            self._survey.run_window(options, window, self._on_step)
            for window in zip(ends, ends[1:])
        ]
        ids = np.concatenate([cloud.pulses[PULSE_IDS] for cloud in clouds])
        if every == 1:
            self._fired_ids = np.sort(ids)
        return clouds[0] if count == 1 else join_clouds(clouds), len(ids)

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
        """Returns the size of the scene and of the trees of its ray caster [bytes]."""
        options, first = self._complete(options), int(self._fired_ids[0])
        self._survey.run_window(options, (first, first + 1), self._on_step)  # builds the trees
        return self._survey.source_of(options).GetSceneSize()

    def _complete(self, options):
        """Returns options with those of the sampler: without its tolerances if they have a number of sub-rays."""
        kept = self._options
        if options.get("sub_rays"):
            kept = {name: value for name, value in kept.items() if name not in ADAPTIVE}
        return {"noise": False, **kept, **options}

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
        """Processor times per pulse [s] with two sets of options, measured in turn."""
        times = [(self.time(1, **first), self.time(1, **second)) for _ in range(REPEATS)]
        return tuple(min(each) for each in zip(*times))

    def time(self, repeats=REPEATS, **options):
        """Processor time per fired pulse [s]: of consecutive pulses, in windows all over the survey that begin with
        a pulse that is fired. What a window of one pulse takes is left out."""
        options = self._complete(options)
        ranks = [(2 * i + 1) * len(self._fired_ids) // (2 * WINDOWS) for i in range(WINDOWS)]
        places = sorted({int(self._fired_ids[rank]) for rank in ranks})
        self._time_window(places[0], 1, options)  # plans and builds trees
        idle = [self._time_window(place, 1, options) for place in places]

        def measure():
            busy = [self._time_window(place, length, options) for place in places]
            return max(0.0, sum(busy) - sum(idle))

        length = max(SHORTEST, self._length // GROWTH)
        most = max(2, min(LONGEST_WINDOW, self.total // len(places)))
        while True:
            length = min(length, most)
            seconds = measure()
            if seconds > ENOUGH_SECONDS or length >= most:
                break
            wanted = length * 1.5 * ENOUGH_SECONDS / max(seconds, ENOUGH_SECONDS / GROWTH)
            length = max(2 * length, int(wanted))
        self._length = length
        if seconds < LONG_SECONDS:
            seconds = min([seconds, *(measure() for _ in range(repeats - 1))])
        fired = sum(self._count_fired(place, length) - 1 for place in places)
        return max(SHORTEST_SECONDS, seconds) / max(1, fired)

    def _count_fired(self, first, length):
        """Returns the pulses of a window that are fired: others cost next to nothing."""
        key = first, length
        if key not in self._fired_in:
            options = self._complete({"sub_rays": 1, "pulses": True})
            window = self._survey.run_window(options, (first, first + length), self._on_step)
            self._fired_in[key] = len(window.pulses)
        return self._fired_in[key]

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
