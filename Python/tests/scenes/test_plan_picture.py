# SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
# SPDX-License-Identifier: BSD-3-Clause
"""Pictures of plans: which part of a scene they show, and in which colours."""

import os
import shutil
import subprocess
import sys

import numpy as np
import pytest

from vtkhelios.reports.plan_picture import find_box

BOX = np.array([(-100.0, -50.0, 0.0), (100.0, 50.0, 10.0)])


def test_a_small_plan_is_shown_alone():
    places = np.array([(0.0, 0.0, 0.0), (30.0, 40.0, 9.0)])
    margin = 0.1 * np.linalg.norm(places[1] - places[0])
    low, high = find_box(BOX, places)
    assert np.allclose(low, (-margin, -margin, 0.0)), "within the scene"
    assert np.allclose(high, (30 + margin, 40 + margin, 10.0))


@pytest.mark.parametrize("last", [(121.0, 10.0, 5.0), (10.0, 61.0, 5.0)])
def test_a_plan_of_most_of_the_scene_shows_all_of_it(last):
    assert find_box(BOX, np.array([(0.0, 0.0, 0.0), last])) is BOX


DRAW = """
import numpy as np
from vtkhelios.reports import plan_picture
from vtkhelios.scenes.scene import Scene
square = np.array([(-50, -50, 0), (50, -50, 0), (50, 50, 0), (-50, 50, 0)], float)
scene = Scene(square, [(0, 1, 2), (0, 2, 3)])
x, y = np.meshgrid(np.arange(-9.0, 10, 2), np.arange(-9.0, 10, 2))
points = np.stack([x, y, 0 * x], axis=-1).reshape(-1, 3)
view = plan_picture.View(scene.polydata, (200, 200), 0.0, 89.0)
nearest = view.find_nearest(points, np.tile([0.0, 0.0, 1.0], (len(points), 1)))
places = view.unproject(0.0)[..., :2] + view.origin[:2]
outside = np.maximum(np.abs(places) - 9, 0)
distance = np.hypot(outside[..., 0], outside[..., 1])[nearest != -1]
found = nearest[nearest != -1]
print((distance < 3.5).sum(), (found[distance < 3.5] == -2).sum(),
      (distance > 4.5).sum(), (found[distance > 4.5] >= 0).sum())
colours = np.tile([1.0, 0.0, 0.0], (len(points), 1))
image = view.draw(colours, nearest, points[:1])
red = image[..., 0] > 2 * image[..., 1]
print((red & (nearest < 0)).sum(), (~red & (nearest >= 0)).mean())
"""


def test_what_is_far_from_test_points_is_outside():
    """A plan in the middle of a square: beyond two steps of 2 m there is no colour of a scan."""
    if not shutil.which("xvfb-run"):
        pytest.skip("xvfb-run is missing")
    done = subprocess.run(
        ["xvfb-run", "-a", "-s", "-screen 0 800x600x24", sys.executable, "-c", DRAW],
        env={**os.environ, "PYTHONPATH": ":".join(sys.path)},
        capture_output=True,
        text=True,
        timeout=600,
    )
    assert done.returncode == 0, done.stderr
    near, lost, far, coloured, wrong, missing = map(float, done.stdout.split())
    assert near > 1000 and far > 100
    assert lost == 0 and coloured == 0
    assert wrong < 200 and missing < 0.02, "the mark and its outline"
