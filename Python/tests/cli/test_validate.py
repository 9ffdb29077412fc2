# SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
# SPDX-License-Identifier: BSD-3-Clause
"""vtkhelios validate: its errors, their positions, and exit codes."""

import json
import re

import pytest

import vtkhelios

from vtkhelios.cli import main

WRONG = """\
<document>
  <scannerSettings id="fast" scanFreq_hz="many"/>
  <survey name="a" scanner="#spinner" platform="#tripod" scene="#yard" simSped="2">
    <leg>
      <platformSettings x="1,5" movePerSec_m="9"/>
      <scannerSettings template="fast" headRotatePerSec_deg="10"/>
    </leg>
    <leg>
      <scannerSettings headRotatePerSec_deg="-5" headRotateStop_deg="90"/>
    </leg>
    <leg>
      <scannerSettings template="fats" pulseFreq_hz="-1"/>
    </leg>
  </survey>
  <scanner id="spinner" optics="rotating" scanAngleMax_deg="1e3"/>
  <platform id="tripod" type="statc"/>
  <scene id="yard" crs="EPSG:99999999">
    <part><filter type="objloader"><param key="filepath" value="missing.obj"/></filter></part>
    <part><filter type="scale"><param key="scale" value="-2"/></filter></part>
  </scene>
</document>
"""


@pytest.fixture
def validate(tmp_path, capsys, monkeypatch):
    """Writes a file, validates it and returns (exit code, the printed lines)."""
    monkeypatch.chdir(tmp_path)

    def call(text, *arguments):
        (tmp_path / "a.xml").write_text(text)
        code = main(["validate", "a.xml", *arguments])
        return code, capsys.readouterr().out.splitlines()

    return call


def test_valid_survey(command_line, make_survey):
    done = command_line("validate", make_survey())
    assert (done.returncode, done.stderr) == (0, "")
    assert done.stdout == "1 file: 0 errors, 0 warnings; geometry was not read (--deep reads it)\n"


def test_deep(command_line, make_survey):
    """A mesh with an error is found with --deep only, at the line of its part and its own."""
    survey = make_survey()
    done = command_line("validate", survey, "--deep")
    assert (done.returncode, done.stdout) == (0, "1 file: 0 errors, 0 warnings\n")
    mesh = survey.with_name("plane.obj")
    mesh.write_text(mesh.read_text().replace("f 1 3 4", "f 1 3 9"))
    assert command_line("validate", survey).returncode == 0
    done = command_line("validate", survey, "--deep")
    first, last = done.stdout.splitlines()
    assert done.returncode == 1 and last == "1 file: 1 error, 0 warnings"
    assert "plane.obj:6: error: " in first or "plane.obj:6: " in first, first
    scene = survey.with_name("scene.xml")
    assert command_line("validate", scene, "--deep").returncode == 0  # a scene alone is not loaded


def test_deep_explains_optics(command_line, make_survey):
    """Materials with mirrors, glass and water are notes, which are no warnings."""
    survey = make_survey()
    mesh = survey.with_name("plane.obj")
    mesh.write_text(f"mtllib optics.mtl\nusemtl window\n{mesh.read_text()}")
    survey.with_name("optics.mtl").write_text(
        "newmtl window\nhelios_optics pane\nNi 1.52\nhelios_thickness 0.008\n"
        "newmtl pond\nhelios_water coastal\nhelios_meanSquareSlope 0.02\n"
        "newmtl lens\nhelios_optics volume\nhelios_dispersion bk7\n"
        "newmtl mirror\nhelios_optics mirror\nhelios_mirrorReflectance 0.9\n"
        "newmtl wall\nhelios_reflectance 0.4\n"
    )
    done = command_line("validate", survey, "--deep", "--strict")
    assert done.returncode == 0, done.stdout
    *notes, last = done.stdout.splitlines()
    assert last == "1 file: 0 errors, 0 warnings"
    assert [line.split(": ", 1)[1] for line in notes] == [
        "note: material window: a pane 0.008 m thick, of index 1.52",
        "note: material pond: water of index 1.34, attenuation 0.182 1/m at 532 nm, backscatter 0.00045 "
        "1/(m sr), rough: mean square slope 0.02",
        "note: material lens: a transparent body of the index of bk7",
        "note: material mirror: a mirror that reflects 0.9",
    ]


