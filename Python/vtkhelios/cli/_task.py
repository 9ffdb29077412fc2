# SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
# SPDX-License-Identifier: BSD-3-Clause
"""Work on many points as a player: what shows progress can watch it."""

import time

from ..core.words import amount, duration, speed
from ._progress import Pace


class Watched:
    """Methods that progress needs of a player, besides GetProgress() and GetMessage()."""

    def __init__(self):
        self._callback = None

    def report(self):
        """Shows the progress."""
        if self._callback:
            self._callback()

    def AddObserver(self, _event, callback):
        self._callback = callback
        return 1

    def RemoveObserver(self, _tag):
        self._callback = None

    def GetCount(self, _name):
        return 0  # reported by a message


class Task(Watched):
    """Counts points. ``total`` may be None: then no remaining time is shown."""

    def __init__(self, name, total=None):
        super().__init__()
        self.name = name
        self.total = total
        self.done = 0
        self._pace = Pace()

    def advance(self, count):
        """Adds finished points."""
        self.done += count
        self._pace.add(time.monotonic(), self.done)
        self.show_step()

    def show_step(self, name=None):
        """Shows the progress; with a name, the current step."""
        self.name = name or self.name
        self.report()

    def GetProgress(self):
        return self.done / self.total if self.total else 0.0

    def GetMessage(self):
        rate = self._pace.rate()
        pace = f", {speed(rate)} points/s" if rate else ""
        left = f", {duration(self._pace.remaining(self.total))} left" if self.total else ""
        return f"{self.name}, {amount(self.done)} points{pace}{left}"


class StepWatch(Watched):
    """The current step as a player: what shows progress can watch it."""

    def __init__(self):
        super().__init__()
        self._name, self._share = "loading", 0.0

    def on_step(self, name, share):
        self._name, self._share = name, share
        self.report()

    def GetProgress(self):
        return self._share

    def GetMessage(self):
        return self._name


class PlanWatch(Watched):
    """Follows the steps of a PlanTask. If progress is uneven, no remaining time is shown."""

    def __init__(self):
        super().__init__()
        self._name = "loading"
        self._pace = Pace()
        self._share = 0.0

    def begin(self, step):
        """Called before a step."""
        self._name, self._share = step.name, 0.0
        self._pace = Pace() if step.is_even else None
        self.report()

    def on_progress(self, _algorithm, share):
        """Called during a step with the fraction done."""
        self._share = share
        if self._pace:
            self._pace.add(time.monotonic(), share)
        self.report()

    def GetProgress(self):
        return self._share

    def GetMessage(self):
        left = self._pace.remaining(1.0) if self._pace else None
        return self._name if left is None else f"{self._name}, {duration(left)} left"
