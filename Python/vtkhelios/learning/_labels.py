# SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
# SPDX-License-Identifier: BSD-3-Clause
"""Labels of points, by class, material, part and motion."""

import json
import pathlib
import re

import numpy as np

from ..array_names import (
    CLASSIFICATION_IDS, MATERIAL_IDS, MATERIAL_NAME, ORGAN_IDS, PART_IDS,
)  # fmt: skip
from ..core.json_files import JsonError, parse_json
from ..formats import FormatError, Header

# Labels of SemanticKITTI by ASPRS class: terrain, vegetation, building, outlier, other ground, road,
# other structure.
CLASSES = {2: 72, 3: 70, 4: 70, 5: 70, 6: 50, 7: 1, 9: 49, 10: 49, 11: 40, 17: 52, 18: 1}
# By words in the name of a material, which go before the class: leaf and wood are apart.
MATERIALS = {
    "trunk": 71, "wood": 71, "bark": 71, "stem": 71, "branch": 71, "leaf": 70, "leaves": 70,
    "foliage": 70, "needle": 70,
}  # fmt: skip
ORGANS = {1: "leaf", 2: "wood"}  # words by OrganIds, of echoes without names of materials
# By words in the name of a part, which go before the material; the first that it has counts.
PARTS = {
    "bicyclist": 31, "cyclist": 31, "motorcyclist": 32, "motorcycle": 15, "motorbike": 15,
    "bicycle": 11, "bike": 11, "bus": 13, "tram": 16, "train": 16, "truck": 18, "lorry": 18,
    "car": 10, "van": 20, "trailer": 20, "vehicle": 20, "person": 30, "pedestrian": 30,
    "sign": 81, "pole": 80, "post": 80, "lamp": 80, "fence": 51, "building": 50, "house": 50,
    "road": 40, "parking": 44, "sidewalk": 48, "pavement": 48, "tree": 70, "bush": 70, "shrub": 70,
    "hedge": 70, "vegetation": 70,
}  # fmt: skip
# Labels of parts that move, by the label at rest.
MOVING = {10: 252, 31: 253, 30: 254, 32: 255, 16: 256, 13: 257, 18: 258, 20: 259}
VEGETATION = 70  # parts of this label keep the labels of their materials
TABLES = ("classes", "materials", "parts", "moving")
EXAMPLE = '{"classes": {"2": 72}, "materials": {"bark": 71}, "parts": {"car": 10}}'


class Labels:
    """Labels by class, material, part and motion; tables extend the defaults, SemanticKITTI's.

    classes
        the label of each class; the material or part has the class.
    materials
        the label by the id of a material, or by a word in its name; it goes before the class.
    parts
        the label by the id of a part, its name, or a word in it; it goes before the material, unless
        it is vegetation. A part without one has that of the part that carries it.
    moving
        the label of what moves, by its label at rest.
    """

    def __init__(self, classes=None, materials=None, parts=None, moving=None):
        self.classes = _extend(CLASSES, classes)
        self.materials = _extend(MATERIALS, materials)
        self.parts = _extend(PARTS, parts)
        self.moving = _extend(MOVING, moving)

    @classmethod
    def read(cls, path):
        """Labels of a JSON file: {"classes": {"2": 72}, "parts": {"car": 10}, "moving": {"10": 252}}."""
        try:
            given = parse_json(pathlib.Path(path).read_bytes())
            if not isinstance(given, dict):
                raise JsonError("is not a table of labels: it is no object")
            tables = {name: dict(_labels(given, name)) for name in TABLES}
            tables["classes"] = {_number(k, "class", 255): v for k, v in tables["classes"].items()}
            tables["moving"] = {_number(k, "label", 65535): v for k, v in tables["moving"].items()}
            return cls(**tables)
        except OSError as error:
            raise FormatError(
                f"{path}: cannot be read: {error.strerror}; check its name"
            ) from error
        except JsonError as error:
            raise FormatError(f"{path}: {error}; give {EXAMPLE}, labels from 0 to 65535") from error

    def find(self, arrays, fields, parts=None):
        """Returns the label of each point at rest, uint16; 0: unlabelled. fields has the names of
        materials; parts (see Parts) those of parts."""
        count = len(arrays["points"])
        classes = arrays.get(CLASSIFICATION_IDS, np.zeros(count, int))
        labels = np.zeros(count, np.uint16)
        for key, label in self.classes.items():
            labels[classes == key] = label
        ids, names = arrays.get(MATERIAL_IDS), Header(fields).texts(MATERIAL_NAME)
        has_material = np.zeros(count, bool)
        for organ, word in ORGANS.items():
            if ORGAN_IDS in arrays and word in self.materials:
                chosen = arrays[ORGAN_IDS] == organ
                labels[chosen], has_material[chosen] = self.materials[word], True
        for number in () if ids is None else np.unique(ids):
            label = self._find_material(int(number), _name_of(names, int(number)))
            if label is not None:
                chosen = ids == number
                labels[chosen], has_material[chosen] = label, True
        ids = arrays.get(PART_IDS)
        for number in () if ids is None or parts is None else np.unique(ids):
            label = self.find_part(int(number), parts)
            if label is not None:
                chosen = ids == number
                labels[chosen & ~has_material if label == VEGETATION else chosen] = label
        return labels

    def find_moving(self, labels, moves):
        """Returns the labels, of points that move in place of those at rest."""
        changed = labels.copy()
        for label, moving in self.moving.items():
            changed[moves & (labels == label)] = moving
        return changed

    def find_part(self, number, parts):
        """Returns the label of a part, by its name or that of its carriers; None: it has none."""
        for each in parts.carriers_of(number):
            name = _name_of(parts.names, each)
            for key in (str(each), name, name.lower()):
                if key and key in self.parts:
                    return self.parts[key]
            words = _words_of(name)
            label = next((self.parts[word] for word in self.parts if word in words), None)
            if label is not None:
                return label
        return None

    def _find_material(self, number, name):
        if str(number) in self.materials:
            return self.materials[str(number)]
        words = (word for word in self.materials if not word.isdigit() and word in name.lower())
        return next((self.materials[word] for word in words), None)


def _extend(defaults, given):
    """Returns a table with the given labels first, then the defaults that it does not have."""
    given = dict(given or {})
    return {**given, **{key: label for key, label in defaults.items() if key not in given}}


def _words_of(name):
    """Returns the words of a name in lower case, as redCar_01 -> red, car; also in the singular."""
    words = {word.lower() for word in re.findall("[A-Z]?[a-z]+|[A-Z]+", name)}
    return words | {word[:-1] for word in words if word.endswith("s")}


def _labels(given, name):
    """Yields the names and labels of a table; JsonError for one that is not valid, or not known."""
    for unknown in given.keys() - set(TABLES):
        raise JsonError(f"{_short(unknown)} is unknown")
    table = given.get(name, {})
    if not isinstance(table, dict):
        raise JsonError(f"is not a table of labels: {name} is no object")
    for key, label in table.items():
        if not isinstance(label, int) or isinstance(label, bool) or not 0 <= label <= 65535:
            raise JsonError(f"is not a table of labels: {_short(label)} is no label")
        yield key, label


def _number(key, what, most):
    if not re.fullmatch("[0-9]{1,5}", key) or int(key) > most:
        raise JsonError(f"is not a table of labels: {what} {_short(key)} is not from 0 to {most}")
    return int(key)


def _short(value):
    text = json.dumps(value)
    return text if len(text) <= 60 else f"{text[:60]}..."


def _name_of(names, number):
    return names[number] if 0 <= number < len(names) else ""
