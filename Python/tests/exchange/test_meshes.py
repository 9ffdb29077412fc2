# SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
# SPDX-License-Identifier: BSD-3-Clause
"""Meshes of other libraries as scenes."""

import types

import numpy as np
import pytest
from vtkmodules.util.numpy_support import vtk_to_numpy
from vtkmodules.vtkCommonDataModel import vtkCellArray
from vtkmodules.vtkFiltersSources import vtkCubeSource, vtkLineSource

import vtkhelios
from vtkhelios.array_names import MATERIAL_IDS, MATERIAL_NAME, PART_IDS, PART_NAME, RGB
from vtkhelios.exchange import _meshes, _polydata

# A unit cube of six squares, their normals outward.
CORNERS = np.array([(x, y, z) for z in (0, 1) for y in (0, 1) for x in (0, 1)], dtype=float)
SQUARES = [(0, 2, 3, 1), (4, 5, 7, 6), (0, 1, 5, 4), (2, 6, 7, 3), (0, 4, 6, 2), (1, 3, 7, 5)]


def area(scene):
    p = scene.points[scene.triangles].astype(float)
    return np.linalg.norm(np.cross(p[:, 1] - p[:, 0], p[:, 2] - p[:, 0]), axis=1).sum() / 2


def volume(scene):
    p = scene.points[scene.triangles].astype(float)
    return np.einsum("ij,ij->i", p[:, 0], np.cross(p[:, 1], p[:, 2])).sum() / 6


def cells(scene, name):
    return vtk_to_numpy(scene.polydata.GetCellData().GetArray(name))


def texts(scene, name):
    array = scene.polydata.GetFieldData().GetAbstractArray(name)
    return [array.GetValue(i) for i in range(array.GetNumberOfValues())]


def thing(**attributes):
    return types.SimpleNamespace(**attributes)


def check_cube(scene, size=1.0):
    assert len(scene) == 12
    assert area(scene) == pytest.approx(6 * size**2) and volume(scene) == pytest.approx(size**3)


@pytest.mark.parametrize("points", ["points", "vertices"])
@pytest.mark.parametrize("faces", ["faces", "cells", "triangles"])
def test_names_of_points_and_faces(points, faces):
    check_cube(vtkhelios.Scene(thing(**{points: CORNERS, faces: np.array(SQUARES)})))


def test_double_points_are_shared():
    scene = vtkhelios.Scene(thing(points=CORNERS, faces=np.array(SQUARES)))
    assert np.shares_memory(scene.points, CORNERS)


def test_faces_of_any_size():
    """A concave polygon beside a triangle: a chevron of area 2.75 and a triangle of 0.5."""
    points = [(0, 0, 0), (2, 1, 0), (4, 0, 0), (4, 1, 0), (2, 2.75, 0), (0, 1, 0), (9, 0, 0), (9, 1, 0), (8, 0, 0)]  # fmt: skip
    shoelace = [(x, y) for x, y, _ in points[:6]]
    expected = 0.5 * abs(
        sum(x0 * y1 - x1 * y0 for (x0, y0), (x1, y1) in zip(shoelace, shoelace[1:] + shoelace[:1]))
    )
    scene = vtkhelios.Scene(
        thing(points=points, faces=[[0, 1, 2, 3, 4, 5], [6, 7, 8]]), reflectance=[0.1, 0.9]
    )
    assert len(scene) == 5 and area(scene) == pytest.approx(expected + 0.5)
    assert np.array_equal(cells(scene, MATERIAL_IDS), [0, 0, 0, 0, 1])


def test_values_of_polygons_are_those_of_their_triangles():
    values = np.linspace(0.1, 0.6, 6)
    scene = vtkhelios.Scene(thing(points=CORNERS, faces=np.array(SQUARES)), reflectance=values)
    reflectance = vtk_to_numpy(scene.polydata.GetFieldData().GetArray("Material.Reflectance"))
    assert np.array_equal(reflectance[cells(scene, MATERIAL_IDS)], np.repeat(values, 2))
    with pytest.raises(ValueError, match=r"shape \(12,\); give one number, or 6 of them"):
        vtkhelios.Scene(thing(points=CORNERS, faces=np.array(SQUARES)), reflectance=np.ones(12))


