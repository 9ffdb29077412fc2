# SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
# SPDX-License-Identifier: BSD-3-Clause
"""Rows of the tables of ahn3.md and forest.md: a fit, and a real cloud against a simulated one."""

import numpy as np

from vtkhelios.reports.fit import shown

SQUARE = 2.0  # side of the squares in which pulses of strips are counted [m]
STRIP_VALUES = ("height above ground", "speed", "course", "angle residual")
ATTITUDE = ("roll", "pitch", "yaw off the course")  # keys of Strip.angles
VERDICTS = {True: "agrees", False: "differs", None: ""}


def instrument_rows(fit, known):
    """Values of an instrument, with their intervals, in the order of known: name and what others say."""
    for name, text in known.items():
        value, error = shown(fit[name])
        yield [name, f"{value} {error}".strip(), text]


def strip_rows(fit, known):
    """Values of the strips, and the smallest and largest attitude along each trajectory."""
    numbers = [strip.number for strip in fit.strips]
    for name in STRIP_VALUES:
        found = [" ".join(shown(fit.of_strip(name, number))).strip() for number in numbers]
        yield [name, *found, known.get(name, "")]
    for column, name in enumerate(ATTITUDE):
        found = [attitude_range(fit, strip, column) for strip in fit.strips]
        yield [name, *found, known.get(name, "")]


def attitude_range(fit, strip, column):
    """Smallest and largest angle of a column of ATTITUDE as text [deg]."""
    angles = strip.angles[:, column]
    if column == 2:
        course = fit.of_strip("course", strip.number).value
        angles = (angles - course + 180.0) % 360.0 - 180.0
    return f"{angles.min():.1f} to {angles.max():.1f} deg"


def strip_titles(fit):
    return ["number", *(f"strip {strip.number}" for strip in fit.strips), "known otherwise"]


def noise_rows(fit):
    """Range noise [mm] of planes by incidence [deg]."""
    for row in fit.noise:
        if row.of == "incidence":
            noise = f"{1e3 * row.noise:.1f} +- {1e3 * row.uncertainty:.1f}"
            yield [f"{row.lower:.0f} to {row.upper:.0f}", noise, f"{row.cells:,}"]


def shown_estimate(estimate, factor=1.0):
    """A value and the ends of its interval, as far as there are any."""
    if estimate is None:
        return ""
    value, low, high = (factor * each + 0.0 for each in estimate)
    return f"{value:.4g}" if np.isnan(low) else f"{value:.4g} [{low:.4g}, {high:.4g}]"


def metric_row(result, name, title="", millimetres=False):
    """A metric of a Comparison: both values, their difference, and whether they agree."""
    row = result[name]
    unit, factor = ("mm", 1e3) if millimetres else (row.unit, 1.0)
    title = f"{title or name} [{unit}]" if unit else title or name
    cells = [shown_estimate(each, factor) for each in (row.a, row.b, row.difference)]
    return [title, *cells, VERDICTS[row.agrees]]


def shift_row(result):
    """Returns the height of the planes of the second cloud above the first cloud's."""
    shift = result.shift[2]
    if shift is None:
        shift = "not determined"
    else:
        shift = "{:.1f} [{:.1f}, {:.1f}]".format(*(1e3 * each for each in shift))
    return ["height of the simulated planes above the real [mm]", "", "", shift, ""]


def count_row(name, real, simulated):
    """Two numbers, and how much larger the second is."""
    ratio = f"{100 * (simulated / real - 1):+.1f} %" if real else ""
    return [name, f"{real:,}", f"{simulated:,}", ratio, ""]


def strip_pulses(real, simulated, strips, side=SQUARE):
    """First returns of each strip in squares [m] with first returns of both clouds: rows of counts, and
    the area of the squares [m²]. strips: of a Fit; simulated legs have their order. An infinite
    side counts all."""
    corner = np.minimum(real.points.min(axis=0), simulated.points.min(axis=0))[:2]
    clouds = []
    for cloud in (real, simulated):
        first = cloud["ReturnNumber"] == 1
        places = np.floor((cloud.points[first, :2] - corner) / side).astype(np.int64)
        clouds.append((places @ [1 << 32, 1], cloud["LegIds"][first]))
    shared = np.intersect1d(clouds[0][0], clouds[1][0])
    rows = []
    for leg, strip in enumerate(strips):
        of_strip = [each[0][each[1] == number] for each, number in zip(clouds, (strip.source, leg))]
        counts = [np.count_nonzero(np.isin(squares, shared)) for squares in of_strip]
        rows.append(count_row(f"pulses of strip {strip.number}", *counts))
    return rows, side**2 * len(shared)


def class_rows(real, simulated, names):
    """First returns of classes, and their returns per pulse. names: of the classes."""
    for number, name in names.items():
        cells = [f"{number} ({name})"]
        for cloud in (real, simulated):
            first = (cloud["ReturnNumber"] == 1) & (cloud["ClassificationIds"] == number)
            returns = cloud["NumberOfReturns"][first]
            cells += [f"{len(returns):,}", f"{returns.mean():.2f}" if len(returns) else ""]
        yield cells
