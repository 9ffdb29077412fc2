# SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
# SPDX-License-Identifier: BSD-3-Clause
"""Draws the table of BenchScannerTrade: error against time per pulse, one column per scene.

    plot_scanner_trade.py table.csv picture.png      (needs python3-matplotlib)
"""

import csv
import math
import sys

import matplotlib

matplotlib.use("Agg")
import matplotlib.pyplot as plt

COLOURS = {"GL": "tab:blue", "circles": "tab:orange", "Vogel": "tab:green", "tolerance": "tab:red"}
NAMES = {"tolerance": "adaptive"}
MARKERS = {"peaks": "o", "gaussians": "s"}
ERRORS = {"range_rms_m": "range RMS [m]", "amplitude_rms": "amplitude RMS"}
SMALLEST = 1e-6  # lower values are clipped
LIGHT = 0.299792458  # m/ns
SHIFT = LIGHT * 0.25 / (4 * math.sqrt(3))  # RMS error of the largest bin of 0.25 ns
NOISE = 0.2075 / 50  # Cramer-Rao bound for a signal-to-noise ratio of 50, 4 ns, 1 ns


def main(table, picture):
    with open(table, newline="") as file:
        rows = list(csv.DictReader(file))
    scenes = list(dict.fromkeys(row["scene"] for row in rows))
    figure, axes = plt.subplots(
        2, len(scenes), figsize=(3.2 * len(scenes), 8), squeeze=False, sharex=True
    )
    for column, scene in zip(axes.T, scenes):
        own = [row for row in rows if row["scene"] == scene]
        for axis, error in zip(column, ERRORS):
            draw(axis, own, error)
        column[0].set_title(scene)
        column[1].set_xlabel("time [us/pulse, one thread]")
        for height, text in ((SHIFT, "largest bin of 0.25 ns"), (NOISE, "noise, SNR 50")):
            column[0].axhline(height, color="k", ls=":", lw=0.7)
            column[0].annotate(
                text, (0.02, height), xycoords=("axes fraction", "data"), fontsize=6, va="bottom"
            )
    for axis, label in zip(axes[:, 0], ERRORS.values()):
        axis.set_ylabel(label)
    handles = [
        plt.Line2D([], [], color=c, marker="o", ls="", label=NAMES.get(p, p))
        for p, c in COLOURS.items()
    ]
    handles += [
        plt.Line2D([], [], color="k", marker=m, ls="", mfc="none", label=d)
        for d, m in MARKERS.items()
    ]
    figure.legend(handles=handles, loc="lower center", ncol=6, fontsize=8)
    figure.suptitle(
        "Left is faster, lower is better; joined: Pareto front; dashed: the reference itself; "
        "numbers: missed + extra echoes [%]"
    )
    figure.tight_layout(rect=(0, 0.04, 1, 0.98))
    figure.savefig(picture, dpi=80)


def draw(axis, rows, error):
    """One scene; hollow if bins are not 0.25 ns."""
    points = []
    for row in rows:
        time, wrong = float(row["us_per_pulse"]), max(float(row[error]), SMALLEST)
        if time <= 0:
            axis.axhline(wrong, color="k", ls="--", lw=0.8)
            continue
        colour = COLOURS[row["pattern"]]
        face = colour if float(row["bin_ns"]) == 0.25 else "none"
        axis.plot(time, wrong, MARKERS[row["detector"]], color=colour, mfc=face, ms=6)
        lost = float(row["missed_pct"]) + float(row["extra_pct"])
        if lost >= 0.05:
            axis.annotate(
                f"{lost:.2g}", (time, wrong), fontsize=6, xytext=(4, 3), textcoords="offset points"
            )
        points.append((time, wrong))
    best = [
        p
        for p in sorted(points)
        if not any(q[0] <= p[0] and q[1] <= p[1] and q != p for q in points)
    ]
    axis.plot(*zip(*best), color="0.6", lw=1, zorder=0)
    axis.set(xscale="log", yscale="log")
    axis.grid(alpha=0.3)


if __name__ == "__main__":
    if len(sys.argv) != 3:
        sys.exit(__doc__)
    main(*sys.argv[1:])
