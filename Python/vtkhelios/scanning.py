# SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
# SPDX-License-Identifier: BSD-3-Clause
"""Surveys of a scene in memory: a scanner of the catalogue, placed in it.

>>> cloud = vtkhelios.scan(scene, position=(0, 0), head=(0, 360), head_speed=60,
                        scan_frequency=100)
"""

import importlib
import os

from ._paths import to_vtk
from ._pipeline import MessageLog, PipelineError, conclude
from .survey import Survey, check_options

__all__ = ["make_survey", "scan"]

# Settings of a leg, and their attributes in surveys (Docs/dialect.md); a pair of values has two.
_SETTINGS = {
    "speed": "movePerSec_m",
    "stop_and_turn": "stopAndTurn",
    "smooth_turn": "smoothTurn",
    "yaw_at_departure": "yawAtDeparture_deg",
    "active": "active",
    "pulse_frequency": "pulseFreq_hz",
    "scan_frequency": "scanFreq_hz",
    "scan_angle": "scanAngle_deg",
    "vertical": ("verticalAngleMin_deg", "verticalAngleMax_deg"),
    "head": ("headRotateStart_deg", "headRotateStop_deg"),
    "head_speed": "headRotatePerSec_deg",
    "beam_divergence": "beamDivergence_rad",
    "duration": "maxDuration_s",
    "vertical_resolution": "verticalResolution_deg",
    "horizontal_resolution": "horizontalResolution_deg",
}


def make_survey(
    scene,
    legs,
    scanner="vz400_class_tls",
    platform="tripod",
    name="survey",
    assets=(),
    **settings,
):
    """A survey (a Survey) of a scene in memory.

    scene
        a Scene, a VTK data set with a surface, or an algorithm that makes one: the
        survey follows its pipeline.
    legs
        a dictionary each, or only a position. ``position``: x, y on the ground below, or
        x, y, z [m]. On a moving platform a leg extends to the position of the next,
        and the last one is the end point. Its settings:
        speed [m/s], stop_and_turn, smooth_turn, yaw_at_departure [deg]; active,
        pulse_frequency [Hz], scan_frequency [lines/s], scan_angle [deg, half],
        vertical=(lowest, highest) [deg], head=(start, stop) [deg], head_speed [deg/s],
        vertical_resolution, horizontal_resolution [deg], beam_divergence [rad],
        duration [s]; or any attribute of platformSettings and scannerSettings in
        Docs/dialect.md, which is also the name in messages.
    settings
        defaults for all legs.
    scanner, platform
        ids in the catalogue, or "file.xml#id" to be found in the folders of assets.

    Nothing is written to disk. Raises PipelineError with the errors.
    """
    survey = _class("vtkHeliosSurvey")()
    with MessageLog() as log:
        log.watch(survey)
        succeeded = _fill(survey, legs, scanner, platform, name, assets, settings)
    conclude(log)
    if not succeeded:
        raise PipelineError(["the survey is not valid, for a reason that was not reported"])
    return Survey(survey, scene=scene)


def scan(
    scene, position=None, path=None, scanner="vz400_class_tls", platform=None, assets=(), **more
):
    """Places a scanner in a scene and returns its echoes as a Cloud.

    It is at a position (on a tripod), or moves along a path of positions (on "copter_linearpath").
    ``more`` are the settings of a leg, see make_survey(), and the options of Survey.run():
    progress, waveforms, noise, seed ...
    """
    if (position is None) == (path is None):
        raise TypeError("scan() needs a position (on a tripod), or a path to move along")
    known = {"position", *_SETTINGS, *_attributes()}
    settings = {name: more.pop(name) for name in list(more) if name in known}
    names = ", ".join(sorted({"position", *_SETTINGS}))
    check_options(more, f"neither a setting of a leg ({names}) nor of a run")
    platform = platform or ("tripod" if path is None else "copter_linearpath")
    legs = [position] if path is None else path
    survey = make_survey(scene, legs, scanner, platform, "scan", assets, **settings)
    return survey.run(**more)


def _fill(survey, legs, scanner, platform, name, assets, settings):
    """Adds everything to a vtkHeliosSurvey; returns whether it is valid."""
    survey.SetName(to_vtk(name))
    assets = [assets] if isinstance(assets, (str, os.PathLike)) else assets
    shipped = importlib.import_module(__package__).data_directory()
    for folder in [*assets, shipped, shipped / "Assets"]:
        survey.AddAssetDirectory(to_vtk(folder))
    scanner = survey.AddScannerFromFile(to_vtk(_reference("scanners.xml", scanner)))
    platform = survey.AddPlatformFromFile(to_vtk(_reference("platforms.xml", platform)))
    if scanner < 0 or platform < 0:
        return False
    good = True
    for leg in legs:
        values = _values(dict(settings, **(leg if isinstance(leg, dict) else {"position": leg})))
        index = survey.AddLeg(scanner, platform)
        for attribute, value in values.items():
            good = survey.SetLegAttribute(index, attribute, _text(value)) and good
    return good and survey.Check()


def _reference(file, name):
    return name if "#" in name else f"{file}#{name}"


def _values(leg):
    """The attributes of a leg and their values."""
    if "position" not in leg:
        raise TypeError("a leg has no position; give x, y, or x, y, z")
    position = tuple(leg.pop("position"))
    if len(position) not in (2, 3):
        raise ValueError(f"position is {position!r}; give x, y, or x, y, z")
    values = dict(zip("xyz", position), onGround=len(position) == 2)
    for name, value in leg.items():
        target = _SETTINGS.get(name, name)
        if isinstance(target, tuple):
            low, high = value
            values.update(zip(target, (low, high)))
        elif name in _SETTINGS or name in _attributes():
            values[target] = value
        else:
            names = ", ".join(["position", *_SETTINGS])
            raise TypeError(f"{name} is not a setting of a leg; known: {names}")
    return values


def _attributes():
    """The names of all settings of a leg in surveys."""
    cls = _class("vtkHeliosSurvey")
    return {cls.GetAttributeName("leg", i) for i in range(cls.GetNumberOfAttributes("leg"))}


def _text(value):
    if isinstance(value, str):
        return to_vtk(value)
    if isinstance(value, bool):
        return "true" if value else "false"
    return repr(float(value))


def _class(name):
    return getattr(importlib.import_module(__package__), name)
