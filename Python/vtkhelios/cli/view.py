# SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
# SPDX-License-Identifier: BSD-3-Clause
"""vtkhelios view: starts the viewer, a program of its own.

The viewer reads text, LAS, LAZ, PLY and VTK files itself. Clouds of other formats are converted to LAS
files in a temporary folder first, and the folder is removed after the viewer has ended.
"""

import os
import pathlib
import shutil
import signal
import subprocess
import sys
import tempfile

import vtkhelios

from .._built_with import HAS_VIEWER, VTK_PACKAGE
from ..core.display import end_with_parent, start_display
from ..core.folders import data_directory
from ..formats._endings import converted_for_view
from . import _web, run_command
from ._messages import say_error
from ._stopping import SIGNALS, Interrupted, claim_line

SUMMARY = "view a survey while it runs, a run, clouds and scenes; clouds as web pages (--html)"

PROGRAM = "vtkhelios-viewer"
SCREEN = ("-screen", "0", "1280x1024x24")
SECONDS_TO_END = 0.25  # time for the viewer to end, after a signal


def find_viewer():
    """Returns the viewer of this build or installation, or None."""
    package = pathlib.Path(vtkhelios.__file__).absolute().parent
    beside = package.parents[3] / "bin" / PROGRAM  # below lib/python3/dist-packages
    within = package / "bin" / PROGRAM  # place in a wheel
    found = next((path for path in (within, beside) if path.is_file()), None)
    return str(found) if found else shutil.which(PROGRAM)


def command(viewer, arguments):
    """Returns the command of the viewer."""
    shipped = data_directory()
    full = [viewer, *arguments]
    if arguments and not {"-h", "--help", "--version"} & set(arguments):
        full += ["--assets", f"{shipped}", "--assets", f"{shipped}/Assets"]
    return full


def provide_display(arguments):
    """Starts a display for a viewer without a window; if that fails, the viewer reports it."""
    if "--offscreen" in arguments and not os.environ.get("DISPLAY"):
        start_display(SCREEN)


def explain_missing():
    """Why there is no viewer, and the remedy."""
    if VTK_PACKAGE != "vtkmodules":
        return (
            f"the wheel has no {PROGRAM}, which needs X11 and OpenGL; show clouds with PyVista "
            "(vtkhelios.Cloud.to_pyvista), or build vtkHelios from its sources: Docs/install.md"
        )
    tree = pathlib.Path(vtkhelios.__file__).absolute().parents[4]  # place in a build
    build = f"cmake --build {tree} --target {PROGRAM}"
    if not (tree / "CMakeCache.txt").is_file():
        left_out = (
            "was left out when vtkHelios was built; build it with -DVTKHELIOS_BUILD_VIEWER=ON"
        )
        missing = f"is not installed in {tree / 'bin'}; install it: cmake --install BUILD"
        return f"{PROGRAM} {missing if HAS_VIEWER else left_out}"
    if HAS_VIEWER:
        return f"{PROGRAM} is not built yet; build it: {build}"
    return (
        f"{PROGRAM} is left out of this build (VTKHELIOS_BUILD_VIEWER is OFF); build it: "
        f"cmake -DVTKHELIOS_BUILD_VIEWER=ON {tree} && {build}"
    )


def needs_conversion(argument):
    """Returns whether an argument is a cloud that the viewer does not read itself."""
    name = argument.lower()
    return name.endswith(converted_for_view()) and os.path.isfile(argument)


def convert_inputs(arguments, folder):
    """Returns the arguments with converted clouds, or None after an error, which is printed."""
    converted = []
    for number, argument in enumerate(arguments):
        if needs_conversion(argument):
            output = pathlib.Path(folder) / f"{number}" / f"{pathlib.Path(argument).stem}.las"
            output.parent.mkdir()
            if run_command(["convert", argument, str(output), "--skip-invalid", "--quiet"]) != 0:
                return None
            argument = str(output)
        converted.append(argument)
    return converted


def view_converted(viewer, arguments):
    """Runs the viewer on converted clouds; returns its exit code."""
    with tempfile.TemporaryDirectory(prefix="vtkhelios-view-") as folder:
        converted = convert_inputs(arguments, folder)
        if converted is None:
            return 1
        return run_viewer(command(viewer, converted))


def run_viewer(full):
    """Runs the viewer; returns its exit code. A signal is passed on to it, which reports the stop."""
    process = subprocess.Popen([*end_with_parent(), *full], start_new_session=True)
    try:
        return process.wait()
    except Interrupted as interruption:
        process.send_signal(interruption.signal)
        try:
            code = process.wait(timeout=SECONDS_TO_END)
        except subprocess.TimeoutExpired:
            process.kill()
            raise
        if code != 128 + interruption.signal:  # it had not begun
            raise
        claim_line()
        return code


def start(arguments):
    if "--html" in {word.split("=")[0] for word in arguments}:
        return _web.start(arguments)
    viewer = find_viewer()
    if viewer is None:
        say_error(explain_missing())
        return 1
    provide_display(arguments)
    if any(map(needs_conversion, arguments)):
        return view_converted(viewer, arguments)
    full = command(viewer, arguments)
    sys.stdout.flush()
    signal.pthread_sigmask(signal.SIG_BLOCK, SIGNALS)  # until the viewer handles them
    os.execv(full[0], full)
