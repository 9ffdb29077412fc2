# SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
# SPDX-License-Identifier: BSD-3-Clause
"""Scene files by independent programs: CityJSON and OBJ of Delft read here, PLY and STL of VTK."""

import collections
import json

import numpy as np
import pytest
from vtkmodules.util.numpy_support import vtk_to_numpy
from vtkmodules.vtkIOGeometry import vtkSTLWriter
from vtkmodules.vtkIOPLY import vtkPLYWriter

import vtkhelios
from _real_data import real_file
from vtkhelios.array_names import CRS, MATERIAL_IDS, MATERIAL_NAME

# Kinds of objects in CityJSON, and the materials of the same surfaces in the OBJ of 3dfier.
KINDS = {
    "WaterBody": "Water",
    "Building": "Building",
    "LandUse": "Terrain",
    "Road": "Road",
    "PlantCover": "Forest",
    "GenericCityObject": "Separation",
    "Bridge": "Bridge",
}


def vectors(points, triangles):
    """Area vectors of triangles [m²]."""
    a, b, c = (points[triangles[:, i]] for i in range(3))
    return 0.5 * np.cross(b - a, c - a)


def enclosed(points, triangles):
    """The volume between triangles and a corner of the model [m³]."""
    corners = points[triangles] - [84616.468, 447422.999, -0.452]
    return np.linalg.det(corners).sum() / 6


def find_rings(boundaries):
    """The surfaces in nested lists."""
    if isinstance(boundaries[0][0], int):
        yield boundaries
    else:
        for each in boundaries:
            yield from find_rings(each)


def read_city(path):
    """The area vectors and centres of all surfaces of each kind of object, by json and numpy."""
    data = json.loads(path.read_text())
    points = np.array(data["vertices"]) * data["transform"]["scale"]
    points += data["transform"]["translate"]
    kinds = collections.defaultdict(list)
    for each in data["CityObjects"].values():
        for geometry in each["geometry"]:
            kinds[each["type"]] += [ring for (ring,) in find_rings(geometry["boundaries"])]
    return points, {kind: np.array(rings) for kind, rings in kinds.items()}


def read_obj(path):
    """The vertices and triangles of each material, by hand."""
    points, faces, name = [], collections.defaultdict(list), ""
    for line in path.read_text().splitlines():
        key, *words = line.split() or [""]
        if key == "v":
            points.append([float(word) for word in words])
        elif key == "usemtl":
            name = words[0]
        elif key == "f":
            faces[name].append([int(word.split("/")[0]) - 1 for word in words])
    return np.array(points), {name: np.array(rows) for name, rows in faces.items()}


def materials_of(scene):
    """The triangles of each material of a scene."""
    names = scene.polydata.GetFieldData().GetAbstractArray(MATERIAL_NAME)
    ids = vtk_to_numpy(scene.polydata.GetCellData().GetArray(MATERIAL_IDS))
    rows = range(names.GetNumberOfValues())
    return {names.GetValue(row): scene.triangles[ids == row] for row in rows}


@pytest.fixture(scope="module")
def delft():
    return vtkhelios.Scene.read(real_file("scene/cityjson_delft.json"))


@pytest.mark.filterwarnings("ignore:.*dropped .* triangles, which have no area")
def test_city_has_the_surfaces_that_another_program_reads(delft):
    points, kinds = read_city(real_file("scene/cityjson_delft.json"))
    found = materials_of(delft)
    assert found.keys() == kinds.keys()
    for kind, triangles in kinds.items():
        expected = np.linalg.norm(vectors(points, triangles), axis=1).sum()
        areas = np.linalg.norm(vectors(delft.points, found[kind]), axis=1)
        assert areas.sum() == pytest.approx(expected, rel=1e-12)
        expected = enclosed(points, triangles)
        assert enclosed(delft.points, found[kind]) == pytest.approx(expected, rel=1e-9)
        assert len(triangles) - len(areas) < 0.005 * len(triangles)  # without area
    assert delft.polydata.GetFieldData().GetAbstractArray(CRS).GetValue(0) == "EPSG:7415"


