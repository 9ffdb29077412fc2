# SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
# SPDX-License-Identifier: BSD-3-Clause
"""Estimators of plant area density, against beams that numpy draws and follows."""

import numpy as np
import pytest

import vtkhelios

DENSITY, G = 1.6, 0.5  # [m2/m3]
BOX = (0.0, 4.0, 0.0, 4.0, 0.0, 4.0)
LOW, HIGH = np.zeros(3), np.full(3, 4.0)


def draw_beams(count, seed, density=DENSITY):
    """Beams through a box of leaves: origins, directions, ranges of the hits (inf: none)."""
    random = np.random.default_rng(seed)
    directions = random.normal(size=(count, 3))
    directions /= np.linalg.norm(directions, axis=1)[:, None]
    # All around: the beams pass random points of the box, from 10 m before them.
    origins = random.uniform(LOW, HIGH, (count, 3)) - 10.0 * directions
    a, b = (LOW - origins) / directions, (HIGH - origins) / directions
    enter = np.minimum(a, b).max(axis=1)
    leave = np.maximum(a, b).min(axis=1)
    ranges = enter + random.exponential(1 / (G * density), count)
    return origins, directions, np.where(ranges < leave, ranges, np.inf)


def make_cloud(origins, directions, ranges, **columns):
    ids = np.arange(len(ranges))
    hit = np.isfinite(ranges)
    points = origins[hit] + ranges[hit, None] * directions[hit]
    cloud = vtkhelios.Cloud.from_arrays(points, PulseIds=ids[hit], **columns)
    cloud.pulses = vtkhelios.Cloud.from_arrays(origins, Direction=directions, PulseIds=ids)
    return cloud


def estimate(beams, voxel=1.0, **options):
    return make_cloud(*beams).plant_area(voxel=voxel, bounds=BOX, **options)


@pytest.mark.parametrize(
    "estimator", ["beer-lambert-corrected", "maximum-likelihood", "maximum-likelihood-corrected"]
)
def test_errors_are_those_stated(estimator):
    """Deviations over the standard errors, of 40 scans of 64 voxels, have the mean 0 and deviation 1."""
    z = []
    for seed in range(40):
        found = estimate(draw_beams(3000, seed), estimator=estimator)
        z.append((found.pad - DENSITY) / found["DensityError"])
    z = np.array(z)
    assert np.isfinite(z).all()
    assert 0.9 < np.std(z) < 1.15
    assert abs(z.mean()) < 0.15


def test_few_beams_bias_the_likelihood_and_the_correction_removes_it():
    """With two beams or so a voxel: the mean of many voxels, weighted equally."""
    means = {}
    for estimator in ("maximum-likelihood", "maximum-likelihood-corrected"):
        pads = [
            estimate(draw_beams(250, seed), estimator=estimator, minimum_beams=0.5).pad
            for seed in range(60)
        ]
        means[estimator] = np.nanmean(pads) / DENSITY
    assert means["maximum-likelihood"] > 1.10
    assert abs(means["maximum-likelihood-corrected"] - 1) < 0.5 * (means["maximum-likelihood"] - 1)


def test_contact_frequency_has_the_bias_of_its_formula():
    """(1 - exp(-u g)) / (u g) of parallel beams with the chord of a voxel."""
    random = np.random.default_rng(0)
    count = 40_000
    origins = np.column_stack([np.full(count, -1.0), *random.uniform(0, 4, (2, count))])
    directions = np.repeat([[1.0, 0.0, 0.0]], count, axis=0)
    ranges = 1 + random.exponential(1 / (G * DENSITY), count)
    ranges[ranges > 5] = np.inf
    beams = origins, directions, ranges
    depth = G * DENSITY
    found = estimate(beams, estimator="contact-frequency")
    expected = DENSITY * (1 - np.exp(-depth)) / depth
    assert np.nanmean(found.pad[0]) == pytest.approx(expected, rel=0.015)
    beer = estimate(beams, estimator="beer-lambert")
    assert np.nanmean(beer.pad[0]) == pytest.approx(DENSITY, rel=0.015)


