# SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
# SPDX-License-Identifier: BSD-3-Clause
"""A fit as text."""

import math

from ..core.words import counted

NAME, VALUE, UNCERTAINTY = 28, 24, 12
UNITS = {"rad": ("mrad", 1e3)}


def shown(value):
    """Returns a value with its unit and its uncertainty, rounded alike."""
    unit, factor = UNITS.get(value.unit, (value.unit, 1.0))
    if value.value is None:
        return f"{value.text} {unit}".rstrip() if value.text else "not known", ""
    if unit == "m" and abs(value.value) < 0.1:
        unit, factor = "mm", 1e3
    number = factor * value.value
    if not value.uncertainty or not math.isfinite(value.uncertainty):
        return f"{number:.4g} {unit}".rstrip(), ""
    error = factor * value.uncertainty
    digits = max(0, min(6, 1 - math.floor(math.log10(error))))
    text = f"{error:.{digits}f}" if error >= 1e-6 else f"{error:.0e}"
    return f"{number:.{digits}f} {unit}".rstrip(), f"+- {text}"


def fit_lines(fit):
    """Everything as text."""
    yield f"cloud    {fit.name}"
    for strip in fit.strips:
        duration = strip.times[-1] - strip.times[0]
        source = "" if strip.source is None else f", source {strip.source}"
        yield (
            f"strip {strip.number}{source}: {counted(strip.points, 'point')} of {counted(strip.pulses, 'pulse')} in "
            f"{duration:.2f} s from {strip.times[0]:.3f} s"
        )
    for number in (None, *(strip.number for strip in fit.strips)):
        yield ""
        yield "instrument" if number is None else f"strip {number}"
        for value in fit.values:
            if value.strip == number:
                text, error = shown(value)
                how = value.how.removeprefix("not known: ")
                yield f"  {value.name:{NAME}}{text:{VALUE}} {error:{UNCERTAINTY}} {how}"
    if fit.noise:
        yield ""
        yield "range noise on planes"
        for row in fit.noise:
            unit = " deg" if row.of == "incidence" else ""
            yield (
                f"  {row.of} {row.lower:.4g} to {row.upper:.4g}{unit}: {1e3 * row.noise:.1f} "
                f"+- {1e3 * row.uncertainty:.1f} mm, {counted(row.cells, 'plane')}"
            )
    yield ""
    yield "+- is the half width of a 95 % interval"
