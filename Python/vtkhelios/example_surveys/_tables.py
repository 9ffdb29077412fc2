# SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
# SPDX-License-Identifier: BSD-3-Clause
"""Tables of the example surveys: CSV files, and places at random."""

import csv
import math
import random


def write_table(path, names, rows):
    """Writes a CSV file; numbers are rounded to 3 decimals, None is empty."""
    with open(path, "w", newline="", encoding="utf-8") as file:
        writer = csv.writer(file, lineterminator="\n")
        writer.writerow(names)
        for row in rows:
            writer.writerow(round(cell, 3) if isinstance(cell, float) else cell for cell in row)


def scatter(count, width, depth, spacing, seed, is_free=lambda x, y: True):
    """Up to count places (x, y) [m] about the origin, at least spacing apart and free.

    The same arguments give the same places. 200 places are tried for each one.
    """
    random_numbers = random.Random(seed)
    places = []
    for _ in range(200 * count):
        x = random_numbers.uniform(-width / 2, width / 2)
        y = random_numbers.uniform(-depth / 2, depth / 2)
        is_apart = all(math.hypot(x - px, y - py) >= spacing for px, py in places)
        if is_apart and is_free(x, y):
            places.append((x, y))
            if len(places) == count:
                break
    return places
