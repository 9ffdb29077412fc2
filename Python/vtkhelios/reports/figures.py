# SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
# SPDX-License-Identifier: BSD-3-Clause
"""Counts for a report, of the points of a run, chunk by chunk."""

import numpy as np

from ..array_names import (
    AMPLITUDE, CLASSIFICATION_IDS, ECHO_WIDTH, GPS_TIME, INCIDENCE_ANGLE, NUMBER_OF_RETURNS, RANGE,
    RETURN_NUMBER,
)  # fmt: skip
from ..formats import FormatError
from ..formats._base import rows_of
from .moving import MovingParts
from .raster import FARTHEST, Histogram, Raster, is_near, tally

HISTOGRAMS = {  # key: finest bin
    "range": 0.01,
    "incidence": 0.5,
    "amplitude": 0.25,
    "width": 0.005,
}


class Figures:
    """Statistics of a run, in memory independent of the number of points."""

    def __init__(self, cell=None):
        self.raster = Raster(cell)
        self.histograms = {key: Histogram(width) for key, width in HISTOGRAMS.items()}
        self.echoes = np.zeros(256, np.int64)  # pulses by their number of returns
        self.classes = np.zeros(256, np.int64)
        self.count = 0
        self.legs = []  # points of each file
        self.low = np.full(3, np.inf)
        self.high = np.full(3, -np.inf)
        self.range_is_computed = False
        self._path = None  # path of the platform: times, positions
        self._scan = None
        self._moving, self._summary = MovingParts(), {}

    def add(self, chunk, reader):
        """Counts the points of a chunk."""
        if self._scan != reader.scan:
            self._scan = reader.scan
            self._path = self._load_path(reader, chunk)
            self.legs += [0] * (reader.scan + 1 - len(self.legs))
        points = chunk["points"]
        if not np.isfinite(points).all():
            raise FormatError(
                f"{reader.path}: has points that are not finite; run the survey again"
            )
        if not is_near(points).all():
            raise FormatError(
                f"{reader.path}: has points more than {FARTHEST:g} m from the origin, up to "
                f"{np.abs(points).max():g} m; run the survey again"
            )
        if not self.raster.add(points[:, :2], reader.scan):
            raise FormatError(
                f"{reader.path}: the maps would be too large with cells of {self.raster.cell:g} m; "
                "give a larger --cell"
            )
        self.count += rows_of(chunk)
        self.legs[reader.scan] += rows_of(chunk)
        self._summary = reader.summary
        self._moving.add(chunk, reader)
        if len(points):
            self.low = np.minimum(self.low, points.min(axis=0))
            self.high = np.maximum(self.high, points.max(axis=0))
        with np.errstate(all="ignore"):  # values excluded from histograms
            self._add_values(chunk)

    def _add_values(self, chunk):
        histograms = self.histograms
        if (ranges := self._ranges(chunk)) is not None:
            histograms["range"].add(ranges)
        if INCIDENCE_ANGLE in chunk:
            histograms["incidence"].add(chunk[INCIDENCE_ANGLE])
        if AMPLITUDE in chunk:
            histograms["amplitude"].add(10.0 * np.log10(1e9 * chunk[AMPLITUDE]))
        if ECHO_WIDTH in chunk:
            histograms["width"].add(chunk[ECHO_WIDTH])
        if RETURN_NUMBER in chunk and NUMBER_OF_RETURNS in chunk:
            first = chunk[NUMBER_OF_RETURNS][chunk[RETURN_NUMBER] == 1]
            self.echoes += tally(first)
        if CLASSIFICATION_IDS in chunk:
            self.classes += tally(np.clip(chunk[CLASSIFICATION_IDS], 0, 255))

    def _load_path(self, reader, chunk):
        if RANGE in chunk or GPS_TIME not in chunk:
            return None
        trajectory = reader.trajectory(reader.files[reader.scan])
        self.range_is_computed |= trajectory is not None
        return trajectory and trajectory[:2]

    def _ranges(self, chunk):
        """From the array, else the distance to the platform [m]."""
        if RANGE in chunk or self._path is None:
            return chunk.get(RANGE)
        times, places = self._path
        at = [np.interp(chunk[GPS_TIME], times, places[:, axis]) for axis in range(3)]
        return np.linalg.norm(chunk["points"] - np.column_stack(at), axis=1)

    def mean_density(self):
        """Returns the points/m² of the non-empty cells."""
        hit = np.count_nonzero(self.raster.counts)
        return self.count / max(1, hit) / self.raster.cell**2

    def overlap(self):
        """Returns the fraction of non-empty cells covered by two scans, or None for one scan."""
        if len(self.legs) < 2:
            return None
        scans = self.raster.scans()
        return float((scans >= 2).sum() / max(1, (scans >= 1).sum()))

    def moving_parts(self):
        """Returns the parts that moved, see MovingParts.to_list()."""
        return self._moving.to_list(self._summary)

    def to_dict(self):
        """Returns the numbers, for tests and --json."""
        moving = self.moving_parts()
        return {
            "points": self.count,
            "cell_m": self.raster.cell,
            "density_per_m2": self.mean_density(),
            "coverage": self.raster.coverage(),
            "overlap": self.overlap(),
            "bounds": {"minimum": self.low.tolist(), "maximum": self.high.tolist()},
            "echoesPerPulse": {str(i): int(n) for i, n in enumerate(self.echoes) if n},
            "classes": {str(i): int(n) for i, n in enumerate(self.classes) if n},
            "medians": {
                key: each.quantile(0.5) for key, each in self.histograms.items() if len(each.counts)
            },
            "pointsOfFiles": self.legs,
            **({"movingParts": moving} if moving else {}),
        }
