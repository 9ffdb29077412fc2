# SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
# SPDX-License-Identifier: BSD-3-Clause
"""The settings of a plan: one row each, with its name in reports and the properties that it sets.

A setting has the same name as the option of the command line: ``max_slope``, ``--max-slope``.
"""

import difflib
import math

from .kinds import (
    Areas, Choice, DocumentChoice, Flag, Number, PlanNumber, PlanOption, PlanString, Reference, Region,
    SettingError, objects_of,
)  # fmt: skip
from .places import Places

__all__ = ["SETTINGS", "SettingError", "check_settings", "fill_document", "fill_filters"]

METHODS = {  # names in the planner, too; reduce also takes the removal criteria
    "reduce": None,
    "bestcoverage": "greedy",
    "greedy": "greedy",
    "best": "best",
    "optimal": "optimal",
}
REMOVE_ORDERS = {"viewshedSize": "viewshed_size", "meanIncidenceAngle": "mean_incidence_angle"}
LINES = {"all": (True, True), "vertical": (True, False), "horizontal": (False, True)}
GROUND = {
    "auto": ("automatic",),
    "true": ("ground",),
    "false": ("highest",),
    "open": ("open_ground",),
}
COVERAGE_OF = {"coverable": ("coverable",), "all": ("all",)}
ORDERS = {"gain": (), "walk": (), "round": ()}
ON = {"ground": "auto", "any": "false"}  # and words of ground
REGION_OF = {"candidates": (), "all": ()}
REMOVE_FIRST = {"smallest": ("ascending",), "largest": ("descending",)}

# In the order of reports. The last ones are not in their list of settings.
SETTINGS = {
    "method": DocumentChoice("method", "document.method", words=METHODS),
    "grid": Number("grid_m", "candidates.x_step", unit="m", low=1e-6),
    "grid_y": Number("gridY_m", "candidates.y_step", unit="m", low=1e-6),
    "test_grid": Number(
        "testGrid_m",
        "test_points.x_step",
        "test_points.y_step",
        "test_points.z_step",
        unit="m",
        low=1e-6,
    ),
    "test_lines": Choice(
        "testLines", "test_points.vertical", "test_points.horizontal", words=LINES
    ),
    "region": Region("region_m", "candidates.region"),
    "region_of": PlanOption("regionOf", words=REGION_OF),
    "candidates": Places("candidates"),
    "exclude": Areas("exclude"),
    "on": PlanOption(None, words=ON),
    "max_slope": Number("maxSlope_deg", "candidates.maximum_slope", unit="deg"),
    "ground": Choice("ground", "candidates.surface", words=GROUND),
    "enclosed": Flag("enclosed", "candidates.skip_enclosed", inverted=True),
    "height": Number("height_m", "candidates.scanner_height", unit="m"),
    "tolerance": Number("hitTolerance_m", "viewsheds.hit_tolerance", unit="m"),
    "two_sided": Flag("hitBehind", "viewsheds.both_sides", reports_opposite=True),
    "scanner_limits": Flag("scannerLimits", "document.use_scanner_limits"),
    "moving_parts": Flag("movingParts", "document.use_moving_parts"),
    "range_min": Number("rangeMin_m", "viewsheds.minimum_range", unit="m"),
    "range_max": Number("rangeMax_m", "viewsheds.maximum_range", unit="m"),
    "elevation_min": Number("elevationMin_deg", "viewsheds.minimum_elevation", unit="deg"),
    "elevation_max": Number("elevationMax_deg", "viewsheds.maximum_elevation", unit="deg"),
    "max_incidence": Number("maxIncidence_deg", "viewsheds.maximum_incidence_angle", unit="deg"),
    "min_density": Number("minDensity_1_m2", "viewsheds.minimum_point_density", unit="1/m2"),
    "coverage": Number("coverage_percent", "planner.minimum_coverage", unit="%", low=1e-6),
    "objects": Number("objects_percent", "planner.minimum_object_coverage", unit="%"),
    "coverage_of": Choice("coverageOf", "planner.coverage_of", words=COVERAGE_OF),
    "area_weights": Flag("areaWeights", "planner.use_areas", "test_points.generate_areas"),
    "overlap": Number("overlap_percent", "planner.minimum_overlap", unit="%", scale=100.0),
    "remove_order": DocumentChoice("removeOrder", "document.remove_order", words=REMOVE_ORDERS),
    "remove_first": Choice("removeFirst", "planner.removal_order", words=REMOVE_FIRST),
    "order": PlanOption("order", words=ORDERS),
    "setup_time": PlanNumber("setupTime_s", unit="s", low=0.0, high=1e5, default=300.0),
    "walking_speed": PlanNumber("walkingSpeed_m_s", unit="m/s", low=0.01, high=100.0, default=1.0),
    "crs": PlanString("crs"),
    "time_limit": Number("timeLimit_s", "planner.time_limit", unit="s"),
    "memory": Number(
        None,
        "candidates.memory_limit",
        "test_points.memory_limit",
        "viewsheds.memory_limit",
        unit="MiB",
    ),
    "platform": Reference(None, "document.platform", "platforms.xml"),
    "scanner": Reference(None, "document.scanner", "scanners.xml"),
    "resolution": Number(None, "document.resolution", unit="deg", low=1e-6),
    "pulse_frequency": Number(None, "document.pulse_frequency", unit="Hz", low=1e-3),
}

