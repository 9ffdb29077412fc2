# SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
# SPDX-License-Identifier: BSD-3-Clause
"""The leaf area of a tree from terrestrial scans, against the true leaf area.

    build/venv/bin/python Python/studies/leaf_area.py OUT [--quick]

Beams with a path length l [m] in a voxel and n leaf hits give its leaf area density [m2/m3]:

    (n - m / L) / (G L),    L = sum of l, m = sum of l of the beams that hit a leaf there

the maximum of the likelihood of Beer and Lambert's law, n / L, less its bias where n is small (F.
Pimont et al. 2018, Remote Sensing of Environment 215, 343); G = 0.5 for uniform leaf orientation
(J. Ross 1981). First in a box of randomly placed triangles, where this is exact, then in a tree.
"""

import statistics
import typing

import numpy as np
from vtkmodules.util.numpy_support import vtk_to_numpy

import _study
import vtkhelios
from _voxels import Grid

G = 0.5  # the mean of |cos| between a beam and the normals of leaves
TRIPOD = 1.7  # m, from the tripod's foot to the beam origin
EDGE = 0.043  # m, of the triangles in the box
WAIST = 0.5 * 0.35e-3  # the beam's radius at 1/e2, over the distance
LEAF = 0.4  # reflectance
FIRST_RADIUS = 1.05  # radius of the beam, in w, for first echoes: measured here, not theory
WEAK = 0.1  # apparent reflectance of the weakest strong echo, over a leaf's


class Stand:
    """A scene of leaves and other objects, with its true values."""

    def __init__(self, scene, leaves):
        self.scene, self.leaves = scene, leaves  # leaves: a boolean for every triangle
        self.corners = scene.points[scene.triangles[leaves]]
        sides = self.corners[:, 1:] - self.corners[:, :1]
        self.areas = np.linalg.norm(np.cross(sides[:, 0], sides[:, 1]), axis=1) / 2

    @property
    def box(self):
        return self.corners.min(axis=(0, 1)) - 1e-6, self.corners.max(axis=(0, 1)) + 1e-6

    def area_in(self, grid):
        """The leaf area in every voxel [m2]; each triangle is assigned by the centres of its 16 parts."""
        up = [(i + 1 / 3, j + 1 / 3) for i in range(4) for j in range(4 - i)]
        down = [(i + 2 / 3, j + 2 / 3) for i in range(3) for j in range(3 - i)]
        ab = np.array(up + down) / 4
        weights = np.column_stack([ab, 1 - ab.sum(axis=1)])
        middles = (weights @ self.corners).reshape(-1, 3)
        voxels, areas = grid.find(middles), np.repeat(self.areas / 16, 16)
        return np.bincount(voxels[voxels >= 0], areas[voxels >= 0], grid.count)


def make_box(seed, density=1.0, side=3.4, height=4.0):
    """Equilateral triangles, random in a cube and in orientation: the medium of the theory."""
    random = np.random.default_rng(seed)
    count = round(density * side**3 / triangle_area())
    normals, along = random.normal(size=(2, count, 3))
    normals /= np.linalg.norm(normals, axis=1)[:, None]
    along -= normals * (normals * along).sum(axis=1)[:, None]
    along /= np.linalg.norm(along, axis=1)[:, None]
    across = np.cross(normals, along)
    centres = random.uniform(-side / 2, side / 2, (count, 3)) + [0, 0, height]
    turns = 2 * np.pi * np.arange(3) / 3
    rims = np.cos(turns)[:, None] * along[:, None] + np.sin(turns)[:, None] * across[:, None]
    points = (centres[:, None] + EDGE / np.sqrt(3) * rims).reshape(-1, 3)
    scene = vtkhelios.Scene(points, np.arange(3 * count).reshape(-1, 3), reflectance=LEAF)
    return Stand(scene, np.ones(count, bool))


def triangle_area():
    return np.sqrt(3) / 4 * EDGE**2


def make_tree(leaves=30_000, seed=1):
    """A broadleaf tree of 10 m on flat ground; its leaves cluster around the twig ends."""
    tree = vtkhelios.vtkHeliosSyntheticScene(
        kind="tree", height=10, size=6, number_of_leaves=leaves, seed=seed
    )
    corners = [(-100, -100, 0), (100, -100, 0), (100, 100, 0), (-100, 100, 0)]
    ground = vtkhelios.Scene(corners, [(0, 1, 2), (0, 2, 3)], reflectance=0.3, ground=True)
    scene = vtkhelios.Scene(tree) + ground
    names = scene.polydata.GetFieldData().GetAbstractArray("Material.Name")
    leaf = [names.GetValue(i) for i in range(names.GetNumberOfValues())].index("leaf")
    return Stand(scene, vtk_to_numpy(scene.polydata.GetCellData().GetArray("MaterialIds")) == leaf)


