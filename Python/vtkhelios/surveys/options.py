# SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
# SPDX-License-Identifier: BSD-3-Clause
"""The rows of vtkHeliosRunOptions: the options of a run, in Python, on the command line and in reports."""

from typing import NamedTuple

from ..core.properties import snake_case
from ..vtkHeliosScannerRun import vtkHeliosRunOptions


class Option(NamedTuple):
    property: str  # property of vtkHeliosRunOptions
    name: str  # keyword of Survey.run()
    key: str  # in the options of run_summary.json
    title: str  # words of a report page
    words: str  # there, with {} for the value; of a flag, if it is on and if it is off
    scale: str  # scale of the value there; empty: it is shown in any case
    argument: str  # option of the command line; empty: none
    metavar: str
    help: str

    def get_choices(self):
        """Returns the words of its value, with those of plug-ins; empty: any."""
        return vtkHeliosRunOptions.GetOptionText(OPTIONS.index(self), "choices").split()


OPTIONS = tuple(
    Option(*(vtkHeliosRunOptions.GetOptionText(row, field) for field in Option._fields))
    for row in range(vtkHeliosRunOptions.GetNumberOfOptions())
)


def in_python():
    """Names in Python, and properties of vtkHeliosRunOptions."""
    return {option.name: snake_case(option.property) for option in OPTIONS}
