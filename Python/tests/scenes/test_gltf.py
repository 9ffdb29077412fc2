# SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
# SPDX-License-Identifier: BSD-3-Clause
"""glTF documents by independent readers: numpy after the specification here, and VTK's own."""

import base64
import json
import struct

import numpy as np
import pytest
from vtkmodules.util.numpy_support import vtk_to_numpy
from vtkmodules.vtkFiltersCore import vtkTriangleFilter
from vtkmodules.vtkIOGeometry import vtkGLTFReader

import vtkhelios

TYPES = {5121: np.uint8, 5123: np.uint16, 5125: np.uint32, 5126: np.float32}
SIZES = {"SCALAR": 1, "VEC3": 3, "VEC4": 4}
INSTANCING = "EXT_mesh_gpu_instancing"


class Writer:
    """A document with one buffer."""

    def __init__(self):
        self.data, self.document = b"", {"asset": {"version": "2.0"}}

    def add(self, name, item):
        items = self.document.setdefault(name, [])
        items.append(item)
        return len(items) - 1

    def add_view(self, array):
        self.data += b"\0" * (-len(self.data) % 4)
        view = {"buffer": 0, "byteOffset": len(self.data), "byteLength": array.nbytes}
        self.data += array.tobytes()
        return self.add("bufferViews", view)

    def add_array(self, array, **more):
        array = np.atleast_2d(array.T).T
        code = next(code for code, kind in TYPES.items() if kind == array.dtype)
        shape = next(name for name, size in SIZES.items() if size == array.shape[1])
        item = {"bufferView": self.add_view(array), "componentType": code, "type": shape}
        return self.add("accessors", {**item, "count": len(array), **more})

    def write(self, path):
        buffer = {"byteLength": len(self.data)}
        if path.suffix == ".glb":
            self.document["buffers"] = [buffer]
            text = json.dumps(self.document).encode()
            text += b" " * (-len(text) % 4)
            data = self.data + b"\0" * (-len(self.data) % 4)
            chunks = struct.pack("<II", len(text), 0x4E4F534A) + text
            chunks += struct.pack("<II", len(data), 0x004E4942) + data
            path.write_bytes(b"glTF" + struct.pack("<II", 2, 12 + len(chunks)) + chunks)
        else:
            code = base64.b64encode(self.data).decode()
            self.document["buffers"] = [
                {**buffer, "uri": f"data:application/octet-stream;base64,{code}"}
            ]
            path.write_text(json.dumps(self.document))


def make_forest(random, nodes=40):
    """Nodes in a tree, with meshes of lists with indices of each size, and without, strips, fans."""
    writer = Writer()
    for index in (np.uint8, np.uint16, np.uint32, None):
        for mode in (4, 5, 6):
            points = random.normal(size=(30, 3)).astype(np.float32)
            lows, highs = points.min(axis=0).tolist(), points.max(axis=0).tolist()
            item = {"attributes": {"POSITION": writer.add_array(points, min=lows, max=highs)}}
            if index:
                item["indices"] = writer.add_array(random.integers(0, 30, 12).astype(index))
            writer.add("meshes", {"primitives": [{**item, "mode": mode}]})
    for number in range(nodes):
        turn = random.normal(size=4)
        if number % 3 == 0:
            matrix = np.eye(4)
            matrix[:3] += 0.3 * random.normal(size=(3, 4))
            node = {"matrix": matrix.T.reshape(-1).tolist()}
        else:
            node = {
                "translation": random.normal(size=3).tolist(),
                "rotation": (turn / np.linalg.norm(turn)).tolist(),
                "scale": random.uniform(0.5, 1.5, 3).tolist(),
            }
        node["mesh"] = int(random.integers(0, 12))
        writer.add("nodes", node)
        if number > 0:
            parent = writer.document["nodes"][int(random.integers(0, number))]
            parent.setdefault("children", []).append(number)
    writer.document |= {"scene": 0, "scenes": [{"nodes": [0]}]}
    return writer


# An independent reader.


def read_array(writer, index):
    item = writer.document["accessors"][index]
    view = writer.document["bufferViews"][item["bufferView"]]
    size = SIZES[item["type"]]
    array = np.frombuffer(
        writer.data, TYPES[item["componentType"]], size * item["count"], view["byteOffset"]
    )
    return array.reshape(-1, size)


def to_matrix(node):
    if "matrix" in node:
        return np.array(node["matrix"]).reshape(4, 4).T
    x, y, z, w = node.get("rotation", (0, 0, 0, 1))
    turn = np.array(
        [
            [1 - 2 * (y * y + z * z), 2 * (x * y - z * w), 2 * (x * z + y * w)],
            [2 * (x * y + z * w), 1 - 2 * (x * x + z * z), 2 * (y * z - x * w)],
            [2 * (x * z - y * w), 2 * (y * z + x * w), 1 - 2 * (x * x + y * y)],
        ]
    )
    matrix = np.eye(4)
    matrix[:3, :3] = turn * node.get("scale", (1, 1, 1))
    matrix[:3, 3] = node.get("translation", (0, 0, 0))
    return matrix


def find_corners(writer, primitive):
    points = read_array(writer, primitive["attributes"]["POSITION"]).astype(float)
    order = np.arange(len(points))
    if "indices" in primitive:
        order = read_array(writer, primitive["indices"])[:, 0].astype(int)
    if primitive["mode"] == 4:
        rows = order.reshape(-1, 3)
    elif primitive["mode"] == 5:
        rows = np.stack([order[:-2], order[1:-1], order[2:]], axis=1)
        rows[1::2] = rows[1::2, [0, 2, 1]]
    else:
        rows = np.stack([np.full(len(order) - 2, order[0]), order[1:-1], order[2:]], axis=1)
    return points[rows]


