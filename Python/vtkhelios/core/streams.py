# SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
# SPDX-License-Identifier: BSD-3-Clause
"""Standard output and standard error of the command line.

What is printed may come from files: control characters are made visible, so that no file
commands the terminal, and what the terminal cannot show is escaped. A stream that cannot be
written to ends no work: the rest of its text is dropped, and main() reports it at the end.
"""

import contextlib
import errno
import io
import os
import re
import sys

# All except tab and line feed; also C1 and bidirectional control characters.
_CONTROL = re.compile("[\x00-\x08\x0b-\x1f\x7f-\x9f\u2028-\u202e\u2066-\u2069]")
_BYTE = re.compile("[\udc80-\udcff]")  # character of a file name that is not UTF-8


def visible(text, encoding="utf-8"):
    """Returns a printable text: \\x1b for an escape, \\xff for a byte that is not text."""
    text = _BYTE.sub(lambda match: f"\\x{ord(match[0]) - 0xDC00:02x}", text)
    text = _CONTROL.sub(lambda match: match[0].encode("unicode_escape").decode(), text)
    return text.encode(encoding, "backslashreplace").decode(encoding)


class Stream:
    """A text stream whose text is visible() and whose errors are kept in ``error``.

    ``unfiltered`` is the same stream for intentional control sequences.
    """

    def __init__(self, raw, show=visible):
        self._raw, self._is_unbuffered = raw, False
        if isinstance(getattr(raw, "buffer", None), io.RawIOBase):  # python -u
            self._raw, self._is_unbuffered = _buffered(raw), True
        self._show = show
        self.error = None
        self.unfiltered = self if show is _as_it_is else Stream(raw, _as_it_is)

    def write(self, text):
        self._attempt(lambda: self._raw.write(self._show(text, self.encoding)))
        if self._is_unbuffered:
            self.flush()
        return len(text)

    def flush(self):
        self._attempt(self._raw.flush)

    def _attempt(self, action):
        if self.failure() is not None:
            return
        try:
            action()
        except (OSError, ValueError) as error:  # ValueError: it was closed
            self.error = error if isinstance(error, OSError) else OSError(errno.EBADF, str(error))
            _discard_the_rest(self._raw)

    def failure(self):
        """Returns the first error of this stream, or None."""
        return self.error or (None if self.unfiltered is self else self.unfiltered.error)

    @property
    def encoding(self):
        return getattr(self._raw, "encoding", None) or "utf-8"

    def isatty(self):
        return self._raw.isatty()

    def __getattr__(self, name):
        return getattr(self._raw, name)


def _buffered(raw):
    """Returns a text stream to the same file. One without a buffer drops what the system did not
    write."""
    return open(raw.fileno(), "w", encoding=raw.encoding, errors=raw.errors, closefd=False)


def _as_it_is(text, encoding):
    return text.encode(encoding, "backslashreplace").decode(encoding)


def _discard_the_rest(raw):
    """The rest of a stream's buffer would fail again when Python exits."""
    with contextlib.suppress(OSError, ValueError, AttributeError):
        null = os.open(os.devnull, os.O_WRONLY)
        os.dup2(null, raw.fileno())
        os.close(null)


def unfiltered(stream):
    """Returns the stream for control sequences, such as a progress bar's."""
    return getattr(stream, "unfiltered", stream)


class _Closed:
    """A standard stream closed by the caller."""

    encoding = "utf-8"

    def write(self, _text):
        raise OSError(errno.EBADF, "it is closed")

    def flush(self):
        pass

    def isatty(self):
        return False


@contextlib.contextmanager
def standard_streams():
    """Replaces sys.stdout and sys.stderr while entered; returns the one of results."""
    before = sys.stdout, sys.stderr
    sys.stdout, sys.stderr = (Stream(_Closed() if raw is None else raw) for raw in before)
    try:
        yield sys.stdout
    finally:
        sys.stdout.flush()
        sys.stderr.flush()
        sys.stdout, sys.stderr = before


def fill_standard_descriptors():
    """Opens /dev/null for each closed descriptor of 0 to 2.

    Otherwise the next opened files get their numbers, and library output goes into them.
    """
    for number in (0, 1, 2):
        try:
            os.fstat(number)
        except OSError:
            taken = os.open(os.devnull, os.O_RDWR)  # the lowest free number
            os.set_inheritable(taken, True)
