# SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
# SPDX-License-Identifier: BSD-3-Clause
"""The survey of a flight plan."""

from ..core.paths import from_vtk
from ..plans import files
from ..plans.files import SCENE
from ..scenes.scene import Scene


def write_survey(plan, path, scene=None):
    """Writes the survey of a FlightPlan, of its scene or of a mesh file; returns the path."""
    return files.write_survey(path, str(scene or _scene_of(plan)), *_content(plan))


def make_survey(plan):
    """Returns the Survey of a FlightPlan; a scene in memory stays there."""
    if plan.has_scene_in_memory():
        return files.build_survey(plan.scene, "", *_content(plan))
    return files.build_survey(None, str(_scene_of(plan)), *_content(plan))


def _scene_of(plan):
    return from_vtk(plan.document.GetSceneReference()) or plan.source


def _content(plan):
    """Returns what is written of a plan besides its scene."""
    design = plan.design
    settings = {"PulseFrequency": design.pulse_frequency}
    if design.scan_frequency:
        settings["ScanFrequency"] = design.scan_frequency
    if design.scan_angle and _needs_angle(plan):
        settings["ScanAngle"] = design.scan_angle
    instrument = plan.instrument.platform, plan.instrument.scanner
    return plan.flight, plan.name, instrument, plan.assets, settings


def _needs_angle(plan):
    """Returns whether the scan angle is not the one that the scanner has by default."""
    is_other = plan.design.scan_angle != plan.instrument.largest_angle
    return is_other or plan.instrument.optics == "oscillating"


def scene_file(plan, folder):
    """Returns the mesh of a scene in memory, written to the folder; None for a scene with a
    file."""
    if not plan.has_scene_in_memory():
        return None
    path = folder / SCENE
    Scene(plan.scene).write(path)
    return path
