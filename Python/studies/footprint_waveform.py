# SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
# SPDX-License-Identifier: BSD-3-Clause
"""Effects of the footprint on the echoes of an airborne scan: width, amplitude, and resolution.

    build/venv/bin/python Python/studies/footprint_waveform.py OUT [--quick]

Slopes are scanned from several heights with several beams, rough ground with footprints from much
smaller to much larger than its bumps, and a step on a slope with one beam along its edge. All are
compared with closed forms. Docs/studies/footprint_waveform.md has the results.
"""

import sys
from pathlib import Path

import numpy as np

import vtkhelios

sys.path.insert(0, str(Path(__file__).resolve().parent))
import _study  # noqa: E402
from _rough_ground import RoughGround  # noqa: E402

LIGHT = 0.299792458  # m/ns
FWHM = 2.3548200450309493  # full width at half maximum of a Gaussian, over its sigma
SIGMA = 4.0 / FWHM  # ns, of the pulse: 4 ns in the catalogue
CUT = 1.5  # the sampled cone, in units of w: the default of vtkHeliosBeamSampler
SUB_RAYS = 256
LARGEST_SPREAD = 5.0  # largest q at which 256 sub-rays give one echo of a plane
EXTINCTION = 3.912 / 23 * (1.064 / 0.55) ** -1.3 / 1000  # 1/m, Kruse: 23 km at 1064 nm


def cut_share(cut=CUT):
    """Variance of a beam truncated at `cut` w, as a fraction of the whole."""
    if np.isinf(cut):
        return 1.0
    rest = np.exp(-2 * cut**2)
    return 2 * (0.5 - rest * (cut**2 + 0.5)) / (1 - rest)


def spread(distance, w, incidence):
    """q: standard deviation of ranges on a tilted plane, in time, over the pulse's sigma."""
    return distance * w * np.tan(incidence) / (LIGHT * SIGMA)


def slope_sigma(distance, w, incidence, cut=CUT):
    """Sigma of the echo of a tilted plane [ns]: footprint and pulse add in quadrature."""
    return SIGMA * np.sqrt(1 + cut_share(cut) * spread(distance, w, incidence) ** 2)


def slope_shift(distance, w, incidence):
    """Distance of the echo of a tilted plane beyond its axis [m]: power-weighted mean range."""
    variance = cut_share() * w**2 / 4
    return distance * variance * (1 - 2 * np.tan(incidence) ** 2)


def full_power(distance, incidence, reflectance=0.5):
    """The lidar equation for the catalogue's instrument [W]: the peak of an unwidened echo."""
    aperture, optics, power = 0.15, 0.99, 4.0
    air = np.exp(-2 * EXTINCTION * distance)
    return (
        power * reflectance * np.cos(incidence) * aperture**2 / 4 * optics * air / distance**2
    )


# Slopes ------------------------------------------------------------------------------------------


def make_slope(slope, size=6000.0):
    """A plane that rises to the right of a northbound flight by `slope` [deg]."""
    rise = size * np.tan(np.radians(slope))
    points = [(x, y, z) for x, z in ((-size, -rise), (size, rise)) for y in (-size, size)]
    return vtkhelios.Scene(points, [(0, 2, 3), (0, 3, 1)])


def waveform_moments(waveforms, ids):
    """Mean range [m] and standard deviation [ns] of the waveforms with these pulse ids: no fit."""
    table = vtkhelios.arrays(waveforms)
    moments = []
    for row in np.searchsorted(table["PulseIds"], ids):
        begin, count = table["Offset"][row], table["Count"][row]
        power = table["Samples"][begin : begin + count].astype(float)
        power /= power.sum()
        time = np.arange(count) * table["BinSize"][row]
        mean = power @ time
        range_ = (table["StartTime"][row] + mean) * LIGHT / 2
        moments.append((range_, np.sqrt(power @ (time - mean) ** 2)))
    return np.transpose(moments)


