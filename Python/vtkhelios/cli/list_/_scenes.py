# SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
# SPDX-License-Identifier: BSD-3-Clause
"""The list of vtkhelios list scenes."""

from ...catalogue import find_scenes

COLUMNS = ("scene", "name", "parts", "tables")
LEGEND = "tables: of parts; Docs/scenes.md describes both. vtkhelios new NAME makes a scene and its survey"


def find(text, assets, warn):
    """Returns the scenes of the working directory and of the folders of --assets."""
    return find_scenes(text, [".", *assets], warn)


def explain_none(text):
    """The error if nothing is found."""
    with_words = f'with "{text}" in its id or name ' if text else ""
    return (
        f"no scene {with_words}in the XML files of the working directory and of --assets; give --assets DIR, "
        "or make one: vtkhelios new NAME"
    )


def row_of(scene):
    """Returns the words of a line."""
    return scene.reference, scene.name, str(scene.parts), str(scene.tables)


def facts_of(scene):
    """Returns the facts that --json prints for a scene."""
    return scene._asdict()
