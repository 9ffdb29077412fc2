# SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
# SPDX-License-Identifier: BSD-3-Clause
"""fit(): simulated flights with known instruments, one number after the other; real clouds; errors."""

import json

import numpy as np
import pytest
from vtkmodules.vtkCommonCore import vtkStringArray

import vtkhelios
from vtkhelios import formats
from vtkhelios.fitting._mirror import oscillation
from vtkhelios.fitting._noise import most_frequent
from vtkhelios.fitting._periods import find_pulse_period, refine_period

from _real_data import real_file

pytestmark = pytest.mark.filterwarnings("ignore:.*is not supported by scanner")

HEIGHT, SPEED, PULSES = 400.0, 60.0, 100_000.0
FREQUENCY = {"rotating": 80.0, "oscillating": 40.0, "conic": 30.0}
DIVERGENCE = {"rotating": 0.00025, "oscillating": 0.000354, "conic": 0.0007}


def make_scene(plates=400, half=1.5, seed=1):
    """Level ground, and square plates above it that divide pulses."""
    random = np.random.default_rng(seed)
    points = [(-400, -400, 0), (400, -400, 0), (400, 400, 0), (-400, 400, 0)]
    faces = [(0, 1, 2), (0, 2, 3)]
    for x, y, z in random.uniform((-250, -150, 3), (250, 150, 15), (plates, 3)):
        n, h = len(points), half
        points += [(x - h, y - h, z), (x + h, y - h, z), (x + h, y + h, z), (x - h, y + h, z)]
        faces += [(n, n + 1, n + 2), (n, n + 2, n + 3)]
    return vtkhelios.Scene(points, faces)


def make_attitude(times, heading, roll, pitch):
    """Quaternions w, x, y, z of Rz(-heading) Rx(pitch) Ry(roll), angles in degrees."""

    def product(a, b):
        w, v = a[:, :1] * b[:, :1] - (a[:, 1:] * b[:, 1:]).sum(axis=1, keepdims=True), None
        v = a[:, :1] * b[:, 1:] + b[:, :1] * a[:, 1:] + np.cross(a[:, 1:], b[:, 1:])
        return np.hstack([w, v])

    def turn(axis, angle):
        half = np.radians(np.broadcast_to(angle, times.shape)) / 2
        found = np.zeros((len(times), 4))
        found[:, 0], found[:, 1 + axis] = np.cos(half), np.sin(half)
        return found

    return product(product(turn(2, -np.asarray(heading)), turn(0, pitch)), turn(1, roll))


def fly(kind="rotating", scene=None, heading=90.0, roll=0.0, pitch=0.0, seconds=1.5, **more):
    """A strip eastward from 100 s on; the heading may differ from the course."""
    times = np.linspace(0, seconds, 31)
    x = SPEED * (times - seconds / 2)
    roll = roll * np.sin(2 * np.pi * times / 3) if np.isscalar(roll) else roll
    flight = vtkhelios.Cloud.from_arrays(
        np.column_stack([x, 0 * x, np.full_like(x, HEIGHT)]),
        GpsTime=100.0 + times,
        Orientation=make_attitude(times, heading, roll, pitch),
    )
    settings = dict(scan_frequency=FREQUENCY[kind], pulse_frequency=PULSES, scan_angle=20)
    survey = vtkhelios.make_survey(
        scene or make_scene(), None, f"{kind}_als", "airplane_linearpath", trajectory=flight,
        syncGPSTime=True, **settings | more,
    )  # fmt: skip
    return survey.run(seed=1, scan_flags=True)


def expect(value, truth, widest):
    """The truth is within the uncertainty, and this within a bound."""
    assert abs(value.value - truth) <= max(value.uncertainty, 1e-9 * abs(truth)), value
    assert value.uncertainty <= widest, value


@pytest.fixture(scope="module")
def flown():
    """A strip of each kind of mirror."""
    return {kind: fly(kind) for kind in FREQUENCY}


