# SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
# SPDX-License-Identifier: BSD-3-Clause
"""The page of a cloud in headless Chromium: pixels, picking, levels of detail, waveforms."""

import math
import re

import numpy as np
import pytest
from webcloud._browser import Browser

from vtkhelios import webcloud

WIDTH, HEIGHT = 1000, 700
STATE = "vtkhelios.state()"
BACK = {"light": (255, 255, 255), "dark": (0x14, 0x17, 0x1A)}


@pytest.fixture(scope="module")
def browser():
    browser = Browser(WIDTH, HEIGHT)
    yield browser
    browser.close()


class Page:
    """An open page, seen from the top in parallel projection, without lighting."""

    def __init__(self, browser, read_pixels, folder):
        self.browser, self._read_pixels, self._folder = browser, read_pixels, folder

    def open(self, arrays, colour_by=None, tables=(), view="top"):
        path = self._folder / "page.html"
        path.write_text(webcloud.make_page(arrays, "test", colour_by=colour_by, tables=tables))
        self.browser.errors.clear()
        self.browser.requests.clear()
        self.browser.open(path)
        self.browser.wait("window.vtkhelios?.state().isComplete")
        if view:
            for key in ("l", "p", view[0]):
                self.browser.key(key)
            self.settle()
        return self

    def settle(self):
        """Waits for a still frame."""
        self.browser.evaluate("new Promise((done) => setTimeout(done, 60))")
        self.browser.wait(f"{STATE}.isComplete && !{STATE}.isMoving")
        self.browser.evaluate(
            "new Promise((done) => requestAnimationFrame(() => requestAnimationFrame(done)))"
        )

    @property
    def state(self):
        return self.browser.evaluate(STATE)

    def pixel_of(self, offset):
        """The pixel of the window of a point in the top view, from the cloud's lowest corner [m]."""
        state = self.state
        left, width, height = self.browser.evaluate(
            "(({left, width, height}) => [left, width, height])"
            "(document.getElementById('cloud').getBoundingClientRect())"
        )
        size = 2 * state["distance"] * math.tan(math.radians(22.5)) / height
        x, y = ((offset[axis] - state["target"][axis]) / size for axis in (0, 1))
        return left + width / 2 + x, height / 2 - y

    def pixels(self):
        """The window as rows from the top of red, green, blue."""
        (self._folder / "s.png").write_bytes(self.browser.screenshot())
        return self._read_pixels(self._folder / "s.png")[::-1]

    def colour_at(self, offset):
        x, y = self.pixel_of(offset)
        return tuple(int(value) for value in self.pixels()[int(y), int(x)])

    def text(self, selector):
        return self.browser.evaluate(f"document.querySelector({selector!r}).innerText")


@pytest.fixture
def page(browser, read_pixels, tmp_path):
    yield Page(browser, read_pixels, tmp_path)
    assert browser.errors == []
    assert all(url.startswith(("file:", "data:text/javascript")) for url in browser.requests)


def grid(side, spacing=1.0):
    """side x side points in a plane, from 0."""
    x, y = np.meshgrid(np.arange(side) * spacing, np.arange(side) * spacing)
    return np.column_stack([x.ravel(), y.ravel(), np.zeros(side * side)])


def test_colours_at_known_pixels(page):
    """Four quarters of a square, at UTM coordinates."""
    points = grid(300, 0.1)
    east, north = points[:, 0] > 15, points[:, 1] > 15
    colours = np.select(
        [(east & north)[:, None], east[:, None], north[:, None]],
        [[1.0, 0.0, 0.0], [0.0, 0.6, 0.0], [0.0, 0.2, 1.0]], [0.4, 0.4, 0.4],
    )  # fmt: skip
    page.open({"points": points + [431_000, 5_473_000, 0], "RGB": colours}, "RGB")
    expected = {
        (22, 22): (255, 0, 0),
        (22, 7): (0, 153, 0),
        (7, 22): (0, 51, 255),
        (7, 7): (102, 102, 102),
    }
    assert {place: page.colour_at(place) for place in expected} == expected
    assert page.colour_at((-0.5, 15)) == page.colour_at((15, 30.5)) == BACK["light"]
    left, top = page.pixel_of((0, 29.9))
    assert 0.85 * HEIGHT < page.pixel_of((0, 0))[1] - top <= HEIGHT  # fills the frame


