# SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
# SPDX-License-Identifier: BSD-3-Clause
"""Two scans of a village of blocks through the Point Cloud Library, filter by filter.

    scan from A ───────────────> port 0 ─┐
                                         ├─ registration ─┐
    scan from B, misaligned ───> port 1 ─┘                ├─ append ─ outliers ─ ground ─ planes
    scan from A ──────────────────────────────────────────┘

The scene is known, so the results are checked against the truth. Run it with

    build/venv/bin/python Python/examples/pcl_filters.py
"""

import numpy as np
from vtkmodules.vtkCommonCore import VTK_DOUBLE, vtkPoints
from vtkmodules.vtkCommonDataModel import vtkPolyData
from vtkmodules.vtkCommonTransforms import vtkTransform
from vtkmodules.vtkFiltersCore import vtkAppendPolyData
from vtkmodules.vtkFiltersGeneral import vtkTransformPolyDataFilter

import vtkhelios
from vtkhelios import pcl


def make_scene():
    """Boxes on flat ground."""
    scene = vtkhelios.vtkHeliosSyntheticScene()
    scene.SetKindToBlocks()
    scene.SetSize(60.0)  # m
    return scene


def make_scan(scene, x, y):
    """The scan of a tripod 1.7 m above a position: 400,000 pulses, no noise."""
    points = vtkPoints()
    points.SetDataType(VTK_DOUBLE)
    points.InsertNextPoint(x, y, 1.7)
    place = vtkPolyData()
    place.SetPoints(points)
    tripod = vtkhelios.vtkHeliosStaticPlatform()
    tripod.SetInputData(place)

    mirror = vtkhelios.vtkHeliosRotatingMirror()
    mirror.SetPulseFrequency(100_000)  # Hz
    mirror.SetScanFrequency(100)  # lines/s
    mirror.SetMirrorAngle(120)  # deg, half of the sweep of a facet
    mirror.SetVerticalAngleMin(-60)  # deg
    mirror.SetVerticalAngleMax(40)

    scanner = vtkhelios.vtkHeliosScanner()
    scanner.SetInputConnection(0, scene.GetOutputPort())
    scanner.SetInputConnection(1, tripod.GetOutputPort())
    scanner.SetBeamDeflector(mirror)
    scanner.SetHeadRotateStart(0)  # deg
    scanner.SetHeadRotateStop(360)
    scanner.SetHeadRotateSpeed(90)  # deg/s
    scanner.SetRangeMin(0.5)  # m
    scanner.SetRangeMax(100)
    scanner.SetRangeAccuracy(0.0)
    return vtkhelios.update(scanner)


def misalign(scan):
    """The scan with its position 30 cm and 2 degrees off."""
    motion = vtkTransform()
    motion.Translate(0.25, -0.15, 0.08)
    motion.RotateZ(2.0)
    moved = vtkTransformPolyDataFilter()
    moved.SetTransform(motion)
    moved.SetInputData(scan)
    return vtkhelios.update(moved)


def thin_out(scan):
    """One echo per 10 cm cube: scans are densest near the tripod."""
    voxels = vtkhelios.vtkHeliosPCLVoxelGrid()
    voxels.SetVoxelSize(0.1)  # m
    voxels.SetInputData(scan)
    return vtkhelios.update(voxels)


def main():
    scene = make_scene()
    fixed = thin_out(make_scan(scene, 0.0, 0.0))
    truth = thin_out(make_scan(scene, 3.0, -2.0))

    # Registers the scan positions: point to plane.
    registration = vtkhelios.vtkHeliosPCLRegistration()
    registration.SetInputData(0, fixed)
    registration.SetInputData(1, misalign(truth))
    aligned = vtkhelios.arrays(vtkhelios.update(registration))["points"]
    error = np.linalg.norm(aligned - vtkhelios.arrays(truth)["points"], axis=1).max()
    print(f"registration: {registration.GetNumberOfPairs():,} pairs, {1000 * error:.3f} mm off")

    # Merges both, down to planes.
    both = vtkAppendPolyData()
    both.AddInputData(fixed)
    both.AddInputConnection(registration.GetOutputPort())
    clean = vtkhelios.vtkHeliosPCLOutlierRemoval()
    clean.SetInputConnection(both.GetOutputPort())
    clean.SetStandardDeviations(4.0)
    ground = vtkhelios.vtkHeliosPCLGroundFilter()
    ground.SetInputConnection(clean.GetOutputPort())
    known = vtkhelios.arrays(vtkhelios.update(clean))["ClassificationIds"] == 2
    found = vtkhelios.arrays(vtkhelios.update(ground))["ClassificationIds"] == 2
    right = (known == found).mean()
    print(f"ground: {found.sum():,} of {len(found):,} echoes, {100 * right:.2f} % right")

    planes = vtkhelios.vtkHeliosPCLPlanes()
    planes.SetInputConnection(ground.GetOutputPort())
    planes.SetDistanceThreshold(0.02)  # m
    planes.SetMinimumNumberOfPoints(1000)
    planes.SetMaximumNumberOfPlanes(3)
    rows = vtkhelios.update(planes).GetFieldData().GetArray("Plane.Coefficients")
    for i in range(rows.GetNumberOfTuples()):
        print("plane: {:.4f} x + {:.4f} y + {:.4f} z + {:.4f} = 0".format(*rows.GetTuple(i)))

    # The cloud in PCL, viewed by numpy: no copy.
    cloud = pcl.CloudEcho.from_polydata(planes.GetOutput())
    print(cloud, "highest", cloud.points[:, 2].max() + cloud.origin[2])
    return {"error": error, "right": right, "ground plane": rows.GetTuple(0), "cloud": cloud}


if __name__ == "__main__":
    main()
