# SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
# SPDX-License-Identifier: BSD-3-Clause
"""Metrics of two clouds against closed forms; intervals; what cannot be measured."""

import json
import math

import numpy as np
import pytest

import vtkhelios
from vtkhelios import formats
from vtkhelios.comparison._blocks import Blocks, kolmogorov_smirnov, total_variation
from vtkhelios.core.systems import find_difference
from vtkhelios.comparison._planes import draw_equal
from vtkhelios.comparison._pulses import Lines

SIDE, ALONG, ACROSS, NOISE = 60.0, 0.25, 0.4, 0.02  # [m]
MULTIPLE = 0.3  # share of the pulses that have a second return


def make_survey(seed, noise=NOISE, shift=(0.0, 0.0, 0.0), slope=0.0, multiple=MULTIPLE):
    """Scan lines along x over a plane, and a roof of two slopes in each direction 10 m above.

    One return of each pulse is on the plane; the second one of some is 3 m below, and later.
    """
    random = np.random.default_rng(seed)
    columns, rows = int(SIDE / ALONG), int(SIDE / ACROSS)
    line, column = (each.ravel() for each in np.mgrid[0:rows, 0:columns])
    x, y = (column + random.random()) * ALONG, (line + random.random()) * ACROSS
    x, y = x % SIDE, y % SIDE
    order = np.lexsort((x, y))
    x, y = x[order], y[order]
    z = slope * np.minimum(np.minimum(x, SIDE - x), np.minimum(y, SIDE - y)) + 10.3
    normal = random.normal(0.0, noise, len(x)) * math.hypot(1.0, slope)
    points = np.column_stack([x, y, z + normal]) + shift
    has_second = random.random(len(x)) < multiple
    times = line * 0.01 + column * 1e-5
    angle = (x / SIDE - 0.5) * 30.0
    first = {
        "points": points, "GpsTime": times, "ScanAngle": angle,
        "ReturnNumber": np.ones(len(x), np.uint8),
        "NumberOfReturns": 1 + has_second.astype(np.uint8),
        "ClassificationIds": np.full(len(x), 6, np.int32),
        "Amplitude": 10.0 ** random.normal(-7.0, 0.1, len(x)),
        "EchoWidth": random.normal(4.0, 0.2, len(x)),
    }  # fmt: skip
    second = {name: values[has_second] for name, values in first.items()}
    second["points"] = second["points"] - [0.0, 0.0, 3.0]
    other = random.normal(0.0, noise, len(x)) * math.hypot(1.0, slope)
    second["points"][:, 2] += (other - normal)[has_second]
    second["ReturnNumber"] = np.full(has_second.sum(), 2, np.uint8)
    second["ClassificationIds"] = np.full(has_second.sum(), 2, np.int32)
    columns = {name: np.concatenate([first[name], second[name]]) for name in first}
    return vtkhelios.Cloud.from_arrays(columns.pop("points"), **columns)


def thin(cloud, share, seed=7):
    """Keeps a random share of the pulses."""
    times, pulse = np.unique(cloud["GpsTime"], return_inverse=True)
    return cloud.filter((np.random.default_rng(seed).random(len(times)) < share)[pulse])


@pytest.fixture(scope="module")
def same():
    """Two samples of one plane."""
    return vtkhelios.compare(make_survey(4), make_survey(5), cell=2.0)


@pytest.fixture(scope="module")
def other():
    """Roofs that are noisier, sparser and shifted."""
    moved = make_survey(2, noise=0.03, shift=(0.08, -0.05, 0.03), slope=0.4)
    return vtkhelios.compare(make_survey(1, slope=0.4), thin(moved, 0.5), cell=2.0)


TRUTH = {  # metric: value of both, tolerance
    "returns per pulse": (1 + MULTIPLE, 0.01),
    "multi-return share": (MULTIPLE, 0.01),
    "density": ((1 + MULTIPLE) / (ALONG * ACROSS), 0.1),
    "pulse density": (1 / (ALONG * ACROSS), 0.05),
    "spacing along lines": (ALONG, 1e-6),
    "spacing across lines": (ACROSS, 1e-6),
    "noise of planes, RMS": (NOISE, 0.0003),
    "noise of planes, median": (NOISE, 0.0004),
    "median amplitude": (20.0, 0.03),  # 1e-7 W is 100 nW
    "median echo width": (4.0, 0.01),
    "planar share of cells": (1.0, 0.05),
}


