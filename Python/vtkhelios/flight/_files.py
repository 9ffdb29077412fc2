# SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
# SPDX-License-Identifier: BSD-3-Clause
"""The files of a flight plan."""

import csv
import io
import json

from ..core.files import write_whole
from ..core.write import write_points
from ..plans.files import SCENE, SUMMARY, SURVEY, new_plan
from ..reports.flight_page import write_page
from ..reports.flight_picture import make_picture
from ._follow import line_waypoints
from ._survey import scene_file, write_survey

LINES, CELLS, TABLE = "lines.vtp", "cells.vtp", "lines.csv"
GEOJSON, PICTURE, PAGE = "lines.geojson", "plan.png", "plan.html"
FILES = (SURVEY, LINES, CELLS, TABLE, GEOJSON, PICTURE, PAGE, SUMMARY)
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


def has_plan(folder, more=()):
    """Returns whether a folder has files of a plan, or more files."""
    return any((folder / name).exists() for name in [*FILES, *more])


def write_plan(plan, folder, overwrite=False, picture=False):
    """Writes all files in a folder with the plan's name; returns their paths."""
    folder = folder / plan.name
    more = [SCENE] if plan.has_scene_in_memory() else []
    if not overwrite and has_plan(folder, more):
        raise FileExistsError(
            f"{folder}: has the files of an earlier plan; give overwrite=True to replace them, or "
            "another folder"
        )
    with new_plan(folder, (*more, *FILES)):
        files = data_files(plan, folder)
        files += [picture_file(plan, folder), page_file(plan, None, folder)] if picture else []
        report = {**plan.report, "files": [each.name for each in files]}
        return [*files, summary_file(report, folder)]


def data_files(plan, folder):
    """Writes survey, lines and cells; returns their paths."""
    mesh = scene_file(plan, folder)
    files = [write_survey(plan, folder / SURVEY, mesh)] + ([mesh] if mesh else [])
    files.append(write_points(plan.flight, folder / LINES))
    files.append(write_points(plan.cells.data, folder / CELLS))
    files.append(_write(folder / TABLE, make_table(plan.lines)))
    files.append(_write(folder / GEOJSON, make_geojson(plan)))
    return files


def picture_file(plan, folder):
    """Draws the picture; returns its path."""
    return _write(folder / PICTURE, make_picture(plan))


def page_file(plan, counts, folder):
    """Writes the page; counts: of a simulation, or None. Returns its path."""
    return _write(folder / PAGE, write_page(plan, counts))


def summary_file(report, folder):
    return _write(folder / SUMMARY, json.dumps(report, indent=2) + "\n")


def make_table(lines):
    """Returns the lines as CSV."""
    text = io.StringIO()
    writer = csv.writer(text, lineterminator="\n")
    writer.writerow([title for title, *_ in COLUMNS])
    for row in lines:
        writer.writerow([f"{value(row):.{digits}f}" for _, value, digits in COLUMNS])
    return text.getvalue()


def make_geojson(plan):
    """Returns the lines and area as GeoJSON, in the coordinates of the scene."""
    features = [
        _feature("LineString", places.tolist(), line=row["line"], time_s=row["time_s"])
        for row, places in zip(plan.lines, line_waypoints(plan.flight), strict=True)
    ]
    area = [[_closed(ring) for ring in rings] for rings in plan.polygons]
    features.append(_feature("MultiPolygon", area, name="area"))
    return json.dumps({"type": "FeatureCollection", "features": features}, indent=1) + "\n"


def _closed(ring):
    return [*ring.tolist(), ring[0].tolist()]


def _feature(kind, coordinates, **properties):
    geometry = {"type": kind, "coordinates": coordinates}
    return {"type": "Feature", "properties": properties, "geometry": geometry}


def _write(path, content):
    write_whole(path, content)
    return path
