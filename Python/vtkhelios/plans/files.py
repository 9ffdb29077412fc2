# SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
# SPDX-License-Identifier: BSD-3-Clause
"""The files of a plan: its survey, its points, its summary."""

import contextlib
import json
import os
import pathlib
import shutil
import warnings

from vtkmodules.vtkCommonDataModel import vtkPolyData

from ..array_names import VISIBILITY
from ..core.classes import vtk_class
from ..core.files import write_whole
from ..core.folders import data_directory
from ..core.paths import from_vtk, to_vtk
from ..core.pipeline import PipelineError, perform
from ..core.reading import look_up
from ..core.write import write_points
from ..reports.plan_page import write_page
from ..scenes.scene import Scene
from ..surveys.survey import Survey
from .geo import check_formats, geo_names, write_geo
from .positions import make_features, make_table

__all__ = [
    "build_survey", "data_files", "geo_files", "has_plan", "new_plan", "page_file", "picture_file",
    "plan_survey", "summary_file", "survey_file", "write_all", "write_survey",
]  # fmt: skip

SUMMARY = "plan_summary.json"
SCENE = "scene.obj"  # name of a scene that has no file
POINTS = {"positions.vtp": 2, "candidates.vtp": 0, "test_points.vtp": 1}  # and ports of the planner
SURVEY = "survey.xml"
PICTURE, PAGE = "plan.png", "plan.html"
GEO = "positions"  # files of positions for maps and receivers, without their endings
FILES = (SURVEY, *POINTS, *geo_names(GEO), PICTURE, PAGE, SUMMARY)


def has_plan(folder, files):
    """Returns whether a folder has files of a plan."""
    return any((folder / name).exists() for name in files)


def write_all(kind, plan, folder, in_memory, overwrite=False, picture=False, geo=None):
    """Writes all files of a plan, by the functions of a module, in a folder with its name; returns
    their paths."""
    formats = check_formats("all" if geo is None else geo)
    folder = pathlib.Path(folder) / plan.name
    names = (*([SCENE] if in_memory else []), *kind.FILES)
    if not overwrite and has_plan(folder, names):
        raise FileExistsError(
            f"{folder}: has the files of an earlier plan; give overwrite=True to replace them, or "
            "another folder"
        )
    with new_plan(folder, names):
        files = kind.data_files(plan, folder)
        written, problem = kind.geo_files(plan, folder, formats)
        if problem and geo is not None:
            warnings.warn(problem, RuntimeWarning, stacklevel=3)
        files += written
        if picture:
            files += [kind.picture_file(plan, folder), kind.page_file(plan, folder)]
        report = {**plan.report, "files": [path.name for path in files]}
        return [*files, summary_file(report, folder)]


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
    """Writes the survey, and candidates, test points and positions as VTK XML; returns their paths."""
    files = [survey_file(plan, folder)]
    for name, port in POINTS.items():
        data = vtkPolyData()
        data.ShallowCopy(plan.outputs[port])
        data.GetPointData().RemoveArray(VISIBILITY)  # a bit per pair: as large as all else
        files.append(write_points(data, folder / name))
    return files


# Settings of the legs: properties of the document (GetLeg...) and of the writer.
_LEG_SETTINGS = (
    "PulseFrequency",
    "ScanFrequency",
    "HeadRotateStart",
    "HeadRotateStop",
    "HeadRotatePerSecond",
    "VerticalAngleMin",
    "VerticalAngleMax",
    "ScanAngle",
)


def _leg_settings(document):
    """The settings of the legs of a plan, by the names of properties."""
    values = {name: getattr(document, f"GetLeg{name}")() for name in _LEG_SETTINGS}
    unused = (
        ["ScanAngle"] if document.HasRotatingMirror() else ["VerticalAngleMin", "VerticalAngleMax"]
    )
    if not values["ScanAngle"] > 0:
        unused.append("ScanAngle")
    return {name: value for name, value in values.items() if name not in unused}


