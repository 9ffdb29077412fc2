# SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
# SPDX-License-Identifier: BSD-3-Clause
"""The examples run, and do what they say."""

import importlib.util
import pathlib
import re

import pytest

EXAMPLES = pathlib.Path(__file__).resolve().parents[1] / "examples"


def load(name):
    spec = importlib.util.spec_from_file_location(name, EXAMPLES / f"{name}.py")
    module = importlib.util.module_from_spec(spec)
    spec.loader.exec_module(module)
    return module


def test_survey_by_hand(capsys):
    columns = load("survey_by_hand").main()
    said = capsys.readouterr().out
    assert "400,000 pulses" in said
    noise = float(re.search(r"range noise: ([\d.]+) mm", said).group(1))
    assert noise == pytest.approx(5.0, rel=0.05)
    assert not columns["points"].flags.owndata
    assert columns["Range"].min() >= 0.5


def test_plan_scans(capsys):
    predicted, simulated = load("plan_scans").main()
    said = capsys.readouterr().out
    assert 0.95 <= predicted < 1 and abs(predicted - simulated) < 0.02
    scans, least = (int(n) for n in re.search(r"(\d+) scans, at least (\d+);", said).groups())
    assert least <= scans == said.count("test points more")


def test_paper_pyramid():
    plans = load("paper_pyramid").main()
    by_size = sorted(map(tuple, plans["ViewshedSize"]))
    assert by_size == [(-2, 10, 1.5), (0, 0, 3.9375), (10, -2, 1.5)]
    assert sorted(map(tuple, plans["MeanIncidenceAngle"])) == [(-10, -10, 1.5), (10, 10, 1.5)]


def test_pcl_filters():
    pytest.importorskip("vtkhelios.pcl")
    results = load("pcl_filters").main()
    assert results["error"] < 1e-3
    assert results["right"] > 0.95
    assert results["ground plane"] == pytest.approx((0, 0, 1, 0), abs=1e-3)
    assert not results["cloud"].points.flags.owndata


def test_every_example_is_tested():
    text = pathlib.Path(__file__).read_text()
    for path in EXAMPLES.glob("*.py"):
        assert f"test_{path.stem}" in text, path.name
