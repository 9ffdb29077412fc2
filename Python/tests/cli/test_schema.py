# SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
# SPDX-License-Identifier: BSD-3-Clause
"""The XML schema and the tables of the dialect: current, and valid for libxml2."""

import pathlib

import pytest

import vtkhelios

from vtkhelios.cli import main
from vtkhelios.cli.schema import make_files

etree = pytest.importorskip("lxml.etree")

ROOT = pathlib.Path(__file__).absolute().parents[3]
SCHEMAS = ROOT / "Data/Schemas"
DIALECT = ROOT / "Docs/dialect.md"

SURVEY = """\
<document>
  <survey name="a" scanner="s.xml#s" platform="p.xml#p" scene="c.xml#c"><leg>
    <platformSettings x="1.5" onGround="True"/>
    <scannerSettings scanFreq_hz="5e1" maxDuration_s="2"/>
  </leg></survey>
  <scanner id="s" optics="rotating" pulseFreqs_Hz="1000, 2e3" maxNOR="3"><beamOrigin z="1">
    <rot axis="x" angle_deg="-90"/></beamOrigin></scanner>
  <platform id="p" type="static"/>
  <scene id="c"><part><filter type="ObjLoader"><param key="filepath" value="a.obj"/></filter></part>
  </scene>
</document>
"""


@pytest.fixture(scope="module")
def schema():
    return etree.XMLSchema(etree.parse(str(SCHEMAS / "survey.xsd")))


# The committed files match the table; to regenerate:
#   vtkhelios schema --output Data/Schemas
#   vtkhelios schema --tables, between the marks in Docs/dialect.md


def test_every_name_is_described():
    assert vtkhelios.vtkHeliosDialect.FindUndescribed() == ""


def test_schemas_are_current():
    files = make_files()
    assert {path.name for path in SCHEMAS.glob("*.xsd")} == set(files)
    for name, text in files.items():
        assert (SCHEMAS / name).read_text(encoding="utf-8") == text, name


def test_tables_are_current():
    text = DIALECT.read_text(encoding="utf-8")
    begin, end = "<!-- tables: begin -->\n", "<!-- tables: end -->"
    inside = text[text.index(begin) + len(begin) : text.index(end)]
    assert inside.strip() == vtkhelios.vtkHeliosDialect.GetTables().strip()


def test_command_line(tmp_path, capsys):
    assert main(["schema"]) == 0
    assert capsys.readouterr().out == vtkhelios.vtkHeliosDialect.GetSchema()
    assert main(["schema", "--tables"]) == 0
    assert capsys.readouterr().out == vtkhelios.vtkHeliosDialect.GetTables()
    assert main(["schema", "--output", str(tmp_path / "new")]) == 0
    assert str(tmp_path / "new/helios.xsd") in capsys.readouterr().out
    assert (tmp_path / "new/scene.xsd").read_text() == (SCHEMAS / "scene.xsd").read_text()


def test_read_only_folder(tmp_path, capsys):
    (tmp_path / "plain").write_text("")
    assert main(["schema", "--output", str(tmp_path / "plain")]) == 1
    assert "cannot be written" in capsys.readouterr().err


# Accepted and rejected documents.


@pytest.mark.parametrize(
    "path",
    sorted((ROOT / "Data").rglob("*.xml")),
    ids=lambda path: path.name,
)
def test_shipped_files_are_valid(schema, path):
    schema.assertValid(etree.parse(str(path)))


def test_mixed_documents_are_valid(schema):
    schema.assertValid(etree.fromstring(SURVEY))


@pytest.mark.parametrize(
    "right, wrong, message",
    [
        ('x="1.5"', 'x="1,5"', "'1,5' is not a valid value"),
        ('x="1.5"', 'x="nan"', "'nan' is not a valid value"),
        ('x="1.5"', 'x="NaN"', "NaN"),
        ('x="1.5"', 'x="INF"', "INF"),
        ('x="1.5"', 'ex="1.5"', "attribute 'ex' is not allowed"),
        ('onGround="True"', 'onGround="yes"', "attribute 'onGround'"),
        ('scanFreq_hz="5e1"', 'scanFreq_hz="-1"', "less than the minimum value allowed ('0')"),
        ('scanFreq_hz="5e1"', 'pulseFreq_hz="0"', "'pulseFreq_hz'"),
        ('scanFreq_hz="5e1"', 'scanFreq_hz="1e7"', "greater than the maximum value allowed"),
        ('optics="rotating"', 'optics="turning"', "'turning' is not an element of the set"),
        ('optics="rotating"', "", "attribute 'optics' is required"),
        ('scene="c.xml#c"', "", "attribute 'scene' is required"),
        ("1000, 2e3", "1000; 2e3", "pattern"),
        ('maxNOR="3"', 'maxNOR="2.5"', "attribute 'maxNOR'"),
        ('axis="x"', 'axis="w"', "'w' is not an element of the set"),
        ('angle_deg="-90"', "", "attribute 'angle_deg' is required"),
        ('type="static"', 'type="stattic"', "'stattic' is not an element of the set"),
        ('type="ObjLoader"', 'type="ObjLoder"', "pattern"),
        ("<leg>", "<leg><wheel/>", "Element 'wheel'"),
        ("<scanner id", "<scanr/><scanner id", "Element 'scanr'"),
        ("document>", "dokument>", "No matching global declaration"),
        ('<beamOrigin z="1">', '<beamOrigin z="1"/><beamOrigin z="1">', "beamOrigin"),
    ],
)
def test_invalid_documents_are_refused(schema, right, wrong, message):
    assert right in SURVEY
    text = SURVEY.replace(right, wrong)
    assert not schema.validate(etree.fromstring(text))
    told = "\n".join(error.message for error in schema.error_log)
    assert message in told