@pytest.mark.parametrize("kind", FREQUENCY)
def test_numbers_of_a_flight(flown, kind):
    fit = vtkhelios.fit(flown[kind])
    assert fit["mirror"].text == kind
    expect(fit["pulse frequency"], PULSES, 0.01)
    expect(fit["line frequency"], FREQUENCY[kind], 0.02)
    expect(fit.of_strip("height above ground", 1), HEIGHT, 0.1)
    expect(fit.of_strip("speed", 1), SPEED, 0.01)
    assert fit.of_strip("course", 1).value == pytest.approx(90, abs=0.01)
    name = "sweep of a facet" if kind == "rotating" else "scan angle"
    assert fit[name].value == pytest.approx(90 if kind == "rotating" else 20, abs=1e-3)
    if kind == "rotating":
        for name, angle in (("smallest angle", -20), ("largest angle", 20)):
            expect(fit[name], angle, 0.3)
    if kind == "oscillating":
        assert fit["law of motion"].text == "triangular"
    assert fit["returns per pulse, maximum"].value == flown[kind]["NumberOfReturns"].max()


@pytest.mark.parametrize("kind", ["rotating", "oscillating"])
def test_noise_of_ranges(flown, kind):
    """On level ground; the catalogue's noise of both is 20 mm."""
    fit = vtkhelios.fit(flown[kind])
    assert fit["range noise"].value == pytest.approx(
        0.02, abs=max(0.001, fit["range noise"].uncertainty)
    )
    rows = [row for row in fit.noise if row.of == "incidence"]
    assert [row.lower for row in rows] == [0.0, 10.0]
    for row in rows:
        assert row.cells > 30 and row.noise == pytest.approx(0.02, abs=0.002)


def test_divergence_of_divided_pulses(flown):
    """The zone of divided pulses is narrower than the beam at 1/e²: within the stated half."""
    for kind in ("oscillating", "conic"):
        value = vtkhelios.fit(flown[kind])["beam divergence"]
        assert abs(value.value - DIVERGENCE[kind]) <= value.uncertainty, value


def test_attitude_and_crab():
    """Roll of 2 degrees, pitch of 3, and a heading 10 degrees off the course."""
    cloud = fly("oscillating", heading=100.0, roll=2.0, pitch=3.0)
    fit = vtkhelios.fit(cloud)
    strip = fit.strips[0]
    roll, pitch, yaw = strip.angles.T
    truth = 2 * np.sin(2 * np.pi * (strip.times - 100.0) / 3)
    inner = slice(2, -2)
    assert np.abs(roll - truth)[inner].max() < 0.1
    assert np.abs(pitch - 3)[inner].max() < 0.1
    assert np.abs(yaw - 100)[inner].max() < 0.2
    expect(fit["scan angle"], 20, 0.1)


def test_trajectory_by_whole_scan_angles():
    """Without pulses of several returns: whole degrees, as in LAS 1.2."""
    for kind in ("rotating", "oscillating"):
        cloud = fly(kind, make_scene(plates=1))
        cloud["ScanAngle"] = np.rint(cloud["ScanAngle"])
        fit = vtkhelios.fit(cloud)
        assert fit["mirror"].text == kind
        assert "scan angles in whole degrees" in fit.strips[0].method
        expect(fit.of_strip("height above ground", 1), HEIGHT, 9)
        expect(fit.of_strip("speed", 1), SPEED, 0.4)
        expect(fit["line frequency"], FREQUENCY[kind], 0.02)
        assert any("if they do not include the roll" in note for note in fit.notes)


def test_lost_pulses_and_a_part_of_the_swath():
    cloud = fly("oscillating")
    random = np.random.default_rng(2)
    y = cloud.points[:, 1]
    lost = np.isin(cloud["PulseIds"], np.flatnonzero(random.random(200_000) < 0.4))
    fit = vtkhelios.fit(cloud.filter(~lost & (y > 20) & (y < 120)))
    expect(fit["pulse frequency"], PULSES, 0.01)
    expect(fit["line frequency"], 40, 0.01)
    expect(fit.of_strip("height above ground", 1), HEIGHT, 0.2)
    expect(fit["scan angle"], 20, 2.1)
    assert "assumed: no turns are in the cloud" in fit["law of motion"].text
    cloud = fly("rotating")
    fit = vtkhelios.fit(cloud.filter(cloud.points[:, 1] > 20))
    assert fit["sweep of a facet"].value == pytest.approx(90, abs=0.01)


