# SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
# SPDX-License-Identifier: BSD-3-Clause
"""The choice of height, speed and frequencies: the shortest flight that meets the requirements.

On flat ground at the height h below the path, a scanner with the rate g(a) of pulses per second and
unit of the tangent a (vtkHeliosSwath) leaves g(a) / (v h) pulses per square metre at the speed v.
"""

import math
import typing

from ..core.classes import vtk_class
from ..core.pipeline import update
from ..plans.kinds import SettingError
from ._settings import BANK, SPEEDS, WIDEST

HEIGHTS = 24  # tried between the limits
EDGE = 0.999  # share of the half swath: its outermost pulses are not counted on
SAME_TIME = 1e-3  # share of the time: the plan with fewer pulses is taken


class Relief(typing.NamedTuple):
    """How far the ground rises above, and drops below, what the flying height refers to [m]; and the
    factor on the density that slopes require."""

    rise: float = 0.0
    drop: float = 0.0
    factor: float = 1.0


class Design(typing.NamedTuple):
    """Heights and lengths [m], frequencies [Hz], speed [m/s], densities [1/m2], angle [deg]."""

    pulse_frequency: float
    scan_frequency: float
    scan_angle: float
    flying_height: float
    speed: float
    swath_width: float
    line_spacing: float
    density: float  # least, in a strip, on flat ground at the largest height
    along: float | None  # spacing of pulses
    across: float | None
    run_in: float
    turn_radius: float
    turn_time: float
    time: float
    pulses: float  # on the lines, of one channel


