# SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
# SPDX-License-Identifier: BSD-3-Clause
"""run_summary.json that is damaged, manipulated, or not a file."""

import json
import os
import random

import pytest

from vtkhelios import cli, formats
from vtkhelios.formats._summary import REPORT, parse_summary, read_summary

WHOLE = {
    "inputs": [{"bytes": 3749, "file": "a.xml", "sha256": "55ce84fd"}],
    "legs": [{
        "duration_s": 2.5, "firstReturns": 1, "leg": 0, "points": 1, "pulses": 2, "pulsesFired": 2,
        "pulsesHit": 1, "start_s": 0.0,
        "files": [{"bytes": 22, "name": "leg000_points.xyz", "records": 1}],
    }],
    "options": {"detector": "", "seed": 0, "noise": True, "rangeTolerance_m": 0.1},
    "rayCaster": "bvh", "sampling": "1 sub-ray", "scene": "ed43", "survey": "village",
    "timings": {"legs_s": [2.25], "load_s": 0.25, "run_s": 2.25, "threads": 2},
    "totals": {"firstReturns": 1, "hitsOutOfRange": 0, "points": 1, "pulses": 2, "pulsesBinned": 0,
               "pulsesFired": 2, "pulsesHit": 1, "pulsesOnPlane": 1, "pulsesSampled": 0,
               "pulsesWithoutBins": 0, "subRays": 4, "largestAmplitude_W": 1e-7},
    "versions": {"VTK": "9.1.0", "vtkHelios": "0.1.0"},
}  # fmt: skip


def changed(place, value):
    """The full one as text, with another value at a position; Ellipsis removes the key."""
    summary = json.loads(json.dumps(WHOLE))
    *way, last = place
    inside = summary
    for step in way:
        inside = inside[step]
    if value is ...:
        del inside[last]
    else:
        inside[last] = value
    return json.dumps(summary)


BAD = [
    (b"", "is not valid JSON: Expecting value"),
    (b"\xff\xfe{}", "byte 0 is not UTF-8"),
    ("[" * 200_000, "is nested too deeply"),
    ('{"legs": NaN}', "is not valid JSON: NaN is not a valid JSON number"),
    ('{"legs": -Infinity}', "-Infinity is not a valid JSON number"),
    ('{"legs": [], "legs": []}', 'the key "legs" is given twice'),
    (f'{{"legs": {"9" * 5000}}}', "is not valid JSON: Exceeds the limit"),
    (f'{{"legs": {"9" * 400}}}', "legs is a number of more than 60 digits: expected a list"),
    ("[1]", "the file is a list: expected an object"),
    ("{}", "the file has no legs"),
    (changed(["legs", 0], 5), r"legs[0] is 5: expected an object"),
    (changed(["legs", 0, "files"], {}), "legs[0].files is an object: expected a list"),
    (changed(["legs", 0, "files", 0, "name"], ...), "legs[0].files[0] has no name"),
    (changed(["legs", 0, "files", 0, "name"], "../a"), '"../a": expected the name of a file in'),
    (changed(["legs", 0, "files", 0, "name"], "\ud800"), r'name is "\ud800": expected the name'),
    (changed(["legs", 0, "files", 0, "records"], -1), "records is -1: expected a whole number"),
    (changed(["legs", 0, "files", 0, "records"], True), "records is true: expected a whole number"),
    (changed(["legs", 0, "leg"], "<script>"), 'legs[0].leg is "<script>": expected a whole number'),
    (changed(["legs", 0, "start_s"], 1e300), "start_s is 1e+300: expected a number from 0 to 1e+15"),
    ('{"legs": [], "timings": {"run_s": 1e999}}', "run_s is Infinity: expected a number from 0"),
    (changed(["timings", "legs_s"], [1, 2]), "timings.legs_s has 2 entries, for 1 leg"),
    (changed(["timings", "threads"], "\x1b[2J" * 99), r'threads is "\u001b[2J'),
    (changed(["options", "seed"], []), "options.seed is a list: expected a text, true, false or"),
    (changed(["versions", "VTK"], None), "versions.VTK is null: expected a text"),
    (changed(["survey"], "\udc80"), r'survey is "\udc80": expected a text'),
    (changed(["inputs", 0, "bytes"], 2**63), "inputs[0].bytes is 9223372036854775808: expected"),
]  # fmt: skip


@pytest.mark.parametrize("text, message", BAD)
def test_errors_name_key_and_value(text, message):
    with pytest.raises(formats.FormatError) as caught:
        parse_summary(text, "a/run_summary.json")
    said = str(caught.value)
    assert said.startswith("a/run_summary.json: ") and message in said
    assert said.endswith("; run the survey again") and said.isprintable() and len(said) < 250


