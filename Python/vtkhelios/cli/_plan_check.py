# SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
# SPDX-License-Identifier: BSD-3-Clause
"""Predicted against simulated coverage: the survey of a plan is run, and its echoes are looked for."""

import math

import numpy as np
from vtkmodules.util.numpy_support import vtk_to_numpy
from vtkmodules.vtkCommonCore import reference, vtkIdList, vtkPoints
from vtkmodules.vtkCommonDataModel import vtkPolyData, vtkStaticPointLocator
from vtkmodules.vtkIOXML import vtkXMLPPolyDataReader

import vtkhelios

from ..array_names import COVERABLE, NORMAL, NUMBER_OF_SCANS, RETURN_NUMBER
from ..core.arrays import numpy_to_vtk
from ..core.reading import make_reader
from ..core.run_files import POINTS, file_of_leg
from ..core.words import counted
from ._progress import make_progress
from ._stopping import Interrupted, StopRequest, run_player, set_outcome

SAME_PULSE = 1e-7  # rad, between the directions of the returns of a pulse
STEEPEST = 0.02  # cosine of incidence; lower limit for the echo spacing at grazing incidence


def simulate(survey, arguments, folder, messages, stands_still=False):
    """Runs a survey without noise; returns an exit code and the output folder. With stands_still parts do not move."""
    reader = make_reader(str(survey), arguments.assets)
    messages.watch(reader)
    if not reader.Read():
        messages.error_unless_told(f"{survey}: cannot be read")
        return 1, None
    player = vtkhelios.vtkHeliosSurveyPlayer()
    messages.watch(player)
    player.SetSurvey(reader.GetSurvey())
    player.SetOutputDirectory(str(folder))
    player.SetFormat("vtp")
    player.GetOptions().SetNoise(False)
    player.GetOptions().SetWithout("partMotion" if stands_still else "")
    player.SetOverwrite(True)
    set_outcome(" during the simulation of the survey; the plan itself is written")
    with StopRequest(player) as request, make_progress(player, messages, quiet=arguments.quiet):
        succeeded = run_player(player)
    if request.signal:
        raise Interrupted(request.signal)
    if not succeeded:
        messages.error_unless_told(player.GetMessage())
        return 1, None
    return 0, player.GetRunFolder()


def compare(clouds, plan, settings, angular_step):
    """Predicted and simulated coverage of the coverable test points.

    A test point is covered if an echo is within the tolerance; or, for coarser scans, if the
    nearest pulse, at most half the pulse spacing away, has an echo on the surface there.
    Requirements of the plan on a line of sight (range, incidence ...) that the scanner does not
    enforce must also hold.
    """
    points = vtkhelios.arrays(plan.test_points.data)
    coverable = points[COVERABLE] > 0
    places = points["points"][coverable]
    predicted = points[NUMBER_OF_SCANS][coverable] > 0
    normals = points[NORMAL][coverable] if NORMAL in points else None
    scanners = plan.positions
    tolerance = settings["hitTolerance_m"]
    near = np.zeros(len(places), dtype=bool)
    passed = np.zeros(len(places), dtype=bool)
    finest = np.full(len(places), np.inf)
    echoes = 0
    for cloud, scanner in zip(clouds, scanners, strict=True):
        echoes += cloud.GetNumberOfPoints()
        sights = Sights(places, normals, scanner, angular_step)
        wanted = sights.find_wanted(settings)
        spacing = sights.half_spacing()
        finest = np.minimum(finest, spacing)
        near |= find_near(cloud, places, wanted & ~near, tolerance)
        coarse = wanted & (spacing > tolerance) & ~near & ~passed
        passed |= find_passed(cloud, sights, coarse, tolerance)
    met = near | passed
    count = max(1, len(places))
    return {
        "predicted_percent": 100.0 * predicted.sum() / count,
        "simulated_percent": 100.0 * met.sum() / count,
        "withinTolerance_percent": 100.0 * near.sum() / count,
        "predictedNotMet": int((predicted & ~met).sum()),
        "metNotPredicted": int((met & ~predicted).sum()),
        "coarse_percent": 100.0 * (finest > tolerance).sum() / count,
        "echoes": echoes,
    }


class Sights:
    """The lines of sight from a scanner to some positions, ignoring occlusion."""

    def __init__(self, places, normals, scanner, angular_step):
        sights = places - scanner
        self.scanner = scanner
        self.half_step = math.radians(angular_step) * math.sqrt(0.5)  # half a diagonal
        self.ranges = np.maximum(np.linalg.norm(sights, axis=1), 1e-12)
        self.directions = sights / self.ranges[:, None]
        self.elevations = np.degrees(np.arcsin(np.clip(sights[:, 2] / self.ranges, -1.0, 1.0)))
        self.cosines = np.ones(len(places))
        if normals is not None:
            self.cosines = np.abs(np.einsum("ij,ij->i", sights, normals)) / self.ranges
        self.steps = math.radians(angular_step) * self.ranges

    def half_spacing(self):
        """Half the diagonal between four neighbouring echoes on a surface there [m]."""
        return 0.5 * np.hypot(self.steps, self.steps / np.maximum(self.cosines, STEEPEST))

    def range_differences(self):
        """Range differences on a surface there between pulses half a step apart [m]."""
        cosines = np.maximum(self.cosines, STEEPEST)
        return self.half_step * self.ranges * np.sqrt(1.0 - cosines**2) / cosines

    def find_wanted(self, settings):
        """Returns the points required by the plan, by range, elevation, incidence and density."""
        incidence = np.degrees(np.arccos(np.clip(self.cosines, 0.0, 1.0)))
        thin = settings["minDensity_1_m2"] * self.steps**2 > self.cosines
        return (
            (self.ranges >= settings["rangeMin_m"])
            & (self.ranges <= settings["rangeMax_m"])
            & (self.elevations >= settings["elevationMin_deg"])
            & (self.elevations <= settings["elevationMax_deg"])
            & (incidence <= settings["maxIncidence_deg"])
            & ~thin
        )


