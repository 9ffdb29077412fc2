# SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
# SPDX-License-Identifier: BSD-3-Clause
"""The documents of the checkout: those that README.md and Docs/README.md lead to.

The site has them where the checkout has them, so that relative links stay valid. Links to folders
lead to their README; files that are not documents are copied.
"""

import functools
import os
import pathlib
import re
import shutil

from . import markdown

ROOT = pathlib.Path(__file__).resolve().parents[3]
HOME, MAP = ROOT / "README.md", ROOT / "Docs/README.md"
LINK = re.compile(r"(?<=\]\()([^)\s]+)(?=\))")
PICTURE = re.compile(r"!\[([^\]]*)\]\(([^)\s]+)\)")
FENCE = re.compile(r"(^```.*?^```$)", re.M | re.S)


@functools.cache
def find():
    """The documents in the order of their first link, README.md first."""
    found = [HOME]
    for document in found:
        for target in (_target(link, document) for link in links_of(document)):
            if target and target.suffix == ".md" and target not in found:
                found.append(target)
    return found


def make(folder, reference):
    """Copies the documents; the first page also has the version and the table of contents, with the
    entries of the reference."""
    for document in find():
        place = folder / page_of(document)
        place.parent.mkdir(parents=True, exist_ok=True)
        place.write_text(text_of(document) + _pages_below(document))
        for target in (_target(link, document) for link in links_of(document)):
            if target and target.suffix != ".md":
                copy = folder / target.relative_to(ROOT)
                copy.parent.mkdir(parents=True, exist_ok=True)
                shutil.copy2(target, copy)
    first = folder / page_of(HOME)
    text = first.read_text()
    text = text.replace("\n", "\n\nVersion {sub-ref}`release`\n", 1)
    for caption, names in {**sections(), **reference}.items():
        text += "\n" + markdown.contents(names, caption)
    first.write_text(text)


def sections():
    """Caption and pages of the tables of Docs/README.md, and of what no table leads to."""
    found, listed = {}, {HOME, MAP}
    for part in re.split(r"(?m)^(?=\| .* \| \|$)", MAP.read_text())[1:]:
        targets = [_target(link, MAP) for link in LINK.findall(part)]
        pages = [target for target in dict.fromkeys(targets) if target and target.suffix == ".md"]
        caption = part.split("|")[1].strip()
        found[caption[:1].upper() + caption[1:]] = [_name(page) for page in pages]
        listed.update(pages)
    listed.update(page for document in listed.copy() for page in _below(document))
    rest = [page for page in find() if page not in listed]
    found["The project"] = [_name(page) for page in [MAP, *rest]]
    return found


def _below(document):
    """The other pages in the folder of a README.md below Docs."""
    if document.name != "README.md" or document.parent.parent != MAP.parent:
        return []
    return [page for page in find() if page.parent == document.parent and page != document]


def _pages_below(document):
    pages = _below(document)
    return "\n" + markdown.contents([f"/{_name(page)}" for page in pages]) if pages else ""


def text_of(document):
    """Its text, with the links of the site; what is in fences stays."""
    parts = FENCE.split(document.read_text())
    parts[::2] = [LINK.sub(lambda link: _site_link(link[1], document), part) for part in parts[::2]]
    return "".join(parts)


def links_of(document):
    """Its relative links, in order."""
    text = FENCE.sub("", document.read_text())
    return [link for link in LINK.findall(text) if not link.startswith(("https:", "http:"))]


def pictures_of(document):
    """(text, link from the site's root) of its pictures."""
    return [
        (text, str(_target(link, document).relative_to(ROOT)))
        for text, link in PICTURE.findall(FENCE.sub("", document.read_text()))
    ]


def title_of(document):
    """Its first heading."""
    return re.search(r"^# (.*)$", document.read_text(), re.M)[1]


def page_of(document):
    """Its file in the site, from the root."""
    return "index.md" if document == HOME else str(document.relative_to(ROOT))


def _name(document):
    return page_of(document).removesuffix(".md")


def _target(link, document):
    """The file of a link; of a folder its README.md, or None."""
    name = link.partition("#")[0]
    target = pathlib.Path(os.path.normpath(document.parent / name)) if name else document
    if target.is_dir():
        target /= "README.md"
    return target if target.is_file() else None


def _site_link(link, document):
    if link.startswith(("https:", "http:", "#")):
        return link
    target, anchor = _target(link, document), link.partition("#")[2]
    if target is None:  # a folder without a README: the page itself
        return f"/{page_of(document)}"
    return f"/{page_of(target)}" + (f"#{anchor}" if anchor else "")
