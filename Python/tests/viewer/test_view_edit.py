# SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
# SPDX-License-Identifier: BSD-3-Clause
"""Interactive scanner editing in the viewer, driven by keys and mouse."""

import pathlib
import time
import xml.etree.ElementTree as ET

import numpy as np
import pytest
from _viewer_window import (
    HEIGHT,
    WIDTH,
    Window,
    close_all,
    display,  # noqa: F401
    needs_window,
    opened,
)

pytestmark = needs_window

SURVEY = """\
<document><survey name="yard" scene="scene.xml#yard" platform="platforms.xml#tripod"
 scanner="scanners.xml#vz400_class_tls"><leg><platformSettings x="-8" y="-9" onGround="true"/>
<scannerSettings pulseFreq_hz="100000" scanFreq_hz="20" headRotatePerSec_deg="60"
 headRotateStop_deg="30"/></leg></survey></document>
"""
SCENE = """\
<document><scene id="yard"><part id="ground"><filter type="objloader">
<param type="string" key="filepath" value="ground.obj"/></filter></part>
<part id="house"><filter type="objloader"><param type="string" key="filepath" value="house.obj"/>
</filter><filter type="translate"><param type="vec3" key="offset" value="4;2;0"/></filter>
</part></scene></document>
"""
GROUND = "mtllib m.mtl\nusemtl grass\nv -20 -20 0\nv 20 -20 0\nv 20 20 0\nv -20 20 0\nf 1 2 3 4\n"
HOUSE = (
    "mtllib m.mtl\nusemtl wall\n"
    + "".join(f"v {x} {y} {z}\n" for z in (0, 4) for x, y in ((0, 0), (8, 0), (8, 6), (0, 6)))
    + "f 1 4 3 2\nf 5 6 7 8\nf 1 2 6 5\nf 2 3 7 6\nf 3 4 8 7\nf 4 1 5 8\n"
)
MATERIALS = "newmtl grass\nhelios_isGround true\nnewmtl wall\nhelios_reflectance 0.3\n"


class Hands(Window):
    """A viewer, and user actions of its editor."""

    def __init__(self, display, folder, *arguments):
        made = ["--save", "made.xml", "--no-eye-dome", "--no-fan"]
        super().__init__(display, folder, *arguments, *made)

    def edit(self, condition):
        """Waits until a condition holds for the editor's state."""
        return self.wait(lambda s: condition(s["editor"]))["editor"]

    def drag(self, name, value):
        """Drags a slider to a value."""
        slider = self.state()["editor"]["sliders"][name]
        span = slider["max"] - slider["min"]

        def pixel(number):
            share = (number - slider["min"]) / span
            x = slider["x0"] + share * (slider["x1"] - slider["x0"])
            return (
                WIDTH * min(max(x, slider["x0"] + 0.006), slider["x1"] - 0.006),
                HEIGHT * slider["y"],
            )

        self.move(pixel(slider["value"]))
        self.do("mousedown", 1)
        time.sleep(0.1)
        self.move(pixel(0.5 * (slider["value"] + value)))
        self.move(pixel(value))
        time.sleep(0.1)
        self.do("mouseup", 1)


@pytest.fixture
def take(display, tmp_path):
    """Opens a file of the yard and starts the editor."""
    files = {"survey.xml": SURVEY, "scene.xml": SCENE, "ground.obj": GROUND, "house.obj": HOUSE}
    for name, text in {**files, "m.mtl": MATERIALS}.items():
        (tmp_path / name).write_text(text)
    open_one, windows = opened(display, tmp_path)

    def take_one(name="survey.xml", *arguments):
        hands = open_one(name, *arguments, kind=Hands)
        hands.wait(
            lambda s: s["time"]["phase"] == "finished" or (name != "survey.xml" and s["scene"])
        )
        hands.do("search", "--sync", "--onlyvisible", "--name", "vtkHelios")
        time.sleep(0.5)  # until it is ready
        hands.key("d")
        hands.edit(lambda e: e["on"])
        return hands

    yield take_one
    close_all(windows)


