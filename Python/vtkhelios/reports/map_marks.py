# SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
# SPDX-License-Identifier: BSD-3-Clause
"""Furniture of the map of a plan: north, a scale bar, axes in metres."""

import math

import numpy as np

from ..core.words import digits

INK = "#1d2329"


def finish_map(axes, box, pad=0.03):
    """Sets the limits of a map to a box (west, east, south, north) and adds axes, north and scale."""
    from matplotlib.ticker import MaxNLocator

    west, east, south, north = box
    size = max(east - west, north - south, 1e-3)
    middle = (west + east) / 2, (south + north) / 2
    for set_limits, centre, extent in (
        (axes.set_xlim, middle[0], east - west), (axes.set_ylim, middle[1], north - south)
    ):  # fmt: skip
        half = max(extent, 0.25 * size) / 2 + pad * size
        set_limits(centre - half, centre + half)
    axes.grid(False)
    axes.set_aspect("equal")
    axes.set_xlabel("x [m]")
    axes.set_ylabel("y [m]")
    axes.ticklabel_format(style="plain", useOffset=False)
    axes.xaxis.set_major_locator(MaxNLocator(4))
    axes.yaxis.set_major_locator(MaxNLocator(5))
    _add_north(axes)
    _add_scale_bar(axes)


def _add_north(axes):
    """The arrow of grid north, +y, above the map at its right end."""
    axes.annotate(
        "", (0.985, 1.11), (0.985, 1.01), xycoords="axes fraction", annotation_clip=False,
        arrowprops={"arrowstyle": "-|>", "color": INK, "linewidth": 1.4, "shrinkA": 0, "shrinkB": 0},
    )  # fmt: skip
    axes.text(0.955, 1.06, "N", transform=axes.transAxes, ha="right", va="center", fontsize=10,
              fontweight="bold", color=INK)  # fmt: skip


def _add_scale_bar(axes):
    """A bar of a round length, above the map at its left end."""
    low, high = axes.get_xlim()
    length = round_length(0.3 * (high - low))
    share = length / (high - low)
    axes.plot([0.01, 0.01 + share], [1.035, 1.035], transform=axes.transAxes, color=INK, linewidth=3,
              solid_capstyle="butt", clip_on=False)  # fmt: skip
    axes.text(0.01 + share / 2, 1.055, describe_length(length), transform=axes.transAxes, ha="center",
              va="bottom", fontsize=8, color=INK)  # fmt: skip


def round_length(most):
    """Returns the largest of 1, 2 and 5 times a power of ten up to a length."""
    power = 10.0 ** math.floor(math.log10(most))
    return max(each * power for each in (1, 2, 5) if each * power <= most * (1 + 1e-9))


def describe_length(metres):
    return f"{digits(metres / 1000)} km" if metres >= 1000 else f"{digits(metres)} m"


def number_place(axes, place, text, colour):
    """A number in a coloured box on a map."""
    axes.text(*place[:2], text, color="white", fontsize=8, fontweight="bold", ha="center", va="center",
              zorder=6, bbox={"boxstyle": "round,pad=0.25", "fc": colour, "ec": "white", "lw": 0.8})  # fmt: skip


def box_of(*points):
    """Returns west, east, south and north of points (n x 2 or more)."""
    places = np.concatenate([np.asarray(each)[:, :2] for each in points])
    (west, south), (east, north) = places.min(axis=0), places.max(axis=0)
    return west, east, south, north
