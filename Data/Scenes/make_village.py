# SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
# SPDX-License-Identifier: BSD-3-Clause
"""Makes the village of the demo: a scene in the HELIOS dialect, with its OBJ files.

    python make_village.py FOLDER

FOLDER gets village_scene.xml (scene id "village"), terrain.obj, lane.obj, houses.obj, street.obj and
plants/*.obj. Trees and shrubs are few files that many parts of the scene name, each turned, scaled and
put onto the ground. Surveys for it are Data/Surveys/village_*.xml.
"""

import argparse
import math
import pathlib
import random

import numpy as np
import vtkhelios

SIDE = 240.0  # of the terrain [m]
SQUARES = 400  # of the terrain, a side
RELIEF = 16.0  # between its highest and lowest place at most [m]
LANE_WIDTH = 4.5

PLANTS = {  # name: (species, seed, height, leaves)
    "broadleaf_1": ("Broadleaf", 1, 12.0, 6000),
    "broadleaf_2": ("Broadleaf", 2, 10.0, 6000),
    "broadleaf_3": ("Broadleaf", 3, 14.0, 7000),
    "conifer_1": ("Conifer", 4, 15.0, 6000),
    "conifer_2": ("Conifer", 5, 12.0, 5000),
    "shrub_1": ("Shrub", 6, 1.5, 1000),
    "shrub_2": ("Shrub", 7, 1.3, 1000),
}

# Along the lane [m], beside it (positive: north of it) [m], length, height of the ridge [m], turn [deg];
# and what joins the house before it: moved by that much along its ridge [m].
HOUSES = [
    (-96, 15, 12, 8.0, 4),
    (-88, -14, 10, 7.0, -6),
    (-66, 14, 14, 8.6, 90),
    (-58, -15, 12, 8.0, 3),
    (-38, 15, 9, 6.6, -4),
    (-26, -17, 18, 8.4, 90),  # the barn
    (20, -14, 12, 8.2, 5),
    (42, 15, 13, 8.4, 0),
    (48, -15, 10, 7.2, 90),
    (70, 14, 11, 7.6, -3),
    (78, -14, 12, 8.0, 6),
    (98, 15, 9, 6.8, 0),
    (84, 20, 5, 3.4, 90),  # a shed
    (4, 19, 18, 12.5, 0),  # the church
    (4, 19, 6.5, 24.0, 0, -11.8),  # its tower
]


def lane(x):
    """The middle of the lane: y at x."""
    return 14.0 * np.sin(x / 34.0) + 5.0 * np.sin(x / 15.0 + 1.0)


def lane_slope(x):
    return 14.0 / 34.0 * np.cos(x / 34.0) + 5.0 / 15.0 * np.cos(x / 15.0 + 1.0)


def beside_lane(x, offset):
    """The place at that distance to the left of the lane, and the lane's heading there [deg]."""
    slope = lane_slope(x)
    norm = math.hypot(1.0, slope)
    heading = math.degrees(math.atan2(slope, 1.0))
    return x - offset * slope / norm, float(lane(x)) + offset / norm, heading


def fade(distance, width):
    """1 up to distance 0, 0 from the width on, smooth between."""
    t = np.clip(1.0 - distance / width, 0.0, 1.0)
    return t * t * (3.0 - 2.0 * t)


