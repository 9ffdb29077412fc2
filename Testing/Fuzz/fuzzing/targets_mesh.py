# SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
# SPDX-License-Identifier: BSD-3-Clause
"""Meshes as scenes: PLY, STL, CityJSON and glTF."""

import base64
import json
import struct

from vtkmodules.util.numpy_support import vtk_to_numpy

import vtkhelios

from .outcomes import check, check_polydata
from .target import Seed, Target, update
from .targets_scene import check_materials

CORNERS = ((0, 0, 0), (4, 0, 0), (4, 3, 0), (0, 3, 0), (2, 1, 2.5))
FACES = ((0, 1, 4), (1, 2, 4), (2, 3, 4), (3, 0, 4), (0, 3, 2, 1))
PLY_HEAD = (
    "ply\nformat {} 1.0\ncomment a tent\nelement vertex 5\nproperty double x\nproperty double y\n"
    "property float z\nelement face 5\nproperty list uchar int vertex_indices\nend_header\n"
)


class Mesh(Target):
    """A file of triangles by its reader: indices and materials are valid."""

    reader = ""

    def run(self, path, data):
        reader = getattr(vtkhelios, self.reader)()
        reader.SetFileName(str(path))
        scene, warned = update(reader)
        check(check_polydata(scene) > 0 or warned, "no triangles, and no warning")
        ids = vtk_to_numpy(scene.GetCellData().GetArray("MaterialIds"))
        count = scene.GetFieldData().GetAbstractArray("Material.Name").GetNumberOfValues()
        check(((ids >= 0) & (ids < count)).all(), f"material ids {ids}")
        check_materials(scene.GetFieldData())


class Ply(Mesh):
    """PLY as a scene."""

    name = "ply-scene"
    kind = "binary"
    reader = "vtkHeliosPLYSceneReader"

    def make_seeds(self, folder):
        text = PLY_HEAD.format("ascii")
        text += "".join(f"{x} {y} {z}\n" for x, y, z in CORNERS)
        text += "".join(f"{len(face)} {' '.join(map(str, face))}\n" for face in FACES)
        return [
            Seed("text.ply", text.encode()),
            Seed("little.ply", make_ply("<", "binary_little_endian")),
            Seed("big.ply", make_ply(">", "binary_big_endian")),
        ]


def make_ply(order, name):
    data = PLY_HEAD.format(name).encode()
    data += b"".join(struct.pack(f"{order}ddf", *corner) for corner in CORNERS)
    for face in FACES:
        data += struct.pack(f"{order}B{len(face)}i", len(face), *face)
    return data


class Stl(Mesh):
    """STL as a scene."""

    name = "stl"
    kind = "binary"
    reader = "vtkHeliosSTLSceneReader"

    def make_seeds(self, folder):
        faces = [[CORNERS[corner] for corner in face] for face in FACES[:4]]
        loops = "".join(
            "facet normal 0 0 1\nouter loop\n"
            + "".join(f"vertex {x} {y} {z}\n" for x, y, z in face)
            + "endloop\nendfacet\n"
            for face in faces
        )
        records = b"".join(
            struct.pack("<12fH", 0, 0, 1, *face[0], *face[1], *face[2], 0) for face in faces
        )
        return [
            Seed("text.stl", f"solid tent\n{loops}endsolid tent\n".encode()),
            Seed("binary.stl", b"tent".ljust(80) + struct.pack("<I", len(faces)) + records),
        ]


class CityJson(Mesh):
    """CityJSON as a scene."""

    name = "cityjson"
    kind = "text"
    reader = "vtkHeliosCityJSONReader"

    def make_seeds(self, folder):
        return [
            Seed("tent.city.json", json.dumps(make_city(), indent=1).encode()),
            Seed("line.city.json", json.dumps(make_city()).encode()),
        ]


