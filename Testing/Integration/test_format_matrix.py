# SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
# SPDX-License-Identifier: BSD-3-Clause
"""The tables of Docs/files.md are what format_matrix.py finds."""

import pathlib
import sys

import numpy as np
import pytest

for package in ("laspy", "lazrs", "copclib", "pye57", "plyfile"):
    pytest.importorskip(package)

sys.path.insert(0, str(pathlib.Path(__file__).parent))
import format_matrix  # noqa: E402


def test_the_document_has_the_tables():
    document = format_matrix.DOCUMENT.read_text(encoding="utf-8")
    assert format_matrix.make_text() in document, "run Testing/Integration/format_matrix.py --write"


def test_wrong_values_are_found():
    truth = format_matrix.move(format_matrix.make(), "points")
    found = {"points": truth["points"] + [0, 0, 0.01], "rgb": 0.5 * truth["rgb8"],
             "times": truth["times"] + 2.0, "classes": truth["classes"] + 1,
             "returns": truth["returns"][:, ::-1], "names": ["house", "ground", "tree"]}  # fmt: skip
    columns = [each for each in format_matrix.COLUMNS if each not in ("feet", "degrees")]
    cells = {column: format_matrix.classify(column, truth, found) for column in columns}
    assert cells.pop("points") == "1e-02"
    feet = format_matrix.move(truth, "feet")
    metres = {"points": feet["points"] * format_matrix.SURVEY_FOOT}
    assert format_matrix.classify("feet", feet, metres) == "as metres"
    assert format_matrix.classify("feet", feet, {"points": feet["points"] + 10}) == "wrong"
    assert set(cells.values()) == {"wrong"}
    assert format_matrix.classify("classes", truth, {}) == "–"
    assert (
        format_matrix.classify("rgb16", truth, {"rgb": np.rint(truth["rgb16"] * 255) / 255})
        == "8 bits"
    )
