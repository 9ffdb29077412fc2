# SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
# SPDX-License-Identifier: BSD-3-Clause
"""CONTRIBUTING.md says about additions that few files know an output, an option and a value of the
instrument, and that the examples are small and apply."""

import pathlib
import re
import subprocess

import pytest

ROOT = pathlib.Path(__file__).resolve().parents[2]
FOLDERS = ("Scanner", "Planning", "Apps/Viewer", "Python/vtkhelios")
SOURCES = {".h", ".cxx", ".py"}

OUTPUT = r"\b(Generate|Write){0}\b|\b(Wanted|Wants)\.{0}\b|Outputs::{0}\b"
# The word of a fact, the row of the table that names its files, and files that only use it.
FACTS = [
    (OUTPUT.format("Truth"), "output of a run that is on or off", set()),
    (OUTPUT.format("Columns"), "output of a run that is on or off", set()),
    # a condition of the scanner, columns of text
    (
        OUTPUT.format("Decibels"),
        "output of a run that is on or off",
        {"vtkHeliosScanner.cxx", "heliosLegOutput.cxx"},
    ),
    (
        r"AccuracyReport|accuracy_report|accuracy-report",
        "option of a run",
        {"heliosSurveyRun.cxx"},
    ),
    (r"SolarIrradiance|solar_irradiance", "value of the instrument", set()),
    (r"FilterBandwidth|filter_bandwidth", "value of the instrument", set()),
    (
        r"\bPhotonEfficiency|photon_efficiency",
        "value of the instrument",
        {"vtkHeliosPhotonCountingDetector.h", "vtkHeliosPhotonCountingDetector.cxx"},
    ),
]


def find_files(words):
    """The names of the files of the product whose code, without comments, has some words."""
    comment = re.compile(r"//.*|^\s*/?\*.*|#.*", flags=re.M)
    return {
        path.name
        for folder in FOLDERS
        for path in (ROOT / folder).rglob("*.*")
        if path.suffix in SOURCES
        and "Testing" not in path.parts
        and re.search(words, comment.sub("", path.read_text()))
    }


def find_named(row):
    """The names of the files in a row of the table."""
    text = (ROOT / "CONTRIBUTING.md").read_text()
    line = next(line for line in text.split("\n") if line.startswith(f"| {row} |"))
    return {word.split("/")[-1] for word in re.findall(r"`([^`]+\.(?:h|cxx|py))`", line)}


def name_value(value):
    return (value if isinstance(value, str) else " ".join(sorted(value)))[:24]


@pytest.mark.parametrize(("words", "row", "users"), FACTS, ids=name_value)
def test_a_fact_is_known_to_the_files_of_the_table(words, row, users):
    known, named = find_files(words), find_named(row)
    assert named and users <= known
    assert known - users <= named, f"more files than CONTRIBUTING.md says: {known - users - named}"


EXAMPLES = [
    ("own_attribute.patch", "attribute of a survey", {"heliosReceiverSetup.cxx"}, 3),
    ("own_output.patch", "output of a run that is on or off", {"vtkHeliosArrayNames.h"}, 32),
]


@pytest.mark.parametrize(("name", "row", "uses", "lines"), EXAMPLES)
def test_an_example_applies_and_is_small(name, row, uses, lines):
    path = ROOT / "Docs/examples" / name
    check = ["git", "apply", "--check", path]
    done = subprocess.run(check, cwd=ROOT, capture_output=True, text=True, check=False)
    assert done.returncode == 0, f"make {name} again for the code as it is:\n{done.stderr}"
    text = path.read_text()
    files = {each.split("/")[-1] for each in re.findall(r"^\+\+\+ b/(\S+)$", text, flags=re.M)}
    assert uses <= files
    if row.startswith("output"):
        assert files - uses <= find_named(row)
    assert len(re.findall(r"^\+(?!\+\+)", text, flags=re.M)) <= lines
