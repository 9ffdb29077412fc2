# SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
# SPDX-License-Identifier: BSD-3-Clause
"""The documents of folders, XML and YAML."""

import pathlib
import xml.etree.ElementTree as ElementTree

from ..core.folders import data_directory
from ..core.reading import is_document, read_xml


class CatalogueError(ValueError):
    """A file of the catalogue that cannot be read: file, place and cure."""


def shipped_assets():
    """The folder of the scanners and platforms that are part of vtkHelios."""
    return data_directory() / "Assets"


def read_folders(read_file, folders, warn=None):
    """Joins the results of read_file(path, name) for the documents of folders and of their subfolders.

    name is the path in its folder. warn is called with the message of each file that cannot be read;
    without it, CatalogueError is raised.
    """
    found = []
    for folder in dict.fromkeys(map(pathlib.Path, folders)):
        for path in filter(is_document, [*sorted(folder.glob("*")), *sorted(folder.glob("*/*"))]):
            try:
                found += read_file(path, path.relative_to(folder).as_posix())
            except CatalogueError as error:
                if warn is None:
                    raise
                warn(str(error))
    return found


def read_root(path):
    """Returns the root element of a document. Raises CatalogueError."""
    try:
        return ElementTree.fromstring(read_xml(path))
    except (ElementTree.ParseError, OSError, LookupError) as error:
        raise CatalogueError(f"{path}: is not readable XML: {error}; correct it") from None
    except ValueError as error:
        raise CatalogueError(str(error)) from None


def has_words(words, text):
    """Returns whether all words occur in a text, in upper or lower case."""
    return all(word in text.lower() for word in words.lower().split())
