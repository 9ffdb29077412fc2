# SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
# SPDX-License-Identifier: BSD-3-Clause
"""Roof planes from an airborne scan, against the true planes.

    build/venv/bin/python Python/studies/roof_planes.py OUT [--quick]

Echoes above the ground are split into buildings (Euclidean clusters), those of a building into
planes (RANSAC; vtkHeliosPCLPlanes), and each plane is fitted by least squares of heights. For n
echoes with noise s along the normal, whose deviations along the plane's principal axes are u and v,
the standard deviations are

    s / (u sqrt(n)), s / (v sqrt(n))    of the normal, towards u and towards v [rad]
    s / sqrt(n) sqrt(1 + (a/u)^2 + (b/v)^2)    of the offset at the lever arms a, b from their mean

Needs a build with PCL.
"""

import pathlib
import tempfile
import typing

import numpy as np

import _study
import vtkhelios
from _village import area_of, cut, find_hull, find_inner, make_village, normal_of, outline

SWATH = 1.15  # width of the strip, over the width of the village
FACET = 90.0  # deg, sweep of a mirror facet
GROUND = 2.0  # m: lower echoes are ignored
ALIKE = 10.0  # deg, between found and true normals: larger is another plane
SCANNER = """\
<document>
  <scanner id="mirror" name="Airborne rotating mirror" optics="rotating" pulseFreqs_Hz="{pulses:.17g}"
           pulseLength_ns="4" wavelength_nm="1064" beamDivergence_rad="{divergence:g}"
           accuracy_m="{noise:g}" rangeMin_m="10" maxNOR="15" scanAngleMax_deg="45"
           scanAngleEffectiveMax_deg="30" scanFreqMin_Hz="1" scanFreqMax_Hz="10000"/>
</document>
"""


def fly(village, height, density, noise, divergence=0.00025, seed=0, **options):
    """A strip over the village, the middle one of its flight: a Cloud.

    height above the ground [m], density on it [1/m2], equal along and across track, noise of ranges
    [m], divergence [rad], options of a run.
    """
    angle = np.degrees(np.arctan(SWATH * village.half / height))
    step = 1 / np.sqrt(density)  # m between pulses
    turn = np.degrees(step / height)  # deg between pulses
    speed = 60.0
    lines = speed / step
    scanner = SCANNER.format(pulses=FACET / turn * lines, divergence=divergence, noise=noise)
    y = village.half + 20
    with tempfile.TemporaryDirectory() as folder:
        (pathlib.Path(folder) / "airborne.xml").write_text(scanner)
        return vtkhelios.scan(
            village.scene,
            path=[(0, -y, height), (0, y, height)],
            scanner="airborne.xml#mirror",
            platform="airplane_linearpath",
            assets=[folder],
            speed=speed,
            scan_frequency=lines,
            scan_angle=angle,
            seed=seed,
            **options,
        )


class Plane(typing.NamedTuple):
    """A plane found: indices of its echoes, and of those not near another plane."""

    echoes: np.ndarray
    sure: np.ndarray


def find_planes(cloud, noise, spacing):
    """The planes of the roofs in a cloud."""
    high = np.flatnonzero(cloud.points[:, 2] > GROUND)
    least = max(8, round(4.0 / spacing**2))  # 4 m2
    near = max(3 * noise, 0.02)  # m
    found = []
    for building in split(cloud, high, 3 * spacing, least):
        planes = vtkhelios.vtkHeliosPCLPlanes(
            distance_threshold=near, minimum_number_of_points=least, maximum_number_of_planes=12
        )
        segmented = vtkhelios.Cloud((cloud[building] >> planes)())
        ids = segmented["PlaneIds"]
        roofs = []
        for number in range(ids.max() + 1):
            pieces = split(cloud, building[ids == number], 3 * spacing, least)
            if pieces and abs(fit_plane(cloud.points[pieces[0]]).axes[2, 2]) > 0.3:  # not a wall
                roofs.append(pieces[0])
        found += [Plane(echoes, leave_out(cloud, echoes, roofs, near)) for echoes in roofs]
    return found


