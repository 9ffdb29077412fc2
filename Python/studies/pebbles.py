# SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
# SPDX-License-Identifier: BSD-3-Clause
"""Millimetre errors of a terrestrial scanner over a bed of pebbles at 3 m.

    build/venv/bin/python Python/studies/pebbles.py OUT [--quick]

Pebbles are ellipsoids, so ray hits are known exactly. Error sources are switched on one by one:
range noise, direction noise, the footprint. The effect of each on ranges, by incidence and at the
edges of pebbles, and on a grid of heights from the points is compared with theory and truth.
Docs/studies/pebbles.md has the results.
"""

import sys
from pathlib import Path

import numpy as np

import vtkhelios

sys.path.insert(0, str(Path(__file__).resolve().parent))
import _study  # noqa: E402
from _pebble_bed import PebbleBed  # noqa: E402
from footprint_waveform import CUT, energy_beyond, full_power  # noqa: E402

RANGE_NOISE = 0.002  # m
WEAK_NOISE = 0.0005  # m, of a surface perpendicular to the beam at 3 m; grows as echoes get weaker
THRESHOLD = 1e-9  # W, detection limit
DIRECTION_NOISE = 1e-4  # rad, on each of two axes
BEAM = 2e-3 / 3  # rad, half the divergence: w = 2 mm at 3 m
STAND = (2.6, 1.5)  # m, from the centre of the bed, above it: 3.0 m
AT_THRESHOLD = WEAK_NOISE * full_power(3.0, 0.0) / THRESHOLD  # m, as set on the scanner
CASES = {
    "no error": {},
    "range noise": dict(range_accuracy=RANGE_NOISE),
    "weak echoes": dict(range_accuracy_at_threshold=AT_THRESHOLD),
    "direction noise": dict(angle_accuracy=DIRECTION_NOISE),
    "footprint": dict(w=BEAM),
}
CASES["all"] = {key: value for case in CASES.values() for key, value in case.items()}
CASES["all"]["sub_rays"] = 64  # enough with noise
MIXED = 0.05  # energy fraction from another pebble of a mixed echo


class View:
    """A bed, its triangles, and a scanner over it; the truth is from the exact ellipsoids."""

    def __init__(self, bed, level=4):
        self.bed, self.level = bed, level
        self.scene = bed.make_scene(level)
        self.caster = vtkhelios.vtkHeliosRayCasterFactory.Create("")  # keeps its tree between scans

    def scan(self, step, w=0.0, azimuth=180.0, sub_rays=256, hits=False, **instrument):
        """Scans the bed from an azimuth [deg] in steps of an angle [rad]; optional sub-ray hits."""
        degrees = np.degrees(step)
        mirror = vtkhelios.vtkHeliosRotatingMirror(
            mirror_angle=45,
            scan_frequency=100,
            pulse_frequency=2 * 45 * 100 / degrees,
            vertical_angle_min=-35,
            vertical_angle_max=-25.5,
        )
        beam = vtkhelios.vtkHeliosBeamSampler(pattern="vogel", number_of_sub_rays=sub_rays)
        beam.beam_divergence = 2 * w
        scanner = vtkhelios.vtkHeliosScanner(
            beam_deflector=mirror,
            beam_sampler=beam,
            ray_caster=self.caster,
            echo_detector=vtkhelios.vtkHeliosPeakDetector(detection_threshold=THRESHOLD),
            sampling="fixed",
            head_rotate_start=-10,
            head_rotate_stop=10,
            head_rotate_speed=100 * degrees,
            generate_pulses=True,
            generate_sub_rays=hits,
            **instrument,
        )
        a = np.radians(azimuth)
        place = vtkhelios.Cloud.from_arrays(
            [[STAND[0] * np.sin(a), STAND[0] * np.cos(a), STAND[1]]]
        )
        platform = place >> vtkhelios.vtkHeliosStaticPlatform(heading=azimuth - 180)
        vtkhelios.update(((self.scene, platform) >> scanner).last)
        outputs = [vtkhelios.Cloud(scanner.GetOutputDataObject(port)) for port in (0, 2, 3)]
        return outputs if hits else outputs[:2]

    def truth(self, pulses):
        """Exact range, pebble and incidence [deg] of each pulse, and whether it is away from the border."""
        directions = pulses["Direction"]
        ranges, owners, cosines = self.bed.cast(pulses.points, directions)
        places = pulses.points + ranges[:, None] * directions
        amid = np.abs(places[:, :2]).max(axis=1) < 0.45 * self.bed.size
        return ranges, owners, np.degrees(np.arccos(np.clip(cosines, -1, 1))), amid


