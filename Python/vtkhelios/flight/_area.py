# SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
# SPDX-License-Identifier: BSD-3-Clause
"""Areas of flight plans: polygons in WKT, GeoJSON, text, VTK XML, or arrays."""

import os
import pathlib
import re

import numpy as np
from vtkmodules.vtkCommonCore import vtkIdList, vtkPoints
from vtkmodules.vtkCommonDataModel import vtkCellArray, vtkPolyData

from ..core.classes import vtk_class
from ..core.json_files import JsonError, parse_json
from ..core.paths import to_vtk
from ..core.pipeline import update
from ..plans.kinds import SettingError

FARTHEST = 1e9  # coordinate [m]
NUMBER = r"[-+]?(?:\d+(?:\.\d*)?|\.\d+)(?:[eE][-+]?\d+)?"
WKT = re.compile(r"\s*(?:SRID=\d+;\s*)?(MULTI)?POLYGON\b", re.I)
GEOJSON = (".geojson", ".json")
KINDS = "a polygon in WKT, or a file of one: .geojson, .json, .wkt, .txt, .csv or .vtp"


def read_area(area):
    """Returns the polygons of an area: a list of polygons, each a list of rings (n x 2 [m]), outer
    first.

    area
        a text in WKT, the path of a file, a vtkPolyData of polygons, or corners (n x 2).
    """
    if isinstance(area, vtkPolyData):
        return _check(_from_polydata(area), "area")
    if isinstance(area, (str, os.PathLike)):
        text = os.fspath(area)
        return _check(_parse_wkt(text, "area"), "area") if WKT.match(text) else _read_file(text)
    try:
        corners = np.array(area, dtype=float)
    except (TypeError, ValueError):
        raise TypeError(f"area is {area!r}; give {KINDS}, or its corners (n x 2)") from None
    if corners.ndim != 2 or corners.shape[1] < 2:
        raise TypeError(f"area has the shape {corners.shape}; give its corners (n x 2)")
    return _check([[corners[:, :2]]], "area")


def is_geojson(area):
    """Returns whether an area is a file of GeoJSON, which may be in degrees."""
    is_text = isinstance(area, (str, os.PathLike)) and not WKT.match(os.fspath(area))
    return is_text and pathlib.Path(area).suffix.lower() in GEOJSON


def box_area(low, high):
    """Returns the rectangle of a box."""
    (x0, y0), (x1, y1) = low[:2], high[:2]
    return [[np.array([(x0, y0), (x1, y0), (x1, y1), (x0, y1)], dtype=float)]]


def to_polydata(polygons):
    """Returns the outer rings as a vtkPolyData."""
    points, cells = vtkPoints(), vtkCellArray()
    points.SetDataTypeToDouble()
    for rings in polygons:
        cells.InsertNextCell(len(rings[0]))
        for x, y in rings[0].tolist():
            cells.InsertCellPoint(points.InsertNextPoint(x, y, 0.0))
    data = vtkPolyData()
    data.SetPoints(points)
    data.SetPolys(cells)
    return data


def measure(polygons):
    """Returns the area of the polygons without their holes [m2]."""
    return sum(
        abs(_signed_area(rings[0])) - sum(abs(_signed_area(hole)) for hole in rings[1:])
        for rings in polygons
    )


def contains(polygons, places):
    """Which places (n x 2) are inside: of the edges of all rings an odd number is to their right."""
    inside = np.zeros(len(places), dtype=bool)
    x, y = places[:, 0], places[:, 1]
    for ring in (ring for rings in polygons for ring in rings):
        for (x0, y0), (x1, y1) in zip(ring, np.roll(ring, -1, axis=0)):
            spans = (y0 <= y) != (y1 <= y)
            if spans.any():
                inside[spans] ^= x[spans] < x0 + (y[spans] - y0) / (y1 - y0) * (x1 - x0)
    return inside


def _signed_area(ring):
    x, y = (ring - ring.mean(axis=0)).T
    return 0.5 * float(np.dot(x, np.roll(y, -1)) - np.dot(np.roll(x, -1), y))


def _read_file(path):
    kind = pathlib.Path(path).suffix.lower()
    if kind == ".vtp":
        reader = vtk_class("vtkHeliosPointXMLReader")()
        reader.SetFileName(to_vtk(path))
        return _check(_from_polydata(update(reader)), path)
    try:
        text = pathlib.Path(path).read_text(encoding="utf-8")
    except (OSError, UnicodeDecodeError) as error:
        reason = getattr(error, "strerror", None) or "is not a text"
        raise SettingError(
            "{0} {path}: cannot be read: {reason}; give {kinds}",
            "area",
            path=path,
            reason=reason,
            kinds=KINDS,
        ) from None
    if kind in GEOJSON:
        return _check(_parse_geojson(text, path), path)
    return _check(_parse_wkt(text, path) if WKT.match(text) else _parse_rows(text, path), path)


