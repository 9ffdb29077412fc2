# SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
# SPDX-License-Identifier: BSD-3-Clause
"""Ghosts in a street: a shop front and a parked car with windows, from a mobile scanner.

    build/venv/bin/python Python/examples/street_ghosts.py OUT

Glass lets part of each pulse through, to what is inside, and reflects part, to what is opposite: that
appears behind the glass, where nothing is. Output: OUT/street_ghosts.png, the scene and the cloud from
above, and the files of the survey. Prints the number of echoes of each kind.
"""

import pathlib
import sys

import numpy as np

import vtkhelios

MATERIALS = """\
newmtl plaster
helios_reflectance 0.6
newmtl asphalt
helios_reflectance 0.2
newmtl goods
helios_reflectance 0.5
newmtl paint
helios_reflectance 0.4
newmtl glass
helios_optics pane
Ni 1.52
helios_thickness 0.008
"""
SCENE = """\
<document><scene id="street"><part><filter type="objloader">
<param type="string" key="filepath" value="street.obj"/></filter></part></scene></document>
"""
SURVEY = """\
<document><survey name="street" scene="scene.xml#street" platform="platforms.xml#car"
  scanner="scanners.xml#mobile_mls">
<leg><platformSettings x="-12" y="0" z="0.2" movePerSec_m="6"/><scannerSettings active="true"
  pulseFreq_hz="300000" scanFreq_hz="100" scanAngle_deg="180"/></leg>
<leg><platformSettings x="12" y="0" z="0.2" movePerSec_m="6"/><scannerSettings active="false"/></leg>
</survey></document>
"""
GLASS = 4  # its row in the materials
FACE = (0, 1, 3, 2)
BOX = [(0, 2, 3, 1), (4, 5, 7, 6), (0, 1, 5, 4), (2, 6, 7, 3), (0, 4, 6, 2), (1, 3, 7, 5)]


class Street:
    """Boxes and rectangles of materials, as an OBJ file."""

    def __init__(self):
        self.lines, self.count = ["mtllib street.mtl"], 0

    def add(self, material, points, faces):
        self.lines.append(f"usemtl {material}")
        self.lines += ["v {:g} {:g} {:g}".format(*point) for point in points]
        self.lines += ["f " + " ".join(str(self.count + 1 + i) for i in face) for face in faces]
        self.count += len(points)

    def box(self, material, x, y, z):
        self.add(material, [(a, b, c) for c in z for b in y for a in x], BOX)

    def wall(self, material, x, y, z):
        """A rectangle across y, or along it from y[0] to y[1]."""
        y = y if isinstance(y, tuple) else (y, y)
        self.add(material, [(a, b, c) for c in z for a, b in zip(x, y)], [FACE])


def make_street():
    street = Street()
    street.box("asphalt", (-40, 40), (-9, 18), (-0.2, 0))
    for x in ((-16, -4), (4, 16)):  # the house with the shop, beside its front
        street.wall("plaster", x, 6, (0, 8))
    street.wall("plaster", (-4, 4), 6, (0, 0.4))
    street.wall("plaster", (-4, 4), 6, (3, 8))
    street.wall("glass", (-4, 4), 6, (0.4, 3))
    street.wall("plaster", (-5, 5), 11, (0, 3.2))  # the shop
    for x in (-5, 5):
        street.wall("plaster", (x, x), (6.2, 11), (0, 3.2))
    for x in (-3, -1, 1, 3):
        street.box("goods", (x - 0.4, x + 0.4), (8.5, 9.0), (0, 1.8))
    street.wall("plaster", (-16, 16), -8, (0, 8))  # the houses opposite
    for x in (-7, 2, 7):
        street.box("paint", (x - 0.1, x + 0.1), (-6.6, -6.4), (0, 6))
    add_car(street, -2.0, -3.6)
    return street