def test_intervals_cover_the_truth():
    """Flights with roll, pitch and crab, parts of the swath, coordinates in whole centimetres; one
    in twenty intervals misses its value by chance."""
    missed, numbers = [], 0
    for seed in range(6):
        random = np.random.default_rng(seed)
        kind = ("rotating", "oscillating")[seed % 2]
        turned = dict(heading=90 + random.uniform(-8, 8), roll=random.uniform(0, 1.5))
        cloud = fly(
            kind, make_scene(seed=seed + 5), **turned, pitch=random.uniform(-3, 3), seconds=3
        )
        points = np.round(cloud.points, 2)
        cloud = vtkhelios.Cloud.from_arrays(points, **{name: cloud[name] for name in cloud.names})
        low = random.uniform(-60, 60)
        width = random.uniform(60, 150)
        fit = vtkhelios.fit(cloud.filter((points[:, 1] > low) & (points[:, 1] < low + width)))
        for value, truth in (
            (fit.of_strip("height above ground", 1), HEIGHT),
            (fit.of_strip("speed", 1), SPEED),
            (fit["line frequency"], FREQUENCY[kind]),
            (fit["range noise"], 0.02),
        ):
            numbers += 1
            if abs(value.value - truth) > value.uncertainty:
                missed.append(value)
    assert numbers == 24 and len(missed) <= 2, missed


def test_strips_by_sources_and_gaps(flown):
    cloud = flown["rotating"]
    later = cloud.filter(np.ones(len(cloud), bool))
    later["GpsTime"] = later["GpsTime"] + 60.0
    later["LegIds"] = np.full(len(later), 7, np.int32)
    fit = vtkhelios.fit(cloud, later)
    assert [strip.source for strip in fit.strips] == [0, 7]
    assert fit.name.endswith("and 1 more")
    later["LegIds"] = np.zeros(len(later), np.int32)
    assert len(vtkhelios.fit(cloud, later).strips) == 2
    few = later.filter(np.arange(len(later)) < 500)
    fit = vtkhelios.fit(cloud, few)
    assert len(fit.strips) == 1 and "is left out; 1000 are needed" in fit.notes[0]


def make_cloud(cloud, points, crs):
    """A cloud with other points in a coordinate system."""
    made = vtkhelios.Cloud.from_arrays(points, **{name: cloud[name] for name in cloud.names})
    text = vtkStringArray()
    text.SetName("CRS")
    text.InsertNextValue(crs)
    made.data.GetFieldData().AddArray(text)
    return made


def test_feet(flown):
    cloud = flown["oscillating"]
    feet = vtkhelios.Cloud.from_arrays(
        cloud.points / 0.3048, **{name: cloud[name] for name in cloud.names}
    )
    fit = vtkhelios.fit(feet, unit=0.3048)
    expect(fit.of_strip("height above ground", 1), HEIGHT, 0.1)
    assert "units of 0.3048 m; they are converted to metres" in fit.notes[0]
    foot = 1200 / 3937
    fit = vtkhelios.fit(make_cloud(cloud, cloud.points / foot, "EPSG:2263"))
    expect(fit.of_strip("height above ground", 1), HEIGHT, 0.1)
    assert "the unit of heights is not stated" in fit.notes[0]


def test_a_fit_is_flown_again(flown, tmp_path):
    """The survey that is written gives the numbers that it was written with."""
    for kind in ("rotating", "oscillating", "conic"):
        fit = vtkhelios.fit(flown[kind])
        names = [path.name for path in fit.write(tmp_path / kind)]
        assert names == ["survey.xml", "scanner.xml", "strip001.csv", "ground.obj"]
        survey = vtkhelios.read_survey(tmp_path / kind / "survey.xml", scene=make_scene())
        again = vtkhelios.fit(survey.run(seed=2, scan_flags=True))
        assert again["mirror"].text == kind
        for name in ("pulse frequency", "line frequency"):
            assert again[name].value == pytest.approx(fit[name].value, rel=1e-4)
        for name in ("height above ground", "speed"):
            assert again.of_strip(name, 1).value == pytest.approx(
                fit.of_strip(name, 1).value, rel=1e-3
            )
        assert again["range noise"].value == pytest.approx(0.02, rel=0.4)
        assert (
            len(again.strips[0].times)
            and vtkhelios.read_survey(tmp_path / kind / "survey.xml").run()
        )


