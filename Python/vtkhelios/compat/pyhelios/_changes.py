# SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
# SPDX-License-Identifier: BSD-3-Clause
"""Changes of a loaded survey."""

from ...core.pipeline import MessageLog, conclude
from ...surveys.items import change
from ._errors import PyHeliosToolsException

NOISES = [f"{what}{axis}Noise" for what in ("position", "attitude") for axis in "XYZ"]
_GIVEN = ("type", "mean", "stdev", "min", "max")
_ZERO = {"type": "NORMAL", "mean": "0", "stdev": "0", "clipEnabled": "false"}


def find_part(survey, name):
    """Returns the index of the part with an id."""
    ids = [survey.GetPartAttribute(index, "id") for index in range(survey.GetNumberOfParts())]
    found = [index for index, each in enumerate(ids) if (each or str(index)) == str(name)]
    if not found:
        known = ", ".join(each or str(index) for index, each in enumerate(ids))
        raise PyHeliosToolsException(f"the scene has no part with the id {name!r}; it has: {known}")
    return found[0]


def rotate_part(survey, part, angles):
    """Rotates a part about x, then y, then z [deg], after its own rotations."""
    for axis, angle in zip("xyz", angles):
        change(survey, "RotatePart", part, axis, angle)


def scale_part(survey, part, factor):
    """Sets the scale of a part."""
    change(survey, "SetPartAttribute", part, "scale/scale", repr(float(factor)))


def move_part(survey, part, offset):
    """Sets the translation of a part [m]."""
    text = ";".join(repr(float(value)) for value in offset)
    change(survey, "SetPartAttribute", part, "translate/offset", text)


def remove_noise(survey):
    """Makes the noise of all platforms zero."""
    for platform in range(survey.GetNumberOfPlatforms()):
        for noise in NOISES:
            given = (survey.GetPlatformAttribute(platform, f"{noise}/{each}") for each in _GIVEN)
            if any(given):
                for name, value in _ZERO.items():
                    change(survey, "SetPlatformAttribute", platform, f"{noise}/{name}", value)


def check_survey(survey):
    """Checks a survey that may have been changed; raises PipelineError with its errors."""
    with MessageLog() as log:
        log.watch(survey)
        survey.Check()
    conclude(log, warn=lambda *_, **__: None)  # warnings were printed when it was read
