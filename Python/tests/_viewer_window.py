# SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
# SPDX-License-Identifier: BSD-3-Clause
"""A viewer in a real window with simulated user input; checked by its state file."""

import json
import os
import shutil
import subprocess
import time

import numpy as np
import pytest

from vtkhelios.cli import view

WIDTH, HEIGHT = 800, 600
PATIENCE = 60  # [s] limit for a change on a busy machine

needs_window = pytest.mark.skipif(
    view.find_viewer() is None or not shutil.which("xdotool") or not shutil.which("Xvfb"),
    reason="the viewer, xdotool or Xvfb is missing",
)


@pytest.fixture(scope="module")
def display():
    """A separate X server."""
    server = subprocess.Popen(
        ["Xvfb", "-displayfd", "1", "-screen", "0", "1280x1024x24", "-noreset"],
        stdout=subprocess.PIPE,
        stderr=subprocess.DEVNULL,
        text=True,
    )
    yield f":{server.stdout.readline().strip()}"
    server.terminate()
    server.wait()


class Window:
    """A running viewer; pixels are counted from the lower left."""

    def __init__(self, display, folder, *arguments):
        self.folder = folder
        self.state_file = folder / "state.json"
        self.environment = {**os.environ, "DISPLAY": display}
        self.process = subprocess.Popen(
            [*view.command(view.find_viewer(), [*map(str, arguments)])]
            + ["--state", str(self.state_file), "--size", f"{WIDTH}x{HEIGHT}"],
            env=self.environment,
            cwd=folder,
            stderr=subprocess.PIPE,
            text=True,
        )

    def state(self):
        try:
            return json.loads(self.state_file.read_text())
        except FileNotFoundError:
            return None

    def wait(self, condition):
        """Waits for a state with a condition."""
        end = time.monotonic() + PATIENCE
        while time.monotonic() < end:
            state = self.state()
            if state and condition(state):
                return state
            if self.process.poll() is not None:
                raise AssertionError(f"it ended: {self.process.stderr.read()}")
            time.sleep(0.02)
        raise AssertionError(f"this did not come: {json.dumps(self.state())}")

    def do(self, *words):
        subprocess.run(["xdotool", *map(str, words)], env=self.environment, check=True)

    def move(self, pixel):
        # Without --sync: that waits long if the mouse is already there.
        self.do("mousemove", round(pixel[0]), round(HEIGHT - 1 - pixel[1]))

    def click(self, place, *held):
        """A click at a world position [m], with keys held."""
        self.move(self.project(place))
        for key in held:
            self.do("keydown", key)
        self.do("click", 1)
        for key in held:
            self.do("keyup", key)

    def key(self, name, place=None):
        self.move(self.project(place) if place else (WIDTH / 2, HEIGHT - 4))
        self.do("key", name)

    def project(self, place):
        """The pixel of a position [m]."""
        camera = self.state()["camera"]
        forward = np.subtract(camera["focalPoint"], camera["position"])
        forward = forward / np.linalg.norm(forward)
        right = np.cross(forward, camera["viewUp"])
        right = right / np.linalg.norm(right)
        up = np.cross(right, forward)
        way = np.subtract(place, camera["position"])
        half = np.tan(np.radians(camera["viewAngle"] / 2)) * way.dot(forward)
        half = camera["scale"] if camera["parallel"] else half
        scale = HEIGHT / 2 / half
        return WIDTH / 2 + scale * way.dot(right), HEIGHT / 2 + scale * way.dot(up)

    def close(self):
        self.key("q")
        self.process.wait(PATIENCE)
        return self.process.returncode


def opened(display, folder):
    """A function that opens viewers in a folder, and the list of open ones."""
    windows = []

    def open_one(*arguments, kind=Window):
        windows.append(kind(display, folder, *arguments))
        return windows[-1]

    return open_one, windows


def close_all(windows):
    for window in windows:
        if window.process.poll() is None:
            window.process.kill()
        window.process.communicate()
