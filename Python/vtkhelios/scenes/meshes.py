# SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
# SPDX-License-Identifier: BSD-3-Clause
"""Meshes that stand in for a scene: without a part, or with fewer triangles."""

import collections
import re
import time
import typing

import numpy as np
from vtkmodules.util.numpy_support import vtk_to_numpy
from vtkmodules.vtkCommonCore import VTK_INT, vtkPoints
from vtkmodules.vtkCommonDataModel import vtkCellArray, vtkPolyData

from ..array_names import (
    FIRST_CELL_IDS, MATERIAL_SPECTRUM, MATERIAL_SPECULARITY, NORMALS, PART_IDS, PART_NAME,
    PROTOTYPE_IDS,
)  # fmt: skip
from ..core.arrays import numpy_to_vtk
from ..core.classes import vtk_classes
from ..core.pipeline import PipelineError, update
from ..core.words import counted
from .scene import has_instances


class Group(typing.NamedTuple):
    """Parts of a scene whose names differ in their last number only: tree_001, tree_002 ..."""

    name: str
    ids: tuple  #: PartIds
    triangles: int


def find_groups(scene):
    """The groups of parts of a scene that have triangles, the largest first: parts whose names differ in a number, and
    parts without a name that are instances of the same meshes."""
    names = scene.GetFieldData().GetAbstractArray(PART_NAME)
    kinds, members = _find_kinds(scene), {}
    for index, count in sorted(_count_triangles(scene).items()):
        is_named = names is not None and index < names.GetNumberOfValues()
        name = names.GetValue(int(index)) if is_named else ""
        stem = re.sub(r"[ _.-]*[0-9]+$", "", name)
        if name.isdigit() or not name:
            name = f"part {name or index}"
            stem = kinds.get(int(index), name)
        members.setdefault(stem, []).append((int(index), int(count), name or stem))
    groups = []
    for stem, parts in members.items():
        first = parts[0][2] if isinstance(stem, tuple) else stem
        many = "like it" if isinstance(stem, tuple) else ""
        count = counted(len(parts), "part")
        name = parts[0][2] if len(parts) == 1 else f"{first} ({f'{count} {many}'.strip()})"
        indices, counts = tuple(part[0] for part in parts), sum(part[1] for part in parts)
        groups.append(Group(name, indices, counts))
    return sorted(groups, key=lambda group: -group.triangles)


def _count_triangles(scene):
    """The triangles of every part that has some; empty: the scene has no parts."""
    ids, counts = scene.GetCellData().GetArray(PART_IDS), collections.Counter()
    if ids is not None:
        own = np.unique(vtk_to_numpy(ids), return_counts=True)
        counts.update(dict(zip(*(each.tolist() for each in own))))
    if has_instances(scene):
        sizes = [_size(scene, number) for number in range(scene.GetNumberOfPrototypes())]
        for part, prototype in zip(
            _instance_ids(scene, PART_IDS), _instance_ids(scene, PROTOTYPE_IDS)
        ):
            counts[int(part)] += sizes[int(prototype)]
    return counts


def _find_kinds(scene):
    """Returns the prototypes of each part that has no triangles of its own: a tree of a table has those of its
    kind."""
    kinds = collections.defaultdict(set)
    if has_instances(scene):
        for part, prototype in zip(
            _instance_ids(scene, PART_IDS), _instance_ids(scene, PROTOTYPE_IDS)
        ):
            kinds[int(part)].add(int(prototype))
        if scene.GetCellData().GetArray(PART_IDS) is not None:
            for part in np.unique(_parts(scene)).tolist():
                kinds.pop(part, None)
    return {part: tuple(sorted(kind)) for part, kind in kinds.items()}


def _size(scene, number):
    """Returns the triangles of a prototype, a mesh or a raster: of one instance."""
    one, place = scene.NewInstance(), vtkPolyData()
    _set_points(place, np.zeros((1, 3)))
    _add(place, PROTOTYPE_IDS, np.zeros(1, np.int32), place.GetPointData())
    one.AddPrototype(scene.GetPrototype(number))
    one.SetInstances(place)
    return one.GetNumberOfTriangles()


def _instance_ids(scene, name):
    """Returns the ids of instances, 0 without the array."""
    array = scene.GetInstances().GetPointData().GetArray(name)
    return np.zeros(scene.GetNumberOfInstances(), int) if array is None else vtk_to_numpy(array)


def has_spectra(scene):
    """Returns whether materials of a scene, or of turbid voxels, name a spectrum."""
    names = scene.GetFieldData().GetAbstractArray(MATERIAL_SPECTRUM)
    return names is not None and any(names.GetValue(i) for i in range(names.GetNumberOfValues()))


def has_lobes(scene):
    """Returns whether materials of a scene are specular."""
    values = scene.GetFieldData().GetArray(MATERIAL_SPECULARITY)
    return values is not None and bool((vtk_to_numpy(values) > 0).any())


def without_parts(scene, ids):
    """Returns the scene without the triangles of some parts."""
    mesh = (
        _select(scene, ~np.isin(_parts(scene), ids)) if scene.GetNumberOfPolys() else vtkPolyData()
    )
    return _with_instances(mesh, scene, ids) if has_instances(scene) else mesh


