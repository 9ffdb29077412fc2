# SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
# SPDX-License-Identifier: BSD-3-Clause
"""Starts the command line: signals end it with one line, also while its modules are imported.

Importing takes a third of a second. The launcher blocks the signals until this module, which it runs
as a script, handles them. ``python -m vtkhelios`` and the script of a wheel import the package
first, which then calls handle_signals() itself.
"""

import os
import runpy
import signal

SIGNALS = (signal.SIGINT, signal.SIGTERM)
_LINE = b"error: interrupted; nothing was written\n"


def _end(number, _frame):
    os.write(2, _LINE)
    os._exit(128 + number)


def handle_signals():
    """Until a command handles them itself."""
    for number in SIGNALS:
        signal.signal(number, _end)
    signal.pthread_sigmask(signal.SIG_UNBLOCK, SIGNALS)  # set by the launcher


def is_command(argv, words):
    """Returns whether a process with these sys.argv and sys.orig_argv is the command line."""
    if argv[:1] == ["-m"]:  # only while the package is imported
        following = words[words.index("-m") + 1 :] if "-m" in words else []
        return following[:1] == ["vtkhelios"]
    return bool(argv) and os.path.basename(argv[0]) == "vtkhelios"


if __name__ == "__main__":
    handle_signals()
    runpy.run_module("vtkhelios", run_name="__main__")
