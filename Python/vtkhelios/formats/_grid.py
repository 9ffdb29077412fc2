# SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
# SPDX-License-Identifier: BSD-3-Clause
"""The rows and columns of a scan, from its pulses, including those without echoes."""

import numpy as np

from ..array_names import CHANNEL_IDS, DIRECTION, GPS_TIME, PULSE_IDS, SCAN_ANGLE

JUMP = 10.0  # jump of the angle, in typical steps: a new line


class Grid:
    """Row and column of every pulse of a scan: 17 bytes/pulse."""

    def __init__(self, first, rows, columns):
        self._first = first
        self._rows = rows
        self._columns = columns
        self._hit = np.zeros(len(rows), bool)

    def place(self, ids):
        """Returns the E57 fields of pulses by their ids."""
        at = np.clip(ids - self._first, 0, len(self._rows) - 1)
        return {"rowIndex": self._rows[at], "columnIndex": self._columns[at]}

    def note(self, ids):
        """Marks pulses that have an echo."""
        self._hit[np.clip(ids - self._first, 0, len(self._hit) - 1)] = True

    def misses(self, chunks, turn, rows):
        """Yields the pulses without echoes: directions in the frame of the scanner."""
        for chunk in chunks:
            for begin in range(0, len(chunk[PULSE_IDS]), rows):
                ids = chunk[PULSE_IDS][begin : begin + rows]
                lost = ~self._hit[ids - self._first]
                local = chunk[DIRECTION][begin : begin + rows][lost] @ turn
                yield {
                    "cartesianX": local[:, 0],
                    "cartesianY": local[:, 1],
                    "cartesianZ": local[:, 2],
                    "timeStamp": chunk[GPS_TIME][begin : begin + rows][lost],
                    **self.place(ids[lost]),
                }


def find_grid(chunks, turn):
    """Returns the grid of pulses, or None if they are not in lines.

    A line ends where the mirror angle jumps, or where pulses are missing; rows are steps of that
    angle. For a multi-channel scanner a channel is a row.
    """
    parts = [
        (chunk[PULSE_IDS].copy(), _angles(chunk, turn), chunk[CHANNEL_IDS].copy())
        for chunk in chunks
    ]
    if not parts:
        return None
    ids, angles, channels = (np.concatenate(each) for each in zip(*parts))
    count = int(channels.max()) + 1
    if count > 1:
        rows, columns = channels, (ids - ids[0]) // count
    else:
        steps = np.diff(angles)
        usual = float(np.median(np.abs(steps))) if len(steps) else 0.0
        new = (np.abs(steps) > JUMP * usual) | (np.diff(ids) > 1)
        if usual == 0.0 or not new.any():
            return None
        columns = np.r_[0, np.cumsum(new)]
        rows = np.rint((angles - angles.min()) / usual)
    size = int(ids[-1] - ids[0]) + 1
    placed = [np.zeros(size, np.int64) for _ in range(2)]
    for target, values in zip(placed, (rows, columns)):
        target[ids - ids[0]] = values
    return Grid(int(ids[0]), *placed)


def _angles(chunk, turn):
    """Returns the angle of the mirror, else the elevation in the frame of the scanner [deg]."""
    if SCAN_ANGLE in chunk:
        return chunk[SCAN_ANGLE].copy()
    up = chunk[DIRECTION] @ turn[:, 2]
    return np.degrees(np.arcsin(np.clip(up, -1.0, 1.0)))
