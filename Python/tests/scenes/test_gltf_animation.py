# SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
# SPDX-License-Identifier: BSD-3-Clause
"""Animations of glTF: morph targets and skins, posed in numpy after the specification."""

import base64
import json

import numpy as np
import pytest
from vtkmodules.util.numpy_support import vtk_to_numpy

import vtkhelios

TYPES = {5123: np.uint16, 5126: np.float32}
SIZES = {1: "SCALAR", 3: "VEC3", 4: "VEC4", 16: "MAT4"}
TIMES = np.array([0.0, 0.4, 1.0], np.float32)


class Writer:
    """A document with one buffer."""

    def __init__(self):
        self.data, self.document = b"", {"asset": {"version": "2.0"}}

    def add(self, name, item):
        items = self.document.setdefault(name, [])
        items.append(item)
        return len(items) - 1

    def add_array(self, array):
        array = np.asarray(array)
        array = array.reshape(len(array), -1)
        self.data += b"\0" * (-len(self.data) % 4)
        view = {"buffer": 0, "byteOffset": len(self.data), "byteLength": array.nbytes}
        self.data += array.tobytes()
        item = {"bufferView": self.add("bufferViews", view), "count": len(array)}
        item["componentType"] = next(code for code, kind in TYPES.items() if kind == array.dtype)
        return self.add("accessors", {**item, "type": SIZES[array.shape[1]]})

    def write(self, path):
        code = base64.b64encode(self.data).decode()
        uri = f"data:application/octet-stream;base64,{code}"
        self.document["buffers"] = [{"byteLength": len(self.data), "uri": uri}]
        path.write_text(json.dumps(self.document))


def make_model(random):
    """A strip with two morph targets, skinned by an arm of three joints below a node that moves."""
    model = {
        "points": random.normal(size=(8, 3)).astype(np.float32),
        "targets": random.normal(size=(2, 8, 3)).astype(np.float32),
        "joints": random.integers(0, 3, (8, 4)).astype(np.uint16),
        "weights": random.uniform(0.1, 1.0, (8, 4)).astype(np.float32),
        "inverse": np.tile(np.eye(4), (3, 1, 1)),
        "keys": {},
    }
    model["inverse"][:, :3] += 0.2 * random.normal(size=(3, 3, 4))
    model["inverse"] = model["inverse"].astype(np.float32)
    model["weights"] /= model["weights"].sum(axis=1, keepdims=True)
    for node in range(4):
        turns = random.normal(size=(3, 4))
        turns /= np.linalg.norm(turns, axis=1, keepdims=True)
        model["keys"][node, "rotation"] = turns.astype(np.float32)
        model["keys"][node, "translation"] = random.normal(size=(3, 3)).astype(np.float32)
        model["keys"][node, "scale"] = random.uniform(0.5, 2.0, (3, 3)).astype(np.float32)
    model["keys"][4, "weights"] = random.uniform(-1.0, 1.0, (3, 2)).astype(np.float32)
    return model


def write_model(model, path, animation="wave"):
    """Writes nodes 0 > 1 > 2 > 3, of which 1 to 3 are joints, and the mesh at node 4."""
    writer = Writer()
    attributes = {
        "POSITION": writer.add_array(model["points"]),
        "JOINTS_0": writer.add_array(model["joints"]),
        "WEIGHTS_0": writer.add_array(model["weights"]),
    }
    targets = [{"POSITION": writer.add_array(each)} for each in model["targets"]]
    primitive = {"attributes": attributes, "targets": targets, "mode": 5}
    writer.add("meshes", {"primitives": [primitive], "weights": [0.1, 0.2]})
    for node in range(4):
        writer.add("nodes", {"children": [node + 1]} if node < 3 else {})
    writer.add("nodes", {"mesh": 0, "skin": 0, "translation": [9.0, 9.0, 9.0]})
    inverse = writer.add_array(model["inverse"].transpose(0, 2, 1).reshape(3, 16))
    writer.add("skins", {"joints": [1, 2, 3], "inverseBindMatrices": inverse})
    writer.document |= {"scene": 0, "scenes": [{"nodes": [0, 4]}]}
    times = writer.add_array(TIMES)
    samplers, channels = [], []
    for (node, path_name), keys in model["keys"].items():
        values = keys.reshape(-1, 1) if path_name == "weights" else keys
        samplers.append({"input": times, "output": writer.add_array(values)})
        target = {"node": node, "path": path_name}
        channels.append({"sampler": len(samplers) - 1, "target": target})
    writer.add("animations", {"name": animation, "samplers": samplers, "channels": channels})
    writer.write(path)
    return writer


# An independent computation.


def interpolate(keys, time, turns=False):
    after = min(max(int(np.searchsorted(TIMES, time, side="right")), 1), len(TIMES) - 1)
    a, b = keys[after - 1].astype(float), keys[after].astype(float)
    t = np.clip((time - TIMES[after - 1]) / (TIMES[after].astype(float) - TIMES[after - 1]), 0, 1)
    if not turns:
        return (1 - t) * a + t * b
    cosine = a @ b
    b, cosine = (b, cosine) if cosine >= 0 else (-b, -cosine)
    angle = np.arccos(min(cosine, 1.0))
    return (np.sin((1 - t) * angle) * a + np.sin(t * angle) * b) / np.sin(angle)


