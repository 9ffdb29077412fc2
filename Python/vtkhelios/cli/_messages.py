# SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
# SPDX-License-Identifier: BSD-3-Clause
"""What the command line says: results on standard output, errors and warnings on standard error."""

import sys

from vtkmodules.vtkCommonCore import vtkLogger, vtkOutputWindow

from .._pipeline import clean_message, is_executive_message


class Messages:
    """Prints VTK's errors and warnings as one line each, at once.

    Listens to the objects it watches and to VTK's output window, where what
    nobody listens to ends.
    """

    def __init__(self, quiet=False, results=True):
        self.quiet = quiet
        self.results = results and not quiet  # whether info() prints
        self.errors = 0
        self.last = None
        self.write_error = lambda text: print(text, file=sys.stderr, flush=True)

    def __enter__(self):
        vtkLogger.SetStderrVerbosity(vtkLogger.VERBOSITY_OFF)
        self.watch(vtkOutputWindow.GetInstance())
        vtkOutputWindow.GetInstance().SetDisplayModeToNever()
        return self

    def __exit__(self, *_):
        vtkLogger.SetStderrVerbosity(vtkLogger.VERBOSITY_INFO)
        vtkOutputWindow.GetInstance().SetDisplayModeToDefault()

    def watch(self, vtk_object):
        for event, say in (("ErrorEvent", self.error), ("WarningEvent", self.warning)):

            def report(_caller, _event, text, say=say):
                message = clean_message(text)
                if not is_executive_message(message) and message != self.last:
                    self.last = message
                    say(message)

            report.CallDataType = "string0"
            vtk_object.AddObserver(event, report)

    def error(self, text):
        self.errors += 1
        self.write_error(f"error: {text}")

    def error_unless_told(self, text):
        """An error, unless the reason was reported already."""
        if not self.errors:
            self.error(text)

    def warning(self, text):
        if not self.quiet:
            self.write_error(f"warning: {text}")

    def info(self, text):
        if self.results:
            print(text, flush=True)