class Ground:
    """The hills, made level across the lane and below the houses."""

    def __init__(self):
        self.source = vtkhelios.vtkHeliosSyntheticScene()
        self.source.SetKindToTerrain()
        self.source.SetSize(SIDE)
        self.source.SetHeight(RELIEF)
        self.source.SetResolution(SQUARES)
        self.source.SetSeed(11)
        self.stations = np.linspace(-SIDE / 2 - 20, SIDE / 2 + 20, 281)
        hills = [self.source.GetTerrainHeight(x, float(lane(x))) for x in self.stations]
        self.profile = np.convolve(np.pad(hills, 12, mode="edge"), np.ones(25) / 25, mode="valid")
        self.pads = []

    def add_pad(self, x, y, heading, half_width, half_length, height=None):
        """Level ground for a house; returns its height."""
        height = float(self.height(x, y)) if height is None else height
        turn = math.radians(heading)
        self.pads.append((x, y, math.cos(turn), math.sin(turn), half_width + 1, half_length + 1, height))
        return height

    def level(self, x, y, hills):
        """The heights of the ground where those of the hills are given."""
        slope = lane_slope(x)
        foot = x + (y - lane(x)) * slope / (1.0 + slope * slope)  # the lane's nearest place, about
        across = np.hypot(x - foot, y - lane(foot))
        weight = fade(across - LANE_WIDTH / 2 - 1.0, 9.0)
        z = hills + weight * (np.interp(foot, self.stations, self.profile) - hills)
        for px, py, cos, sin, half_width, half_length, height in self.pads:
            u = np.abs((x - px) * cos + (y - py) * sin) - half_width
            v = np.abs((y - py) * cos - (x - px) * sin) - half_length
            away = np.hypot(np.maximum(u, 0.0), np.maximum(v, 0.0))
            z = z + fade(away, 4.0) * (height - z)
        return z

    def height(self, x, y):
        return self.level(np.float64(x), np.float64(y), self.source.GetTerrainHeight(x, y))

    def write(self, file):
        scene = vtkhelios.update(self.source)
        points = vtkhelios.arrays(scene)["points"]
        points[:, 2] = self.level(points[:, 0], points[:, 1], points[:, 2])
        write_scene(file, scene)


def write_scene(file, scene):
    file.parent.mkdir(parents=True, exist_ok=True)
    writer = vtkhelios.vtkHeliosObjSceneWriter()
    writer.SetFileName(str(file))
    writer.SetInputData(scene)
    if not writer.Write():
        raise OSError(f"could not write {file}")
    return scene.GetNumberOfCells()


class Faces:
    """Points and faces of a few materials, for what is simplest written down as text."""

    def __init__(self, materials):
        self.materials = materials  # name: (reflectance, class, is ground)
        self.lines = []
        self.count = 0

    def use(self, material):
        self.lines.append(f"usemtl {material}")

    def add(self, points, faces):
        """Faces by the numbers of the points, from 0."""
        self.lines += ["v {:.4f} {:.4f} {:.4f}".format(*point) for point in points]
        self.lines += ["f " + " ".join(str(self.count + 1 + i) for i in face) for face in faces]
        self.count += len(points)

    def add_box(self, centre, heading, low, high):
        cos, sin = math.cos(math.radians(heading)), math.sin(math.radians(heading))
        points = [(centre[0] + cos * x - sin * y, centre[1] + sin * x + cos * y, centre[2] + z)
                  for z in (low[2], high[2]) for y in (low[1], high[1]) for x in (low[0], high[0])]
        self.add(points, [(0, 2, 3, 1), (4, 5, 7, 6), (0, 1, 5, 4), (2, 6, 7, 3), (0, 4, 6, 2), (1, 3, 7, 5)])

    def write(self, file):
        mtl = [f"newmtl {name}\nKd {r} {r} {r}\nhelios_reflectance {r}\nhelios_classification {c}\n"
               f"helios_isGround {str(ground).lower()}\n"
               for name, (r, c, ground) in self.materials.items()]
        file.with_suffix(".mtl").write_text("\n".join(mtl))
        file.write_text("\n".join([f"mtllib {file.stem}.mtl", *self.lines, ""]))


def write_lane(file, ground):
    """A strip with buried edges; asphalt as in the ASTER library (0.30 at 1064, 0.36 at 1550 nm)."""
    faces = Faces({"asphalt": (0.33, 11, True)})
    faces.use("asphalt")
    half = LANE_WIDTH / 2
    section = [(-half - 0.05, -0.2), (-half, 0.03), (-half / 2, 0.05), (0, 0.06), (half / 2, 0.05),
               (half, 0.03), (half + 0.05, -0.2)]
    points = []
    for x in np.linspace(-SIDE / 2 + 4, SIDE / 2 - 4, 233):
        middle = float(ground.height(x, float(lane(x))))
        points += [beside_lane(x, offset)[:2] + (middle + up,) for offset, up in reversed(section)]
    n = len(section)
    rows = len(points) // n
    faces.add(points, [(i, i + 1, i + n + 1, i + n) for row in range(rows - 1)
                       for i in range(row * n, row * n + n - 1)])
    faces.write(file)


