# SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
# SPDX-License-Identifier: BSD-3-Clause
"""Files and colours of materials, which MTL files have beside the materials of a scene."""

import pathlib

from ...core.paths import text_from_vtk

COLOURS = ("ka", "kd", "ks")


def find_file(survey, part, folders):
    """Returns the MTL file of a part of OBJ, which is searched in folders, or None."""
    name = text_from_vtk(survey.vtk.GetPartAttribute(part, "objloader/filepath"))
    paths = (pathlib.Path(folder, name) for folder in folders) if name else ()
    path = next((each for each in paths if each.is_file()), None)
    if path is None:
        return None
    with open(path, errors="replace") as lines:
        line = next((each for each in lines if each.startswith("mtllib ")), None)
    return path.parent / line.split(maxsplit=1)[1].strip() if line else None


def read_colours(path, name):
    """Returns the colours of a material of an MTL file: ka, kd and ks; zeros where it has none."""
    found, inside = dict.fromkeys(COLOURS, (0.0, 0.0, 0.0)), False
    if path is None or not path.is_file():
        return found
    for line in path.read_text(errors="replace").splitlines():
        key, _, rest = line.strip().partition(" ")
        if key == "newmtl":
            inside = rest.strip() == name
        elif inside and key.lower() in COLOURS and rest[:1].strip():
            numbers = rest.split()[:3]
            if all(each.replace(".", "", 1).replace("-", "").isdigit() for each in numbers):
                found[key.lower()] = tuple(map(float, numbers))
    return found
