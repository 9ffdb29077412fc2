# SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
# SPDX-License-Identifier: BSD-3-Clause
"""The window of a flight plan: lines and predicted density over the scene."""

import pytest
from _viewer_window import close_all, display, needs_window, opened  # noqa: F401

from vtkhelios.cli import main

pytestmark = needs_window
GROUND = "v -50 -50 0\nv 150 -50 0\nv 150 150 0\nv -50 150 0\nf 1 2 3 4\n"


@pytest.fixture
def window(display, tmp_path, monkeypatch):
    monkeypatch.chdir(tmp_path)
    (tmp_path / "ground.obj").write_text(GROUND)
    flight = ["--als", "--scanner", "copter_uls", "--flying-height", "50", "--density", "6"]
    assert main(["plan", "ground.obj", *flight, "--quiet"]) == 0
    open_one, windows = opened(display, tmp_path)
    yield open_one(tmp_path / "output/ground_als")
    close_all(windows)


def test_a_flight_plan_is_shown_over_its_scene(window):
    plan = window.wait(lambda state: "plan" in state)["plan"]
    assert plan["visible"] and plan["lines"] >= 2 and plan["gaps"] == 0
    assert plan["cells"] > 1000 and plan["meanDensity"] > 6
    window.key("j")
    window.wait(lambda state: not state["plan"]["visible"])
    assert window.close() == 0
