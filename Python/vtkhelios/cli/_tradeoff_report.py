# SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
# SPDX-License-Identifier: BSD-3-Clause
"""The result of a tradeoff as text, and as a picture."""

import math
import re

from ._progress import duration

COLUMNS = (  # title, measure, factor
    ("p50", "rangeP50_m", 1e3),
    ("p95", "rangeP95_m", 1e3),
    ("RMS [mm]", "rangeRms_m", 1e3),
    ("missed [%]", "missed", 1e2),
    ("invented", "invented", 1e2),
    ("amplitude", "amplitudeRms", 1e2),
    ("width [ns]", "widthRms_ns", 1.0),
)
WIDTH = 11
MARK = "~"


def result_lines(result, threads):
    """Everything as text."""
    own = result.reference
    yield (
        f"from     {result.pulses:,} of about {result.pulses_fired:,.0f} pulses; reference: "
        f"{own['subRays']} sub-rays in fine bins, itself within "
        f"{_figure(own['rangeP95_m'].value, 1e3)} mm (p95), "
        f"{_figure(own['missedAndInvented'].value, 1e2)} % of the echoes"
    )
    yield ""
    yield from _table("ways to compute this survey: errors against the reference", result.ways)
    if result.parts:
        yield ""
        yield from _table(
            "what this scene requires: differences from the survey as it is", result.parts
        )
        yield ""
        yield from _part_lines(result)
    yield ""
    yield f"{MARK} less than three times the error of the reference; us: processor time per pulse;"
    yield "range p95 with its 95 % confidence interval; amplitude: RMS, of a full footprint [%]"
    yield ""
    names = ", ".join(row.name for row in result.frontier)
    yield f"none is both faster and more accurate than: {names}"
    base = result.ways[0]
    yield (
        f"the whole survey as it is takes about {duration(result.run_time(base, threads))} with "
        f"{threads} thread{'s'[: threads != 1]}, without loading and writing"
    )


def _table(title, rows):
    yield title
    heads = "".join(f"{head:>{WIDTH}}" for head, _, _ in COLUMNS)
    yield f"{'':26}{heads}{'us':>10}{'p95 from, to [mm]':>22}"
    for row in rows:
        cells = "".join(_cell(row, name, factor) for _, name, factor in COLUMNS)
        p95 = row.errors["rangeP95_m"]
        ends = f"{_figure(p95.lower, 1e3)}, {_figure(p95.upper, 1e3)}"
        yield f"{row.name:26}{cells}{1e6 * row.seconds:>10.3g}{ends:>22}"


def _cell(row, name, factor):
    value = row.errors[name].value
    mark = MARK if name in row.unclear and value > 0 else " "
    return f"{_figure(value, factor):>{WIDTH - 1}}{mark}"


def _figure(value, factor):
    return f"{factor * value:.3g}" if value > 1e-9 else "0"


def _part_lines(result):
    """Each part of the model in one sentence."""
    whole, *others = result.parts
    for row in others:
        errors, unclear = row.errors, row.unclear
        echoes = 100 * (row.echoes / max(1, whole.echoes) - 1)
        changes = []
        if "rangeP95_m" not in unclear:
            changes.append(f"ranges by {_figure(errors['rangeP95_m'].value, 1e3)} mm (p95)")
        if "missedAndInvented" not in unclear:
            lost = _figure(errors["missedAndInvented"].value, 1e2)
            changes.append(f"{lost} % of the echoes (their number by {echoes:+.2g} %)")
        if "amplitudeRms" not in unclear:
            share = _figure(errors["amplitudeRms"].value, 1e2)
            changes.append(f"amplitudes by {share} % of a full footprint")
        change = ", ".join(changes) or "nothing that can be told from the error of the reference"
        cost = 1e6 * (row.seconds - whole.seconds)
        yield f"{row.name} it changes {change}; {cost:+.2g} us per pulse"


KINDS = {  # of ways in the picture: title, marker
    "sub-rays": ("fixed sub-rays", "s"),
    "tolerance": ("tolerances", "o"),
    "survey": ("the survey as it is", "*"),
}


def make_picture(result):
    """Error against time as PNG bytes; ImportError without matplotlib."""
    from . import _charts

    pyplot = _charts.load()
    figure, (left, right) = pyplot.subplots(
        1, 2, figsize=(9.6, 4.2), layout="constrained", sharex=True
    )
    floor = 1e3 * result.reference["rangeP95_m"].value
    for kind in KINDS:
        rows = [row for row in result.ways if row.kind == kind]
        _draw_ways(left, kind, rows, [_range(row) for row in rows])
        _draw_ways(right, kind, rows, [(max(FLOOR, row.score), 0.0, 0.0) for row in rows])
    left.axhline(max(FLOOR, floor), color=_charts.GREY, linewidth=0.8, linestyle=":",
                 label="error of the reference, at most")  # fmt: skip
    if result.noise > 0:
        left.axhline(1e3 * result.noise, color="black", linewidth=0.8, linestyle="--",
                     label="ranging noise of the instrument (1 sigma)")  # fmt: skip
    best = result.frontier
    right.plot([1e6 * row.seconds for row in best], [max(FLOOR, row.score) for row in best],
               color=_charts.GREY, linewidth=1, zorder=2,
               label="none is faster and more accurate")  # fmt: skip
    left.set_ylabel("range error, 95th percentile [mm]")
    right.set_ylabel("largest of range error [mm], missed and\ninvented [%], amplitude error [%]")
    for axes in (left, right):
        axes.set_xscale("log")
        axes.set_yscale("log")
        axes.margins(x=0.12, y=0.12)
        axes.set_xlabel("processor time per pulse [µs]")
        axes.legend(fontsize=7, loc="best", framealpha=0.9)
    left.set_title(result.survey, loc="left")
    return _charts.to_png(figure)


FLOOR = 1e-6  # of a logarithmic axis [mm, %]


def _draw_ways(axes, kind, rows, values):
    """Points with their intervals and names."""
    from . import _charts

    title, marker = KINDS[kind]
    colours = {"sub-rays": _charts.ORANGE, "tolerance": _charts.BLUE}
    colour = colours.get(kind, "black")
    times = [1e6 * row.seconds for row in rows]
    axes.errorbar(
        times, [value for value, _, _ in values],
        yerr=[[low for _, low, _ in values], [high for _, _, high in values]],
        color=colour, marker=marker, markersize=9 if kind == "survey" else 5, linestyle="none",
        elinewidth=0.8, label=title, zorder=3,
    )  # fmt: skip
    named = set()
    for row, time, (value, _, _) in zip(rows, times, values):
        place = round(4 * math.log10(time)), round(3 * math.log10(value))
        if kind != "survey" and place not in named:  # names of near points would overlap
            named.add(place)
            text = re.sub("tolerance | sub-rays?", "", row.name)
            axes.annotate(text, (time, value), xytext=(5, 3), fontsize=7,
                          textcoords="offset points", color=colour)  # fmt: skip


def _range(row):
    """The range error [mm], and the lengths of its interval below and above."""
    p95 = row.errors["rangeP95_m"]
    value = max(FLOOR, 1e3 * p95.value)
    low = max(0.0, min(0.999 * value, value - 1e3 * p95.lower))
    return value, low, max(0.0, 1e3 * p95.upper - value)
