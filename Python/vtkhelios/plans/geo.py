# SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
# SPDX-License-Identifier: BSD-3-Clause
"""Plans as points, lines and areas for maps and receivers: coordinates in the system of the scene, and
in degrees."""

import dataclasses

import numpy as np
from vtkmodules.util.numpy_support import vtk_to_numpy
from vtkmodules.vtkCommonCore import vtkPoints
from vtkmodules.vtkCommonDataModel import vtkPolyData

from ..array_names import CRS
from ..core.arrays import numpy_to_vtk
from ..core.classes import vtk_class
from ..core.files import write_files
from ..core.paths import text_from_vtk, to_vtk
from ..core.pipeline import update
from ..core.systems import find_system
from .geo_formats import WRITERS
from .kinds import SettingError

__all__ = ["FORMATS", "Feature", "Geography", "check_formats", "find_crs", "geo_names", "write_geo"]

FORMATS = ("csv", *WRITERS)
WITHOUT_SYSTEM = ("csv", "dxf")
WGS84 = "EPSG:4326"
DIGITS = 10  # digits after the point of degrees: 0.01 mm


@dataclasses.dataclass
class Feature:
    """A point, a line or an area of a plan.

    points
        x, y, z [m] in the scene, n x 3: a Point has one; a Polygon is one ring, without its first point
        at the end, or that ring and its holes, a list.
    properties
        for formats that have a table.
    """

    kind: str  # Point, Line or Polygon
    name: str
    layer: str
    points: object
    properties: dict
    description: str = ""


def find_crs(scene):
    """Returns the text of the coordinate system of a scene; empty if it has none."""
    array = scene.GetFieldData().GetAbstractArray(CRS)
    return text_from_vtk(array.GetValue(0)) if array and array.GetNumberOfValues() else ""


class Geography:
    """The coordinate system of a scene: its own, or the one that is given for it.

    Raises SettingError for one that is not known, is not in metres, or differs from the scene's.
    """

    def __init__(self, scene, given=None):
        own = find_crs(scene)
        self.text = given or own
        self.system = find_system(self.text)
        if given:
            self._check(own)

    def _check(self, own):
        system = self.system
        if system.problem:
            raise SettingError("{0} {problem}", "crs", problem=system.problem)
        if system.is_geographic or system.unit != 1 or system.height_unit != 1:
            raise SettingError(
                "{0} {label}: has units of {unit}; a scene has metres: give a system in metres",
                "crs",
                label=system.label,
                unit=system.unit_name,
            )
        if own and not system.is_same(own):
            raise SettingError(
                "{0} is {label}, and the scene is in {own}; leave it out",
                "crs",
                label=system.label,
                own=find_system(own).label,
            )

    @property
    def is_known(self):
        return self.system.is_known

    @property
    def label(self):
        """The name of the system for readers of a file; empty without one."""
        return self.system.code or (self.system.name or " ".join(self.text.split()))

    def is_in_degrees(self, places, box):
        """Returns whether places (n x 2) of a file are longitudes and latitudes: they can be, and none
        is in the scene, whose box has two corners."""
        low, high = box
        inside = ((places >= low[:2]) & (places <= high[:2])).all(axis=1)
        return bool(self.is_known and (np.abs(places) <= (180.0, 90.0)).all() and not inside.any())

    def to_degrees(self, points):
        """Returns longitude, latitude on WGS 84 [degrees] and z as it is, of points (n x 3)."""
        return _reproject(points, self.text, WGS84)

    def from_degrees(self, points):
        """Returns x, y [m] of longitudes and latitudes on WGS 84 (n x 2)."""
        flat = np.column_stack([points, np.zeros(len(points))])
        return _reproject(flat, WGS84, self.text)[:, :2]


def _reproject(points, source, target):
    data, coordinates = vtkPolyData(), vtkPoints()
    coordinates.SetData(numpy_to_vtk(np.array(points, dtype=float).reshape(-1, 3), deep=True))
    data.SetPoints(coordinates)
    reproject = vtk_class("vtkHeliosReproject")()
    reproject.SetInputData(data)
    reproject.SetSourceCRS(to_vtk(source))
    reproject.SetTargetCRS(to_vtk(target))
    return vtk_to_numpy(update(reproject).GetPoints().GetData()).copy()


def check_formats(formats):
    """Returns the formats of geo files, a text with commas or names; raises SettingError for others."""
    words = formats.split(",") if isinstance(formats, str) else list(formats)
    words = [str(word).strip().lower() for word in words]
    if words in ([""], ["none"]):
        return ()
    if words == ["all"]:
        return FORMATS
    for word in words:
        if word not in FORMATS:
            raise SettingError(
                "{0} has {word!r}; known: {known}, all, none",
                "geo",
                word=word,
                known=", ".join(FORMATS),
            )
    return tuple(each for each in FORMATS if each in words)


def geo_names(stem):
    """Returns the names of all geo files of a plan."""
    return [f"{stem}.{kind}" for kind in FORMATS]


def write_geo(folder, stem, plan_name, features, table, geography, formats=FORMATS):
    """Writes the geo files of a plan; returns their paths, and why some are not written, or None.

    table
        the text of the CSV.
    """
    texts, missing = {}, []
    degrees = _Degrees(features, geography) if geography.is_known else None
    for kind in formats:
        if kind == "csv":
            texts[f"{stem}.csv"] = table
        elif degrees is None and kind not in WITHOUT_SYSTEM:
            missing.append(kind)
        else:
            texts[f"{stem}.{kind}"] = WRITERS[kind](plan_name, features, degrees, geography.label)
    return write_files(folder, texts), _describe_missing(missing, geography)


def _describe_missing(missing, geography):
    if not missing:
        return None
    names = ", ".join(missing)
    reason = f"is not known ({geography.text[:40]!r})" if geography.text else "is not stated"
    return (
        f"no {names}: these need degrees, and the coordinate system of the scene {reason}; give --crs, "
        "such as --crs EPSG:25832 (crs=)"
    )


class _Degrees:
    """The features of a plan in degrees: converted at once, rounded."""

    def __init__(self, features, geography):
        rings = [ring for each in features for ring in _rings(each)]
        moved = geography.to_degrees(np.concatenate(rings)) if rings else np.zeros((0, 3))
        moved[:, :2] = np.round(moved[:, :2], DIGITS)
        parts = iter(np.split(moved, np.cumsum([len(ring) for ring in rings])[:-1]))
        self._parts = {id(each): [next(parts) for _ in _rings(each)] for each in features}

    def of(self, feature):
        """Returns the rings of an area, or the points of others: longitude, latitude, z."""
        rings = self._parts[id(feature)]
        return rings if feature.kind == "Polygon" else rings[0]


def _rings(feature):
    rings = feature.points if feature.kind == "Polygon" else [feature.points]
    return [np.asarray(ring, dtype=float).reshape(-1, 3) for ring in rings]
