# SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
# SPDX-License-Identifier: BSD-3-Clause
"""Output of the command line: results on standard output, errors and warnings on standard error."""

import sys

from vtkmodules.vtkCommonCore import vtkLogger, vtkOutputWindow

from .._pipeline import is_executive_message, observe_messages, remove_observers
from ._streams import visible


def say_error(text):
    """Prints an error before there are Messages."""
    print(f"error: {visible(text)}", file=sys.stderr, flush=True)


class Messages:
    """Prints VTK's errors and warnings as one line each, immediately.

    Observes the watched objects and VTK's output window, which gets unobserved messages.
    """

    def __init__(self, quiet=False, results=True):
        self.quiet = quiet
        self.results = results and not quiet  # whether info() prints
        self.errors = 0
        self.write_error = lambda text: print(text, file=sys.stderr, flush=True)
        self._last = None
        self._observers = []
        self._display_mode = None

    def __enter__(self):
        vtkLogger.SetStderrVerbosity(vtkLogger.VERBOSITY_OFF)
        window = vtkOutputWindow.GetInstance()
        self.watch(window)
        self._display_mode = window.GetDisplayMode()
        window.SetDisplayModeToNever()
        return self

    def __exit__(self, *_):
        vtkLogger.SetStderrVerbosity(vtkLogger.VERBOSITY_INFO)
        vtkOutputWindow.GetInstance().SetDisplayMode(self._display_mode)
        remove_observers(self._observers)

    def watch(self, vtk_object):
        self._observers += observe_messages(
            vtk_object, self._passer_on(self.error), self._passer_on(self.warning)
        )

    def _passer_on(self, say):
        """A function that prints a message once."""

        def pass_on(message):
            repeats = is_executive_message(message) and self.errors
            if not repeats and (say, message) != self._last:
                self._last = say, message
                say(message)

        return pass_on

    def error(self, text):
        self.errors += 1
        self.write_error(visible(f"error: {text}"))

    def error_unless_told(self, text):
        """Reports an error, unless its reason was already reported."""
        if not self.errors:
            self.error(text)

    def warning(self, text):
        if not self.quiet:
            self.write_error(visible(f"warning: {text}"))

    def info(self, text):
        if self.results:
            print(visible(text), flush=True)
