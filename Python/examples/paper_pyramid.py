# SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
# SPDX-License-Identifier: BSD-3-Clause
"""The pyramid of Bechtold and Hoefle 2016, figure 5: two orders of removal, two plans.

A small pyramid on a steep base stands on flat ground. Removing the smallest viewsheds first keeps
the position on top, which has the largest, and needs two more; removing the smallest mean incidence
first drops it, since it looks steeply down, and two opposite corners are enough.

    xvfb-run -a build/venv/bin/python Python/examples/paper_pyramid.py pyramid

draws pyramid_viewshedsize.png and pyramid_meanincidenceangle.png; without a name it only prints.
"""

import sys

import numpy as np
from vtkmodules.util.numpy_support import numpy_to_vtk
from vtkmodules.vtkCommonCore import vtkPoints
from vtkmodules.vtkCommonDataModel import vtkCellArray, vtkPolyData

import vtkhelios


def make_scene():
    """A ring of ground 21 m wide, a base 5 m wide and 2 m high, and a pyramid of 0.44 m on it."""
    corners = np.array([(-1, -1), (1, -1), (1, 1), (-1, 1)])
    squares = [(10.5, 0.0), (2.5, 0.0), (1.75, 2.0)]  # half width, height
    places = [(*(half * corner), z) for half, z in squares for corner in corners]
    places.append((0, 0, 2.4375))
    points = vtkPoints()
    points.SetData(numpy_to_vtk(np.array(places, dtype=float), deep=True))
    polys = vtkCellArray()

    def add(*ids):
        polys.InsertNextCell(3)
        for number in ids:
            polys.InsertCellPoint(number)

    for i, j in ((0, 1), (1, 2), (2, 3), (3, 0)):
        for ring in (0, 4):  # ring of the ground, then of the base
            add(ring + i, ring + j, ring + 4 + j)
            add(ring + i, ring + 4 + j, ring + 4 + i)
        add(8 + i, 8 + j, 12)
    scene = vtkPolyData()
    scene.SetPoints(points)
    scene.SetPolys(polys)
    return scene


def make_planner(scene):
    """Candidates and test points every metre, as in the paper; the scanner at 1.5 m."""
    candidates = vtkhelios.vtkHeliosScanPositionCandidates()
    candidates.SetInputData(scene)
    candidates.SetStep(1)
    candidates.SetMaximumSlope(30)  # deg
    candidates.SetScannerHeight(1.5)  # m
    test_points = vtkhelios.vtkHeliosVisibilityTestPoints()
    test_points.SetInputData(scene)
    test_points.SetStep(1)
    test_points.HorizontalOff()
    viewsheds = vtkhelios.vtkHeliosViewsheds()
    viewsheds.SetInputData(0, scene)
    viewsheds.SetInputConnection(1, candidates.GetOutputPort())
    viewsheds.SetInputConnection(2, test_points.GetOutputPort())
    viewsheds.BothSidesOn()  # the paper's test
    planner = vtkhelios.vtkHeliosScanPositionPlanner()
    planner.SetInputConnection(0, viewsheds.GetOutputPort())
    planner.SetInputConnection(1, test_points.GetOutputPort())
    return planner


def main(name=None):
    scene = make_scene()
    planner = make_planner(scene)
    plans = {}
    for method in ("ViewshedSize", "MeanIncidenceAngle"):
        getattr(planner, f"SetMethodTo{method}")()
        columns = vtkhelios.arrays(vtkhelios.update(planner, 2))
        plans[method] = columns["points"].copy()
        print(f"{method}: {len(plans[method])} positions, largest best incidence ", end="")
        print(f"{planner.GetWorstIncidenceAngle():.2f} deg")
        for place, sees in zip(plans[method], columns["ViewshedSize"]):
            print("  ({:g}, {:g}, {:g}) sees {} of 441 test points".format(*place, sees))
        if name:
            from vtkhelios import plan_picture

            plan_picture.save_picture(
                scene,
                planner.GetOutputDataObject(1),
                planner.GetOutputDataObject(2),
                f"{name}_{method.lower()}.png",
                title=f"smallest {'viewshed' if method == 'ViewshedSize' else 'incidence'} removed first",
                elevation=35.0,
            )
    return plans


if __name__ == "__main__":
    main(*sys.argv[1:2])
