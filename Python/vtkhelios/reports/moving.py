# SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
# SPDX-License-Identifier: BSD-3-Clause
"""Counts for a report of the parts that moved during a run: their echoes and radial velocities."""

import numpy as np

from ..array_names import PART_IDS, RADIAL_VELOCITY

HEADS = ("part", "motion", "speed [m/s]", "echoes", "radial velocity [m/s]")
MOST = 50  # rows of a page


class MovingParts:
    """Echoes and radial velocities by part, of a run in whose summary parts move."""

    def __init__(self):
        self._counts = np.zeros(0, np.int64)  # by PartIds
        self._low = self._high = np.zeros(0)  # [m/s]
        self._names = []
        self._has_velocities = self._has_parts = False

    def add(self, chunk, reader):
        """Counts the echoes of a chunk."""
        if not reader.summary.get("movingParts") or PART_IDS not in chunk:
            return
        self._has_parts = True
        self._names = reader.header.part_names or self._names
        ids = np.asarray(chunk[PART_IDS], np.int64)
        known = ids >= 0
        self._grow(int(ids.max(initial=-1)) + 1)
        self._counts += np.bincount(ids[known], minlength=len(self._counts))
        if RADIAL_VELOCITY in chunk:
            self._has_velocities = True
            speeds = np.asarray(chunk[RADIAL_VELOCITY], float)
            known &= np.isfinite(speeds)
            np.minimum.at(self._low, ids[known], speeds[known])
            np.maximum.at(self._high, ids[known], speeds[known])

    def _grow(self, size):
        more = max(0, size - len(self._counts))
        self._counts = np.pad(self._counts, (0, more))
        self._low = np.pad(self._low, (0, more), constant_values=np.inf)
        self._high = np.pad(self._high, (0, more), constant_values=-np.inf)

    def to_list(self, summary):
        """Returns the parts that moved: part, motion, speed_m_s, and as far as the files have them, points and
        radialVelocity_m_s."""
        ids = {name: number for number, name in reversed([*enumerate(self._names)])}
        parts = []
        for each in summary.get("movingParts", []):
            part = {name: each[name] for name in ("part", "motion", "speed_m_s")}
            number = ids.get(each["part"], len(self._counts))
            is_hit = number < len(self._counts) and self._counts[number] > 0
            if self._has_parts and self._names:
                part["points"] = int(self._counts[number]) if is_hit else 0
            if self._has_velocities and is_hit and np.isfinite(self._low[number]):
                part["radialVelocity_m_s"] = [float(self._low[number]), float(self._high[number])]
            parts.append(part)
        return parts


def moving_rows(parts):
    """Returns the rows of a table of parts of MovingParts.to_list(); those beyond MOST are counted."""
    rows = [
        (
            part["part"], part["motion"], _span(part["speed_m_s"]),
            f"{part['points']:,}" if "points" in part else "not in the files",
            _span(part["radialVelocity_m_s"]) if "radialVelocity_m_s" in part else "",
        )
        for part in parts[:MOST]
    ]  # fmt: skip
    if len(parts) > MOST:
        rows.append((f"and {len(parts) - MOST} more", "", "", "", ""))
    return rows


def _span(ends):
    """Returns a range of numbers as text: "8", "-3.2 to 8"."""
    low, high = (f"{value:.3g}" for value in ends)
    low, high = ("0" if text == "-0" else text for text in (low, high))
    return low if low == high else f"{low} to {high}"