def write_street(file, ground):
    """Parked cars and lamp posts along the lane; reflectances assumed."""
    faces = Faces({"car_paint": (0.4, 1, False), "car_glass": (0.1, 1, False), "lamp_post": (0.5, 1, False)})
    for x, side in ((-74, -1), (-47, 1), (-14, -1), (-8, -1), (31, 1), (58, -1), (64, -1), (90, -1)):
        px, py, heading = beside_lane(x, side * (LANE_WIDTH / 2 + 1.1))
        centre = (px, py, float(ground.height(px, py)))
        faces.use("car_paint")
        faces.add_box(centre, heading, (-2.1, -0.85, 0.25), (2.1, 0.85, 0.85))
        for wheel in (-1.35, 1.35):
            faces.add_box(centre, heading, (wheel - 0.3, -0.8, -0.05), (wheel + 0.3, 0.8, 0.3))
        faces.use("car_glass")
        faces.add_box(centre, heading, (-1.3, -0.75, 0.84), (0.9, 0.75, 1.45))
    faces.use("lamp_post")
    for x in range(-105, 110, 30):
        px, py, heading = beside_lane(x, -(LANE_WIDTH / 2 + 0.7))
        centre = (px, py, float(ground.height(px, py)))
        faces.add_box(centre, heading, (-0.06, -0.06, -0.1), (0.06, 0.06, 5.5))
        faces.add_box(centre, heading, (-0.12, -0.1, 5.45), (0.12, 1.1, 5.6))
    faces.write(file)


def place_houses(ground):
    """(x, y, heading, half width, half length, height) of each, its z by a pad of the ground."""
    places = []
    for along, offset, length, height, turn, *shift in HOUSES:
        x, y, heading = beside_lane(along, offset)
        heading += turn + (-90 if offset > 0 else 90)  # the door, at +x, looks to the lane
        half_length, half_width = length / 2, 0.65 * length / 2
        z = places[-1][2] if shift else None
        for along_ridge in shift:
            x -= along_ridge * math.sin(math.radians(heading))
            y += along_ridge * math.cos(math.radians(heading))
        z = ground.add_pad(x, y, heading, half_width, half_length, z)
        places.append((x, y, z, heading, half_width, half_length, height))
    return places


def write_houses(file, places):
    composer = vtkhelios.vtkHeliosSceneComposer()
    for x, y, z, heading, _, half_length, height in places:
        house = vtkhelios.vtkHeliosSyntheticScene()
        house.SetKindToHouse()
        house.SetSize(2 * half_length)
        house.SetHeight(height)
        turn = math.radians(heading) / 2
        transform = vtkhelios.vtkHeliosSceneTransform()
        transform.SetInputConnection(house.GetOutputPort())
        transform.SetRotation(math.cos(turn), 0, 0, math.sin(turn))
        transform.SetTranslation(x, y, z - 0.05)
        composer.AddInputConnection(transform.GetOutputPort())
    return write_scene(file, vtkhelios.update(composer))


def is_free(x, y, houses, room):
    """Whether nothing but ground is that near."""
    near = np.linspace(x - 25, x + 25, 101)
    if np.min(np.hypot(near - x, lane(near) - y)) < LANE_WIDTH / 2 + 2.5 + room:
        return False
    for hx, hy, _, heading, half_width, half_length, _ in houses:
        turn = math.radians(heading)
        u = abs((x - hx) * math.cos(turn) + (y - hy) * math.sin(turn))
        v = abs((y - hy) * math.cos(turn) - (x - hx) * math.sin(turn))
        if u < half_width + 1 + room and v < half_length + 1 + room:
            return False
    return True