def is_scanned(state):
    """Whether all echoes of a scan have arrived since Return was pressed."""
    time = state["time"]
    is_done = time["phase"] == "finished" and time["computed"] >= time["end"] > 0
    return is_done and state["editor"]["scans"] == 1


def count_points(folder):
    """The echoes written by vtkhelios run."""
    return sum(len(file.read_text().splitlines()) for file in folder.rglob("leg*_points.xyz"))


def test_a_click_places_the_tripod(take):
    hands = take()
    for place in ((5, -12, 0), (-12, 3, 0)):
        hands.click(place)
        legs = hands.edit(lambda e, p=place: abs(e["legs"][0]["position"][0] - p[0]) < 1)["legs"]
        assert len(legs) == 1
        assert legs[0]["onGround"]
        assert legs[0]["position"][2] == pytest.approx(0, abs=1e-9)
        # The mouse moves to whole pixels: accuracy is half a pixel.
        off = np.subtract(hands.project(legs[0]["position"]), hands.project(place))
        assert np.abs(off).max() <= 1.0
    hands.click((8, 5, 4))  # the roof is not ground
    legs = hands.edit(lambda e: e["legs"][0]["position"][2] > 3)["legs"]
    assert legs[0]["position"][2] == pytest.approx(4, abs=1e-6)
    assert not legs[0]["onGround"]


def test_scan_positions_are_added_and_removed(take):
    hands = take()
    hands.click((5, -12, 0), "shift")
    hands.edit(lambda e: len(e["legs"]) == 2)
    hands.key("a", (-12, 3, 0))
    hands.edit(lambda e: len(e["legs"]) == 3)
    hands.key("Delete")
    hands.edit(lambda e: len(e["legs"]) == 2)
    hands.key("z")
    hands.edit(lambda e: len(e["legs"]) == 3)
    hands.key("z")
    hands.key("z")
    editor = hands.edit(lambda e: len(e["legs"]) == 1)
    assert editor["legs"][0]["position"][:2] == [-8, -9]
    hands.key("d")
    hands.edit(lambda e: not e["on"])
    hands.click((5, -12, 0))
    hands.key("h")
    state = hands.wait(lambda s: s["help"])
    assert len(state["editor"]["legs"]) == 1  # off: clicks add no position
    assert state["editor"]["legs"][0]["position"][:2] == [-8, -9]


def test_edited_survey_runs_as_displayed(take, command_line, tmp_path):
    hands = take("survey.xml", "--seed", "3")
    before = hands.state()["cloud"]["points"]
    hands.click((5, -12, 0))
    hands.edit(lambda e: abs(e["legs"][0]["position"][0] - 5) < 1)
    hands.drag("headStop", 90)
    editor = hands.edit(lambda e: e["sliders"]["headStop"]["value"] > 80)
    assert editor["sliders"]["headStop"]["value"] == pytest.approx(90, abs=10)
    hands.drag("pulseFrequency", 300000)
    hands.edit(lambda e: e["sliders"]["pulseFrequency"]["value"] == 300000)
    hands.key("Return")
    state = hands.wait(is_scanned)
    assert state["cloud"]["points"] > 2 * before
    hands.key("s")
    hands.edit(lambda e: e["saved"] == "made.xml")
    ended = command_line("validate", tmp_path / "made.xml")
    assert ended.returncode == 0, ended.stderr
    ended = command_line("run", tmp_path / "made.xml", "--output", tmp_path / "out")
    assert ended.returncode == 0, ended.stderr
    assert count_points(tmp_path / "out") == state["cloud"]["points"]
    assert hands.close() == 0


