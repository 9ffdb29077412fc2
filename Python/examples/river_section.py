# SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
# SPDX-License-Identifier: BSD-3-Clause
"""A section through the river of vtkhelios new: surface, column and bed, and a waveform.

    build/venv/bin/python Python/examples/river_section.py OUT

A green scanner flies over the river. Echoes of the bed lie too deep, as light is slower in water;
vtkHeliosRefractionCorrection moves them to where they are. Output: OUT/river_section.png, the section
before and after the correction, and the waveform of one pulse. Prints how far the points are from the
true bed.
"""

import pathlib
import sys

import numpy as np

import vtkhelios
from vtkhelios.example_surveys import river, write_example

SECTION = 120.0  # its x, from the western edge [m]
HALF_WIDTH = 1.0  # [m]
SURFACE, BED = 9, 40  # classes
SPEED = 0.299792458  # speed of light [m/ns]


def fly(folder, **options):
    """The echoes of the first strip, with the truth and waveforms, and its trajectory."""
    survey = vtkhelios.read_survey(folder / "river.xml")
    cloud = survey.run(legs=0, truth=True, waveforms=True, noise=False, **options)
    return cloud, survey.trajectory(0)


def correct(cloud, trajectory, water):
    """The cloud with its echoes below the water where they are."""
    reader = vtkhelios.vtkHeliosObjSceneReader()
    reader.SetFileName(str(water))
    correction = vtkhelios.vtkHeliosRefractionCorrection()
    correction.SetInputData(0, cloud.data)
    correction.SetInputConnection(1, reader.GetOutputPort())
    correction.SetInputData(2, trajectory.data)
    vtkhelios.update(correction)
    return vtkhelios.Cloud(correction.GetOutput())


def errors(points, cloud):
    """Distances of the echoes of the bed from where they come from [m]."""
    bed = cloud["ClassificationIds"] == BED
    return np.linalg.norm(points[bed] - cloud["TruePoint"][bed], axis=1)


def waveform(cloud, row):
    """Times [ns] and powers [W] of the waveform of an echo."""
    table = vtkhelios.arrays(cloud.waveforms)
    i = int(np.flatnonzero(table["PulseIds"] == cloud["PulseIds"][row])[0])
    first, count = table["Offset"][i], table["Count"][i]
    times = table["StartTime"][i] + table["BinSize"][i] * np.arange(count)
    return times, table["Samples"][first : first + count]


def draw(cloud, corrected, path):
    import matplotlib

    matplotlib.use("Agg")
    from matplotlib import pyplot

    figure, (section, wave) = pyplot.subplots(
        1, 2, figsize=(11, 4), width_ratios=(3, 1.3), layout="constrained"
    )
    near = np.abs(cloud.points[:, 0] - river.WEST - SECTION) < HALF_WIDTH
    y = cloud.points[:, 1] - river.SOUTH
    kinds = cloud["ClassificationIds"]
    for label, points, mask, color in (
        ("banks and plants", cloud.points, ~np.isin(kinds, (SURFACE, BED)), "0.6"),
        ("surface of the water", cloud.points, kinds == SURFACE, "tab:blue"),
        ("bed, as measured", cloud.points, kinds == BED, "tab:orange"),
        ("bed, corrected", corrected.points, kinds == BED, "tab:green"),
    ):
        rows = near & mask
        section.scatter(points[rows, 1] - river.SOUTH, points[rows, 2], s=4, c=color, label=label)
    middle = river.middle_at(SECTION)
    section.set(
        xlim=(middle - 18, middle + 18), ylim=(river.WATER - 3.5, river.WATER + 3),
        xlabel="northing [m]", ylabel="height [m]",
    )  # fmt: skip
    section.legend(loc="upper center", ncols=2, markerscale=2)

    rows = np.flatnonzero(near & (kinds == BED))
    row = rows[np.argmin(np.abs(y[rows] - middle))]
    times, powers = waveform(cloud, row)
    wave.semilogx(np.maximum(powers, powers.max() * 1e-6), times)
    wave.invert_yaxis()
    wave.set(xlabel="received power [W]", ylabel="time [ns]", xlim=(powers.max() * 1e-4, None))
    echoes = np.flatnonzero(cloud["PulseIds"] == cloud["PulseIds"][row])
    for echo, name in zip(echoes, ("surface", "bed")):
        time = 2 * cloud["Range"][echo] / SPEED
        wave.axhline(time, color="0.8", lw=0.8)
        wave.annotate(name, (powers.max() * 1.5e-4, time), va="bottom")
    figure.savefig(path, dpi=110)


def main(arguments):
    if len(arguments) != 1:
        print(__doc__.strip(), file=sys.stderr)
        return 2
    out = pathlib.Path(arguments[0])
    folder = out / "river"
    if not folder.exists():
        write_example("river", folder)
    cloud, trajectory = fly(folder)
    corrected = correct(cloud, trajectory, folder / "water.obj")
    for name, points in (("measured", cloud.points), ("corrected", corrected.points)):
        distances = errors(points, cloud)
        print(f"bed, {name}: {np.median(distances):.3f} m from the truth, "
              f"95 % within {np.percentile(distances, 95):.3f} m")  # fmt: skip
    draw(cloud, corrected, out / "river_section.png")
    print(out / "river_section.png")
    return 0


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
