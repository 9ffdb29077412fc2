# SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
# SPDX-License-Identifier: BSD-3-Clause
"""A picture of point clouds: python -m vtkhelios.picture CLOUD... --output PICTURE.png

Points are coloured by their class (ground, vegetation, buildings ...) if the cloud has classes,
else by height, slightly brighter for strong echoes, and shaded by their shape. Without an X display
it starts a virtual one, Xvfb.
"""

import argparse
import pathlib
import sys

import numpy as np
import vtkmodules.vtkRenderingFreeType  # noqa: F401  draws the text
import vtkmodules.vtkRenderingOpenGL2  # noqa: F401  draws at all
from vtkmodules import vtkRenderingCore as rendering
from vtkmodules.util.numpy_support import vtk_to_numpy
from vtkmodules.vtkCommonCore import vtkFloatArray, vtkPoints, vtkUnsignedCharArray
from vtkmodules.vtkCommonDataModel import vtkImageData, vtkPolyData
from vtkmodules.vtkIOImage import vtkPNGWriter

from ..array_names import AMPLITUDE, CLASSIFICATION_IDS
from ..core.arrays import arrays, numpy_to_vtk
from ..core.display import has_display, start_display
from ..core.files import cannot_be_written, write_whole
from ..core.run_files import TRAJECTORY, beside
from ..core.streams import visible
from ..formats import FormatError, open_reader
from ..formats._base import rows_of

OVERSAMPLING = 2  # supersampling factor in width and height, then averaged

SCREEN = ("-screen", "0", "1280x1024x24")  # screen of a virtual display
BACKGROUND_TOP, BACKGROUND_BOTTOM = (0.16, 0.20, 0.26), (0.05, 0.06, 0.08)
TEXT = (0.86, 0.88, 0.90)
MARK = (1.0, 0.80, 0.20)
BAR = 0.05  # share of the height: title and legend, below the picture
SUN = (-0.55, 0.60, 0.58)  # direction of the light: right, up, towards the viewer

