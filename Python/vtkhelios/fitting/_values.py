# SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
# SPDX-License-Identifier: BSD-3-Clause
"""The Values of an instrument and its strips, with what they are found by."""

import math

import numpy as np

from ..array_names import AMPLITUDE
from ..core.words import counted
from ._mirror import CONIC, OSCILLATING, ROTATING, join
from .result import Value

LIGHT = 299_792_458.0  # [m/s]
ROLL = 2.0  # typical mean roll of a strip [deg]
WORDS = {
    ROTATING: "lines in one direction: the angle rises and jumps back",
    OSCILLATING: "lines in both directions",
    CONIC: "spots of successive pulses move in all directions",
}
RATES = {ROTATING: "lines", OSCILLATING: "mirror cycles of two lines", CONIC: "revolutions"}


class Values:
    """Collects Values; ``rows``."""

    def __init__(self):
        self.rows = []

    def add(self, name, unit, value, uncertainty, how, strip=None, text=""):
        self.rows.append(Value(name, unit, value, uncertainty, how, strip, text))

    def add_unknown(self, name, unit, why):
        self.add(name, unit, None, None, f"not known: {why}")

    # Values of the instrument

    def add_pulses(self, periods):
        frequencies = np.array([1 / each.value for each in periods])
        errors = np.array([each.uncertainty / each.value**2 for each in periods])
        value, error = join(frequencies, errors)
        regular = all(each.is_regular for each in periods)
        how = "times of pulses as whole multiples of a period"
        if not regular:
            how = "mean of the times between successive pulses, which are not equal"
        self.add("pulse frequency", "Hz", value, error, how)
        intervals = max((each.intervals for each in periods), key=len)
        if not regular and len(intervals) > 1:
            words = ", ".join(f"{1e6 * each:.3f}" for each in intervals)
            self.add("pulse intervals", "µs", None, None, "intervals that occur in more than 10 % "
                     "of the cases; modulated to resolve several pulses in the air, or two lasers",
                     text=words)  # fmt: skip

    def add_mirrors(self, mirrors):
        kinds = [mirror.kind for mirror in mirrors]
        kind = max(set(kinds), key=kinds.count)
        share = kinds.count(kind)
        self.add("mirror", "", None, None, f"{WORDS[kind]}, in {share} of {counted(len(kinds), 'strip')}",
                 text=kind)  # fmt: skip
        some = [mirror for mirror in mirrors if mirror.kind == kind]
        value, error = join(*(np.array([getattr(each, name) for each in some])
                               for name in ("frequency", "frequency_error")))  # fmt: skip
        what = "azimuth" if kind == CONIC else "scan angle"
        self.add("line frequency", "Hz", value, error,
                 f"{RATES[kind]} per second: times at which a certain {what} is crossed")  # fmt: skip
        sweeps = join(np.array([each.sweep for each in some]),
                       np.array([each.sweep_error for each in some]))  # fmt: skip
        if kind == ROTATING:
            self.add(
                "sweep of a facet", "deg", *sweeps, "rate of the angle over the line frequency"
            )
            self._add_window(some)
        elif kind == OSCILLATING:
            law = min(some, key=lambda each: each.residual)
            words = law.pattern
            if law.turning:
                words += f", reverses during {100 * law.turning:.0f} % of a line"
            self.add("scan angle", "deg", *sweeps, "half the angle of a line: amplitude of the law "
                     "of motion fitted to times and angles")  # fmt: skip
            self.add(
                "law of motion",
                "",
                None,
                None,
                f"smallest residual of the laws, {law.residual:.3f} deg",
                text=words,
            )
            self.add("turn", "", law.turning, None, "share of a line in which the mirror reverses")
        else:
            self.add("scan angle", "deg", *sweeps, "half angle of the cone: median of the angles")

    def _add_window(self, mirrors):
        whole = [each for each in mirrors if all(each.reached)]
        for name, side, best in (("smallest angle", 0, min), ("largest angle", 1, max)):
            some = whole or [each for each in mirrors if each.reached[side]]
            values = [each.limits[side] for each in some or mirrors]
            if whole:
                how, error = "ends of scan lines, with the mean roll", max(
                    0.2, float(np.ptp(values))
                )
            elif some:
                how, error = "end of scan lines on this side, with the mean roll", ROLL
            else:
                how, error = "at least: lines of the cloud end there, without edge flags", None
            self.add(name, "deg", float(best(values)), error, how)

    def add_noise(self, noise, planes):
        name = "range noise"
        if noise is None:
            self.add_unknown(name, "m", "no planes with 10 points of a strip")
            return
        self.add(name, "m", *noise, f"most frequent of {counted(planes, 'plane')}: standard deviation normal to the "
                 "plane over the cosine of the incidence; with the roughness of surfaces")  # fmt: skip

    def add_threshold(self, threshold):
        if threshold is None:
            self.add_unknown("threshold", "", "the cloud has no Intensity or Amplitude that varies")
            return
        value, name, least = threshold
        self.add("threshold", "W" if name == AMPLITUDE else "", value, None,
                 f"0.1 % of the points have a smaller {name}; smallest {least:g}; not calibrated")  # fmt: skip

    def add_returns(self, returns, separation):
        if returns is None:
            self.add_unknown("returns per pulse, maximum", "", "the cloud has no NumberOfReturns")
        else:
            self.add("returns per pulse, maximum", "", float(returns.max()), None, "at least")
        name = "pulse length"
        if separation is None:
            self.add_unknown(name, "ns", "few pulses have several returns")
            return
        distance, width, pairs = separation
        self.add("echo separation", "m", distance, width, f"of {pairs:,} successive echoes: from here "
                 "on they are at least half as frequent as they are at most")  # fmt: skip
        self.add(name, "ns", 2e9 * distance / LIGHT, 2e9 * width / LIGHT,
                 "at most: twice the echo separation over the speed of light")  # fmt: skip

    def add_divergence(self, footprints):
        name = "beam divergence"
        if not footprints:
            self.add_unknown(name, "rad", "too few edges of roofs that divide a pulse, and echo "
                             "widths are no measure without the pulse")  # fmt: skip
            return
        counts = np.array([each[2] for each in footprints], float)
        values, errors = (np.array([each[k] for each in footprints]) for k in (0, 1))
        value = float(np.average(values, weights=counts))
        error = float(np.hypot(np.sqrt(np.average(errors**2, weights=counts) / len(counts)),
                               0.5 * value))  # fmt: skip
        self.add(name, "rad", value, error, f"width of the zone of divided pulses at "
                 f"{counted(int(counts.sum()), 'edge')}: of the part of the beam that is detected")  # fmt: skip

    # Values of strips

    def add_strip(self, found, ground, relief):
        number, track, mirror = found.number, found.track, found.mirror
        frequency = 1 / found.period.value
        self.add("pulse frequency", "Hz", frequency, found.period.uncertainty * frequency**2,
                 "times", number)  # fmt: skip
        self.add(
            "line frequency", "Hz", mirror.frequency, mirror.frequency_error, mirror.kind, number
        )
        height = float(np.mean(track.positions[:, 2])) - ground
        error = math.hypot(track.height_error, relief)
        self.add("height above ground", "m", height, error, track.method, number)
        velocity = track.velocity()
        self.add("speed", "m/s", float(np.linalg.norm(velocity)), track.speed_error, track.method,
                 number)  # fmt: skip
        heading = math.degrees(math.atan2(*velocity)) % 360.0
        self.add("course", "deg", heading, None, "clockwise from north", number)
        self.add("angle residual", "deg", mirror.residual, None,
                 "of the angles about the law of the mirror", number)  # fmt: skip
        for name, side in (("smallest angle", 0), ("largest angle", 1)):
            how = "of the mirror" if mirror.reached[side] else "of the cloud"
            self.add(name, "deg", mirror.limits[side], None, how, number)
