# SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
# SPDX-License-Identifier: BSD-3-Clause
"""The text of the page: the template, the style, the scripts, and the streams of the cloud."""

import base64
import html
import json
import pathlib
import re

import numpy as np

from ..array_names import CLASSIFICATION_IDS, PULSE_IDS
from ..vtkHeliosFiltersCore import vtkHeliosVersion
from ._columns import make_columns, make_scale
from ._octree import build
from ._outline import find_outline
from ._pack import Store, pack_columns
from ._quantise import position_step, quantise_points
from ._waveforms import WaveformSample, link_pulses

FOLDER = pathlib.Path(__file__).parent / "page"
PREFIX = "vtkhelios/"  # prefix of the scripts' names on the page
LICENCE = """\
The page is made by vtkHelios {version}: Copyright (c) The vtkHelios authors, BSD-3-Clause.
It contains twgl.js 7.0.0, under the MIT license:

{twgl}"""


def make_page(arrays, title, *, total=None, crs="", names=None, tables=(), colour_by=None):
    """The HTML text of a page of a cloud.

    arrays
        a dict of numpy arrays of n rows: "points" (n x 3, [m], finite), and the arrays of the points
    title
        the name of the cloud
    total
        the number of points that these are a sample of (default: n)
    crs, names
        the name of the coordinate system, for display, and the names that the numbers in an array stand
        for, by its name: {"PartIds": ["ground", "house"]}
    tables
        waveforms: dicts of the columns and Samples of vtkTables; points refer to them by PulseIds,
        else by WaveformIds, else by GpsTime
    colour_by
        the array of the first view (default: the classes if there are several, else the colours, else
        Height)

    Positions are exact to half a step of 0.1 mm (less for clouds below 10 m, more for those beyond
    200 km). Raises ValueError for a cloud without points, and KeyError for an unknown colour_by.
    """
    points = arrays["points"]
    if len(points) == 0:
        raise ValueError("the cloud has no points")
    pulses, tables = link_pulses(arrays, tables)
    if pulses is not None:
        arrays = {**arrays, PULSE_IDS: pulses}
    columns = make_columns(arrays, names)
    store = Store()
    meta = _pack_points(points, columns, store)
    waves = _pack_waveforms(pulses, tables, store)
    meta |= {
        "title": title, "crs": crs, "total": len(points) if total is None else total,
        "shown": len(points), "columns": [column.describe() for column in columns],
        "waveforms": waves, "lengths": store.lengths, "colourBy": _first(columns, colour_by),
        "licences": licences(),
    }  # fmt: skip
    return _fill(title, meta, store.text())


def licences():
    """The licences of what a page contains."""
    twgl = (FOLDER / "twgl-license.txt").read_text().strip()
    return LICENCE.format(version=vtkHeliosVersion.GetVersion(), twgl=twgl)


def _pack_points(points, columns, store):
    """Adds the octree to the store; returns its description."""
    step = position_step(points)
    steps, corner = quantise_points(points, step)
    nodes, bits = build(steps)
    for node in nodes:
        store.add(pack_columns((steps[node.rows] - node.corner(bits)).T))
        for column in columns:
            store.add(pack_columns([column.codes.values[node.rows]]))
    limits, extremes, _ = make_scale(points[:, 2])
    offsets = steps * step
    return {
        "step": step, "corner": corner, "bits": bits, "outline": find_outline(offsets),
        "box": {"low": offsets.min(axis=0).tolist(), "high": offsets.max(axis=0).tolist()},
        "nodes": [[node.level, *node.place, len(node.rows)] for node in nodes],
        "heights": {"limits": limits, "extremes": extremes},
    }  # fmt: skip


def _pack_waveforms(pulses, tables, store):
    """Adds the waveforms of the pulses to the store; returns their description, None without any."""
    if pulses is None:
        return None
    sample = WaveformSample(pulses)
    for table in tables:
        sample.add(table)
    return sample.pack(store)


def _first(columns, colour_by):
    """Returns the name of the array of the first view."""
    names = ["Height", *(column.name for column in columns)]
    if colour_by is not None:
        if colour_by not in names:
            raise KeyError(f"no array {colour_by}; the cloud has: {', '.join(names)}")
        return colour_by
    classes = next((each for each in columns if each.name == CLASSIFICATION_IDS), None)
    if classes and len(classes.categories) > 1:
        return CLASSIFICATION_IDS
    return next((column.name for column in columns if column.role == "colour"), "Height")


def _fill(title, meta, streams):
    values = {
        "VERSION": vtkHeliosVersion.GetVersion(), "TITLE": html.escape(title),
        "LICENCES": licences().replace("--", "- -"), "STYLE": (FOLDER / "page.css").read_text(),
        "META": _json(meta), "STREAMS": streams, "MODULES": _json({"imports": _modules()}),
    }  # fmt: skip
    page = (FOLDER / "page.html").read_text()
    return re.sub(r"@([A-Z]+)@", lambda found: values[found[1]], page)


def _json(value):
    """JSON within a script element."""
    return json.dumps(value, separators=(",", ":"), default=_number).replace("<", "\\u003c")


def _number(value):
    """Returns a number of numpy."""
    if isinstance(value, np.generic):
        return value.item()
    raise TypeError(f"{value!r} is not a number")


def _modules():
    """Returns the scripts as URLs of data, by the names they have in an import map."""
    return {f"{PREFIX}{path.name}": _url(path) for path in sorted(FOLDER.glob("*.js"))}


def _url(path):
    """Returns a script, which is called by its own name in error messages."""
    script = re.sub(r'from "\./([\w-]+\.js)"', rf'from "{PREFIX}\1"', path.read_text())
    script += f"\n//# sourceURL={PREFIX}{path.name}\n"
    return "data:text/javascript;base64," + base64.b64encode(script.encode()).decode()
