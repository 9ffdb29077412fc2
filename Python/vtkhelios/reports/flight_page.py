# SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
# SPDX-License-Identifier: BSD-3-Clause
"""The page of a flight plan: a single HTML file."""


from ..array_names import NUMBER_OF_STRIPS, PULSE_DENSITY
from ..core.classes import version
from ..core.words import between, counted, describe_settings, digits, noun, time_span
from . import page
from .flight_picture import draw_density, draw_lines, draw_strips, load_charts
from .flight import describe_step
from .page import make_figure
from .plan_page import describe_system
from .template import MACROS, STYLE

HEADS = (
    "line",
    "begin x, y [m]",
    "end x, y [m]",
    "z [m]",
    "heading [deg]",
    "length [m]",
    "time [s]",
)
MAP = (5.6, 4.6)  # inches


def write_page(plan, counts=None):
    """Returns the text of the page; counts: the simulated first returns (Counts), or None. Raises
    RuntimeError without Jinja2 or matplotlib."""
    try:
        template = page.load_template(MACROS + PAGE)
    except ImportError as error:
        raise RuntimeError(str(error)) from None
    check = counts.compare() if counts else None
    return template.render(
        style=STYLE,
        name=plan.name,
        version=version(),
        tiles=_tiles(plan, check),
        maps=_maps(plan, counts),
        heads=HEADS,
        lines=_rows(plan),
        system=describe_system(plan.geography),
        times=_times(plan),
        steps=_steps(plan),
        settings=_settings(plan),
    )


def _tiles(plan, check):
    flight, predicted = plan.report["flight"], plan.report["predicted"]
    tiles = [
        (f"{len(plan)}", noun(len(plan), "flight line")),
        (time_span(flight["time_s"]), "flight time with turns"),
        (f"{flight['speed_m_s']:.1f} m/s", "speed over the ground"),
        (f"{plan.design.pulse_frequency / 1000:g} kHz", "pulse frequency"),
        (f"{predicted['meanOfStrips_1_m2']:.3g} /m²", "predicted mean density of a strip"),
        (f"{predicted['density_1_m2']['mean']:.3g} /m²", "predicted mean density of all strips"),
        (f"{predicted['covered_percent']:.2f} %", "of the area covered"),
    ]
    if plan.design.scan_frequency:
        tiles.insert(4, (f"{plan.design.scan_frequency:.4g} Hz", "scan frequency"))
    if check:
        tiles.append((f"{check['simulated_1_m2']['mean']:.3g} /m²", "simulated mean density"))
        tiles.append(
            (f"{check['empty']:,}", f"of {counted(check['gapCells'], 'cell')} without a return")
        )
    return tiles


def _maps(plan, counts):
    """Returns the maps, as figures of a page."""
    density = plan.cells[PULSE_DENSITY]
    maps = [
        _map(plan, "Predicted pulse density", "lines are numbered in flight order",
             lambda figure, axes: draw_density(figure, axes, plan, density, "")),
        _map(plan, "Strips", f"{plan.cells[NUMBER_OF_STRIPS].min()} or more per cell",
             lambda figure, axes: draw_strips(figure, axes, plan)),
    ]  # fmt: skip
    if counts:
        maps.append(
            _map(plan, "Simulated pulse density",
                 f"first returns in cells of {counts.grid.cell:.3g} m, without noise",
                 lambda figure, axes: _draw_simulated(figure, axes, counts))
        )  # fmt: skip
    return maps


def _draw_simulated(figure, axes, counts):
    simulated = counts.counts / counts.grid.cell**2
    inside = counts.spread_out(simulated)[counts.plan.inside]
    draw_density(figure, axes, counts.plan, inside, "")


def _map(plan, title, note, draw):
    charts = load_charts()
    figure, axes = charts.load().subplots(figsize=MAP, layout="constrained")
    draw(figure, axes)
    draw_lines(axes, plan)
    axes.set_title("")
    return make_figure(title, note, charts.to_png(figure, "tight"), f"map: {title.lower()}")


def _rows(plan):
    return [
        (
            row["line"],
            f"{row['begin'][0]:.2f}, {row['begin'][1]:.2f}",
            f"{row['end'][0]:.2f}, {row['end'][1]:.2f}",
            between(round(row["lowest_m"], 1), round(row["highest_m"], 1), "").strip(),
            f"{row['heading_deg']:.1f}",
            f"{row['length_m']:,.1f}",
            f"{row['time_s']:.1f}",
        )
        for row in plan.lines
    ]


def _times(plan):
    flight = plan.report["flight"]
    lines = flight["lineLength_m"] / flight["speed_m_s"]
    turns = (
        f"{counted(max(len(plan) - 1, 0), 'turn')}, {digits(flight['turnLength_m'] / 1000, 3)} km"
    )
    return [
        (
            "on lines",
            time_span(lines),
            f"{digits(flight['lineLength_m'] / 1000, 3)} km, {flight['speed_m_s']:.1f} m/s",
        ),
        ("in turns", time_span(max(flight["time_s"] - lines, 0.0)), turns),
        ("all", time_span(flight["time_s"]), "without the way to the area and back"),
    ]


def _steps(plan):
    return [
        (f"next {name} pulse frequency", describe_step(step))
        for name, step in plan.report["steps"].items()
    ]


def _settings(plan):
    return describe_settings({**plan.report["settings"], **plan.report["scan"]})


PAGE = """\
<!DOCTYPE html>
<html lang="en"><head><meta charset="utf-8">
<meta name="viewport" content="width=device-width, initial-scale=1">
<title>{{ name }}: flight plan</title><style>{{ style | safe }}</style></head><body>
<h1>{{ name }}</h1>
<p class="lead">Flight plan, made by vtkHelios {{ version }}. {{ system }} Densities are per square metre of the horizontal plane; there is no wind.</p>
<div class="tiles">{% for value, text in tiles -%}
<div class="tile"><b>{{ value }}</b><span>{{ text }}</span></div>{% endfor %}</div>
<h2>Maps</h2>{{ charts(maps) }}
<p class="note">N is grid north, the y axis of the coordinates. Black: the area; orange: flight lines, numbered at their begin.</p>
<h2>Flight lines</h2>{{ table(heads, lines) }}
<h2>Time</h2>{{ table(("", "time", ""), times, (0, 2)) }}
<h2>Other densities</h2>{{ table(("", "cost"), steps, (0, 1)) }}
<h2>Settings</h2>{{ table(("setting", "value"), settings, (0, 1)) }}
</body></html>
"""
