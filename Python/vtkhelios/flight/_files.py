# SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
# SPDX-License-Identifier: BSD-3-Clause
"""The files of a flight plan."""

import numpy as np

from ..core.files import write_whole
from ..core.write import write_points
from ..plans.files import PAGE, PICTURE, SUMMARY, SURVEY
from ..plans.geo import Feature, geo_names, write_geo
from ..plans.positions import to_csv
from ..reports.flight import heights
from ..reports.flight_page import write_page
from ..reports.flight_picture import make_picture
from ._follow import line_waypoints
from ._survey import scene_file, write_survey

LINES, CELLS = "lines.vtp", "cells.vtp"
GEO = "lines"  # files for maps and receivers, without their endings
FILES = (SURVEY, LINES, CELLS, *geo_names(GEO), PICTURE, PAGE, SUMMARY)
COLUMNS = (  # columns of the table: title, value of a row, digits
    ("line", lambda row: row["line"], 0),
    ("x0 [m]", lambda row: row["begin"][0], 3),
    ("y0 [m]", lambda row: row["begin"][1], 3),
    ("x1 [m]", lambda row: row["end"][0], 3),
    ("y1 [m]", lambda row: row["end"][1], 3),
    ("lowest z [m]", lambda row: row["lowest_m"], 3),
    ("highest z [m]", lambda row: row["highest_m"], 3),
    ("heading [deg]", lambda row: row["heading_deg"], 2),
    ("length [m]", lambda row: row["length_m"], 1),
    ("time [s]", lambda row: row["time_s"], 1),
)


def data_files(plan, folder):
    """Writes survey, lines and cells; returns their paths."""
    mesh = scene_file(plan, folder)
    files = [write_survey(plan, folder / SURVEY, mesh)] + ([mesh] if mesh else [])
    files.append(write_points(plan.flight, folder / LINES))
    files.append(write_points(plan.cells.data, folder / CELLS))
    return files


def picture_file(plan, folder):
    """Draws the picture; returns its path."""
    return _write(folder / PICTURE, make_picture(plan))


def page_file(plan, folder, counts=None):
    """Writes the page; counts: of a simulation. Returns its path."""
    return _write(folder / PAGE, write_page(plan, counts))


def geo_files(plan, folder, formats):
    """Writes lines and area in some formats; returns their paths, and why some are missing, or
    None."""
    table = to_csv(plan.lines, COLUMNS, plan.geography.label)
    return write_geo(folder, GEO, plan.name, make_features(plan), table, plan.geography, formats)


def make_features(plan):
    """Returns the lines and the area."""
    features = [
        Feature("Line", f"line {row['line']}", "lines", places, _properties(row), _describe(row))
        for row, places in zip(plan.lines, line_waypoints(plan.flight), strict=True)
    ]
    ground = float(plan.ground.min())
    for rings in plan.polygons:
        raised = [np.column_stack([ring, np.full(len(ring), ground)]) for ring in rings]
        features.append(
            Feature("Polygon", "area", "area", raised, {"area_m2": round(plan.area, 3)})
        )
    return features


def _properties(row):
    names = ("line", "lowest_m", "highest_m", "heading_deg", "length_m", "time_s")
    return {name: round(row[name], 4) for name in names}


def _describe(row):
    return (
        f"heading {row['heading_deg']:.1f} deg, {row['length_m']:.0f} m, {row['time_s']:.0f} s, at "
        f"{heights(row)} m"
    )


def _write(path, content):
    write_whole(path, content)
    return path