def test_flight_lines_over_a_rectangle(take, command_line, tmp_path):
    hands = take()
    first = hands.state()["editor"]["platform"]
    hands.key("Tab")
    editor = hands.edit(lambda e: e["platform"] != first)
    assert "height" in editor["sliders"]
    assert "headStop" not in editor["sliders"]
    scanner = editor["scanner"]
    hands.key("g")
    hands.edit(lambda e: e["scanner"] != scanner)
    hands.drag("speed", 20)
    hands.edit(lambda e: abs(e["sliders"]["speed"]["value"] - 20) < 5)
    hands.drag("scanFrequency", 50)
    hands.key("shift+a")
    hands.edit(lambda e: e["mode"] == "area")
    hands.click((-15, -15, 0))
    hands.wait(lambda s: "opposite" in s["message"])
    hands.click((18, -2, 0))  # nothing hides it
    editor = hands.edit(lambda e: e["mode"] == "scanner" and len(e["legs"]) >= 2)
    assert [leg["active"] for leg in editor["legs"]] == [True, False] * (len(editor["legs"]) // 2)
    height = editor["sliders"]["height"]["value"]
    assert editor["legs"][0]["position"][2] == pytest.approx(height, abs=1e-6)
    hands.key("Return")
    state = hands.wait(is_scanned)
    hands.key("s")
    hands.edit(lambda e: e["saved"])
    ended = command_line("run", tmp_path / "made.xml", "--output", tmp_path / "out")
    assert ended.returncode == 0, ended.stderr
    assert count_points(tmp_path / "out") == hands.state()["cloud"]["points"]
    assert state["cloud"]["points"] > 100


def get_offset(scene, part):
    """The offset of a part of a scene file [m]."""
    found = ET.parse(scene).find(f".//part[@id='{part}']//param[@key='offset']")
    return [float(number) for number in found.get("value").split(";")]


def test_parts_of_the_scene(take, command_line, tmp_path):
    hands = take()
    hands.key("shift+m")
    hands.edit(lambda e: e["mode"] == "parts" and e["parts"] == ["ground", "house"])
    hands.click((8, 5, 4))
    hands.edit(lambda e: e["part"] == "house")
    hands.key("Right")
    hands.edit(lambda e: e["undos"] == 1)
    hands.key("less")
    hands.edit(lambda e: e["undos"] == 2)
    hands.key("z")
    hands.edit(lambda e: e["undos"] == 1)
    while pathlib.Path(hands.state()["editor"]["file"]).name != "house.obj":
        before = hands.state()["editor"]["file"]
        hands.key("g")
        hands.edit(lambda e, b=before: e["file"] != b)
    hands.key("a", (-13, -12, 0))  # beside the tripod
    hands.edit(lambda e: e["parts"] == ["ground", "house", "house_2"])
    hands.key("s")
    hands.edit(lambda e: e["saved"])
    assert get_offset(tmp_path / "made_scene.xml", "house") == pytest.approx([4.5, 2, 0])
    assert get_offset(tmp_path / "made_scene.xml", "house_2")[:2] == pytest.approx(
        [-17, -15], abs=0.5
    )
    assert 'scene="made_scene.xml#yard"' in (tmp_path / "made.xml").read_text()
    hands.key("Return")
    state = hands.wait(is_scanned)
    ended = command_line("run", tmp_path / "made.xml", "--output", tmp_path / "out")
    assert ended.returncode == 0, ended.stderr
    assert count_points(tmp_path / "out") == state["cloud"]["points"]
    hands.click((4.5 + 4, 5, 4))
    hands.edit(lambda e: e["part"] == "house")
    hands.key("Delete")
    hands.edit(lambda e: e["parts"] == ["ground", "house_2"])


def test_scene_becomes_a_survey(take, command_line, tmp_path):
    hands = take("scene.xml")
    hands.key("Return")
    hands.wait(lambda s: "has 0 <leg>" in s["message"])
    hands.click((-5, -12, 0))
    editor = hands.edit(lambda e: len(e["legs"]) == 1)
    assert editor["platform"].endswith("platforms.xml#tripod")
    hands.drag("headStop", 20)
    hands.edit(lambda e: e["sliders"]["headStop"]["value"] < 40)
    hands.key("Return")
    assert hands.wait(is_scanned)["cloud"]["points"] > 100
    hands.key("s")
    hands.edit(lambda e: e["saved"])
    ended = command_line("validate", tmp_path / "made.xml")
    assert ended.returncode == 0, ended.stderr
