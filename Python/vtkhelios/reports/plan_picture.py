# SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
# SPDX-License-Identifier: BSD-3-Clause
"""A picture of a plan: the scene by its number of scans, and by their best incidence angle.

Every pixel has the colour of the nearest test point, grey if no test point is near; the positions
are marked. A plan of a small part of a scene is shown alone. Without an X display a virtual one is
started, see vtkhelios.picture.
"""

import numpy as np
from vtkmodules.util.numpy_support import vtk_to_numpy
from vtkmodules.vtkCommonCore import vtkDoubleArray, vtkIdList, vtkIdTypeArray, vtkPoints
from vtkmodules.vtkCommonDataModel import vtkPolyData, vtkStaticPointLocator
from vtkmodules.vtkFiltersPoints import vtkPointInterpolator, vtkVoronoiKernel

from ..array_names import BEST_INCIDENCE_ANGLE, COVERABLE, NORMAL, NUMBER_OF_SCANS
from ..core.arrays import arrays, numpy_to_vtk
from ..core.classes import vtk_class
from ..core.pipeline import perform
from ..scenes.scene import Scene, has_instances
from . import picture
from .picture import BACKGROUND_BOTTOM, BAR, HEIGHTS, MARK, OVERSAMPLING, TEXT, rendering
from .plan_colours import NOT_COVERABLE, SCANS, UNSEEN

MAXIMUM_NUMBERS = 40  # positions with a number beside them
NEARBY = 2.0  # larger steps between test points: the reach of the plan
OUTSIDE = (0.24, 0.26, 0.29)
SMALL = 0.6  # largest share of the width and depth of the scene for a plan that is shown alone


