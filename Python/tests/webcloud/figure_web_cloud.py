# SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
# SPDX-License-Identifier: BSD-3-Clause
"""The picture of a cloud's page in Docs/viewer.md: a run in headless Chromium, with a picked echo.

    vtkhelios run Data/Surveys/village_uls.xml --assets build/demo/scene --format vtp --waveforms
    build/venv/bin/python Python/tests/webcloud/figure_web_cloud.py output/village_uls PICTURE.jpg 760 380

Writes the page of the run to a temporary folder, picks the echo at pixel 760, 380, or the nearest with
a waveform, and writes the window of 1280 x 800 pixels as JPEG. Needs chromium.
"""

import base64
import pathlib
import sys
import tempfile

from vtkhelios import cli

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[1]))
from webcloud._browser import Browser  # noqa: E402  of the tests

READY = "window.vtkhelios?.state().isComplete && !vtkhelios.state().isMoving"


def draw(run, picture, x=640, y=420):
    """Writes the picture; returns the values of the picked echo."""
    browser = Browser(1280, 800)
    with tempfile.TemporaryDirectory() as folder:
        page = pathlib.Path(folder) / "page.html"
        assert cli.main(["view", str(run), "--html", str(page), "--color-by", "height"]) == 0
        browser.open(page)
        browser.wait(READY)
        browser.key("d")
        browser.mouse("mouseWheel", x, y, deltaX=0, deltaY=-500)
        browser.wait(READY)
        browser.click(x, y)
        browser.wait("vtkhelios.state().picked")
        browser.evaluate("document.getElementById('pick-wave')?.click()")
        browser.wait("vtkhelios.state().picked.wave")
        browser.wait(READY)
        picked = browser.evaluate("vtkhelios.state().picked.values")
        image = browser.call("Page.captureScreenshot", format="jpeg", quality=80)["data"]
        pathlib.Path(picture).write_bytes(base64.b64decode(image))
    browser.close()
    return picked


if __name__ == "__main__":
    print(draw(*sys.argv[1:3], *map(int, sys.argv[3:])))
