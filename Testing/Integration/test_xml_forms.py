# SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
# SPDX-License-Identifier: BSD-3-Clause
"""XML is a tree: documents with and without line breaks, with comments, CDATA, a DOCTYPE and other
orders of attributes and elements give the same survey and the same points."""

import json
import os
import pathlib
import re
import shutil
import xml.etree.ElementTree as ElementTree
from xml.sax.saxutils import escape, quoteattr

import pytest

import vtkhelios
from vtkhelios import cli
from vtkhelios.example_surveys import KINDS, write_example
from vtkhelios.vtkHeliosScannerSurvey import vtkHeliosSurvey, vtkHeliosSurveyReader

ROOT = pathlib.Path(__file__).resolve().parents[2]
DATA = vtkhelios.data_directory()
OTHERS = pathlib.Path(os.environ.get("HELIOS_DATA") or ROOT.parent / "shared/data") / "helios"
GROUND = "v -100 -100 0\nv 100 -100 0\nv 100 100 0\nv -100 100 0\nf 1 2 3 4\n"
SCENE = """<document><scene id="village" name="village"><part><filter type="objloader">
<param type="string" key="filepath" value="ground.obj"/></filter></part></scene></document>"""

# Two scanners and two platforms, each with settings of its own, for one leg each.
TWO = """<document>
<scannerSettings id="common" active="true" scanFreq_hz="50"/>
<platform id="low" name="low" type="static"><scannerMount x="0" y="0" z="1.5"/></platform>
<platform id="high" name="high" type="static"><scannerMount x="0" y="0" z="9"/></platform>
<scanner id="near" name="near" optics="rotating" pulseFreqs_Hz="20000" scanAngleMax_deg="100"
 scanAngleEffectiveMax_deg="50" rangeMin_m="0.5" rangeMax_m="40" headRotatePerSecMax_deg="60"
 accuracy_m="0.001"/>
<scanner id="far" name="far" optics="rotating" pulseFreqs_Hz="10000,20000"
 scanAngleMax_deg="100" scanAngleEffectiveMax_deg="50" rangeMin_m="2" headRotatePerSecMax_deg="60" accuracy_m="0.05">
<FWFSettings beamSampleQuality="2"/></scanner>
<scene id="flat" name="flat"><part id="ground"><filter type="scale">
<param type="double" key="scale" value="0.5"/></filter><filter type="objloader">
<param type="string" key="filepath" value="ground.obj"/></filter></part></scene>
<survey name="two" scene="#flat">
<scan platform="#low" scanner="#near"><scannerRotation axis="yaw" start="0" end="20"/>
<leg><platformSettings x="0" y="0" z="0"/><scannerSettings template="common"/></leg></scan>
<scan platform="#high" scanner="#far"><scannerRotation axis="yaw" start="0" end="20"/>
<leg><platformSettings x="5" y="0" z="0"/><scannerSettings template="common">
<maxDuration_s>0.25</maxDuration_s></scannerSettings></leg></scan>
</survey></document>"""


def pieces(element, form):
    """The parts of an element, to be joined: its start tag, its content, and its end tag."""
    attributes = list(element.attrib.items())
    children = list(element)
    if form == "reordered":
        attributes.reverse()
        # Elements that the dialect finds by name, wherever they are.
        if element.tag in ("document", "leg", "scanner", "platform"):
            children.reverse()
    gap = {"one attribute a line": "\n", "comments": " <!--<leg x='1'/>-->\n<?x y?>"}.get(form, "")
    before = "\n  " if form == "one attribute a line" else " "
    yield f"<{element.tag}" + "".join(f"{before}{n}={quoteattr(v)}" for n, v in attributes) + ">"
    text = (element.text or "").strip()
    if form == "comments" and text:
        half = len(text) // 2
        yield f"{escape(text[:half])}<!-- half --><![CDATA[{text[half:]}]]>"
    else:
        yield escape(text)
    for child in children:
        yield gap
        yield from pieces(child, form)
    yield f"{gap}</{element.tag}>"


FORMS = ("one line", "one attribute a line", "comments", "reordered")


def reformat(text, form):
    """Rewrites the document in another form."""
    head = "<?xml version='1.0'?>"
    if form == "comments":
        head += "<!DOCTYPE document SYSTEM 'none.dtd' [<!ELEMENT leg ANY>]><!-- <document/> -->"
    return head + "".join(pieces(ElementTree.fromstring(text), form))


def reformat_files(folder, form, into):
    """A copy of a folder, with its documents in another form."""
    shutil.copytree(folder, into)
    for path in into.rglob("*.xml"):
        text = path.read_bytes()
        if re.search(rb"<document\b", text):
            path.write_text(reformat(text, form), encoding="utf-8")
    return into


def list_attributes(kind, get, *indices):
    """The attributes of an element of a survey that have a value."""
    names = (
        vtkHeliosSurvey.GetAttributeName(kind, i)
        for i in range(vtkHeliosSurvey.GetNumberOfAttributes(kind))
    )
    return {name: text for name in names if (text := get(*indices, name))}


def describe(path, assets):
    """All that a survey has."""
    reader = vtkHeliosSurveyReader()
    reader.SetFileName(str(path))
    for folder in assets:
        reader.AddAssetDirectory(str(folder))
    assert reader.Read(), path
    survey = reader.GetSurvey()
    return {
        "survey": list_attributes("survey", survey.GetSurveyAttribute),
        "scene": survey.GetSceneName(),
        "parts": [
            list_attributes("part", survey.GetPartAttribute, i)
            for i in range(survey.GetNumberOfParts())
        ],
        "scanners": [
            [list_attributes("scanner", survey.GetScannerAttribute, i)]
            + [
                list_attributes("scanner", survey.GetChannelAttribute, i, k)
                for k in range(survey.GetNumberOfChannels(i))
            ]
            for i in range(survey.GetNumberOfScanners())
        ],
        "platforms": [
            list_attributes("platform", survey.GetPlatformAttribute, i)
            for i in range(survey.GetNumberOfPlatforms())
        ],
        "legs": [
            list_attributes("leg", survey.GetLegAttribute, i)
            for i in range(survey.GetNumberOfLegs())
        ],
    }


