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
from ..core.pipeline import MessageLog, PipelineError, conclude
from ..core.reading import look_up
from ..core.write import write_points
from ..scenes.scene import Scene

__all__ = [
    "data_files", "has_plan", "new_plan", "picture_file", "refer", "survey_file", "summary_file",
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


def survey_file(plan, folder, name=SURVEY):
    """Writes the survey; returns its path."""
    document, path = plan.task.document, folder / name

    def short(reference):
        return to_vtk(refer(from_vtk(reference), folder))

    writer = vtk_class("vtkHeliosSurveyWriter")()
    look_up(writer, str(path), plan.task.assets)
    writer.SetInputDataObject(plan.outputs[2])
    writer.SetSurveyName(to_vtk(plan.name))
    writer.SetScene(short(document.GetSceneReference() or _scene_file(plan, folder)))
    writer.SetPlatform(short(document.GetPlatformReference()))
    writer.SetScanner(short(document.GetScannerReference()))
    writer.SetPulseFrequency(document.GetLegPulseFrequency())
    writer.SetScanFrequency(document.GetLegScanFrequency())
    if document.HasRotatingMirror():
        writer.SetVerticalAngleMin(document.GetLegVerticalAngleMin())
        writer.SetVerticalAngleMax(document.GetLegVerticalAngleMax())
    elif document.GetLegScanAngle() > 0:
        writer.SetScanAngle(document.GetLegScanAngle())
    writer.SetHeadRotateStart(document.GetLegHeadRotateStart())
    writer.SetHeadRotateStop(document.GetLegHeadRotateStop())
    writer.SetHeadRotatePerSecond(document.GetLegHeadRotatePerSecond())
    with MessageLog() as log:
        log.watch(writer)
        succeeded = writer.Write()
    conclude(log)
    if not succeeded:
        raise PipelineError([f"{path}: cannot be written"])
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