@pytest.mark.parametrize("theme", ["light", "dark"])
def test_scale_is_viridis(page, theme):
    """Each theme leaves out the end that vanishes on its background."""
    points = grid(200)
    points[:, 2] = np.linspace(0, 98, 199).repeat(2)[:200][np.rint(points[:, 0]).astype(int)]
    page.open({"points": points}, "Height")
    if theme == "dark":
        page.browser.key("d")
        page.settle()
    low, high = page.state["limits"]
    first, last = (0.0, 0.9) if theme == "light" else (0.15, 1.0)
    colormaps = pytest.importorskip("matplotlib").colormaps
    for x in (30, 100, 170):
        height = points[x, 2]
        expected = colormaps["viridis"](first + (last - first) * (height - low) / (high - low))[:3]
        assert np.allclose(page.colour_at((x, 100)), 255 * np.array(expected), atol=4), x
    assert page.colour_at((-3, 100)) == BACK[theme]


def test_picking_returns_the_values_of_the_file(page, make_arrays):
    arrays = make_arrays(4000)
    page.open(arrays, "ClassificationIds")
    offsets = arrays["points"] - arrays["points"].min(axis=0)
    for row in (5, 1700, 3999):
        page.browser.click(*page.pixel_of(offsets[row]))
        page.browser.wait(f"{STATE}.picked")
        picked = page.state["picked"]
        assert np.array_equal(picked["coordinates"], arrays["points"][row])
        values = picked["values"]
        for name in ("PulseIds", "ClassificationIds", "ReturnNumber"):
            assert values[name] == arrays[name][row], name
        assert values["Range"] == pytest.approx(arrays["Range"][row], abs=5.1e-5)
        assert values["GpsTime"] == pytest.approx(arrays["GpsTime"][row], abs=5.1e-8)
        assert values["Amplitude"] == pytest.approx(arrays["Amplitude"][row], rel=1.6e-5)
        shown = page.text("#picked")
        assert f"{arrays['points'][row, 0]:.4f} m" in shown and "W" in shown
        page.browser.key("Escape")
        page.browser.wait(f"!{STATE}.picked")
        page.settle()


def test_hidden_categories_are_neither_drawn_nor_picked(page):
    points = grid(100)
    classes = np.where(points[:, 0] < 50, 2, 6)
    page.open({"points": points, "ClassificationIds": classes})
    assert page.state["colourBy"] == "ClassificationIds"
    assert page.colour_at((25, 50)) == (0xB5, 0x89, 0x3C) and page.colour_at((75, 50)) == (
        0xD5,
        0x5E,
        0,
    )
    assert re.search(r"2 ground\s*5,000\s*6 building\s*5,000", page.text("#legend"))
    page.browser.evaluate("document.querySelector('.category input').click()")
    page.settle()
    assert page.colour_at((25, 50)) == BACK["light"] and page.colour_at((75, 50)) == (0xD5, 0x5E, 0)
    page.browser.click(*page.pixel_of((25, 50)))
    page.settle()
    assert page.state["picked"] is None


def test_lighting_darkens_edges_only(page):
    points = grid(300, 0.1)
    inner = (np.abs(points[:, :2] - 15) < 5).all(axis=1)
    points[inner, 2] = 10
    page.open({"points": points, "RGB": np.full((len(points), 3), 0.8)}, "RGB")
    assert page.colour_at((15, 9.8)) == page.colour_at((3, 3)) == (204, 204, 204)
    page.browser.key("l")
    page.settle()
    x, y = (round(value) for value in page.pixel_of((15, 10)))
    column = page.pixels()[y - 15 : y + 15, x - 6 : x + 6].min(axis=(1, 2))
    assert column.min() < 150 and column[0] == column[-1] == 204


def test_values_that_are_missing_are_grey(page):
    points = grid(50)
    ranges = np.where(points[:, 0] < 25, np.nan, points[:, 0])
    page.open({"points": points, "Range": ranges}, "Range")
    assert page.colour_at((10, 25)) == (128, 128, 128) != page.colour_at((40, 25))


