# SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
# SPDX-License-Identifier: BSD-3-Clause
"""The tables of Docs/validation are those that the studies make."""

import importlib
import pathlib
import re
import types

import pytest

ROOT = pathlib.Path(__file__).resolve().parents[3]
PAGES = ROOT / "Docs" / "validation"
PAGE = """# Page

<!-- table a: begin -->
| x | y | z |
|---|---|---|
| 1 | p | old |
| 2 | q | kept |
<!-- table a: end -->

text
"""


@pytest.fixture
def pages(monkeypatch):
    monkeypatch.syspath_prepend(ROOT / "Python/studies")
    return importlib.import_module("_pages")


@pytest.fixture
def validation(monkeypatch):
    monkeypatch.syspath_prepend(ROOT / "Python/studies")
    return importlib.import_module("validation")


@pytest.fixture
def made(validation, monkeypatch, tmp_path):
    """A page and a study with one table of it."""
    (tmp_path / "page.md").write_text(PAGE)
    pages = importlib.import_module("_pages")

    def make_tables(_data, _tools):
        rows = [["1", "p", "new"], ["2", "q"], ["3", ""]]
        return [pages.Table("page.md", "a", ["x", "y", "z"], rows, keys=2)]

    study = types.SimpleNamespace(make_tables=make_tables)
    monkeypatch.setattr(validation, "STUDIES", ("one",))
    monkeypatch.setattr(validation.importlib, "import_module", lambda _name: study)
    return validation, tmp_path, study


def test_a_table_replaces_that_of_its_page(made, capsys):
    """Rows of keys only come from the page; without one there, they are left out."""
    validation, folder, _ = made
    assert validation.main(["--pages", str(folder)]) == 0
    new = (folder / "page.md").read_text()
    assert new == PAGE.replace("| old |", "| new |")
    assert "without data for 2, q; left as it is" in capsys.readouterr().out
    assert validation.main(["--pages", str(folder)]) == 0
    assert "no table differs" in capsys.readouterr().out


def test_check_writes_nothing(made, capsys):
    validation, folder, _ = made
    assert validation.main(["--check", "--pages", str(folder)]) == 1
    assert "page.md, table a: is out of date" in capsys.readouterr().out
    assert (folder / "page.md").read_text() == PAGE


def test_a_study_without_its_files_is_named(made, capsys):
    validation, folder, study = made

    def fail(_data, _tools):
        return open(folder / "none.laz", encoding="utf-8")

    study.make_tables = fail
    assert validation.main(["--check", "--pages", str(folder)]) == 0
    assert f"one: without {folder / 'none.laz'}; its tables are left" in capsys.readouterr().out


def test_slow_studies_are_left_out(made, capsys):
    """By --quick, unless they are named."""
    validation, folder, study = made
    study.SLOW = True
    assert validation.main(["--check", "--quick", "--pages", str(folder)]) == 0
    assert "one: slow, left out" in capsys.readouterr().out
    assert validation.main(["one", "--check", "--quick", "--pages", str(folder)]) == 1


def test_a_page_without_the_comments(pages):
    table = pages.Table("page.md", "b", ["x"], [["1"]])
    with pytest.raises(ValueError, match="page.md: no table b; add the lines <!-- table b: begin"):
        pages.replace_table(PAGE, table)
    with pytest.raises(ValueError, match="no table a"):
        pages.replace_table(PAGE.replace("table a: end", "table a: e"), table._replace(name="a"))


def test_an_unknown_study(validation, capsys):
    with pytest.raises(SystemExit):
        validation.main(["wave"])
    assert "no study wave; there are patterns, " in capsys.readouterr().err


def test_columns_of_rows(pages):
    assert pages.transpose(["", "a"], [["x", "1"], ["y", "2"]]) == (
        ["", "x", "y"],
        [["a", "1", "2"]],
    )


SLOW_PAGES = {"ahn3.md", "forest.md"}  # a minute; real_clouds has tests of its own


def test_the_pages_are_up_to_date(validation, pages, monkeypatch, capsys):
    """All tables between comments are made from the data, and equal the pages'."""
    data = importlib.import_module("_study").real_data()
    if not all((data / name).is_dir() for name in ("als", "pattern", "sensor", "waveform")):
        pytest.skip("no data of real instruments")
    made, replace = set(), pages.replace_table

    def record(text, table):
        made.add((table.page, table.name))
        return replace(text, table)

    monkeypatch.setattr(pages, "replace_table", record)
    assert validation.main(["--check", "--quick"]) == 0, capsys.readouterr().out
    named = {
        (path.name, name)
        for path in PAGES.glob("*.md")
        if path.name not in SLOW_PAGES
        for name in re.findall(r"^<!-- table (.*): begin -->$", path.read_text(), re.M)
    }
    assert made == named and len(named) > 8
