# SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
# SPDX-License-Identifier: BSD-3-Clause
"""The street of vtkhelios new --kind street: cars, bicyclists and persons that move."""

import numpy as np

from ._meshes import Mesh, write_tree
from ._tables import write_table
from .mls import KERB, LENGTH, make_houses

WALK = 0.12  # height of the sidewalks [m]
END = 1.5  # end of all trajectories [s]
WHEEL = (0.32, 0.11)  # wheel of a car: radius, half its width [m]
RIM = (0.34, 0.02)  # wheel of a bicycle
# x, y, z [m] at the start, heading (yaw clockwise from north) [deg], speed [m/s]
MOVERS = {
    "trajectory": (-30.0, -1.7, 0.0, 90.0, 7.0),  # the car with the scanner
    "car1": (-16.0, -1.7, 0.0, 90.0, 8.0),
    "car2": (22.0, 1.7, 0.0, 270.0, 10.0),
    "bicyclist1": (-12.0, -3.0, 0.0, 90.0, 5.0),
    "person1": (-14.0, -5.0, WALK, 90.0, 1.4),
    "person2": (-8.0, 5.2, WALK, 270.0, 1.2),
}
PARKED = [(-21.0, -1), (4.0, 1), (10.0, -1), (16.0, 1)]  # x, side


def write_geometry(folder):
    for name, mover in MOVERS.items():
        _write_trajectory(folder / f"{name}.csv", *mover)
    _make_road().write(folder / "road.obj")
    _make_sidewalks().write(folder / "sidewalks.obj")
    make_houses().write(folder / "houses.obj")
    _make_car().write(folder / "car.obj")
    _make_parked_car().write(folder / "parked.obj")
    _make_wheel("metal", *WHEEL).write(folder / "wheel.obj")
    _make_bicyclist().write(folder / "bicyclist.obj")
    _make_bicycle().write(folder / "bicycle.obj")
    _make_wheel("metal", *RIM).write(folder / "rim.obj")
    _make_person().write(folder / "person.obj")
    _make_leg().write(folder / "leg.obj")
    _make_pole().write(folder / "pole.obj")
    _make_sign().write(folder / "sign.obj")
    write_tree(folder / "tree.obj", "Broadleaf", 3, 6.0, 800, 3.5)
    write_table(folder / "things.csv", ("model", "id", "x", "y", "z", "yaw_deg"), _place_things())


def _write_trajectory(path, x, y, z, heading, speed):
    """Writes t [s], roll, pitch, yaw [deg], x, y, z [m], 10 rows a second: straight on."""
    names = ("t", "roll", "pitch", "yaw", "x", "y", "z")
    rows = [f'#HEADER: {", ".join(f"{chr(34)}{name}{chr(34)}" for name in names)}']
    sine, cosine = np.sin(np.radians(heading)), np.cos(np.radians(heading))
    for time in np.arange(0.0, END + 0.05, 0.1):
        way = speed * time
        row = (time, 0.0, 0.0, heading, x + way * sine, y + way * cosine, z)
        rows.append(", ".join(f"{value + 0.0:.4f}" for value in row))
    path.write_text("\n".join(rows) + "\n", encoding="utf-8")


def _place_things():
    """Yields the rows of things at rest: model, id, x, y, z, yaw anticlockwise."""
    for number, (x, side) in enumerate(PARKED, 3):
        yield "parked", f"car{number}", x, side * (KERB - 1.0), 0.0, -90.0 * side + 2.0 * side
    for number, x in enumerate((6.5, 7.2, 7.9), 2):
        yield "bicycle", f"bicycle{number}", x, -5.2, WALK, 8.0
    for number, x in enumerate(np.arange(-30.0, 31.0, 15.0).tolist(), 1):
        yield "pole", f"pole{number}", x, -KERB - 0.5, WALK, 0.0
    for number, x in enumerate((-19.0, 13.0), 1):
        yield "sign", f"sign{number}", x, KERB + 0.5, WALK, 90.0
    for number, x in enumerate(np.arange(-25.0, 36.0, 15.0).tolist(), 1):
        yield "tree", f"tree{number}", x, 5.9, WALK, 72.0 * number


def _make_road():
    road, half = Mesh(), LENGTH / 2
    x, y = np.meshgrid((-half, half), (-KERB, KERB))
    road.add_grid("asphalt", x, y, 0.0 * x)
    return road


def _make_sidewalks():
    sidewalks, half = Mesh(), LENGTH / 2
    for side in (-1, 1):
        low, high = sorted((side * KERB, side * (KERB + 17.5)))
        sidewalks.add_box("paving", (0.0, 0.0, 0.0), (-half, low, -0.2), (half, high, WALK))
    return sidewalks


def _make_car():
    """A car without wheels: x right, y forward, on the road, about the middle of its wheels."""
    car = Mesh()
    car.add_box("metal", (0.0, 0.0, 0.0), (-0.88, -2.1, 0.25), (0.88, 2.1, 0.85))
    _add_frustum(car, "glass", (0.82, -1.75, 0.75, 0.85), (0.62, -1.35, 0.15, 1.4))
    car.add_box("metal", (0.0, 0.0, 0.0), (-0.62, -1.35, 1.4), (0.62, 0.15, 1.46))
    return car


