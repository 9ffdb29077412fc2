# SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
# SPDX-License-Identifier: BSD-3-Clause
"""The commands with their options and arguments, as shells complete them, from the parsers."""

import argparse
import re
import typing

from ... import cli
from ...formats._endings import list_endings_of
from .._parser import Parser

FILE, FOLDER, NUMBER, WORDS, FLAG = "file", "folder", "number", "words", "flag"

_FOLDERS = re.compile(r"DIR|FOLDER")
_NUMBERS = re.compile(r"(?:N|M|F|K/N|SIZE|SECONDS|[XYZ]|(?:[XYZ],)+[XYZ])", re.A)


class Value(typing.NamedTuple):
    """A word at one place of a command line."""

    kind: str  # FILE, FOLDER, NUMBER, WORDS or FLAG
    words: tuple  # kind WORDS
    metavar: str
    endings: tuple = ()  # ending of FILE, such as .las; empty: any


class Option(typing.NamedTuple):
    """An option of a command."""

    names: tuple  # spellings, such as -o, --output
    help: str  # one line
    value: Value
    repeats: bool


class Command(typing.NamedTuple):
    """A command."""

    name: str
    help: str  # one line
    options: tuple  # a list of Option
    arguments: tuple  # a list of Value; the last one stands for all others


def describe_commands():
    """Returns all commands, sorted by name (a list of Command)."""
    return [_describe(name, module) for name, module in cli.commands().items()]


def _describe(name, module):
    if not hasattr(module, "add_arguments"):  # the arguments of another program
        return Command(name, module.SUMMARY, (), (Value(FILE, (), "FILE"),))
    parser = Parser(prog=name)
    module.add_arguments(parser)
    shown = [action for action in parser._actions if action.help != argparse.SUPPRESS]
    options = tuple(_option(parser, action) for action in shown if action.option_strings)
    places = tuple(_place(name, action) for action in shown if not action.option_strings)
    return Command(name, module.SUMMARY, options, places)


def _place(command, action):
    value = _value(action)
    return value._replace(endings=list_endings_of(command)) if value.kind == FILE else value


def _option(parser, action):
    text = parser._get_formatter()._expand_help(action) if action.help else ""
    first = re.split(r"[.;:](?:\s|$)|\s\(|\n", " ".join(text.split()), maxsplit=1)[0]
    repeats = isinstance(action, argparse._AppendAction)
    return Option(tuple(action.option_strings), first, _value(action), repeats)


def _value(action):
    metavar = action.metavar or action.dest.upper()
    metavar = metavar if isinstance(metavar, str) else " ".join(metavar)
    if action.nargs == 0:
        return Value(FLAG, (), "")
    if action.choices is not None:
        return Value(WORDS, tuple(map(str, action.choices)), metavar)
    if _FOLDERS.fullmatch(metavar):
        return Value(FOLDER, (), metavar)
    if _NUMBERS.fullmatch(metavar) or getattr(action.type, "__name__", "") in ("float", "int"):
        return Value(NUMBER, (), metavar)
    return Value(FILE, (), metavar)
