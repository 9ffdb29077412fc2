# SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
# SPDX-License-Identifier: BSD-3-Clause
"""A picture of a plan: the scene by the number of scans that see it, and by their best incidence.

Every place has the colour of the test point nearest to it; the positions are marked. It needs an X
display, as vtkhelios.picture does.
"""

import numpy as np
from vtkmodules.util.numpy_support import numpy_to_vtk, vtk_to_numpy
from vtkmodules.vtkCommonCore import vtkIdList, vtkPoints
from vtkmodules.vtkCommonDataModel import vtkPolyData, vtkStaticPointLocator
from vtkmodules.vtkFiltersPoints import vtkPointInterpolator, vtkVoronoiKernel

from ._arrays import arrays
from . import picture
from .picture import BACKGROUND_BOTTOM, BAR, HEIGHTS, MARK, OVERSAMPLING, TEXT, rendering

UNSEEN = (0.60, 0.12, 0.16)
NOT_COVERABLE = (0.42, 0.43, 0.46)
SCANS = [  # by the number of scans: a colour and a name
    (UNSEEN, "none"),
    ((0.95, 0.80, 0.45), "1"),
    ((0.60, 0.78, 0.42), "2"),
    ((0.28, 0.66, 0.62), "3"),
    ((0.30, 0.48, 0.80), "4"),
    ((0.50, 0.34, 0.72), "5 and more"),
]
MOST_NUMBERS = 40  # positions that have theirs beside them


