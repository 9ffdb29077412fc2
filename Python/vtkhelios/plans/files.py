# SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
# SPDX-License-Identifier: BSD-3-Clause
"""The files of a plan: its survey, its points, its summary."""

import contextlib
import json
import os
import pathlib
import shutil

from vtkmodules.vtkCommonDataModel import vtkPolyData

from ..array_names import VISIBILITY
from ..core.classes import vtk_class
from ..core.files import write_whole
from ..core.folders import data_directory
from ..core.paths import from_vtk, to_vtk
from ..core.pipeline import PipelineError, perform
from ..core.reading import look_up
from ..core.write import write_points
from ..scenes.scene import Scene

__all__ = [
    "LEG_SETTINGS", "data_files", "has_plan", "leg_settings", "new_plan", "picture_file", "survey_file",
    "summary_file", "write_survey",
]  # fmt: skip

SUMMARY = "plan_summary.json"
SCENE = "scene.obj"  # name of a scene that has no file
POINTS = {"positions.vtp": 2, "candidates.vtp": 0, "test_points.vtp": 1}  # and ports of the planner
SURVEY = "survey.xml"
FILES = (SURVEY, *POINTS, "plan.png", SUMMARY)


def has_plan(folder, more=()):
    """Returns whether a folder has files of a plan, or more files."""
    return any((folder / name).exists() for name in [*FILES, *more])


@contextlib.contextmanager
def new_plan(folder, files=FILES):
    """While entered, the files of a plan are written to a folder, which is made, without files of
    an earlier plan. After an error none is left, so that the plan can be written again."""
    _clear(folder, files)
    try:
        yield
    except (OSError, PipelineError):
        with contextlib.suppress(OSError):
            _clear(folder, files)
        raise


def _clear(folder, files):
    folder.mkdir(parents=True, exist_ok=True)
    for name in reversed(files):  # the summary, which marks them complete, first
        (folder / name).unlink(missing_ok=True)
    shutil.rmtree(folder / "check", ignore_errors=True)


def data_files(plan, folder):
    """Writes candidates, test points and positions as VTK XML; returns their paths."""
    files = []
    for name, port in POINTS.items():
        data = vtkPolyData()
        data.ShallowCopy(plan.outputs[port])
        data.GetPointData().RemoveArray(VISIBILITY)  # a bit per pair: as large as all else
        files.append(write_points(data, folder / name))
    return files


# Settings of the legs: properties of the document (GetLeg...) and of the writer, and attributes.
LEG_SETTINGS = {
    "PulseFrequency": "pulseFreq_hz",
    "ScanFrequency": "scanFreq_hz",
    "HeadRotateStart": "headRotateStart_deg",
    "HeadRotateStop": "headRotateStop_deg",
    "HeadRotatePerSecond": "headRotatePerSec_deg",
    "VerticalAngleMin": "verticalAngleMin_deg",
    "VerticalAngleMax": "verticalAngleMax_deg",
    "ScanAngle": "scanAngle_deg",
}


def leg_settings(document):
    """The settings of the legs of a plan, by their names in LEG_SETTINGS."""
    values = {name: getattr(document, f"GetLeg{name}")() for name in LEG_SETTINGS}
    unused = (
        ["ScanAngle"] if document.HasRotatingMirror() else ["VerticalAngleMin", "VerticalAngleMax"]
    )
    if not values["ScanAngle"] > 0:
        unused.append("ScanAngle")
    return {name: value for name, value in values.items() if name not in unused}


def survey_file(plan, folder, name=SURVEY):
    """Writes the survey; returns its path."""
    document = plan.task.document
    scene = from_vtk(document.GetSceneReference()) or _scene_file(plan, folder)
    instrument = map(from_vtk, (document.GetPlatformReference(), document.GetScannerReference()))
    settings = leg_settings(document)
    return write_survey(
        folder / name, plan.outputs[2], plan.name, (scene, *instrument), plan.task.assets, settings
    )


def write_survey(path, legs, name, references, assets, settings):
    """Writes a survey of positions or waypoints (vtkPolyData); returns the path.

    references are those of the scene, the platform and the scanner; settings are by the names in
    LEG_SETTINGS.
    """
    writer = vtk_class("vtkHeliosSurveyWriter")()
    look_up(writer, str(path), assets)
    writer.SetInputDataObject(legs)
    writer.SetSurveyName(to_vtk(name))
    for kind, reference in zip(("Scene", "Platform", "Scanner"), references):
        exists = pathlib.Path(reference.partition("#")[0]).exists()
        getattr(writer, f"Set{kind}")(
            to_vtk(refer(reference, path.parent) if exists else reference)
        )
    for setting, value in settings.items():
        getattr(writer, f"Set{setting}")(value)
    perform(writer, writer.Write, f"{path}: cannot be written")
    return path


def _scene_file(plan, folder):
    """Returns the mesh of a plan; of a scene in memory, written to the folder."""
    if not plan.task.has_scene_in_memory():
        return plan.task.source
    path = folder / SCENE
    Scene(plan.scene).write(path)
    return str(path)


def refer(reference, folder):
    """Returns a reference as written to a file of a folder: shipped files by name."""
    path, mark, name = reference.partition("#")
    absolute = pathlib.Path(path).resolve()
    if absolute.is_relative_to(data_directory().resolve() / "Assets"):
        return f"{absolute.name}{mark}{name}"
    return f"{os.path.relpath(absolute, folder.resolve())}{mark}{name}"


def picture_file(plan, folder):
    """Draws the picture; returns its path. Raises RuntimeError without a display, or in a wheel."""
    try:
        from ..reports.plan_picture import save_picture
    except ImportError as error:
        raise RuntimeError(
            f"the VTK of the wheel does not draw ({error}): open the .vtp files of the plan with PyVista, "
            "or plan with an installation on Debian"
        ) from error

    path = folder / "plan.png"
    save_picture(plan.scene, plan.outputs[1], plan.outputs[2], path, title=plan.name)
    return path


def summary_file(report, folder):
    """Writes the report; returns its path."""
    path = folder / SUMMARY
    write_whole(path, json.dumps(report, indent=2) + "\n")
    return path
