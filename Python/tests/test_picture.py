# SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
# SPDX-License-Identifier: BSD-3-Clause
"""Pictures of clouds, with a virtual display and without."""

import os
import subprocess
import sys
import time

import numpy as np
import pytest

from vtkhelios.reports import picture


@pytest.fixture
def cloud(tmp_path):
    """A tilted plane with a red roof at the centre, in the format of a run."""
    x, y = (axis.ravel() for axis in np.meshgrid(np.linspace(-5, 5, 150), np.linspace(-5, 5, 150)))
    roof = (abs(x) < 2) & (abs(y) < 2)
    rows = np.zeros((len(x), 11))
    rows[:, 0], rows[:, 1], rows[:, 2] = x + 500000, y + 5500000, 0.1 * x + 2 * roof
    rows[:, 3] = 1.0
    rows[:, 9] = np.where(roof, 6, 2)
    np.savetxt(tmp_path / "leg000_points.xyz", rows, fmt="%.4f")
    (tmp_path / "leg000_trajectory.txt").write_text("500000 5500000 4 0 0 0 0\n")
    return tmp_path / "leg000_points.xyz"


def draw(*arguments, path=os.environ["PATH"]):
    """Runs the program without an X display; path is searched for Xvfb."""
    environment = {key: value for key, value in os.environ.items() if key != "DISPLAY"}
    return subprocess.run(
        [sys.executable, "-P", "-m", "vtkhelios.picture", *map(str, arguments)],
        env={**environment, "PYTHONPATH": ":".join(sys.path), "PATH": str(path)},
        capture_output=True,
        text=True,
        timeout=120,
    )


def test_picture(cloud, tmp_path, read_pixels):
    done = draw(cloud, "--output", tmp_path / "p.png", "--title", "a roof")
    assert done.returncode == 0, done.stderr
    pixels = read_pixels(tmp_path / "p.png")
    assert pixels.shape == (1000, 1600, 3)
    reddish = (pixels[..., 0] > 120) & (pixels[..., 0] > 1.5 * pixels[..., 2])
    rows, columns = np.nonzero(reddish)
    assert reddish.mean() > 0.01
    assert (
        abs(columns.mean() - 800) < 100 and abs(rows.mean() - 500) < 150
    )  # the roof at the centre


def test_no_display_and_no_xvfb_is_an_error(cloud, tmp_path):
    done = draw(cloud, "--output", tmp_path / "p.png", path=tmp_path)
    assert done.returncode == 1
    message = "error: no X display, and no Xvfb for a virtual one: apt-get install xvfb\n"
    assert done.stderr == message
    assert not (tmp_path / "p.png").exists()


def test_the_virtual_display_ends(cloud, tmp_path):
    before = running()
    done = draw(cloud, "--output", tmp_path / "p.png")
    assert done.returncode == 0, done.stderr
    end = time.monotonic() + 30
    while running() - before and time.monotonic() < end:
        time.sleep(0.05)
    assert not running() - before


def running():
    """The processes of Xvfb that picture.py started."""
    found = subprocess.run(
        ["pgrep", "-f", "Xvfb -displayfd .* -terminate"], capture_output=True, text=True
    )
    return set(found.stdout.split())


def test_damaged_cloud_is_an_error(tmp_path, capsys):
    (tmp_path / "a.xyz").write_text("1 2 x\n")
    assert picture.main([str(tmp_path / "a.xyz")]) == 1
    assert 'a.xyz:1: "x" in column 3 (z) is not a number' in capsys.readouterr().err


def test_reads_files_of_a_run(cloud):
    points, strengths, classes = picture.read_cloud(cloud)
    assert points.shape == (22500, 3) and set(classes) == {2, 6}
    assert picture.find_marks(cloud)[0].tolist() == [500000.0, 5500000.0, 4.0]


def test_reads_points_without_arrays(tmp_path):
    (tmp_path / "a.xyz").write_text("1 2 3\n4 5 6\n")
    points, strengths, classes = picture.read_cloud(tmp_path / "a.xyz")
    assert points.tolist() == [[1, 2, 3], [4, 5, 6]]
    assert strengths.tolist() == [0, 0] and classes.tolist() == [0, 0]


def test_colours_by_class_and_by_height():
    points = np.array([[0.0, 0.0, z] for z in range(100)])
    strengths = np.ones(100)
    classes = np.where(np.arange(100) < 50, 2, 6)
    by_class = picture.colours(points, strengths, classes)
    assert len(np.unique(by_class, axis=0)) == 2
    by_height = picture.colours(points, strengths, np.zeros(100, int))
    assert (
        by_height[0][2] > by_height[0][0] and by_height[-1][0] > by_height[-1][2]
    )  # blue below, red above
    assert by_height.min() >= 0 and by_height.max() <= 1
