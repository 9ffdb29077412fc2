# SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
# SPDX-License-Identifier: BSD-3-Clause
"""Every scanner of the catalogue, flown once: its rate, field, steps, swath and line spacing.

The truth is geometry (swath = 2 h tan(field / 2)) and the published figures of RATES and SWATHS.
"""

import math

import numpy as np
import pytest

import vtkhelios
from vtkhelios.array_names import CHANNEL_IDS, DIRECTION, SCAN_ANGLE
from vtkhelios.catalogue import find_scanners

SCANNERS = {each.id: each for each in find_scanners()
            if each.optics not in ("risley", "spinning") and each.use != "spaceborne"}  # fmt: skip
LINES = 3  # scan lines or revolutions of a flight
HEIGHTS = {"airborne": 500.0, "unmanned": 50.0, "mobile": 10.0}  # [m]
SPEEDS = {"airborne": 60.0, "unmanned": 8.0, "mobile": 10.0}  # [m/s]
WIDE = 60.0  # the half angle up to which the ground is looked at [deg]

# Published figures: pulse frequency of a channel, measurements per second of all channels [Hz].
RATES = [
    ("riegl_vz400", 100e3, 42e3),
    ("riegl_vz400", 300e3, 122e3),
    ("riegl_vz400i", 100e3, 42e3),
    ("riegl_vz400i", 300e3, 125e3),
    ("riegl_vz400i", 600e3, 250e3),
    ("riegl_vz400i", 1200e3, 500e3),
    ("riegl_vz1000", 70e3, 29e3),
    ("riegl_vz1000", 100e3, 42e3),
    ("riegl_vz1000", 150e3, 62e3),
    ("riegl_vz1000", 300e3, 122e3),
    ("riegl_vz2000i", 1200e3, 500e3),
    ("riegl_vz4000", 50e3, 37e3),
    ("riegl_vz4000", 300e3, 222e3),
    ("riegl_vz6000", 300e3, 222e3),
    ("riegl_vux1uav", 550e3, 500e3),
    ("riegl_vux1ha", 1000e3, 1000e3),
    ("riegl_vux1lr", 820e3, 750e3),
    ("riegl_vux240", 1800e3, 1500e3),
    ("riegl_vq480i", 550e3, 275e3),
    ("riegl_vq580", 380e3, 190e3),
    ("riegl_vq580ii", 2000e3, 1250e3),
    ("riegl_vq780i", 1000e3, 666e3),
    ("riegl_vq780ii", 2000e3, 1330e3),
    ("riegl_vq1560i", 1000e3, 1330e3),
    ("riegl_vq1560ii", 2000e3, 2660e3),
    ("riegl_lmsq560", 240e3, 160e3),
    ("riegl_lmsq680i", 400e3, 266e3),
    ("riegl_lmsq780", 400e3, 266e3),
    ("optech_titan", 300e3, 900e3),
]

# Published swaths [m] from a height [m].
SWATHS = {"nasa_atm_t6": (450.0, 245.0), "nasa_atm_t7": (450.0, 40.0), "nasa_lvis": (10e3, 1000.0)}

# Published fields across the flight where the planes of the channels are turned [deg].
ACROSS = {"riegl_vq1560i": 58.0, "riegl_vq1560ii": 58.0}


def half_angle(scanner):
    return 0.5 * scanner.field_of_view


def scan_frequency(scanner, pulse_frequency):
    """The highest at which the whole field is scanned [Hz]."""
    if scanner.optics == "line":
        return pulse_frequency / scanner.numbers["numFibers"]
    highest = scanner.numbers["scanFreqMax_Hz"]
    most = scanner.numbers.get("scanProduct", math.inf) / half_angle(scanner)
    return min(highest, 0.999999 * most)  # not clipped by a last digit


def fly(scanner, pulse_frequency=None, height=None):
    """A short flight over, or a scan on, a plane at height 0; a Cloud with its pulses, and settings."""
    pulse_frequency = pulse_frequency or scanner.pulse_frequencies[-1]
    frequency = scan_frequency(scanner, pulse_frequency)
    height = height or max(HEIGHTS.get(scanner.use, 2.0), 1.5 * scanner.numbers["rangeMin_m"])
    settings = {"pulse_frequency": pulse_frequency, "duration": LINES / frequency}
    if scanner.optics != "line":
        settings["scan_frequency"] = frequency
    if scanner.optics != "rotating":
        settings["scan_angle"] = half_angle(scanner)
    if scanner.use == "terrestrial":
        speed = scanner.numbers["headRotatePerSecMax_deg"]
        settings.update(position=(0, 0, height), head=(0, 360), head_speed=speed)
    else:
        speed = SPEEDS[scanner.use]
        settings.update(path=[(0, 0, height), (0, 100, height)], speed=speed)
        settings["platform"] = "airplane_linearpath"
    side = 4.0 * height + 100.0
    corners = [(-side, -side, 0), (side, -side, 0), (side, side, 0), (-side, side, 0)]
    plane = vtkhelios.Scene(corners, [(0, 1, 2), (0, 2, 3)])
    cloud = vtkhelios.scan(
        plane, scanner=scanner.id, noise=False, sub_rays=1, pulses=True, **settings
    )
    return cloud, frequency, height, speed


