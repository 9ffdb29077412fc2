# SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
# SPDX-License-Identifier: BSD-3-Clause
"""The settings of a flight plan: names, units, valid ranges and defaults."""

import difflib
import numbers
import typing

from ..plans.kinds import SettingError

SCANNER = "scanners.xml#rotating_als"
PLATFORMS = {"unmanned": "platforms.xml#copter_linearpath"}  # by the use of the scanner
PLATFORM = "platforms.xml#airplane_linearpath"  # platform of all others
WIDEST = 45.0  # half angle that is used of a wider scanner [deg]
DENSITY = 4.0  # 1/m2, if neither density nor spacing is given


class Range(typing.NamedTuple):
    """A number with a valid range; ``least`` 0 excludes 0 if ``positive``."""

    unit: str
    least: float
    most: float
    default: float | None
    text: str
    positive: bool = False

    def check(self, name, value):
        if isinstance(value, bool) or not isinstance(value, numbers.Real):
            raise TypeError(f"{name} is {value!r}; give a number [{self.unit}]")
        if not self.least <= value <= self.most or (self.positive and not value > 0):
            bracket = "(" if self.positive else "["
            raise SettingError(
                "{0} is {value:g}; its valid range is {bracket}{least:g}, {most:g}] {unit}",
                name,
                value=float(value),
                bracket=bracket,
                least=self.least,
                most=self.most,
                unit=self.unit,
            )
        return float(value)


# In the order of --help and of reports.
NUMBERS = {
    "density": Range("1/m2", 0, 1e6, None, "least pulse density of a strip", True),
    "side_overlap": Range("%", 0, 90, 20.0, "overlap of neighbouring strips"),
    "flying_height": Range("m", 0, 1e5, None, "height of the lines above the ground", True),
    "min_flying_height": Range("m", 0, 1e5, None, "lowest height that may be chosen", True),
    "max_flying_height": Range("m", 0, 1e5, None, "largest height that may be chosen", True),
    "nohd": Range(
        "m", 0, 1e5, 0.0, "nominal ocular hazard distance: least height above any ground"
    ),
    "max_climb": Range("deg", 0, 89, 10.0, "steepest climb of terrain following"),
    "speed": Range("m/s", 0, 1e4, None, "speed over the ground", True),
    "min_speed": Range("m/s", 0, 1e4, None, "lowest speed that may be chosen", True),
    "max_speed": Range("m/s", 0, 1e4, None, "largest speed that may be chosen", True),
    "turn_time": Range("s", 0, 1e5, 0.0, "time of a turn; 0: that of the radius"),
    "turn_radius": Range("m", 0, 1e6, None, "radius of turns"),
    "heading": Range("deg", 0, 360, None, "heading of the first line, clockwise from north"),
    "pulse_frequency": Range("Hz", 0, 1e9, None, "pulse frequency", True),
    "scan_frequency": Range("Hz", 0, 1e6, None, "scan frequency", True),
    "scan_angle": Range("deg", 0, 85, None, "half the scan angle", True),
    "cell": Range("m", 0, 1e5, None, "cells of the predicted density", True),
}
PAIRS = {
    "spacing": ("m", "largest distance of pulses along and across the path, in a strip"),
}
FLAGS = {"terrain_following": "follow the ground below, instead of a constant altitude"}
TEXTS = {"area": None, "scanner": SCANNER, "platform": None, "crs": None}
ALL = (*TEXTS, *NUMBERS, *PAIRS, *FLAGS)

# By the use of the scanner in the catalogue: speeds [m/s] that aircraft of that kind fly.
SPEEDS = {"airborne": (40.0, 80.0), "unmanned": (3.0, 15.0)}
BANK = {"airborne": 20.0, "unmanned": 30.0}  # degrees, of turns without a radius


def check_flight_settings(given):
    """Returns all settings, checked; those not given (or None) have their defaults."""
    for name in given:
        if name not in ALL:
            near = difflib.get_close_matches(name, ALL, 1, 0.6)
            hint = f"did you mean {near[0]}?" if near else f"settings are: {', '.join(ALL)}"
            raise TypeError(f"{name} is not a setting of a flight plan; {hint}")
    given = {name: value for name, value in given.items() if value is not None}
    values = {**TEXTS, **{name: each.default for name, each in NUMBERS.items()}}
    values |= {**dict.fromkeys(PAIRS), **dict.fromkeys(FLAGS, False)}
    for name, value in given.items():
        values[name] = _check(name, value)
    _check_together(values)
    return values


def _check(name, value):
    if name in NUMBERS:
        return NUMBERS[name].check(name, value)
    if name in PAIRS:
        return _check_pair(name, value)
    if name in FLAGS and not isinstance(value, bool):
        raise TypeError(f"{name} is {value!r}; give True or False")
    return value


def _check_pair(name, value):
    try:
        along, across = map(float, value)
    except (TypeError, ValueError):
        raise TypeError(f"{name} is {value!r}; give two numbers: along, across [m]") from None
    if not (0 < along <= 1e4 and 0 < across <= 1e4):
        raise SettingError(
            "{0} is {along:g}, {across:g}; the valid range of both is (0, 10000] m",
            name,
            along=along,
            across=across,
        )
    return along, across


def _check_together(values):
    for first, second in (
        ("density", "spacing"),
        ("flying_height", "min_flying_height"),
        ("flying_height", "max_flying_height"),
        ("speed", "min_speed"),
        ("speed", "max_speed"),
    ):
        if values[first] is not None and values[second] is not None:
            raise SettingError("{0} and {1} are both given; give one of them", first, second)
    for low, high in (("min_flying_height", "max_flying_height"), ("min_speed", "max_speed")):
        if None not in (values[low], values[high]) and values[low] > values[high]:
            raise SettingError(
                "{0} is {low:g} and {1} is {high:g}; give a smaller {0} or a larger {1}",
                low,
                high,
                low=values[low],
                high=values[high],
            )
    if values["density"] is None and values["spacing"] is None:
        values["density"] = DENSITY
