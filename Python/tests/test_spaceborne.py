# SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
# SPDX-License-Identifier: BSD-3-Clause
"""GEDI and ICESat-2: tracks, energies and counts from orbit; a stand in wide footprints."""

import math

import numpy as np
import pytest

import vtkhelios

from vtkhelios.array_names import (
    AMPLITUDE, CHANNEL_IDS, COUNT, ECHO_WIDTH, GPS_TIME, OFFSET, PULSE_IDS, RANGE, SAMPLES,
    START_TIME,
)  # fmt: skip

LIGHT = 299792458.0
GEDI, ATLAS = 410e3, 496e3  # heights [m]


def plane(half=1e4, slope=0.0, reflectance=0.5):
    corners = [
        (x, y, slope * x) for x, y in ((-half, -half), (half, -half), (half, half), (-half, half))
    ]
    return vtkhelios.Scene(corners, [(0, 1, 2), (0, 2, 3)], reflectance=reflectance)


def fly(scene, scanner, height, length=200.0, x=0.0, speed=7260.0, **options):
    path = [(x, -0.5 * length, height), (x, 0.5 * length, height)]
    platform = "airplane_linearpath"
    return vtkhelios.scan(
        scene, scanner=scanner, path=path, speed=speed, platform=platform, **options
    )


@pytest.fixture(scope="module")
def gedi_plane():
    return fly(plane(), "gedi", GEDI, waveforms=True, noise=False)


def test_gedi_has_eight_tracks(gedi_plane):
    """600 m apart, four beams that alternate between two tracks, footprints 60 m apart."""
    across = np.round(gedi_plane.points[:, 0] / 600.0 - 0.5)
    assert np.unique(across).tolist() == [-4, -3, -2, -1, 0, 1, 2, 3]
    expected = 600.0 * (across + 0.5)
    assert np.abs(gedi_plane.points[:, 0] - expected).max() < 1.0
    for track in np.unique(across):
        on_track = across == track
        assert len(np.unique(gedi_plane[CHANNEL_IDS][on_track])) == 1
        assert np.diff(gedi_plane.points[on_track, 1]) == pytest.approx(60.0, abs=0.1)


def test_ranges_from_orbit_keep_their_precision(gedi_plane):
    """A footprint with the variance s2 across each axis is s2 / R deeper than its centre."""
    depth = 5.5**2 / GEDI
    nearly = np.abs(gedi_plane.points[:, 0]) < 400.0
    assert gedi_plane.points[nearly, 2] == pytest.approx(-depth, abs=1e-5)
    beams = gedi_plane.points - np.c_[np.zeros(len(gedi_plane)), gedi_plane.points[:, 1],
                                      np.full(len(gedi_plane), GEDI)]  # fmt: skip
    assert gedi_plane[RANGE] == pytest.approx(np.linalg.norm(beams, axis=1), abs=1e-7)


def test_energies_are_those_of_the_lidar_equation(gedi_plane):
    """Coverage beams have 45 % of the energy; amplitudes are those of the equation, two-way."""
    half = gedi_plane[AMPLITUDE] * 4.0 * gedi_plane[RANGE] ** 2 / (0.5 * 0.8**2 * 0.5 * 0.8)
    strong = gedi_plane[CHANNEL_IDS] >= 2
    assert half[strong] == pytest.approx(602e3, rel=0.01)
    assert half[~strong] == pytest.approx(271e3, rel=0.01)
    assert gedi_plane[ECHO_WIDTH] == pytest.approx(15.6, rel=0.01)


