# SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
# SPDX-License-Identifier: BSD-3-Clause
"""Documents in YAML are those in XML: another parser reads the same names and values, and every command
takes them."""

import hashlib
import json
import os
import pathlib
import re
import shutil
import xml.etree.ElementTree as ElementTree

import pytest
import yaml

import vtkhelios
from vtkhelios import cli
from vtkhelios.core.reading import convert, read_xml
from vtkhelios.example_surveys import KINDS, write_example

ROOT = pathlib.Path(__file__).resolve().parents[3]
OTHERS = pathlib.Path(os.environ.get("HELIOS_DATA") or ROOT.parent / "shared/data") / "helios"
DOCUMENTS = [
    path
    for folder in (ROOT / "Data", OTHERS)
    for path in sorted(folder.rglob("*.xml"))
    if b"<document" in path.read_bytes()
]


def list_xml(element, path=()):
    """Yields the path and value of all that an element has; filters have the names of their types."""
    usual = element.tag == "filter" and len(element.attrib) == 1
    names = {} if usual or element.tag == "param" else element.attrib
    values = [(path + (name,), text) for name, text in names.items()]
    counts = {}
    for child in element:
        name = child.tag
        if child.tag == "filter":
            name = child.get("type")
        elif child.tag == "param":
            name = child.get("key")
        if "value" in child.attrib and child.tag == "param":
            values.append((path + (name,), child.get("value")))
        elif not child.attrib and not len(child) and (child.text or "").strip():
            values.append((path + (name,), child.text.strip()))
        else:
            counts[name] = counts.get(name, -1) + 1
            values.append((path + (name, counts[name]), None))
            values += list_xml(child, path + (name, counts[name]))
    return values


def list_yaml(mapping, path=()):
    """Yields the same for what PyYAML reads."""
    values = []
    for name, value in mapping.items():
        if isinstance(value[0] if isinstance(value, list) else value, str):
            values.append((path + (name,), value))
        else:
            for i, each in enumerate(value if isinstance(value, list) else [value]):
                values.append((path + (name, i), None))
                values += list_yaml(each, path + (name, i))
    return values


def plain(values):
    """Values in an order, lists of numbers without separators and blanks."""
    return sorted(
        (
            str(path),
            re.sub(r"[;,\s]+", " ", " ".join(text) if isinstance(text, list) else text or ""),
        )
        for path, text in values
    )


def write_xml(path, text):
    assert vtkhelios.vtkHeliosDialect().WriteXml(str(path), text)


@pytest.mark.parametrize("path", DOCUMENTS, ids=lambda path: path.name)
def test_another_parser_reads_the_same(path, tmp_path):
    write_xml(tmp_path / "a.yaml", path.read_bytes())
    text = (tmp_path / "a.yaml").read_text(encoding="utf-8")
    found = yaml.load(text, yaml.BaseLoader)  # all values as they are written
    wanted = ElementTree.parse(path).getroot()
    for element in wanted.iter("filter"):
        for param in element.iter("param"):
            param.attrib.pop("type", None)
    assert plain(list_yaml(found)) == plain(list_xml(wanted))
    # Words and numbers of texts are texts for a parser that guesses types, too.
    typed = yaml.safe_load(text)
    assert str(typed.get("survey", {}).get("name", "")) == found.get("survey", {}).get("name", "")
    write_xml(tmp_path / "b.yaml", read_xml(tmp_path / "a.yaml"))
    assert (tmp_path / "b.yaml").read_text(encoding="utf-8") == text


def test_the_page_shows_one_document_twice(tmp_path):
    page = (ROOT / "Docs/dialect.md").read_text(encoding="utf-8")
    wanted = re.search(r"```yaml\n(.*?)```", page, re.S)[1]
    xml = re.search(r"```xml\n(.*?)```", page.split("## YAML")[1], re.S)[1]
    write_xml(tmp_path / "a.yaml", xml.encode())
    assert (tmp_path / "a.yaml").read_text() == wanted


def digests(folder):
    return {
        path.name: hashlib.sha256(path.read_bytes()).hexdigest()
        for path in sorted(folder.rglob("*_points.*"))
    }


def rename(text):
    """Refers to the YAML files of a scene and a platform."""
    return re.sub(r"\b(scene|platform)\.xml#", r"\1.yaml#", text)


@pytest.mark.parametrize("kind", KINDS)
def test_examples_are_the_same_surveys(kind, tmp_path):
    write_example(kind, tmp_path / "a")
    shutil.copytree(tmp_path / "a", tmp_path / "b")
    for path in (tmp_path / "b").glob("*.xml"):
        text = path.read_text(encoding="utf-8")
        path.write_text(rename(text), encoding="utf-8")
        convert(path, path.with_suffix(".yaml"))
        path.unlink()
    surveys = [
        vtkhelios.read_survey(tmp_path / "a/a.xml"),
        vtkhelios.read_survey(tmp_path / "b/a.yaml"),
    ]
    for survey, name in zip(surveys, "ab"):
        survey.write(tmp_path / name / "written.yml")
    texts = [(tmp_path / name / "written.yml").read_text(encoding="utf-8") for name in "ab"]
    assert rename(texts[0]) == texts[1]


def test_a_run_has_the_same_bytes(make_survey, tmp_path, capsys):
    path = make_survey()
    for name in ("survey", "scene"):
        convert(path.with_name(f"{name}.xml"), path.with_name(f"{name}.yaml"))
    for number, ending in enumerate((".xml", ".yaml")):
        run = ["run", str(path.with_suffix(ending)), "--output", str(tmp_path / str(number))]
        assert cli.main([*run, "--seed", "3", "--format", "las", "--waveforms"]) == 0
    assert digests(tmp_path / "0") == digests(tmp_path / "1") != {}
    summary = json.loads(next((tmp_path / "1").rglob("*summary.json")).read_text())
    assert "survey.yaml" in json.dumps(summary)