def to_matrix(translation, rotation, scale):
    x, y, z, w = rotation / np.linalg.norm(rotation)
    turn = np.array([
        [1 - 2 * (y * y + z * z), 2 * (x * y - z * w), 2 * (x * z + y * w)],
        [2 * (x * y + z * w), 1 - 2 * (x * x + z * z), 2 * (y * z - x * w)],
        [2 * (x * z - y * w), 2 * (y * z + x * w), 1 - 2 * (x * x + y * y)],
    ])  # fmt: skip
    matrix = np.eye(4)
    matrix[:3, :3], matrix[:3, 3] = turn * scale, translation
    return matrix


def pose(model, time):
    """The points of the model, with z up."""
    places, place = [], np.eye(4)
    for node in range(4):
        parts = {
            name: interpolate(model["keys"][node, name], time, name == "rotation")
            for name in ("translation", "rotation", "scale")
        }
        place = place @ to_matrix(**parts)
        places.append(place)
    points = model["points"].astype(float)
    points += np.einsum(
        "t,tpk->pk", interpolate(model["keys"][4, "weights"], time), model["targets"]
    )
    points = np.column_stack([points, np.ones(len(points))])
    joints = np.array([places[1 + i] @ model["inverse"][i].astype(float) for i in range(3)])
    weights = model["weights"].astype(float)
    weights /= weights.sum(axis=1, keepdims=True)
    moved = np.einsum("pw,pwik,pk->pi", weights, joints[model["joints"]], points)
    return np.column_stack([moved[:, 0], -moved[:, 2], moved[:, 1]])


def read_points(path, time, animation="wave"):
    reader = vtkhelios.vtkHeliosGLTFSceneReader(file_name=str(path), animation=animation)
    reader.SetAnimationTime(time)
    reader.SetKeepAll(True)
    reader.Update()
    assert reader.GetAnimationDuration() == 1.0
    return vtk_to_numpy(reader.GetOutput().GetPoints().GetData())


@pytest.mark.parametrize("time", [0.0, 0.1, 0.4, 0.77, 1.0, 3.0])
def test_morph_targets_and_skins_have_the_pose_of_the_specification(tmp_path, time):
    model = make_model(np.random.default_rng(4))
    write_model(model, tmp_path / "a.gltf")
    expected = pose(model, min(time, 1.0))
    np.testing.assert_allclose(read_points(tmp_path / "a.gltf", time), expected, atol=1e-12)
    np.testing.assert_allclose(read_points(tmp_path / "a.gltf", time, "0"), expected, atol=1e-12)


def test_a_survey_sees_the_animation(tmp_path):
    # A square of 20 m that is skinned to a joint, which rises by 0.5 m in 1 s and turns.
    writer = Writer()
    corners = 10.0 * np.array([[-1, 0, -1], [1, 0, -1], [-1, 0, 1], [1, 0, 1]])
    weights = np.zeros((4, 4), np.float32)
    weights[:, 1] = 1.0
    attributes = {
        "POSITION": writer.add_array(corners.astype(np.float32)),
        "JOINTS_0": writer.add_array(np.zeros((4, 4), np.uint16)),
        "WEIGHTS_0": writer.add_array(weights),
    }
    writer.add("meshes", {"primitives": [{"attributes": attributes, "mode": 5}]})
    writer.add("nodes", {"mesh": 0, "skin": 0})
    writer.add("nodes", {})
    writer.add("skins", {"joints": [1]})
    moves = writer.add_array(np.array([[0, 0, 0], [0, 0.5, 0]], np.float32))
    times = writer.add_array(np.array([0, 1], np.float32))
    channel = {"sampler": 0, "target": {"node": 1, "path": "translation"}}
    sampler = {"input": times, "output": moves}
    writer.add("animations", {"samplers": [sampler], "channels": [channel]})
    writer.write(tmp_path / "rise.gltf")
    part = {"file": str(tmp_path / "rise.gltf"), "motion": "continuous"}
    part["frames"] = {"framesPerSecond": 7, "atEnd": "loop"}
    survey = vtkhelios.make_survey(
        [part],
        [(0, 0, 2)],
        scan_frequency=100,
        head=(0, 80),
        head_speed=60,
        pulse_frequency=100000,
    )
    cloud = survey.run(truth=True, velocities=True, noise=False, sub_rays=1)
    heights = 0.5 * (cloud["GpsTime"] % 1.0)
    assert len(cloud) > 1000
    assert cloud["GpsTime"].max() > 1.1
    np.testing.assert_allclose(cloud["TruePoint"][:, 2], heights, atol=1e-6)
    assert (cloud["RadialVelocity"] < 0).all()  # it comes nearer, from below
