# SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
# SPDX-License-Identifier: BSD-3-Clause
"""A terrestrial survey built by hand, filter by filter; its echoes as numpy arrays without a copy.

What `vtkhelios run` does with a survey file, this does with objects:

    synthetic scene ─────────────────────┬──────────────> port 0 ─┐
                                         │                        ├─ scanner ─> echoes
    waypoint ──> ground snap ──> tripod ─┼──────────────> port 1 ─┘
                     └─ scene ───────────┘

Run it with

    build/venv/bin/python Python/examples/survey_by_hand.py
"""

import numpy as np
from vtkmodules.vtkCommonCore import VTK_DOUBLE, vtkPoints
from vtkmodules.vtkCommonDataModel import vtkPolyData

import vtkhelios


def make_scene():
    """Blocks on flat ground. Any filter that makes triangles will do, e.g. vtkHeliosObjSceneReader."""
    scene = vtkhelios.vtkHeliosSyntheticScene()
    scene.SetKindToBlocks()
    return scene


def make_waypoint(x, y):
    """One point: where the tripod is set up. Coordinates are double, always."""
    points = vtkPoints()
    points.SetDataType(VTK_DOUBLE)
    points.InsertNextPoint(x, y, 0.0)
    waypoint = vtkPolyData()
    waypoint.SetPoints(points)
    return waypoint


def make_platform(scene, waypoint):
    """A tripod, 1.5 m above the ground below (or above) the waypoint."""
    snap = vtkhelios.vtkHeliosGroundSnap()
    snap.SetInputData(0, waypoint)
    snap.SetInputConnection(1, scene.GetOutputPort())
    snap.SetHeightAboveGround(1.5)

    tripod = vtkhelios.vtkHeliosStaticPlatform()
    tripod.SetInputConnection(snap.GetOutputPort())
    return tripod


def make_scanner(scene, platform):
    """A polygon mirror that turns once about the vertical axis: 100,000 pulses a second for 4 s."""
    mirror = vtkhelios.vtkHeliosRotatingMirror()
    mirror.SetPulseFrequency(100_000)  # Hz
    mirror.SetScanFrequency(100)  # lines a second
    mirror.SetMirrorAngle(120)  # deg, half of what a facet sweeps
    mirror.SetVerticalAngleMin(-40)  # deg
    mirror.SetVerticalAngleMax(60)

    beam = vtkhelios.vtkHeliosBeamSampler()
    beam.SetBeamDivergence(0.35e-3)  # rad, full angle at 1/e^2
    beam.SetPatternToCircles()
    beam.SetNumberOfCircles(3)  # 19 sub-rays

    scanner = vtkhelios.vtkHeliosScanner()
    scanner.SetInputConnection(0, scene.GetOutputPort())
    scanner.SetInputConnection(1, platform.GetOutputPort())
    scanner.SetBeamDeflector(mirror)
    scanner.SetBeamSampler(beam)
    scanner.SetHeadRotateStart(0)  # deg
    scanner.SetHeadRotateStop(360)
    scanner.SetHeadRotateSpeed(90)  # deg/s
    scanner.SetRangeMin(0.5)  # m
    scanner.SetRangeMax(600)
    scanner.SetRangeAccuracy(0.005)  # m, one sigma
    return scanner


def main():
    scene = make_scene()
    scanner = make_scanner(scene, make_platform(scene, make_waypoint(0.0, 0.0)))

    echoes = vtkhelios.update(scanner)  # a vtkPolyData; an error would raise PipelineError
    columns = vtkhelios.arrays(echoes)  # views: nothing is copied

    points, ranges = columns["points"], columns["Range"]
    first = columns["ReturnNumber"] == 1
    print(
        f"{scanner.GetNumberOfPulses():,} pulses, {len(points):,} echoes, {first.sum():,} first ones"
    )
    print(
        f"ranges from {ranges.min():.2f} to {ranges.max():.2f} m, median {np.median(ranges):.2f} m"
    )
    print(f"strongest echo {columns['Amplitude'].max() * 1e9:.1f} nW")

    # Changing a property of the scanner runs the scanner again, and nothing above it.
    scanner.SetRangeAccuracy(0.0)
    exact = vtkhelios.arrays(vtkhelios.update(scanner))
    print(f"range noise: {1000 * np.std(ranges - exact['Range']):.2f} mm")
    return columns


if __name__ == "__main__":
    main()
