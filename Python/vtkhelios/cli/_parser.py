# SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
# SPDX-License-Identifier: BSD-3-Clause
"""An argument parser that names the nearest known word for a misspelt one, and types of arguments."""

import argparse
import difflib
import re
import sys

from ..core.reading import is_document

OPTION = re.compile(r"-[^\d.]")  # -1 and -.5 are numbers


def whole_number(highest, lowest=0):
    """Returns an argparse type: an integer from lowest to highest."""

    def parse(text):
        if not text.isascii() or not text.isdigit() or not lowest <= int(text) <= highest:
            raise argparse.ArgumentTypeError(
                f"{text!r} is not a whole number from {lowest} to {highest}"
            )
        return int(text)

    return parse


def number(lowest, highest):
    """Returns an argparse type: a number from lowest to highest."""

    def parse(text):
        try:
            value = float(text)
        except ValueError:
            value = float("nan")
        if not lowest <= value <= highest:
            raise argparse.ArgumentTypeError(
                f"{text!r} is not a number from {lowest:g} to {highest:g}"
            )
        return value

    return parse


def part_of_run(text):
    """Returns an argparse type: part K of N, as (K, N)."""
    found = re.fullmatch(r"([0-9]{1,9})/([0-9]{1,9})", text)
    if not found or not 1 <= int(found[1]) <= int(found[2]):
        raise argparse.ArgumentTypeError(
            f"{text!r} is not a part; expected K/N with K from 1 to N, as 2/4"
        )
    return int(found[1]), int(found[2])


def nearest(word, known):
    """Returns the known word most similar to a given one, or None."""
    close = difflib.get_close_matches(word, known, n=1, cutoff=0.6)
    return close[0] if close else None


class Parser(argparse.ArgumentParser):
    """argparse with suggestions, whole option names only, and texts printed verbatim."""

    def __init__(self, **options):
        options.setdefault("allow_abbrev", False)
        options.setdefault("formatter_class", argparse.RawDescriptionHelpFormatter)
        super().__init__(**options)

    def parse_known_args(self, args=None, namespace=None):
        args = sys.argv[1:] if args is None else list(args)
        for word in args:
            if word == "--" or (self._subparsers and not word.startswith("-")):
                break  # the rest is files or command options
            option = word.split("=")[0]
            if OPTION.match(option) and option not in self._option_string_actions:
                self.error(self.explain_unknown(option))
        return super().parse_known_args(args, namespace)

    def error(self, message):
        """Ends with one line: the error and what helps."""
        words = " ".join(message.split())
        hint = "" if "did you mean" in words or "--help" in words else f"; see {self.prog} --help"
        self.exit(2, f"error: {words}{hint}\n")

    def explain_unknown(self, word):
        """The message for an option that does not exist."""
        best = nearest(word, list(self._option_string_actions))
        hint = f"did you mean {best}?" if best else f"{self.prog} --help lists all options"
        return f"unknown option {word}: {hint}"

    def _check_value(self, action, value):
        if action.choices is None or value in action.choices:
            return
        if is_document(value):
            raise argparse.ArgumentError(None, f"a command is missing: {self.prog} run {value}")
        best = nearest(str(value), list(action.choices))
        known = ", ".join(action.choices)
        hint = f"did you mean {best}?" if best else f"known: {known}"
        raise argparse.ArgumentError(action, f"unknown {value!r}: {hint}")
