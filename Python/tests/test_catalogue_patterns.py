# SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
# SPDX-License-Identifier: BSD-3-Clause
"""Instruments of the catalogue in a closed room, against the figures of their sheets."""

import itertools

import numpy as np
import pytest

import vtkhelios

# Scanner: points/s, elevation min and max [deg] of the sheet, columns in 0.1 s at 10 revolutions/s.
SPINNING = {
    "velodyne_vlp16": (300_000, -15, 15, 1809),
    "velodyne_hdl32e": (700_000, -30.67, 10.67, 2171),
    "hesai_xt32": (640_000, -16, 15, 2000),
}

# Scanner: points/s, width and height of the field of view [deg] of the manual.
LIVOX = {
    "livox_mid40": (100_000, 38.4, 38.4),
    "livox_mid70": (100_000, 70.4, 70.4),
    "livox_avia": (240_000, 70.4, 77.2),
}


@pytest.fixture(scope="module")
def room():
    """A cube of 40 m around the scanner."""
    corners = 20.0 * np.array(list(itertools.product((-1, 1), repeat=3)))
    quads = [(0, 1, 3, 2), (4, 5, 7, 6), (0, 1, 5, 4), (2, 3, 7, 6), (0, 2, 6, 4), (1, 3, 7, 5)]
    triangles = [t for a, b, c, d in quads for t in ((a, b, c), (a, c, d))]
    return vtkhelios.Scene(corners, triangles)


def fly(room, scanner, duration, **settings):
    options = dict(noise=False, pulses=True, beam_divergence=0)
    return vtkhelios.scan(
        room, (0, 0, 0), scanner=scanner, duration=duration, **options, **settings
    )


def angles_of(pulses):
    """Azimuth, anticlockwise from y, and elevation [deg]."""
    x, y, z = pulses["Direction"].T
    return np.degrees(np.arctan2(-x, y)), np.degrees(np.arcsin(z))


@pytest.mark.parametrize("scanner", SPINNING)
def test_spinning_heads(room, scanner):
    rate, low, high, columns = SPINNING[scanner]
    cloud = fly(room, scanner, 0.1, scan_frequency=10, columns=True)
    pulses = cloud.pulses
    assert len(cloud) == len(pulses) == pytest.approx(0.1 * rate, rel=0.04)
    azimuths, elevations = angles_of(pulses)
    assert [elevations.min(), elevations.max()] == pytest.approx([low, high], abs=1e-9)
    steps = np.diff(np.unwrap(azimuths[pulses["ChannelIds"] == 3], period=360))
    assert steps == pytest.approx(-360 / (pulses["ColumnIds"].max() + 1), rel=2e-3)  # clockwise
    assert len(set(pulses["ColumnIds"])) == columns
    pixels = set(zip(pulses["ChannelIds"], pulses["ColumnIds"]))
    assert len(pixels) == len(pulses)


def test_origins_of_the_vlp16(room):
    pulses = fly(room, "velodyne_vlp16", 0.001, scan_frequency=10).pulses
    heights = pulses.points[:, 2] - 1.5 - 0.0377
    beams = pulses["ChannelIds"]
    assert heights[beams == 0] == pytest.approx(0.0112) and set(pulses.points[:, 0]) == {0}
    # The beams cross near the axis: a low one starts high.
    assert np.corrcoef(heights, angles_of(pulses)[1])[0, 1] < -0.999


@pytest.mark.parametrize("scanner", LIVOX)
def test_livox(room, scanner):
    rate, width, height = LIVOX[scanner]
    cloud = fly(room, scanner, 1.0)
    assert len(cloud) == len(cloud.pulses) == rate
    azimuths, elevations = angles_of(cloud.pulses)
    assert np.ptp(azimuths) == pytest.approx(width, abs=0.3)
    assert np.ptp(elevations) == pytest.approx(height, abs=0.3)
