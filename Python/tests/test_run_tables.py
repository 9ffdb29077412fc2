# SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
# SPDX-License-Identifier: BSD-3-Clause
"""Leg tables printed by vtkhelios run."""

import pytest

from vtkhelios.reports.run import table_lines


def make_leg(number, count):
    return {
        "leg": number,
        "start_s": 0.5,
        "duration_s": count / 1e5,
        "pulses": count,
        "pulsesFired": count,
        "points": count,
    }


def test_columns_of_common_numbers():
    lines = list(table_lines([make_leg(0, 1000)], [("bytes", 12, ["1.0 kB"])]))
    assert lines == [
        "legs    leg   start [s]   lasts [s]         pulses        emitted         points       bytes",
        "          0       0.500       0.010          1,000          1,000          1,000      1.0 kB",
    ]


@pytest.mark.parametrize("count", [10**9, 10**12, 10**18])
def test_columns_never_overlap(count):
    legs = [make_leg(0, 7), make_leg(123456, count)]
    lines = list(table_lines(legs, [("time [s]", 10, [0.5, count])]))
    assert len({len(line) for line in lines}) == 1
    assert [len(line.split()) for line in lines[1:]] == [7, 7]
    assert all("  " + word in lines[2] for word in lines[2].split()[1:])


def test_more_legs_than_are_shown():
    lines = list(table_lines([make_leg(k, k) for k in range(25)], []))
    assert len(lines) == 22 and lines[-1] == "         and 5 more"
