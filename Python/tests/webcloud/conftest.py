# SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
# SPDX-License-Identifier: BSD-3-Clause
"""Clouds for the tests of pages."""

import numpy as np
import pytest


@pytest.fixture
def make_arrays():
    """Arrays of a cloud of n points, at UTM coordinates in millimetres."""

    def make(n, seed=1):
        random = np.random.default_rng(seed)
        x, y = random.uniform(0, 200, n), random.uniform(0, 150, n)
        points = np.column_stack([431_234.567 + x, 5_473_210.25 + y, 210 + 5 * np.sin(x / 20)])
        points = np.round(points, 3)
        return {
            "points": points, "Range": random.uniform(50, 300, n), "GpsTime": 1e5 + np.arange(n) * 1e-5,
            "Amplitude": 10 ** random.uniform(-9, -6, n), "PulseIds": 10**12 + np.arange(n) // 2,
            "ClassificationIds": random.integers(2, 7, n).astype(np.int32),
            "ReturnNumber": (1 + np.arange(n) % 2).astype(np.uint8),
            "IncidenceAngle": np.where(x < 20, np.nan, x / 3),
            "RGB": np.column_stack([x / 200, y / 150, 0 * x]).astype(np.float32),
            "Normal": random.normal(size=(n, 3)),
        }  # fmt: skip

    return make
