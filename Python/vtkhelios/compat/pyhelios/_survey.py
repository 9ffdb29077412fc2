# SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
# SPDX-License-Identifier: BSD-3-Clause
"""The survey of a simulation, its legs and their settings, its scanner and its platform."""

import itertools
import math

from ...core.paths import text_from_vtk, to_vtk
from ...surveys.items import change
from ._errors import Closed, NotCoveredError, PyHeliosToolsException
from ._output import Vector
from ._settings import DEGREES, Setting, Settings, name_all
from ._templates import KINDS, make_template


SCANNER, PLATFORM = KINDS


def has_template(settings):
    """Returns whether the settings of a leg have a template; the leg has its values."""
    return settings._template is not None


def get_template(settings):
    """Returns the settings of the template; what is set there changes no leg."""
    if settings._template is None:
        raise PyHeliosToolsException("the settings have no template; see hasTemplate()")
    return make_template(type(settings), settings._template)


class PlatformSettings(Settings):
    """Where a leg begins, and how the platform moves from there."""

    SETTINGS = name_all(
        [
            ("x", Setting("x", 0.0)),
            ("y", Setting("y", 0.0)),
            ("z", Setting("z", 0.0)),
            ("onGround is_on_ground", Setting("onGround", False)),
            ("movePerSec speed_m_s", Setting("movePerSec_m", 70.0)),
            ("stopAndTurn is_stop_and_turn", Setting("stopAndTurn", True)),
            ("smoothTurn is_smooth_turn", Setting("smoothTurn", False)),
            ("slowdownEnabled is_slowdown_enabled", Setting("slowdownEnabled", True)),
            ("yawAtDeparture yaw_angle", Setting("yawAtDeparture_deg", None, DEGREES)),
        ]
    )

    def __init__(self, leg):
        self._read, self._write, self._template = leg._read, leg._write, leg.template(PLATFORM)

    @property
    def position(self):
        return Vector(self.x, self.y, self.z)

    def set_position(self, x, y=None, z=None):
        x, y, z = (x, y, z) if y is not None else x
        self.x, self.y, self.z = x, y, z

    hasTemplate = has_template = has_template
    getTemplate = get_template = get_template


class ScannerSettings(Settings):
    """How the scanner of a leg is set; angles are in radians."""

    SETTINGS = name_all(
        [
            ("active is_active", Setting("active", True)),
            ("pulseFreq pulse_frequency", Setting("pulseFreq_hz", 0)),
            ("scanFreq scan_frequency", Setting("scanFreq_hz", 0.0)),
            ("scanAngle scan_angle", Setting("scanAngle_deg", None, DEGREES)),
            (
                "verticalAngleMin min_vertical_angle",
                Setting("verticalAngleMin_deg", None, DEGREES),
            ),
            (
                "verticalAngleMax max_vertical_angle",
                Setting("verticalAngleMax_deg", None, DEGREES),
            ),
            ("headRotatePerSec head_rotation", Setting("headRotatePerSec_deg", 0.0, DEGREES)),
            ("headRotateStart rotation_start_angle", Setting("headRotateStart_deg", 0.0, DEGREES)),
            ("headRotateStop rotation_stop_angle", Setting("headRotateStop_deg", 0.0, DEGREES)),
            ("beamDivAngle beam_divergence_angle", Setting("beamDivergence_rad", None)),
            (
                "trajectoryTimeInterval trajectory_time_interval",
                Setting("trajectoryTimeInterval_s", 0.0),
            ),
            (
                "verticalResolution vertical_resolution",
                Setting("verticalResolution_deg", 0.0, DEGREES),
            ),
            (
                "horizontalResolution horizontal_resolution",
                Setting("horizontalResolution_deg", 0.0, DEGREES),
            ),
        ]
    )

    def __init__(self, leg):
        self._read, self._write, self._template = leg._read, leg._write, leg.template(SCANNER)

    hasTemplate = has_template = has_template
    getTemplate = get_template = get_template


class ScanningStrip:
    """Legs that write one file."""

    def __init__(self, stripId):
        self.stripId = stripId