def test_all_errors_are_reported_at_once(validate):
    code, lines = validate(WRONG)
    assert code == 1
    expected = [
        ('a.xml:2: error: scanFreq_hz="many" is not a number', "[Hz]"),
        ("a.xml:3: warning: attribute simSped of <survey> is unknown", "did you mean simSpeed?"),
        ('a.xml:5: error: x="1,5" is not a number', "[m]"),
        ('a.xml:12: error: template="fats"', "did you mean fast?"),
        ('a.xml:12: error: pulseFreq_hz="-1" is out of range', "from 0.001 to 1000000000 [Hz]"),
        ('a.xml:15: error: scanAngleMax_deg="1000" is out of range', "from 0 to 360 [deg]"),
        ('a.xml:16: error: type="statc" is not valid', "did you mean static?"),
        ('a.xml:17: error: crs="EPSG:99999999"', ""),
        ('a.xml:18: error: filepath="missing.obj": no such file', "missing.obj"),
        ('a.xml:19: error: scale="-2" is out of range', "from 1e-09"),
        ("a.xml:19: error: <part> has no loader", "objloader"),
    ]
    found = [line.replace("1e3", "1000") for line in lines[:-1]]
    for (start, inside), line in zip(expected, found):
        assert line.startswith(start) and inside in line, line
    assert len(found) == len(expected), found
    assert lines[-1] == "1 file: 10 errors, 1 warning"


def test_legs_are_checked_despite_scanner_errors(validate):
    text = WRONG.replace("statc", "static")
    _, lines = validate(text)
    turned = [line for line in lines if "never reaches it" in line]
    assert len(turned) == 1 and turned[0].startswith("a.xml:9: error: ")
    assert not [line for line in lines if "a.xml:6" in line]  # the template's error is not its own


def test_legs_of_an_unknown_scanner_have_no_errors_of_its_limits(validate, make_survey):
    text = make_survey().read_text()
    text = re.sub(r'scanner="[^"]*"', 'scanner="#nope"', text)
    text = re.sub(r'headRotatePerSec_deg="[^"]*"', "", text)
    resolution = '<scannerSettings verticalResolution_deg="0.1" horizontalResolution_deg="0.1"'
    _, lines = validate(text.replace("<scannerSettings", resolution, 1))
    assert 'has no <scanner> with the id "nope"' in lines[0]
    assert lines[-1] == "1 file: 1 error, 0 warnings", lines


def test_errors_of_each_leg(validate):
    text = WRONG.replace("1e3", "120").replace("statc", "static").replace('"many"', '"50"')
    _, lines = validate(text)
    assert any(line.startswith("a.xml:9: error: no pulse frequency") for line in lines)


def test_unused_assets_are_checked(validate):
    code, lines = validate(
        '<document>\n<scanner id="a" optics="conic"/>\n<scanner id="b" optics="comic"/>\n'
        '<platformSettings id="t" z="high"/></document>'
    )
    assert code == 1
    assert [line[:16] for line in lines[:-1]] == [
        "a.xml:2: error: ",
        "a.xml:3: error: ",
        "a.xml:4: error: ",
    ]
    assert "scanAngleMax_deg is missing" in lines[0] and 'z="high"' in lines[2]


def test_a_ray_caster_that_is_not_built(validate):
    _, lines = validate(WRONG.replace("simSped", "rayCaster"))
    assert any('rayCaster="2" is not in this build; give one of beam' in line for line in lines)


def test_empty_files(validate):
    assert "<document> is empty" in validate("<document/>")[1][0]
    assert "this is not XML" in validate("<document>")[1][0]
    code, lines = validate("<document/>", "nowhere.xml")
    assert code == 1
    assert lines[-2].startswith("nowhere.xml: error: no such file") and "2 files" in lines[-1]


def test_duplicates_and_a_second_root_do_not_hide_other_errors(validate):
    _, lines = validate(
        '<document>\n<scanner id="a" id="b" optics="comic"/>\n</document>\n<document/>'
    )
    text = "\n".join(lines)
    assert "a.xml:2: error: <scanner> has the attribute id twice" in text
    assert "a.xml:4: error: a second root element" in text
    assert 'a.xml:2: error: optics="comic" is not valid; did you mean conic?' in text


