# SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
# SPDX-License-Identifier: BSD-3-Clause
"""A run that vtkHelios 0.2.0 wrote: a summary of version 1, with a play in the folder play001."""

import json
import pathlib
import shutil

import pytest

from vtkhelios import cli, formats
from vtkhelios.formats import FormatError
from vtkhelios.formats._summary import REPORT, read_summary

FORMER = pathlib.Path(__file__).with_name("former_run")
RUN = FORMER / "out/former/play001"


def test_summary_has_the_epoch():
    assert "play" in json.loads((RUN / "run_summary.json").read_text())["options"]
    options = read_summary(RUN / "run_summary.json", REPORT)["options"]
    assert options["epoch"] == 1 and "play" not in options


def test_points_are_read_and_converted(tmp_path, capsys):
    with formats.open_reader(RUN) as reader:
        assert sum(len(chunk["points"]) for chunk in reader.chunks()) == 39
    assert cli.main(["convert", str(RUN), str(tmp_path / "a.las")]) == 0
    with pytest.raises(FormatError) as error:
        formats.open_reader(RUN.parent)
    assert "holds several epochs; give the folder of one: epoch000" in str(error.value)


def test_report(tmp_path, capsys):
    pytest.importorskip("matplotlib")
    assert cli.main(["report", str(RUN), "--output", str(tmp_path / "page"), "--json"]) == 0
    assert json.loads(capsys.readouterr().out)["points"] == 39


def test_run_is_finished(tmp_path, capsys, monkeypatch):
    """Only versions may differ in its fingerprint."""
    shutil.copytree(FORMER, tmp_path / "here")
    monkeypatch.chdir(tmp_path / "here")
    code = cli.main(
        ["run", "survey.xml", "--output", "out", "--seed", "1", "--epoch", "1", "--resume"]
    )
    out, err = capsys.readouterr()
    assert (
        code == 0 and "Nothing is left to do" in out or "vtkHelios was" in err or "VTK was" in err
    )
    assert not any(f"{word} was" in err for word in ("play", "epoch", "summary"))
    assert not (tmp_path / "here/out/former/epoch001").exists()
