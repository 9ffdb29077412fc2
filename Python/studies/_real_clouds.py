# SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
# SPDX-License-Identifier: BSD-3-Clause
"""Parts of real_clouds.py: the city model, facades, pictures."""

import numpy as np

import _study
import vtkhelios

from vtkhelios import formats

# Classes of the materials of a model of 3dfier, equal to the classes of its cloud.
CLASSES = {
    "Building": 6,
    "BuildingWall": 6,
    "Water": 9,
    "WaterWall": 9,
    "Forest": 1,
    "ForestWall": 1,
}
GROUND = 2  # all others
REFLECTANCE = 0.3
WALL, NEAR, STEP, HIGH = (
    0.1,
    0.5,
    1.0,
    2.0,
)  # |z| of a normal; distances, and height above the ground [m]
BAND = 2.0  # width of a section [m]

SCENE = """\
<document>
  <scene id="city" name="City">
    <part id="1">
      <filter type="objloader"><param type="string" key="filepath" value="city.obj"/></filter>
    </part>
  </scene>
</document>
"""


def read_cloud(path):
    """All points of a file as a Cloud."""
    with formats.open_reader(path) as reader:
        chunks = list(reader.chunks())
    columns = {name: np.concatenate([chunk[name] for chunk in chunks]) for name in chunks[0]}
    return vtkhelios.Cloud.from_arrays(columns.pop("points"), **columns)


def write_city(model, folder):
    """Copies a model with materials that have classes, and returns "file#id" of its scene."""
    names = set()
    with open(model) as source, open(folder / "city.obj", "w") as target:
        for line in source:
            if line.startswith("mtllib"):
                line = "mtllib city.mtl\n"
            elif line.startswith("usemtl"):
                names.add(line.split()[1])
            target.write(line)
    text = "".join(
        f"newmtl {name}\nhelios_reflectance {REFLECTANCE}\n"
        f"helios_classification {CLASSES.get(name, GROUND)}\n"
        for name in sorted(names)
    )
    (folder / "city.mtl").write_text(text)
    (folder / "city.xml").write_text(SCENE)
    return "city.xml#city"


def facade_share(mesh, points, box):
    """Share of the places of walls near a point, and their number. Places are the centres of pieces
    of about a square metre, 2 m and more above the lowest one nearby, within a box."""
    reader = vtkhelios.vtkHeliosObjSceneReader(file_name=str(mesh))
    scene = vtkhelios.Scene(vtkhelios.update(reader))
    places = wall_places(scene.points[scene.triangles])
    inside = ((places[:, :2] > box[0] + 2.0) & (places[:, :2] < box[1] - 2.0)).all(axis=1)
    places = places[inside]
    ground = np.percentile(places[:, 2], 2)
    places = places[places[:, 2] > ground + HIGH]
    return is_near(points, places).mean(), len(places)


def wall_places(corners):
    """Points on vertical triangles (n, 3, 3), one per square metre, at random (fixed seed)."""
    sides = corners[:, 1] - corners[:, 0], corners[:, 2] - corners[:, 0]
    normal = np.cross(*sides)
    area = 0.5 * np.linalg.norm(normal, axis=1)
    walls = (area > 0) & (np.abs(normal[:, 2]) <= WALL * 2 * area)
    random = np.random.default_rng(1)
    counts = random.poisson(area[walls] / STEP**2)
    rows = np.repeat(np.flatnonzero(walls), counts)
    a, b = random.random((2, len(rows)))
    a, b = np.where(a + b > 1, 1 - a, a), np.where(a + b > 1, 1 - b, b)
    return corners[rows, 0] + a[:, None] * sides[0][rows] + b[:, None] * sides[1][rows]


def is_near(points, places):
    """Returns whether each place has a point within NEAR, by VTK's locator."""
    from vtkmodules.vtkCommonDataModel import vtkStaticPointLocator
    from vtkmodules.vtkCommonCore import reference

    locator = vtkStaticPointLocator()
    locator.SetDataSet(vtkhelios.Cloud.from_arrays(points).polydata)
    locator.BuildLocator()
    distance = reference(0.0)
    return np.array(
        [locator.FindClosestPointWithinRadius(NEAR, place, distance) >= 0 for place in places]
    )


def separation_of(cloud):
    """Distance of successive echoes of a pulse [m] that 1 % fall below."""
    order = np.lexsort((cloud["ReturnNumber"], cloud["GpsTime"]))
    same = np.diff(cloud["GpsTime"][order]) == 0
    away = np.linalg.norm(np.diff(cloud.points[order], axis=0)[same], axis=1)
    return float(np.percentile(away, 1)) if len(away) else np.nan


def draw_section(real, simulated, out):
    """A section of 100 m through both clouds, one above the other."""
    figure, axes = _study.make_figure(1, 2, size=(8.0, 2.2))
    middle = np.median(simulated.points[:, :2], axis=0)
    for axis, cloud, name in zip(axes, (real, simulated), ("real: AHN3", "simulated")):
        away = cloud.points - np.r_[middle, 0.0]
        inside = (np.abs(away[:, 1]) < BAND / 2) & (np.abs(away[:, 0]) < 50)
        axis.plot(away[inside, 0], away[inside, 2], ".", ms=1)
        axis.set(title=name, ylabel="height [m]", aspect="equal", xlim=(-50, 50), ylim=(-1, 20))
    axes[1].set(xlabel="east [m]")
    _study.save_figure(figure, out / "ahn3.png")


def draw_forest(result, out):
    """The height profiles of both forests."""
    figure, axes = _study.make_figure(1, 1, size=(4.6, 3.2))
    profile = next(each for each in result.histograms if each.name == "height profile")
    for values, name in ((profile.a, "real: bcts"), (profile.b, "simulated")):
        axes[0].step(values, profile.edges[:-1], label=name, lw=1.2)
    axes[0].set(xscale="log", xlabel="share of the points", ylabel="height above the ground [m]")
    axes[0].legend()
    _study.save_figure(figure, out / "forest.png")
