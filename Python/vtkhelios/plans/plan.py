# SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
# SPDX-License-Identifier: BSD-3-Clause
"""Plans of scan positions: of a scene in memory, or of a planner document.

>>> plan = vtkhelios.plan(scene, grid=2, coverage=95)
>>> plan.positions
>>> cloud = plan.survey().run()
"""

import html
import time
import typing

import numpy as np
from vtkmodules.vtkCommonDataModel import vtkPolyData

from ..clouds.cloud import Cloud
from ..core.classes import vtk_class
from ..core.paths import from_vtk
from ..core.pipeline import perform, update
from ..core.watching import Progress
from ..core.words import counted
from ..scenes.scene import Scene, has_instances
from ..surveys.survey import Survey
from . import files as plan_files
from .document import check_assets, make_document
from .geo import Geography
from .places import to_places
from .settings import check_settings, fill_document, fill_filters
from .summary import make_report, order_positions

if typing.TYPE_CHECKING:  # keywords, made by Python/make_stubs.py
    from ..surveys.keywords import PlanSettings

__all__ = ["Plan", "PlanTask", "plan"]


def plan(
    scene, assets=(), name=None, progress=None, **settings: "typing.Unpack[PlanSettings]"
) -> "Plan":
    """Finds the fewest positions to scan a scene from; returns a Plan.

    scene
        a Scene, a vtkPolyData of triangles, or an algorithm that makes one; a file: a planner,
        survey or scene (HELIOS XML), or a mesh (.obj, .tif, .ply, .stl, .gltf, .glb, .json); or a
        vtkHeliosPlannerReader. A setting that is not given, or None, is taken from the file.
    assets
        folders to search for scenes, scanners and platforms that a file names.
    name
        of the plan, its survey and its folder. Default: the file's, else "plan".
    progress
        True for a line on standard error, or a function of the fraction done (0 to 1).
        Exceptions of the function end the planning, and so does Ctrl-C.

    Coverage:

    method
        "reduce", "greedy" (or "bestcoverage"), "best" or "optimal", see Docs/planning.md.
        Default: "best"; in a <surveyPlanner> "reduce".
    coverage
        the share of the test points that must be covered [%], (0, 100]. Default: 100.
    coverage_of
        of the points that any candidate sees, "coverable" (default), or of "all".
    overlap
        overlap that connects the scans [%], [0, 99.9], for registration. Default: 0.
    objects
        the share of the area of each part that must be covered, of what any candidate sees [%], [0,
        100]. Without coverage nothing else is required; area_weights is True by default. Default: 0,
        not required.
    area_weights
        True: test points are weighted by the area that they represent. Default: False.
    remove_order, remove_first
        of "reduce": the removal criterion, "viewshedSize" (default) or "meanIncidenceAngle"; what
        is removed first, the "smallest" (default) or the "largest".
    time_limit
        of "optimal": limit of the search, in wall time [s], [0, 1e6]. Default: 300.
    order
        of the positions: "gain", the largest first (default); "walk", the shortest walk through all of
        them; "round", the shortest that returns to its beginning. Distances are straight lines.

    Scan positions:

    grid, grid_y
        spacing of candidates along x and y [m], (0, 1e6]. Default: a twentieth of the scene's
        diagonal, and the grid's.
    region, region_of
        rectangle: x0, x1, y0, y1 [m], and what it limits: "candidates" (default), or "all", test points,
        too. Default: the scene's.
    candidates
        the places to choose from instead of a grid: a .csv with names of columns (x, y, or z of the
        ground, too), a .geojson of points, or an array (n x 2, or n x 3). GeoJSON and columns lon, lat
        are in degrees if they are not in the scene. Default: a grid.
    exclude
        excluded areas: polygons or closed lines (vtkPolyData), or a .vtp file of them.
    max_slope
        largest slope of the surface [deg], [0, 90]. Default: 15.
    on
        "ground" (default): not on roofs; "any": on any surface.
    ground
        the same in detail: whether positions are on ground materials: "true", "false", "open" (with nothing above), or
        "auto" (default), true if any material is ground, else surfaces without another one below.
    enclosed
        True: also enclosed places, such as rooms. Default: False, only if there are no others.
    height
        of the instrument above the surface [m], (0, 1e4]. Default: the platform's mount.

    Visibility:

    test_grid
        spacing of test points [m], (0, 1e6]. Default: that of grid.
    test_lines
        grid lines that carry test points: "all" (default), "vertical" or "horizontal".
    tolerance
        a ray sees a test point if it ends at most this far before it [m], [1e-6, 1e3].
        Default: 0.05.
    two_sided
        True: also at most this far behind it. Default: False.
    scanner_limits
        True: range gate and field of view of the scanner, where no limit is given.
        Default: False.
    moving_parts
        True: the scene has its moving parts, where they are at the start of the survey. Default:
        False, they are left out.
    range_min, range_max
        [m], [0, 1e9]. Default: no limits.
    elevation_min, elevation_max
        vertical field of view [deg], [-90, 90]. Default: no limits.
    max_incidence
        largest angle of incidence, from the normal [deg], [0, 90]. Default: 90.
    min_density
        least point density on a surface from one position [1/m2], [0, 1e12]. Default: 0.

    The scans:

    platform, scanner
        ids in the catalogue, or "file.xml#id". Default: "tripod" and "vz400_class_tls".
    resolution
        angle between pulses of a line and between lines [deg], (0, 90], as near as the scanner
        allows. Default: 0.1.
    pulse_frequency
        [Hz], (0, 1e9]. Default: the scanner's first.

    The field work:

    setup_time, walking_speed
        for a tripod [s], [0, 1e5], and between tripods [m/s], [0.01, 100]. Default: 300 and 1.
    crs
        the coordinate system of a scene that has none, such as "EPSG:25832", for geo files.

    memory
        limit of each of grids and viewsheds [MiB], [1, 1e9]. Default: 2048.

    Raises ValueError and TypeError for a setting that is not valid, PipelineError with the messages
    of the file and the filters.
    """
    return PlanTask(scene, assets, name, **settings).run(progress)


