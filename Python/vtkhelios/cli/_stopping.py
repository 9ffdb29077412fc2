# SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
# SPDX-License-Identifier: BSD-3-Clause
"""Ctrl-C and SIGTERM: every command ends within a second, with one line and no half file.

The first signal raises Interrupted, wherever Python is; a native run under way is requested to stop
instead (StopRequest), and native code with progress passes the exception on (_native.run). What does
neither, such as a library that writes a picture, is ended by _native after LONGEST: files have their
final names only when they are complete, and a run continues after what its journal has. A second
signal ends the process immediately.
"""

import contextlib
import os
import signal
import sys
import threading

from .. import _native
from ..core.pipeline import SECONDS_BETWEEN_SIGNS, upstream
from ..core.streams import unfiltered, visible

SIGNALS = (signal.SIGINT, signal.SIGTERM)
LONGEST = 0.4  # s, from the signal to the end
RUN, ESTIMATE = 0, 1  # phases of a player


class Interrupted(KeyboardInterrupt):
    """A signal has come; ``signal`` is its number."""

    def __init__(self, number):
        super().__init__(number)
        self.signal = number


class Stopping:
    """While entered, signals end the command; of the main thread only.

    After the command of a process, which is complete, they are ignored until it ends.
    """

    def __init__(self, is_process=False):
        self._is_process = is_process
        self._previous = {}
        self._hooks = None

    def __enter__(self):
        if threading.current_thread() is threading.main_thread():
            _state.reset()
            self._hooks = sys.excepthook, sys.unraisablehook
            for number in SIGNALS:
                self._previous[number] = signal.signal(number, _handle)
            _native.end_after(SIGNALS, LONGEST)
        return self

    def __exit__(self, *_):
        if self._previous:
            _native.end_after((), 0.0)
            sys.excepthook, sys.unraisablehook = self._hooks
            for number, handler in self._previous.items():
                signal.signal(
                    number, signal.SIG_IGN if self._is_process else handler or signal.SIG_DFL
                )
            _state.reset()


class StopRequest:
    """While entered, signals request a native player to stop; ``signal`` is the one received, or 0."""

    def __init__(self, player):
        self._player = player

    @property
    def signal(self):
        return _state.signal

    def __enter__(self):
        _state.players.append(self._player)
        return self

    def __exit__(self, *_):
        _state.players.pop()


def run_native(algorithm):
    """Updates an algorithm; its messages are reported by who watches it."""
    _native.run(algorithm, 0, upstream(algorithm), None, SECONDS_BETWEEN_SIGNS)


def run_player(player, what=RUN):
    """Runs a vtkHeliosSurveyPlayer, or estimates its run; whether that succeeded."""
    succeeded, _ = _native.run(player, what, [player], None, SECONDS_BETWEEN_SIGNS)
    return succeeded


class _State:
    """State that a signal finds."""

    def __init__(self):
        self.reset()

    def reset(self):
        self.signal = 0
        self.players = []
        self.outcome = "; nothing was written"
        self.terminal = ""
        self.update()

    def line(self):
        return f"error: interrupted{self.outcome}"

    def update(self):
        """Sets what is written if the process is ended."""
        text = f"{self.terminal}{visible(self.line())}\n"
        _native.set_end_line(text.encode(errors="backslashreplace"))


_state = _State()


def _ignore(*_):
    """Prints no exception: code that cannot pass one on would print a stop's."""


def _handle(number, _frame):
    _state.signal = _state.signal or number
    sys.excepthook = sys.unraisablehook = _ignore
    if not _state.players:
        raise Interrupted(_state.signal)
    _state.players[-1].Abort()


def is_stopping():
    """Returns whether a signal has come."""
    return _state.signal != 0


def set_outcome(text):
    """Sets what the line of a stop says from now on, after "interrupted; " or, with a space, directly."""
    _state.outcome = text if text[:1] in ("", " ") else f"; {text}"
    _state.update()


def set_terminal(sequence):
    """Sets the control sequence that a terminal with a bar needs before the line."""
    _state.terminal = sequence
    _state.update()


def claim_line():
    """Returns whether no line of the stop is written yet; from now on the caller writes it."""
    return _native.claim_end_line()


def report_stop(interruption, line=None):
    """Writes the line of a stop, once; returns the exit code."""
    number = getattr(interruption, "signal", 0) or _state.signal or signal.SIGINT
    if claim_line():
        print(visible(line or _state.line()), file=sys.stderr, flush=True)
    return 128 + number


def leave(code):
    """Ends the process of a command that was stopped: its memory is not released piece by piece."""
    for stream in (sys.stdout, sys.stderr):
        with contextlib.suppress(OSError, ValueError, AttributeError):
            unfiltered(stream).flush()
    os._exit(code)
