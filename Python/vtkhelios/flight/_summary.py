# SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
# SPDX-License-Identifier: BSD-3-Clause
"""The result of a flight plan as plain data, as in plan_summary.json."""

import math

import numpy as np

from ..array_names import FLYING_HEIGHT, NUMBER_OF_STRIPS, PULSE_DENSITY, STRIP_DENSITY
from ..core.classes import version
from ._follow import line_lengths, line_waypoints
from ._settings import FLAGS, NUMBERS, PAIRS, TEXTS

UNITS = {"1/m2": "_1_m2", "%": "_percent", "m/s": "_m_s", "m": "_m", "deg": "_deg", "s": "_s"}
UNITS["Hz"] = "_Hz"


def make_report(plan):
    """Returns the settings and the result of a FlightPlan."""
    design = plan.design
    return {
        "vtkHelios": version(),
        "kind": "flight",
        "source": plan.source,
        "name": plan.name,
        "settings": _settings(plan.settings),
        "scan": {
            "platform": plan.instrument.platform,
            "scanner": plan.instrument.scanner,
            "optics": plan.instrument.optics,
            "pulseFrequency_Hz": design.pulse_frequency,
            "scanFrequency_Hz": design.scan_frequency,
            "scanAngle_deg": design.scan_angle,
            "halfSwath_deg": math.degrees(
                math.atan(design.swath_width / 2 / _lowest(design, plan))
            ),
        },
        "flight": {
            "flyingHeight_m": design.flying_height,
            "speed_m_s": design.speed,
            "swathWidth_m": design.swath_width,
            "lineSpacing_m": design.line_spacing,
            "runIn_m": design.run_in,
            "turnRadius_m": design.turn_radius,
            "turnTime_s": design.turn_time,
            **plan.pattern,
        },
        "steps": {name: _step(each, plan) for name, each in plan.steps.items()},
        "crs": plan.geography.label or None,
        "predicted": _predicted(plan),
        "lines": list(_lines(plan)),
    }


def _step(step, plan):
    """The cost of another pulse frequency, of the lines on level ground."""
    if isinstance(step, str):
        return {"reason": step}
    return {
        "pulseFrequency_Hz": step.pulse_frequency,
        "flyingHeight_m": step.flying_height,
        "speed_m_s": step.speed,
        "strip_1_m2": step.density,
        "time_s": step.time,
        "timeFactor": step.time / plan.design.time,
        "pulsesFactor": step.pulses / plan.design.pulses,
    }


def _lowest(design, plan):
    """Returns the height that the swath width refers to [m]."""
    return design.swath_width / 2 / plan.tangent


def _settings(values):
    units = {name: each.unit for name, each in NUMBERS.items()}
    units |= {name: unit for name, (unit, _) in PAIRS.items()}
    reported = {name: values[name] for name in (*TEXTS, *FLAGS)}
    if not isinstance(reported["area"], (str, type(None))):
        reported["area"] = "polygons"
    reported |= {name + UNITS[unit]: values[name] for name, unit in units.items()}
    return {_camel(name): value for name, value in reported.items()}


def _camel(name):
    """density_1_m2 and side_overlap_percent as density_1_m2 and sideOverlap_percent."""
    for unit in sorted(UNITS.values(), key=len, reverse=True):
        if name.endswith(unit):
            return _camel(name[: -len(unit)]) + unit
    first, *more = name.split("_")
    return first + "".join(word.capitalize() for word in more)


def _predicted(plan):
    """Densities and strips of the cells."""
    cells, design = plan.cells, plan.design
    strips, flying = cells[NUMBER_OF_STRIPS], cells[FLYING_HEIGHT]
    covered = strips > 0
    strip = cells[PULSE_DENSITY] / np.maximum(strips, 1)
    required = plan.required_density()
    return {
        "area_m2": plan.area,
        "cell_m": plan.grid.cell,
        "cells": len(strips),
        "required_1_m2": required,
        "along_m": design.along,
        "across_m": design.across,
        "strip_1_m2": spread(cells[STRIP_DENSITY]),
        "meanOfStrips_1_m2": float(strip[covered].mean()) if covered.any() else 0.0,
        "density_1_m2": spread(cells[PULSE_DENSITY]),
        "met_percent": 100.0 * float((cells[STRIP_DENSITY] >= required * (1 - 1e-6)).mean()),
        "covered_percent": 100.0 * float(covered.mean()),
        "overlap_percent": 100.0 * float((strips > 1).mean()),
        "flyingHeight_m": spread(flying),
        "groundHeight_m": spread(plan.ground),
        "pulses": _count_pulses(plan),
    }


def spread(values):
    """Minimum, mean and maximum; 0 without values."""
    if not len(values):
        return {"minimum": 0.0, "mean": 0.0, "maximum": 0.0}
    return {
        "minimum": float(values.min()),
        "mean": float(values.mean()),
        "maximum": float(values.max()),
    }


def _count_pulses(plan):
    """Pulses that are emitted to the ground on the lines, of all channels."""
    return round(plan.pattern["lineLength_m"] / plan.design.speed * plan.swath.GetPulseRate())


def _lines(plan):
    """Yields a row per flight line."""
    lengths = line_lengths(plan.flight)
    for number, places in enumerate(line_waypoints(plan.flight)):
        begin, end, length = places[0], places[-1], float(lengths[number])
        yield {
            "line": number,
            "begin": begin.tolist(),
            "end": end.tolist(),
            "lowest_m": float(places[:, 2].min()),
            "highest_m": float(places[:, 2].max()),
            "heading_deg": math.degrees(math.atan2(*(end - begin)[:2])) % 360.0,
            "length_m": length,
            "time_s": length / plan.design.speed,
            "waypoints": len(places),
        }