def save_picture(
    scene,
    test_points,
    positions,
    output,
    title="",
    size=(1800, 1000),
    azimuth=215.0,
    elevation=40.0,
    zoom=1.3,
):
    """Writes a PNG of a plan: what a vtkHeliosScanPositionPlanner gives, and the scene it is of.

    Raises RuntimeError where there is no display.
    """
    if not picture.can_render():
        raise RuntimeError("no X display: run it under xvfb-run -a")
    points = arrays(test_points)
    marks = arrays(positions)["points"]
    view = View(scene, (size[0] // 2, size[1]), azimuth, elevation, zoom)
    nearest = view.find_nearest(points["points"], points.get("Normal"))
    panels = [
        view.draw(colours, nearest, marks)
        for colours in (scan_colours(points), angle_colours(points))
    ]
    image = np.concatenate(panels, axis=1)
    image[: int(BAR * len(image))] = BACKGROUND_BOTTOM
    draw_ramp(image)
    picture.write_png(write_texts(image, title, len(marks)), output)


def scan_colours(points):
    """The colour of every test point by the number of scans that see it."""
    number = np.minimum(points["NumberOfScans"].astype(int), len(SCANS) - 1)
    rgb = np.array([colour for colour, _ in SCANS])[number]
    rgb[points["Coverable"] == 0] = NOT_COVERABLE
    return rgb


def angle_colours(points):
    """The colour of every test point by its best incidence angle."""
    angle = points["BestIncidenceAngle"].astype(float)
    rgb = ramp(np.nan_to_num(angle) / 90.0)
    rgb[np.isnan(angle)] = UNSEEN
    rgb[points["Coverable"] == 0] = NOT_COVERABLE
    return rgb


def ramp(share):
    """Colours from 0, straight onto the surface, to 1, along it."""
    at = np.clip(share, 0.0, 1.0) * (len(HEIGHTS) - 1)
    return np.stack([np.interp(at, range(len(HEIGHTS)), HEIGHTS[:, c]) for c in range(3)], axis=-1)


class View:
    """A scene as a camera sees it: where in space each pixel is."""

    def __init__(self, scene, size, azimuth, elevation, zoom):
        low, high = np.reshape(scene.GetBounds(), (3, 2)).T
        self.origin = (low + high) / 2  # the graphics card counts in float
        mesh = vtkPolyData()
        mesh.ShallowCopy(scene)
        mesh.SetPoints(make_points(vtk_to_numpy(scene.GetPoints().GetData()) - self.origin))
        mapper = rendering.vtkPolyDataMapper()
        mapper.SetInputData(mesh)
        mapper.ScalarVisibilityOff()
        actor = rendering.vtkActor()
        actor.SetMapper(mapper)
        renderer = rendering.vtkRenderer()
        renderer.AddActor(actor)
        corners = np.array([low, high]) - self.origin
        picture.place_camera(renderer, corners, azimuth, elevation, zoom)
        self.window = picture.make_window(size)
        self.window.AddRenderer(renderer)
        renderer.ResetCameraClippingRange()
        self.window.Render()
        self.camera = renderer.GetActiveCamera()
        self.distance = picture.grab_distances(self.window, renderer)
        self.window.RemoveRenderer(renderer)

    def find_nearest(self, points, normals):
        """The test point nearest to what each pixel shows; -1 where it shows nothing.

        Both are moved a little off the surface, so that a thin wall has two sides.
        """
        step = find_step(points)
        shift = np.zeros_like(points) if normals is None else 0.25 * step * normals
        drawn = np.isfinite(self.distance)
        places = self.unproject(0.25 * step)[drawn]
        nearest = np.full(self.distance.shape, -1)
        nearest[drawn] = interpolate(points - self.origin + shift, places)
        return nearest

    def unproject(self, towards):
        """Where each pixel is, moved towards the camera."""
        height, width = self.distance.shape
        axis = np.array(self.camera.GetDirectionOfProjection())
        up = np.array(self.camera.GetViewUp())
        right = np.cross(axis, up)
        right /= np.linalg.norm(right)
        up = np.cross(right, axis)
        scale = 2.0 * np.tan(np.radians(self.camera.GetViewAngle()) / 2) / height
        x = (np.arange(width) + 0.5 - width / 2) * scale
        y = (np.arange(height) + 0.5 - height / 2) * scale
        rays = axis + y[:, None, None] * up + x[None, :, None] * right
        length = np.linalg.norm(rays, axis=2, keepdims=True)
        far = np.where(np.isfinite(self.distance), self.distance, 0.0)[..., None]
        return np.array(self.camera.GetPosition()) + rays * (far - towards / length)

    def draw(self, colours, nearest, marks):
        """The scene in the colours of the test points, and the marks."""
        rgb = np.where(nearest[..., None] >= 0, colours[nearest], 0.0)
        image = picture.shade(rgb, self.distance, self.camera.GetViewAngle())
        overlay = rendering.vtkRenderer()
        overlay.SetActiveCamera(self.camera)
        for pixels, colour in ((13, (0.05, 0.05, 0.06)), (9, MARK)):
            for mark in marks:
                overlay.AddActor(
                    picture.make_cloud_actor(
                        np.atleast_2d(mark) - self.origin, np.array([colour]), pixels * OVERSAMPLING
                    )
                )
        self.window.AddRenderer(overlay)
        overlay.ResetCameraClippingRange()
        for scan, mark in enumerate(marks[:MOST_NUMBERS]):
            overlay.AddActor2D(self.make_number(overlay, str(scan), mark))
        self.window.Render()
        drawn = picture.grab_colours(self.window)
        self.window.RemoveRenderer(overlay)
        return np.where(drawn.any(axis=2, keepdims=True), drawn, image)

    def make_number(self, renderer, words, mark):
        """A text beside a mark."""
        renderer.SetWorldPoint(*(mark - self.origin), 1.0)
        renderer.WorldToDisplay()
        width, height = self.window.GetSize()
        x, y, _ = renderer.GetDisplayPoint()
        return picture.make_text(
            words, x / width + 0.009, y / height + 0.006, 15 * OVERSAMPLING, (1.0, 1.0, 1.0)
        )


def find_step(points):
    """The distance of neighbouring test points: the median of some."""
    data = vtkPolyData()
    data.SetPoints(make_points(points))
    locator = vtkStaticPointLocator()
    locator.SetDataSet(data)
    locator.BuildLocator()
    distances = []
    for place in points[:: max(1, len(points) // 200)].tolist():
        found = vtkIdList()
        locator.FindClosestNPoints(2, place, found)
        if found.GetNumberOfIds() == 2:
            other = max(found.GetId(0), found.GetId(1), key=lambda i: abs(points[i] - place).max())
            distances.append(np.linalg.norm(points[other] - place))
    return float(np.median(distances)) if distances else 1.0


def interpolate(points, places):
    """The index of the point nearest to each place."""
    source = vtkPolyData()
    source.SetPoints(make_points(points))
    index = numpy_to_vtk(np.arange(len(points), dtype=np.float64), deep=True)
    index.SetName("index")
    source.GetPointData().AddArray(index)
    target = vtkPolyData()
    target.SetPoints(make_points(places))
    interpolator = vtkPointInterpolator()
    interpolator.SetInputData(target)
    interpolator.SetSourceData(source)
    interpolator.SetKernel(vtkVoronoiKernel())
    interpolator.PassPointArraysOff()
    interpolator.Update()
    found = interpolator.GetOutput().GetPointData().GetArray("index")
    return vtk_to_numpy(found).round().astype(int)


def make_points(coordinates):
    points = vtkPoints()
    points.SetData(numpy_to_vtk(np.ascontiguousarray(coordinates, dtype=np.float64), deep=True))
    return points


RAMP = (0.66, 0.84)  # where the scale of angles is in the bar, as shares of the width


def draw_ramp(image):
    """The colours of angles, in the bar below the picture."""
    height, width, _ = image.shape
    first, last = (int(share * width) for share in RAMP)
    rows = slice(int(0.35 * BAR * height), int(0.68 * BAR * height))
    image[rows, first:last] = ramp(np.linspace(0.0, 1.0, last - first))


def write_texts(image, title, scans):
    """The picture with what its colours mean, and its title."""
    height, width, _ = image.shape
    window = picture.make_window((width // OVERSAMPLING, height // OVERSAMPLING))
    overlay = rendering.vtkRenderer()
    window.AddRenderer(overlay)

    def write(words, x, y=0.016, colour=TEXT, size=18, right=False):
        overlay.AddActor2D(picture.make_text(words, x, y, size * OVERSAMPLING, colour, right))
        return x + (0.0062 * len(words) + 0.012) * (1600 * OVERSAMPLING / width)

    write(f"{title}: {scans} scan{'s'[: scans != 1]}", 0.01, 0.96, size=20)
    x = write("seen by scans:", 0.01)
    for colour, name in SCANS:
        x = write(name, x, colour=colour)
    write("not coverable", x, colour=NOT_COVERABLE)
    write("best incidence:", 0.51)
    write("0", RAMP[0] - 0.006, right=True)
    x = write("90 deg", RAMP[1] + 0.006)
    write("not seen", x, colour=UNSEEN)
    window.Render()
    drawn = picture.grab_colours(window)
    return np.where(drawn.any(axis=2, keepdims=True), drawn, image)
