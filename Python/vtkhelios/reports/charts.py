# SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
# SPDX-License-Identifier: BSD-3-Clause
"""The pictures of a report, as PNG. Colours that the colour-blind tell apart, on white."""

import io

import numpy as np

from ..core import packages

BLUE, ORANGE, GREY = "#0072b2", "#d55e00", "#9aa3ab"  # colours of Okabe and Ito's palette
WIDTH, HEIGHT = 5.6, 3.1  # size of a chart [inches]
DOTS = 144  # per inch
COLOURS_OF_STRIPS = ["#b9d3e8", "#7fb2d9", "#3d8dc4", "#0b5a94", "#06335a"]


def load():
    """matplotlib, without a display; ImportError if it cannot be imported."""
    packages.load("matplotlib", "charts need").use("Agg")
    pyplot = packages.load("matplotlib", "charts need", "matplotlib.pyplot")
    pyplot.rcParams.update(
        {
            "font.family": "DejaVu Sans", "font.size": 9, "axes.spines.top": False,
            "axes.spines.right": False, "axes.edgecolor": "#555555", "axes.linewidth": 0.8,
            "axes.grid": True, "axes.axisbelow": True, "grid.color": "#e3e6e9",
            "axes.titlesize": 9, "figure.facecolor": "white",
        }
    )  # fmt: skip
    return pyplot


def to_png(figure, bounds=None):
    """Returns a figure as PNG; bounds="tight": all of what is beside it, too."""
    buffer = io.BytesIO()
    figure.savefig(buffer, format="png", dpi=DOTS, bbox_inches=bounds)
    load().close(figure)
    return buffer.getvalue()


def _figure(width=WIDTH, height=HEIGHT):
    return load().subplots(figsize=(width, height), layout="constrained")


def density_map(raster, paths=()):
    """Returns the points/m², by colour on a logarithmic scale, with platform trajectories."""
    from matplotlib.colors import LogNorm

    density = raster.density()
    shown = np.where(raster.counts > 0, density, np.nan)
    known = density[raster.counts > 0]
    low, high = np.percentile(known, [1, 99.5])
    low, high = max(low, high / 1e4), max(high, low * 1.1)
    if high / low < 3:
        low, high = high / 3, high
    figure, axes = _map_figure(raster)
    image = axes.imshow(
        shown, origin="lower", extent=raster.box, cmap="viridis", interpolation="nearest",
        norm=LogNorm(low, high),
    )  # fmt: skip
    for places in filter(len, paths):
        stands = len(places) == 1 or np.ptp(places[:, :2], axis=0).max() == 0.0
        axes.plot(places[:, 0], places[:, 1], color=ORANGE, linewidth=1.2,
                  marker="^" if stands else None, markersize=8, markeredgecolor="white")  # fmt: skip
    west, east, south, north = raster.box
    axes.set_xlim(west, east)
    axes.set_ylim(south, north)
    _add_scale(figure, axes, image, "points/m²")
    return _finish_map(figure, axes)


def strips_map(raster):
    """Returns the number of scans of each cell."""
    from matplotlib.colors import BoundaryNorm, ListedColormap

    scans = raster.scans()
    most = min(int(scans.max()), len(COLOURS_OF_STRIPS))
    shown = np.where(scans > 0, np.minimum(scans, most), np.nan)
    picked = np.linspace(0, len(COLOURS_OF_STRIPS) - 1, most).round().astype(int)
    colours = ListedColormap([COLOURS_OF_STRIPS[i] for i in picked])
    figure, axes = _map_figure(raster)
    image = axes.imshow(
        shown, origin="lower", extent=raster.box, cmap=colours, interpolation="nearest",
        norm=BoundaryNorm(np.arange(0.5, most + 1), most),
    )  # fmt: skip
    bar = figure.colorbar(image, ax=axes, ticks=range(1, most + 1), shrink=0.8)
    names = [str(i) for i in range(1, most + 1)]
    if scans.max() > most:
        names[-1] += " or more"
    bar.ax.set_yticklabels(names)
    bar.set_label("legs or strips per cell")
    bar.outline.set_visible(False)
    return _finish_map(figure, axes)


def _map_figure(raster):
    west, east, south, north = raster.box
    ratio = (north - south) / (east - west)
    height = min(7.0, max(1.6, 4.4 * ratio + 0.7))
    return _figure(WIDTH, height)


def _add_scale(figure, axes, image, label):
    """The scale of a logarithmic map."""
    from matplotlib.ticker import FuncFormatter, LogLocator

    bar = figure.colorbar(image, ax=axes, shrink=0.8, extend="both")
    bar.locator = LogLocator(subs=(1, 2, 5))
    bar.formatter = FuncFormatter(lambda value, _: f"{value:g}")
    bar.minorticks_off()
    bar.update_ticks()
    bar.set_label(label)
    bar.outline.set_visible(False)