def test_polygons_of_vtk():
    cube = vtkCubeSource()
    check_cube(vtkhelios.Scene(cube))
    assert cube.GetOutput().GetNumberOfCells() == 6  # unchanged


def test_the_source_of_a_scan():
    """A tripod in a room of other squares: ranges to the walls."""
    room = thing(points=10 * CORNERS - 5, faces=np.array(SQUARES))
    cloud = vtkhelios.scan(
        room, position=(0, 0, -1), scan_frequency=10, vertical=(-10, 10), head=(0, 9),
        head_speed=60, noise=False,
    )  # fmt: skip
    assert len(cloud) > 100 and np.allclose(np.abs(cloud.points).max(axis=1), 5, atol=1e-3)


def test_pyvista():
    pyvista = pytest.importorskip("pyvista")
    check_cube(vtkhelios.Scene(pyvista.Cube()))
    sphere = pyvista.Sphere()
    assert vtkhelios.Scene(sphere).polydata is sphere  # from the same VTK, and all triangles
    blocks = pyvista.MultiBlock()
    for name, mesh in (("box", pyvista.Cube()), ("ball", sphere)):
        blocks[name] = mesh
    scene = vtkhelios.Scene(blocks)
    assert texts(scene, PART_NAME) == ["box", "ball"]
    assert np.array_equal(np.bincount(cells(scene, PART_IDS)), [12, sphere.n_cells])
    assert area(scene) == pytest.approx(6 + sphere.area, rel=1e-6)


def test_a_scene_in_pyvista():
    pytest.importorskip("pyvista")
    scene = vtkhelios.Scene(thing(points=CORNERS, faces=np.array(SQUARES)), reflectance=0.3)
    mesh = scene.to_pyvista()
    assert mesh.n_cells == 12 and mesh.area == pytest.approx(6)
    assert np.shares_memory(mesh.points, CORNERS)
    assert np.array_equal(mesh.cell_data[MATERIAL_IDS], np.zeros(12))
    assert mesh.field_data["Material.Reflectance"][0] == 0.3


def test_polydata_of_another_vtk():
    """Read by its arrays: what Scene does with every vtkPolyData that is not of its own VTK."""
    mesh = vtkhelios.vtkHeliosSyntheticScene(kind="blocks")()
    parts = _meshes.read_parts(mesh)
    assert np.array_equal(parts[""].points, vtk_to_numpy(mesh.GetPoints().GetData()))
    made, faces = _polydata.read_polydata(mesh)
    own = vtkhelios.Scene(mesh)
    assert made is not mesh and faces is None
    assert np.array_equal(vtkhelios.Scene(made).triangles, own.triangles)
    assert np.array_equal(cells(vtkhelios.Scene(made), MATERIAL_IDS), cells(own, MATERIAL_IDS))
    assert texts(vtkhelios.Scene(made), MATERIAL_NAME) == texts(own, MATERIAL_NAME)


def test_trimesh():
    trimesh = pytest.importorskip("trimesh")
    box = trimesh.creation.box()
    check_cube(vtkhelios.Scene(box))
    box.visual.face_colors = [255, 51, 0, 255]
    assert np.allclose(cells(vtkhelios.Scene(box), RGB), [[1, 0.2, 0]] * 12)
    box.visual.vertex_colors = [0, 102, 255, 255]
    colors = vtkhelios.Scene(box).polydata.GetPointData().GetArray(RGB)
    assert np.allclose(vtk_to_numpy(colors), [[0, 0.4, 1]] * 8)


