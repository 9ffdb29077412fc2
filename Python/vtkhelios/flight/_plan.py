# SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
# SPDX-License-Identifier: BSD-3-Clause
"""Flight plans: lines, speed and frequencies over an area, and the pulse density that they give."""

import math

import numpy as np

from ..array_names import FLYING_HEIGHT, NUMBER_OF_STRIPS, STRIP_DENSITY
from ..clouds.cloud import Cloud
from ..core.classes import vtk_class
from ..core.paths import from_vtk
from ..core.pipeline import update
from ..plans import files as plan_files
from ..plans.document import PLATFORM as TRIPOD
from ..plans.document import SCANNER as TRIPOD_SCANNER
from ..plans.document import check_assets, make_document
from ..plans.geo import Geography
from ..plans.kinds import SettingError
from ..scenes.scene import Scene
from . import _files
from ._area import box_area, contains, is_geojson, measure, read_area, to_polydata
from ._design import Designer, Relief
from ._follow import follow_terrain, line_lengths, line_waypoints
from ._instrument import Instrument
from ._settings import check_flight_settings
from ._summary import make_report
from ._survey import make_survey
from ._terrain import MAXIMUM_CELLS, Grid, Terrain, make_places

__all__ = ["FlightPlan"]

MAXIMUM_ATTEMPTS = 6  # to meet the requirements over relief
ENOUGH = 0.99  # share of the area, with the required density
MARGIN = 1e-3  # margin of a correction, so that it suffices


