# SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
# SPDX-License-Identifier: BSD-3-Clause
"""Opening and saving files, buttons and lists of a window, by keys and mouse."""

import time
import xml.etree.ElementTree as ET

import pytest
from _viewer_window import close_all, display, needs_window, opened  # noqa: F401

pytestmark = needs_window


def is_finished(state):
    return state["time"]["phase"] == "finished" and state["time"]["time"] == state["time"]["end"]


@pytest.fixture
def window(display, tmp_path, make_survey):
    """A finished survey of a tripod above a plane, beside a cloud and a bad survey."""
    (tmp_path / "three.xyz").write_text("0 0 0\n4 0 1\n0 3 2\n")
    (tmp_path / "bad.xml").write_text("<document><survey/></document>")
    open_one, windows = opened(display, tmp_path)
    window = open_one(make_survey(), "--save", "made.xml")
    window.wait(is_finished)
    yield window
    close_all(windows)


def press(window, button):
    place = window.wait(lambda s: button in s.get("buttons", {}))["buttons"][button]
    window.move((place["x"], place["y"]))
    window.do("click", 1)


def choose(window, title, text):
    """Chooses an item of a menu by the mouse."""
    state = window.wait(lambda s: title in [menu["title"] for menu in s["menus"]])
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


def get_ticks(state, title):
    return next(menu.get("ticks", []) for menu in state["menus"] if menu["title"] == title)


def test_the_legend_needs_no_mouse(window):
    state = window.wait(lambda s: "legend" in s["panels"])
    assert state["legend"]["title"] == "Height [m]"
    assert state["legend"]["marks"]


def test_a_cloud_and_a_survey_are_opened(window, tmp_path):
    press(window, "Open")
    state = window.wait(lambda s: s["dialog"]["open"])
    kinds = {entry["name"]: entry["kind"] for entry in state["dialog"]["entries"]}
    assert state["dialog"]["folder"] == str(tmp_path)
    assert kinds["three.xyz"] == "points" and kinds["survey.xml"] == "survey"
    assert kinds["scene.xml"] == "scene" and "state.json" not in kinds
    row = next(entry for entry in state["dialog"]["entries"] if entry["name"] == "three.xyz")
    window.move((row["x"], row["y"]))
    window.do("click", "--repeat", 2, "--delay", 60, 1)
    state = window.wait(lambda s: not s["dialog"]["open"] and s["cloud"]["points"] == 3)
    assert not state["scene"] and state["time"]["end"] == 0
    window.key("ctrl+o")
    window.wait(lambda s: s["dialog"]["open"])
    window.do("type", "--delay", 40, "survey")
    window.wait(lambda s: s["dialog"]["selected"] == "survey.xml")
    window.do("key", "Return")
    state = window.wait(lambda s: s["cloud"]["points"] > 1000 and is_finished(s))
    assert state["scene"] and not state["dialog"]["open"]


def test_what_cannot_be_opened_is_told(window, tmp_path):
    before = window.state()["cloud"]["points"]
    window.key("ctrl+o")
    window.wait(lambda s: s["dialog"]["open"])
    window.do("type", "--delay", 40, "./bad.xml")
    window.wait(lambda s: s["dialog"]["text"] == "./bad.xml")
    window.do("key", "Return")
    state = window.wait(lambda s: s["dialog"]["hint"])
    assert "bad.xml" in state["dialog"]["hint"]
    window.do("key", "Escape")
    state = window.wait(lambda s: not s["dialog"]["open"])
    assert state["cloud"]["points"] == before  # the survey is still there


def test_a_survey_is_saved_as(window, tmp_path):
    window.key("ctrl+s")
    state = window.wait(lambda s: s["dialog"]["open"])
    assert state["dialog"]["text"] == "made.xml"
    for _ in range(8):
        window.do("key", "BackSpace")
    window.wait(lambda s: s["dialog"]["text"] == "")
    window.do("type", "--delay", 40, "copy")
    window.wait(lambda s: s["dialog"]["text"] == "copy")
    window.do("key", "Return")
    window.wait(lambda s: s["editor"].get("saved", "").endswith("copy.xml"))
    assert ET.parse(tmp_path / "copy.xml").find("survey/leg") is not None
    assert not (tmp_path / "made.xml").exists()


def test_buttons_and_their_tips(window):
    press(window, "Top")
    state = window.wait(lambda s: s["camera"]["mode"] == "top" and s["buttons"]["Top"]["on"])
    assert not state["buttons"]["Free"]["on"]
    assert get_ticks(state, "Camera") == ["from above, north up"]
    window.wait(lambda s: "(t)" in s["tip"] and "tip" in s["panels"])
    press(window, "Scan")
    window.wait(lambda s: s["editor"]["on"] and s["buttons"]["Scan"]["on"])
    press(window, "Measure")
    window.wait(lambda s: s["measure"]["on"])


