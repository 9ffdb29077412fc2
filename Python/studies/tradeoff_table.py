# SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
# SPDX-License-Identifier: BSD-3-Clause
"""The tables of Docs/tradeoff.md from the result of a tradeoff, as Markdown.

    build/bin/vtkhelios tradeoff Data/Surveys/village_als.xml --assets build/demo/scene --output build/demo
    build/venv/bin/python Python/studies/tradeoff_table.py build/demo/village_als/tradeoff.json
"""

import json
import pathlib
import sys

WAYS = {  # title: measure, factor
    "p50 [mm]": ("rangeP50_m", 1e3),
    "p95 [mm]": ("rangeP95_m", 1e3),
    "RMS [mm]": ("rangeRms_m", 1e3),
    "missed [%]": ("missed", 100),
    "invented [%]": ("invented", 100),
    "amplitude [%]": ("amplitudeRms", 100),
    "width [ns]": ("widthRms_ns", 1),
}
PARTS = {
    "position [mm]": ("positionP95_m", 1e3),
    "range [mm]": ("rangeP95_m", 1e3),
    **{title: WAYS[title] for title in list(WAYS)[3:]},
}
HIDDEN = ("ray caster cgal", "ray caster obbtree")  # not on the page: they are compared elsewhere


def main(path):
    result = json.loads(pathlib.Path(path).read_text())
    print_table(result["ways"], WAYS, "way", lambda row: cost(row["us_per_pulse"], row))
    print()
    whole, *parts = result["parts"]
    print_table(parts, PARTS, "part", lambda row: difference(row, whole))
    own = result["reference"]
    print(
        f"\nthe reference itself: {1e3 * own['rangeP95_m'][0]:.2g} mm (p95), "
        f"{100 * own['missedAndInvented'][0]:.2g} % of the echoes; {result['pulses']:,} pulses; "
        f"the whole model: {whole['us_per_pulse']:.3g} us, {whole['memory_bytes'] / 1e6:.3g} MB"
    )


def print_table(rows, columns, title, cost_of):
    print("|", " | ".join([title, *columns, "µs", "MB"]), "|")
    print("|---" * (len(columns) + 3) + "|")
    for row in rows:
        if row["way"] not in HIDDEN:
            cells = [cell(row, *column) for column in columns.values()]
            print("|", " | ".join([row["way"], *cells, *cost_of(row)]), "|")


def cell(row, name, factor):
    """A value; the 95th percentile with its interval."""
    text = figure(row[name], factor)
    if name == "rangeP95_m" and row["kind"] != "part" and row[name] > 0:
        ends = (figure(row[f"{name}_{end}"], factor) for end in ("lower", "upper"))
        text += f" ({', '.join(ends)})"
    return text + ("~" if name in row["unclear"].split() and row[name] > 0 else "")


def figure(value, factor):
    return f"{float(f'{factor * value:.2g}'):g}" if value > 1e-9 else "0"


def cost(microseconds, row):
    return f"{microseconds:.2g}", f"{row['memory_bytes'] / 1e6:.3g}"


def difference(row, whole):
    """Returns costs less the costs of the whole model."""
    time = row["us_per_pulse"] - whole["us_per_pulse"]
    memory = (row["memory_bytes"] - whole["memory_bytes"]) / 1e6
    is_told = abs(time) >= 0.1 * whole["us_per_pulse"]
    return f"{time:+.2g}" if is_told else "0~", f"{memory:+.3g}" if abs(memory) > 0.005 else "0"


if __name__ == "__main__":
    if len(sys.argv) != 2:
        sys.exit(__doc__)
    main(sys.argv[1])
