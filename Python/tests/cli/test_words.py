# SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
# SPDX-License-Identifier: BSD-3-Clause
"""Counts and settings in words."""

import math
import pathlib
import re

import pytest

from vtkhelios.core.words import counted, describe_setting, describe_settings, digits

PACKAGE = pathlib.Path(__file__).resolve().parents[2] / "vtkhelios"


@pytest.mark.parametrize(
    "number, singular, text",
    [
        (1, "flight line", "1 flight line"),
        (0, "scanner", "0 scanners"),
        (1200, "echo", "1,200 echoes"),
        (2, "false positive", "2 false positives"),
        (2, "survey", "2 surveys"),
        (2, "summary", "2 summaries"),
        (3, "pass", "3 passes"),
    ],
)
def test_counted(number, singular, text):
    assert counted(number, singular) == text


@pytest.mark.parametrize(
    "value, text",
    [
        (29.97519571943663, "29.98"),
        (8.0, "8"),
        (1e6, "1,000,000"),
        (102330.4, "102,330"),
        (0.1, "0.1"),
        (0.00012346, "0.0001235"),
        (1.5e-9, "1.5e-09"),
        (-3.14159, "-3.142"),
        (0.0, "0"),
        (262144, "262,144"),
        (math.inf, "inf"),
    ],
)
def test_digits(value, text):
    assert digits(value) == text


@pytest.mark.parametrize(
    "key, value, row",
    [
        ("halfSwath_deg", 29.97519571943663, ("Half swath", "29.98 deg")),
        ("density_1_m2", 8.0, ("Density", "8 /m²")),
        ("nohd_m", 300.0, ("NOHD", "300 m")),
        ("maxClimb_deg", 10.0, ("Maximum climb", "10 deg")),
        ("terrainFollowing", False, ("Terrain following", "no")),
        ("spacing_m", (0.4, 0.5), ("Spacing", "0.4, 0.5 m")),
        ("speed_m_s", 55.0, ("Speed", "55 m/s")),
        ("scanner", "scanners.xml#rotating_als", ("Scanner", "scanners.xml#rotating_als")),
    ],
)
def test_settings(key, value, row):
    assert describe_setting(key, value) == row


def test_settings_that_are_not_set_are_left_out():
    assert describe_settings({"area": None, "seed": 0}) == [("Seed", "0")]


NOUNS = (
    "scanner platform scene line leg file strip scan triangle part material position candidate tile "
    "cell plane epoch error warning thread point pulse echo".split()
)
COUNT = re.compile(
    rf"\{{(?:[^{{}}]*:,|len\([^{{}}]*)\}} (?:first |test )?(?:{'|'.join(NOUNS)})e?s\b"
)


def find_counts(text):
    """Returns the counts of a text whose noun is a plural whatever the number, as in "1 scanners"."""
    return COUNT.findall(text)


def test_counts_are_made_by_one_function():
    found = {path.name: find_counts(path.read_text()) for path in PACKAGE.rglob("*.py")}
    assert "words.py" in found
    assert {name: counts for name, counts in found.items() if counts} == {}


def test_plain_counts_are_found():
    assert len(find_counts('f"{count:,} points" f"{len(rows)} lines" f"{a:,} test points"')) == 3
    assert find_counts("f\"{counted(count, 'point')} {count} points of {name}\"") == []