def test_tables_and_json(flown):
    fit = vtkhelios.fit(flown["rotating"], progress=(seen := []).append)
    assert seen and max(seen) <= 1
    content = json.loads(fit.to_json())
    assert (
        content["values"][0]["name"] == "pulse frequency" and content["strips"][0]["pulses"] > 1000
    )
    assert "<table>" in fit._repr_html_() and fit.table["name"][0] == "pulse frequency"
    with pytest.raises(KeyError, match="no value colour; there are: pulse frequency, mirror"):
        fit["colour"]


# Parts


def test_period_with_modulated_intervals():
    """Intervals of 2.5 and 2.7 µs, as an instrument alternates them; a third of the pulses lost."""
    steps = np.tile([2.5e-6, 2.5e-6, 2.7e-6, 2.5e-6, 2.7e-6, 2.5e-6, 2.7e-6], 5000)
    times = np.cumsum(steps)
    times = times[np.random.default_rng(1).random(len(times)) < 0.67]
    found = find_pulse_period(times)
    assert found.value == pytest.approx(steps.mean(), rel=1e-3) and not found.is_regular
    assert found.intervals == pytest.approx((2.5e-6, 2.7e-6), rel=1e-6)


def test_period_of_times_in_coarse_steps():
    """Steps of 119 ns, in which week seconds are stored by some programs, are no modulation."""
    times = 347_000 + np.round(np.arange(50_000) * 1.00001e-5 * 2**23) / 2**23
    found = find_pulse_period(times)
    assert found.is_regular and abs(found.value - 1.00001e-5) < max(found.uncertainty, 1e-14)


def test_period_of_too_few_or_no_period():
    assert find_pulse_period(np.arange(10) * 1e-5) is None
    random = np.sort(np.random.default_rng(1).random(1000))
    assert refine_period(random, 1e-3) is None


def test_laws_of_oscillating_mirrors():
    """Computes the angle of vtkHeliosOscillatingMirror."""
    for turning in (0.0, 0.3, 1.0, "sinusoidal"):
        mirror = vtkhelios.vtkHeliosOscillatingMirror()
        mirror.SetPulseFrequency(1000)
        mirror.SetScanFrequency(1)
        mirror.SetScanAngle(10)
        if turning == "sinusoidal":
            mirror.SetPatternToSinusoidal()
        else:
            mirror.SetTurningPulses(round(500 * turning))
        truth = [mirror.GetScanAngle(k) for k in range(1000)]
        assert 10 * oscillation(np.arange(1000) / 1000, turning) == pytest.approx(truth, abs=1e-9)


def test_most_frequent_value_of_a_mixture():
    random = np.random.default_rng(1)
    values = np.concatenate([random.normal(2, 0.2, 6000), random.uniform(2, 20, 4000)])
    assert most_frequent(values) == pytest.approx(2, abs=0.1)


# Real clouds; the numbers that others state are in the documents of their flights


def test_ahn3_is_a_polygon_of_four_facets():
    fit = vtkhelios.fit(real_file("als/ahn3_delft_1.laz"))
    assert fit["mirror"].text == "rotating" and len(fit.strips) == 3
    assert fit["sweep of a facet"].value == pytest.approx(90.0, abs=0.1)
    expect(fit["line frequency"], 186.79, 0.05)
    assert fit["pulse intervals"].text == "2.500, 2.700"
    for strip in (1, 2, 3):
        assert 440 < fit.of_strip("height above ground", strip).value < 455
        assert 48 < fit.of_strip("speed", strip).value < 69.5