class Rays(typing.NamedTuple):
    """Pulses, their path lengths [m], and the triangle hit, or -1."""

    origins: np.ndarray
    directions: np.ndarray
    lengths: np.ndarray
    cells: np.ndarray


def scan(stand, distance, height, sides=(0,), resolution=0.1, beam=False):
    """One cloud per side, with all pulses, of scanners facing the leaves from a distance [m].

    height is the scanner's [m], sides are headings [deg], resolution is between pulses [deg].
    Without a beam every pulse is a line; else it has its footprint and several echoes.
    """
    low, high = stand.box
    radius = np.linalg.norm(stand.corners[..., :2], axis=2).max()
    width = np.degrees(np.arcsin(min(1, radius / distance)))
    places = [max(distance - radius, 0.5), distance + radius]
    angles = np.degrees(np.arctan2([[low[2] - height], [high[2] - height]], places))
    vertical = max(-40, angles.min() - 0.5), min(60, angles.max() + 0.5)  # the instrument's limits
    legs = []
    for side in np.radians(sides):
        x, y = distance * np.sin(side), -distance * np.cos(side)
        middle = np.degrees(np.arctan2(x, -y))  # towards the tree, from y to the left
        legs.append(dict(position=(x, y, height - TRIPOD), head=(middle - width, middle + width)))
    survey = vtkhelios.make_survey(
        stand.scene,
        legs,
        scanner="vz400_class_tls",
        pulse_frequency=100_000,
        vertical=vertical,
        vertical_resolution=resolution,
        horizontal_resolution=resolution,
    )
    options = {} if beam else dict(sub_rays=1)
    return [survey.run(pulses=True, seed=1, legs=leg, **options) for leg in range(len(legs))]


def follow(cloud, keep=None):
    """The rays of a cloud up to their first echo, or the first of those to keep."""
    keep = np.ones(len(cloud), bool) if keep is None else keep
    ids, pulses = cloud.pulses["PulseIds"], cloud["PulseIds"][keep]
    lengths, cells = np.full(len(ids), np.inf), np.full(len(ids), -1)
    first = np.unique(pulses, return_index=True)[1]  # echoes of a pulse are sorted by range
    rows = np.searchsorted(ids, pulses[first])
    lengths[rows] = cloud["Range"][keep][first]
    cells[rows] = cloud["CellIds"][keep][first]
    return Rays(cloud.pulses.points, cloud.pulses["Direction"], lengths, cells)


def apparent_reflectance(cloud, calibration):
    """Reflectance of a perpendicular surface filling the beam that gives these echoes."""
    return cloud["Amplitude"] * cloud["Range"] ** 2 / calibration


def calibrate():
    """Amplitude times squared range of a white wall [W m2]."""
    corners = [(-1, 20, -1), (1, 20, -1), (1, 20, 5), (-1, 20, 5)]
    wall = vtkhelios.Scene(corners, [(0, 1, 2), (0, 2, 3)], reflectance=1.0)
    cloud = vtkhelios.scan(
        wall, (0, 0, 0), vertical=(-1, 1), head=(-1, 1), head_speed=10, scan_frequency=50
    )
    return float(np.median(cloud["Amplitude"] * cloud["Range"] ** 2))


def count(stand, rays, grid):
    """Counts in every voxel: leaf hits, path length [m], and path length of the rays that hit a
    leaf there."""
    met, voxels = find_met(rays, grid)
    leaf = stand.leaves[rays.cells[met]]
    met, voxels = met[leaf], voxels[leaf]
    gone = rays.lengths[met] - grid.enter(voxels, rays.origins[met], rays.directions[met])
    hits = np.bincount(voxels, minlength=grid.count)
    return np.stack([hits, grid.sum_paths(*rays[:3]), np.bincount(voxels, gone, grid.count)])


def find_met(rays, grid):
    """The rays that hit something in the grid, and the voxels of the hits."""
    met = np.flatnonzero(rays.cells >= 0)
    voxels = grid.find(rays.origins[met] + rays.directions[met] * rays.lengths[met, None])
    return met[voxels >= 0], voxels[voxels >= 0]


