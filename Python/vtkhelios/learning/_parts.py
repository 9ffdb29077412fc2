# SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
# SPDX-License-Identifier: BSD-3-Clause
"""The parts of a scene: their names, what carries them, and which move."""

import numpy as np

from ..array_names import PART_IDS, PART_VELOCITY
from ..formats import FormatError

MAXIMUM_INSTANCES = 2**16 - 1
SLOWEST = 0.01  # speed of what moves [m/s]


class Parts:
    """names by PartIds; carriers: names of the parts that others are mounted on, by their names."""

    def __init__(self, names=(), carriers=None):
        self.names = list(names)
        numbers = {name: number for number, name in enumerate(self.names)}
        self._carriers = {
            numbers[part]: numbers[carrier]
            for part, carrier in (carriers or {}).items()
            if part in numbers and carrier in numbers
        }

    def carriers_of(self, number):
        """Yields a part, the part that carries it, and so on."""
        passed = set()
        while number is not None and number not in passed:
            yield number
            passed.add(number)
            number = self._carriers.get(number)

    def root_of(self, number):
        """Returns the part that carries a part, at the end."""
        return list(self.carriers_of(number))[-1]

    def find_roots(self, arrays):
        """Returns the object of each point: its part, or what carries it; None without parts."""
        ids = arrays.get(PART_IDS)
        if ids is None or not self._carriers:
            return ids
        known, places = np.unique(ids, return_inverse=True)
        return np.array([self.root_of(int(number)) for number in known], ids.dtype)[places]

    def find_instances(self, arrays):
        """Returns the object of each point from 1, 0 without parts; FormatError above 65,535."""
        ids = self.find_roots(arrays)
        if ids is None:
            return np.zeros(len(arrays["points"]), np.uint32)
        if len(ids) and ids.max() >= MAXIMUM_INSTANCES:
            raise FormatError(
                f"part {ids.max():,} is beyond the {MAXIMUM_INSTANCES:,} instances of the layout; join "
                "parts of the scene"
            )
        return (ids + 1).clip(0).astype(np.uint32)

    def find_moving(self, arrays):
        """Returns whether the object of each point moves, by the fastest of its points; of runs
        with --motion."""
        velocities, ids = arrays.get(PART_VELOCITY), self.find_roots(arrays)
        if velocities is None or ids is None:
            return np.zeros(len(arrays["points"]), bool)
        known, places = np.unique(ids, return_inverse=True)
        fastest = np.zeros(len(known))
        np.maximum.at(fastest, places, np.linalg.norm(velocities, axis=1))
        return fastest[places] > SLOWEST
