# SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
# SPDX-License-Identifier: BSD-3-Clause
"""The page of a plan of scan positions, for the field: a single HTML file."""

import math

import numpy as np

from ..array_names import BEST_INCIDENCE_ANGLE, COVERABLE, NUMBER_OF_SCANS
from ..core.classes import version
from ..core.words import counted, digits, noun, time_span
from . import charts, page
from .map_marks import INK, box_of, finish_map, number_place
from .page import make_figure
from .plan_colours import NOT_COVERABLE, SCANS
from .template import MACROS, STYLE

HEADS = (
    "scan", "x [m]", "y [m]", "ground z [m]", "instrument z [m]", "points seen",
    "new points", "seen from here only",
)  # fmt: skip
WIDTH, BAR = 6.4, 1.5  # inches of a map, and of its legend
MARK = charts.ORANGE
MAXIMUM_POINTS = 200_000  # limit of a map
ANGLES = (0, 90)
SETTINGS = {  # settings of the report: name, unit, and the value that does not limit
    "grid_m": ("Candidates every", "m", None),
    "candidates": ("Candidates of", "", None),
    "testGrid_m": ("Points to be seen every", "m", None),
    "region_m": ("Region (x0, x1, y0, y1)", "m", None),
    "height_m": ("Instrument above the ground", "m", None),
    "maxSlope_deg": ("Steepest ground for a tripod", "deg", 90.0),
    "coverage_percent": ("Required coverage", "%", 0.0),
    "objects_percent": ("Required of each object", "%", 0.0),
    "overlap_percent": ("Overlap for registration", "%", 0.0),
    "rangeMin_m": ("Shortest range", "m", 0.0),
    "rangeMax_m": ("Longest range", "m", 1e9),
    "elevationMin_deg": ("Lowest elevation of the beam", "deg", -90.0),
    "elevationMax_deg": ("Highest elevation of the beam", "deg", 90.0),
    "maxIncidence_deg": ("Largest angle of incidence", "deg", 90.0),
    "minDensity_1_m2": ("Least density of a scan", "points/m²", 0.0),
    "order": ("Order of the scans", "", None),
}


def write_page(plan):
    """Returns the text of the page of a Plan. Raises RuntimeError without Jinja2 or matplotlib."""
    try:
        template = page.load_template(MACROS + PAGE)
    except ImportError as error:
        raise RuntimeError(str(error)) from None
    try:
        charts.load()
    except ImportError as error:
        raise RuntimeError(str(error)) from None
    report = plan.report
    return template.render(
        style=STYLE,
        name=plan.name,
        version=version(),
        system=describe_system(plan.geography),
        tiles=_tiles(report),
        maps=_maps(plan),
        times=_times(report),
        heads=HEADS,
        rows=_rows(plan),
        proof=_describe_proof(report["result"]),
        settings=_settings(report),
    )


def describe_system(geography):
    """Returns the coordinate system of a plan, as a sentence."""
    if not geography.is_known:
        return "Coordinates are those of the scene, which states no coordinate system."
    return f"Coordinates are in {geography.system.name or geography.text}."


def _tiles(report):
    result, times = report["result"], report["times"]
    return [
        (f"{result['scans']}", noun(result["scans"], "scan position")),
        (time_span(times["total_s"]), "in the field"),
        (
            f"{result['coverableCoverage_percent']:.1f} %",
            "of the surfaces that can be seen are covered",
        ),
        (f"{result['coverage_percent']:.1f} %", "of all surfaces are covered"),
        (f"{report['scan']['pulseFrequency_Hz'] / 1000:g} kHz", "pulse frequency"),
        (f"{digits(report['scan']['angularStep_deg'], 3)} deg", "between pulses and between lines"),
    ]


def _times(report):
    times, count = report["times"], report["result"]["scans"]
    settings = report["settings"]
    each = times["scan_s"] / count
    speed = digits(settings["walkingSpeed_m_s"], 3)
    return [
        (
            "setting up",
            time_span(times["setup_s"]),
            f"{time_span(settings['setupTime_s'])} for each of {counted(count, 'tripod')}",
        ),
        ("scanning", time_span(times["scan_s"]), f"{time_span(each)} for each"),
        (
            "walking",
            time_span(times["travel_s"]),
            f"{digits(times['way_m'], 3)} m in straight lines in the order of the table, {speed} m/s",
        ),
        ("all", time_span(times["total_s"]), ""),
    ]


def _rows(plan):
    height = plan.task.settings["height"]
    return [
        (
            row["scan"], f"{row['x']:.2f}", f"{row['y']:.2f}", f"{row['z'] - height:.2f}", f"{row['z']:.2f}",
            f"{row['sees']:,}", f"{row['adds']:,}", f"{row['onlyIt']:,}",
        )
        for row in plan.report["positions"]
    ]  # fmt: skip


