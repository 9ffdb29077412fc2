# SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
# SPDX-License-Identifier: BSD-3-Clause
"""Example surveys to start from: a folder with a small scene, a survey and a README.

>>> from vtkhelios.example_surveys import write_example
>>> write_example("forest", "my_forest")

Texts and XML files are copied from Data/Examples. Meshes, rasters and tables are made by the module
of the kind, always the same bytes. To add a kind: its line in KINDS, a folder of Data/Examples with
survey.xml, scene.xml and README.md, and a module with ``write_geometry(folder)``.
"""

import importlib
import os
import pathlib
import shutil

from ..core.files import new_folder
from ..core.folders import data_directory

__all__ = ["COMMANDS", "KINDS", "write_example"]

KINDS = {
    "tls": "a house and its yard, from two positions of a tripod",
    "als": "a hamlet in the hills, from two strips of an aircraft",
    "uls": "an orchard, from a multicopter",
    "mls": "a street, from a car that follows a recorded trajectory",
    "street": "a street with traffic, from a spinning head on a car: data for robots",
    "forest": "a stand with undergrowth, from three positions of a tripod",
    "city": "blocks of houses as CityJSON, from crossing strips of an aircraft",
    "river": "a river with its bed, a bridge and willows, from two strips of a bathymetric aircraft",
}

# Commands to run in the folder, of kinds for which a plain run is not all; the survey is {0}.xml.
COMMANDS = {
    "forest": ("run {0}.xml --pulses --hits --format vtp", "leafarea output/{0} --voxel 0.5"),
}


def write_example(kind, folder):
    """Makes a folder with an example survey; returns its files (Paths in it), sorted.

    kind
        one of KINDS.
    folder
        a new folder; missing parents are made, too. The survey is <name of the folder>.xml.

    The folder appears when it is complete. Raises ValueError for an unknown kind, FileExistsError
    if the folder exists, and OSError if a file cannot be written.
    """
    if kind not in KINDS:
        raise ValueError(f"kind is {kind!r}; known: {', '.join(KINDS)}")
    folder = pathlib.Path(os.path.abspath(folder))
    if os.path.lexists(folder):
        raise FileExistsError(f"{folder}: exists and is kept; give another name, or remove it")
    with new_folder(folder) as unfinished:
        _write_files(kind, folder.name, unfinished)
    return sorted(path for path in folder.rglob("*") if path.is_file())


def _write_files(kind, name, folder):
    shipped = data_directory() / "Examples"
    shutil.copy(shipped / "materials.mtl", folder)
    for path in (shipped / kind).iterdir():
        if path.name != "README.md":
            new_name = f"{name}.xml" if path.name == "survey.xml" else path.name
            shutil.copy(path, folder / new_name)
    pages = (shipped / kind / "README.md", shipped / "commands.md")
    text = "".join(page.read_text(encoding="utf-8") for page in pages)
    (folder / "README.md").write_text(text.replace("@NAME@", name), encoding="utf-8")
    importlib.import_module(f".{kind}", __name__).write_geometry(folder)