def rows_of(cloud, pulses):
    """The rows of `pulses` for the echoes of a cloud."""
    return np.searchsorted(pulses["PulseIds"], cloud["PulseIds"])


def spread_of(values):
    """Half of the inner 68.3 % range: sigma of a Gaussian, robust to outliers."""
    low, high = np.percentile(values, (15.87, 84.13))
    return (high - low) / 2


def root_mean_square(values):
    return float(np.sqrt(np.mean(values**2)))


# Ranges ------------------------------------------------------------------------------------------


def study_ranges(view, step):
    """Scans every case once; the clouds, and columns of range errors [m], incidence ..."""
    clouds, columns = {}, {}
    for name, instrument in CASES.items():
        cloud, pulses = view.scan(step, **instrument)
        if name == "no error":
            ranges, owners, incidence, amid = view.truth(pulses)
            believed = pulses
            columns = dict(range=ranges, owner=owners, incidence=incidence, amid=amid)
        rows = rows_of(cloud, believed)
        if len(cloud) != len(ranges) or (rows != np.arange(len(rows))).any():
            raise RuntimeError(f"{name}: {len(cloud)} echoes of {len(ranges)} pulses")
        columns[name] = cloud["Range"] - ranges
        clouds[name] = cloud
    columns["directions"] = believed["Direction"]
    columns["origins"] = believed.points
    return clouds, columns


def describe_ranges(columns):
    """A row for each case: bias, RMS, spread, large errors [mm], inside the bed."""
    rows = []
    for name in CASES:
        error = 1000 * columns[name][columns["amid"]]
        below = columns["incidence"][columns["amid"]] < 70
        rows.append(
            dict(
                case=name,
                echoes=len(error),
                bias=float(error.mean()),
                rms=root_mean_square(error),
                rms_below_70_deg=root_mean_square(error[below]),
                spread=float(spread_of(error)),
                p99=float(np.percentile(np.abs(error), 99)),
                beyond_5_mm=float((np.abs(error) > 5).mean()),
            )
        )
    return rows


def check_noise(columns):
    """RMS of the range noise alone, over the configured one, and its 4-sigma bound."""
    noise = columns["range noise"] - columns["no error"]
    ratio = np.sqrt((noise**2).mean()) / RANGE_NOISE
    return float(ratio), float(4 / np.sqrt(2 * len(noise)))  # chi-square of n degrees of freedom


def direction_theory(ranges, incidence):
    """Range error on a plane [m] for a direction error of DIRECTION_NOISE."""
    return ranges * DIRECTION_NOISE * np.tan(np.radians(incidence))


def weak_theory(ranges, incidence):
    """The noise of echoes whose amplitude falls with range and incidence [m]."""
    amplitude = full_power(ranges, np.radians(incidence))
    return WEAK_NOISE * full_power(3.0, 0.0) / amplitude


