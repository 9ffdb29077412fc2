# SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
# SPDX-License-Identifier: BSD-3-Clause
"""Commands by the ending of files: the list in errors and Docs/files.md.

FORMATS lists the endings of points, where an ending is added; the dialect's loaders
(heliosXmlFilter.cxx) list the meshes, and vtkHeliosDialect the documents; heliosCloudReader.cxx lists
the viewer's own.
"""

from ..core.classes import vtk_class
from ..core.paths import to_vtk
from ..core.reading import is_document

# By the end of a name, the longest first: module, reader, writer (None: it is read only).
FORMATS = {
    ".copc.laz": ("_copc", "CopcReader", "CopcWriter"),
    ".las": ("_las", "LasReader", "LasWriter"),
    ".laz": ("_las", "LasReader", "LazWriter"),
    ".xyz": ("_text", "TextReader", "TextWriter"),
    ".csv": ("_csv", "TextReader", "CsvWriter"),
    ".txt": ("_text", "TextReader", None),
    ".asc": ("_text", "TextReader", None),
    ".pts": ("_text", "TextReader", None),
    ".ptx": ("_text", "TextReader", None),
    ".pvtp": ("_vtp", "PiecesReader", "PiecesWriter"),
    ".vtp": ("_vtp", "VtpReader", "VtpWriter"),
    ".ply": ("_ply", "PlyReader", "PlyWriter"),
    ".pcd": ("_pcd", "PcdReader", "PcdWriter"),
    ".e57": ("_e57", "E57Reader", "E57Writer"),
}

# Points that the viewer reads itself; it gets the others as LAS.
IN_VIEWER = (
    ".xyz", ".txt", ".asc", ".csv", ".pts", ".ptx", ".las", ".laz", ".copc.laz", ".vtp", ".pvtp",
    ".ply",
)  # fmt: skip

# The loaders of a scene that make voxels of points.
VOXELS = {".xyz": "xyzloader", ".las": "lasloader", ".laz": "lasloader", ".copc.laz": "lasloader"}
VOXELS[".vox"] = "detailedvoxels"

COMMANDS = ("info", "convert from", "convert to", "compare", "plan", "view", "scene")


def _dialect():
    return vtk_class("vtkHeliosDialect")


def points():
    """Returns the endings of points, the longest first."""
    return tuple(FORMATS)


def meshes():
    """Returns the endings of meshes."""
    return tuple(_dialect().GetMeshEndings().split(", "))


def is_mesh_ending(path):
    """Returns whether the ending of a name belongs to a mesh, which for a .ply only its content tells."""
    return bool(_dialect().FindLoader(to_vtk(path)))


def documents():
    """Returns the endings of documents."""
    return tuple(_dialect().GetDocumentEndings().split(", "))


def converted_for_view():
    """The endings of points that the viewer does not read itself."""
    return tuple(each for each in points() if each not in IN_VIEWER)


def known():
    """Returns all endings as text, for errors."""
    return (
        f"{', '.join(points())}; meshes: {', '.join(meshes())}; documents: {', '.join(documents())}"
    )


def explain_no_points(path):
    """Why a file is not read as points, and the remedy."""
    if is_document(path):
        return (
            f"{path}: is a document, not points; vtkhelios info, validate and view read it, and "
            "vtkhelios run makes points of a survey"
        )
    if is_mesh_ending(path):
        return (
            f"{path}: is a mesh, not points; vtkhelios info, plan and view read it, and "
            "vtkhelios convert makes an .obj of it"
        )
    return f"{path}: its ending is not of a known format; known: {known()}"


def describe(ending):
    """Describes the commands for an ending, in the order of COMMANDS; empty: none."""
    uses = dict.fromkeys(COMMANDS, "")
    if ending in FORMATS:
        uses |= {"info": "points", "convert from": "points", "compare": "points"}
        uses["convert to"] = "points" if FORMATS[ending][2] else ""
        uses["view"] = "points"
    if ending in IN_VIEWER:
        uses["view"] = "points"
    if loader := _dialect().FindLoader("a" + ending):
        kind = "with faces: mesh" if ending in FORMATS else "mesh"
        for command in ("info", "plan", "view"):
            uses[command] = ", ".join(filter(None, (uses[command], kind)))
        uses["convert from"] = ", ".join(filter(None, (uses["convert from"], f"{kind}, to .obj")))
        uses["convert to"] = uses["convert to"] or ("meshes" if ending == ".obj" else "")
        uses["scene"] = f"`{loader}`"
    elif ending in VOXELS:
        uses["scene"] = f"`{VOXELS[ending]}`"
    if ending in documents():
        uses |= {"info": "contents", "plan": "scene", "view": "survey, scene", "scene": "`<scene>`"}
        uses |= {"convert from": "documents", "convert to": "documents"}
    return tuple(uses.values())


def list_endings():
    """Returns all endings, each once: points, meshes, then the others."""
    return tuple(dict.fromkeys((*points(), *meshes(), *IN_VIEWER, *VOXELS, *documents())))


def list_endings_of(command):
    """Returns the endings of the files that a command takes, for completion; empty: of any file."""
    columns = [i for i, name in enumerate(COMMANDS) if name.split()[0] == command]
    return tuple(ending for ending in list_endings() if any(describe(ending)[i] for i in columns))


def make_table():
    """Returns the table of Docs/files.md."""
    lines = [f"| ending | {' | '.join(COMMANDS)} |", f"|{'---|' * (1 + len(COMMANDS))}"]
    for ending in list_endings():
        cells = " | ".join(describe(ending)).replace("|  |", "| |").replace("|  |", "| |")
        lines.append(f"| `{ending}` | {cells} |".replace("|  |", "| |"))
    return "\n".join(lines) + "\n"
