# SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
# SPDX-License-Identifier: BSD-3-Clause
"""Size and speed of the page of a cloud.

    build/venv/bin/python Testing/Benchmarks/web_cloud.py [MILLIONS ...]

For clouds of so many million points (default: 1 and 3) with the arrays of a run, over hilly ground
with houses: the time to make the page [s], its size [MB], the time in headless Chromium (1280 x 800,
software rasteriser) from opening to the first frame with points and to the last one [s], and the
times [ms] of a frame of all points and of one of at most 200,000. First it checks that the page has
every point of the cloud and draws them all, of more than MAXIMUM_DRAWN at least so many (the others are
closer together than pixels), and that a picked point has the values of the cloud.
"""

import pathlib
import sys
import tempfile
import time

import numpy as np

from vtkhelios import webcloud

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[2] / "Python/tests"))
from webcloud._browser import Browser  # noqa: E402  of the tests

REPEATS = 5
MAXIMUM_DRAWN = 1_000_000  # points of the first view, without leaving out points


def make_cloud(count):
    """Scan lines over an area of 500 m x 400 m, at UTM coordinates in millimetres."""
    random = np.random.default_rng(1)
    x, y = random.uniform(0, 500, count), random.uniform(0, 400, count)
    order = np.lexsort((x, np.floor(y)))
    x, y = x[order], y[order]
    house = ((x // 25 + y // 25) % 3 == 0) & (x % 25 < 12) & (y % 25 < 12)
    z = 210 + 8 * np.sin(x / 60) * np.cos(y / 50) + 6.0 * house
    points = np.round(
        np.column_stack([431_000 + x, 5_473_000 + y, z]) + random.normal(0, 0.01, (count, 3)), 3
    )
    ranges = np.linalg.norm(points - [431_250, 5_473_200, 700], axis=1)
    pulses = np.arange(count)
    return {
        "points": points, "GpsTime": 1e-5 * pulses, "PulseIds": pulses, "Range": ranges,
        "ReturnNumber": np.ones(count, np.uint8), "NumberOfReturns": np.ones(count, np.uint8),
        "Amplitude": 1e-3 * random.uniform(0.5, 1, count) / ranges**2,
        "EchoWidth": random.normal(4.0, 0.02, count), "ScanAngle": np.degrees(np.arctan((x - 250) / 490)),
        "ClassificationIds": np.where(house, 6, 2), "PartIds": np.where(house, 1, 0),
        "MaterialIds": np.where(house, 1, 0), "IncidenceAngle": random.uniform(0, 30, count),
        "LegIds": (y // 100).astype(np.int32),
    }  # fmt: skip


def check(browser, cloud):
    """All points are there and drawn, and a picked one is a point of the cloud."""
    count = len(cloud["points"])
    nodes = browser.evaluate("vtkhelios.cloud.nodes.map((node) => node.count)")
    drawn = browser.evaluate("vtkhelios.state().points")
    assert sum(nodes) == count
    assert drawn == count if count <= MAXIMUM_DRAWN else drawn >= MAXIMUM_DRAWN
    browser.evaluate("vtkhelios.pick({node: vtkhelios.cloud.nodes[0], point: 77})")
    picked = browser.evaluate("vtkhelios.state().picked")
    row = int(picked["values"]["PulseIds"])
    assert picked["coordinates"] == cloud["points"][row].tolist()
    assert abs(picked["values"]["Range"] - cloud["Range"][row]) <= 5.1e-5


def measure(count, folder):
    """One row of the table."""
    cloud = make_cloud(count)
    begin = time.monotonic()
    text = webcloud.make_page(cloud, "benchmark", colour_by="Height")
    making = time.monotonic() - begin
    page = pathlib.Path(folder) / "page.html"
    page.write_text(text)
    browser = Browser(1280, 800)
    begin = time.monotonic()
    browser.open(page)
    browser.wait("window.vtkhelios?.state().points > 0")
    first = time.monotonic() - begin
    browser.wait("vtkhelios.state().isComplete")
    last = time.monotonic() - begin
    check(browser, cloud)
    frames = [
        min(browser.evaluate(f"vtkhelios.time({budget}).ms") for _ in range(REPEATS))
        for budget in ("Infinity", "200000")
    ]
    browser.close()
    return count, making, len(text) / 1e6, first, last, *frames


def main(millions):
    print("   points  page [s]  size [MB]  first [s]  all [s]  frame [ms]  200,000 [ms]")
    with tempfile.TemporaryDirectory() as folder:
        for each in millions:
            row = measure(round(1e6 * each), folder)
            print(
                "{:9,} {:9.1f} {:10.1f} {:10.2f} {:8.2f} {:11.0f} {:13.0f}".format(*row), flush=True
            )


if __name__ == "__main__":
    main([float(word) for word in sys.argv[1:]] or [1.0, 3.0])