def add_car(street, x, y):
    """A parked car along x: body, glazed cabin, seats."""
    street.box("paint", (x, x + 4.2), (y - 0.9, y + 0.9), (0.3, 0.9))
    cabin = (x + 1.0, x + 3.4)
    street.box("paint", cabin, (y - 0.8, y + 0.8), (1.45, 1.5))
    for side in (y - 0.8, y + 0.8):
        street.wall("glass", cabin, side, (0.9, 1.45))
    for end in cabin:
        street.wall("glass", (end, end), (y - 0.8, y + 0.8), (0.9, 1.45))
    for seat in (x + 1.5, x + 2.6):
        street.box("goods", (seat, seat + 0.2), (y - 0.6, y + 0.6), (0.9, 1.35))


def write_survey(folder):
    folder.mkdir(parents=True, exist_ok=True)
    for name, text in {
        "street.mtl": MATERIALS, "street.obj": "\n".join(make_street().lines) + "\n",
        "scene.xml": SCENE, "street.xml": SURVEY,
    }.items():  # fmt: skip
        (folder / name).write_text(text)
    return folder / "street.xml"


def classify(cloud):
    """0: seen directly, or glass across the beam, 1: through glass, 2: a ghost, far from its surface."""
    is_direct = (cloud["SpecularEvents"] == 0) | (cloud["MaterialIds"] == GLASS)
    away = np.linalg.norm(cloud.points - cloud["TruePoint"], axis=1)
    return np.where(is_direct, 0, np.where(away < 0.1, 1, 2))


def draw(cloud, kinds, path):
    import matplotlib

    matplotlib.use("Agg")
    from matplotlib import pyplot

    figure, axes = pyplot.subplots(figsize=(8.6, 8.8), layout="constrained")
    slab = (cloud.points[:, 2] > 0.1) & (cloud.points[:, 2] < 3)
    for kind, label, color in (
        (0, "seen directly", "0.55"), (1, "through glass", "tab:green"), (2, "ghosts", "tab:red")
    ):  # fmt: skip
        rows = slab & (kinds == kind)
        axes.plot(*cloud.points[rows, :2].T, ".", ms=1, color=color, label=label)
    axes.plot((-12, 12), (0, 0), "k--", lw=1)
    for text, place, target in (
        ("path of the scanner", (-15.5, 0.8), (-11, 0)),
        ("shop front, where it is\nacross the beam", (-13.5, 3.6), (-3.5, 6)),
        ("goods and back wall of the\nshop, through its front", (6.5, 8.2), (3.4, 9)),
        ("the houses opposite, mirrored\nby the shop front", (6.0, 17.5), (3, 20)),
        ("lamp post, mirrored", (6.0, 15.8), (2.2, 18.4)),
        ("parked car, mirrored", (-14.5, 14.5), (-1, 15.6)),
        ("parked car, with seats and\nghosts behind its windows", (4.5, -4.2), (2, -4)),
        ("houses and lamp posts opposite", (-15, -10.5), (-8, -8)),
    ):  # fmt: skip
        axes.annotate(text, target, place, va="center", arrowprops={"arrowstyle": "-", "lw": 0.7})
    axes.set(xlabel="x [m]", ylabel="y [m]", xlim=(-16, 16), ylim=(-12.5, 21.5), aspect="equal")
    axes.legend(loc="lower right", markerscale=10)
    figure.savefig(path, dpi=100)


def main(arguments):
    if len(arguments) != 1:
        print(__doc__.strip(), file=sys.stderr)
        return 2
    out = pathlib.Path(arguments[0])
    cloud = vtkhelios.read_survey(write_survey(out / "street")).run(truth=True, seed=1)
    kinds = classify(cloud)
    for kind, name in enumerate(("directly", "through glass", "ghosts")):
        print(f"{name}: {np.count_nonzero(kinds == kind):,} echoes")
    draw(cloud, kinds, out / "street_ghosts.png")
    print(out / "street_ghosts.png")
    return 0


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