def place_plants(houses):
    """(name, x, y, turn [deg], scale) of gardens' trees, a wood on the north-west hill and hedges."""
    rng = random.Random(5)
    trees = []

    def try_tree(names, x, y, spacing):
        if (max(abs(x), abs(y)) < SIDE / 2 - 4 and is_free(x, y, houses, 3.5)
                and all(math.hypot(x - t[1], y - t[2]) > spacing for t in trees)):
            trees.append((rng.choice(names), x, y, rng.uniform(0, 360), rng.uniform(0.8, 1.25)))

    broadleaf = [name for name in PLANTS if name.startswith("broadleaf")]
    conifers = [name for name in PLANTS if name.startswith("conifer")]
    while len(trees) < 36:  # gardens and orchards
        along = rng.uniform(-112, 112)
        try_tree(broadleaf, *beside_lane(along, rng.choice((-1, 1)) * rng.uniform(7, 40))[:2], 6.5)
    while len(trees) < 70:  # the wood
        try_tree(conifers + broadleaf[:1], rng.gauss(-76, 16), rng.gauss(80, 12), 4.0)
    while len(trees) < 78:  # lone trees in the fields
        try_tree(broadleaf + conifers, rng.uniform(-110, 110), rng.uniform(-110, -60), 15)

    shrubs = []
    for first, last, offset in ((-106, -76, 6.5), (-70, -50, -6.5), (-46, -30, 6.5), (34, 58, 6.5),
                                (62, 92, -6.5)):
        for along in np.arange(first, last, 1.1):
            x, y, _ = beside_lane(float(along), offset)
            shrubs.append((rng.choice(("shrub_1", "shrub_2")), x, y, rng.uniform(0, 360), rng.uniform(0.85, 1.1)))
    return trees, shrubs


def write_plants(folder):
    count = {}
    for name, (species, seed, height, leaves) in PLANTS.items():
        plant = vtkhelios.vtkHeliosSyntheticScene()
        plant.SetKindToTree()
        getattr(plant, f"SetSpeciesTo{species}")()
        plant.SetSeed(seed)
        plant.SetHeight(height)
        plant.SetNumberOfLeaves(leaves)
        count[name] = write_scene(folder / f"{name}.obj", vtkhelios.update(plant))
    return count


def part_xml(name, file, place=None):
    """A part of the scene; place: x, y, turn [deg], scale, on the ground."""
    lines = [f'    <part id="{name}">',
             '      <filter type="objloader">',
             f'        <param type="string" key="filepath" value="{file}"/>',
             "      </filter>"]
    if place:
        x, y, turn, scale = place
        lines += ['      <filter type="rotate">',
                  '        <param type="rotation" key="rotation">',
                  f'          <rot axis="z" angle_deg="{turn:.1f}"/>',
                  "        </param>",
                  "      </filter>",
                  '      <filter type="scale">',
                  f'        <param type="double" key="scale" value="{scale:.3f}"/>',
                  "      </filter>",
                  '      <filter type="translate">',
                  '        <param type="integer" key="onGround" value="-1"/>',
                  f'        <param type="vec3" key="offset" value="{x:.3f};{y:.3f};0"/>',
                  "      </filter>"]
    return "\n".join(lines + ["    </part>"])


def write_xml(file, trees, shrubs):
    parts = [part_xml(name, f"{name}.obj") for name in ("terrain", "lane", "houses", "street")]
    for kind, plants in (("tree", trees), ("shrub", shrubs)):
        parts += [part_xml(f"{kind}_{i:02d}", f"plants/{name}.obj", place)
                  for i, (name, *place) in enumerate(plants, 1)]
    file.write_text('<?xml version="1.0" encoding="UTF-8"?>\n<document>\n'
                    '  <scene id="village" name="Village">\n' + "\n".join(parts) +
                    "\n  </scene>\n</document>\n")


def make_village(folder):
    """Writes everything; returns the number of triangles of the scene."""
    folder.mkdir(parents=True, exist_ok=True)
    ground = Ground()
    houses = place_houses(ground)
    trees, shrubs = place_plants(houses)
    write_lane(folder / "lane.obj", ground)
    write_street(folder / "street.obj", ground)
    count = write_houses(folder / "houses.obj", houses)
    plants = write_plants(folder / "plants")
    ground.write(folder / "terrain.obj")
    write_xml(folder / "village_scene.xml", trees, shrubs)
    return count + 2 * SQUARES**2 + sum(plants[name] for name, *_ in trees + shrubs)


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("folder", type=pathlib.Path, help="where the files go")
    folder = parser.parse_args().folder
    print(f"{folder / 'village_scene.xml'}: {make_village(folder):,} triangles and the lane")


if __name__ == "__main__":
    main()