def test_complete_summary_is_valid():
    assert parse_summary(json.dumps(WHOLE), "a", REPORT) == WHOLE
    assert parse_summary('{"legs": []}', "a") == {"legs": []}


def keys_of(needed, place=()):
    for key, inner in needed.items():
        yield (*place, key)
        step = inner[0] if isinstance(inner, list) else inner
        more = (0,) if isinstance(inner, list) else ()
        yield from keys_of(step or {}, (*place, key, *more))


@pytest.mark.parametrize("place", list(keys_of(REPORT)))
def test_members_required_by_reports(place):
    with pytest.raises(formats.FormatError, match=f"has no {place[-1]}; run the survey again"):
        parse_summary(changed(place, ...), "a", REPORT)


def make_run(folder, data):
    folder.mkdir()
    (folder / "leg000_points.xyz").write_text("1 2 3 1 4 1 1 0 0 0 0\n")
    (folder / "run_summary.json").write_bytes(data.encode() if isinstance(data, str) else data)
    return folder


@pytest.mark.parametrize("command", ["info", "report"])
@pytest.mark.parametrize("text, message", BAD)
def test_commands_report_damage(tmp_path, capsys, command, text, message):
    run = make_run(tmp_path / "run", text)
    assert cli.main([command, str(run)]) == 1
    err = capsys.readouterr().err
    assert message in err and err.startswith("error: ") and err.count("\n") == 1
    assert not (run / "report.html").exists()


def test_summary_that_is_not_a_file(tmp_path):
    os.mkfifo(tmp_path / "run_summary.json")
    with pytest.raises(formats.FormatError, match="is a FIFO, not a regular file; copy it to a"):
        read_summary(tmp_path / "run_summary.json")


def test_resuming_a_finished_run(make_survey, tmp_path, capsys):
    """The messages equal the summary's."""
    arguments = ["run", str(make_survey(stop=1)), "--output", str(tmp_path / "out"), "--resume"]
    assert cli.main(arguments[:-1]) == 0 and cli.main(arguments) == 0
    assert "the run in" in capsys.readouterr().out
    path = tmp_path / "out/plane/run_summary.json"
    whole = json.loads(path.read_text())
    del whole["timings"]["run_s"]
    path.write_text(json.dumps(whole))
    assert cli.main(arguments) == 1
    err = capsys.readouterr().err
    assert "run_summary.json: timings has no run_s; run the survey again" in err


def test_mutants(tmp_path):
    """Any contents give a summary or a message."""
    whole = json.dumps(WHOLE).encode()
    generator = random.Random(7)
    words = [b"null", b"-1", b"1e999", b"NaN", b"{}", b"[]", b'"', b"\xff", b"9" * 30, b"\\ud800"]
    accepted = 0
    for _ in range(3000):
        data = bytearray(whole)
        for _ in range(generator.randint(1, 4)):
            at = generator.randrange(len(data))
            end = at + generator.choice([0, 1, 1, 3, 40])
            data[at:end] = generator.choice([*words, bytes([generator.randrange(256)])])
        try:
            summary = parse_summary(bytes(data), "a", REPORT)
        except formats.FormatError as error:
            assert str(error).isprintable()
        else:
            accepted += 1
            json.dumps(summary, allow_nan=False).encode()
    assert accepted > 50


def test_an_accuracy_that_is_shown_is_whole():
    text = changed(["accuracy"], {"echoes": 1})
    parse_summary(text, "a")  # readers of points do not need it
    with pytest.raises(formats.FormatError, match="a: accuracy has no rangeP50_m"):
        parse_summary(text, "a", REPORT)
    parse_summary(changed(["accuracy"], {"reason": "no echo"}), "a", REPORT)


def test_a_reference_states_its_tolerances_or_sub_rays():
    measures = dict.fromkeys(formats._summary.MEASURED, [0.001, 0.0, 0.002])
    accuracy = {**measures, "pulses": 9, "echoes": 9, "without": []}
    asked = dict(measures, rangeTolerance_m=1e-4, energyTolerance=1e-3)
    for reference in (asked, dict(measures, subRays=4096)):
        parse_summary(changed(["accuracy"], {**accuracy, "reference": reference}), "a", REPORT)
    del asked["rangeTolerance_m"]
    text = changed(["accuracy"], {**accuracy, "reference": asked})
    with pytest.raises(formats.FormatError, match="accuracy.reference has no rangeTolerance_m"):
        parse_summary(text, "a", REPORT)
