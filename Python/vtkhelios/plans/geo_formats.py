# SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
# SPDX-License-Identifier: BSD-3-Clause
"""Texts of GeoJSON (RFC 7946), KML 2.2, GPX 1.1 and DXF (R12) of the features of a plan.

A writer takes the name of the plan, its features, these in degrees (None without a coordinate
system), and the name of the system.
"""

import json
from xml.etree import ElementTree

import numpy as np

__all__ = ["WRITERS"]

KML = "http://www.opengis.net/kml/2.2"
GPX = "http://www.topografix.com/GPX/1/1"
STYLES = {
    "scans": "ff1a5ed5",
    "lines": "ff005ed5",
    "area": "ff111111",
    "route": "ff9aa3ab",
}  # aabbggrr
COLOURS = {"scans": 1, "lines": 30, "area": 7, "route": 8}  # numbers of AutoCAD


def write_geojson(name, features, degrees, system):
    """Returns GeoJSON: longitude and latitude, outer rings counterclockwise; heights are properties,
    since the format has those above the ellipsoid only."""
    items = []
    for each in features:
        places = degrees.of(each)
        if each.kind == "Polygon":
            geometry = {"type": "Polygon", "coordinates": _wind(places)}
        elif each.kind == "Line":
            geometry = {"type": "LineString", "coordinates": places[:, :2].tolist()}
        else:
            geometry = {"type": "Point", "coordinates": places[0, :2].tolist()}
        properties = {"name": each.name, "layer": each.layer, **each.properties}
        items.append({"type": "Feature", "properties": properties, "geometry": geometry})
    collection = {"type": "FeatureCollection", "name": name, "features": items}
    return json.dumps(collection, indent=1, ensure_ascii=False, allow_nan=False) + "\n"


def _wind(rings):
    """Returns closed rings: the first counterclockwise, holes clockwise."""
    closed = []
    for number, ring in enumerate(rings):
        x, y = (ring[:, :2] - ring[:, :2].mean(axis=0)).T
        is_left = np.dot(x, np.roll(y, -1)) > np.dot(np.roll(x, -1), y)
        ring = ring if is_left == (number == 0) else ring[::-1]
        closed.append(np.vstack([ring, ring[:1]])[:, :2].tolist())
    return closed


def write_kml(name, features, degrees, system):
    """Returns KML: points and areas on the ground, lines of flights at their heights."""
    root = ElementTree.Element("kml", xmlns=KML)
    document = _add(root, "Document")
    _add(document, "name", name)
    _add(document, "description", f"Heights are those of the scene ({system}), not converted.")
    for layer in dict.fromkeys(each.layer for each in features):
        style = _add(document, "Style", id=layer)
        _add(_add(style, "IconStyle"), "color", STYLES[layer])
        line = _add(style, "LineStyle")
        _add(line, "color", STYLES[layer])
        _add(line, "width", "2")
        _add(_add(style, "PolyStyle"), "fill", "0")
    for each in features:
        mark = _add(document, "Placemark")
        _add(mark, "name", each.name)
        if each.description:
            _add(mark, "description", each.description)
        _add(mark, "styleUrl", f"#{each.layer}")
        _add_shape(mark, each, degrees.of(each))
    return _to_text(root)


def _add_shape(mark, feature, places):
    if feature.kind == "Polygon":
        polygon = _add(mark, "Polygon")
        for number, ring in enumerate(places):
            side = _add(polygon, "innerBoundaryIs" if number else "outerBoundaryIs")
            closed = np.vstack([ring, ring[:1]])
            _add(_add(side, "LinearRing"), "coordinates", _coordinates(closed[:, :2]))
        return
    shape = _add(mark, "Point" if feature.kind == "Point" else "LineString")
    is_flown = feature.layer == "lines"
    if is_flown:
        _add(shape, "altitudeMode", "absolute")
    elif feature.kind == "Line":
        _add(shape, "tessellate", "1")
    _add(shape, "coordinates", _coordinates(places if is_flown else places[:, :2]))


def _coordinates(places):
    return " ".join(
        ",".join(_number(value, 3 * (i == 2) or 10) for i, value in enumerate(row))
        for row in places
    )


def _number(value, decimals):
    text = f"{value:.{decimals}f}".rstrip("0").rstrip(".")
    return "0" if text == "-0" else text