def strongest_of(cloud):
    """The strongest echo of each pulse, in the order of pulses."""
    order = np.lexsort((-cloud["Amplitude"], cloud["PulseIds"]))
    ids = cloud["PulseIds"][order]
    return cloud[order[np.r_[True, ids[1:] != ids[:-1]]]]


def scan_slope(slope, height, divergence, sub_rays=SUB_RAYS):
    """One strip over a slope; theory and measurement of each pulse."""
    cloud = vtkhelios.scan(
        make_slope(slope),
        path=[(0, 0, height), (0, 100, height)],
        platform="airplane_linearpath",
        scanner="rotating_als",
        speed=50,
        pulse_frequency=150_000,
        scan_frequency=300,
        duration=1 / 300,  # s: one line
        beam_divergence=divergence,
        sub_rays=sub_rays,  # None: adaptive
        detector="gaussian",
        noise=False,
        waveforms=True,
        pulses=True,
    )
    pulses, cloud = cloud.pulses, strongest_of(cloud)
    rows = np.searchsorted(pulses["PulseIds"], cloud["PulseIds"])
    angle = np.radians(slope)
    normal = np.array([-np.sin(angle), 0, np.cos(angle)])
    cosine = -pulses["Direction"][rows] @ normal
    distance = (pulses.points[rows] @ normal) / cosine
    incidence = np.arccos(np.minimum(cosine, 1))
    w = divergence / 2
    mean_range, sigma_moments = waveform_moments(cloud.waveforms, cloud["WaveformIds"])
    return dict(
        slope=np.full(len(rows), slope),
        height=np.full(len(rows), height),
        divergence=np.full(len(rows), divergence),
        incidence=np.degrees(incidence),
        distance=distance,
        q=spread(distance, w, incidence),
        sigma_theory=slope_sigma(distance, w, incidence),
        sigma_whole_beam=slope_sigma(distance, w, incidence, cut=np.inf),
        sigma_moments=sigma_moments,
        sigma_fit=cloud["EchoWidth"] / FWHM,
        amplitude=cloud["Amplitude"] / full_power(distance, incidence),
        echoes=cloud["NumberOfReturns"],
        shift_theory=slope_shift(distance, w, incidence),
        shift_moments=mean_range - distance,
        shift_fit=cloud["Range"] - distance,
    )


def study_slopes(quick=False):
    """The columns of scan_slope() for all strips, concatenated."""
    heights, slopes = ((1000,), (0, 40)) if quick else ((500, 1000, 2000), (0, 20, 40))
    strips = [
        scan_slope(slope, height, divergence)
        for height in heights
        for slope in slopes
        for divergence in (0.25e-3, 0.5e-3, 1e-3)
    ]
    return {name: np.concatenate([strip[name] for strip in strips]) for name in strips[0]}


def study_false_echoes():
    """Where a plane gets more than one echo: a row for each beam sampling method."""
    rows = []
    for sub_rays in (SUB_RAYS, 1024, None):
        strip = scan_slope(40, 2000, 1e-3, sub_rays)
        false = strip["echoes"] > 1
        rows.append(
            dict(
                sub_rays=sub_rays or "adaptive",
                pulses=len(false),
                with_false_echoes=int(false.sum()),
                from_q=float(strip["q"][false].min(initial=np.inf)),
            )
        )
    return rows


# Rough ground ------------------------------------------------------------------------------------


def study_roughness(quick=False, height=1000.0):
    """A row for each roughness and footprint: widening by bumps, measured and theoretical."""
    ground = RoughGround(400 if quick else 700)
    half = ground.count * ground.cell / 2
    radii = (0.1, 0.4) if quick else (0.1, 0.2, 0.4, 0.8, 1.6)
    ends = [(0, -half, height), (0, half, height)]
    legs = [dict(position=ends[k % 2], beam_divergence=2 * w / height) for k, w in enumerate(radii)]
    rows = []
    for deviation in (0.1,) if quick else (0.05, 0.1, 0.2):
        survey = vtkhelios.make_survey(
            ground.make_scene(deviation),
            [*legs, dict(position=ends[len(radii) % 2], active=False)],
            scanner="rotating_als",
            platform="airplane_linearpath",
            pulse_frequency=150_000,
            scan_frequency=100,
            scan_angle=np.degrees(np.arctan(half / height)),
            speed=150,
        )
        cloud = survey.run(
            sub_rays=SUB_RAYS, detector="gaussian", noise=False, waveforms=True, pulses=True
        )
        for leg, w in enumerate(radii):
            rows.append(_roughness_row(ground, cloud, leg, deviation, w, height))
    return rows


