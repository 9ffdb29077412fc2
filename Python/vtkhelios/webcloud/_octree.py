# SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
# SPDX-License-Identifier: BSD-3-Clause
"""An octree of points: every node has a sample of its cube, and its children have the rest."""

import dataclasses

import numpy as np

from ._sample import hashes

GRID = 7  # the sample of a node has one point per cell of a grid of 2^7 per side
LEAF = 20_000  # nodes with fewer points are not divided
DEEPEST = 14  # level; 14 + GRID bits per axis fit a key


@dataclasses.dataclass
class Node:
    """A cube of the octree: level (0: the root), place i, j, k in units of its size, its points."""

    level: int
    place: tuple
    rows: np.ndarray  # in ascending order

    def corner(self, bits):
        """Returns the lowest corner, in steps from the root's, of 2^bits steps."""
        return tuple(axis << (bits - self.level) for axis in self.place)


def build(steps):
    """Returns the nodes of points in whole steps (n x 3, not negative), by level, and the bits of
    the root.

    The points of all nodes down to a level are a sample with about one point per cell of size
    2^(bits - level - GRID) steps; all nodes together hold every point once.
    """
    bits = max(1, int(steps.max(initial=0)).bit_length())
    rest = np.argsort(hashes(np.arange(len(steps))), kind="stable")
    nodes = []
    for level in range(DEEPEST + 1):
        if len(rest) == 0:
            break
        keys = _keys(steps[rest], bits - level)
        _, inverse, counts = np.unique(keys, return_inverse=True, return_counts=True)
        whole = counts[inverse] < LEAF
        if level == DEEPEST:
            whole[:] = True
        chosen = whole.copy()
        _, first = np.unique(_keys(steps[rest], bits - level - GRID), return_index=True)
        chosen[first] = True
        nodes += _nodes(level, keys[chosen], rest[chosen])
        rest = rest[~chosen]
    return nodes, bits


def _keys(steps, shift):
    """One number per cube of 2^shift steps."""
    i, j, k = (steps >> max(0, shift)).T
    return (i << 42) | (j << 21) | k


def _nodes(level, keys, rows):
    order = np.lexsort((rows, keys))
    keys, rows = keys[order], rows[order]
    starts = np.flatnonzero(np.r_[True, keys[1:] != keys[:-1]])
    mask = (1 << 21) - 1
    return [
        Node(level, (int(key >> 42), int(key >> 21 & mask), int(key & mask)), part)
        for key, part in zip(keys[starts], np.split(rows, starts[1:]))
    ]
