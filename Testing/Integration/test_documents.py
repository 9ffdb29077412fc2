# SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
# SPDX-License-Identifier: BSD-3-Clause
"""Links, file names and class names in the documents exist."""

import pathlib
import re

import pytest

ROOT = pathlib.Path(__file__).resolve().parents[2]
FOLDERS = [
    path for path in ROOT.iterdir() if path.is_dir() and path.name[0].isupper()
]  # Apps, Data, Docs, ...: no build folder, no hidden ones
DOCUMENTS = sorted([*ROOT.glob("*.md"), *(file for path in FOLDERS for file in path.rglob("*.md"))])
SOURCES = {
    file.name
    for path in (*FOLDERS, ROOT / "findings")
    for suffix in ("*.h", "*.cxx", "*.py", "*.sh", "*.ipynb")
    for file in path.rglob(suffix)
}


def anchors_of(document):
    """The anchors of the headings of a document, as public forges make them."""
    headings = re.findall(r"^#+ (.*)$", document.read_text(), re.M)
    return {re.sub(r"[^\w\- ]", "", heading.lower()).replace(" ", "-") for heading in headings}


def find_broken_links(document):
    """The relative links of a document whose file or anchor is missing."""
    text = re.sub(r"^```.*?^```$", "", document.read_text(), flags=re.M | re.S)
    broken = []
    for link in re.findall(r"\]\(([^)\s]+)\)", text):
        if link.startswith(("https://", "http://")):
            continue
        name, _, anchor = link.partition("#")
        target = document.parent / name if name else document
        if not target.exists() or (anchor and anchor not in anchors_of(target)):
            broken.append(link)
    return broken


def find_missing_files(text):
    """The paths below the checkout, the sources and the classes in a text that do not exist."""
    folders = "|".join(path.name for path in FOLDERS)
    # Testing/Cxx and Testing/Python are folders of every module.
    paths = re.findall(
        rf"(?<![\w/.])(?!Testing/(?:Cxx|Python))((?:{folders})/[\w./-]*[\w/])(?![\w*<])", text
    )
    files = re.findall(r"(?<![\w.*>-])(?:[\w-]+/)*([\w-]+\.(?:h|cxx|py|sh|ipynb))\b", text)
    classes = [
        name + ".h"
        for name in re.findall(r"(?<!-)\b(vtkHelios[A-Z]\w*[a-z]\w*)(?![\w<*.]|::\w+Core)", text)
        if not name.endswith("Tests")
    ]
    missing = [name for name in paths if not (ROOT / name).exists()]
    return missing + [name for name in [*files, *classes] if name not in SOURCES]


@pytest.mark.parametrize("document", DOCUMENTS, ids=lambda path: str(path.relative_to(ROOT)))
def test_links(document):
    assert find_broken_links(document) == []


@pytest.mark.parametrize("document", DOCUMENTS, ids=lambda path: str(path.relative_to(ROOT)))
def test_named_files(document):
    assert find_missing_files(document.read_text()) == []


def test_every_page_is_listed():
    index = (ROOT / "Docs/README.md").read_text()
    pages = {path.name for path in (ROOT / "Docs").glob("*.md")} - {"README.md"}
    assert {page for page in pages if f"({page})" not in index} == set()


def test_missing_links_are_found(tmp_path):
    (tmp_path / "other.md").write_text("# One Heading, with `code`\n")
    document = tmp_path / "page.md"
    document.write_text(
        "[a](other.md) [b](other.md#one-heading-with-code) [c](https://example.org/none)\n"
        "[d](none.md) [e](other.md#none)\n```\nmap[0](none)\n```\n"
    )
    assert find_broken_links(document) == ["none.md", "other.md#none"]


def test_missing_files_are_found():
    good = "Testing/run.sh `build/Docs/x` `Data/Surveys/*.xml` `Scanner/Core/` vtkHeliosScanner test_*.py"
    assert find_missing_files(good) == []
    bad = "(Docs/none.md) `TestNone.cxx` none/none.py vtkHeliosNone, `vtkHeliosScaner::Name`"
    assert find_missing_files(bad) == [
        "Docs/none.md",
        "TestNone.cxx",
        "none.py",
        "vtkHeliosNone.h",
        "vtkHeliosScaner.h",
    ]


def test_version():
    """The version of CMakeLists.txt equals that of the newest release, the citation and the project that uses it."""
    version = re.search(
        r"project\(vtkHelios VERSION ([\d.]+)", (ROOT / "CMakeLists.txt").read_text()
    )
    release = re.search(r"## \[([\d.]+)\] - ([\d-]+)", (ROOT / "CHANGELOG.md").read_text())
    citation = (ROOT / "CITATION.cff").read_text()
    assert release.group(1) == version.group(1)
    assert f"\nversion: {release.group(1)}\n" in citation
    assert f"\ndate-released: {release.group(2)}\n" in citation
    minor = version.group(1).rpartition(".")[0]
    assert f"vtkHelios {minor} REQUIRED" in (ROOT / "Testing/Install/CMakeLists.txt").read_text()
    assert f"`libvtkhelios{minor}`" in (ROOT / "Apps/Packages/README.md").read_text()