def survey_file(plan, folder, name=SURVEY):
    """Writes the survey; returns its path."""
    scene = from_vtk(plan.task.document.GetSceneReference()) or _scene_file(plan, folder)
    return write_survey(folder / name, scene, *_content(plan))


def plan_survey(plan):
    """Returns the Survey that survey_file() writes; a scene in memory stays there."""
    task, in_memory = plan.task, plan.task.has_scene_in_memory()
    scene = from_vtk(task.document.GetSceneReference()) or ("" if in_memory else task.source)
    return build_survey(plan.scene if in_memory else None, scene, *_content(plan))


def _content(plan):
    """Returns the arguments of write_survey() after the scene."""
    document = plan.task.document
    instrument = map(from_vtk, (document.GetPlatformReference(), document.GetScannerReference()))
    return plan.outputs[2], plan.name, instrument, plan.task.assets, _leg_settings(document)


def write_survey(path, *content):
    """Writes a survey, see _make_writer(); returns the path."""
    writer = _make_writer(path, *content)
    perform(writer, writer.Write, f"{path}: cannot be written")
    return path


def build_survey(in_memory, *content):
    """Returns the Survey that write_survey() writes, of the scene in memory if there is one."""
    writer, survey = _make_writer(None, *content), vtk_class("vtkHeliosSurvey")()
    perform(writer, lambda: writer.BuildSurvey(survey), "the survey cannot be made")
    return Survey(survey, scene=in_memory)


def _make_writer(path, scene, legs, name, instrument, assets, settings):
    """Returns the writer of a survey of positions or waypoints (vtkPolyData).

    scene is a reference or a mesh, instrument are the references of platform and scanner; settings
    are properties of the writer.
    """
    writer = vtk_class("vtkHeliosSurveyWriter")()
    look_up(writer, path and str(path), assets)
    writer.SetInputDataObject(legs)
    writer.SetSurveyName(to_vtk(name))
    for kind, reference in zip(("Scene", "Platform", "Scanner"), (scene, *instrument)):
        exists = reference and pathlib.Path(reference.partition("#")[0]).exists()
        getattr(writer, f"Set{kind}")(to_vtk(_refer(reference, path) if exists else reference))
    for setting, value in settings.items():
        getattr(writer, f"Set{setting}")(value)
    return writer


def _scene_file(plan, folder):
    """Returns the mesh of a plan; of a scene in memory, written to the folder."""
    if not plan.task.has_scene_in_memory():
        return plan.task.source
    path = folder / SCENE
    Scene(plan.scene).write(path)
    return str(path)


def _refer(reference, file):
    """Returns a reference as written to a file: shipped files by name. Without a file, a whole path."""
    path, mark, name = reference.partition("#")
    absolute = pathlib.Path(path).resolve()
    if absolute.is_relative_to(data_directory().resolve() / "Assets"):
        return f"{absolute.name}{mark}{name}"
    way = os.path.relpath(absolute, file.parent.resolve()) if file else absolute
    return f"{way}{mark}{name}"


def picture_file(plan, folder):
    """Draws the picture; returns its path. Raises RuntimeError without a display, or in a wheel."""
    try:
        from ..reports.plan_picture import save_picture
    except ImportError as error:
        raise RuntimeError(
            f"the VTK of the wheel does not draw ({error}): open the .vtp files of the plan with PyVista, "
            "or plan with an installation on Debian"
        ) from error

    path = folder / PICTURE
    save_picture(plan.scene, plan.outputs[1], plan.outputs[2], path, title=plan.name)
    return path


def page_file(plan, folder):
    """Writes the page; returns its path. Raises RuntimeError without matplotlib or Jinja2."""
    path = folder / PAGE
    write_whole(path, write_page(plan))
    return path


def geo_files(plan, folder, formats):
    """Writes the positions in some formats; returns their paths, and why some are missing, or None."""
    features, table = make_features(plan), make_table(plan)
    return write_geo(folder, GEO, plan.name, features, table, plan.geography, formats)


def summary_file(report, folder):
    """Writes the report; returns its path."""
    path = folder / SUMMARY
    write_whole(path, json.dumps(report, indent=2) + "\n")
    return path