class Step(typing.NamedTuple):
    """A step of a plan: a filter to update."""

    name: str
    algorithm: object
    begin: float  # begin of the fraction done
    end: float
    is_even: bool = True  # whether the remaining time follows from the progress

    def run(self, seconds, callback=None):
        """Updates the filter; adds its time to a dictionary.

        The callback is called with the filter and its fraction done.
        """
        start = time.monotonic()
        update(self.algorithm, progress=callback)
        seconds[self.name] = time.monotonic() - start


class PlanTask:
    """A plan to make, with the arguments of plan(): its settings are checked, its document is read.

    filters
        the vtkHeliosScanPlan, whose filters may be changed; settings not known to plan() are
        properties there.
    settings
        a dictionary of all.
    """

    def __init__(self, scene, assets=(), name=None, **settings):
        self.assets = check_assets(assets)
        given = check_settings(settings)
        self.source, self.document = make_document(scene, self.assets)
        fill_document(self.document, given)
        perform(self.document, self.document.Read, f"{self.source}: cannot be read", stacklevel=4)
        self.name = from_vtk(self.document.GetPlanName()) if name is None else name
        self.filters = vtk_class("vtkHeliosScanPlan")()
        self.filters.SetDocument(self.document)
        self.settings = fill_filters(self.filters, given)

    def steps(self):
        """Yields the steps, each to be run before the next one is taken."""
        candidates, test_points = self.filters.GetCandidates(), self.filters.GetTestPoints()
        yield Step("loading the scene", self.document, 0.0, 0.1)
        self._use_scene()
        yield Step("finding candidates", candidates, 0.1, 0.15)
        yield Step("finding test points", test_points, 0.15, 0.2)
        positions = candidates.GetOutput().GetNumberOfPoints()
        points = test_points.GetOutput().GetNumberOfPoints()
        words = f"viewsheds of {counted(positions, 'candidate')}, {counted(points, 'test point')}"
        yield Step(words, self.filters.GetViewsheds(), 0.2, 0.8)
        is_limited = self.settings["method"] == "optimal" and self.settings["time_limit"]
        limit = f", search limited to {self.settings['time_limit']:g} s" if is_limited else ""
        planner = self.filters.GetPlanner()
        yield Step(f"selecting positions{limit}", planner, 0.8, 1.0, is_even=False)

    def _use_scene(self):
        """Sets what depends on the coordinate system of the scene."""
        scene = self.document.GetOutput()
        self.geography = Geography(scene, self.settings["crs"])
        if (given := self.settings["candidates"]) is not None:
            box, region = Scene(scene).bounds, self.settings["region"]
            places = to_places(given, self.geography, box, region)
            self.filters.GetCandidates().SetInputDataObject(2, places)

    def has_scene_in_memory(self):
        """Returns whether the scene has no file."""
        return self.document.GetNumberOfInputConnections(0) > 0

    def run(self, progress=None):
        """Makes the plan; progress is as in plan()."""
        seconds = {}
        with Progress(progress) as watched:
            for step in self.steps():
                watched.begin, watched.end = step.begin, step.end
                step.run(seconds, watched.callback)
        return Plan(self, seconds)


