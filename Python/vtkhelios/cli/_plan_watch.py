# SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
# SPDX-License-Identifier: BSD-3-Clause
"""The steps of a plan as a player: what shows progress and what interrupts can watch it."""

import time

from ._progress import Pace, duration
from ._task import Watched


class PlanWatch(Watched):
    """Follows the steps of a PlanTask. If progress is uneven, no remaining time is shown."""

    def __init__(self):
        super().__init__()
        self._name = "loading"
        self._pace = Pace()
        self._share = 0.0

    def begin(self, step):
        """Called before a step; raises Interrupted if requested."""
        self._name, self._share = step.name, 0.0
        self._pace = Pace() if step.is_even else None
        self.report()

    def on_progress(self, _algorithm, share):
        """Called during a step with the fraction done; raises Interrupted if requested."""
        self._share = share
        if self._pace:
            self._pace.add(time.monotonic(), share)
        self.report()

    def GetProgress(self):
        return self._share

    def GetMessage(self):
        left = self._pace.remaining(1.0) if self._pace else None
        return self._name if left is None else f"{self._name}, {duration(left)} left"