def _roughness_row(ground, cloud, leg, deviation, w, height):
    inner = np.abs(cloud.points[:, :2]).max(axis=1) < ground.count * ground.cell / 2 - 2 * w - 0.2
    echoes = cloud[(cloud["LegIds"] == leg) & inner]
    rows = np.searchsorted(cloud.pulses["PulseIds"], echoes["PulseIds"])
    direction = cloud.pulses["Direction"][rows]
    reach = height / -direction[:, 2]
    foot = cloud.pulses.points[rows] + direction * reach[:, None]
    tilt = slope_sigma(reach, w / height, np.arccos(height / reach)) ** 2  # slightly off nadir
    moments = waveform_moments(cloud.waveforms, echoes["WaveformIds"])[1] ** 2 - tilt
    fitted = (echoes["EchoWidth"] / FWHM) ** 2 - tilt
    unit = (2 * deviation / LIGHT) ** 2  # ns^2, of bumps much smaller than the footprint
    truth = ground.variance_within(foot[:, :2], w, CUT, deviation)
    lowered = (SIGMA / np.sqrt(tilt + unit * truth)).mean() * ground.cosines(deviation).mean()
    return dict(
        deviation=deviation,
        w=w,
        echoes=len(echoes),
        law=ground.expected_within(w, cut_share()),
        truth=float(truth.mean()),
        moments=float(moments.mean() / unit),
        fit=float(fitted.mean() / unit),
        correlation=float(np.corrcoef(truth, moments)[0, 1]),
        width=float(echoes["EchoWidth"].mean()),
        amplitude=float((echoes["Amplitude"] / full_power(echoes["Range"], 0)).mean()),
        amplitude_theory=float(lowered),
    )


# Two surfaces ------------------------------------------------------------------------------------


def fire_at_step(
    step, slope=0.0, offset=0.0, distance=1000.0, w=0.5e-3, cut=CUT, sub_rays=4096, detector=None
):
    """The echoes of one beam along the edge of a step [m] up a slope [deg], `offset` w away."""
    size, tangent = 20 * w * distance, np.tan(np.radians(slope))
    points = [
        (x, distance + z * tangent + behind, z)
        for side, behind in ((-size, 0), (size, step))
        for x in (0, side)
        for z in (-size, size)
    ]
    scene = vtkhelios.Scene(points, [(0, 1, 3), (0, 3, 2), (4, 5, 7), (4, 7, 6)])
    place = vtkhelios.Cloud.from_arrays([[-offset * w * distance, 0, 0]])
    platform = place >> vtkhelios.vtkHeliosStaticPlatform()
    beam = vtkhelios.vtkHeliosBeamSampler(
        beam_divergence=2 * w, pattern="vogel", number_of_sub_rays=sub_rays, truncation=cut
    )
    scanner = vtkhelios.vtkHeliosScanner(
        beam_deflector=vtkhelios.vtkHeliosFiberArray(number_of_fibers=1, pulse_frequency=1),
        beam_sampler=beam,
        sampling="fixed",
        bin_size=0.05,  # ns: near the limit the dip between two maxima is narrow
        duration=1,  # s: one pulse
    )
    if detector:
        scanner.echo_detector = detector
    return vtkhelios.Cloud(((scene, platform) >> scanner)())


