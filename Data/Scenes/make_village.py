# SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
# SPDX-License-Identifier: BSD-3-Clause
"""Makes the village of the demo: a scene in the HELIOS dialect, with its OBJ files.

    python make_village.py FOLDER

FOLDER gets village_scene.xml (scene id "village"), terrain.obj, lane.obj, houses.obj, street.obj
and plants/*.obj. Trees and shrubs are few files that many parts of the scene name, each turned,
scaled and put onto the ground. Surveys for it are Data/Surveys/village_*.xml.
"""

import argparse
import dataclasses
import math
import pathlib
import random
import sys

import numpy as np
import vtkhelios

SIDE = 240.0  # side of the terrain [m]
SQUARES = 400  # squares at a side of the terrain
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

# Along the lane [m], beside it (positive: north of it) [m], length, height of the ridge [m],
# turn [deg]; for what joins the house before it: moved by that much along its ridge [m].
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

# Parked cars: along the lane [m], and on which side of it.
CARS = [(-74, -1), (-47, 1), (-14, -1), (-8, -1), (31, 1), (58, -1), (64, -1), (90, -1)]

# Hedges: from, to along the lane [m], beside it [m].
HEDGES = [(-106, -76, 6.5), (-70, -50, -6.5), (-46, -30, 6.5), (34, 58, 6.5), (62, 92, -6.5)]


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


@dataclasses.dataclass
class House:
    """Where a house stands, its ridge along its y."""

    x: float
    y: float
    z: float
    heading: float  # angle of its x [deg]
    length: float
    height: float

    def get_distance(self, x, y):
        """How far a place is from the walls, 0 within."""
        turn = math.radians(self.heading)
        across = (x - self.x) * math.cos(turn) + (y - self.y) * math.sin(turn)
        along = (y - self.y) * math.cos(turn) - (x - self.x) * math.sin(turn)
        across = np.abs(across) - 0.65 * self.length / 2
        along = np.abs(along) - self.length / 2
        return np.hypot(np.maximum(across, 0.0), np.maximum(along, 0.0))


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
        self.houses = []

    def level(self, x, y, hills):
        """Returns the heights of the ground for the heights of the hills."""
        slope = lane_slope(x)
        foot = x + (y - lane(x)) * slope / (1.0 + slope * slope)  # the lane's nearest place, about
        across = np.hypot(x - foot, y - lane(foot))
        weight = fade(across - LANE_WIDTH / 2 - 1.0, 9.0)
        z = hills + weight * (np.interp(foot, self.stations, self.profile) - hills)
        for house in self.houses:
            z = z + fade(house.get_distance(x, y) - 1.0, 4.0) * (house.z - z)
        return z

    def get_height(self, x, y):
        hills = self.source.GetTerrainHeight(x, y)
        return float(self.level(np.float64(x), np.float64(y), hills))

    def write(self, file):
        scene = vtkhelios.update(self.source)
        points = vtkhelios.arrays(scene)["points"]
        points[:, 2] = self.level(points[:, 0], points[:, 1], points[:, 2])
        return write_scene(file, scene)


def write_scene(file, scene):
    file.parent.mkdir(parents=True, exist_ok=True)
    writer = vtkhelios.vtkHeliosObjSceneWriter()
    writer.SetFileName(str(file))
    writer.SetInputData(scene)
    if not writer.Write():
        raise OSError(f"could not write {file}")
    return scene.GetNumberOfCells()


