# SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
# SPDX-License-Identifier: BSD-3-Clause
"""The rows of vtkHeliosEchoAlgorithm: what a run makes besides the echoes."""

from typing import NamedTuple

from ..core.properties import snake_case
from ..vtkHeliosScannerCore import vtkHeliosEchoAlgorithm


class Output(NamedTuple):
    name: str  # keyword of Survey.run() and run_to(); with hyphens the option of vtkhelios run
    source: str  # property of vtkHeliosSurveySource; empty: of files only
    player: str  # property of vtkHeliosSurveyPlayer
    key: str  # in the options of run_summary.json
    arrays: str
    formats: str  # that can have it
    title: str  # words of a report page
    state: str  # there, if it is on
    help: str  # help of the command line

    @property
    def option(self):
        return f"--{self.name.replace('_', '-')}"


OUTPUTS = tuple(
    Output(*(vtkHeliosEchoAlgorithm.GetOutputText(row, field) for field in Output._fields))
    for row in range(vtkHeliosEchoAlgorithm.GetNumberOfOutputs())
)


def in_memory():
    """Returns the names in Python, and properties of vtkHeliosSurveySource."""
    return {output.name: snake_case(output.source) for output in OUTPUTS if output.source}


def in_files():
    """Returns the names in Python, and properties of vtkHeliosSurveyPlayer."""
    return {output.name: snake_case(output.player) for output in OUTPUTS}