# ASPRS classes: a colour and a name.
CLASSES = {
    2: ((0.66, 0.56, 0.43), "ground"),
    3: ((0.62, 0.76, 0.36), "low vegetation"),
    4: ((0.48, 0.70, 0.32), "medium vegetation"),
    5: ((0.33, 0.66, 0.34), "high vegetation"),
    6: ((0.82, 0.42, 0.33), "building"),
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


NO_DISPLAY = "no X display, and no Xvfb for a virtual one: apt-get install xvfb"


def can_render():
    """Returns whether there is an X display, or a virtual one can be started. VTK exits if it finds
    none."""
    return has_display() or (start_display(SCREEN) and has_display())


def read_cloud(path):
    """Returns the points (n x 3), echo strengths and classes of a point cloud file; without these,
    zeros."""
    with open_reader(path) as reader:
        chunks = list(reader.chunks())

    def joined(name, kind):
        return np.concatenate([chunk.get(name, np.zeros(rows_of(chunk), kind)) for chunk in chunks])

    points = np.concatenate([chunk["points"] for chunk in chunks])
    return points, joined(AMPLITUDE, float), joined(CLASSIFICATION_IDS, int)


def colours(points, strengths, classes):
    """Returns the colour of every point, n x 3 in [0, 1]."""
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
    """From 0.85 for the weakest echoes to 1.1 for the strongest, by rank: power falls with R^2."""
    if len(strengths) < 2:
        return np.ones(len(strengths))
    levels = np.quantile(strengths, np.linspace(0.0, 1.0, 65))
    rank = np.searchsorted(levels, strengths) + np.searchsorted(levels, strengths, side="right")
    return 0.85 + 0.25 * rank / 130.0


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


def add_legend(renderer, classes, marks):
    """The classes present, with their colours, at the right of the bar below the picture."""
    entries = [(MARK, "scanner")] if len(marks) else []
    if len(np.unique(classes)) > 1:
        entries += [CLASSES.get(number, UNCLASSIFIED) for number in reversed(np.unique(classes))]
    x = 0.98
    for colour, name in dict.fromkeys(entries):
        renderer.AddActor2D(make_text(name, x, 0.016, 18 * OVERSAMPLING, colour, right=True))
        x -= 0.02 + 0.0062 * len(name)


def place_camera(renderer, points, azimuth, elevation, zoom):
    """Looks from a compass direction [deg] and height [deg] at the bulk of the points."""
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

    Drawn at twice the size and averaged. Raises RuntimeError without a display.
    """
    check_display()
    points, _, classes = (np.concatenate(columns) for columns in zip(*clouds))
    origin = points.mean(axis=0)  # the graphics card computes in float
    rgb = np.concatenate([colours(*cloud) for cloud in clouds])
    actor = make_cloud_actor(points - origin, rgb, point_size * OVERSAMPLING)
    marks = np.reshape(marks, (-1, 3)) - origin
    look = (azimuth, elevation, zoom)
    draw_picture(actor, points - origin, classes, marks, output, title, size, look)


def save_mesh_picture(
    mesh, output, marks=(), title="", size=(1600, 1000), azimuth=215.0, elevation=28.0, zoom=1.6
):
    """Writes a PNG of triangles with colours (cell scalars of three bytes), lit like clouds.

    Raises RuntimeError without a display.
    """
    check_display()
    points = arrays(mesh)["points"]
    origin = points.mean(axis=0)
    holder = vtkPoints()
    holder.SetData(numpy_to_vtk(points - origin, deep=True))
    moved = vtkPolyData()
    moved.ShallowCopy(mesh)
    moved.SetPoints(holder)
    mapper = rendering.vtkPolyDataMapper()
    mapper.SetInputData(moved)
    mapper.SetScalarModeToUseCellData()
    actor = rendering.vtkActor()
    actor.SetMapper(mapper)
    actor.GetProperty().LightingOff()
    marks = np.reshape(marks, (-1, 3)) - origin
    look = (azimuth, elevation, zoom)
    draw_picture(actor, points - origin, np.zeros(1), marks, output, title, size, look)


def check_display():
    if not can_render():
        raise RuntimeError(NO_DISPLAY)


def draw_picture(actor, points, classes, marks, output, title, size, look):
    """Common part of both pictures: the camera is fitted to the points."""
    scene = rendering.vtkRenderer()
    scene.AddActor(actor)
    place_camera(scene, points, *look)
    window = make_window(size)
    window.AddRenderer(scene)
    window.Render()
    view_angle = scene.GetActiveCamera().GetViewAngle()
    picture = shade(grab_colours(window), grab_distances(window, scene), view_angle)

    # Marks and texts come last: they have no shading.
    window.RemoveRenderer(scene)
    overlay = rendering.vtkRenderer()
    overlay.SetActiveCamera(scene.GetActiveCamera())
    for mark in marks:
        overlay.AddActor(make_cloud_actor(np.atleast_2d(mark), np.array([MARK]), 9 * OVERSAMPLING))
    picture[: int(BAR * len(picture))] = BACKGROUND_BOTTOM
    overlay.AddActor2D(make_text(title, 0.02, 0.015, 19 * OVERSAMPLING))
    add_legend(overlay, classes, marks)
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
    """Returns the image of a window, height x width x 3 in [0, 1], from the bottom row up."""
    width, height = window.GetSize()
    pixels = vtkUnsignedCharArray()
    window.GetPixelData(0, 0, width - 1, height - 1, 0, pixels, 0)
    return vtk_to_numpy(pixels).reshape(height, width, 3) / 255.0


def grab_distances(window, renderer):
    """Distance of each window pixel from the camera, along its axis; infinite: background."""
    width, height = window.GetSize()
    depths = vtkFloatArray()
    window.GetZbufferData(0, 0, width - 1, height - 1, depths)
    depth = vtk_to_numpy(depths).reshape(height, width).astype(float)
    near, far = renderer.GetActiveCamera().GetClippingRange()
    distance = near * far / (far - depth * (far - near))
    return np.where(depth < 1.0, distance, np.inf)


def shade(rgb, distance, view_angle):
    """Shades the image by the shape in its distances; elsewhere the background shows."""
    drawn = np.isfinite(distance)
    light = np.clip(0.72 + 0.42 * sunlight(distance, view_angle), 0.5, 1.2) * dome_light(distance)
    height = np.linspace(0.0, 1.0, len(rgb))[:, None, None]
    background = np.array(BACKGROUND_BOTTOM) * (1 - height) + np.array(BACKGROUND_TOP) * height
    return np.where(drawn[..., None], np.clip(rgb * light[..., None], 0.0, 1.0), background)


def dome_light(distance, strength=12.0):
    """Eye-dome lighting (Boucheny 2009): pixels are darker the more their neighbours are in front."""
    log_distance = np.log(np.where(np.isfinite(distance), distance, 1e30))
    shadow = np.zeros_like(distance)
    for radius in (1, 2, 4):
        step = radius * OVERSAMPLING
        around = np.pad(log_distance, step, mode="edge")
        for y, x in ((0, 1), (0, -1), (1, 0), (-1, 0)):
            neighbour = np.roll(around, (y * step, x * step), axis=(0, 1))[step:-step, step:-step]
            shadow += np.clip(log_distance - neighbour, 0.0, 0.05) / radius
    return np.exp(-strength * shadow)


def sunlight(distance, view_angle, radius=3 * OVERSAMPLING):
    """Returns the cosine between the light and the normals of the surface of the points.

    A surface whose distance d changes by g = d log(d) a radian has the normal (g, 1) before the
    camera.
    """
    drawn = np.isfinite(distance)
    weight = average(drawn.astype(float), radius)
    smooth = average(np.log(np.where(drawn, distance, 1.0)), radius) / np.maximum(weight, 1e-9)
    up, right = (g / (np.radians(view_angle) / len(distance)) for g in np.gradient(smooth))
    return (right * SUN[0] + up * SUN[1] + SUN[2]) / np.sqrt(right**2 + up**2 + 1.0)


def average(image, radius):
    """Returns the mean over a square of side 2 radius + 1, by running sums."""
    width = 2 * radius + 1
    for _ in range(2):  # along the rows, then, transposed, along the columns
        sums = np.cumsum(np.pad(image, ((radius + 1, radius), (0, 0)), mode="edge"), axis=0)
        image = ((sums[width:] - sums[:-width]) / width).T
    return image


def write_png(rgb, output):
    """Writes a supersampled picture, rows from the bottom up, averaged down to its size."""
    height, width = (n // OVERSAMPLING for n in rgb.shape[:2])
    rgb = rgb.reshape(height, OVERSAMPLING, width, OVERSAMPLING, 3).mean(axis=(1, 3))
    pixels = (rgb.reshape(-1, 3) * 255).round().astype(np.uint8)
    image = vtkImageData()
    image.SetDimensions(width, height, 1)
    image.GetPointData().SetScalars(numpy_to_vtk(pixels, deep=True))
    writer = vtkPNGWriter()
    writer.WriteToMemoryOn()
    writer.SetInputData(image)
    writer.Write()
    write_whole(output, vtk_to_numpy(writer.GetResult()).tobytes())


def find_marks(cloud):
    """Scan positions of a cloud, from the trajectory beside it; empty if it moved."""
    paths = beside(pathlib.Path(cloud), TRAJECTORY)
    trajectory = next((path for path in paths if path.suffix == ".txt" and path.is_file()), None)
    if trajectory is None:
        return []
    rows = np.loadtxt(trajectory, usecols=(0, 1, 2), ndmin=2)
    return [rows[0]] if len(rows) and np.ptp(rows, axis=0).max() < 1e-6 else []


def main(argv=None):
    parser = argparse.ArgumentParser(
        prog="python3 -m vtkhelios.picture",
        description=__doc__,
        formatter_class=argparse.RawDescriptionHelpFormatter,
    )
    parser.add_argument("clouds", metavar="CLOUD", nargs="+", help="point clouds, such as .xyz")
    parser.add_argument("--output", metavar="PNG", default="picture.png")
    parser.add_argument("--title", default="")
    parser.add_argument(
        "--azimuth",
        type=float,
        default=215.0,
        help="azimuth of the camera, clockwise from north [deg]",
    )
    parser.add_argument(
        "--elevation", type=float, default=28.0, help="elevation of the camera [deg]"
    )
    parser.add_argument("--zoom", type=float, default=1.6)
    parser.add_argument("--point-size", type=float, default=2.5, help="[pixels]")
    given = parser.parse_args(argv)
    try:
        clouds = [read_cloud(path) for path in given.clouds]
        marks = [mark for path in given.clouds for mark in find_marks(path)]
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
    except (RuntimeError, FormatError) as error:
        print(visible(f"error: {error}"), file=sys.stderr)
        return 1
    except OSError as error:
        problem = cannot_be_written(error, given.output, "--output")
        print(visible(f"error: {problem}"), file=sys.stderr)
        return 1
    return 0
