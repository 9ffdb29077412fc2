# SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
# SPDX-License-Identifier: BSD-3-Clause
"""The study of pebbles: errors of a scanner against exact surfaces and theory."""

import csv

import numpy as np
import pytest
from _programs import load, run_quick

pytest.importorskip("matplotlib")

study = load("pebbles")


@pytest.fixture(scope="module")
def run(tmp_path_factory):
    return run_quick(study, tmp_path_factory)


def test_exact_surface():
    """Rays against ellipsoids: the equation of the surface, its normal, and the triangles."""
    bed = study.PebbleBed(0.2)
    random = np.random.default_rng(5)
    origin = np.array([0.3, -0.9, 1.1])
    targets = np.column_stack([random.uniform(-0.1, 0.1, (2000, 2)), random.uniform(0, 0.02, 2000)])
    directions = targets - origin
    directions /= np.linalg.norm(directions, axis=1)[:, None]
    ranges, owners, cosines = bed.cast(origin, directions)
    points = origin + ranges[:, None] * directions
    for k in range(len(bed)):
        local = (points - bed.centres[k]) @ bed.inverses[k].T
        length = np.linalg.norm(local, axis=1)
        assert np.abs(length[owners == k] - 1).max(initial=0) < 1e-9
        assert (length[owners != k] > 1).all()  # no hit inside another pebble
        normals = local[owners == k] @ bed.inverses[k]
        normals /= np.linalg.norm(normals, axis=1)[:, None]
        expected = -(normals * directions[owners == k]).sum(axis=1)
        assert np.abs(cosines[owners == k] - expected).max(initial=0) < 1e-9
    assert np.abs(points[owners == len(bed), 2]).max() < 1e-12
    assert 0.4 < (owners < len(bed)).mean() < 1

    sphere, faces = study.PebbleBed.make_scene.__globals__["make_sphere"](3)
    assert len(sphere) == 642 and len(faces) == 1280
    edges = np.linalg.norm(sphere[faces] - sphere[np.roll(faces, 1, axis=1)], axis=2)
    middles = np.linalg.norm(sphere[faces].mean(axis=1), axis=1)
    inside = 1 - np.sqrt(1 - edges.max() ** 2 / 3)  # depth of a triangle's centre inside
    assert 0.5 * inside < 1 - middles.min() < 1.001 * inside


def test_range_noise(run):
    """Alone, its RMS is the configured one: chi-square, four standard deviations."""
    ratio, bound = run[0]["noise"]
    count = len(run[0]["columns"]["range"])
    assert bound == pytest.approx(4 / np.sqrt(2 * count)) and count > 20_000
    assert abs(ratio - 1) < bound


def test_errors_by_incidence(run):
    for row in run[0]["incidence"][:8]:  # at grazing incidence beams miss their target
        bound = 4 / np.sqrt(2 * row["echoes"]) * 1.5 + 0.03  # quantiles; and a bin is 10 degrees
        assert row["range noise"] == pytest.approx(row["range_theory"], rel=bound)
        assert row["weak echoes"] == pytest.approx(row["weak_theory"], rel=bound)
        assert row["direction noise"] == pytest.approx(row["direction_theory"], rel=bound)
        assert row["no error"] < 0.05
    assert run[0]["incidence"][7]["weak_theory"] > 3 * study.WEAK_NOISE * 1000


def test_footprint(run):
    """Each beam has the mean range of its exact surface; edges cause the large errors."""
    results = run[0]
    off = results["simulated"] - results["expected"]
    assert np.abs(off).max() < 2e-3 and np.sqrt((off**2).mean()) < 2.5e-4
    assert np.sqrt((results["expected"] ** 2).mean()) > 2e-3
    for row in results["mixed"]:
        expected = row["poisson_theory"]
        assert row["mixed"] == pytest.approx(
            expected, abs=0.05 * expected + 2.5 * np.sqrt(expected / row["echoes"])
        )
        assert row["rms_mixed"] > 20 * row["rms_others"]


def test_grids(run):
    grids = {row["points_of"]: row for row in run[0]["grids"]}
    truth = run[0]["maps"]["truth"]
    assert np.isfinite(truth).all() and truth.min() >= 0 and 0.02 < truth.max() < 0.05
    assert grids["no error"]["rms"] < grids["footprint"]["rms"] < grids["all"]["rms"]
    assert grids["all, 4 positions"]["empty_cells"] < 0.1 < 0.4 < grids["all"]["empty_cells"]
    # A cell on a large pebble has the noise of the mean of its points.
    exact = run[0]["maps"]["no error"]
    assert np.nanmedian(np.abs(exact)) < 5e-4


def test_files(run, read_pixels):
    results, folder = run
    for name in ("ranges", "incidence", "mixed", "grids"):
        with open(folder / f"pebbles_{name}.csv", newline="") as file:
            assert len(list(csv.DictReader(file))) == len(results[name])
    for name in ("errors", "grids"):
        pixels = read_pixels(folder / f"pebbles_{name}.png")
        assert pixels.shape[:2] == (340, 1260) and np.ptp(pixels, axis=(0, 1)).min() > 100