BOX_FACES = [(0, 2, 3, 1), (4, 5, 7, 6), (0, 1, 5, 4), (2, 6, 7, 3), (0, 4, 6, 2), (1, 3, 7, 5)]


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
        points = [
            (centre[0] + cos * x - sin * y, centre[1] + sin * x + cos * y, centre[2] + z)
            for z in (low[2], high[2])
            for y in (low[1], high[1])
            for x in (low[0], high[0])
        ]
        self.add(points, BOX_FACES)

    def write(self, file):
        mtl = []
        for name, (reflectance, classification, is_ground) in self.materials.items():
            mtl += [
                f"newmtl {name}",
                f"Kd {reflectance} {reflectance} {reflectance}",
                f"helios_reflectance {reflectance}",
                f"helios_classification {classification}",
                f"helios_isGround {str(is_ground).lower()}",
                "",
            ]
        file.with_suffix(".mtl").write_text("\n".join(mtl), encoding="utf-8")
        obj = [f"mtllib {file.stem}.mtl", *self.lines, ""]
        file.write_text("\n".join(obj), encoding="utf-8")


def write_lane(file, ground):
    """A strip with buried edges; asphalt by the ASTER library (0.30 at 1064, 0.36 at 1550 nm)."""
    faces = Faces({"asphalt": (0.33, 11, True)})
    faces.use("asphalt")
    half = LANE_WIDTH / 2
    section = [
        (-half - 0.05, -0.2),
        (-half, 0.03),
        (-half / 2, 0.05),
        (0, 0.06),
        (half / 2, 0.05),
        (half, 0.03),
        (half + 0.05, -0.2),
    ]
    points = []
    for x in np.linspace(-SIDE / 2 + 4, SIDE / 2 - 4, 233):
        middle = ground.get_height(x, float(lane(x)))
        points += [beside_lane(x, offset)[:2] + (middle + up,) for offset, up in reversed(section)]
    n = len(section)
    corners = [i for i in range(len(points) - n) if i % n < n - 1]
    faces.add(points, [(i, i + 1, i + n + 1, i + n) for i in corners])
    faces.write(file)


def write_street(file, ground):
    """Parked cars and lamp posts along the lane; reflectances assumed."""
    faces = Faces(
        {
            "car_paint": (0.4, 1, False),
            "car_glass": (0.1, 1, False),
            "lamp_post": (0.5, 1, False),
        }
    )
    for x, side in CARS:
        px, py, heading = beside_lane(x, side * (LANE_WIDTH / 2 + 1.1))
        centre = (px, py, ground.get_height(px, py))
        faces.use("car_paint")
        faces.add_box(centre, heading, (-2.1, -0.85, 0.25), (2.1, 0.85, 0.85))
        for wheel in (-1.35, 1.35):
            faces.add_box(centre, heading, (wheel - 0.3, -0.8, -0.05), (wheel + 0.3, 0.8, 0.3))
        faces.use("car_glass")
        faces.add_box(centre, heading, (-1.3, -0.75, 0.84), (0.9, 0.75, 1.45))
    faces.use("lamp_post")
    for x in range(-105, 110, 30):
        px, py, heading = beside_lane(x, -(LANE_WIDTH / 2 + 0.7))
        centre = (px, py, ground.get_height(px, py))
        faces.add_box(centre, heading, (-0.06, -0.06, -0.1), (0.06, 0.06, 5.5))
        faces.add_box(centre, heading, (-0.12, -0.1, 5.45), (0.12, 1.1, 5.6))
    faces.write(file)


def place_houses(ground):
    """The houses, one after the other, each on ground that it levels."""
    for along, offset, length, height, turn, *shift in HOUSES:
        x, y, heading = beside_lane(along, offset)
        heading += turn + (-90 if offset > 0 else 90)  # the door, at +x, looks to the lane
        for along_ridge in shift:
            x -= along_ridge * math.sin(math.radians(heading))
            y += along_ridge * math.cos(math.radians(heading))
        z = ground.houses[-1].z if shift else ground.get_height(x, y)
        ground.houses.append(House(x, y, z, heading, length, height))
    return ground.houses