def first_channel(cloud, name):
    return cloud[name][cloud[CHANNEL_IDS] == 0] if CHANNEL_IDS in cloud else cloud[name]


def expected_rate(scanner, pulse_frequency):
    """Pulses per second of all channels that are emitted [Hz]."""
    share = 1.0
    if scanner.optics == "rotating":
        share = half_angle(scanner) / scanner.numbers["scanAngleMax_deg"]
    return scanner.channels * pulse_frequency * share


def expected_step(scanner, frequency):
    """The largest angle between successive pulses of a line [deg]."""
    pulse_frequency = scanner.pulse_frequencies[-1]
    half = half_angle(scanner)
    if scanner.optics == "line":
        return 2.0 * half / (scanner.numbers["numFibers"] - 1)
    if scanner.optics == "oscillating":
        return (
            half * frequency / pulse_frequency * {"sine": 2.0 * math.pi}.get(pattern(scanner), 4.0)
        )
    return 2.0 * scanner.numbers["scanAngleMax_deg"] * frequency / pulse_frequency


def pattern(scanner):
    return "sine" if scanner.maker == "Leica" else "triangle"


@pytest.mark.parametrize("name", SCANNERS)
def test_flight(name):
    scanner = SCANNERS[name]
    cloud, frequency, height, speed = fly(scanner)
    check_rate(scanner, cloud, frequency)
    check_angles(scanner, cloud, frequency)
    if scanner.use == "terrestrial":
        check_blind_cone(scanner, cloud)
    else:
        check_swath(scanner, cloud, height)
    if scanner.use != "terrestrial" and scanner.optics in ("rotating", "oscillating", "line"):
        check_lines(cloud, speed / frequency)


def check_rate(scanner, cloud, frequency):
    expected = expected_rate(scanner, scanner.pulse_frequencies[-1]) * LINES / frequency
    assert len(cloud.pulses) == pytest.approx(expected, abs=2 * LINES * scanner.channels)


def check_angles(scanner, cloud, frequency):
    angles = first_channel(cloud.pulses, SCAN_ANGLE)
    if scanner.optics in ("conic", "palmer"):
        assert angles.max() == pytest.approx(half_angle(scanner), rel=1e-3)
        return
    steps = np.abs(np.diff(angles))
    step = expected_step(scanner, frequency)
    within = steps[steps < 1.5 * step]  # not between lines
    assert within.max() == pytest.approx(step, rel=1e-3)
    assert np.ptp(angles) == pytest.approx(scanner.field_of_view, abs=2 * step)


def check_blind_cone(scanner, cloud):
    """The field of a dome is about the zenith, of the others about the horizon."""
    up = cloud.pulses[DIRECTION][:, 2]
    half = half_angle(scanner)
    if half > 90.0:  # from the zenith
        assert math.degrees(math.acos(up.min())) == pytest.approx(half, abs=0.2)
        assert up.max() == pytest.approx(1.0, abs=1e-4)
    else:
        assert math.degrees(math.asin(up.max())) == pytest.approx(half, abs=0.2)


def across(scanner):
    """The whole field across the flight [deg]."""
    return ACROSS.get(scanner.id, scanner.field_of_view)


def check_swath(scanner, cloud, height):
    half = 0.5 * across(scanner)
    x = cloud.points[:, 0]
    if half > WIDE:
        direction = first_channel(cloud.pulses, DIRECTION)
        angles = np.degrees(np.arctan2(direction[:, 0], -direction[:, 2]))
        assert np.ptp(angles) == pytest.approx(2 * half, abs=0.5)
        x, half = x[np.abs(x) < height * math.tan(math.radians(WIDE))], WIDE
    assert np.ptp(x) == pytest.approx(2 * height * math.tan(math.radians(half)), rel=0.03)
    assert x.min() == pytest.approx(-x.max(), rel=0.03)


def check_lines(cloud, spacing):
    """The distance of places where lines cross nadir, from the same side."""
    angles = first_channel(cloud, SCAN_ANGLE)
    y = cloud.points[:, 1]
    y = y[cloud[CHANNEL_IDS] == 0] if CHANNEL_IDS in cloud else y
    crossings = np.nonzero((angles[:-1] < 0) & (angles[1:] >= 0))[0]
    assert len(crossings) >= LINES - 1
    before, after = angles[crossings], angles[crossings + 1]
    share = before / (before - after)  # share of the way to the next echo, at angle 0
    at_nadir = (1 - share) * y[crossings] + share * y[crossings + 1]
    assert np.diff(at_nadir) == pytest.approx(spacing, rel=0.02)