class Leg(Closed):
    """A leg, by its index."""

    def __init__(self, survey, index, templates=None):
        self._survey, self._index, self._templates = survey, index, templates

    def template(self, kind):
        """Returns the element of the template of a kind of settings, or None."""
        return self._templates.find(self._index, kind) if self._templates else None

    def _read(self, attribute):
        if attribute == "pulseFreq_hz":
            return str(self._survey.GetLegPulseFrequency(self._index))  # or the scanner's
        return text_from_vtk(self._survey.GetLegAttribute(self._index, attribute))

    def _write(self, attribute, text):
        change(self._survey, "SetLegAttribute", self._index, attribute, to_vtk(text))

    def getScannerSettings(self):
        return ScannerSettings(self)

    def getPlatformSettings(self):
        return PlatformSettings(self)

    scanner_settings = property(getScannerSettings)
    platform_settings = property(getPlatformSettings)

    @property
    def serialId(self):
        return self._index

    @serialId.setter
    def serialId(self, index):
        if index != self._index:
            raise NotCoveredError(
                f"Leg.serialId cannot be set to {index}: it is the place of the leg, {self._index}"
            )

    serial_id = serialId

    @property
    def strip(self):
        return ScanningStrip(self._read("stripId"))

    @strip.setter
    def strip(self, strip):
        self._write("stripId", strip.stripId)

    def isContainedInAStrip(self):
        return bool(self._read("stripId"))

    belongs_to_strip = isContainedInAStrip


class SurveyView(Closed):
    """The survey: its name, and the length of its legs."""

    OWNER = "Survey"

    def __init__(self, survey):
        self._survey, self._length = survey, 0.0

    @property
    def name(self):
        return text_from_vtk(self._survey.GetName())

    @name.setter
    def name(self, name):
        self._survey.SetName(to_vtk(name))

    @property
    def length(self):
        """The length of the straight lines from leg to leg [m], after calculateLength(); before it,
        0."""
        return self._length

    def getLength(self):
        return self._length

    def calculateLength(self):
        places = []
        for index in range(self._survey.GetNumberOfLegs()):
            place = [0.0, 0.0, 0.0]
            self._survey.GetLegPosition(index, place)
            places.append(place)
        self._length = sum(itertools.starmap(math.dist, itertools.pairwise(places)))

    calculate_length = calculateLength


class Detector(Settings):
    """The detector of the scanner."""

    SETTINGS = name_all(
        [
            ("accuracy", Setting("accuracy_m", 0.0)),
            ("rangeMin range_min", Setting("rangeMin_m", 0.0)),
            ("rangeMax range_max", Setting("rangeMax_m", math.inf)),
        ]
    )

    def __init__(self, scanner):
        self._read, self._write = scanner._read, scanner._write


class FwfSettings(Settings):
    """Waveforms and the sampling of the beam."""

    SETTINGS = name_all(
        [
            ("binSize_ns bin_size", Setting("binSize_ns", 0.25)),
            ("winSize_ns win_size", Setting("winSize_ns", 0.0)),
            ("beamSampleQuality beam_sample_quality", Setting("beamSampleQuality", 0)),
            ("maxFullwaveRange_ns max_fullwave_range", Setting("maxFullwaveRange_ns", 0.0)),
        ]
    )

    def __init__(self, scanner):
        self._read, self._write = scanner._read, scanner._write


class ScannerHead(Settings):
    """The head, which rotates about its axis; speeds are in radians per second."""

    SETTINGS = name_all(
        [("rotatePerSecMax rotate_per_sec_max", Setting("headRotatePerSecMax_deg", 0.0, DEGREES))]
    )

    def __init__(self, scanner):
        self._read, self._write = scanner._read, scanner._write


class BeamDeflector(Settings):
    """The optics; angles are in radians."""

    SETTINGS = name_all(
        [
            ("optics_type", Setting("optics", "")),
            ("scanFreqMin scan_freq_min", Setting("scanFreqMin_Hz", 0.0)),
            ("scanFreqMax scan_freq_max", Setting("scanFreqMax_Hz", 0.0)),
            ("scanAngleMax scan_angle_max", Setting("scanAngleMax_deg", 0.0, DEGREES)),
        ]
    )

    def __init__(self, scanner):
        self._read, self._write = scanner._read, scanner._write

    def getOpticsType(self):
        return self.optics_type.upper()