def test_bcts_and_autzen_oscillate():
    fit = vtkhelios.fit(real_file("als/bcts_1.laz"))
    assert fit["mirror"].text == "oscillating"
    assert fit["pulse frequency"].value == pytest.approx(100_000, abs=5)
    assert fit["line frequency"].value == pytest.approx(65.03, abs=0.05)
    assert fit["scan angle"].value == pytest.approx(15, abs=0.6)
    assert fit["law of motion"].text.startswith("triangular, reverses during")
    fit = vtkhelios.fit(real_file("als/autzen_trim.laz"))
    assert fit["law of motion"].text == "sinusoidal"
    assert fit["pulse frequency"].value == pytest.approx(98_982.5, abs=1)
    assert fit["line frequency"].value == pytest.approx(52.2, abs=0.01)
    assert any("units of 0.3048 m" in note for note in fit.notes)


# Missing and wrong inputs.


def changed(cloud, **columns):
    return vtkhelios.Cloud.from_arrays(
        cloud.points,
        **{name: cloud[name] for name in cloud.names if columns.get(name, 0) is not None}
        | {name: values for name, values in columns.items() if values is not None},
    )


def test_clouds_that_cannot_be_fitted(flown):
    cloud = flown["rotating"]
    flat = fly("rotating", make_scene(plates=1))
    few = cloud.filter(np.arange(len(cloud)) < 2000)
    far = cloud.points.copy()
    far[3, 2] = 1e13
    for given, message in (
        (vtkhelios.Cloud(), "has no points; give a cloud with points"),
        (np.zeros((5, 3)), "has no GpsTime, which identifies the pulses; give a cloud with times"),
        (changed(cloud, GpsTime=None), "has no GpsTime, which identifies the pulses"),
        (changed(cloud, GpsTime=np.zeros(len(cloud))), "GpsTime is 0 at all points, so that no"),
        (changed(cloud, GpsTime=np.full(len(cloud), np.nan)), "GpsTime is nan at all points"),
        (changed(flat, ScanAngle=None), "it has no ScanAngle, and fewer than 50 of its pulses"),
        (changed(flat, ScanAngle=np.zeros(len(flat))), "ScanAngle is constant, and fewer than 50"),
        (
            cloud.filter(np.arange(len(cloud)) < 300),
            "pulses in its longest strip, too few for a fit",
        ),
        (
            changed(few, GpsTime=np.random.default_rng(1).permutation(len(few)) ** 1.01 / 50),
            "fewer than 30 pulses are successive|fewer than 10 of its scan lines are found",
        ),
        (
            vtkhelios.Cloud.from_arrays(far, GpsTime=cloud["GpsTime"]),
            r"point 3 is .*1e\+13\), expected numbers within 1e\+12; correct it",
        ),
    ):
        with pytest.raises(formats.FormatError, match=message):
            vtkhelios.fit(given)


def test_wrong_settings(flown, tmp_path):
    cloud = flown["rotating"]
    for arguments, settings, error, message in (
        ((), {}, ValueError, "no clouds; give one or more"),
        ((cloud,), {"unit": 0}, ValueError, "unit is 0; give the unit of the coordinates"),
        ((cloud,), {"points": 10}, ValueError, "points is 10; give a whole number, 1000 or more"),
        (
            (cloud,),
            {"points": 1000},
            formats.FormatError,
            "have more than 1,000 points; give fewer",
        ),
        (({},), {}, TypeError, "not dict; give a path"),
        ((tmp_path / "a.las",), {}, formats.FormatError, "no such file or folder; check its name"),
    ):
        with pytest.raises(error, match=message):
            vtkhelios.fit(*arguments, **settings)
    with pytest.raises(formats.FormatError, match="longitudes and latitudes .*; convert it first"):
        vtkhelios.fit(make_cloud(cloud, cloud.points / 1e5, "EPSG:4326"))


def test_different_coordinate_systems(tmp_path, flown):
    paths = []
    for code in ("EPSG:25832", "EPSG:25833"):
        header = formats.Header()
        header.crs = code
        paths.append(tmp_path / f"{code[5:]}.las")
        with formats.open_writer(paths[-1], header) as writer:
            writer.write(vtkhelios.arrays(flown["rotating"].polydata))
    with pytest.raises(formats.FormatError, match="systems of the clouds differ: EPSG:25832 and"):
        vtkhelios.fit(*paths)
    assert len(vtkhelios.fit(paths[0]).strips) == 1