class Designer:
    """Chooses a Design for an area (vtkPolyData)."""

    def __init__(self, instrument, settings, area):
        self.instrument, self.settings, self.area = instrument, settings, area
        self.frequencies = self._find_frequencies()
        self.angle = self._find_angle()
        swath = instrument.make_swath(self.frequencies[0], settings["scan_frequency"], self.angle)
        self.tangent = EDGE * min(-swath.GetLeftTangent(), swath.GetRightTangent())
        if not self.tangent > 0:
            raise SettingError(
                "{0} {name}: its pulses do not reach both sides of the path; give another, or "
                "another mount",
                "scanner",
                name=instrument.scanner,
            )
        self.along_tangent = swath.GetLargestAlong()
        unit = self.frequencies[0]
        self.least_rate = swath.GetSmallestRate(-self.tangent, self.tangent) / unit  # per Hz
        self.nadir_rate = swath.GetRate(0.0) / unit
        self._check_lines()

    def choose(self, relief):
        """Returns the Design with the shortest flight; raises SettingError if there is none."""
        found, refused = self._try_all(self.frequencies, relief)
        if not found:
            raise SettingError(
                "no flight meets the requirements: {reason}; give a smaller {0}, another {1}, or other "
                "limits of {2} and {3}",
                "density" if self.settings["density"] else "spacing",
                "scanner",
                "flying_height",
                "speed",
                reason=refused[-1],
            )
        return _find_best(found)

    def find_steps(self, design, relief):
        """Returns the best Design of the next lower pulse frequency, and of the next higher one at up
        to the same speed, or the reason why none exists."""
        steps, at = {}, self.frequencies.index(design.pulse_frequency)
        for name, index in (("lower", at - 1), ("higher", at + 1)):
            if not 0 <= index < len(self.frequencies):
                steps[name] = f"no {name} pulse frequency to choose"
                continue
            most = design.speed if name == "higher" else math.inf
            found, refused = self._try_all([self.frequencies[index]], relief, most)
            steps[name] = _find_best(found) if found else refused[-1]
        return steps

    def _try_all(self, frequencies, relief, fastest=math.inf):
        """Returns the designs of all heights and of these frequencies, and the reasons of others."""
        found, refused = [], []
        for height in self._find_heights(relief):
            for frequency in frequencies:
                candidate = self._try(frequency, height, relief, fastest)
                (refused if isinstance(candidate, str) else found).append(candidate)
        return found, refused

    def make_lines(self, design, altitude=0.0):
        """Returns the updated vtkHeliosFlightLines of a design."""
        lines = vtk_class("vtkHeliosFlightLines")()
        lines.SetInputData(self.area)
        lines.SetSwathWidth(design.swath_width)
        lines.SetLineSpacing(design.line_spacing)
        lines.SetRunIn(design.run_in)
        lines.SetSpeed(design.speed)
        lines.SetTurnRadius(design.turn_radius)
        lines.SetTurnTime(design.turn_time)
        lines.SetAltitude(altitude)
        if self.settings["heading"] is not None:
            lines.SetOptimizeHeading(False)
            lines.SetHeading(self.settings["heading"])
        update(lines)
        return lines

    def _try(self, frequency, height, relief, fastest):
        """Returns a Design, or the reason why none exists."""
        lowest, largest = height - relief.rise, height + relief.drop
        if reason := self._check_height(lowest, largest):
            return reason
        speed = self._find_speed(frequency, largest, relief)
        least, most = self._speed_limits()
        if speed < least:
            return (
                f"at {height:.4g} m and {frequency:g} Hz the speed would be {speed:.3g} m/s, below "
                f"{least:g} m/s"
            )
        speed = min(speed, most, fastest)
        lines = self._find_scan_frequency(frequency, speed, largest)
        width = 2 * lowest * self.tangent
        design = Design(
            frequency,
            lines,
            self.angle,
            height,
            speed,
            width,
            width * (1 - self.settings["side_overlap"] / 100),
            frequency * self.least_rate / (speed * largest),
            *self._find_spacings(frequency, lines, speed, largest),
            largest * self.along_tangent,
            self._find_turn_radius(speed),
            self.settings["turn_time"],
            0.0,
            0.0,
        )
        made = self.make_lines(design)
        return design._replace(
            time=made.GetFlightTime(), pulses=frequency * made.GetLineLength() / speed
        )

    def _find_frequencies(self):
        given, known = self.settings["pulse_frequency"], self.instrument.pulse_frequencies
        if given is None:
            return sorted(known) or [100000.0]
        if known and given not in known:
            raise SettingError(
                "{0} is {given:g}, not supported by {name} (supported: {known} Hz)",
                "pulse_frequency",
                given=given,
                name=self.instrument.scanner,
                known=", ".join(f"{each:g}" for each in known),
            )
        return [given]

    def _find_angle(self):
        given, most = self.settings["scan_angle"], self.instrument.largest_angle
        if given is None:
            return min(most, WIDEST)
        if most and given > most:
            raise SettingError(
                "{0} is {given:g}, above the {most:g} deg of {name}; give a smaller one",
                "scan_angle",
                given=given,
                most=most,
                name=self.instrument.scanner,
            )
        return given

    def _check_lines(self):
        scan, low = self.settings["scan_frequency"], self.instrument.scan_frequencies[0]
        high = self.instrument.highest_scan_frequency(self.angle)
        if scan and not low <= scan <= high:
            raise SettingError(
                "{0} is {scan:g}; {name} has {low:g} to {high:g} Hz at {angle:g} deg",
                "scan_frequency",
                scan=scan,
                name=self.instrument.scanner,
                low=low,
                high=high,
                angle=self.angle,
            )
        if self.settings["spacing"] and not self.instrument.has_lines():
            raise SettingError(
                "{0} needs scan lines, which {name} ({optics}) does not have; give {1}",
                "spacing",
                "density",
                name=self.instrument.scanner,
                optics=self.instrument.optics,
            )

    def _find_heights(self, relief):
        """Returns the flying heights to try."""
        settings = self.settings
        if settings["flying_height"] is not None:
            return [settings["flying_height"]]
        slant = math.hypot(1.0, self.tangent, self.along_tangent)
        most = settings["max_flying_height"]
        if most is None and self.instrument.range_max is None:
            raise SettingError(
                "the catalogue has no largest range of {name}; give {0} or {1}",
                "flying_height",
                "max_flying_height",
                name=self.instrument.scanner,
            )
        if most is None:
            most = self.instrument.range_max / slant - relief.drop
        least = max(settings["nohd"], self.instrument.range_min, 0.05 * most) + relief.rise
        least = max(least, settings["min_flying_height"] or 0.0)
        if not least <= most:
            raise SettingError(
                "the lowest flying height would be {least:.4g} m, above the largest, {most:.4g} m; "
                "give a larger {0}, a smaller {1}, or another {2}",
                "max_flying_height",
                "nohd",
                "scanner",
                least=least,
                most=most,
            )
        return [least + i / (HEIGHTS - 1) * (most - least) for i in range(HEIGHTS)]

    def _check_height(self, lowest, largest):
        """Why a height cannot be flown; None: it can."""
        slant = math.hypot(1.0, self.tangent, self.along_tangent)
        least = max(self.settings["nohd"], self.instrument.range_min)
        if lowest < least:
            return f"the lowest height above the ground is {lowest:.4g} m, below {least:g} m"
        most = self.instrument.range_max
        if most is not None and largest * slant > most * (1 + 1e-9):
            return (
                f"the largest range is {largest * slant:.4g} m, above the {most:g} m of "
                f"{self.instrument.scanner}"
            )
        return None

    def _speed_limits(self):
        settings = self.settings
        if settings["speed"] is not None:
            return settings["speed"], settings["speed"]
        least, most = SPEEDS.get(self.instrument.use, SPEEDS["airborne"])
        if settings["min_speed"] is not None:
            least, most = settings["min_speed"], max(most, settings["min_speed"])
        if settings["max_speed"] is not None:
            least, most = min(least, settings["max_speed"]), settings["max_speed"]
        return least, most

    def _find_speed(self, frequency, height, relief):
        """Returns the largest speed that meets density or spacing."""
        rate = frequency * self.least_rate
        if self.settings["density"]:
            return rate / (height * self.settings["density"] * relief.factor)
        along, across = self.settings["spacing"]
        lines = across * rate / (height * self.instrument.sweeps * self.instrument.channels)
        fixed = self.settings["scan_frequency"]
        lines = min(lines, self.instrument.highest_scan_frequency(self.angle))
        if fixed:
            lines = fixed if fixed <= lines else 0.0
        return (
            along * lines / relief.factor if lines >= self.instrument.scan_frequencies[0] else 0.0
        )

    def _find_scan_frequency(self, frequency, speed, height):
        """Returns the frequency of equal spacing along and across at nadir, or of the given
        spacing."""
        if self.settings["scan_frequency"]:
            return self.settings["scan_frequency"]
        if not self.instrument.has_lines():
            return 0.0
        if self.settings["spacing"]:
            lines = speed / self.settings["spacing"][0]
        else:
            per_second = math.sqrt(speed * frequency * self.nadir_rate / height)
            lines = per_second / (self.instrument.sweeps * self.instrument.channels)
        low = self.instrument.scan_frequencies[0]
        return max(low, min(lines, self.instrument.highest_scan_frequency(self.angle)))

    def _find_spacings(self, frequency, lines, speed, height):
        """Returns the largest spacing of pulses along (of one channel and direction) and across."""
        if not lines or not self.instrument.has_lines():
            return None, None
        sweeps = self.instrument.sweeps * self.instrument.channels
        return speed / lines, lines * sweeps * height / (frequency * self.least_rate)

    def _find_turn_radius(self, speed):
        if self.settings["turn_radius"] is not None:
            return self.settings["turn_radius"]
        bank = BANK.get(self.instrument.use, BANK["airborne"])
        return vtk_class("vtkHeliosFlightLines").ComputeTurnRadius(speed, bank)


def _find_best(designs):
    """Returns the design with the shortest flight, of equal ones that with the fewest pulses."""
    least = min(each.time for each in designs)
    fast = [each for each in designs if each.time <= (1 + SAME_TIME) * least]
    return min(fast, key=lambda each: each.pulses)
