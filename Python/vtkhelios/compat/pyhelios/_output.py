# SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
# SPDX-License-Identifier: BSD-3-Clause
"""The output of a simulation: measurements (echoes) and trajectories, as objects and as arrays."""

import collections.abc
import typing

import numpy as np

from ...array_names import (
    AMPLITUDE, CLASSIFICATION_IDS, DIRECTION, ECHO_WIDTH, GPS_TIME, NUMBER_OF_RETURNS, ORIENTATION,
    PART_IDS, PART_NAME, PULSE_IDS, RANGE, RETURN_NUMBER,
)  # fmt: skip
from ._coordinates import find_angles
from ._errors import NotCoveredError

NANO = 1e9  # amplitudes are W here, nW in HELIOS


class Vector(typing.NamedTuple):
    """A position or direction: v.x and v[0]."""

    x: float
    y: float
    z: float


class _Record:
    """A row of arrays: its columns are attributes, which cannot be set."""

    def __init__(self, columns, row):
        object.__setattr__(self, "_columns", columns)
        object.__setattr__(self, "_row", row)

    def _vector(self, name):
        return Vector(*self._columns[name][self._row].tolist())

    def __getattr__(self, name):
        column = self.NAMES.get(name)
        if column is None:
            raise NotCoveredError(
                f"{type(self).__name__}.{name} is not covered by vtkhelios.compat.pyhelios; it has: "
                f"{', '.join(self.NAMES)}"
            )
        return self._columns[column][self._row].item()

    def __setattr__(self, name, value):
        raise NotCoveredError(
            f"{type(self).__name__}.{name} cannot be set; change the array of outputToNumpy()"
        )

    def getPosition(self):
        return self._vector("position")

    @property
    def position(self):
        """x, y, z [m]."""
        return self._vector("position")


class Measurement(_Record):
    """An echo."""

    NAMES = {
        "distance": "distance",  # [m]
        "intensity": "intensity",  # [nW]
        "echoWidth": "echo_width",  # [ns], two-way
        "echo_width": "echo_width",
        "returnNumber": "return_number",  # from 1
        "return_number": "return_number",
        "pulseReturnNumber": "pulse_return_number",  # number of returns
        "pulse_return_number": "pulse_return_number",
        "fullwaveIndex": "fullwave_index",  # index of the pulse
        "fullwave_index": "fullwave_index",
        "hitObjectId": "hit_object_id",  # id of the part, a text
        "hit_object_id": "hit_object_id",
        "classification": "classification",
        "gpsTime": "gps_time",  # [s] since the start of the survey
        "gps_time": "gps_time",
    }

    def getBeamOrigin(self):
        return self._vector("beam_origin")

    def getBeamDirection(self):
        return self._vector("beam_direction")

    @property
    def beam_origin(self):
        """x, y, z [m]."""
        return self._vector("beam_origin")

    @property
    def beam_direction(self):
        """A unit vector."""
        return self._vector("beam_direction")


class Trajectory(_Record):
    """A sample of a trajectory; angles are in radians."""

    NAMES = {
        "gpsTime": "gps_time",  # [s] since the start of the survey
        "gps_time": "gps_time",
        "roll": "roll",
        "pitch": "pitch",
        "yaw": "yaw",  # clockwise from north
    }


class Records(collections.abc.Sequence):
    """Records of one kind; ``columns`` has their arrays by name, in the names of version 2.1."""

    def __init__(self, kind, columns):
        self._kind, self.columns = kind, columns

    def __len__(self):
        return len(self.columns["gps_time"])

    def __getitem__(self, index):
        if isinstance(index, slice):
            return [self[row] for row in range(*index.indices(len(self)))]
        if not -len(self) <= index < len(self):
            raise IndexError(f"there is no record {index}; there are {len(self)}")
        return self._kind(self.columns, index)

    def length(self):
        return len(self)

    def get(self, index):
        return self[index]


class Output(typing.NamedTuple):
    """Result of a simulation, in the order of version 2.1; filepath comes from version 1."""

    measurements: Records
    trajectories: Records
    outpath: str  # path of the first file of points; empty if no files are written
    outpaths: list  # paths of all files of points
    finished: bool

    @property
    def filepath(self):
        return self.outpath


def make_measurements(clouds):
    """Measurements of Clouds that have pulses."""
    return Records(Measurement, _concatenate(_MEASUREMENT, map(_measure, clouds)))