def make_city():
    """A solid with a hole in its floor, at two levels of detail, and a template."""
    surfaces = [{"type": "GroundSurface"}, {"type": "RoofSurface"}]
    faces = [[list(face)] for face in FACES]
    faces[4].append([5, 6, 7])
    solid = {
        "type": "Solid", "lod": "2", "boundaries": [faces],
        "semantics": {"surfaces": surfaces, "values": [[1, 1, 1, None, 0]]},
    }  # fmt: skip
    floor = {"type": "MultiSurface", "lod": "1", "boundaries": [[[0, 1, 2, 3]]]}
    tree = {
        "type": "GeometryInstance", "template": 0, "boundaries": [2],
        "transformationMatrix": [2, 0, 0, 0, 0, 2, 0, 0, 0, 0, 2, 0, 0, 0, 0, 1],
    }  # fmt: skip
    hole = [(1, 0.5, 0), (2, 0.5, 0), (1.5, 1, 0)]
    return {
        "type": "CityJSON", "version": "2.0",
        "metadata": {"referenceSystem": "https://www.opengis.net/def/crs/EPSG/0/25832"},
        "transform": {"scale": [0.001] * 3, "translate": [478000.5, 5470000.25, 110]},
        "CityObjects": {
            "tent": {"type": "Building", "geometry": [solid, floor]},
            "tree": {"type": "SolitaryVegetationObject", "geometry": [tree]},
        },
        "vertices": [[round(1000 * x) for x in corner] for corner in [*CORNERS, *hole]],
        "geometry-templates": {
            "templates": [{"type": "MultiSurface", "lod": "2", "boundaries": [[[0, 1, 2]]]}],
            "vertices-templates": [[0, 0, 0], [1, 0, 0], [0, 0, 1.5]],
        },
    }  # fmt: skip


class Gltf(Mesh):
    """glTF as a scene."""

    name = "gltf"
    kind = "text"
    reader = "vtkHeliosGLTFSceneReader"

    def make_seeds(self, folder):
        return [Seed("tent.gltf", json.dumps(make_gltf(), indent=1).encode())]


class Glb(Mesh):
    """glTF in its container as a scene."""

    name = "glb"
    kind = "binary"
    reader = "vtkHeliosGLTFSceneReader"

    def make_seeds(self, folder):
        document = make_gltf()
        data = base64.b64decode(document["buffers"][0].pop("uri").split(",")[1])
        text = json.dumps(document).encode()
        text += b" " * (-len(text) % 4)
        chunks = struct.pack("<II", len(text), 0x4E4F534A) + text
        chunks += struct.pack("<II", len(data), 0x004E4942) + data
        return [Seed("tent.glb", b"glTF" + struct.pack("<II", 2, 12 + len(chunks)) + chunks)]


def make_gltf():
    """Two nodes of a tent, one with instances, the other sparse and without indices."""
    points = b"".join(struct.pack("<3f", *corner) for corner in CORNERS)
    indices = b"".join(struct.pack("<3H", *face[:3]) for face in FACES[:4])
    places = struct.pack("<6f", 10, 0, 0, 20, 0, 5)
    row, value = b"\1\0\0\0", struct.pack("<3f", 9, 0, 0)
    views, data = [], b""
    for part in (points, indices, places, row, value):
        views.append({"buffer": 0, "byteOffset": len(data), "byteLength": len(part)})
        data += part
    vectors = {"componentType": 5126, "type": "VEC3"}
    sparse = {
        "count": 1, "indices": {"bufferView": 3, "componentType": 5121}, "values": {"bufferView": 4},
    }  # fmt: skip
    instancing = {"EXT_mesh_gpu_instancing": {"attributes": {"TRANSLATION": 2}}}
    uri = f"data:application/octet-stream;base64,{base64.b64encode(data).decode()}"
    return {
        "asset": {"version": "2.0"}, "scene": 0, "scenes": [{"nodes": [0]}],
        "nodes": [
            {"mesh": 0, "rotation": [0, 0.6, 0, 0.8], "extensions": instancing, "children": [1]},
            {"mesh": 1, "matrix": [2, 0, 0, 0, 0, 2, 0, 0, 0, 0, 2, 0, 1, 2, 3, 1]},
        ],
        "meshes": [
            {"primitives": [{"attributes": {"POSITION": 0}, "indices": 1, "material": 0}]},
            {"primitives": [{"attributes": {"POSITION": 3}, "mode": 5}]},
        ],
        "materials": [{"pbrMetallicRoughness": {"baseColorFactor": [0.1, 0.5, 0.2, 1]}}],
        "accessors": [
            {**vectors, "bufferView": 0, "count": len(CORNERS)},
            {"bufferView": 1, "componentType": 5123, "count": 12, "type": "SCALAR"},
            {**vectors, "bufferView": 2, "count": 2},
            {**vectors, "bufferView": 0, "count": len(CORNERS), "sparse": sparse},
        ],
        "bufferViews": views,
        "buffers": [{"byteLength": len(data), "uri": uri}],
    }  # fmt: skip


def make_targets():
    return [Ply(), Stl(), CityJson(), Gltf(), Glb()]
