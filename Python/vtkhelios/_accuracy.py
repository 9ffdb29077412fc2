# SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
# SPDX-License-Identifier: BSD-3-Clause
"""Samples of the pulses of a survey, run in different ways, compared and timed."""

import importlib
import time
import typing

from ._join import join_clouds
from ._pipeline import PipelineError
from .array_names import PULSE_IDS

PULSES_PER_WINDOW = 256  # of the sample, between signs of progress
WINDOWS, SHORTEST, GROWTH = 4, 32, 4  # of pulses that are timed
ENOUGH_SECONDS, LONGEST_WINDOW = 0.1, 16384
MEASURES = (
    *("rangeP50_m", "rangeP95_m", "rangeRms_m", "missed", "invented", "missedAndInvented"),
    *("amplitudeRms", "widthRms_ns"),
)


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

    def run(self, **options):
        """The echoes of the sample, and the number of pulses fired."""
        options = {"noise": False, **self._options, **options}
        options |= {"pulse_step": self.step, "pulses": True}
        count = max(1, self.total // self.step // PULSES_PER_WINDOW)
        ends = [i * self.total // count for i in range(count + 1)]
        clouds = [
            self._survey.run_window(options, window, self._on_step)
            for window in zip(ends, ends[1:])
        ]
        fired = sum(len(cloud.pulses) for cloud in clouds)
        return clouds[0] if count == 1 else join_clouds(clouds), fired

    def compare(self, cloud, reference):
        """The measures of a cloud against another: a dict of Estimates, and the counts."""
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

    def make_comparison(self):
        """A vtkHeliosEchoComparison for the survey's scanner."""
        comparison = _class("vtkHeliosEchoComparison")()
        source, leg = self._first_leg()
        source.SetUpComparison(comparison, leg)
        return comparison

    def pulse_length(self):
        """Full width at half maximum [ns]."""
        source, leg = self._first_leg()
        return source.GetLegPulseLength(leg)

    def _first_leg(self):
        """The loaded source, and the first leg that fires pulses."""
        source = self._survey.source_of(self._options)
        legs = [leg.index for leg in self._survey.legs if leg.active]
        return source, next(leg for leg in legs if source.GetLegPulseLength(leg) > 0)

    def time(self, **options):
        """Processor time per pulse index [s]: of consecutive pulses, in windows of all the survey."""
        options = {"noise": False, **self._options, **options}
        places = [(2 * i + 1) * self.total // (2 * WINDOWS) for i in range(WINDOWS)]
        idle = min(self._time_window(place, 1, options) for place in places)
        length = SHORTEST
        while True:
            length = min(length, max(1, self.total // (2 * WINDOWS)))
            busy = sum(self._time_window(place, length, options) for place in places)
            seconds = max(0.0, busy - WINDOWS * idle)
            if seconds > ENOUGH_SECONDS or length >= min(LONGEST_WINDOW, self.total // 8):
                return seconds / (WINDOWS * length)
            length *= GROWTH

    def _time_window(self, first, length, options):
        start = time.process_time()
        self._survey.run_window(options, (first, first + length), self._on_step)
        return time.process_time() - start


def _count_pulses(cloud):
    ids = cloud[PULSE_IDS] if len(cloud) else ()
    return len(set(map(int, ids)))


def _class(name):
    return getattr(importlib.import_module(__package__), name)
