# SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
# SPDX-License-Identifier: BSD-3-Clause
"""Output of the command line: results on standard output, errors and warnings on standard error."""

import contextlib
import sys
import warnings

from vtkmodules.vtkCommonCore import vtkLogger, vtkOutputWindow

from ..core.pipeline import (
    PipelineError, SimilarMessages, is_executive_message, observe_messages, remove_observers,
)  # fmt: skip
from ..core.streams import visible
from ._stopping import is_stopping


def say_error(text):
    """Prints an error before there are Messages."""
    print(f"error: {visible(text)}", file=sys.stderr, flush=True)


@contextlib.contextmanager
def shown_problems(messages):
    """Prints the warnings of the library, and the errors of its pipelines, which end the block."""
    with warnings.catch_warnings():
        warnings.simplefilter("always", RuntimeWarning)
        warnings.showwarning = lambda message, *_, **__: messages.warning(str(message))
        try:
            yield
        except PipelineError as error:
            for text in error.messages:
                messages.error(text)


class _Latest:
    """The latest messages of the watched objects."""

    def __init__(self, severity, message):
        self.severity = severity
        self.messages = SimilarMessages(message)
        self.is_printed = False

    def accept(self, message):
        """Returns whether a message needs no line of its own."""
        return message in self.messages or (not self.is_printed and self.messages.add(message))


class Messages:
    """Prints VTK's errors and warnings as one line each.

    Observes the watched objects and VTK's output window, which gets unobserved messages. Messages
    that differ only by a channel or part are one line with their count; it is printed with the
    next output, or by flush().
    """

    def __init__(self, quiet=False, results=True):
        self.quiet = quiet
        self.results = results and not quiet  # whether info() prints
        self._errors = 0
        self.write_error = lambda text: print(text, file=sys.stderr, flush=True)
        self._last = None  # _Latest messages, which may not be printed yet
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
        self.flush()
        vtkLogger.SetStderrVerbosity(vtkLogger.VERBOSITY_INFO)
        vtkOutputWindow.GetInstance().SetDisplayMode(self._display_mode)
        remove_observers(self._observers)

    def watch(self, vtk_object):
        self._observers += observe_messages(
            vtk_object, self._holder_of("error"), self._holder_of("warning")
        )

    def _holder_of(self, severity):
        """Returns a function that prints a message, or holds it back while similar ones may
        follow."""

        def hold(message):
            last = self._last
            repeats = is_executive_message(message) and self.errors
            is_same = last and last.severity == severity and last.accept(message)
            if not repeats and not is_same:
                self.flush()
                self._last = _Latest(severity, message)
                if not self._last.messages.can_grow:
                    self.flush()

        return hold

    @property
    def errors(self):
        """The number of errors, with those that are held back."""
        return self._errors + (self._is_holding() and self._last.severity == "error")

    def _is_holding(self):
        return self._last is not None and not self._last.is_printed

    def flush(self):
        """Prints the messages that are held back."""
        if self._is_holding():
            self._last.is_printed = True
            getattr(self, self._last.severity)(str(self._last.messages))

    def error(self, text):
        self.flush()
        self._errors += 1
        if not is_stopping():  # stopped work may report that; the line of the stop says it
            self.write_error(visible(f"error: {text}"))

    def error_unless_told(self, text):
        """Reports an error, unless its reason was already reported."""
        if not self.errors:
            self.error(text)

    def warning(self, text):
        self.flush()
        if not self.quiet and not is_stopping():
            self.write_error(visible(f"warning: {text}"))

    def note(self, text):
        """Prints a line among the progress, on standard error."""
        self.flush()
        if self.results and not is_stopping():
            self.write_error(visible(text))

    def info(self, text):
        self.flush()
        if self.results:
            print(visible(text), flush=True)