ONLY_OF = {"remove_order": "reduce", "remove_first": "reduce", "time_limit": "optimal"}
RANGES = (("range_min", "range_max"), ("elevation_min", "elevation_max"))


def check_settings(given):
    """Returns the given settings, checked, without those that are None."""
    for name in given:
        if name not in SETTINGS:
            near = difflib.get_close_matches(name, SETTINGS, 1, 0.6)
            hint = f"did you mean {near[0]}?" if near else f"settings are: {', '.join(SETTINGS)}"
            raise TypeError(f"{name} is not a setting of a plan; {hint}")
    given = {
        name: SETTINGS[name].check(name, value)
        for name, value in given.items()
        if value is not None
    }
    _check_together(given)
    if "on" in given:
        given["ground"] = ON[given["on"]]
    return given


def _check_together(given):
    for first, second in (("on", "ground"), ("candidates", "grid_y")):
        if first in given and second in given:
            raise SettingError("{0} and {1} are both given; give one of them", first, second)
    if given.get("region_of") == "all" and "region" not in given:
        raise SettingError("{0} is all, and {1} is not given; give it", "region_of", "region")


def fill_document(document, given):
    """Sets the given settings that a document is read with."""
    for name, value in given.items():
        if SETTINGS[name].is_of_document():
            SETTINGS[name].set({"document": document}, value)


def fill_filters(plan, given):
    """Sets the given settings on the filters of a plan that has its document; returns all."""
    objects = objects_of(plan)
    values = {name: setting.read(objects) for name, setting in SETTINGS.items()}
    values["method"] = values["method"] or "best"
    values["scanner_limits"] = objects["document"].GetScannerLimits()
    values["moving_parts"] = objects["document"].GetMovingParts()
    if "grid" in given:
        given = {"grid_y": given["grid"], "test_grid": given["grid"], **given}
    for name, value in given.items():
        if not SETTINGS[name].is_of_document():
            SETTINGS[name].set(objects, value)
            values[name] = value
    if values["region_of"] == "all":
        plan.GetTestPoints().SetRegion(*given["region"], math.nan, math.nan)
    if values["objects"] and "coverage" not in given:
        # the objects' shares are enough
        objects["planner"].minimum_coverage = values["coverage"] = 0.0
    if values["objects"] and "area_weights" not in given:
        SETTINGS["area_weights"].set(objects, True)
        values["area_weights"] = True
    for name in ("method", "remove_order"):
        values[name] = given.get(name, values[name])
    method = METHODS[values["method"]] or REMOVE_ORDERS[values["remove_order"]]
    objects["planner"].method = method
    _check_ranges(values)
    return values


def _check_ranges(values):
    for low, high in RANGES:
        if values[low] >= values[high]:
            raise SettingError(
                "{0} is {low:g} and {1} is {high:g}, so nothing is visible; give a smaller {0} or a "
                "larger {1}",
                low,
                high,
                low=values[low],
                high=values[high],
            )


def report_settings(values):
    """Returns the settings in a report."""
    return {
        setting.reported: setting.report(values[name])
        for name, setting in SETTINGS.items()
        if setting.reported and ONLY_OF.get(name, values["method"]) == values["method"]
    }
