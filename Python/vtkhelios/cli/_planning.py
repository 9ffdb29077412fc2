# SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
# SPDX-License-Identifier: BSD-3-Clause
"""The pipeline of a plan: from a file to the positions to scan from, one step after the other."""

import re
import time

import vtkhelios

from ._messages import Messages
from ._progress import Pace, duration

METHODS = ["reduce", "bestcoverage", "greedy", "best", "optimal"]
GROUND = {"auto": "Automatic", "true": "Ground", "false": "Highest", "open": "OpenGround"}
LINES = {"all": (True, True), "vertical": (True, False), "horizontal": (False, True)}

# Properties in errors of the filters, and the options that set them.
OPTIONS = {
    "MaximumSlope": "--max-slope",
    "XStep": "--grid",
    "YStep": "--grid-y",
    "ZStep": "--test-grid",
    "steps": "steps (--grid, --test-grid)",
    "Region": "--region",
    "MemoryLimit": "--memory",
    "HitTolerance": "--tolerance",
    "MinimumRange": "--range-min",
    "MaximumRange": "--range-max",
    "MinimumElevation": "--elevation-min",
    "MaximumElevation": "--elevation-max",
    "MaximumIncidenceAngle": "--max-incidence",
    "MinimumPointDensity": "--min-density",
    "MinimumCoverage": "--coverage",
    "CoverageOf": "--coverage-of",
    "MinimumOverlap": "--overlap",
    "Surface": "--ground",
    "Method": "--method",
    "TimeLimit": "--time-limit",
    "Platform": "--platform",
    "Scanner": "--scanner",
}
WORDS = re.compile(r"(?<![\w=\"/.])(" + "|".join(OPTIONS) + r")(?![\w=\"/.]*=|\w)")


class PlanMessages(Messages):
    """Names options instead of properties in errors, and omits interrupted steps."""

    interrupted = False

    def error(self, text):
        if not self.interrupted:
            super().error(WORDS.sub(lambda found: OPTIONS[found[1]], text))


class Steps:
    """The steps of a plan with a player's interface, for progress and interrupts."""

    def __init__(self, messages):
        self.seconds = {}  # by step name
        self._messages = messages
        self._algorithm = None
        self._name = "loading"
        self._pace = Pace()
        self._callback = None

    def run(self, name, algorithm, even=True):
        """Updates an algorithm; returns False after an error or if stopped.

        If its progress is uneven, no remaining time is shown.
        """
        if self._messages.interrupted:
            return False
        self._name, self._algorithm, self._pace = name, algorithm, Pace() if even else None
        self._messages.watch(algorithm)
        tag = algorithm.AddObserver("ProgressEvent", self._on_progress)
        start = time.monotonic()
        self._tell()
        errors = self._messages.errors
        algorithm.Update()
        algorithm.RemoveObserver(tag)
        self.seconds[name] = time.monotonic() - start
        self._algorithm = None
        return self._messages.errors == errors and not self._messages.interrupted

    def _on_progress(self, *_):
        if self._pace:
            self._pace.add(time.monotonic(), self._algorithm.GetProgress())
        self._tell()

    def _tell(self):
        if self._callback:
            self._callback()

    # Interface of a player.

    def Abort(self):
        self._messages.interrupted = True
        if self._algorithm:
            self._algorithm.SetAbortExecute(1)

    def AddObserver(self, _event, callback):
        self._callback = callback
        return 1

    def RemoveObserver(self, _tag):
        self._callback = None

    def GetNumberOfPulsesDone(self):
        return 0  # reported by a message

    def GetProgress(self):
        return self._algorithm.GetProgress() if self._algorithm else 0.0

    def GetMessage(self):
        left = self._pace.remaining(1.0) if self._pace else None
        return self._name if left is None else f"{self._name}, {duration(left)} left"


