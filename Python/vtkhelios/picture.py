# SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
# SPDX-License-Identifier: BSD-3-Clause
"""A picture of point clouds: python -m vtkhelios.picture CLOUD... --output PICTURE.png

Points are coloured by their class (ground, vegetation, buildings ...) where the cloud has classes,
else by height, brightened by how strong their echo is, and shaded by eye-dome lighting. It needs an
X display; without one:

xvfb-run -a -s "-screen 0 1280x1024x24" python3 -m vtkhelios.picture CLOUD... --output PICTURE.png
"""

import argparse
import ctypes
import pathlib
import sys

import numpy as np
from vtkmodules.util.numpy_support import numpy_to_vtk, vtk_to_numpy
from vtkmodules.vtkCommonCore import vtkPoints
from vtkmodules.vtkCommonDataModel import vtkImageData, vtkPolyData
from vtkmodules.vtkIOImage import vtkPNGWriter
from vtkmodules.vtkIOXML import vtkXMLPolyDataReader

from ._arrays import arrays

from vtkmodules import vtkRenderingCore as rendering
from vtkmodules import vtkRenderingOpenGL2 as opengl
import vtkmodules.vtkRenderingFreeType  # noqa: F401  draws the text

BACKGROUND_TOP, BACKGROUND_BOTTOM = (0.16, 0.20, 0.26), (0.05, 0.06, 0.08)
TEXT = (0.86, 0.88, 0.90)
MARK = (1.0, 0.80, 0.20)

# ASPRS classes: a colour and a name.
CLASSES = {
    2: ((0.66, 0.56, 0.43), "ground"),
    3: ((0.62, 0.76, 0.36), "low vegetation"),
    4: ((0.48, 0.70, 0.32), "medium vegetation"),
    5: ((0.33, 0.66, 0.34), "high vegetation"),
    6: ((0.86, 0.42, 0.32), "building"),
    9: ((0.30, 0.55, 0.85), "water"),
    11: ((0.55, 0.56, 0.60), "road"),
}
UNCLASSIFIED = ((0.78, 0.78, 0.80), "other")

# Height, low to high.
HEIGHTS = np.array([(0.19, 0.30, 0.60), (0.13, 0.57, 0.62), (0.42, 0.75, 0.44),
                    (0.95, 0.85, 0.40), (0.93, 0.50, 0.25), (0.75, 0.22, 0.22)])

# Columns of legNNN_points.xyz.
XYZ_COLUMNS = {"x": 0, "y": 1, "z": 2, "intensity": 3, "classification": 9}


def can_render():
    """Whether there is an X display. VTK ends the process where it looks for one in vain."""
    try:
        x11 = ctypes.CDLL("libX11.so.6")
    except OSError:
        return False
    x11.XOpenDisplay.restype = ctypes.c_void_p
    display = x11.XOpenDisplay(None)
    if display:
        x11.XCloseDisplay(ctypes.c_void_p(display))
    return bool(display)


def read_cloud(path):
    """Points (n x 3), echo strengths and classes of a point cloud file (.xyz or .vtp)."""
    path = pathlib.Path(path)
    if path.suffix == ".vtp":
        reader = vtkXMLPolyDataReader()
        reader.SetFileName(str(path))
        reader.Update()
        views = arrays(reader.GetOutput())
        return views["points"], views["Amplitude"], views["ClassificationIds"]
    columns = np.loadtxt(path, usecols=list(XYZ_COLUMNS.values()), ndmin=2, dtype=np.float64)
    return columns[:, :3], columns[:, 3], columns[:, 4].astype(int)