def write_gpx(name, features, degrees, system):
    """Returns GPX: a waypoint per point; a route of the lines, in their order."""
    root = ElementTree.Element("gpx", version="1.1", creator="vtkHelios", xmlns=GPX)
    _add(_add(root, "metadata"), "name", name)
    for each in features:
        if each.kind == "Point":
            _add_place(root, "wpt", degrees.of(each)[0], each.name, each.description)
    names = [each.name for each in features if each.kind == "Point"]
    lines = [each for each in features if each.kind == "Line"]
    if lines:
        route = _add(root, "rte")
        _add(route, "name", name)
        for each in lines:
            places = degrees.of(each)
            for number, place in enumerate(places):
                stop = names[number % len(names)] if names else _stop(each, number, len(places))
                _add_place(route, "rtept", place, stop)
    return _to_text(root)


def _stop(line, number, count):
    """Returns the name of a point of a flight line."""
    return f"{line.name} {({0: 'begin', count - 1: 'end'}).get(number, number)}"


def _add_place(parent, tag, place, name, description=""):
    at = _add(parent, tag, lat=_number(place[1], 10), lon=_number(place[0], 10))
    _add(at, "ele", _number(place[2], 3))
    _add(at, "name", name)
    if description:
        _add(at, "desc", description)


def _add(parent, tag, text=None, **attributes):
    element = ElementTree.SubElement(parent, tag, attributes)
    element.text = None if text is None else _clean(text)
    return element


def _clean(text):
    """Returns a text without the control characters that XML cannot have."""
    return "".join(each for each in text if each >= " " or each in "\t\n")


def _to_text(root):
    ElementTree.indent(root)
    return '<?xml version="1.0" encoding="UTF-8"?>\n' + ElementTree.tostring(root, "unicode") + "\n"


def write_dxf(name, features, degrees, system):
    """Returns DXF of AutoCAD R12, in the coordinates of the scene: a layer per kind of feature, and the
    names of points and lines as texts."""
    places = [
        ring
        for each in features
        for ring in (each.points if each.kind == "Polygon" else [each.points])
    ]
    low, high = (find(np.concatenate(places), axis=0) for find in (np.min, np.max))
    height = max(0.5, 0.01 * float(np.hypot(*(high - low)[:2])))  # height of texts [m]
    system = f"coordinates: {system or 'of the scene, no coordinate system'} [m]"
    pairs = [
        (999, f"vtkHelios plan {name}"),
        (999, system),
        (0, "SECTION"),
        (2, "HEADER"),
        (9, "$ACADVER"),
        (1, "AC1009"),
    ]
    for key, corner in (("$EXTMIN", low), ("$EXTMAX", high)):
        pairs += [(9, key), *_at(corner)]
    layers = dict.fromkeys(each.layer for each in features)
    pairs += [
        (0, "ENDSEC"),
        (0, "SECTION"),
        (2, "TABLES"),
        (0, "TABLE"),
        (2, "LAYER"),
        (70, len(layers)),
    ]
    for layer in layers:
        pairs += [(0, "LAYER"), (2, layer), (70, 0), (62, COLOURS[layer]), (6, "CONTINUOUS")]
    pairs += [(0, "ENDTAB"), (0, "ENDSEC"), (0, "SECTION"), (2, "ENTITIES")]
    for each in features:
        pairs += _entities(each, height)
    pairs += [(0, "ENDSEC"), (0, "EOF")]
    return "".join(f"{code}\n{_one_line(value)}\n" for code, value in pairs)


def _entities(feature, height):
    layer = [(8, feature.layer)]
    if feature.kind == "Point":
        yield from [(0, "POINT"), *layer, *_at(feature.points[0])]
    for ring in feature.points if feature.kind == "Polygon" else [feature.points]:
        if len(ring) > 1:
            closed = 1 if feature.kind == "Polygon" else 0
            yield from [(0, "POLYLINE"), *layer, (66, 1), (70, 8 + closed), *_at((0, 0, 0))]
            for corner in ring:
                yield from [(0, "VERTEX"), *layer, (70, 32), *_at(corner)]
            yield from [(0, "SEQEND"), *layer]
    if feature.kind != "Polygon" and feature.layer != "route":
        yield from [
            (0, "TEXT"),
            *layer,
            *_at(feature.points[0]),
            (40, f"{height:.3f}"),
            (1, feature.name),
        ]


def _at(corner):
    return [(10 * (axis + 1), f"{value:.4f}") for axis, value in enumerate(corner)]


def _one_line(value):
    """Returns a text in ASCII on one line; others as DXF writes them."""
    return "".join(
        each if " " <= each <= "~" else f"\\U+{ord(each):04X}" if each > "~" else " "
        for each in str(value)
    )


WRITERS = {"geojson": write_geojson, "kml": write_kml, "dxf": write_dxf, "gpx": write_gpx}
