# SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
# SPDX-License-Identifier: BSD-3-Clause
"""A comparison as text, and as a page."""

import math

from ..comparison.result import ROUNDING
from ..core.classes import version
from ..core.words import counted, describe_settings, digits
from . import charts
from .page import load_template, make_figure
from .template import MACROS, STYLE

NAME, CELL = 46, 32
HEADS = ("metric", "A", "B", "difference B - A", "agree", "note")
DISTANCE_HEADS = ("metric", "value", "by chance up to", "agree", "note")
CLASS_HEADS = ("class", *HEADS)
MAXIMUM_CHARS = 60  # longest name of a coordinate system

PAGE = (
    MACROS
    + """\
<!DOCTYPE html>
<html lang="en"><head><meta charset="utf-8">
<meta name="viewport" content="width=device-width, initial-scale=1">
<title>Comparison of two clouds</title><style>{{ style | safe }}</style></head><body>
<h1>Comparison of two clouds</h1>
<p class="lead">By vtkHelios {{ version }}. Values with their 95 % confidence intervals.</p>
{{ table(("", "cloud", "points", "compared", "coordinate system"), clouds, text=(0, 1, 4)) }}
<p><b>Registration:</b> {{ registration }}</p>
{{ charts(overview) }}
<h2>Metrics that do not depend on density</h2>
{{ table(heads, free, text=(0, 4, 5)) }}
<h2>Of both clouds at once</h2>
{{ table(distance_heads, single, text=(0, 3, 4)) }}
<h2>Metrics that depend on density</h2>
{{ table(heads, dense, text=(0, 4, 5)) }}
{% if classes %}<h2>By class</h2>
{{ table(class_heads, classes, text=(0, 1, 5, 6)) }}{% endif %}
{% if histograms %}<h2>Histograms</h2>
{{ charts(histograms) }}<p class="note">The outermost bins also hold the points beyond them.</p>{% endif %}
{% if absent %}<h2>Not measured</h2><ul>{% for each in absent %}<li>{{ each }}</li>{% endfor %}</ul>{% endif %}
{% if notes %}<h2>Notes</h2><ul>{% for each in notes %}<li>{{ each }}</li>{% endfor %}</ul>{% endif %}
<h2>Settings</h2>
{{ table(("", ""), settings, text=(0, 1), hidden=True) }}
<p class="note">Intervals: block bootstrap over tiles of the ground. Neighbouring points are not independent, so that \
whole tiles are drawn, of both clouds at once. One in twenty intervals misses its value by chance.</p>
</body></html>
"""
)


def shown(value, unit=""):
    """Returns a number with four digits; lengths below 0.1 m in mm."""
    if value is None or math.isnan(value):
        return "-"
    if abs(value) < ROUNDING:
        return "0"
    if unit == "m" and abs(value) < 0.1:
        return f"{1e3 * value:.3g} mm"
    return f"{value:.4g}{f' {unit}' if unit else ''}"


def with_ends(estimate, unit):
    """Returns a value and its interval, in one unit."""
    if estimate is None:
        return ""
    text = shown(estimate.value, unit)
    if math.isnan(estimate.lower):
        return text
    if text == "0" and max(abs(end) for end in estimate[1:]) >= ROUNDING:
        text = f"0 {unit}".rstrip()
    factor, digits = (1e3, 3) if text.endswith(" mm") else (1.0, 4)
    ends = (factor * end if abs(end) >= ROUNDING else 0.0 for end in estimate[1:])
    return f"{text} [{', '.join(f'{end:.{digits}g}' for end in ends)}]"


def agreement(row):
    return {True: "yes", False: "no", None: "-"}[row.agrees]


def parts_of(result):
    """Returns the rows: free of density, of both clouds at once, by density, of classes."""
    whole = [row for row in result.rows if row.of_class is None]
    return (
        [row for row in whole if row.a and not row.by_density],
        [row for row in whole if not row.a],
        [row for row in whole if row.a and row.by_density],
        [row for row in result.rows if row.of_class is not None],
    )