def derive(counts, grid):
    """The leaf area in every voxel [m2] from counts, which add up over scans; NaN: no ray."""
    hits, paths, met_paths = counts
    with np.errstate(divide="ignore", invalid="ignore"):
        density = (hits - met_paths / paths) / (G * paths)
    return np.where(paths > 0, density * grid.volume, np.nan)


def predict_error(rays, grid):
    """The theoretical relative standard deviation of a derived area: sqrt(sum of m^2) / sum of m.

    m is the number of hits of each leaf: leaves are independent, rays that hit the same one are
    not. With one hit each this is 1 / sqrt(n).
    """
    times = np.unique(rays.cells[find_met(rays, grid)[0]], return_counts=True)[1]
    return float(np.sqrt((times.astype(float) ** 2).sum()) / times.sum())


def widen(radius):
    """Apparent enlargement of the box's leaves for a disc over a line (J. Steiner's formula).

    A disc of radius r hits what a line hits of the outline widened by r: A + P r + pi r^2. Over all
    directions a triangle of area a and perimeter p has the mean outline A = a / 2, P = pi p / 4.
    """
    area, rim = triangle_area() / 2, np.pi / 4 * 3 * EDGE
    return 1 + (rim * radius + np.pi * radius**2) / area


def find_radius(ratio):
    """The radius at which widen() is that ratio."""
    area, rim = triangle_area() / 2, np.pi / 4 * 3 * EDGE
    under = rim**2 + 4 * np.pi * area * (ratio - 1)
    return (np.sqrt(np.maximum(under, 0)) - rim) / (2 * np.pi)


def study_box(seeds, distances, spacing):
    """Rows of the ideal case: lines from 10 m for every seed, beams from all distances for the first."""
    grid = Grid((-1.5, -1.5, 2.5), (1.5, 1.5, 5.5), 3.0)  # inside the box, whose border is thinner
    white, rows = calibrate(), []
    for seed in range(seeds):
        stand = make_box(seed)
        true = stand.area_in(grid)[0]
        for distance in distances if seed == 0 else [10]:
            resolution = np.degrees(spacing / distance)
            kinds = {"line": scan(stand, distance, 4.0, resolution=resolution)[0]}
            if seed == 0:
                kinds["beam"] = scan(stand, distance, 4.0, resolution=resolution, beam=True)[0]
                kinds["beam, strong"] = kinds["beam"]
            for kind, cloud in kinds.items():
                strong = apparent_reflectance(cloud, white) >= WEAK * LEAF
                rays = follow(cloud, strong if "strong" in kind else None)
                ratio = derive(count(stand, rays, grid), grid)[0] / true
                error = predict_error(rays, grid)
                row = dict(kind=kind, seed=seed, distance=float(distance), true=true)
                row |= dict(ratio=ratio, predicted_error=error, z=(ratio - 1) / error)
                row |= dict(radius_over_w=find_radius(ratio) / (WAIST * distance))
                rows.append(row)
    return rows


def strong_radius():
    """The radius in w by which strong echoes widen leaves, for widen(); no constant is fitted.

    A leaf's edge at x from the axis leaves the beam the fraction Phi(-2 x / w) of its energy. For
    leaves with |cos| of incidence u uniform in 0 to 1 an echo counts if u Phi(-2 x / w) is WEAK or
    more: x = w / 2 invPhi(1 - WEAK / u), of which this is the mean.
    """
    n = 2000
    cosines = WEAK + (1 - WEAK) * (np.arange(n) + 0.5) / n
    inverse = statistics.NormalDist().inv_cdf
    return float((1 - WEAK) * np.mean([inverse(1 - WEAK / u) / 2 for u in cosines]))


def sum_up(stand, counts, grid, truth):
    """The error of the leaf area [%], and the true fraction in voxels without rays [%]."""
    areas = derive(counts, grid)
    total = truth.sum()
    unseen = truth[np.isnan(areas)].sum() / total
    return 100 * (np.nansum(areas) / total - 1), 100 * unseen


