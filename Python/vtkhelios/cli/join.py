# SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
# SPDX-License-Identifier: BSD-3-Clause
"""vtkhelios join: makes a run of its parts."""

import argparse
import json
import os
import pathlib

from ..core.json_files import parse_json
from ..core.plugins import PluginError, load_plugin
from ..core.run_files import JOURNAL_NAME, is_epoch
from ..formats import FormatError
from ..formats._summary import convert_to_current
from . import run as run_command
from ._messages import say_error
from ._parser import Parser
from ._reading import add_memory_argument, add_threads_argument

SUMMARY = "join the parts of a run (vtkhelios run --part) into the run of one process"

EPILOG = """\
The files, and run_summary.json except for its timings, are byte-identical to those of vtkhelios run
without --part. Parts may have been run by different computers, in any order, with any number of
threads. join loads the survey and its scene again, which it needs for trajectories and the accuracy,
but computes no pulses. It checks that all parts are there and finished, of the same inputs, options
and versions, and compares the bytes of their files with their checksums; an error names the part.
The parts are not changed; remove their folders afterwards.

PARTS are the folders partKKKofNNN, or a folder that contains them. The survey and the options are
those of the parts. Relative names are searched here, and then in the folder where the parts ran.

examples:
  vtkhelios run survey.xml --part 1/2                 on one computer
  vtkhelios run survey.xml --part 2/2                 on another one
  vtkhelios join output/NAME                          with both folders: writes to output/NAME
  vtkhelios join part*of004 --survey survey.xml --output joined

exit codes: 0 done, 1 failed (the reason is on standard error), 2 wrong usage, 130 interrupted
(--resume continues). See Docs/cluster.md.
"""


def add_arguments(parser):
    parser.epilog = EPILOG
    parser.add_argument(
        "parts", metavar="PARTS", nargs="+", help="the folders of the parts, or one that has them"
    )
    parser.add_argument("--survey", metavar="FILE.xml", help="the survey, if it was moved")
    parser.add_argument(
        "--assets",
        metavar="DIR",
        action="append",
        default=[],
        help="a folder to search first for scenes, scanners and platforms; may be repeated",
    )
    parser.add_argument(
        "--output", "-o", metavar="DIR", help="where the files go (default: where the parts are)"
    )
    run_command.add_earlier_run_arguments(parser)
    add_threads_argument(parser)
    add_memory_argument(parser)
    parser.add_argument("--json", action="store_true", help="print the summary of the run as JSON")
    parser.add_argument("--quiet", action="store_true", help="print errors only")
    run_command.add_verbose_argument(parser)


def run(arguments):
    if arguments.check_all and not arguments.resume:
        say_error("--check-all needs --resume: give both")
        return 2
    try:
        parts = {}
        for folder in find_parts(arguments.parts):
            parts.setdefault(read_part(folder)["options"].get("epoch", 0), []).append(folder)
        first = parts[min(parts)][0]
        options = join_options(arguments, read_part(first), first)
        options.output = arguments.output or find_output(parts, read_part(first))
    except (FormatError, PluginError) as error:
        say_error(str(error))
        return 1
    return run_command.run_survey(options, parts)


def find_parts(folders):
    """Returns the folders of all parts in or below some folders."""
    found = []
    for folder in map(pathlib.Path, folders):
        below = [path for path in folder.glob("*/part*of*") if is_epoch(path.parent)]
        below = sorted(path for path in [*folder.glob("part*of*"), *below] if path.is_dir())
        if not (folder / JOURNAL_NAME).exists() and not below:
            raise FormatError(
                f"{folder}: has no parts of a run; give the folders of vtkhelios run --part, or one "
                "that contains them"
            )
        found += below or [folder]
    return list(dict.fromkeys(found))


def read_part(folder):
    """Reads the run of a part from its journal."""
    path = folder / JOURNAL_NAME
    try:
        with open(path, encoding="utf-8") as file:
            part = parse_json(file.readline())
        if isinstance(part["part"], dict) and isinstance(part["options"], dict):
            return convert_to_current(part)
    except OSError as error:
        raise FormatError(f"{path}: cannot be read: {error.strerror}; run the part") from error
    except (ValueError, KeyError, TypeError):
        pass
    raise FormatError(f"{path}: is not the journal of a part; run it with vtkhelios run --part")


def join_options(arguments, part, folder):
    """Returns the arguments of vtkhelios run that make the whole run."""
    try:
        command = parse_json(str(part["part"]["command"]))
        there, options = pathlib.Path(command["folder"]), dict(command["options"])
        survey, assets = str(options["survey"]), [str(name) for name in options["assets"]]
        plugins = [str(name) for name in options.get("plugin", [])]
    except (ValueError, KeyError, TypeError):
        raise FormatError(
            f"{folder}: was not run by the command line; join it with AddPartFolder() of "
            "vtkHeliosSurveyPlayer"
        ) from None
    for name in plugins:  # the parser knows their detectors
        load_plugin(find_file(name, there))
    joined = default_options(survey, options, folder)
    joined.survey = arguments.survey or find_file(survey, there)
    joined.assets = arguments.assets + [find_file(name, there) for name in assets]
    joined.assets = [name for name in joined.assets if os.path.isdir(name)]
    for name in (
        "overwrite",
        "resume",
        "check_all",
        "threads",
        "memory",
        "json",
        "quiet",
        "verbose",
    ):
        setattr(joined, name, getattr(arguments, name))
    if not os.path.isfile(joined.survey):
        raise FormatError(
            f"{joined.survey}: no such file; give the survey of the parts by --survey"
        )
    return joined


def default_options(survey, options, folder):
    """Returns the arguments of vtkhelios run with options of a part; FormatError if one is not
    valid."""
    parser = Parser(add_help=False)
    run_command.add_arguments(parser)
    joined = parser.parse_args([survey], argparse.Namespace())
    for action in parser._actions:
        if action.dest in options:
            value = options[action.dest]
            if not is_valid(value, action):
                raise FormatError(
                    f"{folder}: is damaged: {action.dest} is {json.dumps(value)[:60]}; run the part again"
                )
            setattr(joined, action.dest, value)
    return joined


def is_valid(value, action):
    """Returns whether a value is one of an option of the command line."""
    if isinstance(action.default, bool):
        return isinstance(value, bool)
    if isinstance(action.default, list):
        return isinstance(value, list) and all(isinstance(each, str) for each in value)
    if value is None or value == action.default:
        return value == action.default
    if action.type is None:
        return isinstance(value, str) and (not action.choices or value in action.choices)
    try:
        return action.type(value if isinstance(value, str) else repr(value)) == value
    except (argparse.ArgumentTypeError, TypeError, ValueError):
        return False


def find_file(name, there):
    """A name that is relative to here, or to the folder of the part's process."""
    return name if os.path.exists(name) else str(there / name)


def find_output(parts, part):
    """Returns the output folder of the parts, if all are in the same."""
    epochs = "epoch" in part["options"]
    outputs = {path.absolute().parents[2 if epochs else 1] for path in sum(parts.values(), [])}
    if len(outputs) > 1:
        raise FormatError(
            f"the parts are in several folders ({', '.join(sorted(map(str, outputs)))}); give --output"
        )
    return os.path.relpath(outputs.pop())
