# SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
# SPDX-License-Identifier: BSD-3-Clause
"""Scan planning: plan positions, scan from there, and check the result.

What `vtkhelios plan --check` does with files, this does with objects:

    scene ─┬─> candidates ──┐
           ├─> test points ─┼─> viewsheds ─> planner ─┬─> positions ─> survey.xml ─> player ─> echoes
           └────────────────┘                         └─> test points: who sees them

Run it with

    build/venv/bin/python Python/examples/plan_scans.py
"""

import pathlib
import tempfile

import numpy as np
from vtkmodules.util.numpy_support import numpy_to_vtk
from vtkmodules.vtkCommonCore import vtkPoints
from vtkmodules.vtkCommonDataModel import vtkPolyData, vtkStaticPointLocator
from vtkmodules.vtkIOXML import vtkXMLPPolyDataReader

import vtkhelios

TOLERANCE = 0.1  # m, between a test point and its echo
RESOLUTION = 0.2  # deg, between pulses
FLATTEST = 80  # deg from the normal: grazing beams are of little use


def make_scene(folder):
    """Boxes on flat ground, 16 m wide, as an OBJ file: surveys use files."""
    scene = vtkhelios.vtkHeliosSyntheticScene()
    scene.SetKindToBlocks()
    scene.SetSize(16)
    scene.SetHeight(3)
    scene.SetResolution(3)
    writer = vtkhelios.vtkHeliosObjSceneWriter()
    writer.SetInputConnection(scene.GetOutputPort())
    writer.SetFileName(str(folder / "blocks.obj"))
    writer.Write()
    return scene


def plan_positions(scene):
    """Candidates every 2 m, test points every metre, and the minimum number of scans."""
    candidates = vtkhelios.vtkHeliosScanPositionCandidates()
    candidates.SetInputConnection(scene.GetOutputPort())
    candidates.SetStep(2)  # m
    candidates.SetSurfaceToOpenGround()  # nothing above it: neither on nor in the boxes
    candidates.SetScannerHeight(1.7)  # m

    test_points = vtkhelios.vtkHeliosVisibilityTestPoints()
    test_points.SetInputConnection(scene.GetOutputPort())
    test_points.SetStep(1)

    viewsheds = vtkhelios.vtkHeliosViewsheds()
    for port, source in enumerate((scene, candidates, test_points)):
        viewsheds.SetInputConnection(port, source.GetOutputPort())
    viewsheds.SetMinimumRange(1.5)  # m: as for a VZ-400
    viewsheds.SetMinimumElevation(-50)  # deg
    viewsheds.SetMaximumElevation(50)
    viewsheds.SetMaximumIncidenceAngle(FLATTEST)

    planner = vtkhelios.vtkHeliosScanPositionPlanner()
    planner.SetInputConnection(0, viewsheds.GetOutputPort())
    planner.SetInputConnection(1, test_points.GetOutputPort())
    planner.SetMinimumCoverage(95)  # %
    return planner


def write_survey(planner, folder):
    """One leg per position; the writer subtracts tripod and scanner height from a leg's z."""
    lines = 100_000 * RESOLUTION / 240  # per second: the mirror sweeps 240 deg
    writer = vtkhelios.vtkHeliosSurveyWriter()
    writer.SetInputConnection(planner.GetOutputPort(2))
    writer.SetFileName(str(folder / "survey.xml"))
    writer.AddAssetDirectory(str(vtkhelios.data_directory() / "Assets"))
    writer.SetScene("blocks.obj")
    writer.SetPlatform("platforms.xml#tripod")
    writer.SetScanner("scanners.xml#vz400_class_tls")
    writer.SetPulseFrequency(100_000)  # Hz
    writer.SetScanFrequency(lines)
    writer.SetHeadRotatePerSecond(RESOLUTION * lines)  # deg/s
    if not writer.Write():
        raise RuntimeError("the survey cannot be written")


def run_survey(folder):
    """Runs it; one cloud per leg."""
    reader = vtkhelios.vtkHeliosSurveyReader()
    reader.SetFileName(str(folder / "survey.xml"))
    reader.AddAssetDirectory(str(vtkhelios.data_directory() / "Assets"))
    reader.Read()
    player = vtkhelios.vtkHeliosSurveyPlayer()
    player.SetSurvey(reader.GetSurvey())
    player.SetOutputDirectory(str(folder))
    player.SetFormat("vtp")
    player.GetOptions().SetNoise(False)
    if not player.Run():
        raise RuntimeError(player.GetMessage())
    for leg in range(player.GetNumberOfLegs()):
        cloud = vtkXMLPPolyDataReader()
        cloud.SetFileName(f"{player.GetRunFolder()}/leg{leg:03}_points.pvtp")
        yield vtkhelios.update(cloud)


def find_met(clouds, places):
    """Which positions have an echo within the tolerance, not at grazing incidence."""
    met = np.zeros(len(places), dtype=bool)
    for cloud in clouds:
        columns = vtkhelios.arrays(cloud)
        echoes = columns["points"][columns["IncidenceAngle"] <= FLATTEST]
        good = vtkPolyData()
        good.SetPoints(vtkPoints())
        good.GetPoints().SetData(numpy_to_vtk(echoes, deep=True))
        locator = vtkStaticPointLocator()
        locator.SetDataSet(good)
        locator.BuildLocator()
        nearest = [locator.FindClosestPoint(place) for place in places.tolist()]
        met |= np.linalg.norm(echoes[nearest] - places, axis=1) < TOLERANCE
    return met


def main():
    with tempfile.TemporaryDirectory() as name:
        folder = pathlib.Path(name)
        planner = plan_positions(make_scene(folder))
        points = vtkhelios.arrays(vtkhelios.update(planner, 1))
        positions = vtkhelios.arrays(planner.GetOutputDataObject(2))
        print(
            f"{planner.GetNumberOfSelected()} scans, lower bound {planner.GetBestBound()}; they "
            f"cover {planner.GetCoverableCoverage():.1f} % of the coverable test points"
        )
        for place, adds in zip(positions["points"], positions["NewlyCovered"]):
            print("  from ({:.1f}, {:.1f}, {:.1f}): {} more test points".format(*place, adds))

        write_survey(planner, folder)
        coverable = points["Coverable"] > 0
        predicted = points["NumberOfScans"][coverable] > 0
        met = find_met(run_survey(folder), points["points"][coverable])
    print(f"predicted {100 * predicted.mean():.2f} %, simulated {100 * met.mean():.2f} %")
    return predicted.mean(), met.mean()


if __name__ == "__main__":
    main()
