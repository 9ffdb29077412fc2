# SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
# SPDX-License-Identifier: BSD-3-Clause
"""The accuracy of a run as text: from its summary, checked or not."""

from ..core.words import counted, digits

MILLIMETRES, PERCENT = (1e3, " mm"), (1e2, " %")


MEASURES = (  # title, key, unit, tolerance
    ("range error, median", "rangeP50_m", MILLIMETRES, None),
    ("range error, 95th percentile", "rangeP95_m", MILLIMETRES, "rangeTolerance_m"),
    ("missed echoes", "missed", PERCENT, None),
    ("invented echoes", "invented", PERCENT, None),
    ("missed and invented", "missedAndInvented", PERCENT, "energyTolerance"),
    ("amplitude, RMS of a full footprint", "amplitudeRms", PERCENT, "energyTolerance"),
)
ASKED = (  # the measures that a tolerance bounds: text, key, unit, tolerance
    ("95 % of the ranges within {}", "rangeP95_m", MILLIMETRES, "rangeTolerance_m"),
    ("{} of the echoes missed or invented", "missedAndInvented", PERCENT, "energyTolerance"),
    ("amplitudes within {} (RMS)", "amplitudeRms", PERCENT, "energyTolerance"),
)


def accuracy_line(accuracy):
    """Returns the accuracy of a run as one line."""
    if "reason" in accuracy:
        return f"accuracy not measured: {accuracy['reason']}"
    asked = accuracy.get("asked", {})
    parts = []
    for text, name, unit, tolerance in ASKED:
        value, least, _ = accuracy[name]
        own, wish = accuracy["reference"][name][0], asked.get(tolerance)
        is_known = wish is None or max(own, 1e-9) <= wish
        part = text.format(short(value, unit) if is_known else f"{short(own, unit)} or better")
        parts.append(part + (" (more than asked)" if wish is not None and least > wish else ""))
    wishes = ", ".join(short(asked[name], unit) for _, _, unit, name in ASKED if name in asked)
    return (
        f"accuracy {', '.join(parts)}; {f'asked {wishes}; ' if wishes else ''}"
        f"from {counted(accuracy['echoes'], 'echo')}"
    )


def short(value, unit):
    """Returns a number in a unit, to two digits; below a nanometre, or a billionth: 0."""
    factor, own = unit
    return digits(factor * value if value > 1e-9 else 0, 2) + own


def accuracy_lines(accuracy):
    """Yields the measured errors, the tolerances, and the error of the reference itself."""
    if "reason" in accuracy:
        yield accuracy_line(accuracy)
        return
    (_, head), *rows = accuracy_rows(accuracy)
    yield f"accuracy of {head}"
    for title, text in rows:
        yield f"         {title + ':':36}{text}"


def accuracy_rows(accuracy):
    """Yields the rows of a page, or of a text: titles and values. None: not measured."""
    if accuracy is None or "reason" in accuracy:
        yield "accuracy", "not measured" if accuracy is None else accuracy["reason"]
        return
    reference, asked = accuracy["reference"], accuracy.get("asked", {})
    without = " and ".join(accuracy["without"])
    yield (
        "accuracy",
        f"{counted(accuracy['echoes'], 'echo')} of {counted(accuracy['pulses'], 'pulse')}, computed again "
        f"{_method(reference)}{f', without {without}' if without else ''}",
    )
    for title, name, unit, tolerance in MEASURES:
        yield title, _result(accuracy, name, unit, asked.get(tolerance))


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
