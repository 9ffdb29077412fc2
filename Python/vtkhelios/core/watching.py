# SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
# SPDX-License-Identifier: BSD-3-Clause
"""Values of ``progress=``: nothing, True for a line on standard error, a function."""

import contextlib
import sys
import time

SECONDS_BETWEEN_LINES = 0.2


class ProgressLine:
    """One line that is overwritten: a bar, the fraction done, the remaining time.

    A file that cannot be written does not end a run: nothing is shown.
    """

    def __init__(self, file=None):
        self._file = sys.stderr if file is None else file
        self._start = time.monotonic()
        self._next = 0.0
        self._width = 0

    def __call__(self, share):
        now = time.monotonic()
        if now >= self._next:
            self._next = now + SECONDS_BETWEEN_LINES
            self._show(share, now - self._start)

    def _show(self, share, elapsed):
        share = min(1.0, max(0.0, share))
        left = f", {elapsed / share - elapsed:.0f} s left" if share > 0.02 else ""
        line = f"[{'#' * round(24 * share):24}] {100 * share:3.0f} %{left}"
        self._write("\r" + line.ljust(self._width))
        self._width = len(line)

    def _write(self, text):
        if self._file is not None:  # None if Python's stream is closed
            with contextlib.suppress(OSError, ValueError):
                self._file.write(text)
                self._file.flush()

    def close(self):
        """Clears the line."""
        if self._width:
            self._write("\r" + " " * self._width + "\r")


class Progress:
    """Entered: the target of VTK's progress, or None; ``begin`` and ``end`` are the range of its part."""

    def __init__(self, progress):
        if not (progress in (None, True, False) or callable(progress)):
            raise TypeError(
                f"progress is {progress!r}; give True, False or a function of the fraction done"
            )
        self._line = ProgressLine() if progress is True else None
        self._report = self._line or progress or None
        self.begin, self.end = 0.0, 1.0

    def __enter__(self):
        return self

    def __exit__(self, *_):
        if self._line:
            self._line.close()

    @property
    def callback(self):
        """A function of the object and its progress, for _native.run()."""
        return self._pass_on if self._report else None

    def _pass_on(self, _object, share):
        self._report(self.begin + (self.end - self.begin) * min(1.0, max(0.0, share)))