def least_separation(sigma, ratio=1.0):
    """Least separation of two Gaussians of a sigma [ns] and amplitude ratio with two maxima [m]."""
    low, high = 1.0, 20.0
    for _ in range(60):
        d = (low + high) / 2
        root = np.sqrt(d * d - 1)
        if abs(np.log(ratio)) > 2 * d * root + 2 * np.log(d - root):
            low = d
        else:
            high = d
    return LIGHT * sigma * high


def find_limit(sigma, **beam):
    """The least step that gives two echoes [m], by bisection."""
    low, high = 0.3 * LIGHT * sigma, 4 * LIGHT * sigma
    while high - low > 2e-4 * high:
        step = (low + high) / 2
        low, high = (low, step) if len(fire_at_step(step, **beam)) > 1 else (step, high)
    return high


def energy_beyond(offset, cut):
    """The fraction of a truncated (`cut` w) beam's energy beyond an edge at `offset` w from its axis."""
    x = offset + (cut - offset) * (np.arange(20000) + 0.5) / 20000
    y = np.linspace(0, cut, 4001)
    half = np.concatenate([[0], np.cumsum(np.exp(-2 * ((y[1:] + y[:-1]) / 2) ** 2))]) * y[1]
    columns = 2 * np.interp(np.sqrt(cut**2 - x**2), y, half)
    return (
        (np.exp(-2 * x**2) @ columns) * (x[1] - x[0]) / (np.pi / 2 * (1 - np.exp(-2 * cut**2)))
    )


def study_limits(quick=False):
    """A row for each slope and offset: the smallest resolved step, and the theory."""
    slopes, offsets = ((0, 60), (0.5,)) if quick else ((0, 30, 45, 60, 70), (0.1, 0.25, 0.5, 0.75))
    beams = [(slope, 0.0) for slope in slopes] + [(0, offset) for offset in offsets]
    rows = []
    for slope, offset in beams:
        for cut in (CUT, 3.0):
            sigma = float(slope_sigma(1000.0, 0.5e-3, np.radians(slope), cut))
            rays = 4096 if quick else 16384
            found = find_limit(sigma, slope=slope, offset=offset, cut=cut, sub_rays=rays)
            share = energy_beyond(offset, cut)
            nearer = np.exp(-2 * EXTINCTION * found) * (1000 / (1000 + found)) ** 2
            ratio = share / (1 - share) * nearer
            rows.append(
                dict(
                    slope=slope,
                    offset=offset,
                    cut=cut,
                    ratio=float(ratio),
                    sigma=sigma,
                    theory=least_separation(sigma, ratio),
                    found=found,
                )
            )
    return rows


def study_steps(quick=False):
    """Results of each detector for steps on level ground: rows of step, detector, range, width."""
    detectors = {
        "peak": None,
        "gaussian": vtkhelios.vtkHeliosGaussianDecomposition(resolve_hidden=True),
    }
    rows = []
    for step in np.linspace(0.1, 1.2, 12 if quick else 45):
        for name, detector in detectors.items():
            echoes = fire_at_step(float(step), sub_rays=1024, detector=detector)
            for where, width in zip(echoes["Range"] - 1000, echoes["EchoWidth"]):
                rows.append(dict(step=step, detector=name, range=where, width=width))
    return rows


# Full study -------------------------------------------------------------------------------------


def summarise(slopes):
    """Errors of the echo width of slopes against theory, by q: rows of relative errors."""
    rows = []
    limits = (0, 0.25, 0.5, 1, 2, 3, LARGEST_SPREAD, 12)
    for low, high in zip(limits[:-1], limits[1:]):
        chosen = (slopes["q"] >= low) & (slopes["q"] < high)
        if not chosen.any():
            continue
        part = {name: values[chosen] for name, values in slopes.items()}
        share = cut_share() * part["q"] ** 2
        rows.append(
            {
                "q": f"{low:g}-{high:g}",
                "pulses": int(chosen.sum()),
                "with_false_echoes": int((part["echoes"] > 1).sum()),
                "width_over_pulse": float((part["sigma_moments"] / SIGMA).mean()),
                "moments_error": _largest(part["sigma_moments"] / part["sigma_theory"]),
                "fit_error": _largest(part["sigma_fit"] / part["sigma_theory"]),
                "whole_beam_error": _largest(part["sigma_fit"] / part["sigma_whole_beam"]),
                "amplitude_error": _largest(part["amplitude"] * np.sqrt(1 + share)),
                "shift_theory_mm": float(1000 * part["shift_theory"].mean()),
                "shift_moments_mm": float(1000 * part["shift_moments"].mean()),
                "shift_fit_mm": float(1000 * part["shift_fit"].mean()),
            }
        )
    return rows


