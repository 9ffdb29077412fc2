# SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
# SPDX-License-Identifier: BSD-3-Clause
"""Real airborne clouds against simulated ones: fit the instrument, fly it again, compare.

    HELIOS_DATA=... build/venv/bin/python Python/studies/real_clouds.py OUT [--quick]

Reads clouds of others from the folder real of HELIOS_DATA (see _study.real_data()), which are not part
of vtkHelios. Prints the tables of Docs/validation/ahn3.md and Docs/validation/forest.md, writes them as
CSV, and draws the pictures. --quick compares a tenth of the forest.
"""

import dataclasses
import errno
import functools
import os
import pathlib
import tempfile
import typing

import numpy as np

import _cloud_tables as tables
import _study
import vtkhelios

from _forest import write_forest
from _pages import Table

from _real_clouds import (
    draw_forest, draw_section, facade_share, read_cloud, separation_of, write_city,
)  # fmt: skip

SLOW = True  # for validation.py --quick: a minute or more
AHN3, MODEL = "als/ahn3_delft_1.laz", "scene/delft_testarea.obj"
FOREST = "als/bcts_1.laz", "als/bcts_2.laz"  # two tiles of the same strips
CLASSES = {1: "vegetation, cars", 2: "ground", 6: "buildings", 9: "water"}

# Values of a fit for the tables, with what is known otherwise.
CITY_KNOWN = {
    "pulse frequency": "",
    "pulse intervals": "the shorter is that of 400 kHz",
    "mirror": "",
    "line frequency": "",
    "sweep of a facet": "90 deg: a polygon of four facets",
    "smallest angle": "about -33 deg",
    "largest angle": "about 33 deg",
    "range noise": "",
    "returns per pulse, maximum": "",
    "echo separation": "",
    "pulse length": "",
    "beam divergence": "",
}
FOREST_KNOWN = {
    "pulse frequency": "100.0 kHz",
    "mirror": "",
    "line frequency": "65.02 Hz by the scan directions",
    "scan angle": "edge flags at 15 deg, in whole degrees",
    "law of motion": "",
    "range noise": "",
    "returns per pulse, maximum": "",
    "echo separation": "",
    "pulse length": "",
    "beam divergence": "",
}
CITY_STRIPS = {
    "height above ground": "420 to 440 m by scan angles",
    "speed": "48 to 69 m/s by scan angles",
}
FOREST_STRIPS = {"height above ground": "about 670 m by scan angles"}

FLOWN = ["", "real", "simulated", "difference", ""]
CITY_METRICS = (
    *("pulse density", "spacing along lines", "spacing across lines", "density"),
    *("returns per pulse", "multi-return share", "planar share of cells"),
    *("occluded in the other cloud", "share within 2 m of the mesh"),
)
FOREST_METRICS = (
    *("pulse density", "spacing along lines", "spacing across lines", "density"),
    *("returns per pulse", "multi-return share", "planar share of cells"),
    *("occluded in the other cloud", "mean height", "height profile, Kolmogorov-Smirnov"),
)
NOISE = "noise of planes, median"


@dataclasses.dataclass
class Flight:
    """A real cloud, the fit of its instrument, and the same flown again."""

    fit: typing.Any
    real: typing.Any
    simulated: typing.Any
    comparison: typing.Any
    pulses: list  # rows of strip_pulses()
    buildings: typing.Any = None  # comparison of class 6
    facades: tuple = ()  # shares of places with echoes, real and simulated; number of places


def fit_and_fly(clouds, folder, scene):
    """Fits clouds, writes the survey into a folder and flies it; the Fit and the echoes."""
    fit = vtkhelios.fit(*clouds)
    fit.write(folder, scene)
    survey = vtkhelios.read_survey(folder / "survey.xml", assets=[folder])
    return fit, survey.run(seed=1, scan_flags=True)


def compare(real, simulated, mesh=None):
    return vtkhelios.compare(real, simulated, mesh=mesh, points=5_000_000, sample=5000)


@functools.lru_cache(maxsize=1)
def fly_city(data):
    """AHN3 over Delft, flown again over the model that others made of this cloud."""
    with tempfile.TemporaryDirectory() as name:
        folder = pathlib.Path(name)
        scene = write_city(data / MODEL, folder)
        fit, simulated = fit_and_fly([data / AHN3], folder, scene)
        real = read_cloud(data / AHN3)
        pulses, area = tables.strip_pulses(real, simulated, fit.strips)
        pulses.append(["area of these pulses [m²]", f"{area:,.0f}", f"{area:,.0f}", "", ""])
        places, box = simulated.points[:, :2], np.array([real.points.min(0), real.points.max(0)])
        box = box[:, :2]
        simulated = simulated.filter(((places > box[0]) & (places < box[1])).all(axis=1))
        mesh = folder / "city.obj"
        shares = [facade_share(mesh, cloud.points, box) for cloud in (real, simulated)]
        roofs = [cloud.filter(cloud["ClassificationIds"] == 6) for cloud in (real, simulated)]
        return Flight(fit, real, simulated, compare(real, simulated, mesh), pulses, compare(*roofs),
                      (shares[0][0], shares[1][0], shares[0][1]))  # fmt: skip