class Plan:
    """A plan that was made.

    positions
        of the instrument [m], n x 3, in the order that was asked for: the largest gain first.
    coverage
        the share of the test points that any candidate sees, and that these see [%].
    scans, candidates, test_points
        Clouds with the arrays of vtkHeliosScanPositionPlanner: ViewshedSize, NewlyCovered,
        MeanIncidenceAngle [deg] ...; the test points with NumberOfScans and BestIncidenceAngle.
    report
        a dictionary with the content of plan_summary.json: settings, bounds, positions.
    seconds
        the time of every step [s].
    scene
        the scene (vtkPolyData; a vtkHeliosScene if parts with the same mesh are stored once).
    task
        the PlanTask, with all filters.

    Later runs of the task do not change it.
    """

    def __init__(self, task, seconds):
        self.task, self.seconds = task, seconds
        planner = task.filters.GetPlanner()
        self.name = task.name
        self.scene, self.geography = _copy(task.document.GetOutput()), task.geography
        self.outputs = [_copy(planner.GetOutputDataObject(port)) for port in range(3)]
        self.outputs[2], walk = order_positions(self.outputs[2], task.settings["order"])
        self.candidates, self.test_points, self.scans = map(Cloud, self.outputs)
        self.report = {**make_report(task, self.outputs[2], walk), "timings": dict(seconds)}

    @property
    def positions(self) -> np.ndarray:
        return self.scans.points

    @property
    def coverage(self) -> float:
        return self.report["result"]["coverableCoverage_percent"]

    @property
    def is_proved_optimal(self) -> bool:
        """Whether there is no plan with fewer scans of these candidates."""
        return self.report["result"]["isProvedOptimal"]

    def survey(self) -> Survey:
        """Returns the Survey that scans from the positions, one leg each."""
        return plan_files.plan_survey(self)

    def write(self, folder="output", overwrite=False, picture=False, geo=None) -> list:
        """Writes the files of ``vtkhelios plan`` and returns their paths.

        They are in a folder with the plan's name below the given one. A scene in memory is written,
        too: scene.obj. overwrite replaces an earlier plan, else it is a FileExistsError. picture
        adds plan.png, which needs an X display, or Xvfb, and plan.html, which needs matplotlib and
        Jinja2. geo are the files of positions: "csv,geojson", "none" ...; None: all that the scene
        permits, without a warning of others.
        """
        in_memory = self.task.has_scene_in_memory()
        return plan_files.write_all(plan_files, self, folder, in_memory, overwrite, picture, geo)

    def __len__(self) -> int:
        return len(self.positions)

    def __repr__(self):
        result = self.report["result"]
        proof = "the fewest" if self.is_proved_optimal else f"at least {result['bestBound']}"
        return (
            f"Plan({self.name!r}: {len(self)} scan{'s'[: len(self) != 1]}, {proof} of "
            f"{counted(self.report['candidates'], 'candidate')}, cover {self.coverage:.2f} % of the "
            f"{self.report['coverable']:,} coverable test points)"
        )

    def _repr_html_(self):
        titles = ("scan", "x, y, z [m]", "sees", "adds", "only it", "mean incidence [deg]")
        head = "".join(f"<th>{title}</th>" for title in titles)
        rows = []
        for row in self.report["positions"]:
            angle = row["meanIncidence_deg"]
            cells = (
                row["scan"],
                f"{row['x']:.3f}, {row['y']:.3f}, {row['z']:.3f}",
                f"{row['sees']:,}",
                f"{row['adds']:,}",
                f"{row['onlyIt']:,}",
                "-" if angle is None else f"{angle:.1f}",
            )
            rows.append(f"<tr>{''.join(f'<td>{cell}</td>' for cell in cells)}</tr>")
        return f"{html.escape(repr(self))}<table><tr>{head}</tr>{''.join(rows)}</table>"


def _copy(polydata):
    copy = polydata.NewInstance() if has_instances(polydata) else vtkPolyData()
    copy.ShallowCopy(polydata)
    return copy