def leave_out(cloud, echoes, roofs, near):
    """The echoes not near another plane of the building: RANSAC gives those to the first plane."""
    points, alone = cloud.points[echoes], np.ones(len(echoes), bool)
    for other in roofs:
        if other is not echoes:
            fit = fit_plane(cloud.points[other])
            alone &= np.abs((points - fit.mean) @ fit.axes[2]) > near
    return echoes[alone] if alone.sum() >= 4 else echoes


def split(cloud, chosen, gap, least):
    """Splits those points of the cloud into groups separated by a gap [m], the largest first."""
    clusters = vtkhelios.vtkHeliosPCLClusters(tolerance=gap, minimum_cluster_size=least)
    ids = vtkhelios.Cloud((cloud[chosen] >> clusters)())["ClusterIds"]
    return [chosen[ids == number] for number in range(ids.max() + 1)]


class Fit(typing.NamedTuple):
    """A least squares plane: the mean, the axes (rows; the last is the normal), the deviations [m]."""

    mean: np.ndarray
    axes: np.ndarray
    deviations: np.ndarray


def fit_plane(points):
    mean = points.mean(axis=0)
    _, singular, axes = np.linalg.svd(points - mean, full_matrices=False)
    largest = axes[
        [0, 1, 2], [*np.abs(axes[:2]).argmax(axis=1), 2]
    ]  # to be positive; the normal up
    axes = axes * np.where(largest < 0, -1, 1)[:, None]
    return Fit(mean, axes, singular / np.sqrt(len(points)))


def fit_roof(points):
    """Fits a plane by least squares of heights: noise is along the beams, which come from above.

    Squares of distances would flatten a slope whose sine is q by noise^2 q sqrt(1 - q^2) / v^2.
    """
    fit = fit_plane(points)
    (a, b), *_ = np.linalg.lstsq(
        points[:, :2] - fit.mean[:2], points[:, 2] - fit.mean[2], rcond=None
    )
    normal = np.array([-a, -b, 1]) / np.sqrt(a * a + b * b + 1)
    return fit._replace(axes=np.array([*fit.axes[:2], normal]))


def measure(cloud, echoes, polygon, noise):
    """Errors of the plane of some echoes against the plane of a polygon, and their theoretical sigma.

    tilts: of the normal, towards the two axes [rad]; offset: along it, at the polygon's centre [m].
    """
    fit, middle, normal = fit_roof(cloud.points[echoes]), polygon.mean(axis=0), normal_of(polygon)
    u, v, found = fit.axes
    tilts = fit.axes[:2] @ found - fit.axes[:2] @ normal
    offset = (fit.mean - middle) @ found / (found @ normal)
    sigma = (
        noise * np.cos(np.radians(cloud["IncidenceAngle"][echoes])).mean() / np.sqrt(len(echoes))
    )
    sigma_tilts = sigma / fit.deviations[:2]
    arms = np.array([(middle - fit.mean) @ u, (middle - fit.mean) @ v]) / fit.deviations[:2]
    sigma_offset = sigma * np.sqrt(1 + arms @ arms)
    return np.array([*tilts, offset]), np.array([*sigma_tilts, sigma_offset])


def match(village, cloud, planes):
    """The plane found for every true one: most of its echoes are on it, and the tilt agrees."""
    true = village.cell_planes[cloud["CellIds"]]
    matched = {}
    for plane in sorted(planes, key=lambda plane: -len(plane.echoes)):
        votes = np.bincount(true[plane.echoes] + 1, minlength=len(village.polygons) + 1)
        number = int(votes.argmax()) - 1
        if number < 0 or number in matched:
            continue
        normal = fit_roof(cloud.points[plane.sure]).axes[2]
        if normal @ normal_of(village.polygons[number]) > np.cos(np.radians(ALIKE)):
            matched[number] = plane
    return matched