def describe_incidence(columns):
    """A row for each 10 degrees of incidence: spreads of errors [mm], and theory."""
    rows = []
    for low in range(0, 90, 10):
        part = columns["amid"] & (columns["incidence"] // 10 == low // 10)
        here = columns["range"][part], columns["incidence"][part]
        row = {"incidence": f"{low}-{low + 10}", "echoes": int(part.sum())}
        for name in CASES:
            row[name] = float(1000 * spread_of(columns[name][part]))
        row["range_theory"] = 1000 * RANGE_NOISE
        row["weak_theory"] = float(1000 * np.median(weak_theory(*here)))
        row["direction_theory"] = float(1000 * np.median(direction_theory(*here)))
        row["footprint_median"] = float(1000 * np.median(columns["footprint"][part]))
        row["footprint_p95"] = float(1000 * np.percentile(np.abs(columns["footprint"][part]), 95))
        rows.append(row)
    return rows


# Mixed echoes ------------------------------------------------------------------------------------


def tilted(directions, x, y):
    """Directions rotated by small angles x and y [rad] across them (n or n x m of both)."""
    side = np.cross(directions, (0.0, 0.0, 1.0))
    side /= np.linalg.norm(side, axis=1)[:, None]
    up = np.cross(side, directions)
    turned = (
        directions[:, None] + np.atleast_2d(x)[..., None] * side[:, None]
        + np.atleast_2d(y)[..., None] * up[:, None]
    )  # fmt: skip
    return turned / np.linalg.norm(turned, axis=2)[..., None]


def expected_errors(bed, origins, directions, ranges, w):
    """The range errors of a beam on the exact surface [m]: the power-weighted mean."""
    steps = np.linspace(-CUT, CUT, 23)
    x, y = (v.ravel() for v in np.meshgrid(steps, steps))
    inside = x**2 + y**2 <= CUT**2
    x, y = x[inside], y[inside]
    rays = tilted(directions, w * x, w * y)
    many = np.repeat(origins, len(x), axis=0)
    found, _, cosines = (v.reshape(len(ranges), -1) for v in bed.cast(many, rays.reshape(-1, 3)))
    power = np.exp(-2 * (x**2 + y**2)) * cosines / found**2
    return (power * found).sum(axis=1) / power.sum(axis=1) - ranges


def edge_density(bed, origins, directions, arcs, seed=3):
    """Length of the edges between pebbles, as seen by the scanner [rad / rad^2].

    By Crofton's formula: pi / 2 times the crossings of a random line per unit length. Also the
    jumps of range at the crossings [m].
    """
    random = np.random.default_rng(seed)
    chosen = random.integers(len(directions), size=arcs)
    angle = random.uniform(0, 2 * np.pi, arcs)
    along = np.linspace(-5e-3, 5e-3, 201)  # rad: 50 microradians are 0.15 mm
    rays = tilted(directions[chosen], *(np.outer(f(angle), along) for f in (np.cos, np.sin)))
    many = np.repeat(origins[chosen], len(along), axis=0)
    found = bed.cast(many, rays.reshape(-1, 3), block=len(along))
    ranges, owners, _ = (v.reshape(arcs, -1) for v in found)
    crossed = owners[:, 1:] != owners[:, :-1]
    jumps = np.abs(np.diff(ranges, axis=1))[crossed]
    return np.pi / 2 * crossed.sum() / (arcs * 0.01), jumps


def strip_width(share=MIXED):
    """Distance from an edge, in w, at which that fraction of a beam's energy is beyond it."""
    low, high = 0.0, CUT
    for _ in range(40):
        middle = (low + high) / 2
        low, high = (middle, high) if energy_beyond(middle, CUT) > share else (low, middle)
    return low


def study_mixed(view, step, arcs, diameters=(0.5, 1, 2, 4, 8)):
    """A row for each footprint: the fraction of mixed echoes and their errors, against the edges."""
    rows, density = [], None
    for diameter in diameters:  # mm, at 3 m
        w = diameter / 2000 / 3
        cloud, pulses, hits = view.scan(step, w=w, hits=True)
        ranges, owners, _, amid = view.truth(pulses)
        if density is None:
            density, jumps = edge_density(
                view.bed, pulses.points[amid], pulses["Direction"][amid], arcs
            )
        rows_of_hits = np.searchsorted(pulses["PulseIds"], hits["PulseIds"])
        other = view.bed.owners(hits["CellIds"], view.level) != owners[rows_of_hits]
        beyond = np.bincount(rows_of_hits, hits["Weight"] * other, len(pulses))
        error = np.abs(1000 * (cloud["Range"] - ranges[rows_of(cloud, pulses)]))[amid]
        mixed = (beyond > MIXED)[amid]
        expected = 2 * strip_width() * w * density
        rows.append(
            dict(
                diameter_mm=diameter,
                echoes=int(amid.sum()),
                mixed=float(mixed.mean()),
                edge_theory=float(expected),
                poisson_theory=float(1 - np.exp(-expected)),
                rms_mixed=root_mean_square(error[mixed]),
                rms_others=root_mean_square(error[~mixed]),
                rms=root_mean_square(error),
            )
        )
    return rows, float(density), float(1000 * np.median(jumps))


# Grids of heights --------------------------------------------------------------------------------


def grid_means(places, heights, cell, count):
    """The mean height of the points in each cell, NaN if empty."""
    index = np.floor(places / cell + count / 2).astype(int)
    inside = ((index >= 0) & (index < count)).all(axis=1)
    flat = index[inside] @ (count, 1)
    number = np.bincount(flat, minlength=count**2)
    with np.errstate(invalid="ignore"):
        return (np.bincount(flat, heights[inside], count**2) / number).reshape(count, count)


def study_grids(view, step, clouds, cell=0.005, half=0.3):
    """Grids of mean heights against the truth: rows, and maps of the errors [m].

    Cells are hidden from the first position if an error-free scan three times as fine has no point
    there.
    """
    count = round(2 * half / cell)
    fine = (np.arange(5 * count) + 0.5) * cell / 5 - half
    places = np.stack(np.meshgrid(fine, fine, indexing="ij"), -1).reshape(-1, 2)
    truth = grid_means(places, view.bed.heights(*places.T), cell, count)
    stands = {180.0: clouds["all"]}
    for azimuth in (0.0, 90.0, 270.0):
        stands[azimuth] = view.scan(step, azimuth=azimuth, seed=int(azimuth), **CASES["all"])[0]
    sets = {name: [clouds[name]] for name in CASES}
    sets["all, 2 positions"] = [stands[180.0], stands[0.0]]
    sets["all, 4 positions"] = list(stands.values())
    fine = view.scan(step / 3)[0].points
    hidden = np.isnan(grid_means(fine[:, :2], fine[:, 2], cell, count))
    rows, maps = [], {"truth": truth, "hidden": hidden}
    for name, parts in sets.items():
        points = np.concatenate([part.points for part in parts])
        error = grid_means(points[:, :2], points[:, 2], cell, count) - truth
        maps[name] = error
        full = np.isfinite(error)
        seen, ghosts = 1000 * error[full], 1000 * error[full & hidden]
        rows.append(
            dict(
                points_of=name,
                empty_cells=float(np.isnan(error).mean()),
                bias=float(seen.mean()),
                rms=root_mean_square(seen),
                spread=float(spread_of(seen)),
                p95=float(np.percentile(np.abs(seen), 95)),
                hidden_but_full=float((full & hidden).mean()) if len(parts) == 1 else np.nan,
                rms_of_these=root_mean_square(ghosts) if len(parts) == 1 else np.nan,
            )
        )
    return rows, maps


# Full study -------------------------------------------------------------------------------------


def compare_with_expected(view, columns, count):
    """The errors of single beams with a footprint, simulated and on the exact surface [m]."""
    amid = np.flatnonzero(columns["amid"])
    chosen = amid[:: max(1, len(amid) // count)]
    expected = expected_errors(
        view.bed,
        columns["origins"][chosen],
        columns["directions"][chosen],
        columns["range"][chosen],
        BEAM,
    )
    return expected, columns["footprint"][chosen]


def study(quick=False):
    """All results and, for the pictures, their columns."""
    view = View(PebbleBed(0.4 if quick else 0.8))
    step = 1.5e-3 if quick else 0.7e-3
    clouds, columns = study_ranges(view, step)
    expected, simulated = compare_with_expected(view, columns, 300 if quick else 3000)
    mixed, density, jump = (
        study_mixed(view, 2e-3, 1500, (2, 4)) if quick else study_mixed(view, 2.5e-3, 4000)
    )
    grids, maps = study_grids(view, step, clouds, half=0.15 if quick else 0.3)
    return dict(
        pebbles=len(view.bed),
        noise=check_noise(columns),
        ranges=describe_ranges(columns),
        incidence=describe_incidence(columns),
        expected=expected,
        simulated=simulated,
        mixed=mixed,
        edge_density=density,
        edge_jump=jump,
        grids=grids,
        columns=columns,
        maps=maps,
        step=step,
    )


# Pictures and tables -----------------------------------------------------------------------------


def draw_errors(results, path):
    """Effects of the footprint, from the scanner; spreads over incidence; fraction of mixed echoes."""
    figure, (seen, spread, mixed) = _study.make_figure(3)
    columns = results["columns"]
    direction = columns["directions"]
    angles = np.degrees(
        np.column_stack([np.arctan2(direction[:, 0], direction[:, 1]), np.arcsin(direction[:, 2])])
    )
    cell = np.degrees(results["step"]) * 1.01
    count = int(5 / cell)
    picture = grid_means(angles - (0, -30.3), 1000 * columns["footprint"], cell, count)
    dots = seen.imshow(
        picture.T, origin="lower", cmap="RdBu_r", vmin=-10, vmax=10, interpolation="nearest",
        extent=(-2.5, 2.5, -32.8, -27.8), aspect=1 / np.cos(np.radians(30)),
    )  # fmt: skip
    seen.set(xlabel="azimuth [deg]", ylabel="elevation [deg]")
    seen.set_facecolor("0.85")
    seen.grid(False)
    seen.set_title("range errors of a footprint of 4 mm", fontsize=10)
    figure.colorbar(dots, ax=seen, label="mm")

    middle = np.arange(5, 90, 10)
    rows = results["incidence"]
    for name, theory, colour in (
        ("range noise", "range_theory", "C0"),
        ("weak echoes", "weak_theory", "C1"),
        ("direction noise", "direction_theory", "C2"),
        ("footprint", None, "C3"),
    ):
        spread.semilogy(middle, [row[name] for row in rows], "o", ms=5, color=colour, label=name)
        if theory:
            spread.semilogy(middle, [row[theory] for row in rows], lw=1, color=colour)
    spread.set(xlabel="incidence [deg]", ylabel="spread of range errors [mm]")
    spread.yaxis.set_major_formatter("{x:g}")
    spread.set_title("contributions (lines: theory)", fontsize=10)
    spread.legend(fontsize=8)

    rows = results["mixed"]
    size = np.array([row["diameter_mm"] for row in rows])
    mixed.plot(size, [100 * row["mixed"] for row in rows], "o", ms=5, label="mixed echoes")
    fine = np.linspace(0, size.max(), 50)
    expected = 2 * strip_width() * fine / 6000 * results["edge_density"]
    mixed.plot(fine, 100 * expected, "C0--", lw=1, label="strips along edges, added")
    mixed.plot(
        fine, 100 * (1 - np.exp(-expected)), "C0", lw=1, label="strips along edges, overlapping"
    )
    mixed.set(xlabel="footprint at 3 m [mm]", ylabel="fraction of echoes [%]", ylim=(0, None))
    mixed.set_title("echoes from two pebbles", fontsize=10)
    mixed.legend(fontsize=8)
    _study.save_figure(figure, path)


def draw_grids(results, path):
    """The true heights, and the errors of grids from one position and from four."""
    figure, axes = _study.make_figure(3)
    maps = results["maps"]
    shown = (
        ("truth", "true heights", "viridis", (None, None)),
        ("footprint", "one position, footprint only: error", "RdBu_r", (-10, 10)),
        ("all, 4 positions", "four positions, all errors: error", "RdBu_r", (-10, 10)),
    )
    for axis, (name, title, colours, (low, high)) in zip(axes, shown):
        half = 2.5 * len(maps[name]) / 10  # cm
        image = axis.imshow(
            1000 * maps[name].T, origin="lower", cmap=colours, vmin=low, vmax=high,
            extent=(-half, half, -half, half), interpolation="nearest",
        )  # fmt: skip
        axis.set(xlabel="x [cm]", ylabel="y [cm]")
        axis.set_facecolor("0.6")
        axis.grid(False)
        axis.set_title(title, fontsize=10)
        figure.colorbar(image, ax=axis, label="mm")
    _study.save_figure(figure, path)


def main():
    given = _study.arguments(__doc__)
    results = study(given.quick)
    ratio, bound = results["noise"]
    print(f"{results['pebbles']} pebbles; range noise alone: {ratio:.4f} of the configured one")
    print(f"(1 within {bound:.4f}: four standard deviations of chi-square)")
    off = 1000 * (results["simulated"] - results["expected"])
    print(f"single beams against the exact surface: {root_mean_square(off):.2f} mm of")
    print(f"{1000 * root_mean_square(results['expected']):.2f} mm, {len(off)} beams")
    off = results["columns"]["footprint"][results["columns"]["amid"]]
    print(
        f"of errors above 1 mm by the footprint {np.mean(off[np.abs(off) > 1e-3] > 0):.0%} are behind"
    )
    print(f"hidden cells: {results['maps']['hidden'].mean():.1%}")
    print(f"edges: {results['edge_density']:.1f} rad/rad^2, jumps of {results['edge_jump']:.1f} mm")
    titles = dict(
        ranges="Range errors [mm]",
        incidence="Their spread by incidence [mm]",
        mixed="Mixed echoes by footprint; errors [mm]",
        grids="Grids of heights, cells of 5 mm; errors [mm]",
    )
    for name, title in titles.items():
        _study.print_table(results[name], title)
        _study.write_csv(given.out / f"pebbles_{name}.csv", results[name])
    draw_errors(results, given.out / "pebbles_errors.png")
    draw_grids(results, given.out / "pebbles_grids.png")
    return results


if __name__ == "__main__":
    main()
