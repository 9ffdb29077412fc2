# SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
# SPDX-License-Identifier: BSD-3-Clause
"""The pages of the documentation site are complete, and their links lead somewhere."""

import argparse
import pathlib
import re
import subprocess
import sys

import pytest
from vtkmodules.vtkIOImage import vtkJPEGReader

import vtkhelios
from vtkhelios import cli

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


def test_every_option_has_an_entry(pages):
    parsers = next(
        each for each in cli.make_parser()._actions if isinstance(each, argparse._SubParsersAction)
    ).choices
    texts = {name: (pages / f"commands/{name}.md").read_text() for name in cli.commands()}
    for name, text in texts.items():
        assert text.startswith(f"# vtkhelios {name}\n\n```{{program}} vtkhelios {name}\n```\n")
        entries = re.findall(r"```\{option\} (.*)\n", text)
        assert len(entries) == len(set(entries)) and "-h, --help" in entries, name
        names = {word for entry in entries for word in re.findall(r"(?<!\S)--?[a-z][\w-]*", entry)}
        shown = (each for each in parsers[name]._actions if each.help is not argparse.SUPPRESS)
        assert {word for each in shown for word in each.option_strings} <= names, name
    assert "```{option} --energy-tolerance F\nadaptive beam sampling: RMS of" in texts["run"]
    assert "```{option} -o FILE, --output FILE\n" in texts["leafarea"]
    assert "```{option} --no-eye-dome\nwithout eye-dome" in texts["view"]
    assert "## Field work\n\n```{option} --setup-time S\n" in texts["plan"]
    assert "\nrecommendation:\n  --range 5mm --missed 1%   the fastest" in texts["tradeoff"]


def test_declarations_in_cpp(pages):
    text = (pages / "classes/vtkHeliosScanner.md").read_text()
    assert "```{cpp:class} vtkHeliosScanner : public vtkHeliosInstrument\n" in text
    assert "```{cpp:function} virtual void vtkHeliosScanner::SetPulseStep(vtkIdType _arg)\n" in text
    text = (pages / "classes/vtkHeliosEchoDetection.md").read_text()
    assert (
        "```{cpp:function} static bool vtkHeliosEchoDetection::AddDetector(const std::string &name, "
        "vtkHeliosEchoDetector *prototype)\n"
    ) in text


def test_first_page(pages):
    text = (pages / "index.md").read_text()
    assert text.startswith("# vtkHelios\n\nVersion {sub-ref}`release`\n")
    cards = re.findall(r"(?m)^\[!\[.+?\]\(/(thumbnails/.+?)\)\]\(/(.+?)\) \[.+?\]\(/\2\)$", text)
    assert len(cards) >= 12 and len(set(cards)) == len(cards)
    for picture, page in cards:
        reader = vtkJPEGReader()
        reader.SetFileName(str(pages / picture))
        reader.Update()
        width, height, _ = reader.GetOutput().GetDimensions()
        assert 100 < width <= 360 and 80 < height <= 225
        assert (pages / page.partition("#")[0]).is_file()


def test_commands(pages):
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