def colours(points, strengths, classes):
    """The colour of every point, n x 3 in [0, 1]."""
    if len(np.unique(classes)) > 1:
        base = np.tile(UNCLASSIFIED[0], (len(points), 1))
        for number, (colour, _) in CLASSES.items():
            base[classes == number] = colour
    else:
        low, high = np.quantile(points[:, 2], [0.02, 0.98])
        height = np.clip((points[:, 2] - low) / max(high - low, 1e-9), 0.0, 1.0) * (len(HEIGHTS) - 1)
        base = np.stack([np.interp(height, range(len(HEIGHTS)), HEIGHTS[:, c]) for c in range(3)], axis=1)
    return np.clip(base * brightness(strengths)[:, None], 0.0, 1.0)


def brightness(strengths):
    """From 0.6 for the weakest echoes to 1.15 for the strongest: their rank, since power falls with R^2."""
    if len(strengths) < 2:
        return np.ones(len(strengths))
    levels = np.quantile(strengths, np.linspace(0.0, 1.0, 65))
    return 0.6 + 0.55 * np.searchsorted(levels, strengths) / 65.0


def make_cloud_actor(points, rgb, size):
    data = vtkPolyData()
    vtk_points = vtkPoints()
    vtk_points.SetData(numpy_to_vtk(np.ascontiguousarray(points), deep=True))
    data.SetPoints(vtk_points)
    data.GetPointData().SetScalars(numpy_to_vtk((rgb * 255).astype(np.uint8), deep=True))
    mapper = rendering.vtkPointGaussianMapper()
    mapper.SetInputData(data)
    mapper.SetScaleFactor(0.0)  # squares of a constant size
    mapper.EmissiveOff()
    actor = rendering.vtkActor()
    actor.SetMapper(mapper)
    actor.GetProperty().SetPointSize(size)
    actor.GetProperty().LightingOff()
    return actor


def make_text(words, x, y, size, colour=TEXT, right=False):
    text = rendering.vtkTextActor()
    text.SetInput(words)
    text.GetPositionCoordinate().SetCoordinateSystemToNormalizedViewport()
    text.SetPosition(x, y)
    style = text.GetTextProperty()
    style.SetFontSize(int(size))
    style.SetColor(*colour)
    if right:
        style.SetJustificationToRight()
    return text


def add_legend(renderer, classes, scale):
    """The classes that occur, with their colours, at the lower left."""
    known = [(CLASSES[n] if n in CLASSES else UNCLASSIFIED) for n in np.unique(classes)]
    for row, (colour, name) in enumerate(reversed(list(dict.fromkeys(known)))):
        renderer.AddActor2D(make_text(name, 0.02, 0.03 + 0.032 * row, 20 * scale, colour))


def place_camera(renderer, points, azimuth, elevation, zoom):
    """Looks from a compass direction [deg] and height [deg] at where most points are."""
    low, high = np.quantile(points, [0.01, 0.99], axis=0)
    centre, a, e = (low + high) / 2, np.radians(azimuth), np.radians(elevation)
    camera = renderer.GetActiveCamera()
    camera.SetFocalPoint(*centre)
    camera.SetPosition(*(centre + [np.sin(a) * np.cos(e), np.cos(a) * np.cos(e), np.sin(e)]))
    camera.SetViewUp(0.0, 0.0, 1.0)
    renderer.ResetCamera(low[0], high[0], low[1], high[1], low[2], high[2])
    camera.Zoom(zoom)


