# SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
# SPDX-License-Identifier: BSD-3-Clause
"""The panels over the picture: places, texts, menus, themes; measuring and sections."""

import itertools
import json
import os
import re
import subprocess
import sys
import time

import numpy as np
import pytest
from _viewer_window import HEIGHT, close_all, display, needs_window, opened  # noqa: F401


pytestmark = needs_window

ROUND = re.compile(r"-?\d+(\.\d+)?( [pn\u00b5m]?W)?")


def is_finished(state):
    return state["time"]["phase"] == "finished" and state["time"]["time"] == state["time"]["end"]


@pytest.fixture
def window(display, tmp_path, make_survey):
    """A finished survey of a tripod above a plane."""
    open_one, windows = opened(display, tmp_path)
    window = open_one(make_survey())
    window.wait(is_finished)
    yield window
    close_all(windows)


@pytest.fixture
def still(make_survey, tmp_path, read_pixels):
    """Makes a picture of a survey; returns its pixels and the state of the viewer."""

    def make(*arguments):
        picture, state = tmp_path / "still.png", tmp_path / "still.json"
        words = [str(make_survey()), "--offscreen", "--still", str(picture), "--state", str(state)]
        environment = {key: value for key, value in os.environ.items() if key != "DISPLAY"}
        environment["PYTHONPATH"] = os.pathsep.join(sys.path)
        command = [sys.executable, "-P", "-m", "vtkhelios", "view", *words, *arguments]
        subprocess.run(command, check=True, env=environment, timeout=300)
        return read_pixels(picture), json.loads(state.read_text())

    return make


def check_places(state):
    """Panels are in the window, and none covers another."""
    width, height = state["window"]
    for x, y, w, h in state["panels"].values():
        assert x >= 0 and y >= 0 and x + w <= width and y + h <= height
    for (one, a), (other, b) in itertools.combinations(state["panels"].items(), 2):
        apart = (
            a[0] + a[2] <= b[0] or b[0] + b[2] <= a[0] or a[1] + a[3] <= b[1] or b[1] + b[3] <= a[1]
        )
        assert apart, (one, a, other, b)


def choose(window, title, text):
    """Chooses an item of a menu by the mouse."""
    state = window.state()
    number = [menu["title"] for menu in state["menus"]].index(title)
    menu, size = state["menus"][number], state["textSize"]
    bar = state["panels"]["menuBar"]
    window.move((menu["x"] + 1.5 * size, bar[1] + bar[3] / 2))
    window.do("click", 1)
    state = window.wait(lambda s: s["openMenu"] == number and "menu" in s["panels"])
    x, y, width, height = state["panels"]["menu"]
    row = (height - size) / len(menu["items"])
    window.move((x + width / 2, y + height - size / 2 - (menu["items"].index(text) + 0.5) * row))
    window.do("click", 1)
    window.wait(lambda s: s["openMenu"] == -1)


def test_panels_never_cover_each_other(window):
    window.key("i")
    window.wait(lambda s: s["inspector"].get("waveformSamples", 0) > 0 and "chart" in s["panels"])
    window.key("d")
    state = window.wait(lambda s: "editor" in s["panels"])
    assert {"menuBar", "timeBar", "legend", "axes", "scaleBar", "chart"} <= set(state["panels"])
    check_places(state)
    window.do("search", "--name", "vtkHelios", "windowsize", 1280, 800)
    window.wait(lambda s: s["window"] == [1280, 800] and s["panels"]["menuBar"][2] == 1280)
    state = window.wait(lambda s: "chart" in s["panels"] and "editor" in s["panels"])
    check_places(state)
    for slider in state["editor"]["sliders"].values():  # all are shown, left of the chart
        assert 0 < slider["x1"] * 1280 < state["panels"]["chart"][0]
        assert slider["y"] * 800 > state["panels"]["editor"][1]


def test_the_help_is_alone(window):
    window.key("h")
    state = window.wait(lambda s: "help" in s["panels"])
    assert set(state["panels"]) == {"help", "menuBar", "timeBar", "toolBar"}
    check_places(state)
    window.key("Escape")
    window.wait(lambda s: not s["help"] and "legend" in s["panels"])


def test_the_status_ends(window):
    state = window.wait(lambda s: "finished" in s["words"])
    assert "playing" not in state["words"]
    assert "/s" not in state["words"]
    assert "50 k pulses" in state["words"]