def study_places(stand, distances, heights, sides, resolution, cell=0.5):
    """Rows: single scans from distances and heights [m], the mean and deviation over sides."""
    grid = Grid(*stand.box, cell)
    truth, rows = stand.area_in(grid), []
    for height in heights:
        for distance in distances:
            clouds = scan(stand, distance, height, sides, resolution)
            counts = [count(stand, follow(cloud), grid) for cloud in clouds]
            found = np.array([sum_up(stand, one, grid, truth) for one in counts])
            row = dict(height=float(height), distance=float(distance))
            row |= dict(error=found[:, 0].mean(), deviation=found[:, 0].std(ddof=1))
            row |= dict(unseen=found[:, 1].mean(), leaf_hits=int(np.mean(counts, axis=0)[0].sum()))
            rows.append(row)
    return rows


def study_beam(stand, distances, resolution, cell=0.5):
    """Rows: one side at eye level, with lines, first echoes, and strong first echoes."""
    grid = Grid(*stand.box, cell)
    truth, white, rows = stand.area_in(grid), calibrate(), []
    for distance in distances:
        line = scan(stand, distance, TRIPOD, resolution=resolution)[0]
        beam = scan(stand, distance, TRIPOD, resolution=resolution, beam=True)[0]
        strong = apparent_reflectance(beam, white) >= WEAK * LEAF
        kinds = dict(line=follow(line), first=follow(beam), strong=follow(beam, strong))
        row = dict(distance=float(distance))
        for kind, rays in kinds.items():
            row[kind] = sum_up(stand, count(stand, rays, grid), grid, truth)[0]
        rows.append(row)
    return rows


def study_positions(stand, resolution, cells, distance=10.0, all_sides=8):
    """Rows: 1, 2, 4 and 8 scans around the tree together, by voxel size; and the layers.

    Layers come from the smallest voxels: height, and leaf area per metre [m2/m], the true one,
    and the areas derived from one scan and from all.
    """
    clouds = scan(stand, distance, TRIPOD, 360 / all_sides * np.arange(all_sides), resolution)
    rays, rows = [follow(cloud) for cloud in clouds], []
    for cell in sorted(cells, reverse=True):
        grid = Grid(*stand.box, cell)
        truth = stand.area_in(grid)
        counts = np.array([count(stand, one, grid) for one in rays])
        for number in (1, 2, 4, 8):
            step = all_sides // number
            sets = [counts[first::step].sum(axis=0) for first in range(step)]
            found = np.array([sum_up(stand, one, grid, truth) for one in sets])
            row = dict(cell=float(cell), scans=number, error=found[:, 0].mean())
            row |= dict(lowest=found[:, 0].min(), highest=found[:, 0].max())
            rows.append(row | dict(unseen=found[:, 1].mean()))
    names = {"true": truth, "one": derive(counts[0], grid), "all": derive(counts.sum(axis=0), grid)}
    table = {"height": grid.layers()}
    for name, areas in names.items():
        table[name] = np.nansum(areas.reshape(grid.shape), axis=(0, 1)) / grid.size[2]
    return rows, [dict(zip(table, map(float, row))) for row in zip(*table.values())]


def study(quick=False):
    """All result rows, by table name; quick: coarser and smaller."""
    if quick:
        box = study_box(seeds=4, distances=(20,), spacing=0.03)
    else:
        box = study_box(seeds=8, distances=(5, 10, 20, 40), spacing=0.015)
    stand = make_tree()
    resolution = 0.25 if quick else 0.1  # deg
    distances, heights = ((4, 10), (TRIPOD,)) if quick else ((4, 6, 10, 20, 40), (TRIPOD, 5, 10))
    sides = (0, 180) if quick else (0, 90, 180, 270)
    places = study_places(stand, distances, heights, sides, resolution)
    beam = study_beam(stand, (10,) if quick else (6, 10, 20, 40), resolution)
    cells = (0.5, 100) if quick else (0.2, 0.5, 1, 100)
    positions, layers = study_positions(stand, resolution, cells)
    true = float(stand.areas.sum())
    return dict(box=box, places=places, beam=beam, positions=positions, layers=layers, true=true)


