# SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
# SPDX-License-Identifier: BSD-3-Clause
"""Without noise, the echo of a single surface lies on the scene, checked with VTK's cell locator."""

import numpy as np
import pytest
from vtkmodules.vtkCommonCore import VTK_DOUBLE, reference, vtkPoints
from vtkmodules.vtkCommonDataModel import vtkGenericCell, vtkPolyData, vtkStaticCellLocator

import vtkhelios

DIVERGENCE = 0.5e-3  # rad, full angle at 1/e^2
CONE = 1.5 * DIVERGENCE / 2  # half angle of the sampled cone


def one_point(x, y, z):
    points = vtkPoints()
    points.SetDataType(VTK_DOUBLE)
    points.InsertNextPoint(x, y, z)
    waypoint = vtkPolyData()
    waypoint.SetPoints(points)
    return waypoint


def make_scanner(scene, position):
    """A tripod with a 360 deg scan, 200,000 pulses."""
    tripod = vtkhelios.vtkHeliosStaticPlatform()
    tripod.SetInputData(one_point(*position))
    mirror = vtkhelios.vtkHeliosRotatingMirror()
    mirror.SetMirrorAngle(60)
    mirror.SetPulseFrequency(100_000)
    beam = vtkhelios.vtkHeliosBeamSampler()
    beam.SetBeamDivergence(DIVERGENCE)
    scanner = vtkhelios.vtkHeliosScanner()
    scanner.SetInputConnection(0, scene.GetOutputPort())
    scanner.SetInputConnection(1, tripod.GetOutputPort())
    scanner.SetBeamDeflector(mirror)
    scanner.SetBeamSampler(beam)
    scanner.SetHeadRotateStop(360)
    scanner.SetHeadRotateSpeed(180)
    return scanner


def distances(mesh, points):
    """Distances of points to the nearest triangle."""
    locator = vtkStaticCellLocator()
    locator.SetDataSet(mesh)
    locator.BuildLocator()
    nearest, cell = [0.0, 0.0, 0.0], vtkGenericCell()
    found, sub, squared = reference(0), reference(0), reference(0.0)
    result = []
    for point in points:
        locator.FindClosestPoint(point, nearest, cell, found, sub, squared)
        result.append(float(squared) ** 0.5)
    return np.array(result)


def sub_ray_ranges(scanner, pulses):
    """The minimum and maximum range of the sub-rays of each of some pulses."""
    hits = vtkhelios.arrays(scanner.GetOutput(3))
    nearest = np.full(pulses.max() + 1, np.inf)
    farthest = -nearest
    np.minimum.at(nearest, hits["PulseIds"], hits["Range"])
    np.maximum.at(farthest, hits["PulseIds"], hits["Range"])
    return nearest[pulses], farthest[pulses]


@pytest.mark.parametrize("kind", ["Blocks", "Terrain", "House"])
def test_single_echoes_lie_on_the_scene(kind):
    scene = vtkhelios.vtkHeliosSyntheticScene()
    getattr(scene, f"SetKindTo{kind}")()
    if kind == "Terrain":
        scene.SetSize(100)
        scene.SetResolution(100)
    scanner = make_scanner(scene, (1.0, -14.0, 12.0))
    scanner.GenerateSubRaysOn()
    vtkhelios.update(scanner)
    columns = vtkhelios.arrays(scanner.GetOutput(0))
    single = columns["NumberOfReturns"] == 1
    assert single.sum() > 5_000
    ranges = columns["Range"][single]
    away = distances(scene.GetOutput(), columns["points"][single])
    # On a plane only the beam's centre matters; across an edge the echo is of the whole beam.
    assert np.quantile(away, 0.5) < 1e-5
    assert np.quantile(away, 0.98) < 2e-3
    nearest, farthest = sub_ray_ranges(scanner, columns["PulseIds"][single])
    assert np.all((ranges > nearest - 1e-5) & (ranges < farthest + 1e-5))
    # A spread larger than one plane's means two surfaces, with their echo between them.
    footprint = CONE * ranges / np.cos(np.radians(columns["IncidenceAngle"][single]))
    on_one = farthest - nearest <= 2 * footprint + 1e-5
    assert on_one.mean() > 0.995
    assert np.all(away[on_one] < footprint[on_one] + 1e-5)


def test_a_shift_to_utm_shifts_the_cloud():
    shift = np.array([500_000.0, 5_500_000.0, 300.0])
    clouds = []
    for origin in (np.zeros(3), shift):
        scene = vtkhelios.vtkHeliosSyntheticScene()
        scene.SetKindToBlocks()
        scene.SetOrigin(*origin)
        scanner = make_scanner(scene, np.array([1.0, -14.0, 12.0]) + origin)
        clouds.append(vtkhelios.arrays(vtkhelios.update(scanner)))
    assert len(clouds[0]["points"]) == pytest.approx(len(clouds[1]["points"]), rel=1e-3)
    both = np.intersect1d(clouds[0]["PulseIds"], clouds[1]["PulseIds"], return_indices=True)[1:]
    moved = clouds[1]["points"][both[1]] - shift - clouds[0]["points"][both[0]]
    # coordinates of vertices round to 1e-9 m there; grazing incidence amplifies that
    assert np.quantile(np.abs(moved), 0.99) < 1e-8