def test_the_legend_has_round_numbers(window):
    window.key("k")
    state = window.wait(lambda s: s["legend"]["title"] == "Amplitude")
    assert len(state["legend"]["marks"]) >= 2
    assert all(ROUND.fullmatch(mark) for mark in state["legend"]["marks"])
    assert all(mark.endswith("W") for mark in state["legend"]["marks"])
    window.key("shift+k")
    state = window.wait(lambda s: s["legend"]["title"] == "Height [m]")
    assert all(ROUND.fullmatch(mark) for mark in state["legend"]["marks"])


def test_menus_do_what_keys_do(window):
    choose(window, "Colours", "next colours")
    window.wait(lambda s: s["cloud"]["colorBy"] == "amplitude")
    choose(window, "Camera", "from above, north up")
    window.wait(lambda s: s["camera"]["mode"] == "top")
    choose(window, "Display", "light, dark colours")
    window.wait(lambda s: s["theme"] == "light")
    choose(window, "Measure", "measure distances: on, off; then click two points")
    window.wait(lambda s: s["measure"]["on"])


def test_a_distance(window):
    window.key("t")
    window.wait(lambda s: s["camera"]["mode"] == "top")
    window.key("shift+d")
    window.wait(lambda s: s["measure"]["on"])
    ends = np.array([[4.0, 3.0, 0.0], [-3.0, 5.0, 0.0]])
    for number, end in enumerate(ends):
        window.click(end)
        window.wait(lambda s, n=number: len(s["measure"]["points"]) == n + 1)
    state = window.state()
    for point, end in zip(state["measure"]["points"], ends):
        seen = np.subtract(window.project(point), window.project(end))
        assert np.hypot(*seen) <= 7  # pixels: the echo near the click
    distance = np.linalg.norm(np.subtract(*state["measure"]["points"]))
    assert state["measure"]["distance"] == pytest.approx(distance, abs=1e-9)
    assert f"distance {distance:.3f} m, horizontal " in state["words"]
    window.key("Escape")
    window.wait(lambda s: not s["measure"]["on"])


def test_a_section(window):
    window.key("t")
    window.wait(lambda s: s["camera"]["mode"] == "top")
    window.key("shift+s")
    window.wait(lambda s: s["section"]["on"])
    for end in ((-6.0, 4.0, 0.0), (6.0, 4.0, 0.0)):
        window.click(end)
        time.sleep(0.3)
    state = window.wait(lambda s: s["section"]["shown"])
    thickness = state["section"]["thickness"]
    assert f"section, {thickness:.3g} m thick" in state["words"]
    assert state["camera"]["parallel"]
    forward = np.subtract(state["camera"]["focalPoint"], state["camera"]["position"])
    assert abs(forward[2]) < 1e-6 * np.linalg.norm(forward)
    window.key("greater")
    window.wait(lambda s: s["section"]["thickness"] == pytest.approx(1.5 * thickness))
    window.key("shift+s")
    window.wait(lambda s: not s["section"]["shown"])


def test_the_coordinates_below_the_mouse(window):
    place = (5.0, 4.0, 0.0)
    window.move(window.project(place))
    state = window.wait(lambda s: s["cursor"])
    found = re.fullmatch(r"E (-?[\d.]+)  N (-?[\d.]+)  z (-?[\d.]+) m", state["cursor"])
    off = np.subtract(
        window.project([float(value) for value in found.groups()]), window.project(place)
    )
    assert np.abs(off).max() <= 2  # pixels
    window.move((5, HEIGHT / 2))  # the sky


def test_stills_have_no_status(still):
    _, state = still("--size", "640x480")
    assert {"legend", "scaleBar", "axes"} == set(state["panels"])
    check_places(state)


@pytest.mark.parametrize("theme, is_dark", [("dark", True), ("light", False)])
def test_themes(still, theme, is_dark):
    pixels, state = still("--size", "320x200", "--theme", theme, "--no-words", "--camera", "side")
    assert state["theme"] == theme
    corners = pixels[[0, 0, -1, -1], [0, -1, 0, -1]].astype(int)
    assert (corners.max() < 60) if is_dark else (corners.min() > 220)


def test_the_first_view_fills_the_frame(still):
    pixels, _ = still("--size", "400x300", "--no-words", "--no-fan", "--no-eye-dome")
    rows, columns = np.nonzero(pixels.max(axis=2) > 60)
    filled = max(np.ptp(rows) / 300, np.ptp(columns) / 400)
    assert 0.8 <= filled <= 1.0