def find_near(cloud, places, wanted, tolerance):
    """Which of the wanted positions have an echo within the tolerance."""
    near = np.zeros(len(places), dtype=bool)
    if cloud.GetNumberOfPoints() > 0:
        locator = make_locator(cloud)
        squared = reference(0.0)
        for index in np.flatnonzero(wanted):
            found = locator.FindClosestPointWithinRadius(tolerance, places[index], squared)
            near[index] = found >= 0
    return near


def find_passed(cloud, sights, wanted, tolerance):
    """Which of the wanted positions have an echo of the nearest pulse on their surface."""
    passed = np.zeros(len(wanted), dtype=bool)
    if cloud.GetNumberOfPoints() == 0 or not wanted.any():
        return passed
    beams = vtk_to_numpy(cloud.GetPoints().GetData()) - sights.scanner
    ranges = np.maximum(np.linalg.norm(beams, axis=1), 1e-12)
    sphere = vtkPolyData()
    sphere.SetPoints(vtkPoints())
    sphere.GetPoints().SetData(numpy_to_vtk(beams / ranges[:, None], deep=True))
    locator = make_locator(sphere)
    allowed = tolerance + sights.range_differences()
    squared, returns = reference(0.0), vtkIdList()
    for index in np.flatnonzero(wanted):
        direction = sights.directions[index]
        nearest = locator.FindClosestPointWithinRadius(sights.half_step, direction, squared)
        if nearest >= 0:
            locator.FindPointsWithinRadius(SAME_PULSE, sphere.GetPoint(nearest), returns)
            found = (ranges[returns.GetId(i)] for i in range(returns.GetNumberOfIds()))
            passed[index] = any(abs(r - sights.ranges[index]) <= allowed[index] for r in found)
    return passed


def make_locator(points):
    locator = vtkStaticPointLocator()
    locator.SetDataSet(points)
    locator.BuildLocator()
    return locator


def read_clouds(folder, count):
    """Yields the points of every leg, one cloud at a time; empty for a leg without points."""
    for leg in range(count):
        reader = vtkXMLPPolyDataReader()
        reader.SetFileName(f"{folder}/{file_of_leg(leg, POINTS, 'vtp')}")
        reader.UpdateInformation()
        reader.GetPointDataArraySelection().DisableAllArrays()
        reader.Update()
        yield reader.GetOutput()


def read_strips(folder, count):
    """Yields the first returns of every strip of a flight, n x 3 [m], one strip at a time."""
    for strip in range(count):
        stem = vtkhelios.vtkHeliosRunFiles.GetStripStem(f"{strip:03}")
        path = f"{folder}/{vtkhelios.vtkHeliosRunFiles.GetFileName(stem, POINTS, 'vtp')}"
        reader = vtkXMLPPolyDataReader()
        reader.SetFileName(path)
        reader.UpdateInformation()
        reader.GetPointDataArraySelection().DisableAllArrays()
        reader.GetPointDataArraySelection().EnableArray(RETURN_NUMBER)
        reader.Update()
        cloud = vtkhelios.arrays(reader.GetOutput())
        yield cloud["points"][cloud[RETURN_NUMBER] == 1]


def check_lines(check, tolerance):
    """Yields the result of the comparison."""
    yield (
        f"check    predicted {check['predicted_percent']:.2f} %, simulated "
        f"{check['simulated_percent']:.2f} % of the coverable test points, by "
        f"{counted(check['echoes'], 'echo')}; {counted(check['predictedNotMet'], 'false positive')}, "
        f"{counted(check['metNotPredicted'], 'false negative')}"
    )
    if check["coarse_percent"] > 1:
        yield (
            f"         the scans are coarser than --tolerance ({tolerance:g} m) at "
            f"{check['coarse_percent']:.0f} % of them, where the nearest pulse counts instead; "
            "give a finer --resolution"
        )


def explain_difference(check, settings):
    """Advice if the simulated coverage differs from the predicted one; None if equal."""
    difference = check["predicted_percent"] - check["simulated_percent"]
    if abs(difference) <= 1:
        return None
    text = f"simulated coverage is {abs(difference):.1f} % {'below' if difference > 0 else 'above'} predicted"
    if difference > 0 and not settings["scannerLimits"]:
        return f"{text}: range gate and field of view of the scanner were ignored; give --scanner-limits"
    return f"{text}; try a finer --resolution or a smaller --test-grid"
