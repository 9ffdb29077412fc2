# SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
# SPDX-License-Identifier: BSD-3-Clause
"""The accuracy of a run as text: from its summary, checked or not."""

MILLIMETRES, PERCENT = (1e3, " mm"), (1e2, " %")


def accuracy_lines(accuracy):
    """Yields the measured errors, the tolerances, and the error of the reference itself."""
    if "reason" in accuracy:
        yield f"accuracy not measured: {accuracy['reason']}"
        return
    reference, asked = accuracy["reference"], accuracy.get("asked", {})
    without = " and ".join(accuracy["without"])
    yield (
        f"accuracy of {accuracy['echoes']:,} echoes of {accuracy['pulses']:,} pulses, computed again "
        f"{_method(reference)}{f', without {without}' if without else ''}"
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
        yield f"         {title + ':':36}{_result(accuracy, name, unit, asked.get(tolerance))}"


def _method(reference):
    """How the reference was computed."""
    if "subRays" in reference:  # a run of 0.2
        return f"with {reference['subRays']} sub-rays"
    range_error = number(reference["rangeTolerance_m"], MILLIMETRES)
    return f"within {range_error} and {number(reference['energyTolerance'], PERCENT)}"


def _result(accuracy, name, unit, asked):
    """Returns a measure, what was asked, and the error of the reference: a measure that the
    reference cannot
    confirm is given as its limit."""
    own = accuracy["reference"][name][0]
    wish = "" if asked is None else f", asked {number(asked, unit)}"
    if asked is not None and max(own, 1e-9) > asked:
        return f"cannot be told to better than {number(own, unit)}{wish}"
    return f"{interval(accuracy[name], unit)}{wish} (reference itself {number(own, unit)})"


def interval(estimate, unit):
    """Returns a value and its confidence interval: 0.31 mm [0.2, 0.44]."""
    value, lower, upper = estimate
    return f"{number(value, unit)} [{number(lower, unit, '')}, {number(upper, unit, '')}]"


def number(value, unit, name=None):
    """Returns a number in a unit, to three digits; below a nanometre, or a billionth: 0."""
    factor, own = unit
    text = f"{factor * value:.3g}" if value > 1e-9 else "0"
    return text + (own if name is None else name)
