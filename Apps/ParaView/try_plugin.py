# SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
# SPDX-License-Identifier: BSD-3-Clause
"""Tries every proxy of the plugin, and compares clouds of ParaView with those of vtkhelios run.

    pvpython Apps/ParaView/try_plugin.py PLUGIN FOLDER
    mpiexec -n 2 pvbatch Apps/ParaView/try_plugin.py PLUGIN FOLDER

PLUGIN is vtkHelios.so; FOLDER has survey.xml with its files, and points.xyz, its echoes by
vtkhelios run. Writes survey.png and, of several ranks, survey-N.png to FOLDER.
"""

import math
import os
import sys

import numpy as np
from paraview import servermanager, simple
from vtkmodules.util.numpy_support import vtk_to_numpy


def make(name, **values):
    """A source or filter by its name in the menu, without blanks: a function of the plugin."""
    return globals()[name](**values)


def fetch(source, port=0):
    """The data of all ranks."""
    source.UpdatePipeline()
    return servermanager.Fetch(source, idx=port)


def read_points(data):
    return vtk_to_numpy(data.GetPoints().GetData())


def check(condition, what):
    if not condition:
        sys.exit(f"not as expected: {what}")
    print(f"ok: {what}", flush=True)


def try_survey(folder):
    """The survey as a source: the echoes of vtkhelios run."""
    survey = make("LiDARSurvey", FileName=os.path.join(folder, "survey.xml"))
    survey.AssetDirectories = [folder]
    survey.Options.Seed = 5
    echoes = read_points(fetch(survey))
    rows = np.loadtxt(os.path.join(folder, "points.xyz"), usecols=(0, 1, 2))
    check(len(echoes) == len(rows), f"{len(rows)} echoes, as by vtkhelios run")
    check(np.abs(echoes - rows).max() < 1e-4, "echoes in the same places and order")
    survey.Options.PulseStep = 10
    check(0 < len(read_points(fetch(survey))) < len(rows) / 5, "a sample of the pulses")
    survey.Options.PulseStep = 1
    survey.GenerateWaveforms = 1
    survey.UpdatePipeline()
    waveforms = survey.GetDataInformation(1).GetNumberOfRows()
    check(0.9 * len(rows) / 2 < waveforms <= len(rows), f"{waveforms} waveforms")
    survey.GenerateWaveforms = 0
    return survey


def try_errors():
    """Errors have the texts of the classes."""
    texts = []

    def collect(_object, _event, text):
        texts.append(text)

    collect.CallDataType = "string0"
    survey = make("LiDARSurvey")
    survey.GetClientSideObject().AddObserver("ErrorEvent", collect)
    survey.UpdatePipeline()
    check("FileName is not set; give a survey" in "".join(texts), "an error without a file")
    simple.Delete(survey)


def try_scene(folder):
    """Read, transformed, composed."""
    scene = make("OBJScene", FileName=os.path.join(folder, "fence.obj"))
    moved = make("TransformScene", Input=scene, Translation=[100, 0, 0])
    both = make("ComposeScene", Input=[scene, moved])
    data = fetch(both)
    check(data.GetNumberOfCells() == 2 * fetch(scene).GetNumberOfCells(), "a composed scene")
    check(data.GetCellData().GetArray("PartIds").GetRange() == (0, 1), "its part ids")
    check(data.GetBounds()[1] - fetch(scene).GetBounds()[1] == 100, "a transformed part")
    return scene


def try_scanner(scene):
    """A tripod 2 m above the ground; the ranges of the ground below are 2 m / cos."""
    place = simple.PointSource(Center=[0, 0, 2], NumberOfPoints=1, Radius=0)
    platform = make("StaticPlatform", Input=place)
    scanner = make("LiDARScanner", Input=scene, Trajectory=platform)
    scanner.BeamDeflector.ScanFrequency = 100
    scanner.BeamDeflector.VerticalAngleMin, scanner.BeamDeflector.VerticalAngleMax = -80, -30
    scanner.HeadRotateStop, scanner.HeadRotateSpeed = 90, 90
    data = fetch(scanner)
    ranges = vtk_to_numpy(data.GetPointData().GetArray("Range"))
    points = read_points(data)
    below = np.abs(points[:, 2]) < 0.01
    check(below.sum() > 10000, f"{len(ranges)} echoes of a scanner")
    distances = np.linalg.norm(points - [0, 0, 2], axis=1)
    check(np.abs(distances - ranges).max() < 1e-6, "ranges from the tripod")


def try_flight(scene):
    """A path 40 m up: its times follow from its speed."""
    line = simple.Line(Point1=[-50, 0, 40], Point2=[50, 0, 40], Resolution=1)
    with_speed = simple.Calculator(Input=line, ResultArrayName="Speed", Function="20")
    path = make("LinearPathPlatform", Input=with_speed)
    times = fetch(path).GetPointData().GetArray("GpsTime").GetRange()
    check(math.isclose(times[1] - times[0], 5), "a flight of 100 m at 20 m/s takes 5 s")


def try_plan(scene):
    candidates = make("CandidateScanPositions", Input=scene, XStep=10, YStep=10)
    targets = make("VisibilityTestPoints", Input=scene, XStep=5, YStep=5, ZStep=5)
    seen = make("Viewsheds", Input=scene, Candidates=candidates, TestPoints=targets)
    plan = make("PlanScanPositions", Input=seen, TestPoints=targets)
    count = fetch(plan, 2).GetNumberOfPoints()
    check(0 < count < fetch(candidates).GetNumberOfPoints(), f"{count} scan positions planned")


def try_others(folder):
    """A file that is not there, other mirrors, help."""
    for name in ("GeoTIFFTerrain", "LASPoints"):
        reader = make(name, FileName=os.path.join(folder, "none"))
        text = reader.GetProperty("FileName").GetDocumentation().GetDescription()
        check("file" in text.lower(), f"{name} has help: {text.strip()}")
    for name in ("HeliosOscillatingMirror", "HeliosConicMirror"):
        mirror = servermanager.ProxyManager().NewProxy("lidar_strategies", name)
        check(mirror and mirror.GetProperty("PulseFrequency"), f"a proxy {name}")


def draw(survey, folder):
    view = simple.CreateRenderView(ViewSize=[1200, 700])
    shown = simple.Show(survey, view)
    shown.PointSize = 3
    simple.ColorBy(shown, ("POINTS", "GpsTime"))
    shown.RescaleTransferFunctionToDataRange(True)
    shown.SetScalarBarVisibility(view, True)
    view.Background, view.UseColorPaletteForBackground = [0.32, 0.34, 0.43], 0
    view.CameraPosition, view.CameraFocalPoint = [10, -14, 14], [-9, 13, 0]
    view.CameraViewUp = [0, 0, 1]
    simple.Render(view)
    count = servermanager.vtkProcessModule.GetProcessModule().GetNumberOfLocalPartitions()
    name = "survey.png" if count == 1 else f"survey-{count}.png"
    simple.SaveScreenshot(os.path.join(folder, name), view)
    print(f"ranks: {count}, picture: {name}", flush=True)


def main(plugin, folder):
    simple.LoadPlugin(plugin, remote=False, ns=globals())
    survey = try_survey(folder)
    try_errors()
    scene = try_scene(folder)
    try_scanner(scene)
    try_flight(scene)
    try_plan(scene)
    try_others(folder)
    draw(survey, folder)


if __name__ == "__main__":
    main(*sys.argv[1:3])
