# SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
# SPDX-License-Identifier: BSD-3-Clause
"""The scene of a simulation: its parts, and its triangles with their materials."""

import functools
import typing

import numpy as np
from vtkmodules.util.numpy_support import vtk_to_numpy

from ...array_names import (
    MATERIAL_CLASSIFICATION, MATERIAL_IDS, MATERIAL_IS_GROUND, MATERIAL_NAME, MATERIAL_REFLECTANCE,
    MATERIAL_SPECTRUM, MATERIAL_SPECULAR_EXPONENT, MATERIAL_SPECULARITY, PART_IDS,
)  # fmt: skip
from ...core.paths import text_from_vtk
from ._errors import Closed, not_covered
from ._materials import COLOURS, find_file, read_colours
from ._output import Vector

PERCENT = 100.0  # reflectances are fractions here
DEFAULT = 0.5  # reflectance of a material without one


class Material(typing.NamedTuple):
    """A material; reflectance is in percent, NaN if the spectrum gives it."""

    name: str
    isGround: bool
    reflectance: float
    specularity: float
    specularExponent: float
    classification: int
    spectra: str
    matFilePath: str = ""  # path of the MTL file of OBJ files, with the colours there
    ka: tuple = (0.0, 0.0, 0.0)
    kd: tuple = (0.0, 0.0, 0.0)
    ks: tuple = (0.0, 0.0, 0.0)

    @property
    def is_ground(self):
        return self.isGround

    @property
    def specular_exponent(self):
        return self.specularExponent

    def __getattr__(self, name):
        """Returns ka0 ... ks2, and mat_file_path."""
        if name == "mat_file_path":
            return self.matFilePath
        if len(name) == 3 and name[:2] in COLOURS and name[2] in "012":
            return getattr(self, name[:2])[int(name[2])]
        raise not_covered("Material", name)


class Vertex(typing.NamedTuple):
    """A corner of a triangle or of a box."""

    position: Vector

    def getPosition(self):
        return self.position


class Box(typing.NamedTuple):
    """The lowest and highest coordinates [m]."""

    low: Vector
    high: Vector

    def getMinVertex(self):
        return Vertex(self.low)

    def getMaxVertex(self):
        return Vertex(self.high)


class ScenePart(Closed):
    """A part of the scene, by its index."""

    def __init__(self, survey, index):
        self._survey, self._index = survey, index

    @property
    def id(self):
        return text_from_vtk(self._survey.GetPartAttribute(self._index, "id")) or str(self._index)

    def getId(self):
        return self.id


class Primitive(Closed):
    """A triangle of the scene, by its index; it cannot be changed."""

    def __init__(self, scene, index):
        self._scene, self._index = scene, index

    def getNumVertices(self):
        return 3

    def getVertex(self, corner):
        return Vertex(Vector(*self._scene.corners[self._index, corner].tolist()))

    def getCentroid(self):
        return Vector(*self._scene.corners[self._index].mean(axis=0).tolist())

    def getMaterial(self):
        part = self._scene.cell_value(PART_IDS, self._index)
        return self._scene.read_material(self._scene.cell_value(MATERIAL_IDS, self._index), part)

    def getScenePart(self):
        return self._scene.getScenePart(self._scene.cell_value(PART_IDS, self._index))


class SceneView(Closed):
    """The scene as it is loaded; coordinates are the survey's, the shift is 0."""

    OWNER = "Scene"

    def __init__(self, survey, folders=()):
        self._survey = survey  # vtkhelios.Survey
        self._folders = folders  # to search files in

    @functools.cached_property
    def mesh(self):
        return self._survey.scene

    @functools.cached_property
    def corners(self):
        """Returns the corners of all triangles, n x 3 x 3 [m]."""
        points = vtk_to_numpy(self.mesh.GetPoints().GetData())
        return points[vtk_to_numpy(self.mesh.GetPolys().GetConnectivityArray()).reshape(-1, 3)]

    def cell_value(self, name, index):
        return int(self.mesh.GetCellData().GetArray(name).GetValue(index))

    def read_material(self, index, part):
        fields = self.mesh.GetFieldData()

        def read(name):
            return fields.GetAbstractArray(name).GetValue(index)

        reflectance, spectrum = read(MATERIAL_REFLECTANCE), read(MATERIAL_SPECTRUM)
        if np.isnan(reflectance) and not spectrum:
            reflectance = DEFAULT
        path = find_file(self._survey, part, self._folders)
        return Material(
            read(MATERIAL_NAME),
            bool(read(MATERIAL_IS_GROUND)),
            PERCENT * reflectance,
            read(MATERIAL_SPECULARITY),
            read(MATERIAL_SPECULAR_EXPONENT),
            read(MATERIAL_CLASSIFICATION),
            spectrum,
            "" if path is None else str(path),
            **read_colours(path, read(MATERIAL_NAME)),
        )

    def getShift(self):
        return Vector(0.0, 0.0, 0.0)

    shift = property(getShift)

    def getAABB(self):
        bounds = np.array(self.mesh.GetBounds()).reshape(3, 2)
        return Box(Vector(*bounds[:, 0].tolist()), Vector(*bounds[:, 1].tolist()))

    AABB = property(getAABB)

    def getNumSceneParts(self):
        return self._survey.vtk.GetNumberOfParts()

    scene_parts_size = getNumSceneParts

    def getScenePart(self, index):
        if not 0 <= index < self.getNumSceneParts():
            raise IndexError(f"there is no part {index}; there are {self.getNumSceneParts()}")
        return ScenePart(self._survey.vtk, index)

    get_scene_part = getScenePart

    @property
    def num_primitives(self):
        return len(self.corners)

    def getPrimitive(self, index):
        if not 0 <= index < len(self.corners):
            raise IndexError(f"there is no primitive {index}; there are {len(self.corners)}")
        return Primitive(self, index)

    primitive = getPrimitive
