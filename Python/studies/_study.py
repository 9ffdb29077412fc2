# SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
# SPDX-License-Identifier: BSD-3-Clause
"""Shared by the studies: the command line, data of real instruments, tables, figures."""

import argparse
import csv
import os
import pathlib

DEFAULT_DATA = pathlib.Path(__file__).resolve().parents[3] / "shared" / "data"


def real_data():
    """The folder of data of real instruments: real in HELIOS_DATA, by default in shared/data beside the
    checkout. It may be absent."""
    return pathlib.Path(os.environ.get("HELIOS_DATA") or DEFAULT_DATA) / "real"


def arguments(doc):
    """The command line of a study: out, the folder (made), and quick."""
    parser = argparse.ArgumentParser(
        description=doc, formatter_class=argparse.RawDescriptionHelpFormatter
    )
    parser.add_argument("out", metavar="OUT", type=pathlib.Path, help="folder to write to")
    parser.add_argument("--quick", action="store_true", help="seconds instead of minutes")
    found = parser.parse_args()
    found.out.mkdir(parents=True, exist_ok=True)
    return found


def print_table(rows, title=""):
    """Rows (dictionaries with the same keys) as columns of text."""
    names = list(rows[0])
    cells = [names] + [[_text(row[name]) for name in names] for row in rows]
    widths = [max(map(len, column)) for column in zip(*cells)]
    print(f"\n{title}" if title else "")
    for line in cells:
        print("  ".join(text.rjust(width) for text, width in zip(line, widths)))


def write_csv(path, rows):
    """Rows (dictionaries with the same keys) as a CSV file."""
    with open(path, "w", newline="", encoding="utf-8") as file:
        writer = csv.DictWriter(file, list(rows[0]))
        writer.writeheader()
        writer.writerows(rows)


def make_figure(columns=1, rows=1, size=(4.2, 3.4)):
    """A figure and its axes (an array), size [inch] each; without a display."""
    from matplotlib.backends.backend_agg import FigureCanvasAgg
    from matplotlib.figure import Figure

    figure = Figure((columns * size[0], rows * size[1]), layout="constrained")
    FigureCanvasAgg(figure)
    axes = figure.subplots(rows, columns, squeeze=False).ravel()
    for one in axes:
        one.grid(color="0.9")
        one.set_axisbelow(True)
    return figure, axes


def save_figure(figure, path):
    """Writes a PNG at 100 dpi."""
    figure.savefig(path, dpi=100)
    print(f"wrote {path}")


def _text(value):
    return f"{value:.4g}" if isinstance(value, float) else str(value)
