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
from vtkmodules.vtkCommonCore import vtkFloatArray, vtkPoints, vtkUnsignedCharArray
from vtkmodules.vtkCommonDataModel import vtkImageData, vtkPolyData
from vtkmodules.vtkIOImage import vtkPNGWriter
from vtkmodules.vtkIOXML import vtkXMLPolyDataReader

from ._arrays import arrays

from vtkmodules import vtkRenderingCore as rendering
import vtkmodules.vtkRenderingFreeType  # noqa: F401  draws the text
import vtkmodules.vtkRenderingOpenGL2  # noqa: F401  draws at all

OVERSAMPLING = 2  # drawn that many times wider and higher, then averaged

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
HEIGHTS = np.array(
    [
        (0.36, 0.50, 0.78),
        (0.25, 0.68, 0.70),
        (0.42, 0.75, 0.44),
        (0.95, 0.85, 0.40),
        (0.93, 0.50, 0.25),
        (0.75, 0.22, 0.22),
    ]
)

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
        height = np.clip((points[:, 2] - low) / max(high - low, 1e-9), 0.0, 1.0) * (
            len(HEIGHTS) - 1
        )
        base = np.stack(
            [np.interp(height, range(len(HEIGHTS)), HEIGHTS[:, c]) for c in range(3)], axis=1
        )
    return np.clip(base * brightness(strengths)[:, None], 0.0, 1.0)


def brightness(strengths):
    """From 0.6 for the weakest echoes to 1.15 for the strongest, by rank: power falls with R^2."""
    if len(strengths) < 2:
        return np.ones(len(strengths))
    levels = np.quantile(strengths, np.linspace(0.0, 1.0, 65))
    rank = np.searchsorted(levels, strengths) + np.searchsorted(levels, strengths, side="right")
    return 0.6 + 0.55 * rank / 130.0


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


def add_legend(renderer, classes):
    """The classes that occur, with their colours, at the lower left."""
    known = [(CLASSES[n] if n in CLASSES else UNCLASSIFIED) for n in np.unique(classes)]
    for row, (colour, name) in enumerate(reversed(list(dict.fromkeys(known)))):
        renderer.AddActor2D(make_text(name, 0.02, 0.03 + 0.032 * row, 20 * OVERSAMPLING, colour))


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


def save_picture(
    clouds,
    output,
    marks=(),
    title="",
    size=(1600, 1000),
    azimuth=215.0,
    elevation=28.0,
    zoom=1.6,
    point_size=2.5,
):
    """Writes a PNG of point clouds [(points, strengths, classes) ...]; marks are positions to show.

    Drawn at twice the size and averaged. Raises RuntimeError where there is no display.
    """
    if not can_render():
        raise RuntimeError("no X display: run it under xvfb-run")
    points, _, classes = (np.concatenate(columns) for columns in zip(*clouds))
    origin = points.mean(axis=0)  # the graphics card counts in float
    rgb = np.concatenate([colours(*cloud) for cloud in clouds])

    scene = rendering.vtkRenderer()
    scene.AddActor(make_cloud_actor(points - origin, rgb, point_size * OVERSAMPLING))
    place_camera(scene, points - origin, azimuth, elevation, zoom)
    window = make_window(size)
    window.AddRenderer(scene)
    window.Render()
    distance = grab_distances(window, scene)
    picture = shade(grab_colours(window), distance)

    # Marks and texts come last: they have no shading.
    window.RemoveRenderer(scene)
    overlay = rendering.vtkRenderer()
    overlay.SetActiveCamera(scene.GetActiveCamera())
    for mark in marks:
        overlay.AddActor(
            make_cloud_actor(np.atleast_2d(mark) - origin, np.array([MARK]), 9 * OVERSAMPLING)
        )
    overlay.AddActor2D(make_text(title, 0.02, 0.95, 24 * OVERSAMPLING))
    if len(np.unique(classes)) > 1:
        add_legend(overlay, classes)
    window.AddRenderer(overlay)
    window.Render()
    drawn = grab_colours(window)
    write_png(np.where(drawn.any(axis=2, keepdims=True), drawn, picture), output)


def make_window(size):
    window = rendering.vtkRenderWindow()
    window.SetOffScreenRendering(1)
    window.SetMultiSamples(0)
    window.SetSize(size[0] * OVERSAMPLING, size[1] * OVERSAMPLING)
    return window


