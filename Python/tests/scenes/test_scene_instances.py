# SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
# SPDX-License-Identifier: BSD-3-Clause
"""Scenes with instances in Python: plans, pictures, boxes equal the results of copies."""

import os
import shutil
import subprocess
import sys

import numpy as np
import pytest

from vtkmodules.util.numpy_support import vtk_to_numpy

import vtkhelios
from vtkhelios.scenes import meshes as meshes
from vtkhelios.core.arrays import arrays
from vtkhelios.core.reading import look_up
from vtkhelios.plans.document import PLATFORM, SCANNER
from vtkhelios.scenes.scene import count_triangles, flatten, has_instances

TREES = 12


def _write_mesh(path, points, faces, material):
    lines = [f"mtllib {path.stem}.mtl", *("v {} {} {}".format(*p) for p in points)]
    lines += [f"usemtl {material}", *("f {} {} {}".format(*(1 + k for k in f)) for f in faces)]
    path.write_text("\n".join(lines) + "\n")
    ground = "helios_isGround 1\n" if material == "ground" else ""
    path.with_suffix(".mtl").write_text(f"newmtl {material}\n{ground}")


def _part(name, file, *filters):
    load = (
        '<filter type="objloader"><param type="string" key="filepath" ' f'value="{file}"/></filter>'
    )
    return f'<part id="{name}">{load}{"".join(filters)}</part>'


def _tree(number, rng):
    x, y = rng.uniform(-9, 9, 2)
    return _part(
        f"tree_{number}",
        "tree.obj",
        '<filter type="rotate"><param key="rotation" type="rotation">'
        f'<rot axis="z" angle_deg="{rng.uniform(0, 360)}"/></param></filter>',
        f'<filter type="scale"><param type="double" key="scale" value="{rng.uniform(0.6, 1.5)}"/>'
        "</filter>",
        f'<filter type="translate"><param type="vec3" key="offset" value="{x};{y};0"/></filter>',
    )


@pytest.fixture
def stand(tmp_path, monkeypatch):
    """A scene file of trees on a lawn; its folder is the working directory."""
    rng = np.random.default_rng(5)
    lawn = [(-10, -10, 0), (10, -10, 0), (10, 10, 1), (-10, 10, 1)]
    _write_mesh(tmp_path / "lawn.obj", lawn, [(0, 1, 2), (0, 2, 3)], "ground")
    leaves = rng.uniform((-1, -1, 1), (1, 1, 4), (60, 3))[:, None] + rng.uniform(
        -0.5, 0.5, (60, 3, 3)
    )
    faces = np.arange(180).reshape(-1, 3)
    _write_mesh(tmp_path / "tree.obj", leaves.reshape(-1, 3), faces, "leaf")
    parts = [_part("lawn", "lawn.obj"), *(_tree(i, rng) for i in range(TREES))]
    path = tmp_path / "stand.xml"
    path.write_text(f'<document><scene id="stand">{"".join(parts)}</scene></document>')
    monkeypatch.chdir(tmp_path)
    return path


def _read(path, instances):
    reader = vtkhelios.vtkHeliosPlannerReader(instances=instances)
    look_up(reader, str(path), [])
    reader.SetDefaultPlatform(PLATFORM)
    reader.SetDefaultScanner(SCANNER)
    return reader


def _plan(path, instances, **settings):
    return vtkhelios.plan(str(path) if instances else _read(path, False), **settings)


def _scene(path, instances):
    reader = _read(path, instances)
    reader.Update()
    return reader.GetOutput()


def test_a_plan_is_that_of_copies(stand):
    plan, truth = (_plan(stand, each, grid=2, resolution=1) for each in (True, False))
    assert has_instances(plan.scene) and not has_instances(truth.scene)
    assert plan.scene.GetNumberOfInstances() == TREES
    for ours, theirs in zip(plan.outputs, truth.outputs):
        ours, theirs = arrays(ours), arrays(theirs)
        assert ours.keys() == theirs.keys()
        for name in ours:
            assert np.array_equal(ours[name], theirs[name], equal_nan=True), name
    assert len(plan.candidates) > 20 and len(plan.test_points) > 100


DRAW = """
import sys
import numpy as np, vtkhelios
from vtkhelios.plan_picture import View, save_picture
from vtkhelios.scene import flatten
plan = vtkhelios.plan("stand.xml", grid=2, resolution=1)
scene = plan.scene
views = [View(each, (300, 200), 215.0, 45.0) for each in (scene, flatten(scene))]
ours, theirs = (view.distance for view in views)
both = np.isfinite(ours) & np.isfinite(theirs)
print(np.isfinite(theirs).mean(), (np.isfinite(ours) != np.isfinite(theirs)).mean(),
      (np.abs(ours[both] - theirs[both]) > 0.01).mean())
save_picture(scene, *plan.outputs[1:], "plan.png", size=(300, 150))
"""


