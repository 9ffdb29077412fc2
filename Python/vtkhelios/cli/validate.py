# SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
# SPDX-License-Identifier: BSD-3-Clause
"""vtkhelios validate: lists the errors in surveys, scenes, scanners and platforms."""

import dataclasses
import json
import re

from ..core.pipeline import SimilarMessages, observe_messages, remove_observers
from ..core.reading import make_reader, missing_folder
from ..core.streams import visible
from ..core.words import counted
from ..vtkHeliosScannerRun import vtkHeliosSurveySource
from ..vtkHeliosScannerSurvey import vtkHeliosDialect
from ._meshes import list_notes
from ._messages import Messages, say_error
from ._optics import describe_optics
from ._reading import add_assets_argument

SUMMARY = "list all errors in surveys, scenes, scanners or platforms (XML, YAML)"

EPILOG = """\
what it checks: every element and attribute, its type, unit and range; misspelt names; that all
references exist: scanners, platforms, scenes, files of geometry and materials; that the scanner
supports the settings of a leg. Files of geometry are not read, unless --deep loads the scene of a
survey, as a run does, with its textures. Everything in a file is checked, whether a
survey uses it or not, and so is everything that a survey refers to.

An error stops a run; a warning is about a difference between a run and what the file may mean, such
as an attribute that is unknown, or not modelled. With --deep notes tell what materials do that reflect
or transmit light, and what images cut out of triangles.

what it prints: file:line: error: the problem, the value, and the remedy; one line each. With
several elements of a name in a line, file:line:column for those after the first.

examples:
  vtkhelios validate survey.xml --assets my_scenes
  vtkhelios validate survey.xml --deep        also read its meshes, rasters, clouds and textures
  vtkhelios validate *.xml --strict           warnings count as errors
  vtkhelios validate survey.xml --json        a list of {file, line, severity, message}

exit codes: 0 no error, 1 errors (with --strict, or warnings), 2 wrong usage.
"""

PLACE = re.compile(r"(?P<file>.+?):(?P<line>\d+)(?::(?P<column>\d+))?: (?P<message>.*)", re.S)


@dataclasses.dataclass
class Finding:
    """An error, warning or note; line is None if it concerns the whole file, column unless
    others of its name precede the element in its line."""

    file: str
    line: int | None
    column: int | None
    severity: str
    message: str

    def as_json(self):
        fields = dataclasses.asdict(self)
        return {key: fields[key] for key in fields if key != "column" or self.column is not None}

    def __str__(self):
        numbers = (number for number in (self.line, self.column) if number is not None)
        return f"{':'.join([self.file, *map(str, numbers)])}: {self.severity}: {self.message}"


def add_arguments(parser):
    parser.epilog = EPILOG
    parser.add_argument("files", metavar="FILE", nargs="+", help="a document, .xml or .yaml")
    add_assets_argument(parser)
    parser.add_argument(
        "--deep", action="store_true", help="also load the scene of a survey, with all its files"
    )
    parser.add_argument("--strict", action="store_true", help="warnings count as errors")
    parser.add_argument("--json", action="store_true", help="print a list of JSON objects")


class Collector(Messages):
    """Keeps a reader's messages instead of printing them."""

    def __init__(self, path):
        super().__init__()
        self.path = path
        self.findings = []

    def _holder_of(self, severity):
        return getattr(self, severity)

    def error(self, text):
        self._errors += 1
        self.add("error", text)

    def warning(self, text):
        self.add("warning", text)

    def accept(self, other):
        """Adds the findings of another one."""
        self._errors += other.errors
        self.findings += [found for found in other.findings if found not in self.findings]

    def add(self, severity, text):
        text = visible(text)
        place = PLACE.fullmatch(text)
        text = text if place else text.removeprefix(f"{self.path}: ")
        file = place["file"] if place else self.path
        line, column = (
            int(place[name]) if place and place[name] else None for name in ("line", "column")
        )
        finding = Finding(file, line, column, severity, place["message"] if place else text)
        if finding not in self.findings:
            self.findings.append(finding)


def check(path, assets, deep=False):
    """Returns the errors of a file and the files it refers to, in the order of files and lines.

    deep: also of the files of geometry, if there is no other error.
    """
    shown = visible(path)
    with Collector(shown) as messages:
        reader = make_reader(path, assets)
        messages.watch(reader)
        if not reader.Check():
            messages.error_unless_told("cannot be read")
        elif deep and not messages.errors:
            load_scene(reader, messages)
    files = list(dict.fromkeys([shown, *(found.file for found in messages.findings)]))
    findings = merge_similar(messages.findings)
    return sorted(
        findings, key=lambda found: (files.index(found.file), found.line or 0, found.column or 0)
    )


def load_scene(reader, messages):
    """Loads the scene of a survey; other documents have none to load."""
    if not vtkHeliosDialect.MayHaveSurvey(reader.GetFileName()) or not reader.Read():
        return
    source = vtkHeliosSurveySource()
    source.SetSurvey(reader.GetSurvey())
    colored = load_into(source, messages.path, colors=True)
    plain = load_into(source, messages.path, colors=False) if colored.errors else colored
    messages.accept(plain)
    for found in colored.findings:
        if found.severity == "error" and found not in plain.findings:
            found.severity = "warning"
            found.message += "; only a run with --colors reads it"
            messages.findings.append(found)
    if not plain.errors:
        for text in describe_optics(source.GetScene()):
            messages.add("note", f"material {text}")
        for text in list_notes(source.GetScene()):
            messages.add("note", text)


def load_into(source, path, colors):
    """Loads the scene of a source, with its colours or without; returns the messages."""
    messages = Collector(path)
    observers = observe_messages(source, messages.error, messages.warning)
    source.SetGenerateColors(colors)
    if not source.Load():
        messages.error_unless_told("its scene cannot be loaded")
    remove_observers(observers)
    return messages


def merge_similar(findings):
    """Returns the findings; findings of a line that differ only by a channel or part become one
    with their count."""
    places = {}
    for found in findings:
        place = (found.file, found.line, found.severity)
        places.setdefault(place, []).append(found)
    return [
        dataclasses.replace(first_of(several, text), message=text)
        for several in places.values()
        for text in SimilarMessages.merge([found.message for found in several])
    ]


def first_of(findings, text):
    """Returns the one that a merged message begins with."""
    return next(found for found in findings if text.startswith(found.message))


def run(arguments):
    if problem := missing_folder(arguments.assets):
        say_error(problem)
        return 2
    findings = []
    for path in arguments.files:
        findings += [
            found
            for found in check(path, arguments.assets, arguments.deep)
            if found not in findings
        ]
    errors = sum(found.severity == "error" for found in findings)
    warnings = sum(found.severity == "warning" for found in findings)
    if arguments.json:
        print(json.dumps([found.as_json() for found in findings], indent=1))
    else:
        for found in findings:
            print(found)
        skipped = "" if arguments.deep or errors else "; geometry was not read (--deep reads it)"
        files = counted(len(arguments.files), "file")
        print(f"{files}: {counted(errors, 'error')}, {counted(warnings, 'warning')}{skipped}")
    return 1 if errors or (arguments.strict and warnings) else 0