def test_commands_take_yaml(make_survey, tmp_path, capsys):
    path = make_survey()
    folder = path.parent
    for name in ("survey", "scene"):
        assert cli.main(["convert", str(folder / f"{name}.xml"), str(folder / f"{name}.yaml")]) == 0
        (folder / f"{name}.xml").unlink()
    survey, scene = folder / "survey.yaml", folder / "scene.yaml"
    survey.write_text(survey.read_text().replace("scene.xml#", "scene.yaml#"))
    assert "written  " in capsys.readouterr().out

    assert cli.main(["validate", str(survey), str(scene), "--deep"]) == 0
    survey.write_text(survey.read_text().replace("scanFreq_hz: 100", "scanFreq_hz: fast"))
    capsys.readouterr()
    assert cli.main(["validate", str(survey), "--json"]) == 1
    (found,) = json.loads(capsys.readouterr().out)
    line = survey.read_text().splitlines()[found["line"] - 1]
    assert found["file"] == str(survey) and "scanFreq_hz: fast" in line
    assert 'scanFreq_hz="fast"' in found["message"]
    survey.write_text(survey.read_text().replace("scanFreq_hz: fast", "scanFreq_hz: 100"))

    assert cli.main(["info", str(survey), "--json"]) == 0
    facts = json.loads(capsys.readouterr().out)
    assert (facts["format"], facts["name"], len(facts["legs"])) == ("survey (YAML)", "plane", 1)
    assert cli.main(["info", str(scene), "--json"]) == 0
    facts = json.loads(capsys.readouterr().out)
    assert facts["format"] == "document (YAML)"
    assert facts["scenes"][0]["parts"][0]["files"] == ["plane.obj"]
    assert cli.main(["list", "scenes", "--assets", str(folder), "--json"]) == 0
    assert "scene.yaml#plane" in capsys.readouterr().out
    assert cli.main(["run", str(survey), "--dry-run", "--output", str(tmp_path / "o")]) == 0
    assert (
        cli.main(["view", str(survey), "--html", str(tmp_path / "page.html"), "--points", "100"])
        == 0
    )
    plan = [
        "plan",
        str(scene),
        "--output",
        str(tmp_path / "plan"),
        "--resolution",
        "40",
        "--grid",
        "100",
    ]
    assert cli.main(plan) == 0
    capsys.readouterr()
    with pytest.raises(SystemExit):
        cli.main([str(survey)])
    assert f"a command is missing: vtkhelios run {survey}" in capsys.readouterr().err


def test_catalogues_may_be_yaml(tmp_path, capsys):
    (tmp_path / "own.yaml").write_text("scanner: {id: mine, name: My own, optics: rotating}\n")
    assert cli.main(["info", "--scanners", "mine", "--assets", str(tmp_path)]) == 0
    assert "own.yaml#mine" in capsys.readouterr().out
    (tmp_path / "own.yaml").write_text("scanner: {id: mine, id: yours}\n")
    cli.main(["info", "--scanners", "mine", "--assets", str(tmp_path)])
    assert "own.yaml:1: <scanner> has id twice" in capsys.readouterr().err


def test_a_recommendation_is_applied_to_yaml(make_survey):
    from vtkhelios.cli.tradeoff import set_options

    path = make_survey()
    convert(path, path.with_suffix(".yaml"))
    target = path.with_name("fast.yml")
    survey = vtkhelios.read_survey(path.with_suffix(".yaml"))
    set_options(survey, {"tolerance": 0.01})
    survey.write(target)
    found = yaml.safe_load(target.read_text())
    assert found["survey"].pop("rangeTolerance_m") == 0.01
    assert found == yaml.safe_load(path.with_suffix(".yaml").read_text())
    vtkhelios.read_survey(target)


def test_convert_refuses_what_it_cannot_do(make_survey, capsys):
    path = make_survey()
    target = path.with_name("a.yaml")

    def expect(message, *arguments):
        assert cli.main(["convert", *map(str, arguments)]) == 1
        assert message in capsys.readouterr().err

    expect("none.xml: no such file or folder", path.with_name("none.xml"), target)
    expect("is one file for several documents; convert one by one", path, path, target)
    expect("is also an input; give another name", path, path)
    assert cli.main(["convert", str(path), str(target)]) == 0
    expect("a.yaml: already exists; give --overwrite to replace it", path, target)
    assert cli.main(["convert", str(path), str(target), "--overwrite"]) == 0
    capsys.readouterr()
    target.write_text("survey:\n  name: a\n  name: b\n")
    expect("a.yaml:3: <survey> has name twice", target, path.with_name("b.xml"))
    assert not path.with_name("b.xml").exists()
    expect("a.yaml: is a document, not points", target, path.with_name("b.las"))
    with pytest.raises(ValueError, match="a.yaml:3: <survey> has name twice"):
        read_xml(target)


def test_names_of_files_are_found_from_another_folder(make_survey):
    path = make_survey()
    (path.parent / "other").mkdir()
    convert(path.with_name("scene.xml"), path.parent / "other/scene.yaml")
    found = yaml.safe_load((path.parent / "other/scene.yaml").read_text())
    assert found["scene"]["part"]["objloader"]["filepath"] == str(path.with_name("plane.obj"))


def test_python_writes_yaml(make_survey):
    path = make_survey()
    survey = vtkhelios.read_survey(path)
    survey.legs[0].scan_frequency = 50
    path = path.with_name("changed.yaml")
    survey.write(path)
    assert vtkhelios.read_survey(path).legs[0].scan_frequency == 50
