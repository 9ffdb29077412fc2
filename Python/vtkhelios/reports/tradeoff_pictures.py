# SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
# SPDX-License-Identifier: BSD-3-Clause
"""The pictures of a tradeoff as PNG bytes; ImportError without matplotlib."""

import math
import re

from ..surveys.accuracy import POSITION
from ..surveys.tradeoff import TOLD
from . import charts

GREEN, PURPLE = "#009e73", "#7a4fa3"
FLOOR = 1e-6  # start of a logarithmic axis [mm, %]
# styles of ways: kind, a part of the name, title, colour, marker, whether they are named
GROUPS = (
    ("sub-rays", "", "fixed sub-rays, circles", charts.ORANGE, "s", True),
    ("pattern", "Vogel", "fixed sub-rays, Vogel's spiral", GREEN, "^", False),
    ("pattern", "Gauss", "fixed sub-rays, Gauss-Legendre", PURPLE, "v", False),
    ("tolerance", "", "tolerances", charts.BLUE, "o", True),
    ("mesh", "", "simplified meshes", charts.GREY, "D", True),
    ("survey", "", "the survey as it is", "black", "*", False),
)
ECHO_CHANGES = ("missed", "invented")


def make_picture(result):
    """Error against time."""
    pyplot = charts.load()
    figure, (left, right) = pyplot.subplots(1, 2, figsize=(9.6, 4.8), sharex=True)
    figure.subplots_adjust(left=0.07, right=0.985, bottom=0.25, top=0.94, wspace=0.22)
    for kind, word, *style in GROUPS:
        rows = [row for row in result.ways if row.kind == kind and word in row.name]
        if rows:
            _draw_ways(left, rows, [_range(row) for row in rows], *style)
            scores = [(max(FLOOR, row.score), 0.0, 0.0) for row in rows]
            _draw_ways(right, rows, scores, *style)
    floor = 1e3 * result.reference["rangeP95_m"].value
    left.axhline(max(FLOOR, floor), color=charts.GREY, linewidth=0.8, linestyle=":",
                 label="error of the reference, at most")  # fmt: skip
    if result.noise > 0:
        left.axhline(1e3 * result.noise, color="black", linewidth=0.8, linestyle="--",
                     label="ranging noise of the instrument (1 sigma)")  # fmt: skip
    best = result.frontier
    right.plot([1e6 * row.seconds for row in best], [max(FLOOR, row.score) for row in best],
               color=charts.GREY, linewidth=1, zorder=2,
               label="none is faster and more accurate")  # fmt: skip
    left.set_ylabel("range error, 95th percentile [mm]")
    right.set_ylabel("largest of range error [mm], missed and\ninvented [%], amplitude error [%]")
    for axes in (left, right):
        axes.set_xscale("log")
        axes.set_yscale("log")
        axes.margins(x=0.12, y=0.12)
        axes.set_xlabel("processor time per pulse [µs]")
    handles = {}
    for axes in (left, right):
        for handle, label in zip(*axes.get_legend_handles_labels()):
            handles.setdefault(label, handle)
    figure.legend(handles.values(), handles, fontsize=7, loc="lower center", ncol=3, frameon=False)
    left.set_title(result.survey, loc="left")
    return charts.to_png(figure)


def _draw_ways(axes, rows, values, title, colour, marker, is_named):
    """Points with their intervals and names."""
    times = [1e6 * row.seconds for row in rows]
    axes.errorbar(
        times, [value for value, _, _ in values],
        yerr=[[low for _, low, _ in values], [high for _, _, high in values]],
        color=colour, marker=marker, markersize=9 if marker == "*" else 5, linestyle="none",
        elinewidth=0.8, label=title, zorder=3,
    )  # fmt: skip
    named = set()
    for row, time, (value, _, _) in zip(rows, times, values):
        place = round(4 * math.log10(time)), round(3 * math.log10(value))
        if is_named and place not in named:  # names of near points would overlap
            named.add(place)
            text = re.sub("tolerance | sub-rays?|mesh within ", "", row.name)
            axes.annotate(text, (time, value), xytext=(5, 3), fontsize=7,
                          textcoords="offset points", color=colour, zorder=5)  # fmt: skip


def _range(row):
    """Returns the range error [mm], and the lengths of its interval below and above."""
    p95 = row.errors["rangeP95_m"]
    value = max(FLOOR, 1e3 * p95.value)
    low = max(0.0, min(0.999 * value, value - 1e3 * p95.lower))
    return value, low, max(0.0, 1e3 * p95.upper - value)


def make_parts_picture(result):
    """Draws the changes by each part of the model and of the scene, and their cost."""
    pyplot = charts.load()
    whole, *rows = result.parts
    figure, panels = pyplot.subplots(
        1, 4, figsize=(9.6, 1.2 + 0.28 * len(rows)), layout="constrained", sharey=True
    )
    places = range(len(rows))
    columns = (
        ("position [mm, p95]", [1e3 * row.errors[POSITION].value for row in rows], charts.BLUE),
        ("amplitude [%, RMS]", [100 * row.errors["amplitudeRms"].value for row in rows], PURPLE),
        ("echoes missed, invented [%]", None, None),
        ("costs [µs per pulse]", [_cost(row, whole) for row in rows], GREEN),
    )
    for axes, (title, values, colour) in zip(panels, columns):
        if values is None:
            _draw_echoes(axes, places, rows)
        else:
            axes.barh(places, values, color=colour)
            for place, value in zip(places, values):
                _name_bar(axes, place, value)
        axes.set_title(title, fontsize=8)
        if title.startswith("position"):
            axes.set_xscale("symlog", linthresh=1.0, linscale=0.5)
            axes.set_xlim(left=0.0)
        axes.tick_params(labelsize=7)
        axes.margins(x=0.25)
        for side in ("top", "right"):
            axes.spines[side].set_visible(False)
    panels[0].set_yticks(places, [row.name for row in rows])
    panels[0].invert_yaxis()
    figure.suptitle(
        f"{result.survey}: what changes without a part of the model or of the scene",
        fontsize=9, x=0.01, ha="left",
    )  # fmt: skip
    return charts.to_png(figure)


def _cost(row, whole):
    """Returns the time that a part takes [us]; 0 where it cannot be told."""
    seconds = whole.seconds - row.seconds
    return 1e6 * seconds if abs(seconds) >= TOLD * whole.seconds else 0.0


def _draw_echoes(axes, places, rows):
    """Missed and invented echoes, one after the other."""
    start = [0.0] * len(rows)
    for name, colour in zip(ECHO_CHANGES, (charts.ORANGE, "#e69f00")):
        values = [100 * row.errors[name].value for row in rows]
        axes.barh(places, values, left=start, color=colour, label=name)
        start = [before + value for before, value in zip(start, values)]
    for place, value in zip(places, start):
        _name_bar(axes, place, value)
    axes.legend(fontsize=6, loc="lower right", frameon=False)


def _name_bar(axes, place, value):
    text = f"{value:#.3g}".rstrip(".") if abs(value) >= 5e-4 else "0"
    axes.annotate(text, (max(0.0, value), place), xytext=(2, 0), fontsize=6, va="center",
                  textcoords="offset points")  # fmt: skip
