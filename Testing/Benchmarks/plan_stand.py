# SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
# SPDX-License-Identifier: BSD-3-Clause
"""Plans scan positions for a stand of instances: processor time and peak memory.

    build/venv/bin/python Testing/Benchmarks/plan_stand.py TREES TRIANGLES [--copies | FOLDER]

Ten prototypes of square leaves stand 4 m apart on a level ground. With a folder the scene is not
planned for, but written there: stand.xml, for vtkhelios view.
"""

import pathlib
import resource
import sys
import time

import numpy as np
from vtkmodules.util.numpy_support import numpy_to_vtk
from vtkmodules.vtkCommonDataModel import vtkPolyData

import vtkhelios
from vtkhelios.scenes.scene import flatten

PROTOTYPES, SPACING = 10, 4.0
LEAF_AREA = 4.0 * SPACING**2  # m2 of a tree
SETTINGS = {"grid": 20, "region": (-50, 50, -50, 50), "test_grid": 4, "test_lines": "vertical"}


def make_tree(count, rng):
    """Square leaves of two triangles each in an ellipsoid."""
    leaves = count // 2
    directions = rng.normal(size=(leaves, 3))
    directions /= np.linalg.norm(directions, axis=1)[:, None]
    places = directions * rng.random((leaves, 1)) ** (1 / 3) * (2, 2, 4) + (0, 0, 6)
    u, v = rng.normal(size=(2, leaves, 3))
    u /= np.linalg.norm(u, axis=1)[:, None]
    v = np.cross(u, v)
    v /= np.linalg.norm(v, axis=1)[:, None]
    half = 0.5 * np.sqrt(LEAF_AREA / leaves)
    corners = [places + half * (a * u + b * v) for a, b in ((-1, -1), (1, -1), (1, 1), (-1, 1))]
    points = np.stack(corners, axis=1).reshape(-1, 3)
    first = 4 * np.arange(leaves)[:, None]
    triangles = np.concatenate([first + (0, 1, 2), first + (0, 2, 3)], axis=1).reshape(-1, 3)
    return points, triangles


def make_mesh(points, triangles, is_ground=False):
    mesh = vtkhelios.Scene(points, triangles, ground=is_ground).polydata
    mesh.GetPolys().ConvertTo32BitStorage()
    return mesh


def make_stand(trees, triangles):
    rng = np.random.default_rng(1)
    side = int(np.ceil(np.sqrt(trees)))
    half = 0.5 * SPACING * (side + 1)
    ground = np.array([(-half, -half, 0), (half, -half, 0), (half, half, 0), (-half, half, 0)])
    composer = vtkhelios.vtkHeliosSceneComposer()
    composer.AddInputData(0, make_mesh(ground, np.array([(0, 1, 2), (0, 2, 3)]), True))
    for _ in range(PROTOTYPES):
        composer.AddInputData(0, make_mesh(*make_tree(triangles, rng)))
    numbers = np.arange(trees)
    grid = np.stack([numbers % side, numbers // side], axis=1) - 0.5 * (side - 1)
    places = np.column_stack([SPACING * grid + rng.uniform(-1, 1, (trees, 2)), 0 * numbers])
    yaw = 0.5 * rng.uniform(0, 2 * np.pi, trees)
    columns = {
        "PrototypeIds": (1 + rng.integers(PROTOTYPES, size=trees)).astype(np.int32),
        "Orientation": np.column_stack([np.cos(yaw), 0 * yaw, 0 * yaw, np.sin(yaw)]),
        "Scale": rng.uniform(0.7, 1.3, trees),
    }
    instances = vtkPolyData()
    instances.SetPoints(vtkhelios.Scene(places, np.empty((0, 3), int)).polydata.GetPoints())
    for name, values in columns.items():
        array = numpy_to_vtk(values, deep=True)
        array.SetName(name)
        instances.GetPointData().AddArray(array)
    composer.SetInputData(1, instances)
    return vtkhelios.update(composer)


def write_part(name, file, filters=""):
    load = f'<filter type="objloader"><param key="filepath" type="string" value="{file}"/></filter>'
    return f'<part id="{name}">{load}{filters}</part>\n'


def write_stand(scene, folder):
    """The scene as OBJ files and a part for every tree."""
    folder.mkdir(parents=True, exist_ok=True)
    mesh = vtkPolyData()
    mesh.ShallowCopy(scene)
    vtkhelios.Scene(mesh).write(folder / "ground.obj")
    for number in range(PROTOTYPES):
        prototype = scene.GetPrototype(number)
        prototype.GetFieldData().ShallowCopy(scene.GetFieldData())
        vtkhelios.Scene(prototype).write(folder / f"tree{number}.obj")
    instances = scene.GetInstances()
    columns = vtkhelios.arrays(instances)
    parts = [write_part("ground", "ground.obj")]
    for i, (x, y, z) in enumerate(columns["points"]):
        yaw = np.degrees(2 * np.arctan2(columns["Orientation"][i][3], columns["Orientation"][i][0]))
        parts.append(
            write_part(
                f"tree_{i}",
                f"tree{columns['PrototypeIds'][i]}.obj",
                '<filter type="rotate"><param key="rotation" type="rotation">'
                f'<rot axis="z" angle_deg="{yaw}"/></param></filter>'
                f'<filter type="scale"><param key="scale" type="double" value="{columns["Scale"][i]}"/>'
                '</filter><filter type="translate"><param key="offset" type="vec3" '
                f'value="{x};{y};{z}"/></filter>',
            )
        )
    text = f'<document><scene id="stand">\n{"".join(parts)}</scene></document>\n'
    (folder / "stand.xml").write_text(text)


def peak():
    return resource.getrusage(resource.RUSAGE_SELF).ru_maxrss / 1024


def main():
    trees, triangles = map(int, sys.argv[1:3])
    start = time.process_time()
    scene = make_stand(trees, triangles)
    count = scene.GetNumberOfTriangles()
    for word in sys.argv[3:]:
        if word != "--copies":
            write_stand(scene, pathlib.Path(word))
            return
        scene = flatten(scene)
    print(f"scene: {count:,} triangles, {time.process_time() - start:.1f} s, {peak():.0f} MiB")
    start = time.process_time()
    plan = vtkhelios.plan(scene, **SETTINGS)
    print(plan)
    print(f"plan: {time.process_time() - start:.1f} s, peak {peak():.0f} MiB")


if __name__ == "__main__":
    main()
