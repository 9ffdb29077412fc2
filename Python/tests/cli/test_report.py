# SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
# SPDX-License-Identifier: BSD-3-Clause
"""vtkhelios report: its numbers against closed forms, and the page."""

import base64
import html.parser
import json
import shutil
import sys

import numpy as np
import pytest

from vtkhelios import cli, formats
from vtkhelios.reports.raster import Histogram, Raster

SIDE = 256


@pytest.fixture
def report(capsys):
    """Makes a report and returns (exit code, numbers, standard error)."""
    pytest.importorskip("matplotlib")

    def call(*arguments):
        capsys.readouterr()
        code = cli.main(["report", *map(str, arguments), "--json"])
        out, err = capsys.readouterr()
        return code, json.loads(out) if out else None, err

    return call


# Rasters and histograms


@pytest.mark.parametrize("chunks", [1, 7])
def test_cells_of_a_size(chunks):
    points = np.random.default_rng(1).uniform([-30, 400], [70, 450], (20_000, 2))
    raster = Raster(cell=2.5)
    for part in np.array_split(points, chunks):
        assert raster.add(part, 0)
    west, east, south, north = raster.box
    assert (west, east, south, north) == (-30.0, 70.0, 400.0, 450.0)
    expected, _, _ = np.histogram2d(points[:, 1], points[:, 0], (20, 40), ((400, 450), (-30, 70)))
    assert np.array_equal(raster.counts, expected)
    assert not Raster(cell=1e-3).add(points, 0)  # more cells than allowed


@pytest.mark.parametrize("shift", [0.0, 5_473_000.3])
def test_joined_cells(shift):
    """The cells have the last size, in any order."""
    random = np.random.default_rng(2)
    parts = [random.uniform(0, size, (500, 2)) + shift for size in (0.01, 1.0, 300.0, 900.0)]
    for order in (parts, parts[::-1]):
        raster = Raster(limit=512)
        for scan, part in enumerate(order):
            raster.add(part, scan)
        assert raster.cell == 2.0 and raster.counts.sum() == 2000
        whole = Raster(cell=2.0)
        whole.add(np.concatenate(parts), 0)
        assert np.array_equal(raster.counts, whole.counts) and raster.box == whole.box


def test_scans_that_saw_a_cell():
    """Also for more scans than bits, and after cells are merged."""
    raster = Raster(limit=64)
    for scan in range(130):
        raster.add(np.array([[0.5, 0.5], [10.0 * scan + 0.5, 100.5]]), scan)
    assert raster.scans()[0, 0] == 130 and raster.cell == 32.0
    assert raster.scans().max() == 130 and raster.scans()[-1, -1] in (1, 2, 3)


def test_coverage_of_a_slanting_strip():
    """Cells outside the strip do not count; a hole of a tenth of it does."""
    y, x = np.mgrid[0:200, 0:400]
    keep = np.abs(x - y - 100) < 40
    hole = (np.abs(x - 200) < 10) & (np.abs(y - 100) < 10)
    points = np.column_stack([x[keep & ~hole], y[keep & ~hole]]) + 0.5
    raster = Raster(cell=1.0)
    raster.add(points, 0)
    assert raster.coverage() == pytest.approx(1 - (keep & hole).sum() / keep.sum(), abs=2e-3)


def test_histograms():
    values = np.random.default_rng(3).normal(-5.0, 30.0, 100_000)
    histogram = Histogram(0.01)
    for part in np.array_split(values, 13):
        histogram.add(part)
    assert histogram.counts.sum() == 100_000 and len(histogram.counts) <= 4096
    for share in (0.01, 0.5, 0.99):
        assert histogram.quantile(share) == pytest.approx(
            np.quantile(values, share), abs=2 * histogram.width
        )
    edges, counts = histogram.merged(50)
    assert len(counts) <= 51 and np.array_equal(np.histogram(values, edges)[0], counts)
    assert np.isnan(Histogram(1.0).quantile(0.5))


# Reports