def test_a_picture_is_that_of_copies(stand):
    if not shutil.which("xvfb-run"):
        pytest.skip("xvfb-run is missing")
    done = subprocess.run(
        ["xvfb-run", "-a", "-s", "-screen 0 800x600x24", sys.executable, "-c", DRAW],
        env={**os.environ, "PYTHONPATH": ":".join(sys.path)},
        capture_output=True,
        text=True,
        timeout=600,
    )
    assert done.returncode == 0, done.stderr
    drawn, other, apart = map(float, done.stdout.splitlines()[0].split())
    assert drawn > 0.2 and other < 0.01 and apart < 0.01  # outlines
    assert (stand.parent / "plan.png").stat().st_size > 10000


def test_a_scene_with_instances(stand, tmp_path):
    scene = vtkhelios.Scene(_scene(stand, True))
    truth = vtkhelios.Scene(_scene(stand, False))
    assert has_instances(scene.polydata) and not has_instances(truth.polydata)
    assert len(scene) == len(truth) == count_triangles(scene.polydata) == 2 + 60 * TREES
    assert np.array_equal(scene.bounds, truth.bounds)
    assert repr(scene) == repr(truth)
    written = []
    for each in (scene, truth):
        each.write(tmp_path / "written.obj")
        written.append((tmp_path / "written.obj").read_bytes())
    assert written[0] == written[1]
    assert flatten(truth.polydata) is truth.polydata


@pytest.mark.parametrize("what", ["points", "triangles"])
def test_instances_have_no_points_of_their_own(stand, what):
    scene = vtkhelios.Scene(_scene(stand, True))
    with pytest.raises(ValueError, match=f"the scene has {TREES} instances, and {what} are of one"):
        getattr(scene, what)


def test_materials_of_instances_are_those_of_meshes(stand):
    with pytest.raises(
        ValueError, match="12 instances, and reflectance, ground and optics are of one mesh"
    ):
        vtkhelios.Scene(_scene(stand, True), reflectance=0.3)


def test_plans_of_a_scene_in_memory(stand, tmp_path):
    plan, truth = (
        vtkhelios.plan(vtkhelios.Scene(_scene(stand, each)), grid=2, resolution=2, name="memory")
        for each in (True, False)
    )
    assert np.array_equal(plan.positions, truth.positions)
    clouds = [each.survey().run(legs=0, noise=False, sub_rays=1) for each in (plan, truth)]
    assert np.array_equal(clouds[0].points, clouds[1].points) and len(clouds[0]) > 1000
    assert [path.name for path in plan.write(tmp_path)]
    assert (tmp_path / "memory/scene.obj").is_file()


def test_a_comparison_takes_instances_as_copies(stand):
    from vtkhelios.comparison._compare import read_mesh

    assert read_mesh(_scene(stand, True)).GetNumberOfPolys() == 2 + 60 * TREES


def test_parts_of_instances_are_left_out(stand):
    scene, truth = (_scene(stand, each) for each in (True, False))
    groups = meshes.find_groups(scene)
    assert groups == meshes.find_groups(truth)
    assert [(group.name, group.triangles) for group in groups] == [
        (f"tree ({TREES} parts)", 60 * TREES),
        ("lawn", 2),
    ]
    trees = range(3, 7)
    rest = meshes.without_parts(scene, trees)
    assert rest.GetNumberOfInstances() == TREES - 4
    ours, theirs = flatten(rest), meshes.without_parts(truth, trees)
    assert np.array_equal(_corners(ours), _corners(theirs))
    alone = meshes.without_parts(scene, [0])
    assert alone.GetNumberOfPolys() == 0 and count_triangles(alone) == 60 * TREES
    assert meshes.find_groups(alone) == groups[:1]
    again = meshes.without_parts(alone, trees)
    assert count_triangles(again) == 60 * (TREES - 4)


def _corners(mesh):
    triangles = vtk_to_numpy(mesh.GetPolys().GetConnectivityArray())
    return vtk_to_numpy(mesh.GetPoints().GetData())[triangles]


def test_a_tradeoff_of_instances(stand, monkeypatch):
    """Measures the instances themselves; what needs copies is left out if there are too many."""
    from vtkhelios.surveys import tradeoff_run as _tradeoff_run

    monkeypatch.setattr(_tradeoff_run, "MAXIMUM_COPIED", 100)
    monkeypatch.setattr(_tradeoff_run, "MAXIMUM_TRIANGLES", 100)
    plan = vtkhelios.plan(str(stand), grid=5, resolution=3)
    result = plan.survey().tradeoff(pulses=10, seconds=1e6)
    casters = [row.name for row in result.ways if row.kind == "ray caster"]
    assert casters == ["ray caster beam"]
    absent = " ".join(result.absent)
    assert (
        "ray caster bvh: it copies instances, and the scene has 722 triangles with them" in absent
    )
    assert "simplified meshes: the scene has 722 triangles" in absent
    names = [row.name for row in result.parts]
    assert "without lawn" in names and f"without tree ({TREES} parts)" in names