def _parse_wkt(text, where):
    """POLYGON ((x y, ...), (hole)) or MULTIPOLYGON (((x y, ...)), ...)."""
    is_multi = WKT.match(text)[1]
    body = text[WKT.match(text).end() :]
    polygons = re.findall(r"\(\s*(\([^()]*\)(?:\s*,\s*\([^()]*\))*)\s*\)", body)
    if not polygons or (len(polygons) > 1 and not is_multi):
        raise _error(where, "is not a valid polygon in WKT: expected POLYGON ((x y, x y, ...))")
    return [
        [_parse_ring(ring, where) for ring in re.findall(r"\(([^()]*)\)", polygon)]
        for polygon in polygons
    ]


def _parse_ring(text, where):
    rows = []
    for number, corner in enumerate(text.split(",")):
        words = corner.split()
        if len(words) < 2 or not all(re.fullmatch(NUMBER, word) for word in words):
            raise _error(where, f"vertex {number} is {corner.strip()!r}: expected x y")
        rows.append((float(words[0]), float(words[1])))
    return np.array(rows)


def _parse_rows(text, path):
    """Returns a corner per line: x y, separated by blanks, commas or semicolons; # starts a
    comment."""
    rows = []
    for number, line in enumerate(text.splitlines(), 1):
        words = re.split(r"[\s,;]+", line.partition("#")[0].strip())
        if words == [""]:
            continue
        if len(words) < 2 or not all(re.fullmatch(NUMBER, word) for word in words[:2]):
            raise _error(f"{path}:{number}", f"{line.strip()!r} is not a corner: expected x y")
        rows.append((float(words[0]), float(words[1])))
    return [[np.array(rows).reshape(-1, 2)]]


def _parse_geojson(text, path):
    try:
        polygons = list(_find_polygons(parse_json(text)))
        return [[_make_ring(ring) for ring in rings] for rings in polygons]
    except JsonError as error:
        raise _error(path, f"{error}; give a GeoJSON polygon") from None
    except (TypeError, ValueError, IndexError, OverflowError):
        raise _error(path, "has coordinates that are not numbers; give x, y pairs") from None


def _find_polygons(item):
    """Yields the coordinates of all polygons in a GeoJSON object."""
    items = [item]
    for each in items:
        if not isinstance(each, dict):
            continue
        if each.get("type") == "Polygon":
            yield each.get("coordinates")
        elif each.get("type") == "MultiPolygon":
            yield from each.get("coordinates") or []
        items += [*(each.get("features") or []), *(each.get("geometries") or [])]
        items.append(each.get("geometry"))


def _make_ring(rows):
    """Returns the corners of a ring; TypeError for those that are no numbers."""
    for row in rows:
        if not all(isinstance(x, (int, float)) and not isinstance(x, bool) for x in row):
            raise TypeError
    return np.array(rows, dtype=float)[:, :2]


def _from_polydata(data):
    polygons = []
    for cells in (data.GetPolys(), data.GetLines()):
        ids = vtkIdList()
        for cell in range(cells.GetNumberOfCells()):
            cells.GetCellAtId(cell, ids)
            corners = [data.GetPoint(ids.GetId(i))[:2] for i in range(ids.GetNumberOfIds())]
            polygons.append([np.array(corners)])
    return polygons


def _check(polygons, where):
    """Returns the polygons without repeated last corners; raises for one without a surface."""
    checked = [[_open(ring) for ring in rings] for rings in polygons]
    if not checked:
        raise _error(where, "has no polygon")
    for number, rings in enumerate(checked):
        if not all((np.abs(ring) <= FARTHEST).all() for ring in rings):
            raise _error(
                where,
                f"polygon {number} has a coordinate that is not finite, or beyond {FARTHEST:g} m; "
                "correct it",
            )
        if not rings or len(rings[0]) < 3 or _signed_area(rings[0]) == 0.0:
            raise _error(
                where, f"polygon {number} has no surface; give three or more corners, not in a line"
            )
    return checked


def _open(ring):
    return ring[:-1] if len(ring) > 1 and (ring[0] == ring[-1]).all() else ring


def _error(where, problem):
    if where == "area":
        return SettingError("{0} {problem}", "area", problem=problem)
    return SettingError("{0} {where}: {problem}", "area", where=where, problem=problem)
