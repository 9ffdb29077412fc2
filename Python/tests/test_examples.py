# SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
# SPDX-License-Identifier: BSD-3-Clause
"""The examples run, with correct results."""

import ast
import json
import pathlib
import re
import shutil

import _programs
import numpy as np
import pytest

import vtkhelios
from vtkhelios.example_surveys import write_example

EXAMPLES = pathlib.Path(__file__).resolve().parents[1] / "examples"


def load(name):
    return _programs.load(name, "examples")


def test_survey_by_hand(capsys):
    columns = load("survey_by_hand").main()
    said = capsys.readouterr().out
    assert "400,000 pulses" in said
    noise = float(re.search(r"range noise: ([\d.]+) mm", said).group(1))
    assert noise == pytest.approx(5.0, rel=0.05)
    assert not columns["points"].flags.owndata
    assert columns["Range"].min() >= 0.5


def test_own_detector():
    """The plug-in adds its detector; test_plugin.py runs surveys with it."""
    detection = vtkhelios.vtkHeliosEchoDetection
    load("own_detector")
    assert detection.RemoveDetector("largest")


def test_plan_scans(capsys):
    predicted, simulated = load("plan_scans").main()
    said = capsys.readouterr().out
    assert 0.95 <= predicted < 1 and abs(predicted - simulated) < 0.02
    scans, least = (int(n) for n in re.search(r"(\d+) scans, lower bound (\d+);", said).groups())
    assert least <= scans == said.count("more test points")


def test_paper_pyramid():
    plans = load("paper_pyramid").main()
    by_size = sorted(map(tuple, plans["ViewshedSize"]))
    assert by_size == [(-2, 10, 1.5), (0, 0, 3.9375), (10, -2, 1.5)]
    assert sorted(map(tuple, plans["MeanIncidenceAngle"])) == [(-10, -10, 1.5), (10, 10, 1.5)]


def test_next_position(capsys):
    shares = load("next_position").main()
    assert len(shares) == capsys.readouterr().out.count("scan ") == 5
    assert shares == sorted(shares) and shares[0] < 0.9 and shares[-1] > 0.97


def test_stream_blocks():
    example = load("stream_blocks")
    raster, survey = example.main()
    assert np.isfinite(raster).mean() > 0.9
    # A single block gives the same raster; medians of blocks differ slightly.
    whole = np.full_like(raster, -np.inf)
    cloud = survey.run(seed=1)
    example.add_heights(whole, cloud[cloud["ReturnNumber"] == 1])
    both = np.isfinite(raster) & np.isfinite(whole)
    assert np.median(np.abs(whole[both] - 0.5 - raster[both])) < 0.01


def test_dask_raster(tmp_path, capsys):
    pytest.importorskip("distributed")
    example = load("dask_raster")
    raster, survey = example.main(tmp_path)
    assert "10 blocks" in capsys.readouterr().out
    assert np.array_equal(raster, example.make_raster(survey.run(seed=1)))


@pytest.mark.parametrize("name", sorted(path.name for path in EXAMPLES.glob("*.ipynb")))
def test_notebook(name):
    namespace = run_notebook(EXAMPLES / name)
    if name == "first_survey.ipynb":
        assert namespace["noise"].std() == pytest.approx(0.005, rel=0.1)
    else:
        assert list(namespace["sizes"].values()) == sorted(
            namespace["sizes"].values(), reverse=True
        )
        assert "did you mean Range?" in namespace["message"]


def run_notebook(path):
    """Runs the cells in order, shows the output of Jupyter, and returns the names."""
    cells = json.loads(path.read_text())["cells"]
    assert all(not cell.get("outputs") for cell in cells), f"{path.name} has outputs; clear them"
    namespace = {"__name__": "__main__"}
    for number, cell in enumerate(cells):
        if cell["cell_type"] != "code":
            continue
        tree = ast.parse("".join(cell["source"]), f"{path.name}, cell {number}")
        shown = tree.body.pop().value if isinstance(tree.body[-1], ast.Expr) else None
        exec(compile(tree, tree_name := f"{path.name}, cell {number}", "exec"), namespace)
        if shown is not None:
            value = eval(compile(ast.Expression(shown), tree_name, "eval"), namespace)
            assert repr(value) and getattr(value, "_repr_html_", lambda: "-")()
    return namespace


