# SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
# SPDX-License-Identifier: BSD-3-Clause
"""Surveys of scripts: without legs, which the script adds, and copies of surveys."""

import pathlib
import re
import tempfile

from ...core.paths import to_vtk
from ...core.pipeline import PipelineError
from ...core.reading import is_document, read_xml
from ...surveys.items import change
from ...surveys.survey import read_survey

# A survey has at least one leg, on a moving platform two: these are removed when it is read.
LEG = b'<leg><platformSettings x="0" y="0" z="0"/><scannerSettings active="false"/></leg>'
LEGS = 2
_SHORT = re.compile(rb"(<survey\b[^>]*?)/\s*>", re.S)


def read(path, assets):
    """Returns the Survey of a file, which may have no legs."""
    text = _read_without_legs(path)
    if text is None:
        return read_survey(path, assets)
    with tempfile.TemporaryDirectory(prefix="vtkhelios-") as folder:
        whole = pathlib.Path(folder, pathlib.Path(path).with_suffix(".xml").name)
        whole.write_bytes(text)
        try:
            survey = read_survey(whole, [*assets, pathlib.Path(path).resolve().parent])
        except PipelineError as error:
            looked_up = rf"{re.escape(folder)}/[^,:]*, "  # in vain, in the temporary folder
            text = re.sub(looked_up, "", str(error).replace(str(whole), str(path)))
            raise PipelineError([text]) from None
    for index in reversed(range(LEGS)):
        survey.vtk.RemoveLeg(index)
    survey.path = path
    return survey


def _read_without_legs(path):
    """Returns the document of a survey without legs, with some; None: it has legs, or is no survey."""
    if not is_document(path) or not pathlib.Path(path).is_file():
        return None
    try:
        text = _SHORT.sub(rb"\1></survey>", read_xml(path))
    except ValueError:
        return None  # read_survey() has the errors
    bare = re.sub(rb"<!--.*?-->", b"", text, flags=re.S)
    if b"</survey>" not in bare or re.search(rb"<leg\b", bare):
        return None
    start = text.rindex(b"</survey>")
    return text[:start] + LEGS * LEG + text[start:]


def copy(survey, assets):
    """Returns another Survey with the same values, also those that were changed."""
    with tempfile.TemporaryDirectory(prefix="vtkhelios-") as folder:
        path = pathlib.Path(folder, "survey.xml")
        change(survey.vtk, "WriteFile", to_vtk(path))
        made = read_survey(path, [*assets, pathlib.Path(survey.path).resolve().parent])
    made.path, made.warn = survey.path, survey.warn
    return made
