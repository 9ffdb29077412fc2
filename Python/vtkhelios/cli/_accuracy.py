# SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
# SPDX-License-Identifier: BSD-3-Clause
"""The accuracy of a run as text: from its summary, checked or not."""

MILLIMETRES, PERCENT = (1e3, " mm"), (1e2, " %")


def accuracy_lines(accuracy):
    """What was measured, what was asked, and the error of the reference itself."""
    if "reason" in accuracy:
        yield f"accuracy not measured: {accuracy['reason']}"
        return
    reference, asked = accuracy["reference"], accuracy.get("asked", {})
    without = " and ".join(accuracy["without"])
    yield (
        f"accuracy of {accuracy['echoes']:,} echoes of {accuracy['pulses']:,} pulses, computed again "
        f"with {reference['subRays']} sub-rays{f', without {without}' if without else ''}"
    )
    rows = (
        ("range error, median", "rangeP50_m", MILLIMETRES, None),
        ("range error, 95th percentile", "rangeP95_m", MILLIMETRES, "rangeTolerance_m"),
        ("missed echoes", "missed", PERCENT, None),
        ("invented echoes", "invented", PERCENT, None),
        ("missed and invented", "missedAndInvented", PERCENT, "energyTolerance"),
        ("amplitude, RMS of a full footprint", "amplitudeRms", PERCENT, "energyTolerance"),
    )
    for title, name, unit, tolerance in rows:
        wish = f", asked {number(asked[tolerance], unit)}" if tolerance in asked else ""
        yield (
            f"         {title + ':':36}{interval(accuracy[name], unit)}{wish}"
            f" (reference itself {number(reference[name][0], unit)})"
        )


def interval(estimate, unit):
    """A value and its confidence interval: 0.31 mm [0.2, 0.44]."""
    value, lower, upper = estimate
    return f"{number(value, unit)} [{number(lower, unit, '')}, {number(upper, unit, '')}]"


def number(value, unit, name=None):
    """A number in a unit, to three digits; below a nanometre, or a billionth: 0."""
    factor, own = unit
    text = f"{factor * value:.3g}" if value > 1e-9 else "0"
    return text + (own if name is None else name)
