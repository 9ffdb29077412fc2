# SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
# SPDX-License-Identifier: BSD-3-Clause
"""Candidates of scan positions from a file: CSV with names of columns, or GeoJSON."""

import csv
import math
import os
import pathlib
import re

import numpy as np
from vtkmodules.vtkCommonCore import vtkPoints
from vtkmodules.vtkCommonDataModel import vtkPolyData

from ..core.arrays import numpy_to_vtk
from ..core.json_files import JsonError, parse_json
from .kinds import Setting, SettingError

__all__ = ["Places", "read_places", "to_places"]

COLUMNS = {  # names of a column, in lower case and without its unit
    "x": ("x", "e", "east", "easting", "rechtswert", "lon", "longitude"),
    "y": ("y", "n", "north", "northing", "hochwert", "lat", "latitude"),
    "z": ("ground z", "ground_z", "z", "h", "height", "elevation", "altitude", "ele"),
}
GROUND = "groundZ_m"  # the property of GeoJSON with the height of the ground


class Places(Setting):
    """Candidates of a plan: a file, or places (n x 2, or n x 3 with the heights of the ground)."""

    def read(self, objects):
        return None

    def set(self, objects, value):
        pass  # once the scene is loaded, which may convert them

    def check(self, name, value):
        if isinstance(value, (str, os.PathLike)):
            read_places(name, value)  # errors now
            return os.fspath(value)
        return _check(name, value)

    def report(self, value):
        return value if value is None or isinstance(value, str) else "places"


def _check(name, value):
    try:
        places = np.array(value, dtype=float)
    except (TypeError, ValueError):
        raise TypeError(f"{name} is {value!r}; give a file, or places (n x 2)") from None
    if places.ndim != 2 or places.shape[1] not in (2, 3) or not len(places):
        raise TypeError(f"{name} has the shape {places.shape}; give places (n x 2, or n x 3)")
    if not np.isfinite(places).all():
        raise SettingError("{0} has a coordinate that is not finite; correct it", name)
    return _with_heights(places)


def _with_heights(places):
    if places.shape[1] == 3:
        return places
    return np.column_stack([places, np.full(len(places), math.nan)])


def to_places(value, geography, box, region=None):
    """Returns the places of a checked setting (vtkPolyData): x, y, z [m], z NaN if it is not given.

    box
        low and high corner of the scene: degrees in a file are known by being outside.
    region
        x0, x1, y0, y1: others are left out.
    """
    points = read_places("candidates", value) if isinstance(value, str) else value
    if isinstance(value, str) and geography.is_in_degrees(points[:, :2], box):
        points = np.column_stack([geography.from_degrees(points[:, :2]), points[:, 2]])
    if region is not None:
        x0, x1, y0, y1 = region
        (x, y), every = points[:, :2].T, len(points)
        points = points[(x >= x0) & (x <= x1) & (y >= y0) & (y <= y1)]
        if not len(points):
            raise SettingError(
                "{0} has none of the {every} places of {1}; give a larger one",
                "region",
                "candidates",
                every=every,
            )
    data, coordinates = vtkPolyData(), vtkPoints()
    coordinates.SetData(numpy_to_vtk(np.ascontiguousarray(points), deep=True))
    data.SetPoints(coordinates)
    return data


def read_places(name, path):
    """Returns the places of a file (n x 3), with NaN for heights that are not given; ``name`` is that of
    the setting."""
    path = os.fspath(path)
    kind = pathlib.Path(path).suffix.lower()
    if kind not in (".csv", ".txt", ".geojson", ".json"):
        raise _error(
            name, path, "is not CSV or GeoJSON; give a .csv with names of columns, or a .geojson"
        )
    try:
        text = pathlib.Path(path).read_text(encoding="utf-8-sig")
    except (OSError, UnicodeDecodeError) as error:
        reason = getattr(error, "strerror", None) or "is not a text in UTF-8"
        raise _error(name, path, f"cannot be read: {reason}; give a .csv or a .geojson") from None
    rows = (
        _parse_csv(name, path, text)
        if kind in (".csv", ".txt")
        else _parse_geojson(name, path, text)
    )
    if not rows:
        raise _error(name, path, "has no place; give one or more")
    return np.array(rows, dtype=float)


def _parse_csv(name, path, text):
    head, *lines = text.splitlines() or [""]
    mark = max(",;\t", key=head.count)
    titles = [
        re.sub(r"\s*[\[(].*", "", word).strip().lower()
        for word in next(csv.reader([head], delimiter=mark))
    ]
    columns = {}
    for axis, names in COLUMNS.items():
        found = [titles.index(each) for each in names if each in titles]
        columns[axis] = found[0] if found else None
    for axis in "xy":
        if columns[axis] is None:
            raise _error(
                name,
                f"{path}:1",
                f"has no column {axis} ({', '.join(COLUMNS[axis])}) among {', '.join(titles)}; name it",
            )
    rows = []
    for number, words in enumerate(csv.reader(lines, delimiter=mark), 2):
        if any(word.strip() for word in words):
            rows.append(
                [_value(name, f"{path}:{number}", words, axis, columns[axis]) for axis in "xyz"]
            )
    return rows


def _value(name, where, words, axis, column):
    text = words[column].strip() if column is not None and column < len(words) else ""
    if not text and axis == "z":
        return math.nan
    try:
        value = float(text)
    except ValueError:
        value = math.nan
    if not math.isfinite(value):
        raise _error(name, where, f"{axis} is {text!r}; give a number")
    return value


def _parse_geojson(name, path, text):
    try:
        return list(_find_points(parse_json(text)))
    except JsonError as error:
        raise _error(name, path, f"{error}; give GeoJSON points") from None
    except (TypeError, ValueError, IndexError, OverflowError):
        raise _error(name, path, "has coordinates that are not numbers; give x, y pairs") from None


def _find_points(item):
    """Yields x, y and the height of all points in a GeoJSON object; raises for what is no number."""
    items = [(item, math.nan)]
    for each, height in items:
        if not isinstance(each, dict):
            continue
        given = (each.get("properties") or {}).get(GROUND)
        height = float(given) if isinstance(given, (int, float)) else height
        kind = each.get("type")
        places = {"Point": [each.get("coordinates")], "MultiPoint": each.get("coordinates")}.get(
            kind, []
        )
        for place in places:
            x, y = place[:2]
            if not all(isinstance(each, (int, float)) and math.isfinite(each) for each in (x, y)):
                raise TypeError
            yield [float(x), float(y), height]
        inner = [
            *(each.get("features") or []),
            *(each.get("geometries") or []),
            each.get("geometry"),
        ]
        items += [(more, height) for more in inner]


def _error(name, where, problem):
    return SettingError("{0} {where}: {problem}", name, where=where, problem=problem)
