# SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
# SPDX-License-Identifier: BSD-3-Clause
"""The text of a survey with other sampling; everything else stays as it is, with its comments."""

import re
import xml.parsers.expat

TOLERANCES = ("rangeTolerance_m", "energyTolerance")
CIRCLES = "beamSampleQuality"
RAY_CASTER = "rayCaster"
SETTINGS = "FWFSettings"


class _Tags:
    """Where the start tags of <survey> and of its <FWFSettings> begin in the bytes of a file."""

    def __init__(self, data):
        self.survey = self.settings = None
        self._names = []
        self._parser = xml.parsers.expat.ParserCreate()
        self._parser.StartElementHandler = self._start
        self._parser.EndElementHandler = lambda _name: self._names.pop()
        self._parser.Parse(data, True)

    def _start(self, name, _attributes):
        self._names.append(name)
        at = self._parser.CurrentByteIndex
        if name == "survey" and self.survey is None:
            self.survey = at
        elif self._names[-2:] == ["survey", SETTINGS] and self.settings is None:
            self.settings = at


def has_survey(data):
    """Returns whether the bytes of a file have a <survey>, or are not XML."""
    try:
        return _Tags(data).survey is not None
    except xml.parsers.expat.ExpatError:
        return True


def with_ray_caster(data, name):
    """Returns the bytes of a survey with a ray caster; raises ValueError as with_sampling()."""
    return _set(data, _find_tags(data).survey, {RAY_CASTER: name})


def with_sampling(data, tolerance=None, energy_tolerance=None, circles=None):
    """Returns the bytes of a survey with these tolerances, or with this many circles of sub-rays.

    Raises ValueError if it has no <survey>, or is not XML.
    """
    tags = _find_tags(data)
    own = dict.fromkeys(TOLERANCES)
    if circles is None:
        own = dict(zip(TOLERANCES, (tolerance, energy_tolerance)))
    if tags.settings is not None:
        data = _set(data, tags.settings, {**dict.fromkeys(TOLERANCES), CIRCLES: circles})
    elif circles is not None:
        data = _add_child(data, tags.survey, f'<{SETTINGS} {CIRCLES}="{circles}"/>'.encode())
    return _set(data, tags.survey, own)


def _find_tags(data):
    try:
        tags = _Tags(data)
    except xml.parsers.expat.ExpatError as error:
        raise ValueError(f"is not XML: {error}") from error
    if tags.survey is None:
        raise ValueError("has no <survey>")
    return tags


def _set(data, start, values):
    """Sets attributes of the tag at a place, or removes those without a value."""
    end = _end_of_tag(data, start)
    tag = data[start:end]
    for name, value in values.items():
        tag = re.sub(rb"""\s+%s\s*=\s*("[^"]*"|'[^']*')""" % name.encode(), b"", tag)
        if value is not None:
            head = re.match(rb"<[^\s/>]+", tag).end()
            tag = tag[:head] + f' {name}="{value}"'.encode() + tag[head:]
    return data[:start] + tag + data[end:]


def _add_child(data, start, child):
    """Adds a child to the tag at a place, which need not be empty."""
    end = _end_of_tag(data, start)
    if data[end - 2 : end] == b"/>":
        return data[: end - 2] + b">\n    " + child + b"\n  </survey>" + data[end:]
    return data[:end] + b"\n    " + child + data[end:]


def _end_of_tag(data, start):
    """One past the > that closes a start tag; values may contain one."""
    return start + re.match(rb"""<(?:[^>"']|"[^"]*"|'[^']*')*>""", data[start:]).end()