def run(villages, height=1000.0, density=8.0, noise=0.02, divergence=0.00025, **options):
    """A row: the results of a strip over each of the villages.

    Errors are RMS over planes, tilt [deg] of the normal, offset [mm] at the roof's centre: of the
    planes found; of those fitted to all their true echoes (label); and to interior ones (inner).
    _theory is one sigma of the same echoes, z the error in sigmas.
    """
    errors = {"found": [], "label": [], "inner": []}
    planes = false = 0
    true_area = found_area = right_area = 0.0
    margin = 1.5 * divergence * height  # m: three radii of the footprint
    for seed, village in enumerate(villages):
        cloud = fly(village, height, density, noise, divergence, seed, **options)
        found = find_planes(cloud, noise, 1 / np.sqrt(density))
        matched = match(village, cloud, found)
        planes += len(matched)
        false += len(found) - len(matched)
        true = village.cell_planes[cloud["CellIds"]]
        for number, polygon in enumerate(village.polygons):
            echoes = np.flatnonzero(true == number)
            kinds = {"label": echoes}
            kinds["inner"] = echoes[find_inner(cloud.points[echoes], polygon, margin)]
            true_area += area_of(outline(polygon))
            if number in matched:
                kinds["found"] = matched[number].sure
                hull = find_hull(cloud.points[matched[number].echoes, :2])
                found_area += area_of(hull)
                right_area += area_of(cut(hull, outline(polygon)))
            for kind, chosen in kinds.items():
                if len(chosen) >= 4:
                    errors[kind].append(measure(cloud, chosen, polygon, noise))
    row = dict(height=float(height), density=float(density), noise=noise)
    row |= dict(
        planes=sum(len(village.polygons) for village in villages), found=planes, false=false
    )
    row |= dict(completeness=right_area / true_area, correctness=right_area / found_area)
    for kind, values in errors.items():
        row |= sum_up(kind, np.array(values))
    return row


def sum_up(kind, values):
    """RMS of errors and sigmas (planes x 2 x 3)."""
    tilts = np.degrees(np.sqrt((values[:, :, :2] ** 2).sum(axis=2).mean(axis=0)))
    offsets = 1e3 * np.sqrt((values[:, :, 2] ** 2).mean(axis=0))
    z = np.sqrt(((values[:, 0] / values[:, 1]) ** 2).mean())
    names = f"tilt_{kind}", f"tilt_{kind}_theory", f"offset_{kind}", f"offset_{kind}_theory"
    return dict(zip(names, map(float, (*tilts, *offsets)))) | {f"z_{kind}": float(z)}


def study(quick=False):
    """Result rows by table name; quick: coarser and smaller."""
    if not hasattr(vtkhelios, "vtkHeliosPCLPlanes"):
        raise ImportError(
            "roof_planes needs vtkHeliosPCLPlanes, and vtkhelios was built without PCL; "
            "install libpcl-dev, and build again with VTKHELIOS_ENABLE_PCL=ON"
        )
    if quick:
        villages = [make_village(rows=2)]
        table = dict(density=[1.0, 4.0], noise=[0.01, 0.04], height=[500.0, 2000.0])
        return {name: series(villages, name, values, density=4.0) for name, values in table.items()}
    villages = [make_village(seed=seed) for seed in (1, 2)]
    table = dict(
        density=[0.5, 1.0, 2.0, 4.0, 8.0, 16.0, 32.0],
        noise=[0.005, 0.01, 0.02, 0.04, 0.08],
        height=[400.0, 700.0, 1000.0, 1500.0, 2000.0, 3000.0],
    )
    numbers = {name: series(villages, name, values) for name, values in table.items()}
    # Errors remaining without a footprint: one line per pulse.
    numbers["lines"] = series(villages, "density", [1.0, 4.0, 16.0], sub_rays=1)
    return numbers


def series(villages, name, values, **others):
    return [run(villages, **{**others, name: value}) for value in values]


def lost_at_random(villages, density):
    """The fraction of the area outside the hull of random points (Renyi, Sulanke 1963)."""
    polygons = [polygon for village in villages for polygon in village.polygons]
    areas = np.array([area_of(outline(polygon)) for polygon in polygons])
    corners = np.array([len(polygon) for polygon in polygons])
    count = areas * density
    return float((areas * 2 / 3 * corners * np.log(count) / count).sum() / areas.sum())


LABELS = {
    "density": "density [1/m2]",
    "noise": "range noise [m]",
    "height": "flying height [m]",
    "tilt": "error of the normal, RMS [deg]",
    "offset": "error of the offset, RMS [mm]",
}


