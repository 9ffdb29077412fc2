# SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
# SPDX-License-Identifier: BSD-3-Clause
"""Whole numbers as compressed bytes, decoded by page/decode.js.

A column of n numbers has a head of 9 bytes: the width w in bytes (0 to 7), plus 128 if differences
are stored, and the base (float64); then w planes of n bytes, the lowest first. Without differences
a number is base + value. With them the first is base, and each is its predecessor plus the
difference, stored as 2 d for d >= 0 and -2 d - 1 for d < 0.
"""

import base64
import struct
import zlib

import numpy as np

LEVEL = 6  # level of zlib


def pack_columns(columns):
    """Returns the zlib stream of columns of whole numbers (int64), one after the other."""
    return zlib.compress(b"".join(map(_pack, columns)), LEVEL)


def _pack(values):
    low = int(values.min()) if len(values) else 0
    plain = values - low
    changes = np.diff(values, prepend=values[:1])
    folded = np.where(changes >= 0, 2 * changes, -2 * changes - 1)
    if _bits(folded) < _bits(plain):
        return _head(folded, 128, int(values[0])) + _planes(folded)
    return _head(plain, 0, low) + _planes(plain)


def _bits(values):
    """Mean number of significant bits."""
    return np.log2(values + 1.0).mean() if len(values) else 0.0


def _width(values):
    return (int(values.max(initial=0)).bit_length() + 7) // 8


def _head(values, flag, base):
    return struct.pack("<Bd", _width(values) | flag, base)


def _planes(values):
    raw = np.ascontiguousarray(values, "<i8").view(np.uint8).reshape(-1, 8)
    return np.ascontiguousarray(raw[:, : _width(values)].T).tobytes()


class Store:
    """Streams one after the other as base64, each from a multiple of 3 bytes on."""

    def __init__(self):
        self.lengths = []  # sizes of the streams [bytes]
        self._parts = []

    def add(self, stream):
        self.lengths.append(len(stream))
        self._parts.append(stream + bytes(-len(stream) % 3))

    def text(self):
        return base64.b64encode(b"".join(self._parts)).decode()
