# SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
# SPDX-License-Identifier: BSD-3-Clause
"""Labels, instances and intensities of points."""

import json

import numpy as np

from ..array_names import (
    AMPLITUDE, CLASSIFICATION_IDS, INTENSITY, MATERIAL_IDS, MATERIAL_NAME, PART_IDS, RANGE,
    REFLECTANCE,
)  # fmt: skip
from ..formats import FormatError

# Labels of SemanticKITTI by ASPRS class: terrain, vegetation, building, other ground, road, other
# structure.
CLASSES = {2: 72, 3: 70, 4: 70, 5: 70, 6: 50, 9: 49, 10: 49, 11: 40, 17: 52}
# By words in the name of a material, which go before the class: leaf and wood are apart.
MATERIALS = {
    "trunk": 71, "wood": 71, "bark": 71, "stem": 71, "branch": 71, "leaf": 70, "leaves": 70,
    "foliage": 70, "needle": 70,
}  # fmt: skip
MOST_INSTANCES = 2**16 - 1


class Labels:
    """Labels by class and material.

    classes
        the label of each class, which is that of the material or part. Default: SemanticKITTI's.
    materials
        the label by the id of a material, or by a word in its name; it goes before the class.
    """

    def __init__(self, classes=None, materials=None):
        self.classes = dict(CLASSES if classes is None else classes)
        self.materials = dict(MATERIALS if materials is None else materials)

    @classmethod
    def read(cls, path):
        """Labels of a JSON file: {"classes": {"2": 72}, "materials": {"bark": 71, "3": 70}}."""
        try:
            with open(path, encoding="utf-8") as file:
                given = json.load(file)
            classes = {int(key): _label(value) for key, value in given.pop("classes", {}).items()}
            materials = {key: _label(value) for key, value in given.pop("materials", {}).items()}
        except OSError as error:
            raise FormatError(
                f"{path}: cannot be read: {error.strerror}; check its name"
            ) from error
        except (ValueError, AttributeError, TypeError) as error:
            raise FormatError(
                f"{path}: is not a table of labels: {error}; give "
                '{"classes": {"2": 72}, "materials": {"bark": 71}}, labels from 0 to 65535'
            ) from error
        if given:
            raise FormatError(f"{path}: {next(iter(given))} is unknown; give classes, materials")
        return cls(classes, materials)

    def find(self, arrays, fields):
        """The label of each point, uint16; 0: unlabelled. fields has the names of materials."""
        count = len(arrays["points"])
        classes = arrays.get(CLASSIFICATION_IDS, np.zeros(count, int))
        labels = np.zeros(count, np.uint16)
        for key, label in self.classes.items():
            labels[classes == key] = label
        ids = arrays.get(MATERIAL_IDS)
        for number in () if ids is None else np.unique(ids):
            label = self._find_material(int(number), _name_of(fields, int(number)))
            if label is not None:
                labels[ids == number] = label
        return labels

    def _find_material(self, number, name):
        if str(number) in self.materials:
            return self.materials[str(number)]
        words = (word for word in self.materials if not word.isdigit() and word in name.lower())
        return next((self.materials[word] for word in words), None)


def _label(value):
    if not isinstance(value, int) or isinstance(value, bool) or not 0 <= value <= 65535:
        raise ValueError(f"{value!r} is no label")
    return value


def _name_of(fields, number):
    names = fields.GetAbstractArray(MATERIAL_NAME)
    return names.GetValue(number) if names and number < names.GetNumberOfValues() else ""


def find_instances(arrays):
    """The part of each point from 1, 0 without parts; FormatError above 65,535."""
    ids = arrays.get(PART_IDS)
    if ids is None:
        return np.zeros(len(arrays["points"]), np.uint32)
    if len(ids) and ids.max() >= MOST_INSTANCES:
        raise FormatError(
            f"part {ids.max():,} is beyond the {MOST_INSTANCES:,} instances of the layout; join parts "
            "of the scene"
        )
    return (ids + 1).clip(0).astype(np.uint32)


def find_intensities(arrays):
    """From 0 to 1: the reflectance where stored, else the amplitude corrected for the range.

    The latter is relative to the 99th percentile of the scan, as the gain of a receiver would be;
    without ranges it is the amplitude, or the intensity of 16 bits.
    """
    if REFLECTANCE in arrays:
        return np.clip(10.0 ** (arrays[REFLECTANCE] / 10.0), 0, 1).astype(np.float32)
    if AMPLITUDE in arrays:
        values = arrays[AMPLITUDE] * arrays.get(RANGE, 1.0) ** 2
        full = np.percentile(values, 99) if len(values) else 1.0
        return np.clip(values / (full or 1.0), 0, 1).astype(np.float32)
    full = np.asarray(arrays.get(INTENSITY, np.zeros(len(arrays["points"]))), float)
    return (full / 65535).astype(np.float32)