def test_slopes_widen_the_pulse_by_the_footprint():
    """A slope of 30 % over a footprint of 5.5 m: 11 ns more, as standard deviations (Gardner 1982)."""
    slope = 0.3
    cloud = fly(plane(slope=slope), "gedi", GEDI, noise=False)
    x, down = cloud.points[:, 0], GEDI - cloud.points[:, 2]
    incidence = math.atan(slope) - np.arctan2(x, down)
    depths = 5.5 * cloud[RANGE] / GEDI * np.tan(incidence)
    sigma = np.hypot(15.6 / 2.3548, 2e9 * depths / LIGHT)
    assert cloud[ECHO_WIDTH] == pytest.approx(2.3548 * sigma, rel=2e-3)


def test_waveforms_have_bins_of_one_nanosecond_and_at_most_1420():
    tower = vtkhelios.Scene(
        [(-1e4, -1e4, 0), (1e4, -1e4, 0), (0, 2e4, 0), (0, -1e4, 230), (1e4, 0, 230), (0, 1e4, 230)],
        [(0, 1, 2), (3, 4, 5)],
    )  # fmt: skip
    with pytest.warns(RuntimeWarning, match="truncated"):
        cloud = fly(tower, "gedi", GEDI, x=-300.0, waveforms=True, noise=False, length=120.0)
    table = vtkhelios.arrays(cloud.waveforms)
    assert np.all(table["BinSize"] == 1.0) and table[COUNT].max() == 1420


def test_waveforms_are_at_the_times_of_their_ranges(gedi_plane):
    table = vtkhelios.arrays(gedi_plane.waveforms)
    for row, offset in enumerate(table[OFFSET]):
        samples = table[SAMPLES][offset : offset + table[COUNT][row]]
        peak = table[START_TIME][row] + samples.argmax()
        assert peak == pytest.approx(2e9 * gedi_plane[RANGE][row] / LIGHT, abs=0.51)


def test_icesat_has_three_pairs():
    """Pairs 3.3 km apart, beams 90 m apart and 2.5 km along the track, footprints 0.7 m apart."""
    scene = plane(reflectance=0.9)
    cloud = fly(scene, "icesat2_atlas", ATLAS, length=70.0, speed=7000.0, noise=False)
    beams = [cloud.points[cloud[CHANNEL_IDS] == k] for k in range(6)]
    across = np.array([each[:, 0].mean() for each in beams])
    along = np.array([each[:, 1].mean() for each in beams])
    assert np.diff(across) == pytest.approx([90, 3210, 90, 3210, 90], abs=2)
    assert np.abs(np.diff(along)) == pytest.approx([2500] * 5, abs=5)
    first = np.unique(cloud[GPS_TIME][cloud[CHANNEL_IDS] == 0])
    assert np.diff(first).min() == pytest.approx(1e-4, abs=1e-9)


def test_photons_are_counted_as_the_lidar_equation_says():
    """Mean counts of strong and weak beams on a plane of reflectance 0.1, less those of dead times."""
    cloud = fly(plane(reflectance=0.1), "icesat2_atlas", ATLAS, length=1400.0, speed=7000.0,
                noise=False, pulses=True)  # fmt: skip
    planck, transmission = 6.62607015e-34 * LIGHT / 532e-9, 0.6 * 0.42 * 0.15
    for channel, energy, dead in ((0, 175e-6, 0.2), (1, 45e-6, 0.8)):
        mean = energy * 0.1 * 0.8**2 / (4.0 * ATLAS**2) * transmission / planck
        pulses = np.count_nonzero(cloud.pulses[CHANNEL_IDS] == channel)
        found = np.count_nonzero(cloud[CHANNEL_IDS] == channel) / pulses
        blind = mean**2 * dead / (2.0 * math.sqrt(math.pi) * 1.5 / 2.3548)  # pairs within it
        assert found == pytest.approx(
            mean - blind, abs=4.0 * math.sqrt(mean / pulses) + 0.02 * mean
        )
        seen = len(np.unique(cloud[PULSE_IDS][cloud[CHANNEL_IDS] == channel])) / pulses
        assert seen == pytest.approx(1.0 - math.exp(-mean), abs=4.0 * math.sqrt(0.25 / pulses))