def _with_instances(mesh, scene, without):
    """Returns a mesh with the instances of a scene, without instances of some parts."""
    every, left = scene.GetInstances(), vtkPolyData()
    mask = ~np.isin(_instance_ids(scene, PART_IDS), without)
    _set_points(left, vtk_to_numpy(every.GetPoints().GetData())[mask])
    data = every.GetPointData()
    for index in range(data.GetNumberOfArrays()):
        array = data.GetArray(index)  # None for strings
        if array is not None and array.GetName() != FIRST_CELL_IDS:
            _add(left, array.GetName(), vtk_to_numpy(array)[mask], left.GetPointData())
    whole = scene.NewInstance()
    whole.ShallowCopy(mesh)
    whole.GetFieldData().ShallowCopy(scene.GetFieldData())
    for number in range(scene.GetNumberOfPrototypes()):
        whole.AddPrototype(scene.GetPrototype(number))
    whole.SetInstances(left)
    return whole


class TooLong(Exception):
    """A simplification that was given up."""


def simplify(scene, distance, seconds, progress):
    """Returns the scene with fewer triangles within a distance [m], and the verified distance.

    None without CGAL, if this mesh cannot be simplified, or if that takes more processor time.
    """
    end = time.process_time() + seconds

    def watch(_filter, share):
        progress(share)
        if time.process_time() > end:
            raise TooLong

    kind = vtk_classes().get("vtkHeliosMeshSimplify")
    if kind is None:
        return None
    algorithm = kind(maximum_distance=distance)
    algorithm.SetInputDataObject(0, scene)
    try:
        mesh = vtkPolyData()
        mesh.ShallowCopy(update(algorithm, progress=watch))
    except (PipelineError, TooLong):
        return None
    mesh.GetPolys().ConvertTo32BitStorage()
    return mesh, algorithm.GetVerifiedDistance()


def with_parts(scene, simplified, ids):
    """The scene with some parts from another mesh that was made of it."""
    rest, own = without_parts(scene, ids), _select(simplified, np.isin(_parts(simplified), ids))
    if rest.GetCellData().GetArray(NORMALS) is not None:
        _add_normals(own)
    return _join(rest, own)


def _parts(scene):
    return vtk_to_numpy(scene.GetCellData().GetArray(PART_IDS))


def _corners(mesh):
    return vtk_to_numpy(mesh.GetPolys().GetConnectivityArray()).reshape(-1, 3)


def _set_triangles(mesh, corners):
    # Copies: the cells use the memory of these arrays, without a reference. 32 bits, as in scenes.
    cells = vtkCellArray()
    offsets = np.arange(0, 3 * len(corners) + 1, 3, dtype=np.int32)
    flat = np.ascontiguousarray(corners, dtype=np.int32).reshape(-1)
    cells.SetData(numpy_to_vtk(offsets, 1, VTK_INT), numpy_to_vtk(flat, 1, VTK_INT))
    mesh.SetPolys(cells)


def _select(scene, mask):
    """Returns the triangles of a mask, with their data and the points that they use."""
    used, corners = np.unique(_corners(scene)[mask], return_inverse=True)
    mesh = vtkPolyData()
    _set_points(mesh, vtk_to_numpy(scene.GetPoints().GetData())[used])
    _set_triangles(mesh, corners.reshape(-1, 3))
    mesh.GetFieldData().ShallowCopy(scene.GetFieldData())
    data = scene.GetCellData()
    for index in range(data.GetNumberOfArrays()):
        array = data.GetArray(index)  # None for strings
        if array is not None:
            _add(mesh, array.GetName(), vtk_to_numpy(array)[mask])
    return mesh


def _join(first, second):
    """Two meshes of the same field data, with the cell arrays of both."""
    mesh = vtkPolyData()
    clouds = [vtk_to_numpy(each.GetPoints().GetData()) for each in (first, second)]
    _set_points(mesh, np.concatenate(clouds))
    _set_triangles(mesh, np.concatenate([_corners(first), _corners(second) + len(clouds[0])]))
    mesh.GetFieldData().ShallowCopy(first.GetFieldData())
    for index in range(first.GetCellData().GetNumberOfArrays()):
        name = first.GetCellData().GetArrayName(index)
        pair = [each.GetCellData().GetArray(name) for each in (first, second)]
        if all(array is not None for array in pair):
            _add(mesh, name, np.concatenate([vtk_to_numpy(array) for array in pair]))
    return mesh


def _set_points(mesh, values):
    points = vtkPoints()
    points.SetData(numpy_to_vtk(np.ascontiguousarray(values, dtype=np.float64), deep=1))
    mesh.SetPoints(points)


def _add(mesh, name, values, data=None):
    array = numpy_to_vtk(np.ascontiguousarray(values), deep=1)
    array.SetName(name)
    (data or mesh.GetCellData()).AddArray(array)


def _add_normals(mesh):
    """Unit normals of the triangles, in place of those that simplification drops."""
    points = vtk_to_numpy(mesh.GetPoints().GetData())[_corners(mesh)]
    normals = np.cross(points[:, 1] - points[:, 0], points[:, 2] - points[:, 0])
    lengths = np.maximum(np.linalg.norm(normals, axis=1, keepdims=True), 1e-300)
    _add(mesh, NORMALS, normals / lengths)