def _finish_map(figure, axes):
    axes.grid(False)
    axes.set_xlabel("x [m]")
    axes.set_ylabel("y [m]")
    axes.set_aspect("equal")
    axes.ticklabel_format(style="plain", useOffset=False)
    axes.xaxis.set_major_locator(_few_ticks())
    axes.yaxis.set_major_locator(_few_ticks())
    return to_png(figure)


def _few_ticks():
    from matplotlib.ticker import MaxNLocator

    return MaxNLocator(5)


def histogram(edges, counts, label, median=None, unit="", log=False):
    """Adjacent bars; the median as a line. Fractions may be on a logarithmic scale."""
    figure, axes = _figure()
    total = max(1, counts.sum())
    axes.bar(
        edges[:-1], 100 * counts / total, np.diff(edges), align="edge", color=BLUE, linewidth=0
    )
    if log:
        from matplotlib.ticker import FuncFormatter

        axes.set_yscale("log")
        axes.yaxis.set_major_formatter(FuncFormatter(lambda value, _: f"{value:g}"))
        axes.yaxis.get_minor_locator().set_params(subs=[])
    axes.set_xlabel(label)
    axes.set_ylabel("fraction of points [%]")
    axes.set_xlim(edges[0], edges[-1])
    axes.grid(axis="x", visible=False)
    if median is not None and np.isfinite(median):
        axes.axvline(median, color=ORANGE, linewidth=1.4)
        near_end = median > (edges[0] + edges[-1]) / 2
        axes.annotate(
            f"median {median:.4g} {unit}".rstrip(), (median, 1.0), xycoords=("data", "axes fraction"),
            xytext=(4 if near_end else -4, 2), textcoords="offset points", color=ORANGE,
            ha="right" if near_end else "left", va="bottom",
        )  # fmt: skip
    return to_png(figure)


def bars(names, values, label, axis_label):
    """One bar per name, with its fraction written at its end."""
    figure, axes = _figure(WIDTH, max(1.5, 0.6 + 0.32 * len(names)))
    total = max(1, sum(values))
    shares = [100 * value / total for value in values]
    places = np.arange(len(names))
    axes.barh(places, shares, color=BLUE, height=0.7)
    for place, share, value in zip(places, shares, values):
        axes.annotate(f"{share:.1f} % ({value:,})", (share, place), xytext=(4, 0),
                      textcoords="offset points", va="center", fontsize=8)  # fmt: skip
    axes.set_yticks(places, names)
    axes.invert_yaxis()
    axes.set_ylabel(label)
    axes.set_xlabel(axis_label)
    axes.set_xlim(0, max(shares) * 1.4 or 1)
    axes.set_xticks([tick for tick in axes.get_xticks() if tick <= 100])
    axes.grid(axis="y", visible=False)
    return to_png(figure)


def two_histograms(edges, first, second, label, names):
    """Fractions of two clouds in the same bins, as steps."""
    figure, axes = _figure()
    for fractions, colour, style, name in zip((first, second), (BLUE, ORANGE), ("-", "--"), names):
        axes.stairs(
            100 * fractions, edges, color=colour, linestyle=style, linewidth=1.4, label=name
        )
    axes.set_xlabel(label)
    axes.set_ylabel("fraction of points [%]")
    axes.set_xlim(edges[0], edges[-1])
    axes.set_ylim(0, None)
    axes.legend(frameon=False)
    return to_png(figure)


def intervals(names, estimates, agreements):
    """Differences over the mean of both values, with their intervals; 0 is agreement."""
    figure, axes = _figure(1.4 * WIDTH, max(1.5, 0.7 + 0.3 * len(names)))
    places = np.arange(len(names))
    axes.axvline(0.0, color=GREY, linewidth=1.0)
    for place, (value, lower, upper), agrees in zip(places, estimates, agreements):
        colour = BLUE if agrees else ORANGE
        axes.plot([100 * lower, 100 * upper], [place, place], color=colour, linewidth=2.2)
        axes.plot(100 * value, place, "o" if agrees else "D", color=colour, markersize=5)
    axes.set_yticks(places, names)
    axes.invert_yaxis()
    axes.set_xlabel("difference B - A over the mean of both [%]")
    axes.set_xscale("symlog", linthresh=1.0)
    axes.xaxis.set_major_formatter(lambda value, _: f"{value:g}")
    axes.grid(axis="y", visible=False)
    return to_png(figure)