def make_run(folder, strips):
    """A run without a scanner: points of strips as text, with a summary."""
    folder.mkdir()
    legs = []
    for leg, points in enumerate(strips):
        name = f"leg{leg:03}_points.xyz"
        with formats.open_writer(folder / name) as writer:
            count = len(points)
            writer.write({
                "points": points, "GpsTime": np.linspace(leg, leg + 1, count),
                "ReturnNumber": np.ones(count, np.uint8), "Amplitude": np.full(count, 1e-8),
                "NumberOfReturns": np.ones(count, np.uint8), "EchoWidth": np.full(count, 4.0),
                "ClassificationIds": np.full(count, 2, np.int32),
                "PulseIds": np.arange(count, dtype=np.int64), "PartIds": np.zeros(count, np.int32),
            })  # fmt: skip
        (folder / f"leg{leg:03}_trajectory.txt").write_text(
            f"0.0 0.0 100.0 {leg}.0 0.0 0.0 0.0\n0.0 0.0 100.0 {leg + 1}.0 0.0 0.0 0.0\n"
        )
        legs.append({
            "leg": leg, "points": count, "pulsesFired": 2 * count, "pulsesHit": count,
            "start_s": leg, "duration_s": 1.0, "firstReturns": count, "pulses": 2 * count,
            "files": [{"name": name, "records": count, "bytes": 1}],
        })  # fmt: skip
    total = sum(leg["points"] for leg in legs)
    summary = {
        "survey": "strips <&>", "legs": legs, "inputs": [
            {"file": "survey.xml", "bytes": 12345, "sha256": "0123456789abcdef" * 4}],
        "options": {"seed": 0}, "rayCaster": "bvh", "sampling": "1 sub-ray", "scene": "ab" * 32,
        "timings": {"legs_s": [0.5] * len(legs), "load_s": 0.1, "run_s": 1.0, "threads": 2},
        "totals": {"points": total, "pulsesFired": 2 * total, "pulsesHit": total, "pulsesBinned": 0,
                   "pulsesOnPlane": total, "pulsesWithoutBins": 0, "subRays": total},
        "versions": {"VTK": "9.1.0", "vtkHelios": "0.1.0"},
    }  # fmt: skip
    (folder / "run_summary.json").write_text(json.dumps(summary))
    return folder


def strip(west, east):
    """Four points per cell of 1 m, 100 m long, at z 0."""
    x, y = np.meshgrid(np.arange(west, east, 0.5) + 0.25, np.arange(0, 100, 0.5) + 0.25)
    return np.column_stack([x.ravel(), y.ravel(), np.zeros(x.size)])


def test_numbers_of_two_strips(tmp_path, report):
    """60 and 60 m wide, with an overlap of 20 m."""
    run = make_run(tmp_path / "run", [strip(-50, 10), strip(-10, 50)])
    code, numbers, _ = report(run, "--cell", 1)
    assert code == 0
    assert numbers["points"] == 2 * 60 * 100 * 4
    assert numbers["overlap"] == pytest.approx(20 / 100)
    assert numbers["coverage"] == 1.0
    assert numbers["density_per_m2"] == pytest.approx(4 * 120 / 100)
    assert numbers["echoesPerPulse"] == {"1": numbers["points"]}
    assert numbers["medians"]["amplitude"] == pytest.approx(10.0, abs=0.3)  # dB above 1 nW
    distances = np.linalg.norm(
        np.concatenate([strip(-50, 10), strip(-10, 50)]) - [0, 0, 100], axis=1
    )
    assert numbers["medians"]["range"] == pytest.approx(np.median(distances), abs=0.1)
    assert numbers["pointsOfFiles"] == [24_000, 24_000]


class Page(html.parser.HTMLParser):
    """The pictures and text of a page; fails if tags do not match."""

    def __init__(self, text):
        super().__init__()
        self.pictures, self.words, self.open = {}, [], []
        self.feed(text)
        assert not self.open

    def handle_starttag(self, tag, attributes):
        attributes = dict(attributes)
        if tag == "img":
            kind, data = attributes["src"].split(",")
            assert kind == "data:image/png;base64" and attributes["alt"]
            self.pictures[attributes["alt"]] = base64.b64decode(data)
        elif tag != "meta":
            assert tag not in ("script", "link", "iframe")
            self.open.append(tag)

    def handle_endtag(self, tag):
        assert self.open.pop() == tag

    def handle_data(self, data):
        self.words.append(data)


