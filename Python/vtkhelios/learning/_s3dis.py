# SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
# SPDX-License-Identifier: BSD-3-Clause
"""The layout of S3DIS (Stanford 3D Indoor Spaces).

Area_1/ROOM/ROOM.txt                     x y z [m], red green blue [0, 255]
Area_1/ROOM/Annotations/CLASS_NUMBER.txt the points of each object: of a class and part

A room is a scan. Coordinates are relative to Area_1/origin.txt, whole metres.
"""

import numpy as np

from ..array_names import CLASSIFICATION_IDS, PART_IDS, RGB
from ._labels import find_intensities
from ._tables import write_table

NAMES = {
    2: "ground", 3: "lowvegetation", 4: "mediumvegetation", 5: "highvegetation", 6: "building",
    9: "water", 10: "rail", 11: "road", 17: "bridge",
}  # fmt: skip
ROW = "%.4f %.4f %.4f %d %d %d"


class S3disWriter:
    """Writes rooms; folder is a Path."""

    def __init__(self, folder, labels, fields):
        self.area, self.fields = folder / "Area_1", fields

    def write(self, scans):
        """Writes all scans; returns their number and the number of points."""
        origin, count, number = None, 0, -1
        for number, scan in enumerate(scans):
            points = scan.arrays["points"]
            origin = np.floor(points.min(axis=0)) if origin is None else origin
            name = f"{scan.leg}_{number:06}"
            room = self.area / name
            (room / "Annotations").mkdir(parents=True)
            rows = np.column_stack([points - origin, _find_colours(scan.arrays)])
            write_table(room / f"{name}.txt", rows, ROW)
            for title, mask in _find_objects(scan.arrays):
                write_table(room / f"Annotations/{title}.txt", rows[mask], ROW)
            count += len(rows)
        write_table(self.area / "origin.txt", origin[np.newaxis], "%.0f")
        return number + 1, count


def _find_objects(arrays):
    """Yields the names as ground_1, and masks: every part of every class."""
    count = len(arrays["points"])
    classes = arrays.get(CLASSIFICATION_IDS, np.zeros(count, int)).astype(int)
    classes[classes == 1] = 0  # neither has a class
    parts = arrays.get(PART_IDS, np.zeros(count, int))
    for key in np.unique(classes):
        name = NAMES.get(int(key), f"class{key}" if key else "clutter")
        for number, part in enumerate(np.unique(parts[classes == key]), 1):
            yield f"{name}_{number}", (classes == key) & (parts == part)


def _find_colours(arrays):
    """RGB, else the intensity as grey."""
    if RGB in arrays:
        return np.rint(255 * np.clip(arrays[RGB], 0, 1))
    return np.rint(255 * find_intensities(arrays))[:, np.newaxis].repeat(3, axis=1)
