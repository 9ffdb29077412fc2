# SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
# SPDX-License-Identifier: BSD-3-Clause
"""vtkhelios list and help: what a survey may name, and the texts of the commands."""

import json
import xml.etree.ElementTree as ElementTree

import pytest

import vtkhelios
from vtkhelios import cli
from vtkhelios.catalogue import CatalogueError, find_platforms, find_scanners, find_scenes

SCENES = """\
<document>
  <scene id="yard" name="My yard"><part/><part/><partTable/></scene>
  <scene id="empty"/>
</document>
"""


def say(capsys, *words):
    """Returns the output of a command that succeeds."""
    assert cli.main([*map(str, words)]) == 0
    return capsys.readouterr().out


def test_scanners_are_those_of_info(capsys):
    text = say(capsys, "list", "scanners", "riegl", "terrestrial")
    assert text == say(capsys, "info", "--scanners", "riegl terrestrial")
    assert "scanners.xml#riegl_vz400 " in text
    assert "vtkhelios instrument writes the scanner of an Ouster sensor from its metadata" in text
    facts = json.loads(say(capsys, "list", "scanners", "--json"))["scanners"]
    assert len(facts) == len(find_scanners())


def test_platforms_are_those_of_the_file(capsys):
    path = vtkhelios.data_directory() / "Assets/platforms.xml"
    ids = [each.get("id") for each in ElementTree.parse(path).iter("platform")]
    rows = say(capsys, "list", "platforms").splitlines()
    assert [row.split()[0] for row in rows[1:-1]] == [f"platforms.xml#{name}" for name in ids]
    facts = json.loads(say(capsys, "list", "platforms", "TRIPOD", "--json"))["platforms"]
    assert facts == [
        {
            "reference": "platforms.xml#tripod",
            "id": "tripod",
            "name": "Tripod",
            "type": "static",
            "mount_m": [0.0, 0.0, 1.5],
        }
    ]


def test_scenes_are_those_of_folders(tmp_path, monkeypatch, capsys):
    (tmp_path / "more").mkdir()
    (tmp_path / "more/scenes.xml").write_text(SCENES)
    monkeypatch.chdir(tmp_path)
    rows = say(capsys, "list", "scenes").splitlines()
    assert rows[1].split() == ["more/scenes.xml#yard", "My", "yard", "2", "1"]
    assert rows[3].startswith("2 scenes. ")
    assert "scenes.xml#yard " in say(capsys, "list", "scenes", "my", "--assets", "more")
    assert find_scenes("empty")[0].reference == "more/scenes.xml#empty"


def test_nothing_found_names_the_cure(tmp_path, monkeypatch, capsys):
    monkeypatch.chdir(tmp_path)
    assert cli.main(["list", "scenes"]) == 1
    assert "no scene in the XML files of the working directory" in capsys.readouterr().err
    assert cli.main(["list", "scenes", "x"]) == 1
    assert 'no scene with "x" in its id or name' in capsys.readouterr().err
    assert cli.main(["list", "platforms", "balloon"]) == 1
    assert '"balloon": no platform has all these words' in capsys.readouterr().err
    assert cli.main(["list", "scanners", "balloon"]) == 1
    assert "vtkhelios instrument makes one from a manufacturer's file" in capsys.readouterr().err
    assert cli.main(["list", "scanners", "x", "--assets", "none"]) == 1
    assert "--assets none: no such folder" in capsys.readouterr().err
    with pytest.raises(SystemExit):
        cli.main(["list", "scaners"])
    assert "did you mean scanners?" in capsys.readouterr().err


def test_unreadable_files_are_warnings(tmp_path, capsys):
    (tmp_path / "bad.xml").write_text("<document>")
    (tmp_path / "mount.xml").write_text(
        '<document><platform id="a"><scannerMount x="1,5"/></platform></document>'
    )
    text = say(capsys, "list", "platforms", "tripod", "--assets", tmp_path)
    assert text.count("\n") == 3
    with pytest.raises(CatalogueError, match="bad.xml: is not readable XML"):
        find_platforms(assets=[tmp_path])
    (tmp_path / "bad.xml").unlink()
    with pytest.raises(
        CatalogueError, match="mount.xml: platform a: its scannerMount is not valid"
    ):
        find_platforms(assets=[tmp_path])


def end_of(capsys, *words):
    """Returns the output of a command that ends by argparse."""
    with pytest.raises(SystemExit) as end:
        cli.main([*words])
    assert end.value.code == 0
    return capsys.readouterr().out


def test_help_is_that_of_the_command(capsys):
    assert end_of(capsys, "help", "run") == end_of(capsys, "run", "--help")
    assert end_of(capsys, "help") == end_of(capsys, "--help")


def test_help_of_an_unknown_command_names_the_nearest(capsys):
    with pytest.raises(SystemExit) as end:
        cli.main(["help", "converted"])
    assert end.value.code == 2
    assert "did you mean convert?" in capsys.readouterr().err