def read_triangles(writer, index=0, parent=None):
    """The corners of all triangles below a node, n x 3 x 3, y up."""
    node = writer.document["nodes"][index]
    matrix = (np.eye(4) if parent is None else parent) @ to_matrix(node)
    found = []
    if "mesh" in node:
        for primitive in writer.document["meshes"][node["mesh"]]["primitives"]:
            corners = find_corners(writer, primitive)
            found.append(corners @ matrix[:3, :3].T + matrix[:3, 3])
    found += [read_triangles(writer, child, matrix) for child in node.get("children", ())]
    return np.concatenate(found)


def turn_up(corners):
    return np.stack([corners[..., 0], -corners[..., 2], corners[..., 1]], axis=-1)


def signature(corners, digits):
    """Returns centre and area vector without its sign, sorted, of triangles in any order."""
    a, b, c = (corners[:, i] for i in range(3))
    areas = 0.5 * np.linalg.norm(np.cross(b - a, c - a), axis=1)
    rows = np.column_stack([corners.mean(axis=1), areas])[areas > 1e-9]
    return rows[np.lexsort(np.round(rows, digits).T)]


def measure(corners):
    """The area of triangles, and the sum of their centres by area."""
    a, b, c = (corners[:, i] for i in range(3))
    areas = 0.5 * np.linalg.norm(np.cross(b - a, c - a), axis=1)
    return areas.sum(), (areas[:, None] * corners.mean(axis=1)).sum(axis=0)


@pytest.fixture
def forest(tmp_path, request):
    writer = make_forest(np.random.default_rng(7))
    path = tmp_path / f"forest.{request.param}"
    writer.write(path)
    return writer, path


@pytest.mark.filterwarnings("ignore:.*dropped .* triangles, which have no area")
@pytest.mark.parametrize("forest", ["gltf", "glb"], indirect=True)
def test_triangles_are_those_of_the_specification(forest):
    writer, path = forest
    scene = vtkhelios.Scene.read(path)
    expected = signature(turn_up(read_triangles(writer)), 6)
    found = signature(scene.points[scene.triangles], 6)
    assert len(expected) > 300
    assert np.allclose(found, expected, rtol=0, atol=1e-9)


@pytest.mark.filterwarnings("ignore:.*dropped .* triangles, which have no area")
@pytest.mark.parametrize("forest", ["gltf", "glb"], indirect=True)
def test_triangles_are_those_of_vtk(forest):
    """In single precision."""
    _, path = forest
    reader = vtkGLTFReader()
    reader.SetFileName(str(path))
    reader.ApplyDeformationsToGeometryOn()
    reader.Update()
    leaves = reader.GetOutput().NewIterator()
    area, moment = 0.0, np.zeros(3)
    while not leaves.IsDoneWithTraversal():
        triangles = vtkTriangleFilter()  # splits strips
        triangles.SetInputData(leaves.GetCurrentDataObject())
        triangles.Update()
        mesh = triangles.GetOutput()
        corners = vtk_to_numpy(mesh.GetPolys().GetConnectivityArray()).reshape(-1, 3)
        part, sums = measure(vtk_to_numpy(mesh.GetPoints().GetData())[corners].astype(float))
        area, moment = area + part, moment + sums
        leaves.GoToNextItem()
    scene = vtkhelios.Scene.read(path)
    found = measure(scene.points[scene.triangles])
    assert found[0] == pytest.approx(area, rel=1e-5)
    assert np.allclose(found[1], turn_up(moment), rtol=0, atol=1e-5 * area)


def test_instances_are_copies_at_nodes(tmp_path):
    """EXT_mesh_gpu_instancing against the same places as nodes."""
    random = np.random.default_rng(3)
    points = random.normal(size=(30, 3)).astype(np.float32)
    places = random.normal(size=(50, 3)).astype(np.float32)
    turns = random.normal(size=(50, 4))
    turns = (turns / np.linalg.norm(turns, axis=1, keepdims=True)).astype(np.float32)
    sizes = random.uniform(0.5, 2, (50, 3)).astype(np.float32)
    scenes = []
    for name in ("instances.glb", "nodes.glb"):
        writer = Writer()
        attributes = {"POSITION": writer.add_array(points)}
        writer.add("meshes", {"primitives": [{"attributes": attributes}]})
        root = {"translation": [100, 2, 3], "rotation": [0, 0.6, 0, 0.8]}
        if name == "instances.glb":
            arrays = {"TRANSLATION": places, "ROTATION": turns, "SCALE": sizes}
            arrays = {key: writer.add_array(array) for key, array in arrays.items()}
            root |= {"mesh": 0, "extensions": {INSTANCING: {"attributes": arrays}}}
            writer.document["extensionsUsed"] = [INSTANCING]
            writer.add("nodes", root)
        else:
            writer.add("nodes", {**root, "children": list(range(1, 51))})
            for place, turn, size in zip(places, turns, sizes):
                writer.add(
                    "nodes",
                    {
                        "mesh": 0,
                        "translation": place.tolist(),
                        "rotation": turn.tolist(),
                        "scale": size.tolist(),
                    },
                )
        writer.document |= {"scenes": [{"nodes": [0]}]}
        writer.write(tmp_path / name)
        scenes.append(vtkhelios.Scene.read(tmp_path / name))
    first, second = (scene.points[scene.triangles] for scene in scenes)
    assert len(first) == 500
    assert np.array_equal(first, second)
