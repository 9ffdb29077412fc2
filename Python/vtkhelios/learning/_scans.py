# SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
# SPDX-License-Identifier: BSD-3-Clause
"""A run as scans: the points of a time window or leg, and the pose of the sensor."""

import dataclasses
import itertools

import numpy as np

from ..array_names import DIRECTION, GPS_TIME, HIT, PULSE_IDS
from ..core.run_files import SUMMARY_NAME
from ..formats import FormatError
from ..core.rotation import matrix_of


ROUNDING = 1e-9  # tolerance of times that are in order [s]
IDENTITY = {"position_m": [0.0] * 3, "orientation": [1.0, 0.0, 0.0, 0.0]}


@dataclasses.dataclass
class Frame:
    """Points in the frame of the sensor, or platform, at the middle of a scan: x forward, y left, z up."""

    leg: str  #: the stem of its file of points
    start: float  #: GpsTime of the window [s]
    pose: np.ndarray  #: 4 x 4, from the frame to the coordinates of the run
    # arrays of the points, by vtkhelios.array_names; "points" are in the frame of the run
    arrays: dict
    misses: dict | None  #: pulses without an echo: "Direction" in the run, GpsTime, ChannelIds
    platform: np.ndarray | None = None  #: the pose of the platform, 4 x 4, x forward, y left, z up
    duration: float = 0.0  #: of the window; of a leg, to its last echo [s]

    @property
    def points(self):
        """n x 3 [m], float64."""
        return (self.arrays["points"] - self.pose[:3, 3]) @ self.pose[:3, :3]

    @property
    def directions(self):
        """Unit vectors of the misses, m x 3."""
        return self.misses[DIRECTION] @ self.pose[:3, :3]


def read_scans(reader, window=None, frame="sensor"):
    """Yields the scans of a RunReader in order; window [s], None: a scan is a leg.

    frame
        of the points: "sensor", the mount of the scanner on the platform, with x along its y axis;
        or "platform".
    """
    tagged = ((reader.scan, _check(reader, chunk)) for chunk in reader.chunks())
    for index, group in itertools.groupby(tagged, key=lambda pair: pair[0]):
        name = reader.files[index]
        poses = _Poses(reader, name, _find_mount(reader, name, frame))
        chunks = (chunk for _, chunk in group)
        pulses = reader.scans[index].pulses or reader._pulses(name)
        start = poses.start
        misses = _Misses(pulses, start, window)
        for number, arrays in _split(chunks, start, window, name):
            missed = misses.find(number, arrays)
            begin = start + number * (window or 0.0)
            middle = begin + window / 2 if window else np.median(arrays[GPS_TIME])
            length = window or float(arrays[GPS_TIME].max()) - begin
            platform = poses.of_platform(middle)
            yield Frame(
                reader.scans[index].name, begin, poses.at(middle), arrays, missed, platform, length
            )


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
        numbers = _number(times, start, window)
        edges = np.flatnonzero(np.diff(numbers)) + 1
        for part in np.split(np.arange(len(times)), edges):
            if not len(part):
                continue
            here = int(numbers[part[0]])
            if number is not None and here < number:  # also if it begins there by rounding
                here = int(_number(times[part].min() + 2 * ROUNDING, start, window))
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


def _number(times, start, window):
    """Returns the numbers of the windows of times.

    The times of a trajectory in text are rounded: a pulse may come before the first of them.
    """
    if not window:
        return np.zeros(np.shape(times), int)
    return np.floor((np.maximum(times - start, 0) + ROUNDING) / window).astype(int)


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


def _find_mount(reader, name, frame):
    """Returns where the frame of points sits on the platform, 4 x 4."""
    mount = IDENTITY
    if frame == "sensor":
        legs = [leg for leg in reader.summary["legs"] if name in {f["name"] for f in leg["files"]}]
        mount = legs[0].get("mount")
        if mount is None:
            raise FormatError(
                f"{reader.folder / SUMMARY_NAME}: does not have the mount of the scanner, which "
                "gives the frame of the sensor; run the survey again, or give --frame platform"
            )
    return pose_of(mount["position_m"], matrix_of(mount["orientation"]) @ FORWARD_LEFT_UP)


def pose_of(place, turn):
    """Returns a pose as a matrix of 4 x 4."""
    pose = np.eye(4)
    pose[:3, :3], pose[:3, 3] = turn, place
    return pose


class _Poses:
    """The trajectory of a leg as poses at any time; mount: of the frame on the body, 4 x 4."""

    def __init__(self, reader, name, mount):
        trajectory = reader.trajectory(name)
        if trajectory is None:
            raise FormatError(
                f"{reader.folder / name}: has no trajectory, which gives the pose of a scan; run the "
                "survey again"
            )
        self._times, self._places, self._turns = (np.asarray(each) for each in trajectory)
        self.start = float(self._times[0])
        self._mount = mount

    def at(self, time):
        """Returns the pose of the frame of points."""
        return self._of_body(time) @ self._mount

    def of_platform(self, time):
        """Returns the pose of the platform: x forward, y left, z up."""
        return self._of_body(time) @ pose_of(np.zeros(3), FORWARD_LEFT_UP)

    def _of_body(self, time):
        place = [np.interp(time, self._times, self._places[:, axis]) for axis in range(3)]
        return pose_of(place, matrix_of(self._turn(time)))

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


# Axes of the frame of a scan in the frame of the body or scanner: x right, y forward, z up.
FORWARD_LEFT_UP = np.array([[0.0, -1.0, 0.0], [1.0, 0.0, 0.0], [0.0, 0.0, 1.0]])
