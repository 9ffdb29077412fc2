# SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
# SPDX-License-Identifier: BSD-3-Clause
"""How much is printed: nothing, warnings, or also the steps."""

import sys

SILENT, WARNINGS, STEPS = 0, 1, 2

_level = WARNINGS


def _set(level):
    global _level
    _level = level


def loggingSilent():
    """Prints nothing."""
    _set(SILENT)


def loggingQuiet():
    """Prints nothing but errors, which are exceptions."""
    _set(SILENT)


def loggingDefault():
    """Prints warnings, on standard error."""
    _set(WARNINGS)


def loggingTime():
    """Prints warnings and steps with their times."""
    _set(STEPS)


def loggingVerbose():
    """Prints warnings and steps with their times."""
    _set(STEPS)


def loggingVerbose2():
    """Prints warnings and steps with their times."""
    _set(STEPS)


def say_warning(message, *_, **__):
    """Prints a warning, in place of warnings.warn()."""
    if _level >= WARNINGS:
        print(f"warning: {message}", file=sys.stderr, flush=True)


def say_step(message):
    """Prints what was done."""
    if _level >= STEPS:
        print(message, flush=True)
