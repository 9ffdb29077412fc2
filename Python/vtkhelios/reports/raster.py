# SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
# SPDX-License-Identifier: BSD-3-Clause
"""Points counted in square cells, and numbers in bins, in memory that does not grow with them."""

import numpy as np

FINEST = 2.0**-10  # [m]
SCANS_A_PLANE = 64
LARGEST = 20_000  # maximum cells a side for a given size
MAXIMUM_CELLS = 2**24  # in all
FARTHEST = 1e12  # limit of coordinates and other numbers; larger ones are damaged


def is_near(points):
    """Which rows are finite and within FARTHEST."""
    return (np.abs(points) <= FARTHEST).all(axis=1)


def tally(values):
    """Counts of the integers 0 to 255; others are ignored."""
    known = values[(values >= 0) & (values <= 255)]
    return np.bincount(known.astype(np.int64).ravel(), minlength=256)


class Raster:
    """Counts points, and the scans of each cell, in a raster in xy.

    Without a cell size it starts with fine cells and merges 2 x 2 of them whenever there would be
    more than ``limit`` in a direction; sums and scans stay exact. Cells start at multiples of their
    size.
    """

    def __init__(self, cell=None, limit=512):
        self.cell = cell or FINEST
        self._is_given = cell is not None
        self._limit = LARGEST if cell else limit
        self._corner = None  # place of the first cell, in cells: x, y
        self.counts = np.zeros((0, 0), np.int64)  # rows are y
        self._scans = []  # planes of 64 scans each, as bits

    def add(self, xy, scan):
        """Counts points (n x 2) of a scan by its number; False if there would be too many cells.

        All coordinates are within FARTHEST, see is_near().
        """
        if not len(xy):
            return True
        low, high = xy.min(axis=0), xy.max(axis=0)
        if not self._make_room(low, high):
            return False
        index = np.floor(xy / self.cell).astype(np.int64) - self._corner
        height, width = self.counts.shape
        flat = index[:, 1] * width + index[:, 0]
        begin = int(flat.min())
        found = np.bincount(flat - begin)
        self.counts.reshape(-1)[begin : begin + len(found)] += found
        plane, bit = divmod(scan, SCANS_A_PLANE)
        while len(self._scans) <= plane:
            self._scans.append(np.zeros((height, width), np.uint64))
        seen = self._scans[plane].reshape(-1)[begin : begin + len(found)]
        seen[found > 0] |= np.uint64(1 << bit)
        return True

    def _make_room(self, low, high):
        while True:
            first = np.floor(low / self.cell).astype(np.int64)
            last = np.floor(high / self.cell).astype(np.int64)
            if self._corner is not None:
                height, width = self.counts.shape
                last = np.maximum(last, self._corner + [width - 1, height - 1])
                first = np.minimum(first, self._corner)
            sides = last - first + 1
            if (sides <= self._limit).all() and sides.prod() <= MAXIMUM_CELLS:
                break
            if self._is_given:
                return False
            self.coarsen()
        self._grow(first, last)
        return True

    def _grow(self, first, last):
        width, height = last - first + 1
        if self._corner is None:
            self._corner = first
        before = self._corner - first
        if self.counts.shape == (height, width):
            return
        self.counts = self._placed(self.counts, before, height, width)
        self._scans = [self._placed(plane, before, height, width) for plane in self._scans]
        self._corner = first

    def _placed(self, old, before, height, width):
        new = np.zeros((height, width), old.dtype)
        rows, columns = old.shape
        new[before[1] : before[1] + rows, before[0] : before[0] + columns] = old
        return new

    def coarsen(self):
        """Merges 2 x 2 cells."""
        self.cell *= 2
        if self._corner is None:
            return
        height, width = self.counts.shape
        first = self._corner // 2
        before = self._corner - 2 * first
        rows, columns = -(-(height + before[1]) // 2), -(-(width + before[0]) // 2)

        def blocks(plane):
            return self._placed(plane, before, 2 * rows, 2 * columns).reshape(rows, 2, columns, 2)

        self.counts = blocks(self.counts).sum(axis=(1, 3))
        self._scans = [
            np.bitwise_or.reduce(np.bitwise_or.reduce(blocks(plane), axis=3), axis=1)
            for plane in self._scans
        ]
        self._corner = first

    @property
    def box(self):
        """West, east, south, north [m]."""
        height, width = self.counts.shape
        x, y = self._corner * self.cell
        return x, x + width * self.cell, y, y + height * self.cell

    def density(self):
        """Returns the points/m²."""
        return self.counts / self.cell**2

    def scans(self):
        """Returns the number of scans of each cell."""
        total = np.zeros(self.counts.shape, np.int64)
        for plane in self._scans:
            for row, seen in zip(total, plane):  # bits take 64 times the memory
                bits = np.unpackbits(seen.view(np.uint8).reshape(-1, 8), axis=1)
                row += bits.sum(axis=1, dtype=np.int64)
        return total

    def outline(self):
        """Returns the cells between the first and the last non-empty ones in their row and
        column."""
        hit = self.counts > 0
        return _between(hit, 0) & _between(hit, 1)

    def coverage(self):
        """The fraction of the cells in the outline that have a point."""
        outline = self.outline()
        return float((self.counts > 0).sum() / max(1, outline.sum()))


def _between(hit, axis):
    after = np.maximum.accumulate(hit, axis=axis)
    before = np.flip(np.maximum.accumulate(np.flip(hit, axis), axis=axis), axis)
    return after & before


class Histogram:
    """Values in bins of a width that doubles when there would be more than ``limit``."""

    def __init__(self, width, limit=4096):
        self.width = width
        self.counts = np.zeros(0, np.int64)
        self.first = 0  # the number of the first bin
        self._limit = limit

    def add(self, values):
        values = values[np.abs(values) <= FARTHEST]
        if not len(values):
            return
        while True:
            bins = np.floor(values / self.width).astype(np.int64)
            low, high = int(bins.min()), int(bins.max())
            if len(self.counts):
                low, high = min(low, self.first), max(high, self.first + len(self.counts) - 1)
            if high - low < self._limit:
                break
            self._coarsen()
        counts = np.zeros(high - low + 1, np.int64)
        begin = self.first - low if len(self.counts) else 0
        counts[begin : begin + len(self.counts)] = self.counts
        counts += np.bincount(bins - low, minlength=len(counts))
        self.first, self.counts = low, counts

    def _coarsen(self):
        self.width *= 2
        if len(self.counts):
            odd = self.first % 2
            padded = np.r_[np.zeros(odd, np.int64), self.counts]
            padded = np.r_[padded, np.zeros(len(padded) % 2, np.int64)]
            self.counts = padded.reshape(-1, 2).sum(axis=1)
            self.first //= 2

    def merged(self, most=80):
        """Edges and counts of at most this many bins."""
        joined = max(1, -(-len(self.counts) // most))
        odd = self.first % joined
        padded = np.r_[np.zeros(odd, np.int64), self.counts]
        padded = np.r_[padded, np.zeros(-len(padded) % joined, np.int64)]
        counts = padded.reshape(-1, joined).sum(axis=1)
        first = self.first - odd
        edges = (first + joined * np.arange(len(counts) + 1)) * self.width
        return edges, counts

    def quantile(self, share):
        """Approximate; within a bin."""
        total = np.cumsum(self.counts)
        if not len(total) or total[-1] == 0:
            return float("nan")
        at = int(np.searchsorted(total, share * total[-1]))
        before = total[at - 1] if at else 0
        part = (share * total[-1] - before) / max(1, self.counts[at])
        return float((self.first + at + part) * self.width)
