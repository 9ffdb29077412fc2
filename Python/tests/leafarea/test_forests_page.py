# SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
# SPDX-License-Identifier: BSD-3-Clause
"""The commands of Docs/forests.md run as they are written, on a survey of fewer pulses."""

import json
import pathlib
import re
import shlex

import pytest

import vtkhelios
from vtkhelios import cli

PAGE = pathlib.Path(__file__).resolve().parents[3] / "Docs/forests.md"


def read_commands():
    block = re.search(r"```\n(vtkhelios new .*?)```", PAGE.read_text(), re.S)
    return [shlex.split(line)[1:] for line in block[1].splitlines()]


def test_commands_of_the_page(tmp_path, monkeypatch, capsys):
    pytest.importorskip("matplotlib")
    monkeypatch.chdir(tmp_path)
    commands = read_commands()
    assert [words[0] for words in commands] == ["new", "run", "leafarea", "leafarea"]
    found = []
    for words in commands:
        more = ["--json"] if words[0] == "leafarea" else []
        capsys.readouterr()
        assert cli.main([*words, *more]) == 0, words
        if more:
            found.append(json.loads(capsys.readouterr().out))
        if words[0] == "new":
            survey = tmp_path / "stand/stand.xml"
            text = survey.read_text()
            for step in ('verticalResolution_deg="0.28"', 'horizontalResolution_deg="0.51"'):
                assert step in text
                text = text.replace(step, step.replace("0.28", "1.2").replace("0.51", "2"))
            survey.write_text(text)
    plants, leaves = found
    assert plants["heights"] == "above ground" and plants["knowsMisses"]
    assert 1.0 < plants["lai"] < 3.0 and leaves["plantArea_m2"] < 0.95 * plants["plantArea_m2"]
    assert all((tmp_path / name).is_file() for name in ("found.vox", "found.vti", "profile.csv"))


def test_a_new_forest_ends_with_its_leaf_area(tmp_path, monkeypatch, capsys):
    """The commands that new prints run as they are written, and tell the trees of each echo."""
    monkeypatch.chdir(tmp_path)
    assert cli.main(["new", "a stand", "--kind", "forest"]) == 0
    lines = capsys.readouterr().out.split("to run it:\n")[1].splitlines()
    commands = [shlex.split(line) for line in lines]
    assert [words[:2] for words in commands] == [
        ["cd", "a stand"], ["vtkhelios", "run"], ["vtkhelios", "leafarea"],
    ]  # fmt: skip
    monkeypatch.chdir(tmp_path / commands[0][1])
    survey = tmp_path / "a stand/a stand.xml"
    survey.write_text(survey.read_text().replace('"0.28"', '"1.2"').replace('"0.51"', '"2"'))
    for words in commands[1:]:
        assert cli.main([*words[1:], "--quiet"] if words[1] == "run" else words[1:]) == 0
    assert "; LAI " in capsys.readouterr().out
    cloud = vtkhelios.read(str(tmp_path / "a stand/output/a stand"))
    is_tree = cloud["TreeIds"] > 0
    assert (cloud["PartIds"][is_tree] == cloud["TreeIds"][is_tree]).all()
    assert set(cloud["SpeciesIds"][is_tree]) == {0, 1} and set(cloud["OrganIds"][is_tree]) == {1, 2}
    assert set(cloud["ClassificationIds"][~is_tree]) == {2, 3}