def _maps(plan):
    points = plan.test_points
    step = -(-len(points) // MAXIMUM_POINTS)
    order = np.argsort(points.points[:, 2], kind="stable")[::step]  # the highest ones on top
    drawn = points.points[order, :2]
    can_be_seen = points[COVERABLE][order] > 0
    number = np.minimum(points[NUMBER_OF_SCANS][order], len(SCANS) - 1)
    colours = np.array([colour for colour, _ in SCANS])[number]
    colours[~can_be_seen] = NOT_COVERABLE
    angles = np.where(can_be_seen, points[BEST_INCIDENCE_ANGLE][order].astype(float), np.nan)
    return [
        _map(
            plan,
            drawn,
            colours,
            "How often surfaces are scanned",
            "number of scans that see a point; from above",
        ),
        _map(
            plan,
            drawn,
            angles,
            "How steeply surfaces are seen",
            "best angle of incidence; 0 deg is perpendicular; white: not seen",
        ),
    ]


def _map(plan, places, colours, title, note):
    """Returns a map of the test points, as a figure of a page; colours: of each, or angles [deg]."""
    box = box_of(places, plan.positions)
    figure, axes = charts.load().subplots(figsize=(WIDTH, _height(box)), layout="constrained")
    size = _mark_size(plan, box)
    if colours.ndim == 2:
        axes.scatter(*places.T, s=size, c=colours, marker="s", linewidths=0)
    else:
        image = axes.scatter(*places.T, s=size, c=colours, marker="s", linewidths=0, cmap="cividis_r",
                             vmin=ANGLES[0], vmax=ANGLES[1], plotnonfinite=False)  # fmt: skip
        bar = figure.colorbar(image, ax=axes, shrink=0.8, ticks=range(0, 91, 15))
        bar.set_label("angle of incidence [deg]")
        bar.outline.set_visible(False)
    _draw_positions(axes, plan)
    finish_map(axes, box)
    if colours.ndim == 2:
        _add_legend(axes, plan)
    return make_figure(
        title, note, charts.to_png(figure, "tight"), f"map: {title.lower()}, tripods numbered"
    )


def _mark_size(plan, box):
    """Returns the area of a mark [points squared], so that marks of a level surface touch."""
    west, east, south, north = box
    step = (
        plan.task.filters.GetTestPoints().GetXStep() or math.dist((west, south), (east, north)) / 20
    )
    width = 72 * (WIDTH - BAR - 1.0) * step / max(east - west, (north - south) / 1.5, 1e-3)
    return float(np.clip(width, 1.0, 40.0)) ** 2


def _height(box):
    """Returns the height of a map [inches]."""
    west, east, south, north = box
    ratio = (north - south) / max(east - west, 1e-3)
    return 1.3 + (WIDTH - BAR - 1.0) * min(max(ratio, 0.25), 1.5)


def _draw_positions(axes, plan):
    places = plan.positions
    order = plan.task.settings["order"]
    if order != "gain":
        way = np.vstack([places, places[:1]]) if order == "round" else places
        axes.plot(*way[:, :2].T, color="white", linewidth=2.6, zorder=4)
        axes.plot(*way[:, :2].T, color=INK, linewidth=1.2, linestyle="--", zorder=5)
    for number, place in enumerate(places):
        number_place(axes, place, str(number), MARK)


def _add_legend(axes, plan):
    from matplotlib.lines import Line2D
    from matplotlib.patches import Patch

    entries = [Patch(color=colour, label=name) for colour, name in SCANS]
    entries.append(Patch(color=NOT_COVERABLE, label="cannot be seen"))
    entries.append(
        Line2D([], [], marker="s", color=MARK, linestyle="", markersize=8, label="tripod")
    )
    if plan.task.settings["order"] != "gain":
        entries.append(Line2D([], [], color=INK, linestyle="--", label="way"))
    axes.legend(
        handles=entries,
        loc="center left",
        bbox_to_anchor=(1.01, 0.5),
        frameon=False,
        title="scans",
        fontsize=8,
    )


def _settings(report):
    """Returns what was asked for, in words; limits that do not limit are left out."""
    settings, scan = report["settings"], report["scan"]
    shown = [("Scanner", _id(scan["scanner"])), ("Platform", _id(scan["platform"]))]
    for key, (name, unit, unlimited) in SETTINGS.items():
        value = settings.get(key)
        if value not in (None, False, unlimited):
            text = digits(value) if isinstance(value, (int, float)) else str(value)
            shown.append((name, f"{text} {unit}".strip()))
    return shown


def _id(reference):
    return reference.rpartition("#")[2]


def _describe_proof(result):
    if result["isProvedOptimal"]:
        return "No plan from these candidates with fewer scans reaches this coverage."
    bound = counted(result["bestBound"], "scan")
    return f"Any plan from these candidates needs at least {bound} for this coverage."


PAGE = """\
<!DOCTYPE html>
<html lang="en"><head><meta charset="utf-8">
<meta name="viewport" content="width=device-width, initial-scale=1">
<title>{{ name }}: scan positions</title><style>{{ style | safe }}</style></head><body>
<h1>{{ name }}</h1>
<p class="lead">Plan of scan positions, made by vtkHelios {{ version }}. {{ system }}</p>
<div class="tiles">{% for value, text in tiles -%}
<div class="tile"><b>{{ value }}</b><span>{{ text }}</span></div>{% endfor %}</div>
<h2>Maps</h2>{{ charts(maps) }}
<p class="note">N is grid north, the y axis of the coordinates.</p>
<h2>Tripods</h2>{{ table(heads, rows) }}
<p class="note">{{ proof }} The instrument is levelled above the ground point.</p>
<h2>Time in the field</h2>{{ table(("", "time", ""), times, (0, 2)) }}
<h2>Settings</h2>{{ table(("setting", "value"), settings, (0, 1)) }}
</body></html>
"""
