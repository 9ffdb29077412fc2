# SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
# SPDX-License-Identifier: BSD-3-Clause
"""X displays, and virtual ones."""

import ctypes
import os
import shutil
import subprocess
import threading


def start_display(screen):
    """Starts Xvfb for this process and its children; whether that succeeded.

    It ends with this process, however that ends, and what the process becomes by os.execv(); if it
    is not started by the main thread, with the last of its clients.
    """
    before = end_with_parent()
    options = ["-noreset" if before else "-terminate", *screen, "-nolisten", "tcp"]
    program = shutil.which("Xvfb")
    if program is None:
        return False
    read, write = os.pipe()
    with open(read) as numbers:
        subprocess.Popen(
            [*before, program, "-displayfd", str(write), *options],
            pass_fds=[write], start_new_session=True,
            stdin=subprocess.DEVNULL, stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL,
        )  # fmt: skip
        os.close(write)
        number = numbers.readline().strip()  # empty if it ends
    if number:
        os.environ["DISPLAY"] = f":{number}"
    return bool(number)


def end_with_parent():
    """Words before a command that end it when this process ends; none if that is not possible."""
    program = shutil.which("setpriv")
    is_main = threading.current_thread() is threading.main_thread()  # else with the thread
    return [program, "--pdeathsig", "TERM", "--"] if program and is_main else []


def has_display():
    """Connects to the X display, for as long as the process lasts; whether there is one."""
    try:
        x11 = ctypes.CDLL("libX11.so.6")
    except OSError:
        return False
    x11.XOpenDisplay.restype = ctypes.c_void_p
    return bool(x11.XOpenDisplay(None))