def test_first_frame_has_few_points_and_moving_keeps_a_budget(page, make_arrays):
    arrays = make_arrays(120_000)
    arrays = {"points": arrays["points"], "LegIds": np.zeros(120_000, int)}
    page.open(arrays, "Height", view=None)
    assert page.state["points"] == 120_000
    nodes = page.browser.evaluate("vtkhelios.cloud.nodes.map((node) => node.count)")
    assert nodes[0] <= 30_000 and sum(nodes) == 120_000
    few = page.browser.evaluate("vtkhelios.time(40000)")
    assert nodes[0] <= few["points"] <= 40_000
    page.browser.evaluate("vtkhelios.view.budget = 30000")
    page.browser.evaluate(
        "(() => { const found = []; vtkhelios.view.onFrame = () => found.push([vtkhelios.state().isMoving,"
        " vtkhelios.state().points]); window.found = found; })()"
    )
    page.browser.drag((500, 350), (560, 380))
    page.settle()
    counts = page.browser.evaluate("window.found")
    moving = [points for is_moving, points in counts if is_moving]
    assert moving and max(moving) <= max(1.1 * 30_000, nodes[0])
    assert page.state["points"] == 120_000


def test_nodes_out_of_sight_are_not_drawn(page, make_arrays):
    arrays = make_arrays(120_000)
    page.open({"points": arrays["points"]}, view="top")
    whole = page.state["points"]
    page.browser.mouse("mouseWheel", 500, 350, deltaX=0, deltaY=-1500)
    page.settle()
    assert page.state["points"] < 0.7 * whole
    page.browser.key("f")
    page.settle()
    assert page.state["points"] == whole


def test_zoom_keeps_the_point_under_the_mouse(page):
    page.open({"points": grid(100)})
    offset = (70, 60)
    x, y = page.pixel_of(offset)
    page.browser.mouse("mouseWheel", x, y, deltaX=0, deltaY=-300)
    page.settle()
    assert page.pixel_of(offset) == pytest.approx((x, y), abs=1)


def test_waveform_of_the_picked_echo(page):
    points = grid(10)
    pulses = 7_000_000_000 + np.arange(100)
    shape = np.exp(-((np.arange(40) - 12.5) ** 2) / 8)
    samples = np.concatenate([shape * (1 + k) * 1e-9 for k in range(99)]).astype(np.float32)
    table = {
        "PulseIds": pulses[:99], "StartTime": np.arange(99) + 60.5, "BinSize": np.full(99, 0.25),
        "Offset": 40 * np.arange(99), "Count": np.full(99, 40), "Samples": samples,
    }  # fmt: skip
    page.open({"points": points, "PulseIds": pulses, "Range": np.full(100, 15.0)}, tables=[table])
    page.browser.click(*page.pixel_of(points[77]))
    page.browser.wait(f"{STATE}.picked")
    wave = page.state["picked"]["wave"]
    first = round((wave["start"] - 137.5) / 0.25)
    assert wave["bin"] == 0.25 and first > 0  # without zeros at the ends
    found = np.pad(wave["samples"], (first, 40 - first - len(wave["samples"])))
    assert np.allclose(found, samples[77 * 40 :][:40], atol=0.51 * 78e-9 / 4095, rtol=0)
    label = page.browser.evaluate("document.querySelector('.chart').getAttribute('aria-label')")
    assert re.fullmatch("waveform of (1[89]|2[0-9]) samples, peak 75.6 nW", label), label
    page.browser.key("Escape")
    page.settle()
    page.browser.click(*page.pixel_of(points[99]))
    page.browser.wait(f"{STATE}.picked")
    assert page.state["picked"]["wave"] is None
    assert "The page has the waveforms of 99 of 99 pulses, not of this one." in page.text("#picked")
    page.browser.evaluate("document.getElementById('pick-wave').click()")
    page.browser.wait(f"{STATE}.picked.wave")
    assert page.state["picked"]["values"]["PulseIds"] in (pulses[98], pulses[89])


def test_cloud_of_one_point(page):
    page.open({"points": np.array([[431_000.123, 5_473_000.456, 7.0]]), "LegIds": np.array([4])})
    page.browser.click(*page.pixel_of((0, 0)))
    page.browser.wait(f"{STATE}.picked")
    assert page.state["picked"]["coordinates"] == [431_000.123, 5_473_000.456, 7.0]
    assert page.state["picked"]["values"] == {"LegIds": 4}


