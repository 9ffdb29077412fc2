# SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
# SPDX-License-Identifier: BSD-3-Clause
"""Ctrl-C stops a run after the block it is at; pressed again, at once."""

import signal

from .. import _native


class Interrupt:
    """While entered, SIGINT and SIGTERM request the player to stop. ``signal`` is the one received.

    Python runs the handler at the next progress report of the player. A second signal ends the
    process at once, even without reports.
    """

    def __init__(self, player, messages):
        self.player = player
        self.messages = messages
        self.signal = 0
        self._previous = {}

    def __enter__(self):
        for number in (signal.SIGINT, signal.SIGTERM):
            self._previous[number] = signal.signal(number, self._stop)
        _native.end_at_second(list(self._previous))
        return self

    def __exit__(self, *_):
        for number, handler in self._previous.items():
            signal.signal(number, handler)

    def _stop(self, number, _frame):
        self.signal = number
        self.player.Abort()
        for again in self._previous:
            signal.signal(again, signal.SIG_DFL)
        self.messages.warning("stopping after this block; press Ctrl-C again to stop immediately")
