# SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
# SPDX-License-Identifier: BSD-3-Clause
"""The survey of a flight plan."""

import pathlib
import tempfile

from ..core.paths import from_vtk
from ..plans import files
from ..plans.files import SCENE
from ..scenes.scene import Scene
from ..surveys.survey import read_survey

STAND_IN = "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n"  # for a scene that stays in memory


def write_survey(plan, path, scene=None):
    """Writes the survey of a FlightPlan, of its scene or of a mesh file; returns the path."""
    scene = scene or from_vtk(plan.document.GetSceneReference()) or plan.source
    references = str(scene), plan.instrument.platform, plan.instrument.scanner
    design = plan.design
    settings = {"PulseFrequency": design.pulse_frequency}
    if design.scan_frequency:
        settings["ScanFrequency"] = design.scan_frequency
    if design.scan_angle and _needs_angle(plan):
        settings["ScanAngle"] = design.scan_angle
    return files.write_survey(path, plan.flight, plan.name, references, plan.assets, settings)


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


def make_survey(plan):
    """Returns the Survey of a FlightPlan; a scene in memory stays there."""
    with tempfile.TemporaryDirectory(prefix="vtkhelios-") as name:
        folder, in_memory = pathlib.Path(name), plan.has_scene_in_memory()
        if in_memory:
            (folder / SCENE).write_text(STAND_IN)
        path = write_survey(plan, folder / "survey.xml", folder / SCENE if in_memory else None)
        survey = read_survey(path, plan.assets, scene=plan.scene if in_memory else None)
    survey.path = None
    return survey