QUALITY = 3  # beamSampleQuality of HELIOS++ if none is given


class Scanner(Settings):
    """The first scanner of the survey; what is set holds for all channels."""

    SETTINGS = name_all(
        [
            ("averagePower average_power", Setting("averagePower_w", 4.0)),
            ("beamDivergence beam_divergence", Setting("beamDivergence_rad", 0.0003)),
            ("beamQuality beam_quality", Setting("beamQualityFactor", None)),
            ("efficiency", Setting("opticalEfficiency", 0.99)),
            ("receiverDiameter receiver_diameter", Setting("receiverDiameter_m", 0.15)),
            ("visibility", Setting("atmosphericVisibility_km", 23.0)),
            ("wavelength", Setting("wavelength_nm", 1064e-9, 1e9)),
            ("maxNOR max_nor", Setting("maxNOR", 0)),
            ("pulseLength_ns pulse_length", Setting("pulseLength_ns", 4.0)),
        ]
    )

    def __init__(self, survey):
        self._survey = survey

    def _read(self, attribute):
        return text_from_vtk(self._survey.GetScannerAttribute(0, attribute))

    def _write(self, attribute, text):
        change(self._survey, "SetScannerAttribute", 0, attribute, to_vtk(text))

    def getSupportedPulseFrequencies(self):
        """In hertz, as integers."""
        text = self._read("pulseFreqs_Hz")
        return [round(float(word)) for word in text.split(",") if word.strip()]

    supported_pulse_freqs_hz = property(getSupportedPulseFrequencies)

    def getDetector(self):
        return Detector(self)

    detector = property(getDetector)

    @property
    def fwfSettings(self):
        return FwfSettings(self)

    FWF_settings = fwfSettings

    @property
    def deviceId(self):
        return self.getDeviceId(0)

    device_id = deviceId

    def getNumDevices(self):
        return self._survey.GetNumberOfChannels(0)

    num_devices = property(getNumDevices)

    def getDeviceId(self, index):
        """Returns the id of the scanner; of a channel of several, with its number."""
        count = self.getNumDevices()
        if not 0 <= index < count:
            raise IndexError(f"there is no device {index}; there are {count}")
        name = text_from_vtk(self._read("id") or self._survey.GetScannerName())
        return name if count == 1 else f"{name}_{index}"

    @property
    def numRays(self):
        """The sub-rays of beamSampleQuality, by default 3; without it beams are sampled adaptively."""
        quality = self.fwfSettings.beamSampleQuality or QUALITY
        return 1 + 3 * quality * (quality - 1)

    num_rays = numRays

    def getScannerHead(self, index=0):
        return ScannerHead(self)

    def getBeamDeflector(self, index=0):
        return BeamDeflector(self)

    scanner_head, beam_deflector = property(getScannerHead), property(getBeamDeflector)

    def toString(self):
        return (
            f"Scanner: {self.deviceId}\nDevice[0]: {self.deviceId}\n"
            f"\tAverage Power: {self.averagePower:g} W\n"
            f"\tBeam Divergence: {1e3 * self.beamDivergence:g} mrad\n"
            f"\tWavelength: {1e9 * self.wavelength:g} nm\n"
            f"\tVisibility: {self.visibility:g} km\n"
        )

    to_string = toString


class Platform(Settings):
    """The first platform of the survey."""

    SETTINGS = name_all([("name", Setting("name", "")), ("type", Setting("type", ""))])

    def __init__(self, survey):
        self._survey = survey

    def _read(self, attribute):
        return text_from_vtk(self._survey.GetPlatformAttribute(0, attribute))

    def _write(self, attribute, text):
        change(self._survey, "SetPlatformAttribute", 0, attribute, to_vtk(text))

    def getRelativePosition(self):
        """Returns the position of the scanner in the body frame [m]."""
        return Vector(*(float(self._read(f"scannerMount/{axis}") or 0) for axis in "xyz"))

    device_relative_position = property(getRelativePosition)