class FlightPlan:
    """A flight plan that was made.

    waypoints
        a Cloud: points [m] with Speed [m/s] and Active (1: the scanner fires to the next).
    lines
        a list of dictionaries, a flight line each: begin, end [m], length [m], heading [deg] ...
    cells
        a Cloud: the centres of cells of the area with PulseDensity and StripDensity [1/m2],
        NumberOfStrips, FlyingHeight [m].
    grid
        the Grid of the cells; inside: which of its cells are in the area and on the ground.
    design
        heights, speed, frequencies: a Design.
    steps
        the next "lower" and "higher" pulse frequency: a Design each, or the reason why none exists.
    report
        a dictionary with the content of plan_summary.json.
    """

    def __init__(self, scene, assets=(), name=None, **settings):
        self.assets = check_assets(assets)
        self.settings = check_flight_settings(settings)
        self.source, self.document = _read_document(scene, self.assets)
        self.name = f"{from_vtk(self.document.GetPlanName())}_als" if name is None else name
        self.instrument = Instrument(
            self.settings["scanner"], self.settings["platform"], self.assets
        )
        self.scene = update(self.document)
        self.geography = Geography(self.scene, self.settings["crs"])
        self.terrain = Terrain(self.scene)
        self.polygons = self._find_area()
        self.area = measure(self.polygons)
        self.grid = self._make_grid()
        heights, known = self.terrain.grid_heights(self.grid)
        inside = contains(self.polygons, self.grid.centres()).reshape(self.grid.shape)
        self.inside = inside & known
        if not self.inside.any():
            raise SettingError(
                "{0} has no ground of the scene; give a polygon in the coordinates of the scene, {box}",
                "area",
                box=_describe_box(self.scene),
            )
        self.ground = heights[self.inside]
        self._places = make_places(self.grid, heights, self.inside)
        self._plan()
        self.report = make_report(self)

    def survey(self):
        """Returns the Survey of the flight, to run in memory; of a scene in memory or in a file."""
        return make_survey(self)

    def write(self, folder="output", overwrite=False, picture=False, geo=None):
        """Writes the files of ``vtkhelios plan --als`` and returns their paths.

        They are in a folder with the plan's name below the given one. overwrite replaces an earlier
        plan, else it is a FileExistsError. picture adds plan.png and plan.html. geo are the files of
        lines: "csv,geojson", "none" ...; None: all that the scene permits, without a warning of others.
        """
        in_memory = self.has_scene_in_memory()
        return plan_files.write_all(_files, self, folder, in_memory, overwrite, picture, geo)

    def line_waypoints(self):
        """Yields the waypoints of each line, n x 3 [m]."""
        return line_waypoints(self.flight)

    def has_scene_in_memory(self):
        return self.document.GetNumberOfInputConnections(0) > 0

    def _find_area(self):
        low, high = box = _box(self.scene)
        if self.settings["area"] is None:
            return box_area(low, high)
        polygons = read_area(self.settings["area"])
        corners = np.concatenate([ring for rings in polygons for ring in rings])
        if not is_geojson(self.settings["area"]) or not self.geography.is_in_degrees(corners, box):
            return polygons
        return [[self.geography.from_degrees(ring) for ring in rings] for rings in polygons]

    def _make_grid(self):
        corners = np.concatenate([rings[0] for rings in self.polygons])
        low, high = corners.min(axis=0), corners.max(axis=0)
        size = high - low
        cell = self.settings["cell"]
        if cell is None:
            cell = max(self._nominal_cell(), math.sqrt(size[0] * size[1] / MAXIMUM_CELLS))
        if np.prod(np.ceil(size / cell)) > 100 * MAXIMUM_CELLS:
            raise SettingError(
                "{0} is {cell:g} m, which makes {count:.3g} cells of the area; give a larger one",
                "cell",
                cell=cell,
                count=float(np.prod(np.ceil(size / cell))),
            )
        return Grid(low, high, cell)

    def _nominal_cell(self):
        if self.settings["density"]:
            return 2 / math.sqrt(self.settings["density"])
        return 2 * max(self.settings["spacing"])

    def _plan(self):
        """Plans; over relief again, with what the ground rises and drops below the lines."""
        designer = Designer(self.instrument, self.settings, to_polydata(self.polygons))
        self.tangent = designer.tangent
        follows = self.settings["terrain_following"]
        relief = Relief(drop=0.0 if follows else float(np.ptp(self.ground)))
        for attempt in range(MAXIMUM_ATTEMPTS):
            try:
                self.design = designer.choose(relief)
            except SettingError:
                if attempt == 0:
                    raise
                break  # the last plan stays, and its report says what it lacks
            planned = relief
            self._fly(designer)
            better = self._correct(relief)
            if better == relief:
                break
            relief = better
        self.steps = designer.find_steps(self.design, planned)

    def _fly(self, designer):
        """The lines of the design at their heights, and the density that they give."""
        lines = designer.make_lines(self.design, self._find_altitude())
        self.pattern = {
            "heading_deg": lines.GetFirstHeading(),
            "lines": lines.GetNumberOfLines(),
            "lineLength_m": lines.GetLineLength(),
            "turnLength_m": lines.GetTurnLength(),
            "time_s": lines.GetFlightTime(),
        }
        data = update(lines)
        if self.settings["terrain_following"]:
            data = self._follow(data)
            self._count_climbs(data)
        self.flight = data
        self.swath = self.instrument.make_swath(
            self.design.pulse_frequency, self.design.scan_frequency, self.design.scan_angle
        )
        density = vtk_class("vtkHeliosPulseDensity")()
        density.SetSwath(self.swath)
        density.SetInputData(0, self._places)
        density.SetInputData(1, data)
        self.cells = Cloud(update(density))
        self.waypoints = Cloud(data)

    def _count_climbs(self, data):
        """The length and time of lines that climb."""
        length = line_lengths(data).sum()
        more = (length - self.pattern["lineLength_m"]) / self.design.speed
        self.pattern |= {"lineLength_m": length, "time_s": self.pattern["time_s"] + more}

    def _find_altitude(self):
        return float(self.ground.max()) + self.design.flying_height

    def _follow(self, lines):
        """Returns the lines at the flying height above the ground, as polylines."""
        cell, climb = self.grid.cell, self.settings["max_climb"]
        return follow_terrain(self.terrain, lines, self.design.flying_height, climb, cell)

    def _correct(self, relief):
        """The relief that the next plan must allow for; the same if this plan is good."""
        cells, height = self.cells, self.design.flying_height
        if self.settings["terrain_following"]:
            flying = cells[FLYING_HEIGHT]
            if self._has_gaps() or flying.min() < self.settings["nohd"]:
                rise = (1 + MARGIN) * max(0.0, height - float(flying.min()))
                relief = relief._replace(rise=max(relief.rise, rise))
            if self._is_thin():
                drop = (1 + MARGIN) * max(0.0, float(flying.max()) - height)
                if drop > relief.drop:
                    return relief._replace(drop=drop)
        if self._is_thin():
            factor = self.required_density() / max(self._quantile(), 1e-9)
            return relief._replace(factor=relief.factor * min(2.0, factor * (1 + MARGIN)))
        return relief

    def _has_gaps(self):
        return bool((self.cells[NUMBER_OF_STRIPS] == 0).any())

    def _quantile(self):
        return float(np.quantile(self.cells[STRIP_DENSITY], 1 - ENOUGH))

    def _is_thin(self):
        return self._quantile() < self.required_density() * (1 - 1e-6)

    def required_density(self):
        """The pulse density that a strip must have [1/m2]."""
        if self.settings["density"]:
            return self.settings["density"]
        return 1.0 / math.prod(self.settings["spacing"])

    @property
    def lines(self):
        return self.report["lines"]

    def __len__(self):
        return len(self.lines)

    def __repr__(self):
        return (
            f"FlightPlan({self.name!r}: {len(self)} line{'s'[: len(self) != 1]}, "
            f"{self.pattern['time_s'] / 60:.1f} min at {self.design.speed:.1f} m/s, "
            f"{self.report['predicted']['density_1_m2']['mean']:.2f} pulses/m2)"
        )


def _read_document(scene, assets):
    """Returns the file of a plan, None for a scene in memory, and the reader of its scene."""
    source, document = make_document(scene, assets)
    document.SetPlatform(TRIPOD)  # the reader checks them, and no one else uses them
    document.SetScanner(TRIPOD_SCANNER)
    update(document)
    return source, document


def _box(scene):
    return Scene(scene).bounds


def _describe_box(scene):
    low, high = _box(scene)
    return f"x {low[0]:.6g} to {high[0]:.6g}, y {low[1]:.6g} to {high[1]:.6g} m"