def save_picture(clouds, output, marks=(), title="", size=(1600, 1000), azimuth=215.0,
                 elevation=28.0, zoom=1.6, point_size=2.5):
    """Writes a PNG of point clouds [(points, strengths, classes) ...]; marks are positions to point out.

    Drawn at twice the size and averaged. Raises RuntimeError where there is no display.
    """
    if not can_render():
        raise RuntimeError("no X display: run it under xvfb-run")
    points, strengths, classes = (np.concatenate(columns) for columns in zip(*clouds))
    origin = points.mean(axis=0)  # the graphics card counts in float
    rgb = np.concatenate([colours(*cloud) for cloud in clouds])

    scale = 2
    renderer = rendering.vtkRenderer()
    renderer.GradientBackgroundOn()
    renderer.SetBackground(*BACKGROUND_BOTTOM)
    renderer.SetBackground2(*BACKGROUND_TOP)
    renderer.AddActor(make_cloud_actor(points - origin, rgb, point_size * scale))
    place_camera(renderer, points - origin, azimuth, elevation, zoom)
    shading = opengl.vtkEDLShading()
    shading.SetDelegatePass(opengl.vtkRenderStepsPass())
    renderer.SetPass(shading)

    # Marks and texts are drawn over it, without the shading.
    overlay = rendering.vtkRenderer()
    overlay.SetLayer(1)
    overlay.SetActiveCamera(renderer.GetActiveCamera())
    for mark in marks:
        overlay.AddActor(make_cloud_actor(np.atleast_2d(mark) - origin, np.array([MARK]), 9 * scale))
    overlay.AddActor2D(make_text(title, 0.02, 0.95, 24 * scale))
    if len(np.unique(classes)) > 1:
        add_legend(overlay, classes, scale)

    window = rendering.vtkRenderWindow()
    window.SetOffScreenRendering(1)
    window.SetMultiSamples(0)
    window.SetNumberOfLayers(2)
    window.SetSize(size[0] * scale, size[1] * scale)
    window.AddRenderer(renderer)
    window.AddRenderer(overlay)
    window.Render()
    write_averaged(window, scale, output)


def write_averaged(window, scale, output):
    """Writes what a window shows as PNG, scale x scale pixels averaged to one."""
    grab = rendering.vtkWindowToImageFilter()
    grab.SetInput(window)
    grab.ReadFrontBufferOff()
    grab.Update()
    width, height, _ = grab.GetOutput().GetDimensions()
    pixels = vtk_to_numpy(grab.GetOutput().GetPointData().GetScalars())
    pixels = pixels.reshape(height // scale, scale, width // scale, scale, 3).mean(axis=(1, 3))
    image = vtkImageData()
    image.SetDimensions(width // scale, height // scale, 1)
    image.GetPointData().SetScalars(numpy_to_vtk(pixels.reshape(-1, 3).round().astype(np.uint8), deep=True))
    writer = vtkPNGWriter()
    writer.SetFileName(str(output))
    writer.SetInputData(image)
    writer.Write()


def find_marks(cloud):
    """Where the scanner stood for a cloud: the first line of the trajectory beside it, if it does not move."""
    path = pathlib.Path(cloud)
    trajectory = path.with_name(path.name.replace("_points", "_trajectory")).with_suffix(".txt")
    if not trajectory.is_file():
        return []
    rows = np.loadtxt(trajectory, usecols=(0, 1, 2), ndmin=2)
    return [rows[0]] if len(rows) and np.ptp(rows, axis=0).max() < 1e-6 else []


def main(argv=None):
    parser = argparse.ArgumentParser(prog="python3 -m vtkhelios.picture", description=__doc__,
                                     formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("clouds", metavar="CLOUD", nargs="+", help="point clouds, .xyz or .vtp")
    parser.add_argument("--output", metavar="PNG", default="picture.png")
    parser.add_argument("--title", default="")
    parser.add_argument("--azimuth", type=float, default=215.0, help="compass direction to look from [deg]")
    parser.add_argument("--elevation", type=float, default=28.0, help="height to look from [deg]")
    parser.add_argument("--zoom", type=float, default=1.6)
    parser.add_argument("--point-size", type=float, default=2.5, help="[pixels]")
    given = parser.parse_args(argv)
    clouds = [read_cloud(path) for path in given.clouds]
    marks = [mark for path in given.clouds for mark in find_marks(path)]
    try:
        save_picture(clouds, given.output, marks, given.title, azimuth=given.azimuth,
                     elevation=given.elevation, zoom=given.zoom, point_size=given.point_size)
    except RuntimeError as error:
        print(f"error: {error}", file=sys.stderr)
        return 1
    return 0


if __name__ == "__main__":
    sys.exit(main())
