# SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
# SPDX-License-Identifier: BSD-3-Clause
"""Inputs of a tradeoff: a survey, or the one that plan makes for a scene or a mesh."""

import pathlib

import vtkhelios

from ...core.paths import from_vtk, text_from_vtk, to_vtk
from ...plans.files import survey_file
from ...plans.plan import Plan, PlanTask
from ...surveys.survey import Survey, read_survey
from ..run import read_survey as read_given

PLAN_SETTINGS = ("platform", "scanner", "resolution", "grid")


class SurveyInput:
    """A survey in a file."""

    def __init__(self, arguments, messages):
        self._path, self._assets, self.survey = arguments.survey, arguments.assets, None
        read = read_given(arguments, messages)
        if read is not None:
            self.survey = Survey(read, arguments.survey)
            self.name = text_from_vtk(read.GetName())

    def describe(self):
        return f"survey   {self.survey.name} ({self._path})"

    def prepare(self, watch):
        """Nothing: it has been read."""

    def make_survey(self, _target):
        """Returns the survey of the file, to be changed and written."""
        return read_survey(self._path, self._assets)


class PlannedInput:
    """A scene or a mesh, scanned from the positions that plan finds."""

    def __init__(self, arguments):
        settings = {name: getattr(arguments, name) for name in PLAN_SETTINGS}
        self._task = PlanTask(arguments.survey, arguments.assets, **settings)
        self._path, self._plan, self.survey = arguments.survey, None, None
        self.name = self._task.name

    def describe(self):
        scanner, platform = (
            from_vtk(reference).rpartition("#")[2]
            for reference in (
                self._task.document.GetScannerReference(),
                self._task.document.GetPlatformReference(),
            )
        )
        count = len(self.survey.legs)
        positions = f"{count} scan position{'s'[: count != 1]}"
        return (
            f"scene    {self.name} ({self._path}), {scanner} on {platform} at {positions} as planned "
            "by vtkhelios plan"
        )

    def prepare(self, watch):
        """Plans the survey."""
        seconds = {}
        for step in self._task.steps():
            step.run(seconds, lambda _filter, share, step=step: watch.on_step(step.name, share))
        self._plan = Plan(self._task, seconds)
        self.survey = self._plan.survey()

    def make_survey(self, target):
        """Writes the planned survey, and returns it, to be changed and written there again."""
        return read_survey(survey_file(self._plan, target.parent, target.name), self._task.assets)


def open_input(arguments, messages):
    """Returns the kind of the file, or None after an error; raises SettingError and
    PipelineError."""
    path = pathlib.Path(arguments.survey.partition("#")[0])
    is_scene = path.is_file() and not _is_survey(path)
    given = [name for name in PLAN_SETTINGS if getattr(arguments, name) is not None]
    if is_scene:
        return PlannedInput(arguments)
    if given:
        messages.error(
            f"--{given[0]} is for a scene or a mesh, and {arguments.survey} is a survey, which has "
            "its own: leave it out, or change the survey"
        )
        return None
    found = SurveyInput(arguments, messages)
    return found if found.survey is not None else None


def _is_survey(path):
    """Returns whether a file has, or may have, a <survey>: the reader reports what is wrong with
    it."""
    is_mesh = bool(vtkhelios.vtkHeliosDialect.FindLoader(to_vtk(path)))
    return not is_mesh and vtkhelios.vtkHeliosDialect.MayHaveSurvey(to_vtk(path))