def test_river_section(tmp_path):
    example = load("river_section")
    write_example("river", tmp_path / "river")
    cloud, trajectory = example.fly(tmp_path / "river", pulse_step=10)
    corrected = example.correct(cloud, trajectory, tmp_path / "river/water.obj")
    assert np.median(example.errors(cloud.points, cloud)) > 0.5
    assert np.median(example.errors(corrected.points, cloud)) < 0.05
    example.draw(cloud, corrected, tmp_path / "section.png")
    assert (tmp_path / "section.png").stat().st_size > 20_000


def test_street_traffic(tmp_path, capsys):
    pytest.importorskip("matplotlib")
    labels, boxes = load("street_traffic").main(tmp_path, pulse_step=8)
    said = capsys.readouterr().out
    assert {10, 40, 48, 50, 80, 252, 253, 254} <= set(labels.tolist())
    assert sum(box.moves for box in boxes) == 5 == said.count(" echoes, ")
    assert re.search(r"car1: \d+ echoes, 4.20 x 1.76 x 1.46 m", said)
    for name in ("street-velocity.png", "street-instances.png"):
        assert (tmp_path / name).stat().st_size > 10_000


def test_street_ghosts(tmp_path, capsys):
    example = load("street_ghosts")
    survey = vtkhelios.read_survey(example.write_survey(tmp_path / "street"))
    cloud = survey.run(truth=True, seed=1, pulse_step=20)
    kinds = example.classify(cloud)
    through, ghosts = kinds == 1, kinds == 2
    assert through.sum() > 500 and ghosts.sum() > 500
    # Mirrored by the shop front, y = 6: the houses opposite, y = -8, appear at y = 20.
    mirrored = ghosts & (np.abs(cloud["TruePoint"][:, 1] + 8) < 1e-3)
    assert mirrored.sum() > 100
    assert np.abs(cloud.points[mirrored & (cloud.points[:, 1] > 6), 1] - 20).max() < 0.1
    example.draw(cloud, kinds, tmp_path / "ghosts.png")
    assert (tmp_path / "ghosts.png").stat().st_size > 20_000


def test_figure_videos(make_survey, tmp_path):
    from vtkhelios.cli import view

    if view.find_viewer() is None or not shutil.which("Xvfb"):
        pytest.skip("the viewer or Xvfb is missing")
    survey = make_survey(speed=600)  # the village takes minutes
    look = ["--size", "160x120", "--camera", "orbit"]
    video, still = load("figure_videos").film(survey, tmp_path, 0.08, *look)
    assert video.read_bytes()[:4] == b"OggS"
    assert still.read_bytes()[1:4] == b"PNG"


def test_pcl_filters():
    pytest.importorskip("vtkhelios.pcl")
    results = load("pcl_filters").main()
    assert results["error"] < 1e-3
    assert results["right"] > 0.95
    assert results["ground plane"] == pytest.approx((0, 0, 1, 0), abs=1e-3)
    assert not results["cloud"].points.flags.owndata


def test_crop_field(tmp_path, capsys, read_pixels):
    from vtkhelios.reports import picture

    results = load("crop_field").main(tmp_path, rows=4, row_length=3.0, lines=50, speed=60)
    said = capsys.readouterr().out
    assert f"{results['plants']} plants" in said and 60 <= results["plants"] <= 76
    plants, leaves = results["seen"]
    assert plants > 0.9 and 0.1 < leaves < 0.9
    heights = results["cloud"].points[:, 2]
    assert heights.max() == pytest.approx(1.1, abs=0.2) and heights.min() > -0.1
    assert (tmp_path / "crop_field.obj").is_file()
    if picture.can_render():
        for name in ("scene", "cloud", "shadows"):
            assert np.ptp(read_pixels(tmp_path / f"{name}.png").reshape(-1, 3), axis=0).min() > 100


def test_every_example_is_tested():
    text = pathlib.Path(__file__).read_text()
    for path in EXAMPLES.glob("*.py"):
        assert f"test_{path.stem}" in text, path.name
