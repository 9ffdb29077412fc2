# SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
# SPDX-License-Identifier: BSD-3-Clause
"""vtkhelios compare: inputs, table, page and JSON, errors, interrupts; real clouds."""

import html.parser
import json
import pathlib
import re
import signal
import sys

import numpy as np
import pytest

import vtkhelios
from vtkhelios import cli, formats
from vtkhelios.cli import compare

ROOT = pathlib.Path(__file__).resolve().parents[3]
REAL = next(
    (each / "shared/data/real" for each in ROOT.parents if (each / "shared/data/real").is_dir()),
    None,
)


def write(path, seed=0, count=20_000, shift=0.0, crs=""):
    random = np.random.default_rng(seed)
    points = random.uniform(0, 50, (count, 3)) * [1, 1, 0] + [0, 0, 0.3 + shift]
    points[:, 2] += random.normal(0, 0.01, count)
    header = formats.Header()
    header.crs = crs
    with formats.open_writer(path, header) as writer:
        writer.write({
            "points": points, "GpsTime": np.arange(count) * 1e-5,
            "ReturnNumber": np.ones(count, np.uint8), "NumberOfReturns": np.ones(count, np.uint8),
            "ClassificationIds": np.full(count, 2, np.int32), "Amplitude": np.full(count, 1e-8),
            "EchoWidth": np.full(count, 4.0),
            "PulseIds": np.arange(count, dtype=np.int64), "PartIds": np.zeros(count, np.int32),
        })  # fmt: skip
    return path


@pytest.fixture
def clouds(tmp_path):
    return write(tmp_path / "a.las", 1), write(tmp_path / "b.vtp", 2, shift=0.1)


def call(capsys, *arguments):
    capsys.readouterr()
    code = cli.main(["compare", *map(str, arguments)])
    return code, *capsys.readouterr()


def test_table(clouds, capsys):
    code, out, err = call(capsys, *clouds)
    assert code == 0
    assert re.search(r"^noise of planes, RMS +(9\.\d+|10\.?\d*) mm \[", out, re.M)
    found = re.search(r"^registration: (B is shifted.*?z \+0\.(\d+) m)", out, re.M)
    assert abs(int(found[2]) - 1000) < 10
    assert "x and y not determined by the planes" in out
    assert "not measured: classes: all points have class 2" in out
    assert "has no coordinate system; it is taken to be that of the other" in err


def test_json_is_that_of_the_package(clouds, capsys):
    code, out, _ = call(capsys, *clouds, "--json", "--sample", 100, "--seed", 3, "--cell", 1)
    assert code == 0
    same = vtkhelios.compare(*clouds, sample=100, seed=3, cell=1.0)
    assert json.loads(out) == json.loads(same.to_json())


class Reader(html.parser.HTMLParser):
    """The text of a page, its pictures, and whatever it would load."""

    def __init__(self):
        super().__init__()
        self.text, self.pictures, self.loads = "", 0, []

    def handle_starttag(self, tag, attributes):
        source = dict(attributes).get("src", "")
        self.pictures += source.startswith("data:image/png;base64,")
        if (source or dict(attributes).get("href")) and not source.startswith("data:"):
            self.loads.append(tag)

    def handle_data(self, data):
        self.text += data


def test_page(tmp_path, capsys):
    pytest.importorskip("matplotlib")
    pytest.importorskip("jinja2")
    first = write(tmp_path / "<b>&.las", 1)
    page = tmp_path / "new" / "page.html"
    arguments = first, write(tmp_path / "b.las", 2), "--output", page
    code, out, _ = call(capsys, *arguments)
    assert code == 0 and f"written  {page}, {page.with_suffix('.json')}" in out
    reader = Reader()
    reader.feed(page.read_text())
    assert "<b>&.las" in reader.text and "returns per pulse" in reader.text
    assert reader.pictures >= 4 and reader.loads == []
    assert json.loads(page.with_suffix(".json").read_text())["metrics"]
    code, _, err = call(capsys, *arguments)
    assert code == 1 and f"{page}: already exists; give --overwrite to replace it" in err
    assert call(capsys, *arguments, "--overwrite", "--quiet")[:2] == (0, "")


def test_runs_and_folders(small_runs, tmp_path, capsys):
    """A run, its files in a folder, and a folder of runs have the same points."""
    run = small_runs["las"]
    folder = tmp_path / "files"
    folder.mkdir()
    for path in run.glob("*_points.las"):
        (folder / path.name).write_bytes(path.read_bytes())
    code, out, _ = call(capsys, run, folder, "--json", "--sample", 1000)
    result = json.loads(out)
    assert code == 0 and result["a"]["points"] == result["b"]["points"] > 1000
    assert result["registration"].startswith("no shift found")
    rows = {row["metric"]: row for row in result["metrics"] if row["class"] is None}
    assert rows["returns per pulse"]["difference"] == 0 and rows["returns per pulse"]["a"] > 1
    (tmp_path / "runs").mkdir()
    (tmp_path / "runs/first").symlink_to(run)
    (tmp_path / "runs/notes.txt").write_text("not a cloud")
    code, out, _ = call(capsys, tmp_path / "runs", run, "--json", "--sample", 100)
    assert code == 0 and json.loads(out)["a"]["points"] == result["a"]["points"]


