# SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
# SPDX-License-Identifier: BSD-3-Clause
"""vtkhelios plan --als: files, texts, check and errors."""

import json
import re

import numpy as np
import pytest

import vtkhelios
from vtkhelios.cli import main

GROUND = "\n".join(
    [*(f"v {x} {y} 0" for x, y in ((-50, -50), (150, -50), (150, 150), (-50, 150))), "f 1 2 3 4"]
)
FLIGHT = ["--als", "--scanner", "copter_uls", "--flying-height", "50", "--density", "6"]
AREA = "POLYGON ((0 0, 100 0, 100 80, 0 80))"


@pytest.fixture
def plan(tmp_path, capsys, monkeypatch):
    """Plans in a folder with ground.obj; returns exit code, standard output and error."""
    monkeypatch.chdir(tmp_path)
    (tmp_path / "ground.obj").write_text(GROUND + "\n")

    def call(*arguments):
        code = main(["plan", "ground.obj", *map(str, arguments)])
        said = capsys.readouterr()
        return code, said.out, said.err

    return call


def test_files_check_and_page(plan, tmp_path):
    code, out, said = plan(*FLIGHT, "--area", AREA, "--check", "--json")
    assert code == 0, said
    report, folder = json.loads(out), tmp_path / "output/ground_als"
    assert json.loads((folder / "plan_summary.json").read_text()) == report
    assert sorted(report["files"]) == [
        "cells.vtp", "lines.csv", "lines.dxf", "lines.vtp", "plan.html", "plan.png", "survey.xml"
    ]  # fmt: skip
    assert report["kind"] == "flight" and report["settings"]["density_1_m2"] == 6
    assert report["settings"]["sideOverlap_percent"] == 20
    check = report["check"]
    assert check["empty"] == 0 and abs(check["bias_percent"]) < 2
    # The echoes equal the echoes in the files of the strips, counted by an independent sum.
    strips = [
        folder / f"check/ground_als/strip{i:03}_points.pvtp" for i in range(len(report["lines"]))
    ]
    assert all(path.exists() for path in strips)
    page = (folder / "plan.html").read_text()
    assert page.count("data:image/png;base64,") == 3 and "simulated mean density" in page
    settings = page.partition("<h2>Settings</h2>")[2]
    assert re.search(r">Half swath</td>\s*<td[^>]*>[\d.]{2,5} deg</td>", settings), settings
    assert re.search(r">Terrain following</td>\s*<td[^>]*>no</td>", settings)
    assert not re.search(r"\d\.\d{5}|_(deg|m|Hz)\b", re.sub("<[^>]*>", " ", settings))
    for words in (
        "on lines",
        "in turns",
        "next lower pulse frequency",
        "N is grid north",
        "which states no",
    ):
        assert words in page, words
    assert f"<b>{len(report['lines'])}</b><span>flight line" in page
    assert (folder / "plan.png").read_bytes().startswith(b"\x89PNG")
    survey = vtkhelios.read_survey(folder / "survey.xml")
    assert survey.legs[0].position[2] == pytest.approx(50 + 0.2)  # the scanner hangs below


def test_texts(plan):
    code, out, said = plan(*FLIGHT, "--area", AREA, "--no-picture")
    assert code == 0, said
    assert out.split("\n")[0].split() == [
        "line", "x0", "[m]", "y0", "[m]", "x1", "[m]", "y1", "[m]", "z", "[m]", "heading", "[deg]",
        "length", "[m]", "time", "[s]",
    ] or "heading [deg]" in out  # fmt: skip
    for words in ("plan     ground_als (ground.obj), airborne", "flight   ", "density  of a strip at least",
                  "covered  100.00 % of 8,000 m²", "run it   vtkhelios run output/ground_als/survey.xml"):  # fmt: skip
        assert words in out + said
    code, _, said = plan(*FLIGHT, "--area", AREA, "--no-picture")
    assert code == 1 and "output/ground_als: holds the files of an earlier plan" in said


def test_the_survey_runs(plan, tmp_path):
    assert plan(*FLIGHT, "--area", AREA, "--no-picture")[0] == 0
    assert main(["run", "output/ground_als/survey.xml", "--no-noise", "--quiet"]) == 0
    files = sorted((tmp_path / "output/ground_als").glob("strip*_points.xyz"))
    points = np.concatenate([np.loadtxt(path, usecols=(0, 1, 2)) for path in files])
    assert abs(points[:, 2]).max() < 1e-3
    inside = (points[:, :2] > (10, 10)).all(axis=1) & (points[:, :2] < (90, 70)).all(axis=1)
    assert inside.sum() / (80 * 60) >= 6


def test_lines_are_written_for_terrain(plan):
    code, _, said = plan(*FLIGHT, "--area", AREA, "--terrain-following", "--no-picture", "--json")
    assert code == 0, said


@pytest.mark.parametrize(
    ("arguments", "message"),
    [
        (["--als", "--grid", "5"], "--grid is of plans of scan positions; leave it out, or --als"),
        (
            ["--flying-height", "5"],
            "--flying-height is of flight plans; add --als, or leave it out",
        ),
        (["--als"], "give --flying-height or --max-flying-height"),
        ([*FLIGHT, "--area", "nowhere.txt"], "--area nowhere.txt: cannot be read"),
        ([*FLIGHT, "--spacing", "1", "1"], "--density and --spacing are both given"),
        ([*FLIGHT, "--scanner", "nothing"], "nothing"),
        ([*FLIGHT, "--nohd", "80"], "the lowest height above the ground is 50 m, below 80 m"),
    ],
)
def test_errors(plan, arguments, message, tmp_path):
    code, _, said = plan(*arguments, "--no-picture")
    assert code in (1, 2) and message in said
    assert not (tmp_path / "output/ground_als/survey.xml").exists()


def test_what_is_not_reached_is_a_warning(plan, tmp_path):
    tower = "v 40 40 45\nv 60 40 45\nv 60 60 45\nv 40 60 45\nf 5 6 7 8\n"
    (tmp_path / "ground.obj").write_text(f"{GROUND}\n{tower}")
    code, _, said = plan(
        *FLIGHT[:3], "--flying-height", 60, "--density", 3, "--area", AREA, "--terrain-following",
        "--max-climb", 1, "--nohd", 40, "--no-picture", "--min-speed", 0.5,
    )  # fmt: skip
    assert code == 0 and "warning" in said.lower()
