# SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
# SPDX-License-Identifier: BSD-3-Clause
"""The viewer, driven by keys and mouse on its own display; its state file shows the result."""

import os
import subprocess
import sys

import numpy as np
import pytest
from _viewer_window import HEIGHT, WIDTH, close_all, display, needs_window, opened  # noqa: F401


pytestmark = needs_window


@pytest.fixture
def open_window(display, tmp_path):
    """Opens viewers, and closes the remaining ones."""
    open_one, windows = opened(display, tmp_path)
    yield open_one
    close_all(windows)


def is_finished(state):
    return state["time"]["phase"] == "finished" and state["time"]["time"] == state["time"]["end"]


@pytest.fixture
def window(open_window, make_survey):
    """A finished survey of a tripod above a plane."""
    window = open_window(make_survey())
    window.wait(is_finished)
    return window


def distance(camera):
    return np.linalg.norm(np.subtract(camera["position"], camera["focalPoint"]))


def test_survey_runs_to_its_end(window):
    state = window.state()
    assert state["cloud"]["points"] > 5000
    assert state["cloud"]["drawn"] == state["cloud"]["points"]
    assert state["time"]["pulses"] == 50000  # 30 degrees at 60 degrees/s and 100 kHz
    assert state["cloud"]["bytes"] <= 40 * state["cloud"]["points"] + 2**23
    assert window.close() == 0


def test_keys_of_the_camera(window):
    before = window.state()["camera"]
    assert before["mode"] == "free"
    window.key("t")
    top = window.wait(lambda s: s["camera"]["mode"] == "top")["camera"]
    assert top["parallel"]
    assert top["viewUp"] == [0, 1, 0]
    assert top["position"][:2] == pytest.approx(top["focalPoint"][:2])
    window.key("x")
    side = window.wait(lambda s: s["camera"]["mode"] == "side")["camera"]
    assert side["position"][1] < side["focalPoint"][1]  # from the south
    window.key("v")
    eye = window.wait(lambda s: s["camera"]["mode"] == "scanner")["camera"]
    assert eye["position"] == pytest.approx([0, 0, 3.7], abs=0.5)  # the tripod's head
    window.key("c")
    window.key("r")
    window.wait(lambda s: s["camera"]["mode"] == "free" and not s["camera"]["parallel"])


def test_dragging_rotates_and_the_wheel_zooms(window):
    before = window.state()["camera"]
    window.move((400, 300))
    window.do("mousedown", 1)
    window.move((520, 340))
    window.do("mouseup", 1)
    turned = window.wait(lambda s: s["camera"]["position"] != before["position"])["camera"]
    assert turned["focalPoint"] == pytest.approx(before["focalPoint"], abs=1e-3)
    assert distance(turned) == pytest.approx(distance(before), rel=1e-3)
    window.do("click", 4)
    window.wait(lambda s: distance(s["camera"]) < 0.99 * distance(turned))


def test_the_time_bar_seeks(window):
    window.key("space")
    state = window.wait(lambda s: not s["time"]["playing"])
    left, right, height = state["time"]["bar"]
    # VTK's slider leaves half of its length free at either end.
    window.move((WIDTH * (left + 0.25 * (right - left)), HEIGHT * height))
    window.do("click", 1)
    span = state["time"]["end"] - state["time"]["start"]
    state = window.wait(lambda s: s["time"]["time"] < 0.9 * span)
    assert state["time"]["time"] == pytest.approx(0.25 * span, abs=0.02 * span)
    assert state["cloud"]["drawn"] < 0.5 * state["cloud"]["points"]
    window.key("End")
    window.wait(lambda s: s["cloud"]["drawn"] == s["cloud"]["points"])


def test_keys_of_time(window):
    window.key("Home")
    window.key("1")
    window.wait(lambda s: s["time"]["speed"] == 1)
    window.key("minus")
    window.wait(lambda s: s["time"]["speed"] == 0.5)
    window.key("plus")
    window.key("plus")
    window.wait(lambda s: s["time"]["speed"] == 2)
    window.key("space")
    state = window.wait(lambda s: not s["time"]["playing"])
    window.key("comma")
    step = window.wait(lambda s: s["time"]["time"] != state["time"]["time"])
    assert step["time"]["time"] == pytest.approx(
        max(0, state["time"]["time"] - 0.01)
    )  # 100 lines/s


def test_keys_of_colours_and_display(window):
    window.key("k")
    window.wait(lambda s: s["cloud"]["colorBy"] == "amplitude")
    window.key("shift+k")
    window.wait(lambda s: s["cloud"]["colorBy"] == "height")
    window.key("bracketright")
    window.wait(lambda s: s["cloud"]["pointSize"] == 3)
    window.key("e")
    window.wait(lambda s: not s["cloud"]["eyeDome"])
    window.key("b")
    window.wait(lambda s: s["cloud"]["clipping"])
    window.key("m")
    window.wait(lambda s: not s["scene"])
    window.key("h")
    window.wait(lambda s: s["help"])
    window.key("w")
    window.wait(lambda s: s["words"].strip() == "")