def test_first_view_leaves_out_outliers(page):
    """Unless they are near; the whole cloud is between the near and the far plane."""
    points = np.concatenate([grid(100), [[50, 50, 5000], [50, 50, -5000]]])
    page.open({"points": points})
    assert 0.85 * HEIGHT < page.pixel_of((0, 0))[1] - page.pixel_of((0, 99))[1] <= HEIGHT
    assert page.state["target"][2] == pytest.approx(5000, abs=1)


def test_distance_of_two_points(page):
    points = grid(40)
    points[:, 2] = 0.25 * points[:, 0]
    page.open({"points": points})
    page.browser.key("m")
    for row in (40 * 5 + 3, 40 * 8 + 7):
        page.browser.click(*page.pixel_of(points[row]))
        page.settle()
    assert page.text("#distance") == "5.09902 m (horizontal 5 m, vertical 1 m)"
    page.browser.key("Escape")
    assert page.browser.evaluate("document.getElementById('distance').hidden")


def test_touch(page):
    """One finger rotates, two pan and zoom."""
    page.open({"points": grid(100)})
    before = page.state

    def touch(kind, *places):
        points = [{"x": x, "y": y, "id": i} for i, (x, y) in enumerate(places)]
        page.browser.call("Input.dispatchTouchEvent", type=kind, touchPoints=points)

    touch("touchStart", (500, 300))
    touch("touchMove", (550, 300))
    touch("touchEnd")
    page.settle()
    assert page.state["distance"] == before["distance"] and page.state["picked"] is None
    touch("touchStart", (500, 300), (600, 300))
    touch("touchMove", (450, 300), (650, 300))
    touch("touchEnd")
    page.settle()
    assert page.state["distance"] == pytest.approx(before["distance"] / 2, rel=0.02)


def test_scale_bar(page):
    page.open({"points": grid(100)})
    length, unit = page.text("#bar-text").split()
    pixels = page.browser.evaluate("document.getElementById('bar').getBoundingClientRect().width")
    start, end = page.pixel_of((10, 10)), page.pixel_of((10 + float(length), 10))
    assert unit == "m" and end[0] - start[0] == pytest.approx(pixels, abs=1.5)


def test_ticks_are_round_and_have_units(page):
    points = grid(60)
    page.open({"points": points, "Amplitude": np.linspace(1.3e-9, 8.7e-9, 3600)}, "Amplitude")
    assert page.text("#legend .title") == "Amplitude [nW]"
    ticks = "[...document.querySelectorAll('.tick')].map((tick) => tick.innerText)"
    assert page.browser.evaluate(ticks) == ["2", "4", "6", "8"]
    page.open({"points": points, "Range": np.linspace(0.0004, 0.0021, 3600)}, "Range")
    assert page.browser.evaluate(ticks) == ["0.0005", "0.001", "0.0015", "0.002"]


def test_other_arrays_and_limits(page):
    points = grid(60)
    page.open(
        {"points": points, "Range": points[:, 0], "LegIds": (points[:, 1] > 30).astype(int)},
        "Range",
    )
    before = page.colour_at((50, 30))
    page.browser.evaluate(
        "(() => { const input = document.querySelectorAll('.limits input')[1]; input.value = '200';"
        " input.dispatchEvent(new Event('change')); })()"
    )
    page.settle()
    assert page.colour_at((50, 30)) != before and page.state["limits"][1] == 200
    page.browser.evaluate("vtkhelios.choose(2)")
    page.settle()
    assert page.state["colourBy"] == "LegIds" and page.colour_at((20, 10)) == (0, 0x72, 0xB2)


def test_help_lists_keys_and_licences(page):
    page.open({"points": grid(10)}, view=None)
    page.browser.key("h")
    assert "measure a distance" in page.text("#help")
    assert "twgl.js" in page.browser.evaluate("document.getElementById('licences').textContent")
    page.browser.key("h")
    assert not page.browser.evaluate("document.getElementById('help').open")


def test_without_webgl(page, browser):
    """The page names the reason and the remedy."""
    page.open({"points": grid(10)}, view=None)
    script = "HTMLCanvasElement.prototype.getContext = () => null"
    identifier = browser.call("Page.addScriptToEvaluateOnNewDocument", source=script)["identifier"]
    browser.call("Page.reload")
    browser.wait("document.getElementById('problem')?.hidden === false")
    assert page.text("#problem") == (
        "WebGL 2 is not available: use a current browser, with graphics acceleration on"
    )
    browser.call("Page.removeScriptToEvaluateOnNewDocument", identifier=identifier)