def test_lists_of_colours_and_instruments(window):
    choose(window, "Colours", "range")
    state = window.wait(lambda s: s["cloud"]["colorBy"] == "range")
    assert get_ticks(state, "Colours") == ["range"]
    window.key("d")
    state = window.wait(lambda s: s["editor"]["on"])
    platform = next(menu for menu in state["menus"] if menu["title"] == "Platform")
    assert "Car" in platform["items"]
    choose(window, "Platform", "Car")
    state = window.wait(lambda s: s["editor"]["platform"].endswith("#car"))
    assert get_ticks(state, "Platform") == ["Car"]
    assert state["editor"]["sliders"]["height"]["value"] == 0
    assert state["editor"]["sliders"]["speed"]["value"] == 10
    choose(window, "Instrument", "RIEGL VUX-1HA")
    state = window.wait(lambda s: s["editor"]["scanner"].endswith("#riegl_vux1ha"))
    assert state["editor"]["sliders"]["scanAngle"]["value"] == 180
    x, y, width, height = state["panels"]["editor"]
    line = 1.4 * state["textSize"]
    window.move((x + width / 2, y + height - state["textSize"] / 2 - 1.5 * line))
    window.do("click", 1)
    window.wait(lambda s: s["openMenu"] == [m["title"] for m in s["menus"]].index("Platform"))
    window.key("shift+m")  # lists of parts
    state = window.wait(lambda s: s["editor"]["mode"] == "parts")
    assert "Part" in [menu["title"] for menu in state["menus"]]


STREET = """\
<document><survey scene="scene.xml#s" platform="interpolated" basePlatform="platforms.xml#car_linearpath"
 scanner="scanners.xml#riegl_vux1ha"><leg><platformSettings trajectory="way.csv" tIndex="0" rollIndex="1"
 pitchIndex="2" yawIndex="3" xIndex="4" yIndex="5" zIndex="6"/><scannerSettings pulseFreq_hz="300000"
 scanFreq_hz="50" scanAngle_deg="120"/></leg></survey></document>
"""
WAY = "0,0,0,90,-3,0,0\n0.2,0,0,90,0,0,0\n"
ROAD = "v -20 -20 0\nv 20 -20 0\nv 20 20 0\nv -20 20 0\nf 1 2 3 4\n"
SCENE = """\
<document><scene id="s"><part id="road"><filter type="objloader">
<param type="string" key="filepath" value="road.obj"/></filter></part></scene></document>
"""


FLIGHT = """\
<document><survey scene="scene.xml#s" platform="platforms.xml#copter_linearpath"
 scanner="scanners.xml#riegl_vux1ha"><leg><platformSettings x="-8" y="0" z="42" movePerSec_m="8"/><scannerSettings
 pulseFreq_hz="300000" scanFreq_hz="50" scanAngle_deg="40"/></leg><leg><platformSettings x="8" y="0" z="42"/>
<scannerSettings active="false"/></leg></survey></document>
"""


def test_direct_control_flies_as_high_as_the_survey(display, tmp_path):
    (tmp_path / "survey.xml").write_text(FLIGHT)
    (tmp_path / "scene.xml").write_text(SCENE)
    (tmp_path / "road.obj").write_text(ROAD.replace(" 0\n", " 7\n"))
    open_one, windows = opened(display, tmp_path)
    window = open_one(tmp_path / "survey.xml")
    window.wait(is_finished)
    window.key("d")
    editor = window.wait(lambda s: s["editor"].get("sliders"))["editor"]
    assert editor["sliders"]["height"]["value"] == pytest.approx(35)
    assert editor["sliders"]["speed"]["value"] == 8
    assert [leg["ground"] for leg in editor["legs"]] == [7, 7]
    close_all(windows)


def test_direct_control_starts_from_the_survey(display, tmp_path):
    for name, text in ("survey.xml", STREET), ("way.csv", WAY), ("scene.xml", SCENE):
        (tmp_path / name).write_text(text)
    (tmp_path / "road.obj").write_text(ROAD)
    open_one, windows = opened(display, tmp_path)
    window = open_one(tmp_path / "survey.xml", "--save", "made.xml")
    window.wait(is_finished)
    window.key("d")
    editor = window.wait(lambda s: s["editor"].get("sliders"))["editor"]
    values = {name: slider["value"] for name, slider in editor["sliders"].items()}
    assert values["scanAngle"] == 120 and values["scanFrequency"] == 50
    assert values["pulseFrequency"] == 300000
    assert values["speed"] == pytest.approx(15)
    assert values["height"] == 0
    assert editor["platform"].endswith("platforms.xml#car_linearpath")
    window.key("t")
    window.wait(lambda s: s["camera"]["mode"] == "top")
    for number, place in enumerate([(-5.0, 0.0, 0.0), (5.0, 0.0, 0.0)]):
        window.click(place)
        window.wait(lambda s, n=number: len(s["editor"]["legs"]) == n + 1)
        time.sleep(0.4)  # no double click
    window.key("s")
    window.wait(lambda s: s["editor"].get("saved", "").endswith("made.xml"))
    leg = ET.parse(tmp_path / "made.xml").find("survey/leg")
    assert leg.find("scannerSettings").get("scanAngle_deg") == "120"
    assert float(leg.find("platformSettings").get("z", "0")) == 0
    close_all(windows)