@pytest.mark.parametrize("name, pulse_frequency, rate", RATES)
def test_published_rate(name, pulse_frequency, rate):
    scanner = SCANNERS[name]
    assert pulse_frequency in scanner.pulse_frequencies
    cloud, frequency, *_ = fly(scanner, pulse_frequency)
    measured = len(cloud.pulses) * frequency / LINES
    assert measured == pytest.approx(rate, rel=0.03, abs=2 * frequency)


@pytest.mark.parametrize("name", SWATHS)
def test_published_swath(name):
    height, swath = SWATHS[name]
    cloud, *_ = fly(SCANNERS[name], height=height)
    assert np.ptp(cloud.points[:, 0]) == pytest.approx(swath, rel=0.025)


def test_crossed_planes():
    """VQ-1560i: the sheet has 8 degrees forward and backward at the ends of the lines."""
    cloud, *_ = fly(SCANNERS["riegl_vq1560i"])
    direction = cloud.pulses[DIRECTION]
    along = np.degrees(np.arctan2(direction[:, 1], -direction[:, 2]))
    assert along.max() == pytest.approx(8.0, abs=0.3)
    assert along.min() == pytest.approx(-8.0, abs=0.3)


def test_nutating_mirror():
    """VQ-840-GL: 20 degrees across the flight and 14 along it, on either side."""
    cloud, *_ = fly(SCANNERS["riegl_vq840gl"])
    direction = cloud.pulses[DIRECTION]
    for axis, angle in ((0, 20.0), (1, 14.0)):
        angles = np.degrees(np.arctan2(direction[:, axis], -direction[:, 2]))
        assert np.ptp(angles) == pytest.approx(2 * angle, rel=0.03)


def test_channels_look_forward():
    """Titan: 1550 nm looks 3.5 degrees forward, 1064 nm to nadir, 532 nm 7 degrees forward."""
    cloud, *_ = fly(SCANNERS["optech_titan"])
    direction, channel = cloud.pulses[DIRECTION], cloud.pulses[CHANNEL_IDS]
    for number, angle in enumerate((3.5, 0.0, 7.0)):
        own = direction[channel == number]
        nadir = own[np.abs(own[:, 0]).argmin()]
        assert math.degrees(math.atan2(nadir[1], -nadir[2])) == pytest.approx(angle, abs=0.02)


def test_fast_mirrors_scan_less():
    """The scan product: Titan scans 2 times 800 / 210 degrees at 210 Hz."""
    settings = dict(scan_frequency=210, scan_angle=30, pulse_frequency=300e3, duration=0.02)
    plane = vtkhelios.Scene([(-1e3, -1e3, 0), (1e3, -1e3, 0), (0, 1e3, 0)], [(0, 1, 2)])
    with pytest.warns(RuntimeWarning, match="scanProduct"):
        cloud = vtkhelios.scan(
            plane, path=[(0, 0, 500), (0, 9, 500)], scanner="optech_titan", speed=60,
            platform="airplane_linearpath", noise=False, sub_rays=1, pulses=True, **settings,
        )  # fmt: skip
    assert np.ptp(cloud.pulses[SCAN_ANGLE]) == pytest.approx(2 * 800 / 210, rel=0.01)


@pytest.mark.parametrize("pulse_frequency, field", [(100e3, 360), (200e3, 180), (300e3, 120)])
def test_fields_of_the_minivux3(pulse_frequency, field):
    """At each of its pulse frequencies it makes 100,000 measurements/s."""
    plane = vtkhelios.Scene([(-50, -50, 0), (50, -50, 0), (0, 50, 0)], [(0, 1, 2)])
    cloud = vtkhelios.scan(
        plane, path=[(0, 0, 50), (0, 9, 50)], scanner="riegl_minivux3uav", speed=8,
        vertical=(-field / 2, field / 2), scan_frequency=100, pulse_frequency=pulse_frequency,
        duration=0.1, noise=False, sub_rays=1, pulses=True,
    )  # fmt: skip
    assert len(cloud.pulses) == pytest.approx(10e3, abs=10)
    step = np.median(np.diff(cloud.pulses[SCAN_ANGLE]))
    assert step == pytest.approx(360 * 100 / pulse_frequency, rel=1e-6)  # 0.36 on the sheet


def test_upright_field():
    """VZ-400i: 100 degrees, from 40 below to 60 above the horizon."""
    plane = vtkhelios.Scene([(-50, -50, 0), (50, -50, 0), (0, 50, 0)], [(0, 1, 2)])
    cloud = vtkhelios.scan(
        plane, position=(0, 0, 2), scanner="riegl_vz400i", vertical=(-40, 60), head=(0, 1),
        head_speed=60, scan_frequency=240, noise=False, sub_rays=1, pulses=True,
    )  # fmt: skip
    elevation = np.degrees(np.arcsin(cloud.pulses[DIRECTION][:, 2]))
    assert (elevation.min(), elevation.max()) == pytest.approx((-40, 60), abs=0.7)