@pytest.mark.parametrize("name", TRUTH)
def test_two_samples_of_a_plane_have_its_values(same, name):
    expected, tolerance = TRUTH[name]
    row = same[name]
    for each in (row.a, row.b):
        assert each.value == pytest.approx(expected, abs=tolerance)
        assert each.lower <= each.value <= each.upper
    assert row.agrees


def test_two_samples_of_a_plane_agree_and_are_registered(same):
    compared = [row.agrees for row in same.rows if row.agrees is not None and not row.by_density]
    assert len(compared) > 20 and compared.count(False) <= 2  # one in twenty is off by chance
    assert same.registration.startswith("no shift found: z ")
    assert "x and y not determined by the planes" in same.registration
    assert same.shift[:2] == [None, None] and abs(same.shift[2].value) < 5e-4
    assert any(text.startswith("shift x: too few of the planes") for text in same.absent)


def test_spacing_of_nearest_points_of_a_random_plane():
    """The median of a Poisson process of density d is sqrt(ln 2 / (pi d))."""
    points = np.random.default_rng(1).uniform(0, 100, (100_000, 3)) * [1, 1, 0]
    result = vtkhelios.compare(points[:50_000], points)
    row = result["nearest-neighbour spacing"]
    for each, density in ((row.a, 5.0), (row.b, 10.0)):
        assert each.value == pytest.approx(math.sqrt(math.log(2) / (math.pi * density)), rel=0.03)
    assert row.agrees is False and row.by_density
    assert "GpsTime" in next(text for text in result.absent if text.startswith("spacing along"))


def test_shift_noise_and_density_of_another_cloud(other):
    for estimate, truth in zip(other.shift, (0.08, -0.05, 0.03)):
        assert estimate.value == pytest.approx(truth, abs=0.002)
        assert estimate.upper - estimate.lower < 0.008
    assert other.registration.startswith("B is shifted against A; nothing was moved: x +0.0")
    noise = other["noise of planes, median"]  # cells of ridges are not flat
    assert noise.b.value == pytest.approx(0.03, rel=0.05) and noise.agrees is False
    assert noise.a.value == pytest.approx(NOISE, rel=0.05)
    density = other["density"]
    assert density.b.value / density.a.value == pytest.approx(0.5, rel=0.02)
    assert density.agrees is False


def test_half_of_the_pulses_changes_no_metric_that_is_free_of_density():
    """One in twenty of the intervals misses 0 by chance."""
    agreements = []
    for seed in range(6):
        cloud = make_survey(seed, slope=0.4 * (seed % 2))
        result = vtkhelios.compare(cloud, thin(cloud, 0.5, seed), cell=2.0, sample=500)
        free = [row for row in result.rows if not row.by_density and row.of_class is None]
        assert len(free) >= 18 and result["density"].agrees is False
        agreements += [row.agrees for row in free]
    assert agreements.count(False) <= 0.1 * len(agreements)


def test_height_profiles_that_differ_by_a_known_part():
    """A fifth of the pulses with a second return against two fifths: 1/6 and 2/7 of the points."""
    first, second = make_survey(1, multiple=0.2), make_survey(2, multiple=0.4)
    result = vtkhelios.compare(first, second, cell=2.0)
    for kind in ("total variation", "Kolmogorov-Smirnov"):
        row = result[f"height profile, {kind}"]
        assert row.difference.value == pytest.approx(2 / 7 - 1 / 6, abs=0.01)
        assert row.agrees is False and row.chance < 0.03
    share = next(row for row in result.rows if row.name == "share of points" and row.of_class == 2)
    assert share.difference.value == pytest.approx(2 / 7 - 1 / 6, abs=0.01)


def test_a_hole_is_occluded():
    cloud, other = make_survey(1), make_survey(2)
    x, y = other.points[:, 0], other.points[:, 1]
    holed = other.filter(~((np.abs(x - 30) < 6) & (np.abs(y - 30) < 6)))
    row = vtkhelios.compare(cloud, holed, cell=2.0)["occluded in the other cloud"]
    assert row.a.value == pytest.approx(144 / 3600, abs=0.003) and row.b.value == 0.0


