# SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
# SPDX-License-Identifier: BSD-3-Clause
"""Labels by part, material, class and motion; instances, and the scale of intensities."""

import json

import numpy as np
import pytest

from vtkhelios import formats
from vtkhelios.learning import Labels
from vtkhelios.learning._intensity import IntensityScale
from vtkhelios.learning._parts import Parts

NAMES = ["road", "redCar_01", "wheel", "carpet", "Bicyclists", "old trees", "bus stop sign", ""]
PARTS = Parts(NAMES, {"wheel": "redCar_01"})


def make_fields(*materials):
    header = formats.Header()
    header.set_texts("Material.Name", materials)
    return header.fields


def find(labels, **arrays):
    count = len(next(iter(arrays.values())))
    given = {name: np.array(values) for name, values in arrays.items()}
    fields = make_fields("Oak_Bark", "beech leaves", "concrete")
    return labels.find({"points": np.zeros((count, 3)), **given}, fields, PARTS).tolist()


def test_labels_of_materials_go_before_classes():
    found = find(Labels(), MaterialIds=[0, 1, 2, 2], ClassificationIds=[5, 5, 6, 2])
    assert found == [71, 70, 50, 72]


def test_labels_of_parts_go_before_materials():
    """By words: a carpet is no car; wheels have the label of their car; trees keep their bark."""
    found = find(Labels(), PartIds=range(8), MaterialIds=[2] * 8, ClassificationIds=[2] * 8)
    assert found == [40, 10, 10, 72, 31, 70, 13, 72]
    assert find(Labels(), PartIds=[5, 5, 1], MaterialIds=[0, 1, 0]) == [71, 70, 10]


def test_given_labels_extend_the_defaults(tmp_path):
    """Fault F51: a file with one class set all others to 0."""
    path = tmp_path / "labels.json"
    path.write_text(
        json.dumps({"classes": {"64": 99}, "parts": {"stop": 81, "7": 44, "carpet": 9}})
    )
    labels = Labels.read(path)
    assert find(labels, ClassificationIds=[64, 2, 6]) == [99, 72, 50]
    assert find(labels, PartIds=[6, 7, 3, 1, 0]) == [81, 44, 9, 10, 40]
    assert find(Labels(materials={"concrete": 52}), MaterialIds=[0, 2]) == [71, 52]
    assert find(Labels(classes={2: 0}), ClassificationIds=[2, 6]) == [0, 50]


def test_what_moves_has_its_own_label():
    """The fastest point of an object counts: the lowest point of a wheel rests on the road."""
    arrays = {
        "points": np.zeros((5, 3)), "PartIds": np.array([1, 2, 2, 4, 0]),
        "PartVelocity": np.array([[8.0, 0, 0], [0, 0, 0], [16, 0, 0], [0, 0, 0], [0, 0, 0]]),
    }  # fmt: skip
    labels = Labels()
    rest = labels.find(arrays, make_fields(), PARTS)
    moves = PARTS.find_moving(arrays)
    assert moves.tolist() == [True, True, True, False, False]
    assert labels.find_moving(rest, moves).tolist() == [252, 252, 252, 31, 40]
    assert Labels(moving={10: 7}).find_moving(rest, moves).tolist() == [7, 7, 7, 31, 40]
    assert not PARTS.find_moving({**arrays, "PartVelocity": None}).any()


def test_instances_are_what_carries_a_part():
    arrays = {"points": np.zeros((4, 3)), "PartIds": np.array([0, 1, 2, -1])}
    assert PARTS.find_instances(arrays).tolist() == [1, 2, 2, 0]
    assert Parts().find_instances(arrays).tolist() == [1, 2, 3, 0]
    assert Parts().find_instances({"points": np.zeros((2, 3))}).tolist() == [0, 0]


def test_carriers_in_a_circle_end():
    parts = Parts(["a", "b"], {"a": "b", "b": "a"})
    assert list(parts.carriers_of(0)) == [0, 1]


def test_too_many_instances():
    with pytest.raises(formats.FormatError, match="65,535 is beyond the 65,535 instances"):
        Parts().find_instances({"points": np.zeros((1, 3)), "PartIds": np.array([65535])})


class Reader:
    """Chunks of a run."""

    def __init__(self, *chunks):
        self._chunks, self.count = chunks, sum(len(each["points"]) for each in chunks)

    def chunks(self):
        return iter(self._chunks)


def test_intensities_have_one_scale_in_all_scans():
    """Fault F53: every scan was relative to its own brightest points."""

    def make(amplitude):
        return {
            "points": np.zeros((1000, 3)), "Range": np.full(1000, 10.0),
            "Amplitude": np.full(1000, amplitude),
        }  # fmt: skip

    dark, bright = make(1e-6), make(4e-6)
    scale = IntensityScale.measure(Reader(dark, bright))
    assert scale.find(dark) == pytest.approx(0.25)
    assert scale.find(bright) == pytest.approx(1.0)
    reflectance = {"points": np.zeros((2, 3)), "Reflectance": np.array([-10.0, 3.0])}
    assert IntensityScale.measure(Reader(reflectance)).find(reflectance) == pytest.approx([0.1, 1])
    intensity = {"points": np.zeros((1, 3)), "Intensity": np.array([65535])}
    assert IntensityScale.measure(Reader(intensity)).find(intensity) == pytest.approx([1.0])