def _largest(ratio):
    """The largest deviation from 1, with its sign."""
    return float((ratio - 1)[np.abs(ratio - 1).argmax()])


def study(quick=False):
    """All measurements and their theory: slopes (columns), the others rows."""
    slopes = study_slopes(quick)
    return dict(
        slopes=slopes,
        summary=summarise(slopes),
        false_echoes=study_false_echoes(),
        roughness=study_roughness(quick),
        limits=study_limits(quick),
        steps=study_steps(quick),
    )


# Pictures and tables -----------------------------------------------------------------------------


def draw_slopes(slopes, path, height=1000, slope=40):
    """Echo widths over incidence, amplitudes and width errors over q."""
    figure, (width, amplitude, error) = _study.make_figure(3)
    here = (slopes["height"] == height) & (slopes["slope"] == slope)
    here &= slopes["q"] < LARGEST_SPREAD
    for divergence in np.unique(slopes["divergence"]):
        chosen = np.flatnonzero(here & (slopes["divergence"] == divergence))
        chosen = chosen[np.argsort(slopes["incidence"][chosen])]
        angle = slopes["incidence"][chosen]
        dots = width.plot(angle[::8], FWHM * slopes["sigma_fit"][chosen][::8], ".", ms=6)[0]
        dots.set_label(f"{1000 * divergence:g} mrad")
        width.plot(angle, FWHM * slopes["sigma_theory"][chosen], color=dots.get_color(), lw=1)
    width.set(xlabel="incidence [deg]", ylabel="echo width, FWHM [ns]", ylim=(0, None))
    width.set_title(f"fitted width, slope of {slope}° from {height} m", fontsize=10)
    width.legend(title="dots; lines: theory", fontsize=8, title_fontsize=8)

    order = np.argsort(slopes["q"])
    order = order[slopes["q"][order] < LARGEST_SPREAD]
    q = slopes["q"][order]
    few = order[:: max(1, len(order) // 400)]
    amplitude.loglog(slopes["q"][few], slopes["amplitude"][few], ".", ms=5, label="all strips")
    amplitude.loglog(q, 1 / np.sqrt(1 + cut_share() * q**2), "k", lw=1, label="theory")
    amplitude.set(xlim=(0.05, 6), ylim=(0.15, 1.15), xlabel="q = R w tan θ / (c σ)")
    amplitude.set(yticks=(0.2, 0.3, 0.5, 0.7, 1), ylabel="amplitude / amplitude at q = 0")
    amplitude.yaxis.set_major_formatter("{x:g}")
    amplitude.yaxis.set_minor_formatter("")
    amplitude.xaxis.set_major_formatter("{x:g}")
    amplitude.set_title("amplitude lost to the spread of ranges", fontsize=10)
    amplitude.legend(fontsize=8)

    for name, against, label in (
        ("sigma_moments", "sigma_theory", "second moment / theory"),
        ("sigma_fit", "sigma_theory", "fit / theory"),
        ("sigma_fit", "sigma_whole_beam", "fit / theory, beam not truncated"),
    ):
        percent = 100 * (slopes[name] / slopes[against] - 1)
        error.plot(slopes["q"][few], percent[few], ".", ms=5, label=label)
    error.set(xlabel="q", ylabel="width against theory [%]", xlim=(0, 5), ylim=(-2.4, 1.5))
    error.set_title("validity of the theory", fontsize=10)
    error.legend(fontsize=8, loc="lower right")
    _study.save_figure(figure, path)


def draw_ground_and_steps(roughness, limits, steps, path):
    """Widening by roughness over the footprint, and resolution."""
    figure, (rough, limit, found) = _study.make_figure(3)
    w = np.geomspace(0.06, 2.5, 100)
    x = cut_share() * w**2
    rough.semilogx(w, x / (1 + x), "k", lw=1, label="theory")
    for deviation in sorted({row["deviation"] for row in roughness}):
        rows = [row for row in roughness if row["deviation"] == deviation]
        rough.plot(
            [row["w"] for row in rows], [row["fit"] for row in rows], "o", ms=5, mfc="none",
            label=f"σ_h = {100 * deviation:g} cm",
        )  # fmt: skip
    rough.xaxis.set_major_formatter("{x:g}")
    rough.set(xlabel="footprint radius w / correlation length L", ylim=(0, 1))
    rough.set(ylabel="widening / (2 σ_h / c)²")
    rough.set_title("rough ground: variance added to echoes", fontsize=10)
    rough.legend(fontsize=8)

    angle = np.linspace(0, 72, 100)
    for cut, name, colour in (
        (CUT, "beam truncated at 1.5 w", "C0"),
        (3.0, "beam truncated at 3 w", "C1"),
    ):
        sigma = slope_sigma(1000.0, 0.5e-3, np.radians(angle), cut)
        limit.plot(angle, LIGHT * sigma, color=colour, lw=1, label=f"c σ', {name}")
        rows = [row for row in limits if row["cut"] == cut and row["offset"] == 0]
        where = [row["slope"] for row in rows]
        limit.plot(where, [row["found"] for row in rows], "o", ms=5, mfc="none", color=colour)
    limit.set(xlabel="slope [deg]", ylabel="smallest step with two echoes [m]", ylim=(0, None))
    limit.set_title("step on a slope, footprint w = 0.5 m", fontsize=10)
    limit.legend(title="circles: simulated; lines: theory", fontsize=8, title_fontsize=8)

    for name, look in (("gaussian", "x"), ("peak", ".")):
        rows = [row for row in steps if row["detector"] == name]
        found.plot(
            [row["step"] for row in rows], [row["range"] for row in rows], look, ms=5, label=name
        )
    found.plot([0.1, 1.2], [0, 0], "k", lw=0.8)
    found.plot([0.1, 1.2], [0.1, 1.2], "k", lw=0.8, label="truth")
    found.axvline(LIGHT * SIGMA, color="0.6", ls="--", lw=1, label="c σ")
    found.set(xlabel="step [m]", ylabel="range of echoes relative to the first [m]")
    found.set_title("level steps: echoes by detector", fontsize=10)
    found.legend(fontsize=8)
    _study.save_figure(figure, path)


def main():
    given = _study.arguments(__doc__)
    results = study(given.quick)
    _study.print_table(results["summary"], "Slopes: largest relative errors by q")
    _study.print_table(results["false_echoes"], "False echoes of a plane, slope of 40 deg, 1 mrad")
    _study.print_table(results["roughness"], "Rough ground: variance added, over (2 sigma_h / c)^2")
    _study.print_table(results["limits"], "Steps: least separation [m]")
    slopes = results["slopes"]
    kept = range(0, len(slopes["q"]), 10)
    rows = [{name: float(values[k]) for name, values in slopes.items()} for k in kept]
    _study.write_csv(given.out / "footprint_waveform.csv", rows)
    for name in ("summary", "false_echoes", "roughness", "limits", "steps"):
        _study.write_csv(given.out / f"footprint_waveform_{name}.csv", results[name])
    draw_slopes(slopes, given.out / "footprint_waveform_slopes.png")
    draw_ground_and_steps(
        results["roughness"],
        results["limits"],
        results["steps"],
        given.out / "footprint_waveform_surfaces.png",
    )
    return results


if __name__ == "__main__":
    main()