class Plan:
    """The filters of a plan, configured by the arguments, or else the document."""

    def __init__(self, arguments, document):
        self.arguments = arguments
        self.document = document
        self.settings = self.choose_settings()
        self.candidates = self.make_candidates()
        self.test_points = self.make_test_points()
        self.viewsheds = self.make_viewsheds()
        self.planner = self.make_planner()

    def run(self, steps):
        """Runs all filters; returns False after an error or if stopped."""
        return (
            steps.run("loading the scene", self.document)
            and steps.run("finding candidates", self.candidates)
            and steps.run("finding test points", self.test_points)
            and steps.run(self.describe_viewsheds(), self.viewsheds)
            and steps.run(self.describe_choice(), self.planner, even=False)
        )

    def describe_viewsheds(self):
        positions = self.candidates.GetOutput().GetNumberOfPoints()
        points = self.test_points.GetOutput().GetNumberOfPoints()
        return f"viewsheds of {positions:,} candidates, {points:,} test points"

    def describe_choice(self):
        limit = self.settings.get("timeLimit_s")
        return "selecting positions" + (f", search limited to {limit:g} s" if limit else "")

    def choose_settings(self):
        """All settings of the plan, as JSON: options override the document."""
        given, document = self.arguments, self.document
        grid = chosen(given.grid, document.GetXStep())
        grid_y = grid if given.grid and not given.grid_y else document.GetYStep() or grid
        own_test_grid = document.GetTestPointStep() if not given.grid else grid
        method = chosen(given.method, document.GetMethod() or "best")
        first = "largest" if document.GetRemoveLargestFirst() else "smallest"
        settings = {
            "method": method,
            "grid_m": grid,
            "gridY_m": chosen(given.grid_y, grid_y),
            "testGrid_m": chosen(given.test_grid, own_test_grid),
            "testLines": chosen(given.test_lines, document.GetTestLines()),
            "region_m": given.region,
            "exclude": given.exclude,
            "maxSlope_deg": chosen(given.max_slope, document.GetMaximumSlope()),
            "ground": chosen(given.ground, document.GetGroundOnly()),
            "enclosed": given.enclosed or document.GetEnclosed(),
            "height_m": chosen(given.height, document.GetScannerHeight()),
            "hitTolerance_m": chosen(given.tolerance, document.GetHitTolerance()),
            "hitBehind": document.GetHitBehind() and not given.two_sided,
            "scannerLimits": document.GetScannerLimits(),
            "rangeMin_m": chosen(given.range_min, document.GetRangeMin()),
            "rangeMax_m": min(1e9, chosen(given.range_max, document.GetRangeMax())),
            "elevationMin_deg": chosen(given.elevation_min, document.GetElevationMin()),
            "elevationMax_deg": chosen(given.elevation_max, document.GetElevationMax()),
            "maxIncidence_deg": chosen(given.max_incidence, document.GetMaximumIncidenceAngle()),
            "minDensity_1_m2": chosen(given.min_density, document.GetMinimumPointDensity()),
            "coverage_percent": chosen(given.coverage, document.GetMinimumCoverage()),
            "coverageOf": chosen(
                given.coverage_of, "all" if document.GetCoverageOfAll() else "coverable"
            ),
            "areaWeights": given.area_weights or document.GetUseAreas(),
            "overlap_percent": chosen(given.overlap, 100.0 * document.GetMinimumOverlap()),
        }
        if method == "reduce":
            settings["removeOrder"] = chosen(given.remove_order, document.GetRemoveOrder())
            settings["removeFirst"] = chosen(given.remove_first, first)
        if method == "optimal":
            settings["timeLimit_s"] = chosen(given.time_limit, document.GetTimeLimit())
        return settings

    def make_candidates(self):
        settings = self.settings
        candidates = vtkhelios.vtkHeliosScanPositionCandidates()
        candidates.SetInputConnection(0, self.document.GetOutputPort())
        if self.arguments.exclude:
            reader = vtkhelios.vtkHeliosPointXMLReader()
            reader.SetFileName(self.arguments.exclude)
            candidates.SetInputConnection(1, reader.GetOutputPort())
        candidates.SetXStep(settings["grid_m"])
        candidates.SetYStep(settings["gridY_m"])
        if self.arguments.region:
            candidates.SetRegion(*self.arguments.region)
        candidates.SetMaximumSlope(settings["maxSlope_deg"])
        getattr(candidates, f"SetSurfaceTo{GROUND[settings['ground']]}")()
        candidates.SetSkipEnclosed(not settings["enclosed"])
        candidates.SetScannerHeight(settings["height_m"])
        candidates.SetMemoryLimit(self.arguments.memory)
        return candidates

    def make_test_points(self):
        vertical, horizontal = LINES[self.settings["testLines"]]
        points = vtkhelios.vtkHeliosVisibilityTestPoints()
        points.SetInputConnection(0, self.document.GetOutputPort())
        points.SetStep(self.settings["testGrid_m"])
        points.SetVertical(vertical)
        points.SetHorizontal(horizontal)
        points.SetGenerateAreas(self.settings["areaWeights"])
        points.SetMemoryLimit(self.arguments.memory)
        return points

    def make_viewsheds(self):
        settings = self.settings
        viewsheds = vtkhelios.vtkHeliosViewsheds()
        viewsheds.SetInputConnection(0, self.document.GetOutputPort())
        viewsheds.SetInputConnection(1, self.candidates.GetOutputPort())
        viewsheds.SetInputConnection(2, self.test_points.GetOutputPort())
        viewsheds.SetHitTolerance(settings["hitTolerance_m"])
        viewsheds.SetBothSides(not settings["hitBehind"])
        viewsheds.SetMinimumRange(settings["rangeMin_m"])
        viewsheds.SetMaximumRange(settings["rangeMax_m"])
        viewsheds.SetMinimumElevation(settings["elevationMin_deg"])
        viewsheds.SetMaximumElevation(settings["elevationMax_deg"])
        viewsheds.SetMaximumIncidenceAngle(settings["maxIncidence_deg"])
        viewsheds.SetMinimumPointDensity(settings["minDensity_1_m2"])
        viewsheds.SetAngularStep(self.document.GetLegAngularStep())
        viewsheds.SetMemoryLimit(self.arguments.memory)
        return viewsheds

    def make_planner(self):
        settings = self.settings
        planner = vtkhelios.vtkHeliosScanPositionPlanner()
        planner.SetInputConnection(0, self.viewsheds.GetOutputPort())
        planner.SetInputConnection(1, self.test_points.GetOutputPort())
        by_size = settings.get("removeOrder") != "meanIncidenceAngle"
        method = {
            "reduce": planner.VIEWSHED_SIZE if by_size else planner.MEAN_INCIDENCE_ANGLE,
            "bestcoverage": planner.GREEDY,
            "greedy": planner.GREEDY,
            "best": planner.BEST,
            "optimal": planner.OPTIMAL,
        }
        planner.SetMethod(method[settings["method"]])
        if settings.get("removeFirst") == "largest":
            planner.SetRemovalOrderToDescending()
        planner.SetMinimumCoverage(settings["coverage_percent"])
        planner.SetCoverageOf(planner.ALL if settings["coverageOf"] == "all" else planner.COVERABLE)
        planner.SetUseAreas(settings["areaWeights"])
        planner.SetMinimumOverlap(settings["overlap_percent"] / 100.0)
        planner.SetTimeLimit(settings.get("timeLimit_s", planner.GetTimeLimit()))
        return planner


def chosen(option, document):
    """An option, else the value of the document."""
    return document if option is None else option
