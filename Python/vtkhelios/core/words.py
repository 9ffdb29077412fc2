# SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
# SPDX-License-Identifier: BSD-3-Clause
"""Numbers as words: durations, amounts, speeds."""

import math


def duration(seconds):
    """1:02:03, 2:03 or 0:03; dashes for None."""
    if seconds is None:
        return "-:--"
    whole = int(seconds + 0.5)
    hours, minutes = whole // 3600, whole // 60 % 60
    return f"{hours}:{minutes:02}:{whole % 60:02}" if hours else f"{minutes}:{whole % 60:02}"


def amount(count):
    """Returns a number of pulses or points: 20,850, 1.23 M."""
    return f"{count / 1e6:,.2f} M" if count >= 999_995 else f"{count:,}"


def speed(rate):
    """Returns a rate, to three digits: 0.25, 3,900, 1.23 M."""
    if rate >= 999_500:
        return f"{rate / 1e6:,.2f} M"
    if rate < 10:
        return f"{rate:.2g}"
    return f"{round(rate, 2 - math.floor(math.log10(rate))):,.0f}"
