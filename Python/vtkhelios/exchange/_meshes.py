# SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
# SPDX-License-Identifier: BSD-3-Clause
"""Meshes of other libraries as numpy arrays; no library is imported, and none is needed.

read_parts() recognizes a mesh by its attributes:

===================  ==============================================================
another VTK          GetPoints() and GetPolys(): vtkPolyData, pyvista.PolyData
Open3D               vertices and triangles; vertex and triangle of its tensors
trimesh              vertices and faces; graph and geometry of its scenes
meshio               points and cells, of which triangles and quads are used
others               points or vertices, and faces, triangles or cells
===================  ==============================================================
"""

import dataclasses
import importlib

import numpy as np

from ..array_names import MATERIAL_IDS, MATERIAL_NAME, RGB


@dataclasses.dataclass
class Mesh:
    """Polygons: corner k of polygon i is point corners[offsets[i] + k]."""

    points: np.ndarray  #: n x 3 [m]
    corners: np.ndarray
    offsets: np.ndarray  #: one more than polygons
    cell_arrays: dict = dataclasses.field(default_factory=dict)
    point_arrays: dict = dataclasses.field(default_factory=dict)
    fields: dict = dataclasses.field(default_factory=dict)  #: numpy arrays, or lists of texts


def read_parts(source):
    """Returns the meshes of an object by name, {"": Mesh} of a single one; None: of no known
    kind."""
    for read in (_read_vtk_blocks, _read_trimesh_scene):
        if (parts := read(source)) is not None:
            return parts
    for read in (_read_vtk, _read_tensors, _read_meshio, _read_plain):
        if (mesh := read(source)) is not None:
            return {"": mesh}
    return None


def _has(source, *names):
    return all(hasattr(source, name) for name in names)


# Another VTK -------------------------------------------------------------------------------------


def _read_vtk_blocks(source):
    """Returns the blocks of a vtkMultiBlockDataSet by name; those without polygons are left out."""
    if not _has(source, "GetNumberOfBlocks", "GetBlock", "GetMetaData"):
        return None
    parts = {}
    for index in range(source.GetNumberOfBlocks()):
        block = source.GetBlock(index)
        nested = None if block is None else _read_vtk_blocks(block)
        meshes = nested if nested is not None else {"": _read_vtk(block)}
        name = _block_name(source, index)
        for inner, mesh in meshes.items():
            if mesh is not None:
                parts[f"{name}/{inner}" if inner else name] = mesh
    return parts


def _block_name(source, index):
    is_named = source.HasMetaData(index)
    name = source.GetMetaData(index).Get(source.NAME()) if is_named else ""
    return name or f"block{index}"


def _read_vtk(source):
    if not _has(source, "GetPoints", "GetPolys", "GetCellData"):
        if _has(source, "IsA", "GetCellData"):
            raise TypeError(
                f"a {type(source).__name__} is not a surface; give what extract_surface() of "
                "PyVista or vtkGeometryFilter makes of it"
            )
        return None
    to_numpy, points = _converter(source), source.GetPoints()
    if source.GetNumberOfCells() != source.GetNumberOfPolys():
        raise ValueError(
            f"the mesh has {source.GetNumberOfVerts()} vertex, {source.GetNumberOfLines()} line and "
            f"{source.GetNumberOfStrips()} strip cells besides its {source.GetNumberOfPolys()} "
            "polygons; give polygons only, as triangulate() of PyVista or vtkTriangleFilter makes "
            "them with PassVerts and PassLines off"
        )
    polys = source.GetPolys()
    return Mesh(
        to_numpy(points.GetData()) if points is not None else np.empty((0, 3)),
        to_numpy(polys.GetConnectivityArray()),
        to_numpy(polys.GetOffsetsArray()),
        _read_vtk_arrays(source.GetCellData(), to_numpy),
        _read_vtk_arrays(source.GetPointData(), to_numpy),
        _read_vtk_arrays(source.GetFieldData(), to_numpy),
    )


def _converter(source):
    """vtk_to_numpy() of the VTK that made an object."""
    for kind in type(source).__mro__:
        package, _, module = kind.__module__.rpartition(".")
        if module.startswith("vtkCommon"):
            return importlib.import_module(f"{package}.util.numpy_support").vtk_to_numpy
    return np.asarray


def _read_vtk_arrays(attributes, to_numpy):
    arrays = {}
    for index in range(attributes.GetNumberOfArrays()):
        array = attributes.GetAbstractArray(index)
        name = array.GetName()
        if name and array.IsA("vtkStringArray"):
            arrays[name] = [array.GetValue(i) for i in range(array.GetNumberOfValues())]
        elif name and array.IsA("vtkDataArray"):
            arrays[name] = to_numpy(array)
    return arrays


# trimesh -----------------------------------------------------------------------------------------


