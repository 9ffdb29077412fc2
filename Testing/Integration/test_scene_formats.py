# SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
# SPDX-License-Identifier: BSD-3-Clause
"""One mesh in every format of scenes: the files of a survey are the same, byte for byte."""

import json
import struct

import numpy as np
import pytest

import vtkhelios
from vtkhelios.array_names import AMPLITUDE, CELL_IDS, CLASSIFICATION_IDS, PART_IDS

SURVEY = """\
<document><survey name="yard" platform="platforms.xml#tripod" scanner="scanners.xml#vz400_class_tls"
  scene="scene.xml#s"><leg><platformSettings x="5" y="5" z="0"/>
<scannerSettings active="true" pulseFreq_hz="100000" scanFreq_hz="100" headRotatePerSec_deg="60"
  verticalAngleMin_deg="-40" verticalAngleMax_deg="60" headRotateStart_deg="0" headRotateStop_deg="120"/></leg>
</survey></document>
"""
SCENE = """\
<document><scene id="s"><part id="mesh"><filter type="{}loader">
<param type="string" key="filepath" value="{}"/>{}
</filter></part></scene></document>
"""
MATERIALS = '<param type="string" key="matfile" value="all.mtl"/>'
POINTS = [(0, 0, 0), (20, 0, 0), (20, 20, 0.5), (0, 20, 0), (12, 5, 0), (12, 9, 3), (12, 1, 3)]
FACES = [(0, 1, 2), (0, 2, 3), (4, 5, 6)]


def make_obj():
    lines = ["mtllib all.mtl", "usemtl GenericCityObject"]
    lines += [f"v {x} {y} {z}" for x, y, z in POINTS]
    lines += ["f " + " ".join(str(i + 1) for i in face) for face in FACES]
    return "\n".join(lines).encode()


def make_ply(order="little"):
    data = (
        f"ply\nformat binary_{order}_endian 1.0\nelement vertex {len(POINTS)}\nproperty double x\n"
        f"property double y\nproperty double z\nelement face {len(FACES)}\n"
        "property list uchar int vertex_indices\nend_header\n"
    ).encode()
    mark = "<" if order == "little" else ">"
    data += b"".join(struct.pack(f"{mark}3d", *point) for point in POINTS)
    return data + b"".join(struct.pack(f"{mark}B3i", 3, *face) for face in FACES)


def make_stl():
    corners = [[x for i in face for x in POINTS[i]] for face in FACES]
    records = b"".join(struct.pack("<12fH", 0, 0, 0, *each, 0) for each in corners)
    return bytes(80) + struct.pack("<I", len(FACES)) + records


def make_city():
    boundaries = [[list(face)] for face in FACES]
    geometry = {"type": "MultiSurface", "lod": "1", "boundaries": boundaries}
    city = {
        "type": "CityJSON", "version": "2.0",
        "transform": {"scale": [0.5, 0.5, 0.5], "translate": [0, 0, 0]},
        "CityObjects": {"yard": {"type": "GenericCityObject", "geometry": [geometry]}},
        "vertices": [[int(2 * x) for x in point] for point in POINTS],
    }  # fmt: skip
    return json.dumps(city).encode()


def make_gltf():
    """Binary; y is up, so a point is (x, z, -y)."""
    points = b"".join(struct.pack("<3f", x, z, -y) for x, y, z in POINTS)
    data = points + b"".join(struct.pack("<3H", *face) for face in FACES)
    data += bytes(-len(data) % 4)
    primitive = {"attributes": {"POSITION": 0}, "indices": 1, "material": 0}
    document = {
        "asset": {"version": "2.0"}, "scenes": [{"nodes": [0]}], "nodes": [{"mesh": 0}],
        "materials": [{"name": "GenericCityObject"}], "meshes": [{"primitives": [primitive]}],
        "accessors": [
            {"bufferView": 0, "componentType": 5126, "count": len(POINTS), "type": "VEC3"},
            {"bufferView": 1, "componentType": 5123, "count": 3 * len(FACES), "type": "SCALAR"},
        ],
        "bufferViews": [
            {"buffer": 0, "byteLength": len(points)},
            {"buffer": 0, "byteOffset": len(points), "byteLength": 6 * len(FACES)},
        ],
        "buffers": [{"byteLength": len(data)}],
    }  # fmt: skip
    text = json.dumps(document).encode()
    text += b" " * (-len(text) % 4)
    chunks = struct.pack("<II", len(text), 0x4E4F534A) + text
    chunks += struct.pack("<II", len(data), 0x004E4942) + data
    return b"glTF" + struct.pack("<II", 2, 12 + len(chunks)) + chunks


def scan(folder, loader, name, data):
    """The echoes of a survey of a mesh."""
    (folder / name).write_bytes(data)
    (folder / "all.mtl").write_text(
        "newmtl GenericCityObject\nhelios_reflectance 0.3\nhelios_classification 1\n"
    )
    (folder / "scene.xml").write_text(
        SCENE.format(loader, name, "" if loader == "obj" else MATERIALS)
    )
    (folder / "survey.xml").write_text(SURVEY)
    return vtkhelios.read_survey(folder / "survey.xml").run(seed=1)


@pytest.mark.parametrize(
    ("loader", "name", "make"),
    [
        ("ply", "little.ply", make_ply),
        ("ply", "big.ply", lambda: make_ply("big")),
        ("stl", "a.stl", make_stl),
        ("cityjson", "a.city.json", make_city),
        ("gltf", "a.glb", make_gltf),
    ],
)
def test_echoes_are_those_of_the_obj(tmp_path, loader, name, make):
    expected = scan(tmp_path, "obj", "a.obj", make_obj())
    echoes = scan(tmp_path, loader, name, make())
    assert len(expected.points) > 1000
    assert np.array_equal(echoes.points, expected.points)
    for array in (AMPLITUDE, CLASSIFICATION_IDS, CELL_IDS):
        assert np.array_equal(echoes[array], expected[array])
    object_number = 1 if loader == "cityjson" else 0  # objects of a city follow the parts
    assert np.array_equal(echoes[PART_IDS], expected[PART_IDS] + object_number)
