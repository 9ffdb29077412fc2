# SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
# SPDX-License-Identifier: BSD-3-Clause
"""A sample of the points of a stream of chunks, in bounded memory."""

import numpy as np

LIMIT = 1_000_000  # points of a page unless another number is given


def hashes(numbers):
    """Returns a pseudo-random uint64 for each whole number: the finalizer of SplitMix64."""
    with np.errstate(over="ignore"):
        x = np.asarray(numbers).astype(np.uint64) + np.uint64(0x9E3779B97F4A7C15)
        x = (x ^ (x >> np.uint64(30))) * np.uint64(0xBF58476D1CE4E5B9)
        x = (x ^ (x >> np.uint64(27))) * np.uint64(0x94D049BB133111EB)
        return x ^ (x >> np.uint64(31))


class Sample:
    """The points with the smallest hashes of their index, at most ``limit``, in their order.

    Which points are chosen depends on their index only, not on the chunks; a sample of fewer points
    is a subset of one of more. It needs the memory of 2 limit points and a chunk.
    """

    def __init__(self, limit=LIMIT, names=None):
        self.limit = limit
        self.names = None if names is None else {"points", *names}
        self.count = 0  # points seen
        self._dropped = set()
        self._parts = []  # columns of chosen points, each with its "index"
        self._kept = 0
        self._highest = np.uint64(2**64 - 1)  # hash of a point that may be chosen

    def add(self, chunk):
        """Adds the points of a chunk: a dict of arrays with "points" (n x 3, [m])."""
        rows = len(chunk["points"])
        index = np.arange(self.count, self.count + rows)
        self.count += rows
        keep = np.flatnonzero(hashes(index) <= self._highest)
        if len(keep) == 0:
            return
        part = {name: values[keep] for name, values in chunk.items() if self._wants(name)}
        self._parts.append({**part, "index": index[keep]})
        self._kept += len(keep)
        if self._kept > 2 * self.limit:
            self._shrink()

    def columns(self):
        """Returns the chosen points: a dict of arrays, with "points" and "index", their number in
        the file."""
        self._shrink()
        return dict(self._parts[0]) if self._parts else {"points": np.empty((0, 3))}

    @property
    def dropped(self):
        """The names of the arrays that some chunks do not have, and the sample therefore not."""
        self._shrink()
        return self._dropped

    def _wants(self, name):
        return self.names is None or name in self.names

    def _shrink(self):
        """Joins the parts, and drops the points with the largest hashes."""
        if not self._parts:
            return
        names = set.intersection(*(set(part) for part in self._parts))
        self._dropped |= set.union(*(set(part) for part in self._parts)) - names
        names = [name for name in self._parts[0] if name in names]
        joined = {name: np.concatenate([part[name] for part in self._parts]) for name in names}
        if self._kept > self.limit:
            keys = hashes(joined["index"])
            self._highest = np.partition(keys, self.limit - 1)[self.limit - 1]
            keep = keys <= self._highest
            joined = {name: values[keep] for name, values in joined.items()}
        self._parts, self._kept = [joined], len(joined["index"])
