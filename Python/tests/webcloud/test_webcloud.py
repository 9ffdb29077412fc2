# SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
# SPDX-License-Identifier: BSD-3-Clause
"""The page of a cloud, read by an independent reader: points, values, levels of detail, samples."""

import sys

import numpy as np
import pytest
from webcloud._page_reader import PageReader, decode

from vtkhelios import formats, webcloud
from vtkhelios.array_names import MATERIAL_NAME
from vtkhelios.webcloud._columns import make_columns, make_scale
from vtkhelios.webcloud._contents import Contents
from vtkhelios.webcloud._octree import DEEPEST, GRID, LEAF, build
from vtkhelios.webcloud._outline import find_outline
from vtkhelios.webcloud._quantise import position_step, quantise
from vtkhelios.webcloud._sample import Sample, hashes
from vtkhelios.webcloud._waveforms import WaveformSample


def sorted_rows(points, values):
    """Points and values in the order of a value."""
    order = np.argsort(values, kind="stable")
    return points[order], values[order]


def test_every_value_of_the_cloud(make_arrays):
    """Millimetres at UTM coordinates are exact; other values keep the accuracy of the manual."""
    arrays = make_arrays(60_000)
    arrays["GpsTime"][7] = 123.0
    page = PageReader(webcloud.make_page(arrays, "a"))
    points, values = page.cloud()
    order, back = np.argsort(arrays["GpsTime"]), np.argsort(values["GpsTime"])
    assert np.array_equal(points[back], arrays["points"][order])
    for name, bound in {"GpsTime": 5.1e-8, "Range": 5.1e-5, "IncidenceAngle": 5.1e-5}.items():
        assert np.nanmax(np.abs(values[name][back] - arrays[name][order])) <= bound
    assert np.array_equal(
        np.isnan(values["IncidenceAngle"][back]), np.isnan(arrays["IncidenceAngle"][order])
    )
    for name in ("PulseIds", "ClassificationIds", "ReturnNumber"):
        assert np.array_equal(values[name][back], arrays[name][order])
    assert np.abs(values["Amplitude"][back] / arrays["Amplitude"][order] - 1).max() < 1.6e-5
    for axis, name in enumerate(("Normal.x", "Normal.y", "Normal.z")):
        assert np.allclose(
            values[name][back], arrays["Normal"][order][:, axis], rtol=1.6e-5, atol=0
        )
    red = (values["RGB"][back].astype(int) >> 16) / 255
    assert np.abs(red - arrays["RGB"][order][:, 0]).max() <= 0.5001 / 255
    assert page.meta["shown"] == page.meta["total"] == 60_000


def test_page_needs_no_network(make_arrays):
    page = PageReader(webcloud.make_page(make_arrays(100), "a"))
    assert page.addresses == [] and set(page.scripts) == {"meta", "streams", "importmap", "module"}
    assert (
        "twgl.js" in page.meta["licences"]
        and "Permission is hereby granted" in page.meta["licences"]
    )


def test_title_and_labels_are_escaped(make_arrays):
    bad = "</script><script>alert(1)</script>&\"'@META@"
    text = webcloud.make_page(
        make_arrays(100) | {"PartIds": np.zeros(100, int)}, bad, names={"PartIds": [bad]}
    )
    page = PageReader(text)
    assert page.meta["title"] == bad and "alert" not in "".join(page.scripts.get(None, ""))
    assert set(page.scripts) == {"meta", "streams", "importmap", "module"}
    assert page.meta["columns"][-1]["categories"] == [[0, f"0 {bad}", 100]]


def test_numbers_have_the_names_beside_the_file(tmp_path, make_arrays):
    """Parts and materials, from the file of names of LAS, also of a number without a name."""
    header = formats.Header()
    header.part_names, materials = ["ground", "", "2"], ["grass", "brick"]
    header.set_texts(MATERIAL_NAME, materials)
    numbers = np.arange(100) % 4
    chunk = {"points": make_arrays(100)["points"], "PartIds": numbers, "MaterialIds": numbers % 2}
    with formats.open_writer(tmp_path / "a.las", header) as writer:
        writer.write(chunk)
    with formats.open_reader(tmp_path / "a.las") as reader:
        contents = Contents.of_reader(reader)
        for each in reader.chunks():
            contents.add(each)
    labels = {
        column["name"]: [label for _, label, _ in column["categories"]]
        for column in PageReader(contents.make_page()).meta["columns"]
    }
    assert labels["PartIds"] == ["0 ground", "1", "2", "3"]
    assert labels["MaterialIds"] == ["0 grass", "1 brick"]


# Levels of detail