def save_picture(
    scene,
    test_points,
    positions,
    output,
    title="",
    size=(1800, 820),
    azimuth=215.0,
    elevation=45.0,
):
    """Writes a PNG of a plan: the output of a vtkHeliosScanPositionPlanner, and its scene.

    Raises RuntimeError without a display.
    """
    if not picture.can_render():
        raise RuntimeError(picture.NO_DISPLAY)
    points = arrays(test_points)
    marks = arrays(positions)["points"]
    places = np.concatenate([points["points"], marks])
    view = View(scene, (size[0] // 2, size[1]), azimuth, elevation, places)
    nearest = view.find_nearest(points["points"], points.get(NORMAL))
    panels = [
        view.draw(colours, nearest, marks)
        for colours in (scan_colours(points), angle_colours(points))
    ]
    image = np.concatenate(panels, axis=1)
    image[: int(BAR * len(image))] = BACKGROUND_BOTTOM
    draw_ramp(image)
    picture.write_png(write_texts(image, title, len(marks)), output)


def scan_colours(points):
    """Returns the colour of every test point by its number of scans."""
    number = np.minimum(points[NUMBER_OF_SCANS].astype(int), len(SCANS) - 1)
    rgb = np.array([colour for colour, _ in SCANS])[number]
    rgb[points[COVERABLE] == 0] = NOT_COVERABLE
    return rgb


def angle_colours(points):
    """Returns the colour of every test point by its best incidence angle."""
    angle = points[BEST_INCIDENCE_ANGLE].astype(float)
    rgb = ramp(np.nan_to_num(angle) / 90.0)
    rgb[np.isnan(angle)] = UNSEEN
    rgb[points[COVERABLE] == 0] = NOT_COVERABLE
    return rgb


def ramp(share):
    """Colours from 0, normal incidence, to 1, grazing."""
    at = np.clip(share, 0.0, 1.0) * (len(HEIGHTS) - 1)
    return np.stack([np.interp(at, range(len(HEIGHTS)), HEIGHTS[:, c]) for c in range(3)], axis=-1)


class View:
    """A scene, or its part about some places, seen by a camera: the position of each pixel."""

    def __init__(self, scene, size, azimuth, elevation, places=None):
        is_traced = has_instances(scene)  # not drawn: there may be very many triangles
        box = Scene(scene).bounds if is_traced else np.reshape(scene.GetBounds(), (3, 2)).T
        low, high = box if places is None else find_box(box, places)
        self.origin = (low + high) / 2  # the graphics card computes in float
        renderer = rendering.vtkRenderer()
        if not is_traced:
            renderer.AddActor(make_actor(scene, self.origin))
        corners = np.array([low, high]) - self.origin
        picture.place_camera(renderer, corners, azimuth, elevation, zoom=1.0)
        fill_view(renderer.GetActiveCamera(), corners, size[0] / size[1])
        self.window = picture.make_window(size)
        self.window.AddRenderer(renderer)
        renderer.ResetCameraClippingRange()
        self.window.Render()
        self.camera = renderer.GetActiveCamera()
        if is_traced:
            self.distance = self.trace(scene)
        else:
            self.distance = picture.grab_distances(self.window, renderer)
        self.window.RemoveRenderer(renderer)

    def trace(self, scene):
        """Returns the distances that grab_distances() returns, by rays."""
        width, height = self.window.GetSize()
        caster = vtk_class("vtkHeliosRayCasterFactory").Create("")
        perform(caster, lambda: caster.Build(scene))
        eye = self.origin + self.camera.GetPosition()
        return np.array([cast(caster, eye, row) for row in self.make_rays(width, height)])

    def find_nearest(self, points, normals):
        """Returns the test point nearest to each pixel; -1 for the background, -2 if it is far.

        Both are moved slightly off the surface, so that a thin wall has two sides.
        """
        step = find_step(points)
        shift = np.zeros_like(points) if normals is None else 0.25 * step * normals
        drawn = np.isfinite(self.distance)
        places = self.unproject(0.25 * step)[drawn]
        nearest = np.full(self.distance.shape, -1)
        shifted = points - self.origin + shift
        found = interpolate(shifted, places)
        reach = NEARBY * find_step(points, 0.95)
        is_far = np.linalg.norm(shifted[found] - places, axis=1) > reach
        nearest[drawn] = np.where(is_far, -2, found)
        return nearest

    def unproject(self, towards):
        """Returns the position of each pixel, moved towards the camera."""
        height, width = self.distance.shape
        rays = self.make_rays(width, height)
        length = np.linalg.norm(rays, axis=2, keepdims=True)
        far = np.where(np.isfinite(self.distance), self.distance, 0.0)[..., None]
        return np.array(self.camera.GetPosition()) + rays * (far - towards / length)

    def make_rays(self, width, height):
        """Returns the directions of the pixels, of length 1 along the axis of the camera."""
        right, up, axis = camera_axes(self.camera)
        scale = 2.0 * np.tan(np.radians(self.camera.GetViewAngle()) / 2) / height
        x = (np.arange(width) + 0.5 - width / 2) * scale
        y = (np.arange(height) + 0.5 - height / 2) * scale
        return axis + y[:, None, None] * up + x[None, :, None] * right

    def draw(self, colours, nearest, marks):
        """Returns the scene in the colours of the test points, and the marks."""
        rgb = np.where(nearest[..., None] == -2, OUTSIDE, colours[nearest])
        rgb = np.where(nearest[..., None] == -1, 0.0, rgb)
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
        for scan, mark in enumerate(marks[:MAXIMUM_NUMBERS]):
            overlay.AddActor2D(self.make_number(overlay, str(scan), mark))
        self.window.Render()
        drawn = picture.grab_colours(self.window)
        self.window.RemoveRenderer(overlay)
        return np.where(drawn.any(axis=2, keepdims=True), drawn, image)

    def make_number(self, renderer, words, mark):
        """Returns a text beside a mark."""
        renderer.SetWorldPoint(*(mark - self.origin), 1.0)
        renderer.WorldToDisplay()
        width, height = self.window.GetSize()
        x, y, _ = renderer.GetDisplayPoint()
        text = picture.make_text(
            words, x / width + 0.012, y / height + 0.006, 17 * OVERSAMPLING, (1.0, 1.0, 1.0)
        )
        text.GetTextProperty().BoldOn()
        return text


def find_box(box, places):
    """Returns the box to show: that of the scene, or of places in a small part of it."""
    low, high = places.min(axis=0), places.max(axis=0)
    if ((high - low)[:2] > SMALL * (box[1] - box[0])[:2]).any():
        return box
    margin = 0.1 * np.linalg.norm(high - low)
    return np.maximum(low - margin, box[0]), np.minimum(high + margin, box[1])


def make_actor(scene, origin):
    """Returns the triangles of a mesh, relative to an origin."""
    mesh = vtkPolyData()
    mesh.ShallowCopy(scene)
    mesh.SetPoints(make_points(vtk_to_numpy(scene.GetPoints().GetData()) - origin))
    mapper = rendering.vtkPolyDataMapper()
    mapper.SetInputData(mesh)
    mapper.ScalarVisibilityOff()
    actor = rendering.vtkActor()
    actor.SetMapper(mapper)
    return actor


def cast(caster, eye, rays):
    """Returns the ranges of rays from a point, in units of their directions; infinite: no hit."""
    ranges, cells = vtkDoubleArray(), vtkIdTypeArray()
    origins = numpy_to_vtk(np.tile(eye, (len(rays), 1)))
    caster.Intersect(origins, numpy_to_vtk(np.ascontiguousarray(rays)), ranges, cells)
    return vtk_to_numpy(ranges).copy()


def camera_axes(camera):
    """Right, up, and view direction of a camera."""
    axis = np.array(camera.GetDirectionOfProjection())
    right = np.cross(axis, camera.GetViewUp())
    right /= np.linalg.norm(right)
    return right, np.cross(right, axis), axis


def fill_view(camera, corners, aspect):
    """Moves and zooms a camera so that a box fills the picture between title and legend."""
    box = np.array(np.meshgrid(*np.transpose(corners))).reshape(3, -1).T
    low, high = 2 * BAR - 1, 1 - 1.5 * BAR  # limits of the height, -1 to 1
    for _ in range(4):  # perspective: converges quickly
        axes = np.array(camera_axes(camera))
        seen = (box - camera.GetPosition()) @ axes.T
        scale = np.tan(np.radians(camera.GetViewAngle()) / 2)
        flat = seen[:, :2] / seen[:, 2:] / scale
        first, last = flat.min(axis=0), flat.max(axis=0)
        zoom = min(1.94 * aspect / (last[0] - first[0]), (high - low) / (last[1] - first[1]))
        off = ((first + last) / 2 - np.array([0.0, (low + high) / 2 / zoom])) * scale
        shift = (off * camera.GetDistance()) @ axes[:2]
        camera.SetPosition(*(np.array(camera.GetPosition()) + shift))
        camera.SetFocalPoint(*(np.array(camera.GetFocalPoint()) + shift))
        camera.Zoom(zoom)


def find_step(points, share=0.5):
    """Returns the distance of neighbouring test points: the median, or another quantile, of some."""
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
    return float(np.quantile(distances, share)) if distances else 1.0


def interpolate(points, places):
    """Returns the index of the nearest point to each position."""
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


RAMP = (0.64, 0.80)  # angle scale in the bar, as fractions of the width


def draw_ramp(image):
    """The colours of angles, in the bar below the picture."""
    first, last = (int(share * image.shape[1]) for share in RAMP)
    image[bar_rows(image), first:last] = ramp(np.linspace(0.0, 1.0, last - first))


def bar_rows(image):
    """Returns the rows of the colours in the bar."""
    return slice(int(0.32 * BAR * len(image)), int(0.68 * BAR * len(image)))


def write_texts(image, title, scans):
    """Returns the picture with its legend and title."""
    height, width, _ = image.shape
    window = picture.make_window((width // OVERSAMPLING, height // OVERSAMPLING))
    overlay = rendering.vtkRenderer()
    window.AddRenderer(overlay)

    def write(words, x, y=0.016, colour=None, size=18, right=False):
        if colour:  # a colour patch before the text
            first = int(x * width)
            image[bar_rows(image), first : first + 12 * OVERSAMPLING] = colour
            x += 17 * OVERSAMPLING / width
        overlay.AddActor2D(picture.make_text(words, x, y, size * OVERSAMPLING, TEXT, right))
        return x + (10.5 * len(words) + 16) * OVERSAMPLING / width

    write(f"{title}: {scans} scan{'s'[: scans != 1]}", 0.01, 0.955, size=20)
    x = write("number of scans:", 0.01)
    for colour, name in SCANS:
        x = write(name, x, colour=colour)
    write("not coverable", x, colour=NOT_COVERABLE)
    write("best incidence:", 0.51)
    write("0", RAMP[0] - 0.006, right=True)
    x = write("90 deg", RAMP[1] + 0.006)
    write("not seen", x + 0.005, colour=UNSEEN)
    window.Render()
    drawn = picture.grab_colours(window)
    return np.where(drawn.any(axis=2, keepdims=True), drawn, image)
