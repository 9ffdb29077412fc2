# SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
# SPDX-License-Identifier: BSD-3-Clause
"""The pictures of all documents on one page, each with a link to the page that explains it."""

from . import documents, markdown


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