@pytest.mark.parametrize("n", [1, 300, 150_000])
def test_octree_has_every_point_once(n):
    steps = np.random.default_rng(2).integers(0, 2**20, (n, 3))
    steps[:, 2] //= 50
    nodes, bits = build(steps)
    rows = np.concatenate([node.rows for node in nodes])
    assert np.array_equal(np.sort(rows), np.arange(n))
    keys = {(node.level, *node.place) for node in nodes}
    assert len(keys) == len(nodes)
    for node in nodes:
        size = 2 ** (bits - node.level)
        inside = steps[node.rows] - node.corner(bits)
        assert inside.min() >= 0 and inside.max() < size
        assert node.level == 0 or (node.level - 1, *(axis // 2 for axis in node.place)) in keys
        assert (np.diff(node.rows) > 0).all()


def test_levels_are_samples_of_a_grid():
    """Down to each level there is one point per cell, wherever there are points, and no more."""
    steps = np.random.default_rng(3).integers(0, 2**16, (200_000, 3))
    steps[:, 2] //= 1000
    nodes, bits = build(steps)
    assert max(node.level for node in nodes) >= 1
    root = nodes[0].rows
    cells = steps[root] >> (bits - GRID)
    all_cells = np.unique(steps >> (bits - GRID), axis=0)
    assert len(root) == len(np.unique(cells, axis=0)) == len(all_cells) < LEAF


def test_equal_points_end_in_the_deepest_level():
    nodes, _ = build(np.zeros((3 * LEAF, 3), np.int64))
    assert sum(len(node.rows) for node in nodes) == 3 * LEAF and nodes[-1].level <= DEEPEST


# Samples


@pytest.mark.parametrize("rows", [97, 5000])
def test_samples_depend_on_no_chunks(rows):
    """A sample has exactly its points, is nested in larger ones, and is not biased."""
    points = np.column_stack([np.arange(20_000.0)] * 3)
    found = {}
    for limit in (100, 1000):
        sample = Sample(limit)
        for start in range(0, 20_000, rows):
            sample.add({"points": points[start : start + rows]})
        columns = sample.columns()
        found[limit] = columns["index"]
        assert (
            np.array_equal(columns["points"][:, 0], columns["index"])
            and len(columns["index"]) == limit
        )
        assert (np.diff(columns["index"]) > 0).all() and sample.count == 20_000
    assert set(found[100]) <= set(found[1000])
    expected = np.sort(np.argsort(hashes(np.arange(20_000)))[:1000])
    assert np.array_equal(found[1000], expected)
    assert abs(found[1000].mean() / 10_000 - 1) < 4 / np.sqrt(12 * 1000) * 2


def test_arrays_that_some_chunks_lack_are_dropped():
    sample = Sample(10)
    sample.add({"points": np.zeros((2, 3)), "Range": np.ones(2), "LegIds": np.ones(2, int)})
    sample.add({"points": np.ones((1, 3)), "LegIds": np.ones(1, int)})
    assert set(sample.columns()) == {"points", "index", "LegIds"} and sample.dropped == {"Range"}
    assert len(Sample(10).columns()["points"]) == 0


# Numbers


@pytest.mark.parametrize(
    "extent, step",
    [
        (0.0, 1e-4),
        (1e-300, 1e-9),
        (0.005, 1e-8),
        (5.0, 1e-5),
        (1000.0, 1e-4),
        (3e5, 1e-3),
        (1e12, 1e3),
    ],
)
def test_step_of_positions(extent, step):
    assert position_step(np.array([[0.0, 0, 0], [extent, 0, 0]])) == step


def test_positions_of_any_size(make_arrays):
    for scale in (1e-3, 1.0, 1e7):
        points = scale * np.random.default_rng(4).normal(size=(500, 3))
        page = PageReader(webcloud.make_page({"points": points, "LegIds": np.arange(500)}, "a"))
        found, values = page.cloud()
        back = np.argsort(values["LegIds"])
        assert np.abs(found[back] - points).max() <= 0.5001 * page.meta["step"]
        assert page.meta["step"] <= 1e-4 or page.meta["step"] < np.ptp(points, axis=0).max() / 65536


@pytest.mark.parametrize(
    "values, unit",
    [
        (np.array([-(2**62), 2**62]), None),
        (np.array([np.inf, 1.0, -np.inf]), "m"),
        (np.array([1e300, 1.0]), "m"),
        (np.array([np.nan, np.nan]), "s"),
        (np.array([True, False]), None),
    ],
)
def test_numbers_of_any_size(values, unit):
    codes = quantise(values, unit)
    assert codes.values.min() >= 0 and codes.values.max() < 2**53
    if codes.kind == "float":
        found = (codes.values.astype(np.uint32) << np.uint32(8)).view(np.float32)
        with np.errstate(over="ignore"):
            assert np.allclose(found, values.astype(np.float32), rtol=1.6e-5, equal_nan=True)


def test_roles_of_arrays():
    n = 5000
    columns = {
        column.name: column
        for column in make_columns({
            "points": np.zeros((n, 3)), "index": np.arange(n), "WaveformIds": np.arange(n),
            "LegIds": np.arange(n) // 100, "UserData": np.arange(n) % 3, "Intensity": np.arange(n),
            "Amplitude": np.logspace(-9, -6, n), "Flat": np.full(n, 3.0), "Many": np.zeros((n, 9)),
            "PulseIds": np.arange(n) % 2,
        })
    }  # fmt: skip
    roles = {name: column.role for name, column in columns.items()}
    assert roles == {
        "LegIds": "category", "UserData": "category", "Intensity": "continuous", "PulseIds": "continuous",
        "Amplitude": "continuous", "Flat": "continuous",
    }  # fmt: skip
    assert columns["Amplitude"].is_logarithmic and columns["Amplitude"].unit == "W"
    assert columns["LegIds"].categories[3] == [3, "3", 100]


def test_scale_leaves_out_the_ends():
    values = np.r_[np.linspace(0, 100, 10_001), np.nan]
    limits, extremes, is_logarithmic = make_scale(values)
    assert limits == pytest.approx((2, 98)) and extremes == (0, 100) and not is_logarithmic
    assert make_scale(np.array([np.nan])) == ((0.0, 1.0), (0.0, 1.0), False)


def test_outline_of_a_cloud():
    """It has the corners of a box, on its surface only, and no outliers."""
    points = np.random.default_rng(5).uniform(0, 10, (50_000, 3))
    points[:8] = [[x, y, z] for x in (0, 10) for y in (0, 10) for z in (0, 10)]
    points[8] = [5, 5, 900]
    outline = find_outline(points)
    assert set(map(tuple, points[:8])) <= set(map(tuple, outline)) and len(outline) < 256
    assert [5, 5, 900] not in outline
    assert find_outline(points[8:9]) == [[5, 5, 900]]


# Waveforms


def make_table(pulses, count=30):
    samples = np.exp(-(((np.arange(count * len(pulses)) % count) - 9.0) ** 2) / 8) * 1e-7
    return {
        "PulseIds": pulses, "StartTime": 100.0 + pulses, "BinSize": np.full(len(pulses), 0.25),
        "Offset": count * np.arange(len(pulses)), "Count": np.full(len(pulses), count),
        "Samples": samples.astype(np.float32),
    }  # fmt: skip


@pytest.mark.parametrize("parts", [1, 5])
def test_waveforms_within_a_limit(parts):
    pulses = np.arange(1000)
    sample = WaveformSample(pulses[::2], limit=19 * 100)  # without zeros at the end
    for part in np.array_split(pulses, parts):
        sample.add(make_table(part))
    kept = sample.shrink()
    expected = np.sort(pulses[::2][np.argsort(hashes(pulses[::2]))[:100]])
    assert np.array_equal(kept["PulseIds"], expected) and sample.seen == 500
    assert np.array_equal(kept["StartTime"], 100.0 + expected) and (kept["BinSize"] == 0.25).all()
    assert (kept["Samples"].reshape(100, 19).argmax(axis=1) == 9).all()


@pytest.mark.parametrize(
    "samples",
    [[0.0], [0.0, 0.0, 0.0], [5.0], [0.0, 0.0, 1.0, 0.0, 0.0, 0.0], [-1.0, -2.0], [3.0, 1.0, 2.0]],
)
def test_any_waveform(samples, make_arrays):
    """Zeros at both ends are left out, but one; a waveform of zeros stays."""
    table = make_table(np.arange(3), 1)
    table["Samples"] = np.array([7.0, *samples, 9.0], np.float32)
    table["Offset"], table["Count"] = np.array([0, 1, 1 + len(samples)]), np.array(
        [1, len(samples), 1]
    )
    arrays = {"points": make_arrays(3)["points"], "PulseIds": np.arange(3)}
    page = PageReader(webcloud.make_page(arrays, "a", tables=[table]))
    data = page.stream(page.meta["waveforms"]["firstStream"])
    *head, codes = decode(data, [3, 3, 3, 3, 3, None])
    peaks = head[3].astype(np.uint32).view(np.float32)
    found = codes[head[4][0] : -head[4][2]] * (peaks[1] / 4095)
    first = round((head[1][1] * 1e-4 - 101) / 0.25)
    whole = np.zeros(len(samples))
    whole[first : first + len(found)] = found
    assert np.allclose(whole, np.array(samples) if max(samples) > 0 else 0, atol=1e-3)
    assert len(found) <= np.count_nonzero(samples) + 2 or max(samples) <= 0


def test_errors(make_arrays):
    with pytest.raises(ValueError, match="the cloud has no points"):
        webcloud.make_page({"points": np.zeros((0, 3))}, "a")
    with pytest.raises(KeyError, match="no array Rnge; the cloud has: Height, Range"):
        webcloud.make_page(make_arrays(10), "a", colour_by="Rnge")


def test_pages_are_repeatable(make_arrays):
    first, second = (webcloud.make_page(make_arrays(3000), "a") for _ in range(2))
    assert first == second and sys.getsizeof(first) < 700_000