@functools.lru_cache(maxsize=1)
def fly_forest(data, quick=False):
    """bcts, flown again over a forest of synthetic trees in its place; the clouds of the plot."""
    real = read_cloud(data / FOREST[0])
    ground = float(np.median(real.points[real["ClassificationIds"] == 2, 2]))
    centre = 0.5 * (real.points[:, :2].min(axis=0) + real.points[:, :2].max(axis=0))
    with tempfile.TemporaryDirectory() as name:
        folder = pathlib.Path(name)
        scene = write_forest(folder, centre, ground, side=30.0 if quick else 70.0)
        fit, simulated = fit_and_fly([data / name for name in FOREST], folder, scene)
    half = 14.0 if quick else 33.0
    parts = [
        cloud.filter((np.abs(cloud.points[:, :2] - centre) < half).all(axis=1))
        for cloud in (real, simulated)
    ]
    pulses, _ = tables.strip_pulses(*parts, fit.strips, np.inf)
    return Flight(fit, *parts, compare(*parts), pulses)


def fit_tables(page, fit, known, of_strips):
    """The tables of an instrument and of its strips."""
    titles = ["number", "found", "known otherwise"]
    yield Table(page, "instrument", titles, list(tables.instrument_rows(fit, known)))
    rows = list(tables.strip_rows(fit, of_strips))
    yield Table(page, "strips", tables.strip_titles(fit), rows)


def city_tables(flight):
    """The tables of ahn3.md."""
    page = "ahn3.md"
    yield from fit_tables(page, flight.fit, CITY_KNOWN, CITY_STRIPS)
    titles = ["incidence [deg]", "range noise [mm]", "planes"]
    yield Table(page, "noise", titles, list(tables.noise_rows(flight.fit)))
    real, simulated = flight.real, flight.simulated
    rows = list(flight.pulses)
    rows += [tables.metric_row(flight.comparison, name) for name in CITY_METRICS]
    rows.append(tables.metric_row(flight.comparison, NOISE, millimetres=True))
    rows.append(
        tables.metric_row(flight.buildings, NOISE, "noise of planes of buildings, median", True)
    )
    rows.append(tables.shift_row(flight.comparison))
    one, other, places = flight.facades
    name = f"places on facades with an echo, of {places:,} [%]"
    rows.append([name, f"{100 * one:.1f}", f"{100 * other:.1f}", "", ""])
    yield Table(page, "flown again", FLOWN, rows)
    titles = ["class", *(f"{name}: {what}" for name in ("real", "simulated")
                         for what in ("pulses", "returns per pulse"))]  # fmt: skip
    rows = list(tables.class_rows(real, simulated, CLASSES))
    yield Table(page, "classes", titles, rows)


def forest_tables(flight):
    """The tables of forest.md."""
    page = "forest.md"
    yield from fit_tables(page, flight.fit, FOREST_KNOWN, FOREST_STRIPS)
    rows = list(flight.pulses)
    rows += [tables.metric_row(flight.comparison, name) for name in FOREST_METRICS]
    rows.append(tables.metric_row(flight.comparison, NOISE, millimetres=True))
    both = [f"{separation_of(cloud):.2f}" for cloud in (flight.real, flight.simulated)]
    rows.append(["echo separation that 1 % fall below [m]", *both, "", ""])
    yield Table(page, "flown again", FLOWN, rows)


PAGES = (
    ((AHN3, MODEL), fly_city, city_tables),
    (FOREST, fly_forest, forest_tables),
)


def make_tables(data, _tools):
    """The tables of both pages; FileNotFoundError after those whose files are there."""
    absent = []
    for names, fly, make in PAGES:
        missing = [data / name for name in names if not (data / name).is_file()]
        absent += missing
        if not missing:
            yield from make(fly(data))
    if absent:
        raise FileNotFoundError(errno.ENOENT, os.strerror(errno.ENOENT), str(absent[0]))


def draw_figures(data, folder):
    city = fly_city(data)
    draw_section(city.real, city.simulated, folder)
    draw_forest(fly_forest(data).comparison, folder)


def main():
    options = _study.arguments(__doc__)
    data = _study.real_data()
    city, forest = fly_city(data), fly_forest(data, options.quick)
    for table in (*city_tables(city), *forest_tables(forest)):
        titles = [title or f"({column})" for column, title in enumerate(table.titles)]
        rows = [dict(zip(titles, row)) for row in table.rows]
        title = f"{table.page}, {table.name}"
        _study.print_table(rows, title)
        _study.write_csv(options.out / f"{title.replace(', ', '_')}.csv", rows)
    draw_section(city.real, city.simulated, options.out)
    draw_forest(forest.comparison, options.out)


if __name__ == "__main__":
    main()