def write_houses(file, houses):
    composer = vtkhelios.vtkHeliosSceneComposer()
    for house in houses:
        source = vtkhelios.vtkHeliosSyntheticScene()
        source.SetKindToHouse()
        source.SetSize(house.length)
        source.SetHeight(house.height)
        turn = math.radians(house.heading) / 2
        transform = vtkhelios.vtkHeliosSceneTransform()
        transform.SetInputConnection(source.GetOutputPort())
        transform.SetRotation(math.cos(turn), 0, 0, math.sin(turn))
        transform.SetTranslation(house.x, house.y, house.z - 0.05)
        composer.AddInputConnection(transform.GetOutputPort())
    return write_scene(file, vtkhelios.update(composer))


def is_free(x, y, houses):
    """Returns whether there is room for a tree: not over the lane, not over a roof."""
    near = np.linspace(x - 25, x + 25, 101)
    away = np.min(np.hypot(near - x, lane(near) - y))
    return away > LANE_WIDTH / 2 + 6.0 and all(h.get_distance(x, y) > 4.5 for h in houses)


def place_plants(houses):
    """(name, x, y, turn [deg], scale) of each tree: gardens, a wood, fields; and of each shrub."""
    rng = random.Random(5)
    trees = []

    def try_tree(names, x, y, spacing):
        if (
            max(abs(x), abs(y)) < SIDE / 2 - 4
            and is_free(x, y, houses)
            and all(math.hypot(x - t[1], y - t[2]) > spacing for t in trees)
        ):
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
    for first, last, offset in HEDGES:
        for along in np.arange(first, last, 1.1):
            x, y, _ = beside_lane(float(along), offset)
            name = rng.choice(("shrub_1", "shrub_2"))
            shrubs.append((name, x, y, rng.uniform(0, 360), rng.uniform(0.85, 1.1)))
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


PART = """\
    <part id="{name}">
      <filter type="objloader">
        <param type="string" key="filepath" value="{file}"/>
      </filter>{place}
    </part>
"""
PLACE = """
      <filter type="rotate">
        <param type="rotation" key="rotation"><rot axis="z" angle_deg="{turn:.1f}"/></param>
      </filter>
      <filter type="scale">
        <param type="double" key="scale" value="{scale:.3f}"/>
      </filter>
      <filter type="translate">
        <param type="integer" key="onGround" value="-1"/>
        <param type="vec3" key="offset" value="{x:.3f};{y:.3f};0"/>
      </filter>"""
SCENE = """\
<?xml version="1.0" encoding="UTF-8"?>
<document>
  <scene id="village" name="Village">
{parts}  </scene>
</document>
"""


def write_xml(file, trees, shrubs):
    parts = [
        PART.format(name=name, file=f"{name}.obj", place="")
        for name in ("terrain", "lane", "houses", "street")
    ]
    for kind, plants in (("tree", trees), ("shrub", shrubs)):
        for i, (name, x, y, turn, scale) in enumerate(plants, 1):
            place = PLACE.format(x=x, y=y, turn=turn, scale=scale)
            parts.append(
                PART.format(name=f"{kind}_{i:03d}", file=f"plants/{name}.obj", place=place)
            )
    file.write_text(SCENE.format(parts="".join(parts)), encoding="utf-8")


def make_village(folder):
    """Writes everything; returns the number of triangles of the scene."""
    folder.mkdir(parents=True, exist_ok=True)
    ground = Ground()
    houses = place_houses(ground)
    trees, shrubs = place_plants(houses)
    write_lane(folder / "lane.obj", ground)
    write_street(folder / "street.obj", ground)
    count = ground.write(folder / "terrain.obj") + write_houses(folder / "houses.obj", houses)
    plants = write_plants(folder / "plants")
    write_xml(folder / "village_scene.xml", trees, shrubs)
    return count + sum(plants[name] for name, *_ in trees + shrubs)


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("folder", type=pathlib.Path, help="where the files go")
    folder = parser.parse_args().folder
    try:
        count = make_village(folder)
    except OSError as error:
        sys.exit(f"make_village.py: {error}")
    print(f"{folder / 'village_scene.xml'}: {count:,} triangles and the lane")


if __name__ == "__main__":
    main()