def without(text, folder):
    return str(text).replace(str(folder), "")


def run(capsys, *arguments):
    assert cli.main([str(argument) for argument in arguments]) == 0, capsys.readouterr().err


@pytest.fixture(scope="module")
def examples(tmp_path_factory):
    """The surveys that vtkhelios new makes."""
    folder = tmp_path_factory.mktemp("new")
    return {kind: write_example(kind, folder / kind)[0].parent for kind in KINDS}


@pytest.mark.parametrize("form", FORMS)
@pytest.mark.parametrize("kind", KINDS)
def test_examples_are_the_same_in_every_form(kind, form, examples, tmp_path):
    folder = examples[kind]
    other = reformat_files(folder, form, tmp_path / "other")
    assets = reformat_files(DATA / "Assets", form, tmp_path / "Assets")
    first = describe(folder / f"{kind}.xml", [DATA / "Assets"])
    again = describe(other / f"{kind}.xml", [assets])
    assert first["legs"] and first["scanners"][0][0]
    assert without(first, folder) == without(again, other)


@pytest.mark.parametrize("form", FORMS)
@pytest.mark.parametrize(
    "path", sorted((ROOT / "Data/Surveys").glob("*.xml")), ids=lambda p: p.stem
)
def test_surveys_of_the_tree_are_the_same_in_every_form(path, form, tmp_path):
    folder = tmp_path / "first"
    folder.mkdir()
    shutil.copy(path, folder)
    (folder / "ground.obj").write_text(GROUND)
    (folder / "village_scene.xml").write_text(SCENE)
    other = reformat_files(folder, form, tmp_path / "other")
    first = describe(folder / path.name, [DATA])
    assert without(first, folder) == without(describe(other / path.name, [DATA]), other)


@pytest.mark.parametrize("form", FORMS)
def test_surveys_of_others_are_the_same_in_every_form(form, tmp_path):
    surveys = sorted(OTHERS.glob("data/surveys/**/*.xml"))
    if not surveys:
        pytest.skip(f"no surveys in {OTHERS}")
    other = reformat_files(OTHERS, form, tmp_path / "other")
    for path in surveys:
        first = describe(path, [OTHERS])
        again = describe(other / path.relative_to(OTHERS), [other])
        assert without(first, OTHERS) == without(again, other), path


@pytest.mark.parametrize("form", ("as it is", *FORMS))
def test_each_leg_has_its_scanner_and_its_platform(form, tmp_path, capsys):
    (tmp_path / "ground.obj").write_text(GROUND)
    text = TWO if form == "as it is" else reformat(TWO, form)
    (tmp_path / "survey.xml").write_text(text)
    (tmp_path / "lines.xml").write_text(TWO)
    survey = describe(tmp_path / "survey.xml", [])
    assert [scanner[0]["name"] for scanner in survey["scanners"]] == ["near", "far"]
    assert [scanner[0]["rangeMin_m"] for scanner in survey["scanners"]] == ["0.5", "2"]
    assert [leg.get("maxDuration_s", "-1") for leg in survey["legs"]] == ["-1", "0.25"]
    assert [platform["name"] for platform in survey["platforms"]] == ["low", "high"]
    for name in ("survey.xml", "lines.xml"):
        run(capsys, "run", tmp_path / name, "--output", tmp_path / name[0], "--quiet")
    made = sorted(path.name for path in (tmp_path / "l" / "two").glob("leg*"))
    assert len(made) >= 2
    for name in made:
        expected = (tmp_path / "l" / "two" / name).read_bytes()
        assert (tmp_path / "s" / "two" / name).read_bytes() == expected


@pytest.mark.parametrize("form", ("one line", "comments"))
def test_points_are_the_same_in_every_form(form, examples, tmp_path, capsys):
    other = reformat_files(examples["tls"], form, tmp_path / "tls")
    for name, folder in (("first", examples["tls"]), ("other", other)):
        options = ("--part", "1/40", "--pulses-per-block", "1000", "--quiet")
        run(capsys, "run", folder / "tls.xml", "--output", tmp_path / name, *options)
    first, again = (
        sorted(p.read_bytes() for p in (tmp_path / name).rglob("leg*"))
        for name in ("first", "other")
    )
    assert first == again and max(map(len, first)) > 1000


def test_messages_tell_elements_of_one_line_apart(tmp_path, capsys):
    (tmp_path / "ground.obj").write_text(GROUND)
    text = reformat(TWO, "one line").replace(
        "<scannerSettings template", '<x/><scannerSettings a="1" template'
    )
    (tmp_path / "survey.xml").write_text(text.replace('rangeMin_m="2"', 'rangeMin_m="2 m"'))
    assert cli.main(["validate", str(tmp_path / "survey.xml")]) == 1
    output = capsys.readouterr().out
    column = text.index("<scanner ", text.index("<scanner ") + 1) + 1
    assert f'survey.xml:1:{column}: error: rangeMin_m="2 m" is not a number' in output
    assert cli.main(["validate", str(tmp_path / "survey.xml"), "--json"]) == 1
    found = [each for each in json.loads(capsys.readouterr().out) if "2 m" in each["message"]]
    assert [(each["line"], each["column"]) for each in found] == [(1, column)]
