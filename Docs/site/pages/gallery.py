# SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
# SPDX-License-Identifier: BSD-3-Clause
"""The pictures of all documents on one page, each with a link to the page that explains it; and
thumbnails for the first page."""

import pathlib
import re

from vtkmodules.vtkImagingCore import vtkImageExtractComponents, vtkImageResize
from vtkmodules.vtkIOImage import vtkImageReader2Factory, vtkJPEGWriter

from . import documents, markdown

TABLE = re.compile(r"(?m)^(?:\|.*\n)+")
CARD = re.compile(r"!\[([^\]]*)\]\(([^)]*)\) (\[[^\]]*\]\([^)]*\))")
THUMBNAILS, WIDTH, HEIGHT = "thumbnails", 360, 225  # the most pixels


def make(folder):
    """Writes the page."""
    parts = ["# Gallery\n"]
    for document in documents.find():
        pictures = documents.pictures_of(document)
        if pictures:
            title = markdown.escape(documents.title_of(document))
            parts.append(f"## [{title}]({documents.page_of(document)})\n")
            parts += [f"![{text}]({link})\n\n{text}\n" for text, link in pictures]
    (folder / "gallery.md").write_text("\n".join(parts))
    return ["gallery"]


def make_cards(folder, text):
    """The text of the first page, whose table of pictures with links is one of thumbnails."""
    (folder / THUMBNAILS).mkdir()
    table = TABLE.search(text)
    cards = []
    for words, picture, link in CARD.findall(table[0]):
        file = f"/{THUMBNAILS}/{pathlib.Path(picture).stem}.jpg"
        write_thumbnail(documents.ROOT / picture.lstrip("/"), folder / file[1:])
        target = link[link.index("(") + 1 : -1]
        cards.append(f"[![{words}]({file})]({target}) {link}")
    lines = "\n\n".join(cards)
    return text.replace(table[0], f"```{{container}} gallery\n{lines}\n```\n")


def write_thumbnail(source, target):
    """Writes a picture as JPEG, as large as a card permits."""
    reader = vtkImageReader2Factory.CreateImageReader2(str(source))
    reader.SetFileName(str(source))
    colours, resize, writer = vtkImageExtractComponents(), vtkImageResize(), vtkJPEGWriter()
    reader.Update()
    width, height, _ = reader.GetOutput().GetDimensions()
    scale = min(WIDTH / width, HEIGHT / height)
    colours.SetInputConnection(reader.GetOutputPort())
    colours.SetComponents(0, 1, 2)  # without opacity
    resize.SetInputConnection(colours.GetOutputPort())
    resize.SetOutputDimensions(round(scale * width), round(scale * height), 1)
    writer.SetInputConnection(resize.GetOutputPort())
    writer.SetFileName(str(target))
    writer.SetQuality(85)
    writer.Write()