def test_errors(clouds, tmp_path, capsys):
    a, b = clouds
    (tmp_path / "empty").mkdir()
    for arguments, message in (
        ((a, tmp_path / "gone.las"), "gone.las: no such file or folder; check its name"),
        ((a, tmp_path / "empty"), "empty: is a folder without run_summary.json"),
        ((a, write(tmp_path / "a.txt.las", crs="EPSG:25832"), "--mesh", a), "is not a mesh of a"),
        ((a, b, "--output", "page.pdf"), "page.pdf: does not end in .html; give --output such"),
        (
            (a, b, "--output", a / "page.html"),
            "a.las: cannot be written: File exists; give another --output",
        ),
    ):
        code, out, err = call(capsys, *arguments, "--sample", 10, "--quiet")
        assert code == 1 and message in err and out == "" and "Traceback" not in err
    first = write(tmp_path / "c.las", crs="EPSG:25832")
    code, _, err = call(capsys, first, write(tmp_path / "d.las", crs="EPSG:25833"))
    assert code == 1 and "d.las: the coordinate systems of the clouds differ: EPSG:25832" in err
    both = tmp_path / "both"
    both.mkdir()
    write(both / "c.las", crs="EPSG:25832"), write(both / "d.las", crs="EPSG:25833")
    code, _, err = call(capsys, first, both)
    assert code == 1 and "both: its files have different coordinate systems: EPSG:25832" in err


def test_files_without_an_array_of_the_others(tmp_path, capsys):
    folder = tmp_path / "mixed"
    folder.mkdir()
    first = write(folder / "a.las")
    with formats.open_writer(folder / "b.vtp") as writer:
        writer.write({"points": np.random.default_rng(1).uniform(0, 50, (1000, 3))})
    code, _, err = call(capsys, folder, first)
    assert code == 0 and "mixed: not all of its files have GpsTime; it is not compared" in err


def test_a_sample_of_tiles_is_said(clouds, capsys):
    _, out, _ = call(capsys, *clouds, "--points", 5000)
    assert re.search(r"^sample   tiles drawn at random: 25 % of the ground", out, re.M)


def test_without_matplotlib(clouds, capsys, monkeypatch):
    monkeypatch.setitem(sys.modules, "matplotlib", None)
    code, _, err = call(capsys, *clouds, "--output", "page.html")
    assert (
        code == 1 and "charts need the package matplotlib, which is not installed: apt-get" in err
    )
    assert call(capsys, *clouds, "--quiet")[0] == 0


def test_interrupt_writes_nothing(clouds, tmp_path, capsys, monkeypatch):
    """Ctrl-C during the search for planes."""
    whole, page = compare.compare_watched, tmp_path / "page.html"

    def interrupted(a, b, on_step, **settings):
        def step(name, share):
            if name == "planes":
                signal.raise_signal(signal.SIGINT)
            on_step(name, share)

        return whole(a, b, step, **settings)

    monkeypatch.setattr(compare, "compare_watched", interrupted)
    code, out, err = call(capsys, *clouds, "--output", page)
    assert code == 130 and "interrupted; nothing was written" in err
    assert out == "" and not page.exists()


def test_help_teaches(capsys):
    with pytest.raises(SystemExit):
        cli.main(["compare", "--help"])
    text = capsys.readouterr().out
    for word in ("returns per pulse", "registration:", "intervals:", "examples:", "exit codes:"):
        assert word in text


# Real clouds


needs_real = pytest.mark.skipif(REAL is None, reason="no real data")


@needs_real
def test_one_real_scanner_over_two_forests():
    """bcts: 100 kHz and 65.02 Hz, the tiles are neighbours: spacing agrees, the forests do not."""
    result = vtkhelios.compare(REAL / "als/bcts_1.laz", REAL / "als/bcts_2.laz", sample=1000)
    assert result.registration == "not known: the clouds share no ground"
    for name in ("spacing along lines", "spacing across lines"):
        assert result[name].b.value == pytest.approx(result[name].a.value, rel=0.1)
    assert result["returns per pulse"].agrees is False


@needs_real
def test_a_real_cloud_shifted():
    path, shift = REAL / "als/ahn3_delft_1.laz", (0.12, -0.07, 0.05)
    with formats.open_reader(path) as reader:
        points = np.concatenate([chunk["points"] for chunk in reader.chunks()])
    result = vtkhelios.compare(points, points + shift, sample=1000)
    for found, truth in zip(result.shift, shift):
        assert found.value == pytest.approx(truth, abs=0.001)
