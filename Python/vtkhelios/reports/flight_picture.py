# SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
# SPDX-License-Identifier: BSD-3-Clause
"""Maps of a flight plan: predicted density and strips, with lines and area; needs no display."""

import numpy as np

from ..array_names import NUMBER_OF_STRIPS, PULSE_DENSITY
from ..core.words import counted, time_span
from . import charts
from .map_marks import box_of, finish_map, number_place

SIZE = (12.5, 6.2)  # inches
LINE, EDGE = "#d55e00", "#111111"
STRIPS = ["#b01030", "#b9d3e8", "#7fb2d9", "#3d8dc4", "#0b5a94", "#06335a"]  # 0: a gap
MAXIMUM_NUMBERS = 40  # lines with a number beside them


def make_picture(plan):
    """Returns a PNG of the maps, as bytes. Raises RuntimeError without matplotlib."""
    pyplot = load_charts().load()
    figure, axes = pyplot.subplots(1, 2, figsize=SIZE, layout="constrained", sharey=True)
    draw_density(figure, axes[0], plan, plan.cells[PULSE_DENSITY], "predicted pulse density")
    draw_strips(figure, axes[1], plan)
    for each in axes:
        draw_lines(each, plan)
    axes[1].set_ylabel("")
    figure.suptitle(describe(plan), fontsize=10)
    return load_charts().to_png(figure)


def load_charts():
    """Returns the module of charts; RuntimeError without matplotlib."""
    try:
        charts.load()
    except ImportError as error:
        raise RuntimeError(str(error)) from None
    return charts


def describe(plan):
    design, flight = plan.design, plan.pattern
    return (
        f"{plan.name}: {counted(len(plan), 'line')}, {time_span(flight['time_s'])}; {design.flying_height:.0f} m "
        f"above ground, {design.speed:.1f} m/s, {design.pulse_frequency / 1000:g} kHz"
    )


def draw_density(figure, axes, plan, values, title):
    """A map of densities of the cells of a plan [1/m2]."""
    image = axes.imshow(
        to_map(plan, values), origin="lower", extent=plan.grid.box, cmap="viridis",
        interpolation="nearest", vmin=0.0, vmax=max(float(np.quantile(values, 0.995)), 1e-9),
    )  # fmt: skip
    axes.set_title(title, pad=26)
    bar = figure.colorbar(image, ax=axes, shrink=0.8, extend="max")
    bar.set_label("pulses/m²")
    bar.outline.set_visible(False)


def draw_strips(figure, axes, plan):
    """A map of the number of strips."""
    from matplotlib.colors import BoundaryNorm, ListedColormap

    strips = plan.cells[NUMBER_OF_STRIPS]
    most = min(max(int(strips.max()), 1), len(STRIPS) - 1)
    image = axes.imshow(
        to_map(plan, np.minimum(strips, most)), origin="lower", extent=plan.grid.box,
        cmap=ListedColormap(STRIPS[: most + 1]), interpolation="nearest",
        norm=BoundaryNorm(np.arange(-0.5, most + 1), most + 1),
    )  # fmt: skip
    axes.set_title("strips per cell", pad=26)
    bar = figure.colorbar(image, ax=axes, shrink=0.8, ticks=range(most + 1))
    bar.ax.set_yticklabels([*map(str, range(most)), f"{most}{' or more' * (strips.max() > most)}"])
    bar.outline.set_visible(False)


def draw_lines(axes, plan):
    """Area and flight lines, with their numbers where they begin."""
    for rings in plan.polygons:
        for ring in rings:
            axes.plot(*np.vstack([ring, ring[:1]]).T, color=EDGE, linewidth=1.0)
    for number, places in enumerate(plan.line_waypoints()):
        axes.annotate(
            "", places[-1, :2], places[0, :2],
            arrowprops={"arrowstyle": "-|>", "color": LINE, "linewidth": 1.1, "shrinkA": 0, "shrinkB": 0},
        )  # fmt: skip
        if number < MAXIMUM_NUMBERS:
            number_place(axes, places[0], str(number), LINE)
    west, east, south, north = plan.grid.box
    corners = np.array([(west, south), (east, north)])
    finish_map(axes, box_of(corners, *plan.line_waypoints()))


def to_map(plan, values):
    """Returns the values of cells as an array of the grid; NaN outside the area."""
    shown = np.full(plan.grid.shape, np.nan)
    shown[plan.inside] = values
    return shown
