# SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
# SPDX-License-Identifier: BSD-3-Clause
"""Docs/from-helios.md: options exist, and what it says of pyhelios is so."""

import pathlib
import re

import pytest

from vtkhelios.cli import make_parser
from vtkhelios.compat import pyhelios
from vtkhelios.compat.pyhelios import _scene, _survey

PAGE = (pathlib.Path(__file__).resolve().parents[3] / "Docs/from-helios.md").read_text()
NAMES = re.compile(r"`(\w+)`")


def read_rows(title, columns):
    """The rows of the table with this first cell of its head, as lists of cells."""
    table = re.search(rf"^\| `?{title}`? \|.*\n\|---.*\n((?:\|.*\n)+)", PAGE, re.M).group(1)
    rows = [[cell.strip() for cell in row[1:-1].split(" | ")] for row in table.splitlines()]
    return [row + [""] * (columns - len(row)) for row in rows]


@pytest.fixture
def owners(make_survey, tmp_path):
    """The objects of the table."""
    builder = pyhelios.SimulationBuilder(str(make_survey()), [], tmp_path)
    build = builder.build()
    leg = build.sim.getLeg(0)
    return {
        "pyhelios": pyhelios,
        "SimulationBuilder": builder,
        "SimulationBuild": build,
        "Simulation": build.sim,
        "Survey": build.sim.getSurvey(),
        "Leg": leg,
        "PlatformSettings": leg.getPlatformSettings(),
        "ScannerSettings": leg.getScannerSettings(),
        "Scanner": build.sim.getScanner(),
        "Platform": build.sim.getPlatform(),
        "Scene": build.sim.getScene(),
    }


def test_the_table_of_names(owners):
    rows = {NAMES.match(row[0])[1]: row[1:] for row in read_rows("object", 3)}
    assert rows.keys() == owners.keys()
    for owner, (covered, missing) in rows.items():
        for name in NAMES.findall(covered):
            assert hasattr(owners[owner], name), f"{owner}.{name}"
        for name in NAMES.findall(missing):
            if not missing.startswith("True for"):  # setters whose True is refused
                with pytest.raises(
                    pyhelios.NotCoveredError, match=f"{owner}.{name} is not covered"
                ):
                    getattr(owners[owner], name)


def test_all_settings_are_in_the_table():
    rows = {NAMES.match(row[0])[1]: row[1] for row in read_rows("object", 3)}
    for kind in (_survey.PlatformSettings, _survey.ScannerSettings, _survey.Scanner):
        listed = {
            kind.SETTINGS[name]
            for name in NAMES.findall(rows[kind.__name__])
            if name in kind.SETTINGS
        }
        assert listed == set(kind.SETTINGS.values())
    public = {name for name in vars(_scene.SceneView) if re.match("get[A-Z]", name)}
    assert public <= set(NAMES.findall(rows["Scene"]))


def test_options_of_the_other_column_exist():
    subparsers = make_parser(["run"])._subparsers._group_actions[0]
    known = subparsers.choices["run"]._option_string_actions
    named = re.findall(r"--[a-z-]+", " ".join(row[1] for row in read_rows("helios", 3)))
    assert len(named) > 10
    assert [name for name in named if name not in known] == []


def test_the_script_runs(make_survey, tmp_path, monkeypatch, capsys):
    script = re.search(r"```python\n(from vtkhelios.compat.*?)```", PAGE, re.S).group(1)
    make_survey()
    monkeypatch.chdir(tmp_path)
    monkeypatch.setattr("vtkhelios.compat.pyhelios._simulation._seed", "")
    values = {}
    exec(compile(script, "from-helios.md", "exec"), values)
    assert values["measurements"].shape[1] == 17
    assert capsys.readouterr().out == f"{len(values['measurements'])}\n"
    assert len(list(tmp_path.glob("output/plane/*/leg000_points.las"))) == 1