def test_a_planner(validate):
    planner = (
        '<document>\n<surveyPlanner id="a" scene="#s" platform="#p" scaner="#c" method="{}"/>\n'
    )
    code, lines = validate(planner.format("bst") + '<platform id="p"/></document>')
    text = "\n".join(lines)
    assert code == 1
    assert 'a.xml:2: error: method="bst" is not valid; did you mean best? Expected reduce' in text
    assert 'a.xml:2: error: scene="#s": a.xml has no <scene> with the id "s"' in text
    assert "a.xml:2: error: <surveyPlanner> has no attribute scanner" in text
    assert "attribute scaner of <surveyPlanner> is unknown; did you mean scanner?" in text


def test_json(validate):
    code, lines = validate(WRONG, "--json")
    findings = json.loads("\n".join(lines))
    assert code == 1 and len(findings) == 11
    assert findings[1]["severity"] == "warning" and findings[1]["line"] == 3
    assert all(set(found) == {"file", "line", "severity", "message"} for found in findings)
    assert {found["file"] for found in findings} == {"a.xml"}


def test_strict(validate):
    text = '<document><platform id="p" type="static" whels="4"/></document>'
    assert validate(text)[0] == 0
    code, lines = validate(text, "--strict")
    assert (
        code == 1
        and lines[-1] == "1 file: 0 errors, 1 warning; geometry was not read (--deep reads it)"
    )


def test_assets_are_looked_up(validate, tmp_path):
    (tmp_path / "more").mkdir()
    (tmp_path / "more/missing.obj").write_text("v 0 0 0\n")
    _, lines = validate(WRONG, "--assets", "more")
    assert not [line for line in lines if "missing.obj" in line]


def test_wrong_usage(validate, capsys):
    assert main(["validate", "a.xml", "--assets", "nowhere"]) == 2
    assert "--assets nowhere: no such folder" in capsys.readouterr().err
    with pytest.raises(SystemExit) as stopped:
        main(["validate"])
    assert stopped.value.code == 2


SWINGING = "<scanner id='a' optics='oscillating'>"


@pytest.mark.parametrize(
    "name, place",
    [
        ("optics", '<scanner id="a" scanAngleMax_deg="9" optics="{}"/>'),
        ("scanPattern", '<scanner id="a" optics="oscillating" scanPattern="{}"/>'),
        ("echoDetector", f"{SWINGING}<FWFSettings echoDetector='{{}}'/></scanner>"),
        ("returnSelection", f"{SWINGING}<FWFSettings returnSelection='{{}}'/></scanner>"),
        ("rotations", '<platform id="p"><scannerMount rotations="{}"/></platform>'),
        ("method", '<surveyPlanner id="a" method="{}"/>'),
        ("pspRemoveOrder", '<surveyPlanner id="a" pspRemoveOrder="{}"/>'),
        ("pspRemoveFirst", '<surveyPlanner id="a" pspRemoveFirst="{}"/>'),
        ("coverageOf", '<surveyPlanner id="a" coverageOf="{}"/>'),
        (
            "axis",
            '<platform id="p"><scannerMount><rot axis="{}" angle_deg="1"/></scannerMount>'
            "</platform>",
        ),
    ],
)
def test_schema_has_the_keywords_of_the_reader(name, place, validate):
    etree = pytest.importorskip("lxml.etree")
    schema = etree.fromstring(vtkhelios.vtkHeliosDialect.GetSchema().encode())
    space = {"xs": "http://www.w3.org/2001/XMLSchema"}
    found = schema.xpath(f"//xs:attribute[@name='{name}'][.//xs:enumeration]", namespaces=space)
    words = [word.get("value") for word in found[0].iterfind(".//xs:enumeration", space)]
    assert len(words) > 1
    for word in words:
        _, lines = validate(f"<document>{place.format(word)}</document>")
        assert not [line for line in lines if f'{name}="{word}"' in line], lines
    code, lines = validate(f"<document>{place.format('wrong')}</document>")
    assert code == 1 and f'{name}="wrong"' in lines[0]