def test_a_picture_and_a_video(window, tmp_path, read_pixels):
    window.key("p")
    window.wait(lambda s: s["message"] == "saved vtkhelios.png")
    assert read_pixels(tmp_path / "vtkhelios.png").shape == (HEIGHT, WIDTH, 3)
    window.key("shift+r")
    window.wait(lambda s: s["recording"])
    window.key("shift+r")
    window.wait(lambda s: not s["recording"])
    assert (tmp_path / "vtkhelios.ogv").read_bytes()[:4] == b"OggS"


def test_a_click_inspects_the_echo_at_that_pixel(window):
    window.key("t")
    window.wait(lambda s: s["camera"]["mode"] == "top")
    window.key("i")  # the echo nearest to the centre
    first = window.wait(lambda s: s["inspector"].get("waveformSamples", 0) > 0)["inspector"]
    window.key("Escape")
    window.wait(lambda s: s["inspector"].get("row", -1) < 0)
    window.click(first["position"])
    again = window.wait(lambda s: s["inspector"].get("waveformSamples", 0) > 0)["inspector"]
    seen = window.project(again["position"])
    assert np.hypot(*np.subtract(seen, window.project(first["position"]))) <= 6  # pixels
    assert again["subRays"] > 0 and again["echoes"] >= 1
    window.key("Escape")


def test_another_size(window):
    window.do("search", "--name", "vtkHelios", "windowsize", 640, 480)
    window.wait(lambda s: s["window"] == [640, 480])


def test_failed_survey_shows_its_error(open_window, make_survey, tmp_path):
    survey = make_survey()
    (tmp_path / "plane.obj").write_text("v 0 0 0\n")
    window = open_window(survey)
    state = window.wait(lambda s: "The scene is empty" in s["message"])
    assert state["time"]["phase"] == "failed"
    assert "The scene is empty" in state["words"]
    assert window.close() == 1


def view_command(*arguments, **environment):
    """Runs the command line to the end without a display."""
    own = {key: value for key, value in os.environ.items() if key != "DISPLAY"}
    words = [sys.executable, "-P", "-m", "vtkhelios", "view", *map(str, arguments)]
    own |= {"PYTHONPATH": os.pathsep.join(sys.path), **environment}
    return subprocess.run(words, capture_output=True, text=True, env=own, timeout=300)


def test_without_a_display(make_survey):
    ended = view_command(make_survey())
    assert ended.returncode == 1
    assert "there is no display (DISPLAY is not set)" in ended.stderr
    assert "xvfb-run" in ended.stderr
    ended = view_command(make_survey(), DISPLAY=":98765")
    assert ended.returncode == 1
    assert "the display :98765 cannot be opened" in ended.stderr


def test_pictures_offscreen(make_survey, tmp_path, read_pixels):
    still = tmp_path / "still.png"
    ended = view_command(
        make_survey(), "--offscreen", "--still", still, "--size", "320x200", "--camera", "top",
        "--no-words", "--color-by", "one", "--no-fan"
    )  # fmt: skip
    assert (ended.returncode, ended.stderr) == (0, "")
    assert read_pixels(still).shape == (200, 320, 3)
    ended = view_command(
        make_survey(), "--offscreen", "--record", tmp_path / "f%02d.png", "--seconds", "0.2",
        "--fps", "10", "--size", "160x120", "--camera", "follow"
    )  # fmt: skip
    assert (ended.returncode, ended.stderr) == (0, "")
    assert sorted(path.name for path in tmp_path.glob("f*.png")) == ["f00.png", "f01.png"]


@pytest.mark.parametrize(
    "arguments, code, message",
    [
        (["none.xml"], 1, "none.xml: no such file; check the name"),
        (["SURVEY", "--speed", "0"], 2, "--speed 0: give 0.01 to 1000, or max"),
        (["SURVEY", "--size", "big"], 2, "--size big: give WIDTHxHEIGHT, 64x64 to 16384x16384"),
        (["SURVEY", "--offscreen"], 2, "give --record or --still"),
        (["SURVEY", "--seconds", "3"], 2, "give --record, too"),
        (["SURVEY", "--camera", "moon"], 2, "moon not in {free,fly"),
        (["SURVEY", "OTHER"], 1, "is shown by itself; leave out"),
        (["SURVEY", "--plugin", "none.so"], 1, "none.so: no such file; give a plug-in"),
        (["SURVEY", "--plugin", __file__], 1, "is no library (.so), the plug-ins of this program"),
        (["SURVEY", "--offscreen", "--still", "a.jpg"], 1, "stills are PNG"),
        (["SURVEY", "--offscreen", "--still", "no/a.png"], 1, "the folder no does not exist"),
        (["SURVEY", "--offscreen", "--record", "a.mp4"], 1, "give a name that ends in .ogv"),
    ],
)
def test_errors(make_survey, display, arguments, code, message):
    survey = str(make_survey())
    words = [survey if word in ("SURVEY", "OTHER") else word for word in arguments]
    ended = view_command(*words, DISPLAY=display)
    assert message in ended.stderr
    assert ended.returncode == code


def test_command_line_starts_the_viewer(command_line):
    ended = command_line("view", "--help")
    assert ended.returncode == 0
    assert "--offscreen" in ended.stdout