def test_the_page(small_runs, tmp_path, report, read_pixels):
    run = tmp_path / "run"
    shutil.copytree(small_runs["vtp"], run)
    code, numbers, _ = report(run)
    text = (run / "report.html").read_text()
    page = Page(text)
    words = " ".join(page.words)
    assert "http" not in text  # requires no network
    summary = json.loads((run / "run_summary.json").read_text())
    for each in summary["inputs"]:
        assert each["sha256"] in words and each["file"] in words
    for leg in summary["legs"]:
        assert f"{leg['points']:,}" in words
    assert f"{numbers['points']:,}" in words and summary["scene"] in words
    assert len(page.pictures) == 8
    for start in ("map of the density", "map of the overlap", "Range: histogram, median",
                  "Angle of incidence", "Amplitude", "Echo width", "pulses by", "points by"):  # fmt: skip
        assert any(alt.startswith(start) for alt in page.pictures), start
    for alt, data in page.pictures.items():
        (tmp_path / "p.png").write_bytes(data)
        pixels = read_pixels(tmp_path / "p.png")
        height, width, _ = pixels.shape
        assert width > 700 and height > 200
        dark = (pixels.sum(axis=2) < 600).mean()
        assert 0.005 < dark < 0.9, alt  # not empty, on white
    assert len(text) < 2_000_000


def test_text_has_no_incidence(small_runs, tmp_path, report):
    code, numbers, _ = report(small_runs["xyz"], "--output", tmp_path / "r.html")
    assert code == 0
    text = (tmp_path / "r.html").read_text()
    assert "Not in the files of this run: angle of incidence." in text
    assert "distance to the platform: text files have no ranges" in text
    _, others, _ = report(small_runs["las"], "--output", tmp_path / "s.html")
    assert "incidence" in others["medians"] and "incidence" not in numbers["medians"]
    assert numbers["medians"]["range"] == pytest.approx(others["medians"]["range"], rel=0.1)
    for name in ("coverage", "overlap", "points", "classes", "echoesPerPulse"):
        assert numbers[name] == pytest.approx(others[name], rel=1e-3)


def test_names_are_escaped(tmp_path, report):
    run = make_run(tmp_path / "run", [strip(0, 10)])
    assert report(run)[0] == 0
    text = (run / "report.html").read_text()
    assert "strips &lt;&amp;&gt;" in text and "strips <&>" not in text
    assert "Overlap" not in text  # it has one leg


def test_summary_texts_are_escaped(tmp_path, report):
    """A script in every text, and in the option keys."""
    script = "<script>alert('x')</script><img src=x onerror=alert(1)>\"'&"
    run = make_run(tmp_path / "run", [strip(0, 10)])

    def doctored(value, key=None):
        if isinstance(value, dict):
            return {name: doctored(each, name) for name, each in value.items()}
        if isinstance(value, list):
            return [doctored(each) for each in value]
        return script + value if isinstance(value, str) and key != "name" else value

    summary = doctored(json.loads((run / "run_summary.json").read_text()))
    summary["options"][script] = script
    (run / "run_summary.json").write_text(json.dumps(summary))
    assert report(run)[0] == 0
    text = (run / "report.html").read_text()
    page = Page(text)  # contains no script element
    assert len(page.pictures) == text.count("<img ")
    assert "<script" not in text and " ".join(page.words).count(script) == 11


@pytest.mark.parametrize("scale", [1e-300, 1e-9, 1.0, 1e6, 1e11])
@pytest.mark.parametrize("shift", [0.0, 1e9, 3e11])
def test_rasters_of_any_extent(scale, shift):
    raster = Raster()
    points = scale * np.random.default_rng(4).uniform(-1, 1, (1000, 2)) + shift
    for scan, part in enumerate([points[:1], points[:1], points]):
        assert raster.add(part, scan)
    assert raster.counts.sum() == 1002 and raster.counts.size <= 512 * 512
    assert 0 < raster.coverage() <= 1 and np.isfinite(raster.box).all()


