# SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
# SPDX-License-Identifier: BSD-3-Clause
"""A run as scans: the points of a time window or leg, and the pose of the platform."""

import dataclasses
import itertools

import numpy as np

from ..array_names import DIRECTION, GPS_TIME, HIT, PULSE_IDS
from ..formats import FormatError


@dataclasses.dataclass
class Frame:
    """Points in the frame of the platform at the middle of a scan: x forward, y left, z up."""

    leg: str  #: the stem of its file of points
    start: float  #: GpsTime of the window [s]
    pose: np.ndarray  #: 4 x 4, from the frame to the coordinates of the run
    # arrays of the points, by vtkhelios.array_names; "points" are in the frame of the run
    arrays: dict
    misses: dict | None  #: pulses without an echo: "Direction" in the run, GpsTime, ChannelIds

    @property
    def points(self):
        """n x 3 [m], float64."""
        return (self.arrays["points"] - self.pose[:3, 3]) @ self.pose[:3, :3]

    @property
    def directions(self):
        """Unit vectors of the misses, m x 3."""
        return self.misses[DIRECTION] @ self.pose[:3, :3]


def read_scans(reader, window=None):
    """Yields the scans of a RunReader in order; window [s], None: a scan is a leg."""
    tagged = ((reader.scan, _check(reader, chunk)) for chunk in reader.chunks())
    for index, group in itertools.groupby(tagged, key=lambda pair: pair[0]):
        name = reader.files[index]
        poses = _Poses(reader, name)
        chunks = (chunk for _, chunk in group)
        pulses = reader.scans[index].pulses or reader._pulses(name)
        start = poses.start
        misses = _Misses(pulses, start, window)
        for number, arrays in _split(chunks, start, window, name):
            missed = misses.find(number, arrays)
            begin = start + number * (window or 0.0)
            middle = begin + window / 2 if window else np.median(arrays[GPS_TIME])
            yield Frame(reader.scans[index].name, begin, poses.at(middle), arrays, missed)


def _check(reader, chunk):
    """Returns the chunk; FormatError without times."""
    if GPS_TIME not in chunk:
        raise FormatError(
            f"{reader.folder / reader.files[reader.scan]}: has no {GPS_TIME}, which scans are made "
            "by; run the survey again with --format las"
        )
    return chunk


def _split(chunks, start, window, name):
    """Yields (number of the window, arrays); the windows of a leg increase."""
    number, parts = None, []
    for chunk in chunks:
        times = chunk[GPS_TIME]
        # The times of a trajectory in text are rounded: a pulse may come before the first of them.
        numbers = (
            np.floor(np.maximum(times - start, 0) / window).astype(int) if window else 0 * times
        )
        edges = np.flatnonzero(np.diff(numbers)) + 1
        for part in np.split(np.arange(len(times)), edges):
            if not len(part):
                continue
            here = int(numbers[part[0]])
            if number is not None and here < number:
                raise FormatError(
                    f"{name}: its points are not in order of time; give --window leg, or run the "
                    "survey again"
                )
            if here != number and parts:
                yield number, _join(parts)
                parts = []
            number = here
            parts.append({key: values[part] for key, values in chunk.items()})
    if parts:
        yield number, _join(parts)


def _join(parts):
    return {key: np.concatenate([part[key] for part in parts]) for key in parts[0]}


class _Misses:
    """The pulses of windows that have no echo."""

    def __init__(self, pulses, start, window):
        self._windows = _split(pulses(), start, window, "pulses") if pulses else None
        self._next = (-1, None)

    def find(self, number, arrays):
        """Returns the pulses of a window, whose echoes are given; None without pulses or their
        ids."""
        if self._windows is None or PULSE_IDS not in arrays:
            return None
        while self._next is not None and self._next[0] < number:
            self._next = next(self._windows, None)
        if self._next is None or self._next[0] != number:
            return None
        pulses = self._next[1]
        missed = ~np.isin(pulses[PULSE_IDS], arrays[PULSE_IDS])
        return {key: values[missed] for key, values in pulses.items() if key != HIT}


class _Poses:
    """The trajectory of a leg as poses at any time."""

    def __init__(self, reader, name):
        trajectory = reader.trajectory(name)
        if trajectory is None:
            raise FormatError(
                f"{reader.folder / name}: has no trajectory, which gives the pose of a scan; run the "
                "survey again"
            )
        self._times, self._places, self._turns = (np.asarray(each) for each in trajectory)
        self.start = float(self._times[0])

    def at(self, time):
        place = [np.interp(time, self._times, self._places[:, axis]) for axis in range(3)]
        pose = np.eye(4)
        pose[:3, :3] = _matrix(self._turn(time)) @ FORWARD_LEFT_UP
        pose[:3, 3] = place
        return pose

    def _turn(self, time):
        """Returns the unit quaternion, by spherical interpolation."""
        last = int(np.clip(np.searchsorted(self._times, time), 0, len(self._times) - 1))
        first = max(last - 1, 0)
        a, b = self._turns[first], self._turns[last]
        step = self._times[last] - self._times[first]
        share = np.clip((time - self._times[first]) / step, 0.0, 1.0) if step > 0 else 1.0
        cosine = np.clip(a @ b, -1.0, 1.0)
        b, angle = (b if cosine >= 0 else -b), np.arccos(abs(cosine))
        if angle < 1e-9:
            return b
        return (np.sin((1 - share) * angle) * a + np.sin(share * angle) * b) / np.sin(angle)


# Axes of the frame of a scan in the frame of the body: x right, y forward, z up.
FORWARD_LEFT_UP = np.array([[0.0, -1.0, 0.0], [1.0, 0.0, 0.0], [0.0, 0.0, 1.0]])


def _matrix(turn):
    """Returns the rotation matrix of a unit quaternion w, x, y, z."""
    w, x, y, z = turn
    return np.array([
        [1 - 2 * (y * y + z * z), 2 * (x * y - w * z), 2 * (x * z + w * y)],
        [2 * (x * y + w * z), 1 - 2 * (x * x + z * z), 2 * (y * z - w * x)],
        [2 * (x * z - w * y), 2 * (y * z + w * x), 1 - 2 * (x * x + y * y)],
    ])  # fmt: skip
