# SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
# SPDX-License-Identifier: BSD-3-Clause
"""The catalogue of scanners: every number has a source, and the page is made of it."""

import collections
import importlib.util
import json
import pathlib
import xml.etree.ElementTree as ElementTree

import numpy as np
import pytest

import vtkhelios
from vtkhelios import catalogue
from vtkhelios.catalogue import KINDS, USES, CatalogueError, find_scanners
from vtkhelios.cli import main

ROOT = pathlib.Path(__file__).resolve().parents[2]
ASSETS = ROOT / "Data/Assets"
ALL = find_scanners()
INSTRUMENTS = [each for each in ALL if each.maker]
TITLES = {"id", "name", "maker", "use", "optics", "spin"}
PARTS = ("beamOrigin", "incidentBeam", "beams")

OWN = """\
<document>
  <scanner id="own" name="My own" maker="Me" use="mobile" optics="rotating" pulseFreqs_Hz="2e5, 1e5"
    scanAngleMax_deg="180" scanAngleEffectiveMax_deg="100" beamDivergence_rad="0.001">
    <channels><channel/><channel/></channels>
    <sources><source kind="assumed" of="beamDivergence_rad" note="a
      guess"/></sources>
  </scanner>
</document>
"""


def test_forty_instruments_and_the_classes():
    assert len(INSTRUMENTS) >= 40
    classes = {each.id for each in ALL if not each.maker}
    assert {"vz400_class_tls", "rotating_als", "conic_als", "mobile_mls", "copter_uls"} <= classes
    ids = collections.Counter(each.id for each in ALL)
    assert [name for name, count in ids.items() if count > 1] == []


def element_of(scanner):
    file, _, name = scanner.reference.partition("#")
    root = ElementTree.parse(ASSETS / file).getroot()
    return next(each for each in root.iter("scanner") if each.get("id") == name)


@pytest.mark.parametrize("scanner", INSTRUMENTS, ids=lambda each: each.id)
def test_every_number_has_one_source(scanner):
    element = element_of(scanner)
    numbers = set(element.attrib) - TITLES
    for channel in element.iterfind("channels/channel"):
        numbers |= set(channel.attrib) - {"id", "name"}
    numbers |= {part for part in PARTS if element.find(f".//{part}") is not None}
    named = collections.Counter(name for each in scanner.sources for name in each.attributes)
    assert set(named) == numbers
    assert set(named.values()) == {1}
    assert {each.kind for each in scanner.sources} <= set(KINDS)
    assert all(each.note for each in scanner.sources)


@pytest.mark.parametrize("scanner", INSTRUMENTS, ids=lambda each: each.id)
def test_every_instrument_is_complete(scanner):
    assert scanner.use in USES
    needed = {
        "pulseFreqs_Hz",
        "pulseLength_ns",
        "wavelength_nm",
        "beamDivergence_rad",
        "accuracy_m",
    }
    # The field of prisms and of spinning heads equals the field of their beams.
    field = set() if scanner.optics in ("risley", "spinning") else {"scanAngleMax_deg"}
    assert needed | field | {"rangeMin_m"} <= set(scanner.numbers)
    assert scanner.optics in ("line", "risley") or "scanFreqMax_Hz" in scanner.numbers
    assert 1e-5 <= scanner.beam_divergence <= 1.1e-2
    assert scanner.use == "spaceborne" or scanner.beam_divergence >= 1e-4


@pytest.mark.parametrize("scanner", ALL, ids=lambda each: each.id)
def test_every_scanner_is_valid(scanner):
    survey = vtkhelios.vtkHeliosSurvey()
    survey.AddAssetDirectory(str(ASSETS))
    with vtkhelios.core.pipeline.MessageLog() as log:
        log.watch(survey)
        assert survey.AddScannerFromFile(scanner.reference) == 0
    assert log.errors == []
    assert log.warnings == []


def test_page_is_current():
    path = ROOT / "Python/make_instruments.py"
    spec = importlib.util.spec_from_file_location("make_instruments", path)
    module = importlib.util.module_from_spec(spec)
    spec.loader.exec_module(module)
    cure = "run build/venv/bin/python Python/make_instruments.py"
    assert module.PAGE.read_text(encoding="utf-8") == module.make_page(), cure


