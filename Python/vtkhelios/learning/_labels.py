# SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
# SPDX-License-Identifier: BSD-3-Clause
"""Labels, instances and intensities of points."""

import json
import pathlib
import re

import numpy as np

from ..array_names import (
    AMPLITUDE, CLASSIFICATION_IDS, INTENSITY, MATERIAL_IDS, MATERIAL_NAME, ORGAN_IDS, PART_IDS,
    RANGE, REFLECTANCE,
)  # fmt: skip
from ..core.json_files import JsonError, parse_json
from ..formats import FormatError

# Labels of SemanticKITTI by ASPRS class: terrain, vegetation, building, other ground, road, other
# structure.
CLASSES = {2: 72, 3: 70, 4: 70, 5: 70, 6: 50, 9: 49, 10: 49, 11: 40, 17: 52}
# By words in the name of a material, which go before the class: leaf and wood are apart.
MATERIALS = {
    "trunk": 71, "wood": 71, "bark": 71, "stem": 71, "branch": 71, "leaf": 70, "leaves": 70,
    "foliage": 70, "needle": 70,
}  # fmt: skip
ORGANS = {1: "leaf", 2: "wood"}  # words by OrganIds, of echoes without names of materials
MAXIMUM_INSTANCES = 2**16 - 1


class Labels:
    """Labels by class and material.

    classes
        the label of each class; the material or part has the class. Default: SemanticKITTI's.
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
            given = parse_json(pathlib.Path(path).read_bytes())
            if not isinstance(given, dict):
                raise JsonError("is not a table of labels: it is no object")
            classes = {_class(key): label for key, label in _labels(given, "classes")}
            return cls(classes, dict(_labels(given, "materials")))
        except OSError as error:
            raise FormatError(
                f"{path}: cannot be read: {error.strerror}; check its name"
            ) from error
        except JsonError as error:
            raise FormatError(
                f"{path}: {error}; give "
                '{"classes": {"2": 72}, "materials": {"bark": 71}}, labels from 0 to 65535'
            ) from error

    def find(self, arrays, fields):
        """Returns the label of each point, uint16; 0: unlabelled. fields has the names of
        materials."""
        count = len(arrays["points"])
        classes = arrays.get(CLASSIFICATION_IDS, np.zeros(count, int))
        labels = np.zeros(count, np.uint16)
        for key, label in self.classes.items():
            labels[classes == key] = label
        for organ, word in ORGANS.items():
            if ORGAN_IDS in arrays and word in self.materials:
                labels[arrays[ORGAN_IDS] == organ] = self.materials[word]
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


def _labels(given, name):
    """Yields the names and labels of a table; JsonError for one that is not valid, or not known."""
    for unknown in given.keys() - {"classes", "materials"}:
        raise JsonError(f"{_short(unknown)} is unknown")
    table = given.get(name, {})
    if not isinstance(table, dict):
        raise JsonError(f"is not a table of labels: {name} is no object")
    for key, label in table.items():
        if not isinstance(label, int) or isinstance(label, bool) or not 0 <= label <= 65535:
            raise JsonError(f"is not a table of labels: {_short(label)} is no label")
        yield key, label


def _class(key):
    if not re.fullmatch("[0-9]{1,3}", key) or int(key) > 255:
        raise JsonError(f"is not a table of labels: class {_short(key)} is not from 0 to 255")
    return int(key)


def _short(value):
    text = json.dumps(value)
    return text if len(text) <= 60 else f"{text[:60]}..."


def _name_of(fields, number):
    names = fields.GetAbstractArray(MATERIAL_NAME)
    return names.GetValue(number) if names and number < names.GetNumberOfValues() else ""


def find_instances(arrays):
    """Returns the part of each point from 1, 0 without parts; FormatError above 65,535."""
    ids = arrays.get(PART_IDS)
    if ids is None:
        return np.zeros(len(arrays["points"]), np.uint32)
    if len(ids) and ids.max() >= MAXIMUM_INSTANCES:
        raise FormatError(
            f"part {ids.max():,} is beyond the {MAXIMUM_INSTANCES:,} instances of the layout; join parts "
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
