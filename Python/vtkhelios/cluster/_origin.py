# SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
# SPDX-License-Identifier: BSD-3-Clause
"""Where a survey was read from: what another process reads it from, too."""

import os
import uuid

from ..core.paths import from_vtk
from ..core.pipeline import perform


class Origin:
    """The file of a survey, the folders and the function that it is read with; made before that."""

    def __init__(self, path, assets, read):
        self.path = os.path.abspath(path)
        self.assets = [os.path.abspath(folder) for folder in assets]
        self.folder = os.getcwd()
        self.read = read
        self.key = uuid.uuid4().hex  # read again, it is another survey
        self._state = _file_state(self.path)
        self._time = None
        self._fingerprint = None

    def set_survey(self, vtk_survey):
        """The survey that was read; later changes of it are in no file."""
        self._time = vtk_survey.GetMTime()

    def check(self, vtk_survey):
        """Raises ValueError if the survey, or its file, has changed since it was read."""
        if vtk_survey.GetMTime() != self._time:
            raise ValueError(
                f"{self.path}: the survey was changed after it was read, and workers read its file; "
                "change the file, and read it again"
            )
        if _file_state(self.path) != self._state:
            raise ValueError(f"{self.path} has changed since it was read; read it again")

    def get_fingerprint(self, survey):
        """Returns the digests of the files of the survey, computed once."""
        if self._fingerprint is None:
            source = survey.source()
            self._fingerprint = from_vtk(perform(source, source.GetFingerprint))
        return self._fingerprint


def _file_state(path):
    try:
        state = os.stat(path)
    except OSError:
        return None
    return state.st_mtime_ns, state.st_size