def test_words_of_a_search():
    found = find_scanners("Terrestrial riegl")
    assert {"riegl_vz400", "riegl_vz400i", "riegl_vz6000"} <= {each.id for each in found}
    assert {each.use for each in found} == {"terrestrial"}
    assert find_scanners("riegl nothing") == []
    assert find_scanners() == ALL


def test_scanners_of_other_folders(tmp_path):
    (tmp_path / "mine").mkdir()
    (tmp_path / "mine/own.xml").write_text(OWN)
    (own,) = find_scanners("my own", [tmp_path])
    assert own.reference == "mine/own.xml#own"
    assert own.pulse_frequencies == (1e5, 2e5)
    assert own.pulse_rate == 4e5  # rate of two channels
    assert own.field_of_view == 200
    assert own.source_of("beamDivergence_rad").note == "a guess"
    assert own.source_of("rangeMin_m") is None


def test_files_that_cannot_be_read(tmp_path):
    path = tmp_path / "own.xml"
    path.write_text(OWN.replace("</document>", ""))
    with pytest.raises(
        CatalogueError, match=r"own\.xml: is not readable XML: .*line 9.*correct it"
    ):
        find_scanners("", [tmp_path])
    path.write_text(OWN.replace('"180"', '"wide"'))
    message = (
        'own.xml: scanner own: scanAngleMax_deg="wide" is not valid: expected a number; '
        "vtkhelios validate FILE lists all errors"
    )
    told = []
    assert len(find_scanners("", [tmp_path], told.append)) == len(ALL)
    assert told == [f"{tmp_path}/{message}"]


def test_scan_finds_the_file_of_an_id():
    plane = vtkhelios.Scene([(-50, -50, 0), (50, -50, 0), (0, 50, 0)], [(0, 1, 2)])
    settings = dict(head=(0, 1), head_speed=10, scan_frequency=50, sub_rays=1)
    short = vtkhelios.scan(plane, position=(0, 0), scanner="faro_s70", **settings)
    whole = "instruments/faro.xml#faro_s70"
    assert np.array_equal(
        short.points, vtkhelios.scan(plane, position=(0, 0), scanner=whole, **settings).points
    )
    assert len(short)
    assert catalogue.find_file("none") == "scanners.xml"


def test_list(capsys):
    assert main(["info", "--scanners", "vz-400i"]) == 0
    head, line, end = capsys.readouterr().out.splitlines()
    assert head.split() == ["scanner", "name", "kind", "kHz", "field", "mrad", "source"]
    words = (
        "instruments/riegl.xml#riegl_vz400i RIEGL VZ-400i terrestrial, rotating 100-1200 100 0.35"
    )
    assert " ".join(line.split()).startswith(f"{words} RIEGL VZ-400i data sheet")
    assert end.startswith("1 scanner. kHz: ")


def test_list_of_channels_and_of_all(capsys):
    assert main(["info", "--scanners"]) == 0
    text = capsys.readouterr().out
    assert "  3 x 50-300  " in text
    assert len(text.splitlines()) == len(ALL) + 2


def test_list_as_json(capsys):
    assert main(["info", "--scanners", "optech titan", "--json"]) == 0
    (titan,) = json.loads(capsys.readouterr().out)["scanners"]
    assert titan["reference"] == "instruments/optech.xml#optech_titan"
    assert titan["pulseRate_Hz"] == 900e3
    assert titan["fieldOfView_deg"] == 60
    assert titan["numbers"]["scanProduct"] == 800
    assert {each["kind"] for each in titan["sources"]} == {"checked", "sheet", "derived", "assumed"}


def test_list_of_a_folder_with_a_damaged_file(tmp_path, capsys):
    (tmp_path / "bad.xml").write_text("<document>")
    (tmp_path / "own.xml").write_text(OWN)
    assert main(["info", "--scanners", "my own", "--assets", str(tmp_path)]) == 0
    out, err = capsys.readouterr()
    assert "own.xml#own" in out
    assert "warning:" in err and "bad.xml: is not readable XML" in err


def test_errors_of_the_list(tmp_path, capsys):
    assert main(["info", "--scanners", "riegl nothing"]) == 1
    assert '"riegl nothing": no scanner has all these words' in capsys.readouterr().err
    assert main(["info", "--scanners", "x", "--assets", str(tmp_path / "none")]) == 1
    assert "none: no such folder" in capsys.readouterr().err
    assert main(["info"]) == 2
    assert "give a file, a run or a survey, or --scanners" in capsys.readouterr().err
    assert main(["info", "a.las", "--scanners", "x"]) == 2
