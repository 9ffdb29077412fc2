# SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
# SPDX-License-Identifier: BSD-3-Clause
"""Echoes with all kinds of arrays, written to point files and read back."""

import numpy as np
import pytest

from vtkhelios import formats

COUNT = 5000
CRS = "EPSG:25832"
EPOCH = 1.4e9


def make_chunk(count=COUNT, seed=1):
    """Echoes at UTM coordinates, with all kinds of arrays."""
    random = np.random.default_rng(seed)
    number = random.integers(1, 4, count).astype(np.uint8)
    return {
        "points": np.round(random.uniform(0, 100, (count, 3)) + [476000.0, 5473000.0, 110.0], 4),
        "GpsTime": np.arange(count) * 1e-5 + 3.0,
        "PulseIds": np.arange(count, dtype=np.int64) // 2 + 2**40,
        "ReturnNumber": number,
        "NumberOfReturns": (number + random.integers(0, 2, count)).astype(np.uint8),
        "Range": random.uniform(1, 300, count),
        "Amplitude": 10.0 ** random.uniform(-12, -4, count),
        "EchoWidth": random.uniform(4, 6, count),
        "ScanAngle": np.round(random.uniform(-30, 30, count) / 0.006) * 0.006,
        "ClassificationIds": random.integers(0, 12, count).astype(np.int32),
        "PartIds": random.integers(0, 3, count).astype(np.int32),
        "LegIds": np.full(count, 2, np.int32),
        "ChannelIds": random.integers(0, 8, count).astype(np.int32),
        "RGB": (random.integers(0, 256, (count, 3)) / 255.0).astype(np.float32),
        "TruePoint": random.uniform(0, 100, (count, 3)),
    }


def make_header():
    header = formats.Header()
    header.crs, header.epoch = CRS, EPOCH
    return header


def write(path, chunk=None, header=None, rows=1700, scan=None):
    chunk = make_chunk() if chunk is None else chunk
    with formats.open_writer(path, header or make_header()) as writer:
        if scan:
            writer.begin(scan)
        for begin in range(0, len(chunk["points"]), rows):
            writer.write({name: values[begin : begin + rows] for name, values in chunk.items()})
    return writer


def read(path, rows=1234):
    with formats.open_reader(path) as reader:
        chunks = list(reader.chunks(rows))
        names = chunks[0]
        assert reader.count is None or reader.count >= sum(len(each["points"]) for each in chunks)
    return reader, {name: np.concatenate([each[name] for each in chunks]) for name in names}


@pytest.fixture(params=["las", "laz", "copc.laz", "pvtp", "vtp", "ply"])
def full_format(request):
    """The formats that store every array."""
    return request.param
