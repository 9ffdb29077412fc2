# SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
# SPDX-License-Identifier: BSD-3-Clause
"""Scenes of known plant area, scanned and found again; and where that fails."""

import importlib

import numpy as np
import pytest

import vtkhelios

SURVEY = """\
<document>
  <survey name="s" scene="#s" platform="platforms.xml#tripod" scanner="scanners.xml#vz400_class_tls">
    {legs}
  </survey>
  <scene id="s"><part><filter type="detailedvoxels"><param key="filepath" value="{file}"/></filter></part></scene>
</document>
"""
LEG = """<leg><platformSettings x="{x}" y="{y}" z="-1.7" onGround="false"/>
      <scannerSettings pulseFreq_hz="50000" verticalAngleMin_deg="-16" verticalAngleMax_deg="16"
        verticalResolution_deg="0.4" horizontalResolution_deg="0.4" headRotateStart_deg="{a}"
        headRotateStop_deg="{b}"/></leg>"""
BOX = (-2, 2, 8, 12, -2, 2)
CELLS = 4


def write_voxels(path, density):
    rows = "".join(f"{i} {j} {k} {density[i, j, k]}\n" for i, j, k in np.ndindex(density.shape))
    path.write_text(
        "VOXEL SPACE\n#min_corner: -2 8 -2\n#max_corner: 2 12 2\n#split: 4 4 4\n#res: 1\n"
        f"i j k PadBVTotal\n{rows}"
    )


def scan_voxels(folder, name, **options):
    legs = LEG.format(x=0, y=0, a=-16, b=16) + LEG.format(x=9, y=12, a=80, b=125)
    path = folder / "survey.xml"
    path.write_text(SURVEY.format(legs=legs, file=name))
    return vtkhelios.read_survey(path).run(pulses=True, **options)


@pytest.fixture
def density():
    return np.round(np.random.default_rng(1).uniform(0, 1.5, (CELLS,) * 3), 3)


def test_turbid_voxels_within_the_standard_error(tmp_path, density):
    """From two positions, by photon paths; written as .vox, scanned and found again."""
    write_voxels(tmp_path / "leaves.vox", density)
    cloud = scan_voxels(tmp_path, "leaves.vox", sub_rays=1)
    found = cloud.plant_area(voxel=1.0, bounds=BOX)
    z = (found.pad - density) / found["DensityError"]
    assert found.shape == (4, 4, 4) and found["NumberOfBeams"].min() > 50
    assert abs(z.mean()) < 0.4 and 0.7 < z.std() < 1.3
    assert found.area == pytest.approx(density.sum(), abs=3 * found.area_error)

    found.write(tmp_path / "found.vox")
    again = scan_voxels(tmp_path, "found.vox", sub_rays=1, seed=5)
    second = again.plant_area(voxel=1.0, bounds=BOX)
    z = (second.pad - found.pad) / second["DensityError"]
    assert abs(z.mean()) < 0.4 and 0.7 < z.std() < 1.3


def test_sub_rays_share_the_energy(tmp_path, density):
    """Hits have the energy that leaves intercept; echoes alone have no place for what passes."""
    write_voxels(tmp_path / "leaves.vox", density)
    cloud = scan_voxels(tmp_path, "leaves.vox", hits=True)
    found = cloud.plant_area(voxel=1.0, bounds=BOX)
    assert found.area == pytest.approx(density.sum(), abs=3 * found.area_error)
    assert found.area_error < 0.02 * density.sum()
    cloud.sub_rays = None
    assert cloud.plant_area(voxel=1.0, bounds=BOX).area > 2 * density.sum()


@pytest.fixture
def study(monkeypatch, request):
    monkeypatch.syspath_prepend(request.config.rootpath / "Python/studies")
    return importlib.import_module("leaf_area")


def scan_box(study, stand, distance, **options):
    """Scans a box of triangles from a distance, with pulses 3 cm apart."""
    width, step = np.degrees([np.arctan(1.7 / (distance - 1.7)), 0.03 / distance])
    leg = dict(position=(0, -distance, 4.0 - study.TRIPOD), head=(-width, width))
    survey = vtkhelios.make_survey(
        stand.scene, [leg], scanner="vz400_class_tls", pulse_frequency=100_000,
        vertical=(-width, width), vertical_resolution=step, horizontal_resolution=step,
    )  # fmt: skip
    return survey.run(pulses=True, seed=1, **options)


BOX_OF_LEAVES = (-1.5, 1.5, -1.5, 1.5, 2.5, 5.5)