def test_cells_are_limited_in_all():
    """Long and narrow is allowed, long and wide is not."""
    assert Raster(cell=1.0).add(np.array([[0.0, 0.0], [19_999.0, 800.0]]), 0)
    assert not Raster(cell=1.0).add(np.array([[0.0, 0.0], [19_999.0, 19_999.0]]), 0)


@pytest.mark.parametrize("scale", [1e-300, 1.0, 1e11])
def test_reports_of_any_extent(tmp_path, report, scale):
    """One point, equal points, and distant ones."""
    for name, points in {
        "one": np.full((1, 3), scale), "equal": np.full((50, 3), scale),
        "apart": scale * np.array([[-1.0, -1.0, 0.0], [1.0, 2.0, 3.0]]),
    }.items():  # fmt: skip
        run = make_run(tmp_path / name, [points])
        code, numbers, err = report(run)
        assert code == 0 and numbers["points"] == len(points), err
        assert "Warning" not in err


def test_distant_points(tmp_path, report):
    run = make_run(tmp_path / "run", [np.array([[0.0, 0.0, 0.0], [0.0, -1e300, 0.0]])])
    code, _, err = report(run)
    assert code == 1
    assert "has points more than 1e+12 m from the origin, up to 1e+300 m; run the survey" in err


def test_histograms_of_anything():
    histogram = Histogram(0.005)
    histogram.add(np.array([np.nan, np.inf, -np.inf, 1e300, -1e300, 1e11, 5e-324, 2.0]))
    assert histogram.counts.sum() == 3 and len(histogram.counts) <= 4096


def test_memory_is_bounded():
    """Neither cells nor bins grow with the number of points."""
    raster, histogram = Raster(), Histogram(0.01)
    random = np.random.default_rng(5)
    for _ in range(20):
        raster.add(random.normal(0, 1000, (50_000, 2)), 0)
        histogram.add(random.exponential(1e6, 50_000))
    assert raster.counts.size <= 512 * 512 and len(histogram.counts) <= 4096


@pytest.mark.parametrize(
    "name, message",
    [
        ("none", "none: no such folder; give the folder of a run"),
        ("file", "file: is a file; give the folder of a run"),
        ("empty", "empty: is a folder without run_summary.json"),
    ],
)
def test_paths_that_are_not_runs(tmp_path, report, name, message):
    (tmp_path / "file").write_text("")
    (tmp_path / "empty").mkdir()
    code, _, err = report(tmp_path / name)
    assert code == 1 and message in err


def test_other_errors(tmp_path, report, capsys):
    run = make_run(tmp_path / "run", [strip(0, 50)])
    code, _, err = report(run, "--cell", 0.001)
    assert code == 1 and "the maps would be too large with cells of 0.001 m; give a larger" in err
    assert not list(run.glob("report*"))
    (run / "report.html").write_text("mine")
    code, _, err = report(run)
    assert code == 1 and "report.html: already exists; give --overwrite" in err
    assert report(run, "--overwrite")[0] == 0
    (run / "leg000_points.xyz").write_text("nan 0 0 1 4 1 1 0 0 0 0\n")
    code, _, err = report(run, "--overwrite")
    assert code == 1 and "has points that are not finite; run the survey again" in err
    (run / "leg000_points.xyz").unlink()
    code, _, err = report(run, "--overwrite")
    assert code == 1 and "leg000_points.xyz: no such file; check its name" in err
    with pytest.raises(SystemExit):
        cli.main(["report", str(run), "--cell", "x"])
    assert "'x' is not a number from 0.001 to 100000" in capsys.readouterr().err


@pytest.mark.parametrize("package", ["matplotlib", "jinja2"])
def test_without_a_package(tmp_path, monkeypatch, capsys, package):
    run = make_run(tmp_path / "run", [strip(0, 10)])
    monkeypatch.setitem(sys.modules, package, None)
    assert cli.main(["report", str(run)]) == 1
    err = capsys.readouterr().err
    assert (
        f"need the package {package}, which is not installed: apt-get install python3-{package}"
        in err
    )
    assert not (run / "report.html").exists()