def comparison_lines(result):
    """Everything as text."""
    for name, side in (("A", result.a), ("B", result.b)):
        yield f"{name:8} {side['name']}, {side['compared']:,} of {counted(side['points'], 'point')} compared"
    settings = result.settings
    yield (
        f"ground   {counted(settings['tiles'], 'tile')} of {digits(settings['tile_m'])} m, "
        f"{settings['commonTiles']} of them in both; cells of {settings['cell_m']:g} m"
    )
    if settings["sampledShare"] < 1:
        yield f"sample   tiles drawn at random: {100 * settings['sampledShare']:.3g} % of the ground"
    yield f"registration: {result.registration}"
    free, single, dense, classes = parts_of(result)
    yield from _pair_table("metrics that do not depend on density", free)
    yield from _single_table(single)
    yield from _pair_table("metrics that depend on density", dense)
    yield from _pair_table("by class", classes)
    yield ""
    for text in result.absent:
        yield f"not measured: {text}"
    yield "values with 95 % confidence intervals, by a block bootstrap over tiles"


def _pair_table(title, rows):
    if not rows:
        return
    yield ""
    yield f"{title:{NAME}}{'A':{CELL}} {'B':{CELL}} {'B - A':{CELL}} agree"
    for row in rows:
        name = row.name if row.of_class is None else f"{row.of_class:3} {row.name}"
        values = (with_ends(each, row.unit) for each in (row.a, row.b, row.difference))
        yield f"{name:{NAME}}{' '.join(f'{each:{CELL}}' for each in values)} {agreement(row)}"


def _single_table(rows):
    if not rows:
        return
    yield ""
    yield f"{'of both clouds at once':{NAME}}{'value':{CELL}} {'by chance up to':{CELL}} agree"
    for row in rows:
        chance = "" if row.chance is None else shown(row.chance)
        value = with_ends(row.difference, row.unit)
        yield f"{row.name:{NAME}}{value:{CELL}} {chance:{CELL}} {agreement(row)}"


def write_comparison_page(result):
    """Returns the text of the page."""
    free, single, dense, classes = parts_of(result)
    return load_template(PAGE).render(
        style=STYLE,
        version=version(),
        clouds=[_cloud_cells(*each) for each in (("A", result.a), ("B", result.b))],
        registration=result.registration,
        overview=_overview(free),
        heads=HEADS,
        free=[_cells(row) for row in free],
        distance_heads=DISTANCE_HEADS,
        single=[_single_cells(row) for row in single],
        dense=[_cells(row) for row in dense],
        class_heads=CLASS_HEADS,
        classes=[(row.of_class, *_cells(row)) for row in classes],
        histograms=[_histogram(each) for each in result.histograms],
        absent=result.absent,
        notes=result.notes,
        settings=describe_settings(result.settings),
    )


def _cloud_cells(name, side):
    crs = side["coordinateSystem"]
    crs = crs if len(crs) <= MAXIMUM_CHARS else f"{crs[:MAXIMUM_CHARS]}..."
    return name, side["name"], f"{side['points']:,}", f"{side['compared']:,}", crs or "none"


def _cells(row):
    values = (with_ends(each, row.unit) for each in (row.a, row.b, row.difference))
    return row.name, *values, agreement(row), row.note


def _single_cells(row):
    chance = "" if row.chance is None else shown(row.chance)
    return row.name, with_ends(row.difference, row.unit), chance, agreement(row), row.note


def _overview(rows):
    """Returns the differences of all metrics with an interval, over the mean of both values."""
    names, estimates, agreements = [], [], []
    for row in rows:
        scale = 0.5 * abs(row.a.value + row.b.value)
        if row.agrees is not None and scale > 0 and row.unit != "dB":
            names.append(row.name)
            estimates.append([value / scale for value in row.difference])
            agreements.append(row.agrees)
    if not names:
        return []
    png = charts.intervals(names, estimates, agreements)
    note = "blue circles: 0 is in the interval; orange diamonds: it is not"
    return [make_figure("Differences", note, png, "differences of the metrics with intervals")]


def _histogram(each):
    name = each.name.removesuffix(" histogram").replace("height profile", "height")
    label = f"{name} [{each.unit}]" if each.unit else name
    png = charts.two_histograms(each.edges, each.a, each.b, label, ("A", "B"))
    return make_figure(each.name.capitalize(), "", png, f"{each.name} of both clouds")
