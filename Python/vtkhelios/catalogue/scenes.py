# SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
# SPDX-License-Identifier: BSD-3-Clause
"""Scenes of the XML files in folders. None is part of vtkHelios."""

import typing

from ._files import has_words, read_folders, read_root


class SceneEntry(typing.NamedTuple):
    """A scene of an XML file."""

    reference: str  # reference in surveys: file.xml#id
    id: str
    name: str
    parts: int  # elements <part>
    tables: int  # elements <partTable>


def find_scenes(text="", folders=(".",), warn=None):
    """The scenes of the XML files in folders, in the order of their files.

    text
        words that all occur in the reference or name, in upper or lower case. Default: all.
    folders
        of each, its XML files and its subfolders' XML files. Default: the working directory.
    warn
        see find_scanners().
    """
    found = read_folders(_read_file, folders, warn)
    return [each for each in found if has_words(text, " ".join(each[:3]))]


def _read_file(path, name):
    return [
        SceneEntry(
            f"{name}#{scene.get('id', '')}",
            scene.get("id", ""),
            scene.get("name", ""),
            len(scene.findall("part")),
            len(scene.findall("partTable")),
        )
        for scene in read_root(path).iter("scene")
    ]
