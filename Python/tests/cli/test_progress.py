# SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
# SPDX-License-Identifier: BSD-3-Clause
"""Rate and remaining time of a run."""

import pytest

from vtkhelios.cli._progress import Pace, duration


def test_steady_pace():
    pace = Pace()
    for second in range(20):
        pace.add(second, 2_000_000 * second)
    assert pace.rate() == pytest.approx(2_000_000)
    assert pace.remaining(100_000_000) == pytest.approx((100 - 38) / 2)


def test_recent_pace_dominates():
    pace = Pace(seconds=10)
    for second in range(40):
        pace.add(second, 100 * second if second < 20 else 2000 + 300 * (second - 20))
    assert pace.rate() == pytest.approx(300)


def test_unknown_at_the_start():
    pace = Pace()
    assert pace.rate() is None and pace.remaining(10) is None
    pace.add(1.0, 5)
    assert pace.rate() is None
    pace.add(9.0, 5)
    assert pace.rate() is None and pace.remaining(10) is None


def test_never_negative():
    pace = Pace()
    pace.add(0.0, 0)
    pace.add(1.0, 50)
    assert pace.remaining(40) == 0.0


@pytest.mark.parametrize(
    "seconds, text",
    [
        (None, "-:--"),
        (0, "0:00"),
        (59.7, "1:00"),
        (83, "1:23"),
        (3600, "1:00:00"),
        (36125, "10:02:05"),
    ],
)
def test_duration(seconds, text):
    assert duration(seconds) == text
