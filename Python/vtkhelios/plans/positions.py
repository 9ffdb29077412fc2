# SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
# SPDX-License-Identifier: BSD-3-Clause
"""The positions of a plan as a table, and as features for maps and receivers."""

import csv
import io

import numpy as np

from .geo import Feature

__all__ = ["make_features", "make_table"]

COLUMNS = (  # columns of the table: title, value of a row, digits
    ("scan", lambda row: row["scan"], 0),
    ("x [m]", lambda row: row["x"], 3),
    ("y [m]", lambda row: row["y"], 3),
    ("ground z [m]", lambda row: row["groundZ"], 3),
    ("instrument z [m]", lambda row: row["z"], 3),
    ("sees", lambda row: row["sees"], 0),
    ("adds", lambda row: row["adds"], 0),
    ("only it", lambda row: row["onlyIt"], 0),
)


def _rows(plan):
    height = plan.task.settings["height"]
    for row in plan.report["positions"]:
        yield {**row, "name": f"scan {row['scan']}", "groundZ": row["z"] - height}


def make_table(plan):
    """Returns the positions as CSV, in the coordinates of the scene, with the name of their system."""
    return to_csv(_rows(plan), COLUMNS, plan.geography.label)


def to_csv(rows, columns, system):
    """Returns rows as CSV; columns: title, value, digits; the last one is the system."""
    text = io.StringIO()
    writer = csv.writer(text, lineterminator="\n")
    writer.writerow([*(title for title, *_ in columns), "crs"])
    for row in rows:
        writer.writerow([*(f"{value(row):.{digits}f}" for _, value, digits in columns), system])
    return text.getvalue()


def make_features(plan):
    """Returns the tripods, and the way between them if their order is one."""
    features = []
    for row in _rows(plan):
        ground = [row["x"], row["y"], row["groundZ"]]
        properties = {
            "scan": row["scan"],
            "groundZ_m": round(row["groundZ"], 4),
            "instrumentZ_m": round(row["z"], 4),
        }
        text = f"ground at {row['groundZ']:.2f} m, instrument at {row['z']:.2f} m; x {row['x']:.3f}, y {row['y']:.3f} m"
        features.append(
            Feature("Point", row["name"], "scans", np.array([ground]), properties, text)
        )
    order = plan.task.settings["order"]
    if order != "gain" and len(features) > 1:
        places = [each.points[0] for each in features]
        places += places[:1] if order == "round" else []
        length = {"length_m": round(plan.report["times"]["way_m"], 3)}
        features.append(Feature("Line", "walk", "route", np.array(places), length))
    return features