def _make_parked_car():
    """A car with its wheels."""
    car = _make_car()
    for x in (-0.75, 0.75):
        for y in (-1.3, 1.3):
            _add_wheel(car, "metal", (x, y, WHEEL[0]), *WHEEL)
    return car


def _make_bicyclist():
    """A bicycle with its rider, without wheels."""
    cyclist = _make_frame()
    cyclist.add_box("wood", (0.0, 0.0, 0.0), (-0.2, -0.35, 0.95), (0.2, 0.1, 1.5))
    cyclist.add_box("wood", (0.0, 0.0, 0.0), (-0.1, -0.12, 1.52), (0.1, 0.12, 1.78))
    for side in (-1, 1):
        low, high = sorted((0.1 * side, 0.22 * side))
        cyclist.add_box("wood", (0.0, 0.0, 0.0), (low, -0.25, 0.35), (high, -0.05, 0.98))
        low, high = sorted((0.2 * side, 0.28 * side))
        cyclist.add_box("wood", (0.0, 0.0, 0.0), (low, 0.0, 1.05), (high, 0.45, 1.15))
    return cyclist


def _make_bicycle():
    """A bicycle at rest, with its wheels."""
    bicycle = _make_frame()
    for y in (-0.52, 0.52):
        _add_wheel(bicycle, "metal", (0.0, y, RIM[0]), *RIM)
    return bicycle


def _make_frame():
    frame = Mesh()
    frame.add_box("metal", (0.0, 0.0, 0.0), (-0.02, -0.52, 0.5), (0.02, 0.5, 0.55))
    frame.add_box("metal", (0.0, 0.0, 0.0), (-0.02, -0.3, 0.3), (0.02, -0.25, 0.95))
    frame.add_box("metal", (0.0, 0.0, 0.0), (-0.02, 0.45, 0.3), (0.02, 0.5, 1.05))
    frame.add_box("metal", (0.0, 0.0, 0.0), (-0.28, 0.4, 1.02), (0.28, 0.45, 1.06))
    return frame


def _make_person():
    """A person without legs."""
    person = Mesh()
    person.add_box("wood", (0.0, 0.0, 0.0), (-0.2, -0.12, 0.82), (0.2, 0.12, 1.45))
    person.add_box("wood", (0.0, 0.0, 0.0), (-0.09, -0.11, 1.5), (0.09, 0.11, 1.74))
    for side in (-1, 1):
        low, high = sorted((0.22 * side, 0.31 * side))
        person.add_box("wood", (0.0, 0.0, 0.0), (low, -0.06, 0.8), (high, 0.06, 1.42))
    return person


def _make_leg():
    leg = Mesh()
    leg.add_box("wood", (0.0, 0.0, 0.0), (-0.07, -0.08, 0.06), (0.07, 0.08, 0.85))
    leg.add_box("wood", (0.0, 0.0, 0.0), (-0.06, -0.08, 0.0), (0.06, 0.2, 0.06))
    return leg


def _make_pole():
    pole = Mesh()
    pole.add_box("metal", (0.0, 0.0, 0.0), (-0.07, -0.07, 0.0), (0.07, 0.07, 6.0))
    pole.add_box("metal", (0.0, 0.0, 0.0), (-0.12, -0.1, 5.9), (0.12, 1.3, 6.05))
    return pole


def _make_sign():
    sign = Mesh()
    sign.add_box("metal", (0.0, 0.0, 0.0), (-0.03, -0.03, 0.0), (0.03, 0.03, 2.3))
    sign.add_box("metal", (0.0, 0.0, 0.0), (-0.3, 0.03, 2.0), (0.3, 0.05, 2.6))
    return sign


def _make_wheel(material, radius, half):
    wheel = Mesh()
    _add_wheel(wheel, material, (0.0, 0.0, 0.0), radius, half)
    return wheel


def _add_wheel(mesh, material, place, radius, half, sides=20):
    """Adds a cylinder about an axis along x."""
    angles = 2 * np.pi * np.arange(sides) / sides
    ring = np.column_stack([0 * angles, radius * np.cos(angles), radius * np.sin(angles)])
    points = np.vstack([ring - (half, 0, 0), ring + (half, 0, 0)]) + place
    after = [(side + 1) % sides for side in range(sides)]
    faces = [(side, sides + side, sides + after[side], after[side]) for side in range(sides)]
    faces += [tuple(range(sides))[::-1], tuple(range(sides, 2 * sides))]
    mesh.add(material, points, [face[::-1] for face in faces[:-2]] + faces[-2:])


def _add_frustum(mesh, material, low, high):
    """Adds a box that narrows upward; half its width, back, front and height, below and above."""
    points = [
        (side * half, y, z)
        for half, back, front, z in (low, high)
        for y in (back, front)
        for side in (-1, 1)
    ]
    faces = [(0, 2, 3, 1), (4, 5, 7, 6), (0, 1, 5, 4), (2, 6, 7, 3), (0, 4, 6, 2), (1, 3, 7, 5)]
    mesh.add(material, points, faces)
