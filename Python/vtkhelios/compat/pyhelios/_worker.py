# SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
# SPDX-License-Identifier: BSD-3-Clause
"""The thread that runs a simulation."""

import threading

from ._errors import PyHeliosToolsException
from ._output import make_output
from ._scene import SceneView
from ._survey import SurveyView


class _Stop(BaseException):
    """Ends the thread after stop()."""


class Worker:
    """The survey, and the thread that runs it."""

    def __init__(self):
        self.survey = self._view = self._scene = self.callback = None
        self.outputs, self.templates = {}, None
        self.started = self.paused = self.stopped = self.finished = False
        self._goes = threading.Event()
        self._thread = self._result = self._error = None

    def load(self, survey, outputs, templates, folders):
        """Sets the survey, the outputs of its files, the templates of legs, and where files are."""
        self.survey, self.outputs, self.templates = survey, outputs, templates
        self._view, self._scene = SurveyView(survey.vtk), SceneView(survey, folders)

    def _loaded(self, value):
        if self.survey is None:
            raise PyHeliosToolsException("the survey is not loaded; call loadSurvey() first")
        return value

    @property
    def view(self):
        return self._loaded(self._view)

    @property
    def scene(self):
        return self._loaded(self._scene)

    @property
    def vtk(self):
        return self._loaded(self.survey).vtk

    def start(self, run):
        if self.started:
            raise PyHeliosToolsException("the simulation was started before; build another one")
        self.started = True
        self._goes.set()
        self._thread = threading.Thread(target=self._work, args=(run,), daemon=True)
        self._thread.start()

    def _work(self, run):
        try:
            self._result = run(self)
        except _Stop:
            self._result = make_output([], [], [], True)
        except BaseException as error:
            self._error = error
        self.finished = True

    def check(self, _share=None):
        """Called by the thread: waits while it is paused, and ends it after stop()."""
        self._goes.wait()
        if self.stopped:
            raise _Stop

    def pause(self):
        if self.started and not self.finished:
            self.paused = True
            self._goes.clear()

    def resume(self):
        self.paused = False
        self._goes.set()

    def stop(self):
        self.stopped = True
        self.resume()

    def join(self):
        if self._thread is None:
            raise PyHeliosToolsException("the simulation was not started; call start() first")
        self._thread.join()
        if self._error is not None:
            raise self._error
        return self._result