def test_city_has_the_plan_of_the_obj(delft):
    """The OBJ is the same model at other heights: roofs and ground cover the same area from above."""
    points, faces = read_obj(real_file("scene/delft_testarea.obj"))
    found = materials_of(delft)
    for kind, name in KINDS.items():
        expected = vectors(points, faces[name])[:, 2].sum()
        assert vectors(delft.points, found[kind])[:, 2].sum() == pytest.approx(expected, rel=1e-9)


def soup(scene):
    """Triangles as corners, whatever their vertices are numbered."""
    return scene.points[scene.triangles]


@pytest.mark.parametrize("ascii", [True, False])
@pytest.mark.parametrize("kind", ["ply", "ply_big", "stl"])
def test_files_of_vtk_read_as_they_were_written(tmp_path, kind, ascii):
    source = vtkhelios.Scene(
        [[0, 0, 0], [4, 0, 0], [4, 3, 0.5], [0, 3, 0], [2, 1, 2.5]],
        [[0, 1, 4], [1, 2, 4], [2, 3, 4], [3, 0, 4]],
    )
    writer = vtkSTLWriter() if kind == "stl" else vtkPLYWriter()
    if kind == "ply_big":
        writer.SetDataByteOrderToBigEndian()
    path = tmp_path / f"tent.{kind[:3]}"
    writer.SetFileName(str(path))
    writer.SetInputData(source.polydata)
    writer.SetFileTypeToASCII() if ascii else writer.SetFileTypeToBinary()
    assert writer.Write()
    scene = vtkhelios.Scene.read(path)
    assert np.array_equal(soup(scene), soup(source))
    assert len(scene.points) == 5


def test_an_unknown_ending_is_refused(tmp_path):
    with pytest.raises(
        ValueError, match=r"house\.dxf: is not a mesh of a known format; known: \.obj"
    ):
        vtkhelios.Scene.read(tmp_path / "house.dxf")


def test_a_name_is_a_scene(tmp_path):
    path = tmp_path / "plane.obj"
    corners = [(-9, -9, 0), (9, -9, 0), (9, 9, 0), (-9, 9, 0)]
    vtkhelios.Scene(corners, [(0, 1, 2), (0, 2, 3)], reflectance=0.25).write(path)
    scene = vtkhelios.Scene(path)
    assert len(scene) == 2 and len(vtkhelios.Scene(str(path), reflectance=0.7)) == 2
    shown = scene._repr_html_()
    assert "Scene(2 triangles" in shown and "<td>material0</td><td>0.25</td>" in shown
    lines = dict(scan_frequency=50, vertical=(-40, -30), head=(0, 360), head_speed=60)
    cloud = vtkhelios.scan(path, position=(0, 0, 2), **lines)
    assert len(cloud) > 1000 and abs(cloud.z).max() < 0.1
    survey = vtkhelios.make_survey(path, [(0, 0, 2)], **lines)
    survey.write(tmp_path / "survey.xml")
    again = vtkhelios.read_survey(tmp_path / "survey.xml").run()
    assert np.array_equal(again.points, survey.run().points)
    with pytest.raises(ValueError, match="a.xml: is not a mesh of a known format; give its loader"):
        vtkhelios.scan("a.xml", position=(0, 0, 2), **lines)


def test_reader_properties_are_keywords(tmp_path):
    path = tmp_path / "tent.ply"
    path.write_text(
        "ply\nformat ascii 1.0\nelement vertex 3\nproperty double x\nproperty double y\n"
        "property double z\nelement face 1\nproperty list uchar int vertex_indices\nend_header\n"
        "0 0 0\n1 0 0\n0 1 0.1\n3 0 1 2\n"
    )
    upright = vtkhelios.Scene.read(path, up_axis=vtkhelios.vtkHeliosSceneReader.UP_AXIS_Y)
    assert np.array_equal(upright.points[2], [0, -0.1, 1])
