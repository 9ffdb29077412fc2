# SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
# SPDX-License-Identifier: BSD-3-Clause
"""Rate and remaining time of a run."""

import time

import pytest

from vtkhelios.cli._messages import Messages
from vtkhelios.cli._progress import Lines, Pace
from vtkhelios.core.words import amount, duration, speed


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


@pytest.mark.parametrize(
    "count, text",
    [(0, "0"), (7, "7"), (20_850, "20,850"), (999_999, "1.00 M"), (1_234_567, "1.23 M")],
)
def test_amount(count, text):
    assert amount(count) == text


@pytest.mark.parametrize(
    "rate, text",
    [
        (0.254, "0.25"),
        (3.14, "3.1"),
        (42.4, "42"),
        (3912.0, "3,910"),
        (123_456.0, "123,000"),
        (999_600.0, "1.00 M"),
        (2_345_678.0, "2.35 M"),
    ],
)
def test_speed(rate, text):
    assert speed(rate) == text


class Slow:
    """A player that reports once."""

    def AddObserver(self, _event, callback):
        self.report = callback
        return 1

    def RemoveObserver(self, _tag):
        pass

    def GetMessage(self):
        return "building a tree"

    def GetProgress(self):
        return 0.25

    def GetCount(self, _name):
        return 0


def test_lines_are_repeated_while_nothing_is_reported(capfd, monkeypatch):
    monkeypatch.setattr(Lines, "seconds_between", 0.2)
    player = Slow()
    with Messages() as messages, Lines(player, messages):
        player.report()
        time.sleep(1.5)
    lines = capfd.readouterr().err.splitlines()
    assert len(lines) >= 2 and set(lines) == {" 25 % building a tree"}
