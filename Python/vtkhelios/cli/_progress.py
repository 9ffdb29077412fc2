# SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
# SPDX-License-Identifier: BSD-3-Clause
"""Progress of a run: a bar on a terminal, a line every few seconds elsewhere."""

import collections
import importlib.util
import sys
import threading
import time

from ..core.paths import from_vtk
from ..core.streams import unfiltered, visible
from ..core.words import amount, counted, duration, speed
from ._stopping import is_stopping, set_terminal

SECONDS_BETWEEN_LINES = 2.0
SECONDS_BETWEEN_BARS = 0.1
LATE = 0.1  # s, of a report, before a line is repeated
CLEAR_LINE, SHOW_CURSOR = "\r\033[K", "\033[?25h"


class Pace:
    """Growth rate of a count over the last seconds, and the remaining time."""

    def __init__(self, seconds=10.0):
        self._window = seconds
        self._samples = collections.deque()

    def add(self, now, done):
        self._samples.append((now, done))
        while len(self._samples) > 2 and now - self._samples[1][0] > self._window:
            self._samples.popleft()

    def rate(self):
        """Counts per second, or None without enough data."""
        if len(self._samples) < 2:
            return None
        (t0, n0), (t1, n1) = self._samples[0], self._samples[-1]
        return (n1 - n0) / (t1 - t0) if t1 - t0 > 0.05 and n1 > n0 else None

    def remaining(self, total):
        """Seconds until total is reached, never negative; None if unknown."""
        rate = self.rate()
        return max(0.0, (total - self._samples[-1][1]) / rate) if rate else None


class Progress:
    """Follows a player; subclasses show the text of describe()."""

    seconds_between = SECONDS_BETWEEN_LINES

    def __init__(self, player, messages):
        self._player = player
        self._messages = messages
        self._indices = Pace()  # for the remaining time
        self._fired = Pace()  # shown: some pulse indices emit no pulse
        self._next = time.monotonic() + self.seconds_between
        self._tag = None

    def __enter__(self):
        self._tag = self._player.AddObserver("ProgressEvent", self._on_progress)
        return self

    def __exit__(self, *_):
        self._player.RemoveObserver(self._tag)

    def _on_progress(self, *_):
        now = time.monotonic()
        done = self._player.GetCount("pulses")
        if done > 0:
            self._messages.flush()  # ends the lines of loading
            self._indices.add(now, done)
            self._fired.add(now, self._player.GetCount("pulsesFired"))
        if now >= self._next:
            self._next = now + self.seconds_between
            self.show()

    def describe(self):
        """Returns the state of the run in one line."""
        player = self._player
        if player.GetCount("pulses") <= 0:
            return from_vtk(player.GetMessage()) or "loading"
        rate = self._fired.rate()
        pace = f"{speed(rate)} pulses/s, " if rate else ""
        fired, points = player.GetCount("pulsesFired"), player.GetCount("points")
        left = self._indices.remaining(player.GetNumberOfPulses()) if rate else None
        remaining = "" if left is None else f", {duration(left)} left"
        return (
            f"leg {player.GetCurrentLeg() + 1} of {player.GetNumberOfLegs()}, "
            f"{amount(fired)} pulses, {pace}{counted(points, 'point')}{remaining}"
        )

    def show(self):
        pass


class Lines(Progress):
    """A line every few seconds, also while nothing is reported.

    A thread repeats the latest line then; it does not use the player, which is at work.
    """

    def __init__(self, player, messages):
        super().__init__(player, messages)
        self._latest = f"  0 % {from_vtk(player.GetMessage()) or 'loading'}"
        self._lock = threading.Lock()
        self._ended = threading.Event()
        self._thread = threading.Thread(target=self._repeat, daemon=True)

    def __enter__(self):
        self._thread.start()
        return super().__enter__()

    def __exit__(self, *_):
        self._ended.set()
        super().__exit__()

    def _on_progress(self, *_):
        super()._on_progress()
        percent = 100.0 * min(1.0, max(0.0, self._player.GetProgress()))
        self._latest = f"{percent:3.0f} % {self.describe()}"

    def show(self):
        percent = 100.0 * min(1.0, max(0.0, self._player.GetProgress()))
        self._write(f"{percent:3.0f} % {self.describe()}")

    def _write(self, line):
        with self._lock:
            if not is_stopping():
                print(line, file=sys.stderr, flush=True)

    def _repeat(self):
        while not self._ended.wait(max(0.05, self._next - time.monotonic())):
            now = time.monotonic()
            if now >= self._next + LATE:  # else the next report is shown
                self._next = now + self.seconds_between
                self._write(self._latest)


class PlainBar(Progress):
    """A single line that is overwritten, for a terminal without rich."""

    seconds_between = SECONDS_BETWEEN_BARS

    def show(self):
        percent = 100.0 * min(1.0, max(0.0, self._player.GetProgress()))
        set_terminal(CLEAR_LINE)
        _overwrite(f"{percent:3.0f} % {visible(self.describe())}")

    def __exit__(self, *_):
        super().__exit__()
        _overwrite("")
        set_terminal("")


def _overwrite(text):
    print(f"{CLEAR_LINE}{text}", end="", file=unfiltered(sys.stderr), flush=True)


class RichBar(Progress):
    """A bar drawn by rich; messages printed meanwhile scroll above it.

    The bar, and rich, which is slow to import, are loaded when it is first shown.
    """

    seconds_between = SECONDS_BETWEEN_BARS
    _bar = None

    def _start(self):
        from rich import progress
        from rich.console import Console

        self._bar = progress.Progress(
            progress.BarColumn(bar_width=24),
            progress.TaskProgressColumn(),
            progress.TextColumn("{task.description}", markup=False),
            console=Console(file=unfiltered(sys.stderr), highlight=False),
            auto_refresh=False,
            transient=True,
        )
        self._task = self._bar.add_task("loading", total=1.0)
        self._write_error = self._messages.write_error
        self._messages.write_error = lambda text: self._bar.console.print(
            text, markup=False, soft_wrap=True
        )
        set_terminal(CLEAR_LINE + SHOW_CURSOR)
        self._bar.start()

    def __exit__(self, *_):
        super().__exit__()
        if self._bar:
            self._bar.stop()
            set_terminal("")
            self._messages.write_error = self._write_error

    def show(self):
        if not self._bar:
            self._start()
        done = min(1.0, max(0.0, self._player.GetProgress()))
        self._bar.update(self._task, completed=done, description=visible(self.describe()))
        self._bar.refresh()


def make_progress(player, messages, quiet=False):
    """Returns the progress display for standard error."""
    if quiet:
        return Progress(player, messages)
    if not sys.stderr.isatty():
        return Lines(player, messages)
    has_rich = importlib.util.find_spec("rich")
    return (RichBar if has_rich else PlainBar)(player, messages)