def test_trimesh_scene():
    """Two boxes, one of them twice as large and moved, with two materials."""
    trimesh = pytest.importorskip("trimesh")
    whole = trimesh.Scene()
    for number, name in enumerate(("bark", "leaf")):
        box = trimesh.creation.box()
        material = trimesh.visual.material.SimpleMaterial()
        material.name = name
        box.visual = trimesh.visual.TextureVisuals(material=material)
        whole.add_geometry(
            box, node_name=f"part{number}", transform=np.diag([2, 2, 2, 1]) if number else None
        )
    scene = vtkhelios.Scene(whole)
    assert volume(scene) == pytest.approx(9)
    assert texts(scene, PART_NAME) == ["part0", "part1"]
    assert texts(scene, MATERIAL_NAME) == ["bark", "leaf"]
    assert np.array_equal(cells(scene, MATERIAL_IDS), np.repeat([0, 1], 12))


def test_meshio():
    meshio = pytest.importorskip("meshio")
    blocks = [("line", [[0, 1]]), ("quad", SQUARES[:5]), ("triangle", [[1, 3, 7], [1, 7, 5]])]
    mesh = meshio.Mesh(CORNERS, blocks, cell_data={PART_IDS: [[9], [0, 1, 2, 3, 4], [5, 6]]})
    scene = vtkhelios.Scene(mesh)
    check_cube(scene)
    assert np.array_equal(cells(scene, PART_IDS), [0, 0, 1, 1, 2, 2, 3, 3, 4, 4, 5, 6])
    solid = meshio.Mesh(CORNERS, [("tetra", [[0, 1, 2, 4]])])
    with pytest.raises(ValueError, match="no triangle, quad, polygon cells; it has: tetra"):
        vtkhelios.Scene(solid)


def test_open3d():
    open3d = pytest.importorskip("open3d")
    box = open3d.geometry.TriangleMesh.create_box()
    check_cube(vtkhelios.Scene(box))
    box.triangle_material_ids = open3d.utility.IntVector([0, 1] * 6)
    scene = vtkhelios.Scene(box)
    assert np.array_equal(cells(scene, MATERIAL_IDS), [0, 1] * 6)
    assert texts(scene, MATERIAL_NAME) == ["material0", "material1"]
    check_cube(vtkhelios.Scene(open3d.t.geometry.TriangleMesh.create_box()))


def tensors(**items):
    return {
        name: thing(cpu=lambda array=array: thing(numpy=lambda: array))
        for name, array in items.items()
    }


def test_tensors_of_open3d():
    """The same by its documented interface, as its package is too large for every test run."""
    triangles = np.array([(0, 2, 1), (0, 1, 3), (0, 3, 2), (1, 2, 3)])
    corners = CORNERS[[0, 1, 2, 4]].astype(np.float32)
    mesh = thing(
        vertex=tensors(positions=corners, colors=np.full((4, 3), 51, np.uint8)),
        triangle=tensors(indices=triangles, material_ids=np.array([[0], [0], [2], [0]])),
    )
    scene = vtkhelios.Scene(mesh)
    assert volume(scene) == pytest.approx(1 / 6)
    assert texts(scene, MATERIAL_NAME) == ["material0", "material1", "material2"]
    colors = scene.polydata.GetPointData().GetArray(RGB)
    assert np.allclose(vtk_to_numpy(colors), 0.2)


@pytest.mark.parametrize(
    ("mesh", "error", "words"),
    [
        (thing(points=CORNERS, faces=np.array([[0, 1, 8]])), ValueError, "from 0 to 8; the points are 0 to 7"),
        (thing(points=CORNERS[:, :2], faces=np.array(SQUARES)), ValueError, r"shape \(8, 2\); give an array"),
        (thing(points=CORNERS + np.nan, faces=np.array(SQUARES)), ValueError, "points has NaN or infinity"),
        (thing(points=CORNERS, faces=np.arange(4)), ValueError, r"faces are int64 \(4,\); give whole numbers"),
        (thing(points=CORNERS, faces=[[0.0, 1, 2]]), ValueError, "faces are float64"),
        (thing(graph=thing(nodes_geometry=[]), geometry={}), ValueError, "has no mesh; give one with points"),
        (thing(points=CORNERS), TypeError, "a mesh with points and faces, not of SimpleNamespace"),
    ],
)  # fmt: skip
def test_meshes_that_are_not_valid(mesh, error, words):
    with pytest.raises(error, match=words):
        vtkhelios.Scene(mesh)


