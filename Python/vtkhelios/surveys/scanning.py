# SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
# SPDX-License-Identifier: BSD-3-Clause
"""Surveys of a scene in memory: a scanner of the catalogue, placed in it.

>>> cloud = vtkhelios.scan(scene, position=(0, 0), head=(0, 360), head_speed=60,
                        scan_frequency=100)
"""

import os
import typing

from ..catalogue import find_file
from ..core.classes import vtk_class
from ..core.folders import data_directory
from ..core.paths import to_vtk
from ..core.pipeline import MessageLog, PipelineError, conclude
from .items import SETTINGS, attributes, leg_values, text_of
from ..clouds.cloud import Cloud
from .inputs import trajectory_data
from .survey import Survey, check_options

if typing.TYPE_CHECKING:  # dictionaries of keywords, made by Python/make_stubs.py
    from .keywords import LegSettings, ScanOptions

__all__ = ["make_survey", "scan"]


def make_survey(
    scene,
    legs=None,
    scanner="vz400_class_tls",
    platform=None,
    name="survey",
    assets=(),
    trajectory=None,
    **settings: "typing.Unpack[LegSettings]",
) -> Survey:
    """Returns a survey (a Survey) of a scene in memory.

    scene
        a Scene, a VTK data set with a surface, or an algorithm that makes one: the
        survey follows its pipeline. Or the name of a mesh, or a list of parts, a file name each, or a dictionary with the
        file and what Parts.append() takes: ``["ground.obj", {"file": "car.obj", "scale": 2}]``.
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
        ids in the catalogue, or "file.xml#id" to be found in the folders of assets. Default: a
        tripod; with a trajectory, the mount of "copter_linearpath".
    trajectory
        what the platform follows, instead of the positions of its legs: a Cloud or vtkPolyData with
        the points [m] and the arrays GpsTime [s], in order, and Orientation (unit quaternions w, x,
        y, z, body to world; body x right, y forward, z up), such as
        ``Cloud.from_arrays(points, GpsTime=times, Orientation=quaternions)`` or
        ``survey.trajectory(leg)``; an algorithm that makes one, such as vtkHeliosTrajectoryReader;
        or the name of a file. The platform gives mount and noise. One leg flies all of it, or
        each of ``legs`` the part from its tStart to its tEnd [s]. The survey follows changes of
        the data (``cloud.data.Modified()``) and of the pipeline.

    Nothing is written to disk. Raises PipelineError with the errors.
    """
    if legs is None and trajectory is None:
        raise TypeError("make_survey() needs legs, or a trajectory")
    flies = trajectory is not None
    if isinstance(trajectory, (str, os.PathLike)):
        settings["trajectory"] = os.fspath(trajectory)
        trajectory = None
    trajectory_data(trajectory)  # raises without a valid type
    platform = platform or ("copter_linearpath" if flies else "tripod")
    survey = vtk_class("vtkHeliosSurvey")()
    with MessageLog() as log:
        log.watch(survey)
        legs = [{}] if legs is None else legs
        succeeded = _fill(survey, legs, scanner, platform, name, assets, settings, flies)
    conclude(log)
    if not succeeded:
        raise PipelineError(["the survey is not valid, for a reason that was not reported"])
    if isinstance(scene, (str, os.PathLike)):
        scene = [scene]
    if not isinstance(scene, (list, tuple)):
        return Survey(survey, scene=scene, trajectory=trajectory)
    made = Survey(survey, trajectory=trajectory)
    for part in scene:
        made.parts.append(**(part if hasattr(part, "items") else {"file": part}))
    return made


def scan(
    scene,
    position=None,
    path=None,
    scanner="vz400_class_tls",
    platform=None,
    assets=(),
    trajectory=None,
    **more: "typing.Unpack[ScanOptions]",
) -> Cloud:
    """Places a scanner in a scene and returns its echoes as a Cloud.

    It is at a position (on a tripod), moves along a path of positions (on "copter_linearpath"), or
    follows a trajectory with times and attitudes, see make_survey().
    ``more`` are the settings of a leg, see make_survey(), and the options of Survey.run():
    progress, waveforms, noise, seed ...
    """
    if [position is None, path is None, trajectory is None].count(False) != 1:
        raise TypeError(
            "scan() needs a position (on a tripod), or a path or trajectory to move along"
        )
    known = {"position", *SETTINGS, *attributes("leg")}
    settings = {name: more.pop(name) for name in list(more) if name in known}
    names = ", ".join(sorted({"position", *SETTINGS}))
    check_options(more, f"neither a setting of a leg ({names}) nor of a run")
    platform = platform or ("tripod" if position is not None else "copter_linearpath")
    legs = path if path is not None else None if position is None else [position]
    survey = make_survey(scene, legs, scanner, platform, "scan", assets, trajectory, **settings)
    return survey.run(**more)


def _fill(survey, legs, scanner, platform, name, assets, settings, flies):
    """Adds everything to a vtkHeliosSurvey; returns whether it is valid."""
    survey.SetName(to_vtk(name))
    assets = [assets] if isinstance(assets, (str, os.PathLike)) else assets
    shipped = data_directory()
    for folder in [*assets, shipped, shipped / "Assets"]:
        survey.AddAssetDirectory(to_vtk(folder))
    scanner = survey.AddScannerFromFile(to_vtk(_reference(scanner, find_file)))
    platform = survey.AddPlatformFromFile(to_vtk(_reference(platform)))
    if scanner < 0 or platform < 0:
        return False
    good = not flies or survey.SetPlatformAttribute(platform, "type", "interpolated")
    for leg in legs:
        given = leg if isinstance(leg, dict) else {"position": leg}
        values = leg_values({**settings, **given}, flies)
        index = survey.AddLeg(scanner, platform)
        for attribute, value in values.items():
            good = survey.SetLegAttribute(index, attribute, text_of(value)) and good
    return good and survey.Check()


def _reference(name, find_file=lambda _: "platforms.xml"):
    return name if "#" in name else f"{find_file(name)}#{name}"