def draw(numbers, path):
    figure, axes = _study.make_figure(3, 2)
    draw_errors(axes[0], numbers["density"], "density", "tilt")
    draw_errors(axes[1], numbers["density"], "density", "offset")
    draw_areas(axes[2], numbers["density"])
    draw_errors(axes[3], numbers["noise"], "noise", "tilt")
    high = {
        "found": (numbers["height"], "found"),
        "all true echoes": (numbers["height"], "label"),
        "true echoes, no edges": (numbers["height"], "inner"),
    }
    draw_sigmas(axes[4], "height", high)
    without = numbers.get("lines", [])
    what = {"found": (numbers["density"], "found"), "found, no footprint": (without, "found")}
    draw_sigmas(axes[5], "density", what)
    _study.save_figure(figure, path)


def draw_errors(axes, rows, name, what):
    values = [row[name] for row in rows]
    for kind, label, colour in (("found", "found", "C3"), ("inner", "true echoes, no edges", "C0")):
        axes.plot(values, [row[f"{what}_{kind}"] for row in rows], "o", color=colour, label=label)
        theory = [row[f"{what}_{kind}_theory"] for row in rows]
        axes.plot(values, theory, color=colour, lw=1, label="theory")
    axes.set(xlabel=LABELS[name], ylabel=LABELS[what])
    set_logarithmic(axes, values)
    axes.legend(fontsize="small")


def draw_areas(axes, rows):
    density = [row["density"] for row in rows]
    for name in ("completeness", "correctness"):
        axes.plot(density, [row[name] for row in rows], "o-", label=name)
    random = [1 - lost_at_random([make_village()], value) for value in density]
    axes.plot(density, random, "k--", lw=1, label="hull of random points")
    axes.set(xlabel=LABELS["density"], ylabel="fraction of the roof area", ylim=(None, 1.01))
    axes.set_xscale("log")
    axes.minorticks_off()
    axes.set_xticks(density, [f"{value:g}" for value in density])
    axes.legend(fontsize="small")


def draw_sigmas(axes, name, what):
    """The errors in theoretical standard deviations; expected: 1."""
    for label, (rows, kind) in what.items():
        axes.plot(
            [row[name] for row in rows], [row[f"z_{kind}"] for row in rows], "o-", label=label
        )
    axes.axhline(1, color="black", lw=1)
    axes.set(xlabel=LABELS[name], ylabel="errors / sigmas of theory, RMS")
    set_logarithmic(axes, [row[name] for row in next(iter(what.values()))[0]])
    axes.legend(fontsize="small")


def set_logarithmic(axes, values):
    from matplotlib.ticker import FuncFormatter, LogLocator, NullLocator

    axes.set(xscale="log", yscale="log")
    axes.set_xticks(values, [f"{value:g}" for value in values])
    axes.yaxis.set_major_locator(LogLocator(subs=(1, 2, 3, 5)))
    axes.yaxis.set_major_formatter(FuncFormatter(lambda value, _: f"{value:g}"))
    axes.xaxis.set_minor_locator(NullLocator())
    axes.yaxis.set_minor_locator(NullLocator())


def draw_map(path, density=4.0):
    """Echoes from above, coloured by their detected plane."""
    village = make_village()
    cloud = fly(village, 1000.0, density, 0.02)
    figure, (axes,) = _study.make_figure(size=(6, 5.4))
    for index, plane in enumerate(find_planes(cloud, 0.02, 1 / np.sqrt(density))):
        x, y = cloud.points[plane.echoes, :2].T
        axes.plot(x, y, ".", ms=1.2, color=f"C{index % 10}")
    for polygon in village.polygons:
        axes.plot(*np.append(polygon, polygon[:1], axis=0)[:, :2].T, color="black", lw=0.6)
    axes.set(aspect="equal", xlabel="x [m]", ylabel="y [m]")
    axes.set_title(f"Detected planes, {density:g} points/m2, from 1000 m")
    _study.save_figure(figure, path)


def main():
    options = _study.arguments(__doc__)
    numbers = study(options.quick)
    for name, rows in numbers.items():
        whole = [{key: row[key] for key in list(row)[:8]} for row in rows]
        errors = [{key: row[key] for key in [*list(row)[:3], *list(row)[8:]]} for row in rows]
        _study.print_table(whole, name)
        _study.print_table(errors)
        _study.write_csv(options.out / f"roof_planes_{name}.csv", rows)
    draw(numbers, options.out / "roof_planes.png")
    draw_map(options.out / "roof_planes_map.png")
    return numbers


if __name__ == "__main__":
    main()