@pytest.mark.parametrize("options", [dict(sub_rays=1), dict(hits=True)], ids=["lines", "hits"])
def test_triangles_of_known_area(study, options):
    stand = study.make_box(0)
    true = stand.area_in(study.Grid((-1.5, -1.5, 2.5), (1.5, 1.5, 5.5), 1.0))
    cloud = scan_box(study, stand, 10.0, **options)
    found = cloud.plant_area(voxel=1.0, bounds=BOX_OF_LEAVES, leaf_size=study.triangle_area())
    z = (found.pad * 1.0 - true.reshape(found.shape)) / found["DensityError"]
    assert abs(z.mean()) < 0.6 and z.std() < 1.3
    assert found.area == pytest.approx(true.sum(), abs=3 * found.area_error)
    assert 0.005 < found.area_error / found.area < 0.02
    by_angles = cloud.plant_area(voxel=1.0, bounds=BOX_OF_LEAVES, leaf_angles="incidence")
    assert by_angles.area == pytest.approx(true.sum(), rel=0.04)


def test_edge_hits_of_echoes_enlarge_leaves(study):
    """Echoes say where energy is met, not how much: leaves grow with the footprint."""
    stand = study.make_box(0)
    true = stand.area_in(study.Grid((-1.5, -1.5, 2.5), (1.5, 1.5, 5.5), 3.0))[0]
    near, far = (
        scan_box(study, stand, distance).plant_area(voxel=1.0, bounds=BOX_OF_LEAVES).area / true
        for distance in (10.0, 40.0)
    )
    assert 1.3 < near < 1.7 < far


def test_clumps_hide_leaves():
    """All leaves of a voxel in an eighth of it: large voxels have less than half of them."""
    random = np.random.default_rng(4)
    count, density = 40_000, 16.0  # in the small cube
    origins = np.column_stack([np.full(count, -1.0), *random.uniform(0, 1, (2, count))])
    inside = (origins[:, 1:] < 0.5).all(axis=1)
    ranges = 1 + random.exponential(1 / (0.5 * density), count)
    ranges[(ranges > 1.5) | ~inside] = np.inf
    hit = np.isfinite(ranges)
    ids, along = np.arange(count), np.array([1.0, 0, 0])
    points = origins[hit] + ranges[hit, None] * along
    cloud = vtkhelios.Cloud.from_arrays(points, PulseIds=ids[hit])
    directions = np.repeat(along[None], count, axis=0)
    cloud.pulses = vtkhelios.Cloud.from_arrays(origins, Direction=directions, PulseIds=ids)
    areas = [cloud.plant_area(voxel=voxel, bounds=(0, 1, 0, 1, 0, 1)).area for voxel in (0.5, 1.0)]
    assert areas[0] == pytest.approx(density / 8, rel=0.05)
    assert areas[1] < 0.45 * density / 8


def test_shadows_are_marked_and_filled_by_their_layer():
    """A wall hides half of a layer."""
    y = np.arange(0.125, 4, 0.25)
    origins = np.column_stack([np.full(len(y), -1.0), y, np.full(len(y), 0.5)])
    directions = np.repeat([[1.0, 0, 0]], len(y), axis=0)
    wall = y < 2
    points = origins + np.where(wall, 0.5, 2.5)[:, None] * directions
    ids = np.arange(len(y))
    classes = np.where(wall, 2, 5)
    cloud = vtkhelios.Cloud.from_arrays(points, PulseIds=ids, ClassificationIds=classes)
    cloud.pulses = vtkhelios.Cloud.from_arrays(origins, Direction=directions, PulseIds=ids)
    found = cloud.plant_area(voxel=1.0, bounds=(0, 2, 0, 4, 0, 1))
    assert (found["CellState"][:, :2] == 2).all() and (found["CellState"][:, 2:] == 1).all()
    assert np.isnan(found.pad[:, :2]).all() and found.ground_area == 8
    (row,) = found.profile()
    assert row["seen"] == row["shadowed"] == 0.5
    assert found.lai == pytest.approx(2 * found.lai_seen)


def test_wood_and_leaves_apart():
    """By material: wood ends beams and is no hit."""
    random = np.random.default_rng(6)
    count, leaf, wood = 30_000, 1.2, 0.4
    origins = np.column_stack([*random.uniform(0, 2, (2, count)), np.full(count, 3.0)])
    down = np.repeat([[0.0, 0, -1.0]], count, axis=0)
    ranges = 1 + random.exponential(2 / (leaf + wood), count)
    materials = (random.uniform(size=count) < wood / (leaf + wood)).astype(np.int32)
    hit = ranges < 3
    ids = np.arange(count)
    cloud = vtkhelios.Cloud.from_arrays(
        (origins + ranges[:, None] * down)[hit], PulseIds=ids[hit], MaterialIds=materials[hit]
    )
    cloud.pulses = vtkhelios.Cloud.from_arrays(origins, Direction=down, PulseIds=ids)
    box = (0, 2, 0, 2, 0, 2)
    for material, true in ((0, leaf), (1, wood)):
        found = cloud.plant_area(voxel=1.0, bounds=box, materials=[material])
        assert found.area == pytest.approx(8 * true, abs=3 * found.area_error)