def _read_trimesh_scene(source):
    """Returns the meshes of a trimesh.Scene, each at its place, by the names of their nodes."""
    if not _has(source, "graph", "geometry"):
        return None
    parts = {}
    for node in source.graph.nodes_geometry:
        transform, name = source.graph[node]
        mesh = _read_plain(source.geometry[name])
        if mesh is not None:  # else a path, or points
            mesh.points = mesh.points @ transform[:3, :3].T + transform[:3, 3]
            parts[node] = mesh
    return parts


def _add_trimesh_visual(mesh, visual):
    """Colours of faces or vertices, and the name of the material, if they are defined."""
    kind = getattr(visual, "kind", None)
    if kind == "face":
        mesh.cell_arrays[RGB] = _to_rgb(visual.face_colors)
    elif kind == "vertex":
        mesh.point_arrays[RGB] = _to_rgb(visual.vertex_colors)
    if name := getattr(getattr(visual, "material", None), "name", None):
        mesh.fields[MATERIAL_NAME] = [name]
        mesh.cell_arrays[MATERIAL_IDS] = np.zeros(len(mesh.offsets) - 1, np.int32)


def _to_rgb(colors):
    """Red, green, blue in [0, 1] of colours in [0, 1], or of integers of 8 or 16 bits."""
    colors = np.asarray(colors)[:, :3]
    full = np.iinfo(colors.dtype).max if colors.dtype.kind in "iu" else 1
    return (colors / full).astype(np.float32)


# Open3D ------------------------------------------------------------------------------------------


def _read_tensors(source):
    """Returns an open3d.t.geometry.TriangleMesh."""
    if not _has(source, "vertex", "triangle"):
        return None
    vertex, triangle = _numpy_items(source.vertex), _numpy_items(source.triangle)
    mesh = _make_mesh(vertex.pop("positions"), triangle.pop("indices"))
    for arrays, values in ((mesh.point_arrays, vertex), (mesh.cell_arrays, triangle)):
        for name, array in values.items():
            if name == "colors":
                arrays[RGB] = _to_rgb(array)
            elif name == "material_ids":
                arrays[MATERIAL_IDS] = array.reshape(-1)
            elif name != "normals":
                arrays[name] = array
    return mesh


def _numpy_items(tensors):
    return {name: tensor.cpu().numpy() for name, tensor in tensors.items()}


def _add_open3d_legacy(mesh, source):
    ids = np.asarray(source.triangle_material_ids)
    if len(ids):
        mesh.cell_arrays[MATERIAL_IDS] = ids
    if len(source.vertex_colors):
        mesh.point_arrays[RGB] = _to_rgb(source.vertex_colors)


# meshio ------------------------------------------------------------------------------------------


def _read_meshio(source):
    if not _has(source, "points", "cells", "cell_data") or not isinstance(source.cells, list):
        return None
    surface = [i for i, block in enumerate(source.cells) if block.type in _MESHIO]
    if not surface:
        kinds = ", ".join(block.type for block in source.cells) or "none"
        raise ValueError(f"the mesh has no {', '.join(_MESHIO)} cells; it has: {kinds}")
    faces = [np.asarray(source.cells[i].data) for i in surface]
    mesh = _make_mesh(source.points, faces)
    for name, blocks in source.cell_data.items():
        mesh.cell_arrays[name] = np.concatenate([np.asarray(blocks[i]) for i in surface])
    return mesh


_MESHIO = ("triangle", "quad", "polygon")


# Arrays ------------------------------------------------------------------------------------------


def _read_plain(source):
    """Returns the points and faces under their usual names."""
    points = next((getattr(source, name) for name in _POINTS if hasattr(source, name)), None)
    faces = next((getattr(source, name) for name in _FACES if hasattr(source, name)), None)
    if points is None or faces is None:
        return None
    mesh = _make_mesh(np.asarray(points), faces)
    if hasattr(source, "visual"):
        _add_trimesh_visual(mesh, source.visual)
    if hasattr(source, "triangle_material_ids"):
        _add_open3d_legacy(mesh, source)
    return mesh


_POINTS, _FACES = ("vertices", "points"), ("faces", "triangles", "cells")


def _make_mesh(points, faces):
    """Returns a mesh of faces: an array of n x k corners, several of them, or a list of each
    face's."""
    blocks = _make_blocks(faces)
    if not all(block.ndim == 2 and block.dtype.kind in "iu" for block in blocks):
        shapes = ", ".join(f"{block.dtype} {block.shape}" for block in blocks[:3])
        raise ValueError(f"faces are {shapes}; give whole numbers, the points of each face")
    sizes = np.concatenate([np.full(len(b), b.shape[1]) for b in blocks] or [np.empty(0, int)])
    corners = np.concatenate([b.reshape(-1) for b in blocks] or [np.empty(0, int)])
    return Mesh(np.asarray(points), corners, np.concatenate([[0], np.cumsum(sizes)]))


def _make_blocks(faces):
    """Faces as arrays of faces with the same number of corners."""
    if not isinstance(faces, (list, tuple)):
        return [np.asarray(faces)]  # also vectors of C++
    blocks = [np.asarray(face) for face in faces]
    return [block[np.newaxis] if block.ndim == 1 else block for block in blocks]
