# SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
# SPDX-License-Identifier: BSD-3-Clause
"""The study of leaf area: its parts against closed forms, its results against theory."""

import csv
import importlib
import pathlib
import sys

import numpy as np
import pytest

STUDIES = pathlib.Path(__file__).resolve().parents[2] / "studies"


@pytest.fixture
def study(monkeypatch):
    monkeypatch.syspath_prepend(STUDIES)
    return importlib.import_module("leaf_area")


def make_rays(study, count, lengths):
    random = np.random.default_rng(3)
    directions = random.normal(size=(count, 3))
    directions[0] = 0, 1, 0  # along the voxels' faces
    directions[1] = 0, 0, -1
    directions /= np.linalg.norm(directions, axis=1)[:, None]
    origins = random.uniform(-1, 2, (count, 3))
    origins[:2] = (0.25, -1, 0.3), (0.6, 0.55, 4)
    return study.Rays(origins, directions, np.full(count, lengths), np.zeros(count, int))


def test_paths_in_voxels(study):
    grid = study.Grid((0, 0, 0), (1, 1.2, 0.9), 0.3)
    assert tuple(grid.shape) == (4, 4, 3) and grid.volume == pytest.approx(0.25 * 0.3 * 0.3)
    rays = make_rays(study, 200, 3.0)
    steps = (np.arange(20_000) + 0.5) * (3.0 / 20_000)
    points = rays.origins[:, None] + rays.directions[:, None] * steps[:, None]
    voxels = grid.find(points.reshape(-1, 3))
    expected = np.bincount(voxels[voxels >= 0], minlength=grid.count) * (3.0 / 20_000)
    assert np.count_nonzero(expected) > 20
    assert grid.sum_paths(*rays[:3]) == pytest.approx(expected, abs=200 * 3.0 / 20_000 / 2)
    # A ray enters its last voxel before it ends, by less than the diagonal.
    rays = rays._replace(lengths=np.linspace(0.2, 1.5, 200))
    met, voxels = study.find_met(rays, grid)
    gone = rays.lengths[met] - grid.enter(voxels, rays.origins[met], rays.directions[met])
    assert len(met) > 10 and gone.min() >= 0 and gone.max() <= np.linalg.norm(grid.size)


def test_formulas(study):
    radii = np.array([0.0, 0.002, 0.01])
    assert study.find_radius(study.widen(radii)) == pytest.approx(radii)
    # From above: a triangle of area a and outline p, touched by a disc.
    area, rim = study.triangle_area(), 3 * study.EDGE
    assert study.widen(0.001) == pytest.approx(
        1 + (np.pi / 4 * rim * 0.001 + np.pi * 1e-6) / (area / 2), rel=1e-12
    )
    assert study.strong_radius() == pytest.approx(0.3227, abs=5e-4)


def test_derived_density_is_unbiased(study):
    """Exponential path lengths in an opaque medium: no bias for any number of rays."""
    random = np.random.default_rng(0)
    grid = study.Grid((0, 0, 0), (1, 1, 1), 1.0)
    ways = random.exponential(1 / (study.G * 1.7), (20_000, 6))  # six rays per voxel
    counts = np.stack([np.full(20_000, 6.0), ways.sum(axis=1), ways.sum(axis=1)])
    derived = study.derive(counts, grid)
    error = derived.std() / np.sqrt(len(derived))
    assert abs(derived.mean() - 1.7) < 4 * error and error < 0.02
    assert np.isnan(study.derive(np.zeros((3, 1)), grid)).all()


def test_study(study, tmp_path, monkeypatch, capsys):
    pytest.importorskip("matplotlib")
    monkeypatch.setattr(sys, "argv", ["leaf_area.py", str(tmp_path / "out"), "--quick"])
    numbers = study.main()
    assert "true leaf area of the tree: 84.82 m2" in capsys.readouterr().out
    assert numbers["true"] == pytest.approx(
        3 * np.pi / 4 * 6**2, rel=1e-3
    )  # index times ground area
    check_box(study, numbers["box"])
    check_tree(numbers)
    for name in ("leaf_area_box.png", "leaf_area_tree.png"):
        assert (tmp_path / "out" / name).read_bytes()[1:4] == b"PNG"
    with open(tmp_path / "out" / "leaf_area_box.csv", newline="") as file:
        rows = list(csv.DictReader(file))
    assert [float(row["ratio"]) for row in rows] == [row["ratio"] for row in numbers["box"]]


def check_box(study, rows):
    """Where the theory is exact, lines agree within its error, and beams as it widens leaves."""
    lines = [row for row in rows if row["kind"] == "line"]
    assert all(abs(row["z"]) < 3.5 and 0.005 < row["predicted_error"] < 0.02 for row in lines)
    assert len(lines) == 4 and abs(np.mean([row["z"] for row in lines])) < 3 / np.sqrt(4)
    for row in rows:
        if row["kind"] == "beam, strong":
            predicted = study.widen(study.strong_radius() * study.WAIST * row["distance"])
            assert row["ratio"] == pytest.approx(predicted, rel=0.04) and predicted > 1.12
        if row["kind"] == "beam":
            assert 0.9 < row["radius_over_w"] < 1.5  # at most to the edge of the sampled beam


def check_tree(numbers):
    near, far = numbers["places"]
    # From 4 m the top is above the scanner's limit of 60 degrees; from 10 m all is visible.
    assert near["unseen"] > 5 > 0.5 > far["unseen"]
    assert near["error"] < far["error"] < 0
    (beam,) = numbers["beam"]
    assert beam["first"] > beam["strong"] + 10 and beam["strong"] > beam["line"]
    by_cell = {}
    for row in numbers["positions"]:
        by_cell.setdefault(row["cell"], []).append(row)
    coarse, fine = by_cell[100], by_cell[0.5]
    # Clumped leaves: larger voxels give lower densities; more scans do not help.
    assert all(row["error"] < -25 for row in coarse) and all(-9 < row["error"] < 0 for row in fine)
    for rows in (coarse, fine):
        widths = [row["highest"] - row["lowest"] for row in rows]
        assert widths == sorted(widths, reverse=True)
