# SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
# SPDX-License-Identifier: BSD-3-Clause
"""Labels, objects and intensities of points, which layouts write besides their coordinates."""

import dataclasses

import numpy as np

from ..formats import FormatError, Header
from ._boxes import Boxes
from ._intensity import IntensityScale
from ._labels import Labels
from ._parts import Parts


@dataclasses.dataclass
class Content:
    """Labels, objects and intensities of the points of a run."""

    labels: Labels = dataclasses.field(default_factory=Labels)
    header: Header = dataclasses.field(default_factory=Header)
    parts: Parts = dataclasses.field(default_factory=Parts)
    scale: IntensityScale = dataclasses.field(default_factory=IntensityScale)
    boxes: Boxes | None = None

    @classmethod
    def of(cls, reader, labels=None, survey=None):
        """Returns that of a RunReader; survey: of the run (vtkhelios.Survey), for boxes of objects."""
        labels = labels or Labels()
        scale = IntensityScale.measure(reader)  # which also reads the names of all files
        parts = Parts(reader.header.part_names, reader.summary.get("carriers"))
        boxes = survey and Boxes(survey.scene, parts, labels, any(map(_moves, survey.parts)))
        return cls(labels, reader.header, parts, scale, boxes)

    def find_labels(self, arrays):
        """Returns the label of each point, also by its motion."""
        rest = self.labels.find(arrays, self.header.fields, self.parts)
        return self.labels.find_moving(rest, self.parts.find_moving(arrays))

    def find_static_labels(self, arrays):
        """Returns the label of each point at rest."""
        return self.labels.find(arrays, self.header.fields, self.parts)

    def find_instances(self, arrays):
        """Returns the object of each point, from 1; 0: none."""
        return self.parts.find_instances(arrays)

    def find_intensities(self, arrays):
        """Returns the intensity of each point, from 0 to 1."""
        return self.scale.find(arrays)

    def find_boxes(self, arrays, layout):
        """Returns the boxes of the objects with echoes; FormatError without the scene."""
        if self.boxes is None:
            raise FormatError(
                f"{layout} has boxes of objects, which need the scene: give --survey FILE, the survey "
                "of the run"
            )
        return self.boxes.find(arrays)


def _moves(part):
    """Returns whether a part of a survey moves, or is carried."""
    return any(part[name] for name in ("trajectory/file", "dmotion[0]/id", "mount"))


def yaw_of(axes):
    """Returns the angle of the first axis from x to y [rad]."""
    return float(np.arctan2(axes[1, 0], axes[0, 0]))