def test_unequal_chords_bias_beer_and_lambert_and_the_correction_removes_most():
    beams = draw_beams(60_000, 5, density=4.0)
    raw = np.nanmean(estimate(beams, voxel=2.0, estimator="beer-lambert").pad) / 4.0
    corrected = np.nanmean(estimate(beams, voxel=2.0, estimator="beer-lambert-corrected").pad) / 4.0
    assert raw < 0.85
    assert abs(corrected - 1) < 0.6 * abs(raw - 1)
    likely = estimate(beams, voxel=2.0)
    assert np.nansum(likely.pad * 8) == pytest.approx(4.0 * 64, abs=4 * likely.area_error)


def test_paths_are_those_of_another_program(monkeypatch, request):
    """The free paths in all voxels, by the traversal of the study in numpy."""
    monkeypatch.syspath_prepend(request.config.rootpath / "Python/studies")
    from _voxels import Grid

    origins, directions, ranges = draw_beams(2000, 8)
    found = estimate((origins, directions, ranges), voxel=0.5)
    grid = Grid((0, 0, 0), (4, 4, 4), 0.5)
    expected = grid.sum_paths(origins, directions, ranges).reshape(grid.shape)
    assert found["PathLength"] == pytest.approx(expected, abs=1e-6)


def test_leaves_of_other_angles():
    """Horizontal leaves and vertical beams: G is 1."""
    random = np.random.default_rng(2)
    count = 5000
    origins = np.column_stack([*random.uniform(0, 4, (2, count)), np.full(count, 9.0)])
    directions = np.repeat([[0.0, 0.0, -1.0]], count, axis=0)
    ranges = 5 + random.exponential(1 / DENSITY, count)
    ranges[ranges > 9] = np.inf
    cloud = make_cloud(origins, directions, ranges)
    for angles in ("horizontal", [[0, 0, 1, 1.0], [1, 0, 0, 0.0]]):
        found = cloud.plant_area(voxel=2.0, bounds=BOX, leaf_angles=angles)
        assert found.area == pytest.approx(DENSITY * 64, abs=4 * found.area_error)
    ellipsoid = cloud.plant_area(voxel=2.0, bounds=BOX, leaf_angles="ellipsoidal", leaf_ratio=100.0)
    assert ellipsoid.area == pytest.approx(found.area, rel=0.01)


def test_angles_of_incidence_weigh_hits():
    """Leaves of random orientation: each hit counts 1 / |cos|, whose density is 2 cos."""
    random = np.random.default_rng(3)
    beams = draw_beams(40_000, 3)
    cosines = np.sqrt(random.uniform(0, 1, np.isfinite(beams[2]).sum()))
    cloud = make_cloud(*beams, IncidenceAngle=np.degrees(np.arccos(cosines)))
    found = cloud.plant_area(voxel=4.0, bounds=BOX, leaf_angles="incidence")
    # Angles whose cosine is below 0.02 weigh 50: the mean is 1 % lower.
    assert found.area == pytest.approx(0.99 * DENSITY * 64, rel=0.03)


def test_options_outside_their_range_are_errors():
    cloud = make_cloud(*draw_beams(10, 0))
    for options, words in (
        (dict(voxel=0), "voxel is 0; give a number from 0.001 to 10000"),
        (dict(estimator="likelihood"), "estimator is 'likelihood'; "),
        (dict(leaf_angles="spheric"), "did you mean spherical?"),
        (dict(leaf_angles="table"), "give its rows x y z G"),
        (dict(leaf_angles=[1, 2]), "give a name, or rows x y z G"),
        (dict(bounds=(0, 1, 0, 1, 1, 0)), "each rising"),
        (dict(shares="none"), "shares is 'none'"),
        (dict(minimum_beams=0), "minimum_beams is 0"),
        (dict(voxels=3), "unexpected keyword argument 'voxels'"),
        (dict(materials=["leaf"]), "has no material leaf; it has: no names"),
        (dict(classes=[4]), "no echo is of a plant that is counted"),
        (dict(voxel=0.001, bounds=(0, 10, 0, 10, 0, 10)), "more than 100 million"),
        (dict(estimator="beer-lambert", leaf_angles="incidence"), "maximum likelihood"),
    ):
        with pytest.raises(ValueError) as caught:
            cloud.plant_area(**options)
        assert words in str(caught.value), options