def test_negative_materials():
    mesh = _meshes.Mesh(CORNERS, np.array([0, 1, 2]), np.array([0, 3]))
    mesh.cell_arrays[MATERIAL_IDS] = np.array([-1])
    with pytest.raises(ValueError, match="MaterialIds has -1; material ids are 0 and more"):
        _polydata._make_polydata(mesh)


def test_data_that_are_no_surface():
    line = vtkLineSource()
    line.Update()
    with pytest.raises(ValueError, match="1 line and 0 strip cells besides its 0 polygons"):
        _meshes.read_parts(line.GetOutput())
    grid = thing(IsA=None, GetCellData=None)
    with pytest.raises(TypeError, match=r"is not a surface; give what extract_surface\(\)"):
        _meshes.read_parts(grid)


# An L of 7 m² from each of its corners, a square with a hole, and two squares that share a corner.
GRID = np.array([(x, y, 0) for y in range(5) for x in range(5)], dtype=float)
POLYGONS = {
    **{f"L{k}": (list(np.roll([0, 4, 9, 6, 21, 20], k)), 7.0) for k in range(6)},
    "hole": ([0, 4, 24, 20, 0, 6, 16, 18, 8, 6], 12.0),
    "pinch": ([0, 1, 6, 12, 13, 18, 17, 12, 11, 5], None),
    "corner": ([0, 2, 12, 14, 24, 22, 12, 10], 8.0),
    "comb": ([0, 4, 24, 13, 23, 12, 22, 11, 21], None),
}  # fmt: skip


def shoelace(corners):
    x, y = GRID[corners, :2].T
    return 0.5 * abs(np.dot(x, np.roll(y, -1)) - np.dot(y, np.roll(x, -1)))


@pytest.mark.parametrize("name", POLYGONS)
@pytest.mark.parametrize("kind", ["thing", "polydata", "meshio"])
def test_polygons_of_every_kind_keep_their_area(name, kind):
    corners, expected = POLYGONS[name]
    expected = shoelace(corners) if expected is None else expected
    points = GRID @ np.linalg.qr(np.arange(9).reshape(3, 3) ** 2 + np.eye(3))[0] + [5e5, 5e6, 100]
    if kind == "polydata":
        mesh = _polydata._make_polydata(_meshes._make_mesh(points, [corners]))
    elif kind == "meshio":
        block = thing(type="polygon", data=np.array([corners]))
        mesh = thing(points=points, cells=[block], cell_data={})
    else:
        mesh = thing(points=points, faces=[corners])
    scene = vtkhelios.Scene(mesh, reflectance=[0.3])
    assert area(scene) == pytest.approx(expected, rel=1e-8)


def test_polygons_that_cross_are_a_warning():
    with pytest.warns(
        RuntimeWarning, match="The sides of polygon 1 cross, so its triangles may be"
    ):
        vtkhelios.Scene(thing(points=GRID, faces=[[0, 4, 24, 20], [0, 4, 20, 24]]))


def test_strips_are_triangles():
    cells_of_strip = vtkCellArray()
    cells_of_strip.InsertNextCell(5, [0, 5, 1, 6, 2])
    mesh = _polydata._make_polydata(_meshes._make_mesh(GRID, np.empty((0, 3), int)))
    mesh.SetStrips(cells_of_strip)
    assert area(vtkhelios.Scene(mesh)) == pytest.approx(1.5)
