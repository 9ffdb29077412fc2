# SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
# SPDX-License-Identifier: BSD-3-Clause
"""Reads the page of a cloud, independently of the code that writes and shows it."""

import base64
import html.parser
import json
import struct
import zlib

import numpy as np


class PageReader(html.parser.HTMLParser):
    """The scripts of a page by their id, and the addresses that it refers to."""

    def __init__(self, text):
        super().__init__()
        self.scripts, self.addresses, self._id = {}, [], None
        self.feed(text)
        self.meta = json.loads(self.scripts["meta"])
        self._bytes = base64.b64decode(self.scripts["streams"])

    def handle_starttag(self, tag, attributes):
        attributes = dict(attributes)
        self._id = attributes.get("id", attributes.get("type")) if tag == "script" else None
        self.addresses += [attributes[name] for name in ("src", "href") if name in attributes]

    def handle_data(self, data):
        if self._id:
            self.scripts[self._id] = self.scripts.get(self._id, "") + data

    def stream(self, index):
        starts = np.cumsum([0] + [-(-length // 3) * 3 for length in self.meta["lengths"]])
        return zlib.decompress(self._bytes[starts[index] :][: self.meta["lengths"][index]])

    def cloud(self):
        """All points and columns (NaN: missing), node by node: coordinates [m], a dict of values."""
        columns = self.meta["columns"]
        points, values = [], {column["name"]: [] for column in columns}
        for index, (level, *place, count) in enumerate(self.meta["nodes"]):
            first = index * (1 + len(columns))
            steps = np.column_stack(decode(self.stream(first), [count] * 3))
            corner = np.array(place) * 2 ** (self.meta["bits"] - level)
            assert steps.min() >= 0 and steps.max() < 2 ** (self.meta["bits"] - level)
            points.append(in_steps(steps + corner + self.meta["corner"], self.meta["step"]))
            for part, column in enumerate(columns):
                (codes,) = decode(self.stream(first + 1 + part), [count])
                values[column["name"]].append(value_of(column, codes))
        return np.concatenate(points), {name: np.concatenate(each) for name, each in values.items()}


def decode(data, counts):
    """Whole numbers of columns with these numbers of rows; None: the sum of the column before."""
    found = []
    for count in counts:
        count = int(found[-1].sum()) if count is None else count
        flags, base = struct.unpack_from("<Bd", data)
        width = flags & 127
        planes = np.frombuffer(data, np.uint8, width * count, 9).reshape(width, count)
        numbers = sum(
            (planes[i].astype(np.int64) << 8 * i for i in range(width)), np.zeros(count, np.int64)
        )
        if flags & 128:
            numbers = np.cumsum(np.where(numbers % 2, -(numbers + 1) // 2, numbers // 2))
        found.append(numbers + int(base))
        data = data[9 + width * count :]
    assert not data
    return found


def in_steps(numbers, step):
    return numbers / round(1 / step) if step < 1 else numbers * step


def value_of(column, codes):
    if column["kind"] == "float":
        return (codes.astype(np.uint32) << np.uint32(8)).view(np.float32).astype(float)
    values = in_steps(codes + column["base"], column["step"]).astype(float)
    return (
        np.where(codes == column["missing"], np.nan, values)
        if column["missing"] is not None
        else values
    )