def make_trajectories(clouds):
    """Trajectories of the Clouds of Survey.trajectory()."""
    return Records(Trajectory, _concatenate(_TRAJECTORY, map(_trace, clouds)))


def make_output(blocks, paths, files, finished):
    """Returns the Output of Clouds of echoes and of trajectories."""
    first = files[0] if files else ""
    return Output(make_measurements(blocks), make_trajectories(paths), first, files, finished)


_MEASUREMENT = {
    "position": (float, 3),
    "beam_origin": (float, 3),
    "beam_direction": (float, 3),
    "distance": (float,),
    "intensity": (float,),
    "echo_width": (float,),
    "return_number": (int,),
    "pulse_return_number": (int,),
    "fullwave_index": (int,),
    "hit_object_id": (str,),
    "part": (int,),
    "classification": (int,),
    "gps_time": (float,),
}
_TRAJECTORY = {
    "position": (float, 3),
    "gps_time": (float,),
    "roll": (float,),
    "pitch": (float,),
    "yaw": (float,),
}


def _concatenate(columns, blocks):
    blocks = list(blocks)
    if not blocks:
        return {name: np.zeros((0, *shape), kind) for name, (kind, *shape) in columns.items()}
    return {name: np.concatenate([block[name] for block in blocks]) for name in columns}


def _measure(cloud):
    pulse = np.searchsorted(cloud.pulses[PULSE_IDS], cloud[PULSE_IDS])
    part = cloud[PART_IDS]
    return {
        "position": cloud.points,
        "beam_origin": cloud.pulses.points[pulse],
        "beam_direction": cloud.pulses[DIRECTION][pulse],
        "distance": cloud[RANGE],
        "intensity": cloud[AMPLITUDE] * NANO,
        "echo_width": cloud[ECHO_WIDTH],
        "return_number": cloud[RETURN_NUMBER],
        "pulse_return_number": cloud[NUMBER_OF_RETURNS],
        "fullwave_index": cloud[PULSE_IDS],
        "hit_object_id": _find_names(cloud, part),
        "part": part,
        "classification": cloud[CLASSIFICATION_IDS],
        "gps_time": cloud[GPS_TIME],
    }


def _find_names(cloud, part):
    """Returns the ids of the parts of all echoes, as strings; for a part without an id, its number."""
    names = cloud.data.GetFieldData().GetAbstractArray(PART_NAME)
    count = names.GetNumberOfValues() if names else 0
    known = np.array([names.GetValue(k) or str(k) for k in range(count)] or [""], dtype=str)
    inside = (part >= 0) & (part < count)
    return np.where(inside, known[np.where(inside, part, 0)], part.astype(str))


def _trace(cloud):
    roll, pitch, yaw = find_angles(cloud[ORIENTATION])
    return {
        "position": cloud.points,
        "gps_time": cloud[GPS_TIME],
        "roll": roll,
        "pitch": pitch,
        "yaw": yaw,
    }


def outputToNumpy(output):
    """Returns the measurements (n x 17) and trajectories (m x 7) of an Output as arrays of float64.

    Columns of measurements: 0 to 2 position, 3 to 5 beam origin, 6 to 8 beam direction, 9
    intensity [nW], 10 echo width [ns], 11 return number, 12 number of returns, 13 pulse, 14 hit
    object, 15 class, 16 GPS time [s]. The hit object is the id of the part if all ids are whole
    numbers, else the number of the part. Columns of trajectories: 0 to 2 position, 3 GPS time [s],
    4 to 6 roll, pitch, yaw [rad].
    """
    measured, traced = output[0].columns, output[1].columns
    columns = [measured[name] for name in ("position", "beam_origin", "beam_direction")]
    rest = ("intensity", "echo_width", "return_number", "pulse_return_number", "fullwave_index")
    columns += [measured[name][:, None] for name in rest]
    columns += [_find_numbers(measured)[:, None]]
    columns += [measured[name][:, None] for name in ("classification", "gps_time")]
    path = [
        traced["position"],
        *(traced[name][:, None] for name in ("gps_time", "roll", "pitch", "yaw")),
    ]
    return np.hstack(columns).astype(np.float64), np.hstack(path).astype(np.float64)


def _find_numbers(columns):
    try:
        return columns["hit_object_id"].astype(np.int64)
    except ValueError:
        return columns["part"]


def outputToList(output):
    """Returns the rows of outputToNumpy() as two lists of lists."""
    measurements, trajectories = outputToNumpy(output)
    return measurements.tolist(), trajectories.tolist()