def draw_box(rows, path):
    figure, (left, right) = _study.make_figure(2)
    by_seed = {row["seed"]: row for row in rows if row["kind"] == "line" and row["distance"] >= 10}
    lines = list(by_seed.values())
    left.axhline(1, color="black", lw=1)
    left.errorbar(
        [row["seed"] for row in lines],
        [row["ratio"] for row in lines],
        [row["predicted_error"] for row in lines],
        fmt="o",
        capsize=3,
    )
    left.set(xlabel="box (seed)", ylabel="derived / true leaf area", ylim=(0.95, 1.05))
    left.set_title("Single rays; bars: one sigma by theory")
    away = np.linspace(0, max(row["distance"] for row in rows), 50)
    looks = {
        "beam": ("first echoes", "C3", f"widened by {FIRST_RADIUS} w (fitted)", FIRST_RADIUS),
        "beam, strong": ("strong echoes", "C1", "predicted, without fit", strong_radius()),
        "line": ("single rays", "C0", None, None),
    }
    for kind, (label, colour, theory, radius) in looks.items():
        found = [row for row in rows if row["kind"] == kind and row["seed"] == 0]
        values = [row["distance"] for row in found], [row["ratio"] for row in found]
        right.plot(*values, "o", color=colour, label=label)
        if theory:
            right.plot(away, widen(radius * WAIST * away), color=colour, lw=1, label=theory)
    right.axhline(1, color="black", lw=1)
    right.set(xlabel="distance [m]", ylabel="derived / true leaf area", xlim=(0, None))
    right.set_title("Effect of the beam width")
    right.legend(fontsize="small")
    _study.save_figure(figure, path)


def draw_tree(numbers, path):
    figure, axes = _study.make_figure(2, 2)
    draw_places(axes[0], numbers["places"])
    for kind, label in (
        ("first", "first echoes"),
        ("strong", "strong echoes"),
        ("line", "single rays"),
    ):
        colour = {"first": "C3", "strong": "C1", "line": "C0"}[kind]
        values = [(row["distance"], row[kind]) for row in numbers["beam"]]
        axes[1].plot(*zip(*values), "o-", color=colour, label=label)
    axes[1].set(title="Beam width, scanner at 1.7 m", xlabel="distance [m]")
    draw_positions(axes[2], numbers["positions"])
    for one in axes[:3]:
        one.axhline(0, color="black", lw=1)
        one.set(ylabel="error of leaf area [%]")
        one.legend(fontsize="small")
    layers = {key: [row[key] for row in numbers["layers"]] for key in numbers["layers"][0]}
    for name, label in (("one", "one scan"), ("all", "eight scans"), ("true", "true")):
        look = dict(color="black", lw=1) if name == "true" else dict(marker=".", lw=0.7)
        axes[3].plot(layers[name], layers["height"], label=label, **look)
    axes[3].set(title="Layers, from 10 m", xlabel="leaf area [m2/m]", ylabel="height [m]")
    axes[3].legend(fontsize="small")
    _study.save_figure(figure, path)


def draw_places(axes, rows):
    for height in sorted({row["height"] for row in rows}):
        found = [row for row in rows if row["height"] == height]
        values = ([row[name] for row in found] for name in ("distance", "error", "deviation"))
        axes.errorbar(*values, fmt="o-", capsize=3, label=f"scanner at {height:g} m")
    axes.set(title="One scan, single rays, voxels of 0.5 m", xlabel="distance [m]", xscale="log")
    ticks = sorted({row["distance"] for row in rows})
    axes.set_xticks(ticks, [f"{tick:g}" for tick in ticks])
    axes.minorticks_off()


def draw_positions(axes, rows):
    for cell in sorted({row["cell"] for row in rows}):
        found = [row for row in rows if row["cell"] == cell]
        scans, error, low, high = (
            np.array([row[name] for row in found])
            for name in ("scans", "error", "lowest", "highest")
        )
        label = f"{cell:g} m" if cell < 50 else "one voxel"
        axes.errorbar(scans, error, [error - low, high - error], fmt="o-", capsize=3, label=label)
    axes.set(title="Combined scans, from 10 m", xlabel="scans around the tree")
    axes.set_xscale("log", base=2)
    axes.set_xticks([1, 2, 4, 8], [1, 2, 4, 8])


def main():
    options = _study.arguments(__doc__)
    numbers = study(options.quick)
    for name in ("box", "places", "beam", "positions", "layers"):
        _study.print_table(numbers[name], name)
        _study.write_csv(options.out / f"leaf_area_{name}.csv", numbers[name])
    print(f"\ntrue leaf area of the tree: {numbers['true']:.2f} m2")
    print(f"strong echoes widen leaves by {strong_radius():.3f} w, by theory")
    draw_box(numbers["box"], options.out / "leaf_area_box.png")
    draw_tree(numbers, options.out / "leaf_area_tree.png")
    return numbers


if __name__ == "__main__":
    main()
