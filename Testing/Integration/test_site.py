# SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
# SPDX-License-Identifier: BSD-3-Clause
"""The pages of the documentation site are complete, and their links lead somewhere."""

import pathlib
import re
import subprocess
import sys

import pytest

import vtkhelios

ROOT = pathlib.Path(__file__).resolve().parents[2]
sys.path.insert(0, str(ROOT / "Docs/site"))

from pages import __main__ as site  # noqa: E402
from pages import classes, documents, markdown  # noqa: E402


@pytest.fixture(scope="module")
def pages(tmp_path_factory):
    folder = tmp_path_factory.mktemp("site") / "source"
    site.main(folder)
    return folder


def test_every_class_and_property_has_its_text(pages):
    for name in vtkhelios.__all__:
        if name.startswith("vtkHelios"):
            text = (pages / f"classes/{name}.md").read_text()
            for key in classes.own_properties(getattr(vtkhelios, name)):
                assert f"\n### {markdown.escape(key)}\n" in text, (name, key)
    text = (pages / "classes/vtkHeliosInstrument.md").read_text()
    assert "the bin size of the waveform \\[ns\\]. Valid range" in text
    assert "### abort" not in text  # method of every VTK algorithm


def test_every_document_is_in_a_table_of_contents(pages):
    listed = set()
    for page in pages.rglob("*.md"):
        for block in re.findall(r"```\{toctree\}\n(.*?)```", page.read_text(), re.S):
            names = [line for line in block.split("\n") if line and line[0] != ":"]
            listed |= {
                pages / f"{name[1:]}.md" if name[0] == "/" else page.parent / f"{name}.md"
                for name in names
            }
    assert set(pages.rglob("*.md")) - {pages / "index.md"} == listed


def test_links_and_pictures(pages):
    for page in pages.rglob("*.md"):
        text = documents.FENCE.sub("", page.read_text())
        for link in documents.LINK.findall(text):
            name = link.partition("#")[0]
            if name and not link.startswith("http"):
                place = pages / name[1:] if name[0] == "/" else page.parent / name
                assert place.is_file(), (page, link)


def test_commands(pages):
    assert "--energy-tolerance F" in (pages / "commands/run.md").read_text()
    assert "[vtkhelios run](run.md)" in (pages / "commands/index.md").read_text()


def test_docstrings_as_markdown():
    text = """Sends ``a|b`` over *c*.

    length
        of a pulse
        [ns]

    with:
    - one,
      continued
    - two

    >>> scan()
    """
    assert markdown.prose(text).split("\n\n") == [
        "Sends `a\\|b` over \\*c\\*.",
        "- `length`: of a pulse \\[ns\\]",
        "with:",
        "- one, continued\n- two",
        "```pycon\n>>> scan()\n```",
    ]


@pytest.mark.slow
def test_site_is_built(tmp_path):
    done = subprocess.run(
        [ROOT / "Docs/site/build.sh", tmp_path], capture_output=True, text=True, check=False
    )
    assert done.returncode == 0, done.stderr
    assert "vtkHeliosScanner" in (tmp_path / "classes/index.html").read_text()
