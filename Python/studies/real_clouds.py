# SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
# SPDX-License-Identifier: BSD-3-Clause
"""Real airborne clouds against simulated ones: fit the instrument, fly it again, compare.

    build/venv/bin/python Python/studies/real_clouds.py OUT [--quick] [--data DIR]

Reads clouds of others from the folder real/ of HELIOS_DATA (without it: data of a folder "shared"
beside the repository), which are not part of vtkHelios. Prints the tables of Docs/validation/ahn3.md
and Docs/validation/forest.md and draws their pictures. --quick compares a tenth of the forest.
"""

import sys

import numpy as np

import _study
import vtkhelios

from vtkhelios.cli._fit_report import fit_lines

from _forest import write_forest
from _georeference import DATA

from _real_clouds import (
    draw_forest, draw_section, facade_share, pulse_rows, read_cloud, separation_of, shown, write_city,
)  # fmt: skip

AHN3, MODEL = "als/ahn3_delft_1.laz", "scene/delft_testarea.obj"
FOREST = "als/bcts_1.laz", "als/bcts_2.laz"  # two tiles of the same strips
EXPECTED = {  # of others, for the tables
    "AHN3 Delft": "about 400 kHz, +-33 deg, 420 to 440 m, 48 to 69 m/s by scan angles",
    "bcts": "100.0 kHz, 65.02 Hz, +-15 deg, about 670 m by scan angles",
}
METRICS = (
    *("pulse density", "density", "spacing along lines", "spacing across lines"),
    *(
        "returns per pulse",
        "multi-return share",
        "noise of planes, median",
        "planar share of cells",
    ),
    *("occluded in the other cloud", "mean height", "height profile, Kolmogorov-Smirnov"),
)


def fit_and_fly(clouds, folder, scene):
    """Fits clouds, writes the survey into a folder and flies it; the Fit and the echoes."""
    fit = vtkhelios.fit(*clouds)
    print("", *fit_lines(fit), sep="\n")
    fit.write(folder, scene)
    survey = vtkhelios.read_survey(folder / "survey.xml", assets=[folder])
    return fit, survey.run(seed=1, scan_flags=True)


def compare(real, simulated, mesh=None, points=5_000_000, title="real (A) against simulated (B)"):
    """Prints the metrics of two clouds."""
    result = vtkhelios.compare(real, simulated, mesh=mesh, points=points, sample=5000)
    names = {row.name for row in result.rows}
    rows = []
    for name in (*METRICS, *(name for name in sorted(names) if "mesh" in name)):
        if name in names:
            row = result[name]
            rows.append({"metric": name, "real": shown(row.a), "simulated": shown(row.b),
                         "difference": shown(row.difference), "unit": row.unit})  # fmt: skip
    _study.print_table(rows, title)
    print(result.registration)
    return result


def study_city(data, out):
    """AHN3 over Delft, flown again over the model that others made of this cloud."""
    folder = out / "ahn3"
    folder.mkdir(exist_ok=True)
    scene = write_city(data / MODEL, folder)
    _, simulated = fit_and_fly([data / AHN3], folder, scene)
    real = read_cloud(data / AHN3)
    box = real.points[:, :2].min(axis=0), real.points[:, :2].max(axis=0)
    inside = ((simulated.points[:, :2] > box[0]) & (simulated.points[:, :2] < box[1])).all(axis=1)
    simulated = simulated.filter(inside)
    compare(real, simulated, mesh=folder / "city.obj")
    roofs = [cloud.filter(cloud["ClassificationIds"] == 6) for cloud in (real, simulated)]
    compare(*roofs, title="buildings only (class 6)")
    _study.print_table(pulse_rows(real, simulated, (1, 2, 6, 9)), "by class")
    shares = [facade_share(folder / "city.obj", cloud.points, box) for cloud in (real, simulated)]
    rows = [{"facades with echoes": "share of 1 m places within 0.5 m of an echo", "places": shares[0][1],
             "real": shares[0][0], "simulated": shares[1][0]}]  # fmt: skip
    _study.print_table(rows)
    draw_section(real, simulated, out)


def study_forest(data, out, quick):
    """bcts, flown again over a forest of synthetic trees in its place."""
    folder = out / "forest"
    folder.mkdir(exist_ok=True)
    real = read_cloud(data / FOREST[0])
    ground = float(np.median(real.points[real["ClassificationIds"] == 2, 2]))
    centre = 0.5 * (real.points[:, :2].min(axis=0) + real.points[:, :2].max(axis=0))
    scene = write_forest(folder, centre, ground, side=30.0 if quick else 70.0)
    _, simulated = fit_and_fly([data / name for name in FOREST], folder, scene)
    half = 14.0 if quick else 33.0
    parts = [
        cloud.filter((np.abs(cloud.points[:, :2] - centre) < half).all(axis=1))
        for cloud in (real, simulated)
    ]
    result = compare(*parts)
    _study.print_table(pulse_rows(*parts, ()), "returns of pulses")
    rows = [{"cloud": name, "echo separation [m]": separation_of(cloud)}
            for name, cloud in zip(("real", "simulated"), parts)]  # fmt: skip
    _study.print_table(rows)
    draw_forest(result, out)


def main():
    data = DATA
    if "--data" in sys.argv:
        import pathlib

        place = sys.argv.index("--data")
        data = pathlib.Path(sys.argv[place + 1])
        del sys.argv[place : place + 2]
    options = _study.arguments(__doc__)
    for name, text in EXPECTED.items():
        print(f"{name}: expected {text}")
    study_city(data, options.out)
    study_forest(data, options.out, options.quick)


if __name__ == "__main__":
    main()
