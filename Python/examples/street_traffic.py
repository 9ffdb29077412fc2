# SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
# SPDX-License-Identifier: BSD-3-Clause
"""A street with traffic, as data for robots: pictures by radial velocity and by instance, and boxes.

    build/venv/bin/python Python/examples/street_traffic.py OUT

Makes the survey of vtkhelios new --kind street in OUT/street and runs it. Output:
OUT/street-velocity.png and OUT/street-instances.png, one scan from above and behind the car with the
sensor. Prints the echoes of each label, and the boxes of what moves.
"""

import collections
import pathlib
import sys

import numpy as np

import vtkhelios
from vtkhelios import formats, learning
from vtkhelios.array_names import RADIAL_VELOCITY
from vtkhelios.example_surveys import write_example

SCAN = 4  # the fifth of ten
EYE, PITCH, FOCUS = (
    np.array([-16.0, 3.5, 11.0]),
    -24.0,
    1.15,
)  # in the frame of the sensor [m], [deg]
EDGES = [
    (0, 1),
    (0, 2),
    (1, 3),
    (2, 3),
    (4, 5),
    (4, 6),
    (5, 7),
    (6, 7),
    (0, 4),
    (1, 5),
    (2, 6),
    (3, 7),
]
WALLS = (40, 48, 50)  # labels of what is grey: road, sidewalks, houses


def main(folder, **options):
    folder = pathlib.Path(folder)
    write_example("street", folder / "street")
    survey = vtkhelios.read_survey(folder / "street/street.xml")
    report = survey.run_to(
        folder / "street/output", "vtp", motion=True, velocities=True, tolerance=0.01, **options
    )
    with formats.open_reader(report["folder"]) as reader:
        content = learning.Content.of(reader, survey=survey)
        scan = list(learning.read_scans(reader, 0.1))[SCAN]
    labels = content.find_labels(scan.arrays)
    print(dict(sorted(collections.Counter(labels.tolist()).items())))
    boxes = content.find_boxes(scan.arrays, "a picture")
    for box in boxes:
        if box.moves:
            length, width, height = box.size
            name = content.parts.names[box.part]
            print(f"{name}: {box.points} echoes, {length:.2f} x {width:.2f} x {height:.2f} m")
    draw_velocities(folder / "street-velocity.png", scan)
    draw_instances(folder / "street-instances.png", scan, content, labels, boxes)
    return labels, boxes


def draw_velocities(path, scan):
    """Draws the radial velocity of every echo, of the car with the sensor, too."""
    speeds = scan.arrays[RADIAL_VELOCITY]
    figure, axes = make_axes()
    points, order = project(scan.points)
    drawn = axes.scatter(*points.T, c=speeds[order], s=0.7, cmap="turbo", vmin=-18, vmax=8, lw=0)
    bar = figure.colorbar(drawn, ax=axes, shrink=0.5, pad=0.01)
    bar.set_label("radial velocity [m/s], positive: moves away")
    figure.savefig(path, dpi=130, bbox_inches="tight", pad_inches=0.05)


def draw_instances(path, scan, content, labels, boxes):
    """Draws a colour for each object, and the boxes of vehicles and persons."""
    import matplotlib

    instances = content.find_instances(scan.arrays)
    palette = matplotlib.colormaps["tab20"](np.arange(20))[:, :3]
    colours = palette[(instances * 7) % 20]
    colours[np.isin(labels, WALLS)] = (0.36, 0.38, 0.42)
    figure, axes = make_axes()
    points, order = project(scan.points)
    axes.scatter(*points.T, c=colours[order], s=0.7, lw=0)
    signs = np.array([(x, y, z) for x in (-1, 1) for y in (-1, 1) for z in (-1, 1)])
    for box in boxes:
        center, turn = box.within(scan.pose)
        corners, _ = project((signs * box.size / 2) @ turn.T + center, is_sorted=False)
        for a, b in EDGES if len(corners) == 8 else ():
            axes.plot(*corners[[a, b]].T, color="orangered" if box.moves else "white", lw=0.7)
    figure.savefig(path, dpi=130, bbox_inches="tight", pad_inches=0.05)


def make_axes():
    """Returns a figure and axes of matplotlib, which it needs: 10 by 5.6 inches, dark."""
    import matplotlib

    matplotlib.use("Agg")
    from matplotlib import pyplot

    figure, axes = pyplot.subplots(figsize=(10, 5.6))
    axes.set_facecolor("0.08")
    axes.set(xlim=(-0.75, 0.75), ylim=(-0.42, 0.42), xticks=[], yticks=[], aspect="equal")
    return figure, axes


def project(points, is_sorted=True):
    """Returns the places in the picture of points before the camera, and their order: the far first."""
    pitch = np.radians(PITCH)
    forward = np.array([np.cos(pitch), 0.0, np.sin(pitch)])
    up = np.array([-np.sin(pitch), 0.0, np.cos(pitch)])
    moved = points - EYE
    depth = moved @ forward
    order = np.argsort(-depth) if is_sorted else np.arange(len(points))
    order = order[depth[order] > 1.0]
    across = np.column_stack([-moved[order, 1], moved[order] @ up])
    return FOCUS * across / depth[order, np.newaxis], order


if __name__ == "__main__":
    if len(sys.argv) != 2:
        sys.exit(__doc__)
    main(sys.argv[1])