def test_cells_are_not_occluded_where_few_points_are_expected():
    """With 3 % of the points a cell of 2 m has one or two of the 52."""
    cloud = make_survey(1)
    absent = vtkhelios.compare(cloud, thin(cloud, 0.03), cell=2.0).absent
    assert any(
        text.startswith("occluded in the other cloud: no cell in which 5 points") for text in absent
    )


def test_both_clouds_give_equally_many_points_of_a_cell():
    random = np.random.default_rng(1)
    numbers = random.integers(0, 50, 5000), random.integers(10, 90, 1000)
    numbers[1][numbers[1] == 20] = 21
    counts = [
        np.bincount(each[rows], minlength=90)
        for each, rows in zip(numbers, draw_equal(numbers, random))
    ]
    both = np.minimum(*(np.bincount(each, minlength=90) for each in numbers))
    assert np.array_equal(counts[0], np.where(both >= 10, both, 0)) and counts[0].any()
    assert np.array_equal(*counts)


def test_lines_of_different_strips_are_no_pairs():
    cloud = make_survey(1)
    cloud["LegIds"] = np.rint(cloud["GpsTime"] // 0.01).astype(np.int32)
    absent = vtkhelios.compare(cloud, cloud).absent
    assert any("fewer than 30 pairs of lines side by side" in text for text in absent)


def test_distances_to_a_mesh_are_signed(tmp_path):
    corners = [(-10, -10, 10.2), (90, -10, 10.2), (90, 90, 10.2), (-10, 90, 10.2)]
    scene = vtkhelios.Scene(corners, [(0, 1, 2), (0, 2, 3)])
    scene.write(tmp_path / "plane.obj")
    for mesh in (scene, tmp_path / "plane.obj"):
        clouds = make_survey(1, multiple=0), make_survey(2, shift=(0, 0, -0.25), multiple=0)
        result = vtkhelios.compare(*clouds, mesh=mesh, sample=5000)
        row = result["distance to the mesh, median"]
        assert row.a.value == pytest.approx(0.1, abs=0.002)
        assert row.b.value == pytest.approx(-0.15, abs=0.002)
        spread = result["distance to the mesh, spread"]
        assert spread.a.value == pytest.approx(0.6745 * NOISE, rel=0.05)


def test_clouds_that_share_no_ground_are_compared_as_wholes():
    apart = make_survey(2, shift=(500.0, 0.0, 0.0))
    result = vtkhelios.compare(make_survey(1), apart)
    assert result.settings["commonTiles"] == 0
    assert result.registration == "not known: the clouds share no ground"
    assert "planes: the clouds share no ground" in result.absent
    for name in ("returns per pulse", "spacing across lines", "height profile, Kolmogorov-Smirnov"):
        assert result[name].agrees, name
    with pytest.raises(KeyError, match="not measured: planes"):
        result["planes"]


def test_a_sample_of_tiles_has_the_density_of_the_whole():
    first, second = make_survey(1), thin(make_survey(2), 0.5)
    whole = vtkhelios.compare(first, second, cell=2.0)
    part = vtkhelios.compare(first, second, cell=2.0, points=20_000)
    assert part.settings["sampledShare"] == pytest.approx(20_000 / len(first))
    assert 10_000 < part.a["compared"] < 30_000 and part.a["points"] == len(first)
    assert part["density"].a.value == pytest.approx(whole["density"].a.value, rel=0.03)
    assert part["spacing across lines"].b.value == pytest.approx(ACROSS, rel=1e-3)


def test_equal_seeds_give_equal_results():
    clouds = make_survey(1), make_survey(2)
    texts = [vtkhelios.compare(*clouds, seed=seed, sample=500).to_json() for seed in (3, 3, 4)]
    assert texts[0] == texts[1] != texts[2]


def test_intervals_cover_the_mean_of_independent_tiles():
    """Standard error of a mean of 200 tiles."""
    random = np.random.default_rng(1)
    tiles = np.arange(200)
    values = random.normal(5.0, 1.0, 200)
    sampled = Blocks(200, 0).ratio(values, np.ones(200))
    found = sampled.estimate()
    assert found.value == pytest.approx(values.mean())
    assert found.upper - found.lower == pytest.approx(2 * 1.96 / math.sqrt(200), rel=0.15)
    median = Blocks(200, 0).quantile(values, tiles).estimate()
    wide = 2 * 1.96 * math.sqrt(math.pi / 2 / 200)
    assert median.upper - median.lower == pytest.approx(wide, rel=0.35)


def test_few_tiles_have_no_interval():
    sampled = Blocks(7, 0).ratio(np.ones(7), np.ones(7)).estimate()
    assert sampled.value == 1 and math.isnan(sampled.lower) and math.isnan(sampled.upper)


def test_distances_of_histograms():
    first, second = np.array([0.5, 0.5, 0.0]), np.array([0.25, 0.5, 0.25])
    assert total_variation(first, second) == 0.25 and kolmogorov_smirnov(first, second) == 0.25
    assert kolmogorov_smirnov(np.array([0.5, 0, 0.5]), np.array([0, 1.0, 0])) == 0.5


@pytest.mark.parametrize("mirror", ["polygon", "oscillating", "flags"])
def test_lines_of_mirrors(mirror):
    """Lines 0.4 m apart, by sawtooth and zigzag angles, or by the scan direction alone."""
    cloud = make_survey(1, multiple=0)
    line = np.rint(cloud["GpsTime"] // 0.01).astype(int)
    if mirror != "polygon":
        x = np.where(line % 2, SIDE - cloud.points[:, 0], cloud.points[:, 0])
        points = np.column_stack([x, cloud.points[:, 1:]])
        angle = (x / SIDE - 0.5) * 30
        columns = {"GpsTime": cloud["GpsTime"], "ScanAngle": np.rint(angle)}
        if mirror == "flags":
            columns = {
                "GpsTime": cloud["GpsTime"],
                "ScanDirectionFlag": (line % 2).astype(np.uint8),
            }
        cloud = vtkhelios.Cloud.from_arrays(points, **columns)
    row = vtkhelios.compare(cloud, cloud)["spacing across lines"]
    assert row.a.value == pytest.approx(ACROSS, rel=1e-3)


# Missing and wrong inputs.


def test_one_point_and_few_points_are_not_measured():
    one = np.array([[1.0, 2.0, 3.0]])
    result = vtkhelios.compare(one, one)
    assert "nearest-neighbour spacing: ndarray of 1 point has one point" in result.absent
    assert all(row.agrees is None for row in result.rows)
    json.loads(result.to_json())
    result = vtkhelios.compare(one, make_survey(1))
    json.loads(result.to_json())


@pytest.mark.parametrize("empty", [np.empty((0, 3)), vtkhelios.Cloud()])
def test_empty_clouds_are_errors(empty):
    with pytest.raises(formats.FormatError, match="0 points: has no points; give a cloud with"):
        vtkhelios.compare(make_survey(1), empty)


def test_missing_arrays_are_named():
    bare = vtkhelios.Cloud.from_arrays(make_survey(1).points)
    result = vtkhelios.compare(bare, make_survey(2))
    reasons = dict(text.split(": ", 1) for text in result.absent)
    for name, array in (
        ("returns per pulse", "ReturnNumber"), ("spacing along lines", "GpsTime"),
        ("amplitude", "Amplitude"), ("echo width", "EchoWidth"), ("classes", "ClassificationIds"),
    ):  # fmt: skip
        assert f"Cloud of {len(bare):,} points has no {array}" in reasons[name]
    zeros = make_survey(1)
    zeros["ReturnNumber"] = np.zeros(len(zeros), np.uint8)
    absent = vtkhelios.compare(zeros, make_survey(2)).absent
    assert any("has no point with ReturnNumber 1" in text for text in absent)


def test_different_coordinate_systems_are_an_error():
    first, second = make_survey(1), make_survey(2)
    for cloud, code in ((first, "EPSG:25832"), (second, "EPSG:25833")):
        header = formats.Header()
        header.crs = code
        cloud.data.GetFieldData().ShallowCopy(header.fields)
    with pytest.raises(formats.FormatError, match="EPSG:25832 and EPSG:25833; convert one of them"):
        vtkhelios.compare(first, second)
    result = vtkhelios.compare(first, make_survey(2))
    assert any("has no coordinate system; it is taken to be" in note for note in result.notes)


def test_coordinate_systems_of_wkt():
    system = vtkhelios.vtkHeliosCoordinateSystem()
    system.SetText("EPSG:25832")
    wkt = system.GetWkt()
    assert find_difference(wkt, "EPSG:25832") is None
    assert find_difference(wkt, "EPSG:3005").startswith("EPSG:25832 and EPSG:3005")
    assert find_difference(wkt, 'PROJCS["own"]') is None and find_difference("", wkt) is None


@pytest.mark.parametrize(
    "settings, message",
    [
        ({"cell": 0.0}, "cell is 0.0; give a length above 0"),
        ({"points": 10}, "points is 10; give a whole number, 1000 or more"),
        ({"sample": 1.5}, "sample is 1.5; give a whole number, 10 or more"),
        ({"seed": -1}, "seed is -1; give a whole number, 0 or more"),
    ],
)
def test_wrong_settings(settings, message):
    with pytest.raises(ValueError, match=message):
        vtkhelios.compare(np.zeros((1, 3)), np.zeros((1, 3)), **settings)


def test_wrong_inputs(tmp_path):
    good = make_survey(1)
    with pytest.raises(ValueError, match=r"shape \(3,\); give an array of \(n, 3\)"):
        vtkhelios.compare(np.zeros(3), good)
    with pytest.raises(TypeError, match="clouds are compared, not dict; give a path"):
        vtkhelios.compare({}, good)
    with pytest.raises(TypeError, match="a mesh is a path, a Scene or a vtkPolyData, not int"):
        vtkhelios.compare(good, good, mesh=3)
    with pytest.raises(formats.FormatError, match="gone.obj: no such file; check the name of the"):
        vtkhelios.compare(good, good, mesh=tmp_path / "gone.obj")
    (tmp_path / "a.dxf").write_text("")
    with pytest.raises(formats.FormatError, match="a.dxf: is not a mesh of a known format"):
        vtkhelios.compare(good, good, mesh=tmp_path / "a.dxf")
    with pytest.raises(formats.FormatError, match="the mesh: has no triangles"):
        vtkhelios.compare(good, good, mesh=good)
    with pytest.raises(formats.FormatError, match=r"point 0 is \(1e\+13, 0, 0\), expected numbers"):
        vtkhelios.compare(np.array([[1e13, 0, 0]]), good)
    with pytest.raises(formats.FormatError, match="cells of 0.005 m; give larger cells, or remove"):
        vtkhelios.compare(np.array([[1e9, -1e9, 0]]), np.array([[-1e9, 1e9, 1e9]]), cell=0.001)
    with pytest.raises(KeyError, match="no metric colour; there are: "):
        vtkhelios.compare(good, good)["colour"]


def test_period_of_pulses_with_gaps():
    """The pulse period is found although every second pulse is missing."""
    cloud = thin(make_survey(1), 0.3)
    from vtkhelios.comparison._inputs import Side

    side = Side("a", {"points": cloud.points, "GpsTime": cloud["GpsTime"],
                      "ReturnNumber": cloud["ReturnNumber"],
                      "NumberOfReturns": cloud["NumberOfReturns"]})  # fmt: skip
    side.tiles = np.zeros(len(cloud), np.int64)
    assert Lines(side, SIDE).period == pytest.approx(1e-5, rel=1e-3)


@pytest.mark.parametrize("counts", [(1, 1), (1, 300), (300, 1), (2, 3)])
def test_few_points(tmp_path, counts):
    paths = [tmp_path / f"{name}.las" for name in "ab"]
    for path, count in zip(paths, counts):
        chunk = {
            "points": np.random.default_rng(1).uniform(0, 9, (count, 3)),
            "Intensity": np.full(count, 7, np.uint16),
            "EchoWidth": np.full(count, 4.0),
        }
        with formats.open_writer(path, formats.Header()) as writer:
            writer.write(chunk)
    result = vtkhelios.compare(*paths)
    assert [side["points"] for side in (result.a, result.b)] == list(counts)
    assert any(row.name.startswith("median intensity") for row in result.rows)
    json.loads(result.to_json())


def test_progress_and_tables():
    seen = []
    result = vtkhelios.compare(make_survey(1), make_survey(2), sample=100, progress=seen.append)
    assert seen and 0 <= min(seen) <= max(seen) <= 1
    table = result.table
    assert table["metric"][0] == "returns per pulse" and len(table) == len(result.rows)
    assert "<table>" in result._repr_html_()
    content = json.loads(result.to_json())
    assert content["metrics"][0]["a"] == pytest.approx(1.3, abs=0.02)
    assert sum(content["histograms"][0]["a"]) == pytest.approx(1)
