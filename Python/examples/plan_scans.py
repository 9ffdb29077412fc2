# SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
# SPDX-License-Identifier: BSD-3-Clause
"""Scan planning: plan positions, scan from there, and check the result.

What `vtkhelios plan --check` does with files, this does in memory. Run it with

    build/venv/bin/python Python/examples/plan_scans.py
"""

import numpy as np
from vtkmodules.vtkCommonDataModel import vtkStaticPointLocator

import vtkhelios

TOLERANCE = 0.1  # m, between a test point and its echo
FLATTEST = 80  # deg from the normal: grazing beams are of little use


def make_scene():
    """Boxes on flat ground, 16 m wide."""
    scene = vtkhelios.vtkHeliosSyntheticScene()
    scene.SetKindToBlocks()
    scene.SetSize(16)
    scene.SetHeight(3)
    scene.SetResolution(3)
    return scene


def make_plan(scene):
    """Candidates every 2 m, test points every metre, and the minimum number of scans."""
    return vtkhelios.plan(
        scene,
        grid=2,  # m
        test_grid=1,
        ground="open",  # nothing above it: neither on nor in the boxes
        height=1.7,
        range_min=1.5,  # m: the range of a VZ-400
        elevation_min=-50,  # deg
        elevation_max=50,
        max_incidence=FLATTEST,
        coverage=95,  # %
        resolution=0.2,  # deg, between pulses
        pulse_frequency=100_000,  # Hz
    )


def find_met(cloud, places):
    """Which places have an echo within the tolerance, not at grazing incidence."""
    good = cloud.filter(cloud["IncidenceAngle"] <= FLATTEST)
    locator = vtkStaticPointLocator()
    locator.SetDataSet(good.polydata)
    locator.BuildLocator()
    nearest = [locator.FindClosestPoint(place) for place in places.tolist()]
    return np.linalg.norm(good.points[nearest] - places, axis=1) < TOLERANCE


def main():
    plan = make_plan(make_scene())
    result = plan.report["result"]
    print(
        f"{len(plan)} scans, lower bound {result['bestBound']}; they cover {plan.coverage:.1f} % of "
        "the coverable test points"
    )
    for place, adds in zip(plan.positions, plan.scans["NewlyCovered"]):
        print("  from ({:.1f}, {:.1f}, {:.1f}): {} more test points".format(*place, adds))

    points = plan.test_points.filter(plan.test_points["Coverable"] > 0)
    predicted = points["NumberOfScans"] > 0
    met = find_met(plan.survey().run(noise=False), points.points)
    print(f"predicted {100 * predicted.mean():.2f} %, simulated {100 * met.mean():.2f} %")
    return predicted.mean(), met.mean()


if __name__ == "__main__":
    main()
