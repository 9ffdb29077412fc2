# SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
# SPDX-License-Identifier: BSD-3-Clause
"""Draws the table of BenchRayCasterTrade: speed against range error, lost hits as numbers.

    plot_ray_casters.py table.csv picture.png      (needs python3-matplotlib)
"""

import csv
import sys

import matplotlib

matplotlib.use("Agg")
import matplotlib.pyplot as plt

MARKERS = {"local": "o", "UTM": "s", "geocentric": "^"}
SMALLEST = 1e-16  # m, plotted for an error of 0
LARGEST = 1e-2  # m, plotted if hardly any hit is right


def main(table, picture):
    with open(table, newline="") as file:
        rows = list(csv.DictReader(file))
    scenes = list(dict.fromkeys(row["scene"] for row in rows))[:4]
    casters = list(dict.fromkeys(row["caster"] for row in rows))
    colours = dict(zip(casters, plt.get_cmap("tab20").colors))
    figure, axes = plt.subplots(2, 2, figsize=(11, 8), sharex=True, sharey=True)
    for axis, scene in zip(axes.flat, scenes):
        for row in (row for row in rows if row["scene"] == scene):
            draw(axis, row, colours[row["caster"]])
        axis.set(title=scene, xscale="log", yscale="log")
        axis.grid(alpha=0.3)
    for axis in axes[1]:
        axis.set_xlabel("speed [Mray/s, one thread]")
    for axis in axes[:, 0]:
        axis.set_ylabel("worst range error [m]")
    handles = [plt.Line2D([], [], color=colours[c], marker="o", ls="", label=c) for c in casters]
    handles += [
        plt.Line2D([], [], color="k", marker=m, ls="", mfc="none", label=p)
        for p, m in MARKERS.items()
    ]
    figure.legend(handles=handles, loc="lower center", ncol=5, fontsize=8)
    figure.suptitle(
        "Ray casters: right is faster, lower is better; numbers: wrong hits in 1000 rays"
    )
    figure.tight_layout(rect=(0, 0.09, 1, 1))
    figure.savefig(picture, dpi=80)


def draw(axis, row, colour):
    """One ray caster at one position; filled if ours."""
    speed, error = float(row["mray_per_s"]), max(float(row["worst_range_error_m"]), SMALLEST)
    wrong = sum(int(row[name]) for name in ("missed", "invented", "other_surface"))
    wrong = round(1000 * wrong / int(row["rays"]))
    error = max(error, LARGEST) if wrong > 500 else error
    face = colour if row["kind"] == "ours" else "none"
    axis.plot(speed, error, MARKERS[row["coordinates"]], color=colour, mfc=face, ms=7)
    if wrong:
        axis.annotate(
            str(wrong), (speed, error), fontsize=7, xytext=(5, 3), textcoords="offset points"
        )


if __name__ == "__main__":
    if len(sys.argv) != 3:
        sys.exit(__doc__)
    main(*sys.argv[1:])
