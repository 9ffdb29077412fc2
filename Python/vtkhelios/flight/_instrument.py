# SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
# SPDX-License-Identifier: BSD-3-Clause
"""The scanner of a flight plan: its limits, and the distribution of its pulses across the path."""

import functools
import math

from .. import catalogue
from ..core.classes import vtk_class
from ..core.folders import data_directory
from ..core.paths import to_vtk
from ..core.pipeline import MessageLog, PipelineError, conclude, perform
from ..plans.kinds import SettingError
from ._settings import PLATFORM, PLATFORMS

SWEEPS = {"rotating": 1, "oscillating": 2, "conic": 2, "palmer": 2}  # per scan period


class Instrument:
    """A scanner on a moving platform.

    optics, pulse_frequencies [Hz], scan_frequencies (lowest, highest) [Hz], largest_angle [deg],
    range_max [m] or None, use: as in the catalogue.
    """

    def __init__(self, scanner, platform, assets=()):
        self.scanner = scanner if "#" in scanner else f"{catalogue.find_file(scanner)}#{scanner}"
        self._assets = assets
        self.use = self._find_use()
        platform = platform or PLATFORMS.get(self.use, PLATFORM)
        self.platform = platform if "#" in platform else f"platforms.xml#{platform}"
        survey = self._make_survey({})
        self._texts = functools.partial(survey.GetScannerAttribute, 0)
        self.optics = self._texts("optics") or "rotating"
        self.channels = survey.GetNumberOfChannels(0)
        frequencies = self._texts("pulseFreqs_Hz").split(",")
        self.pulse_frequencies = [float(each) for each in frequencies if each.strip()]
        self.scan_frequencies = self._number("scanFreqMin_Hz", 0), self._number("scanFreqMax_Hz", 0)
        self.largest_angle = self._find_largest_angle()
        self.scan_product = self._number("scanProduct", math.inf)
        self.range_max = self._number("rangeMax_m", None)
        self.range_min = self._number("rangeMin_m", 0.0)

    def has_lines(self):
        """Returns whether the scan frequency sets the spacing along the path."""
        return self.optics in SWEEPS

    @property
    def sweeps(self):
        """Lines across the path per scan period."""
        return SWEEPS.get(self.optics, 1)

    def highest_scan_frequency(self, angle):
        """At a scan angle [deg]: of the scanner, and of its scan product."""
        highest = self.scan_frequencies[1] or math.inf
        return min(highest, self.scan_product / angle) if angle else highest

    def make_swath(self, pulse_frequency, scan_frequency=None, scan_angle=None):
        """Returns a vtkHeliosSwath of these settings; None: the scanner's default."""
        attributes = {"pulseFreq_hz": pulse_frequency}
        if scan_frequency:
            attributes["scanFreq_hz"] = scan_frequency
        if scan_angle:
            attributes["scanAngle_deg"] = scan_angle
        survey = self._make_survey(attributes)
        swath = vtk_class("vtkHeliosSwath")()
        perform(swath, lambda: swath.Build(survey, 0), f"{self.scanner}: has no swath")
        return swath

    def _make_survey(self, attributes):
        survey = vtk_class("vtkHeliosSurvey")()
        shipped = data_directory()
        with MessageLog() as log:
            log.watch(survey)
            for folder in [*self._assets, ".", shipped, shipped / "Assets"]:
                survey.AddAssetDirectory(to_vtk(folder))
            scanner = survey.AddScannerFromFile(to_vtk(self.scanner))
            platform = survey.AddPlatformFromFile(to_vtk(self.platform))
            good = scanner >= 0 and platform >= 0
            attributes = {**(_middle_frequency(survey) if good else {}), **attributes}
            for leg in range(2 if good else 0):
                survey.AddLeg(scanner, platform)
                survey.SetLegAttribute(leg, "x", str(float(leg)))
                for name, value in attributes.items():
                    good = survey.SetLegAttribute(leg, name, repr(float(value))) and good
            if good and not survey.IsMoving():
                raise SettingError(
                    "{0} is {name}, which does not move; give one such as airplane_linearpath",
                    "platform",
                    name=self.platform,
                )
            good = good and survey.Check()
        conclude(log)
        if not good:
            raise PipelineError([f"{self.scanner} on {self.platform}: cannot be used"])
        return survey

    def _find_use(self):
        """Returns the use of the scanner in the catalogue: the survey does not read it."""
        known = catalogue.find_scanners("", self._assets, warn=lambda _: None)
        return next((each.use for each in known if each.reference == self.scanner), "airborne")

    def _find_largest_angle(self):
        largest = self._number("scanAngleMax_deg", 0.0)
        if self.optics == "rotating":
            return self._number("scanAngleEffectiveMax_deg", 0.0) or largest
        return largest

    def _number(self, name, default):
        text = self._texts(name)
        return float(text) if text else default


def _middle_frequency(survey):
    """Returns a scan frequency within the limits of the scanner, also with its largest angle, if it
    has any."""

    def number(name, default):
        text = survey.GetScannerAttribute(0, name)
        return float(text) if text else default

    low, high = number("scanFreqMin_Hz", 0.0), number("scanFreqMax_Hz", 0.0)
    if not high:
        return {}
    fastest = number("scanProduct", math.inf) / max(number("scanAngleMax_deg", 0.0), 1e-9)
    return {"scanFreq_hz": max(low, min((low + high) / 2, fastest))}