def grab_colours(window):
    """What a window shows, height x width x 3 in [0, 1], from the bottom row up."""
    width, height = window.GetSize()
    pixels = vtkUnsignedCharArray()
    window.GetPixelData(0, 0, width - 1, height - 1, 0, pixels, 0)
    return vtk_to_numpy(pixels).reshape(height, width, 3) / 255.0


def grab_distances(window, renderer):
    """How far what a window shows is from the camera, along its axis; infinite: nothing there."""
    width, height = window.GetSize()
    depths = vtkFloatArray()
    window.GetZbufferData(0, 0, width - 1, height - 1, depths)
    depth = vtk_to_numpy(depths).reshape(height, width).astype(float)
    near, far = renderer.GetActiveCamera().GetClippingRange()
    distance = near * far / (far - depth * (far - near))
    return np.where(depth < 1.0, distance, np.inf)


def shade(rgb, distance, strength=12.0):
    """Eye-dome lighting (Boucheny 2009): the more its neighbours are in front, the darker a pixel.

    Where nothing was drawn the background shows: a gradient.
    """
    empty = np.isinf(distance)
    log_distance = np.log(np.where(empty, 1e30, distance))
    shadow = np.zeros_like(distance)
    for radius in (1, 2, 4):
        step = radius * OVERSAMPLING
        for rows, columns in ((0, step), (0, -step), (step, 0), (-step, 0)):
            neighbour = np.roll(log_distance, (rows, columns), axis=(0, 1))
            shadow += np.clip(log_distance - neighbour, 0.0, 0.05) / radius
    light = np.exp(-strength * shadow)[..., None]
    height = np.linspace(0.0, 1.0, len(rgb))[:, None, None]
    background = np.array(BACKGROUND_BOTTOM) * (1 - height) + np.array(BACKGROUND_TOP) * height
    return np.where(empty[..., None], background, rgb * light)


def write_png(rgb, output):
    """Writes an oversampled picture, rows from the bottom up, averaged down to its size."""
    height, width = (n // OVERSAMPLING for n in rgb.shape[:2])
    rgb = rgb.reshape(height, OVERSAMPLING, width, OVERSAMPLING, 3).mean(axis=(1, 3))
    pixels = (rgb.reshape(-1, 3) * 255).round().astype(np.uint8)
    image = vtkImageData()
    image.SetDimensions(width, height, 1)
    image.GetPointData().SetScalars(numpy_to_vtk(pixels, deep=True))
    writer = vtkPNGWriter()
    writer.SetFileName(str(output))
    writer.SetInputData(image)
    writer.Write()


def find_marks(cloud):
    """Where the scanner stood for a cloud, from the trajectory beside it; none where it moved."""
    path = pathlib.Path(cloud)
    trajectory = path.with_name(path.name.replace("_points", "_trajectory")).with_suffix(".txt")
    if not trajectory.is_file():
        return []
    rows = np.loadtxt(trajectory, usecols=(0, 1, 2), ndmin=2)
    return [rows[0]] if len(rows) and np.ptp(rows, axis=0).max() < 1e-6 else []


def main(argv=None):
    parser = argparse.ArgumentParser(
        prog="python3 -m vtkhelios.picture",
        description=__doc__,
        formatter_class=argparse.RawDescriptionHelpFormatter,
    )
    parser.add_argument("clouds", metavar="CLOUD", nargs="+", help="point clouds, .xyz or .vtp")
    parser.add_argument("--output", metavar="PNG", default="picture.png")
    parser.add_argument("--title", default="")
    parser.add_argument(
        "--azimuth", type=float, default=215.0, help="compass direction to look from [deg]"
    )
    parser.add_argument("--elevation", type=float, default=28.0, help="height to look from [deg]")
    parser.add_argument("--zoom", type=float, default=1.6)
    parser.add_argument("--point-size", type=float, default=2.5, help="[pixels]")
    given = parser.parse_args(argv)
    clouds = [read_cloud(path) for path in given.clouds]
    marks = [mark for path in given.clouds for mark in find_marks(path)]
    try:
        save_picture(
            clouds,
            given.output,
            marks,
            given.title,
            azimuth=given.azimuth,
            elevation=given.elevation,
            zoom=given.zoom,
            point_size=given.point_size,
        )
    except RuntimeError as error:
        print(f"error: {error}", file=sys.stderr)
        return 1
    return 0


if __name__ == "__main__":
    sys.exit(main())
