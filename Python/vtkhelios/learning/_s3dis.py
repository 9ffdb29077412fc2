# SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
# SPDX-License-Identifier: BSD-3-Clause
"""The layout of S3DIS (Stanford 3D Indoor Spaces).

Area_1/ROOM/ROOM.txt                     x y z [m], red green blue [0, 255]
Area_1/ROOM/Annotations/CLASS_NUMBER.txt the points of each object: of a class and part

A room is a scan. Coordinates are relative to Area_1/origin.txt, whole metres.
"""

import numpy as np

from ..array_names import CLASSIFICATION_IDS, RGB
from ._tables import write_table

NAMES = {
    2: "ground", 3: "lowvegetation", 4: "mediumvegetation", 5: "highvegetation", 6: "building",
    9: "water", 10: "rail", 11: "road", 17: "bridge",
}  # fmt: skip
# By label of SemanticKITTI, which goes before the class.
LABEL_NAMES = {
    10: "car", 11: "bicycle", 13: "bus", 15: "motorcycle", 16: "train", 18: "truck", 20: "vehicle",
    30: "person", 31: "bicyclist", 32: "motorcyclist", 51: "fence", 80: "pole", 81: "sign",
}  # fmt: skip
LABELS = 1000  # above all classes
ROW = "%.4f %.4f %.4f %d %d %d"


class S3disWriter:
    """Writes rooms; folder is a Path."""

    def __init__(self, folder, content):
        self.area, self.content = folder / "Area_1", content

    def write(self, scans):
        """Writes all scans; returns their number and the number of points."""
        origin, count, number = None, 0, -1
        for number, scan in enumerate(scans):
            points = scan.arrays["points"]
            origin = np.floor(points.min(axis=0)) if origin is None else origin
            name = f"{scan.leg}_{number:06}"
            room = self.area / name
            (room / "Annotations").mkdir(parents=True)
            colours = _find_colours(scan.arrays, self.content)
            rows = np.column_stack([points - origin, colours])
            write_table(room / f"{name}.txt", rows, ROW)
            labels = self.content.find_static_labels(scan.arrays)
            instances = self.content.find_instances(scan.arrays)
            for title, mask in _find_objects(scan.arrays, labels, instances):
                write_table(room / f"Annotations/{title}.txt", rows[mask], ROW)
            count += len(rows)
        write_table(self.area / "origin.txt", origin[np.newaxis], "%.0f")
        return number + 1, count


def _find_objects(arrays, labels, instances):
    """Yields the names as ground_1, and masks: every object of every class, or of a label that has a
    name."""
    count = len(arrays["points"])
    classes = arrays.get(CLASSIFICATION_IDS, np.zeros(count, int)).astype(int)
    classes[classes == 1] = 0  # neither has a class
    kinds = np.where(np.isin(labels, list(LABEL_NAMES)), labels.astype(int) + LABELS, classes)
    for kind in np.unique(kinds):
        unnamed = f"class{kind}" if kind else "clutter"
        name = LABEL_NAMES.get(int(kind) - LABELS) or NAMES.get(int(kind), unnamed)
        for number, instance in enumerate(np.unique(instances[kinds == kind]), 1):
            yield f"{name}_{number}", (kinds == kind) & (instances == instance)


def _find_colours(arrays, content):
    """RGB, else the intensity as grey."""
    if RGB in arrays:
        return np.rint(255 * np.clip(arrays[RGB], 0, 1))
    return np.rint(255 * content.find_intensities(arrays))[:, np.newaxis].repeat(3, axis=1)
