# SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
# SPDX-License-Identifier: BSD-3-Clause
"""Trajectories and georeferencing, against recorded data and independent computations.

    build/venv/bin/python Python/studies/trajectories.py OUT [--quick]

Reads data of others from the folder real/ of HELIOS_DATA (without it: data of a folder "shared"
beside the repository): the pulses of an Optech ALTM, the shots of NASA's ATM, an SBET file and an
error report of Applanix. Prints the tables of Docs/validation/trajectories.md and draws its figure.
"""

import numpy as np

import _pages
import _study
import vtkhelios

from _georeference import (
    DATA, ECCENTRICITY, SEMI_MAJOR, georeference_in_ecef, georeference_with_vtkhelios, platform_of,
    read_csd, to_local, turn,
)  # fmt: skip
from _mirror_laws import LAWS, fit_harmonics, fit_law
from _palmer import fit_pattern, palmer, read_qfit

__all__ = ["DATA", "palmer", "platform_of", "read_csd", "read_qfit", "fit_pattern"]

PULSES_PER_SECOND = 1 / 14.00023801e-6  # rate of the Optech file
COMPONENTS = ("east", "north", "up", "pitch", "roll", "heading")
POINTS = {  # comparison: words of the page
    "local": "local system (`ENU`), against geocentric coordinates",
    "utm": "UTM in place of the local system",
    "arinc": "roll before pitch (`ARINC_705` of HELIOS files) in place of `NAVIGATION`",
}


def compare_georeferencing(pulses, boresight):
    """Distances of our points to those computed in geocentric coordinates [m], by system."""
    origin = pulses["latitude"][0], pulses["longitude"][0], pulses["height"][0]
    degrees = np.degrees(origin[:2])
    local = "ENU {:.17g} {:.17g} {:.17g}".format(*degrees, origin[2])
    exact = to_local(georeference_in_ecef(pulses, boresight), origin)
    ours = georeference_with_vtkhelios(pulses, boresight, local)
    found = {"local": np.linalg.norm(ours - exact, axis=1)}

    # UTM: the ground point is the aircraft plus the beam, both in the map
    zone = int((degrees[1] + 180) // 6) + 1
    utm = f"EPSG:{32600 + zone}"
    mapped = georeference_with_vtkhelios(pulses, boresight, utm)
    truth = _transform(exact, local, utm)
    found["utm"] = np.linalg.norm(mapped - truth, axis=1)

    # pitch and roll in the order of ARINC_705 of HELIOS files
    beam = np.stack(
        [np.sin(pulses["angle"]), 0 * pulses["angle"], -np.cos(pulses["angle"])], -1
    ) * pulses["range"][:, :1]  # fmt: skip
    rolled = (
        turn(0, 0, pulses["heading"]) @ turn(pulses["roll"], 0, 0) @ turn(0, pulses["pitch"], 0)
    )
    right = turn(pulses["roll"], pulses["pitch"], pulses["heading"])
    body = beam @ turn(*boresight)[0].T
    found["arinc"] = np.linalg.norm(np.einsum("nij,nj->ni", rolled - right, body), axis=1)
    return found


def _transform(points, source, target):
    """Points in another system, by vtkHeliosReproject."""
    data = vtkhelios.Cloud.from_arrays(points).polydata
    reproject = vtkhelios.vtkHeliosReproject()
    reproject.SetInputData(data)
    reproject.SetSourceCRS(source)
    reproject.SetTargetCRS(target)
    return vtkhelios.arrays(vtkhelios.update(reproject))["points"].copy()


def angle_noise(pulses):
    """RMS of the recorded scan angles about a local polynomial [deg]."""
    angles = np.degrees(pulses["angle"])
    window = np.arange(-15, 16)
    basis = np.linalg.pinv(np.vander(window, 5))[-1]
    smooth = np.convolve(angles, basis[::-1], "valid")
    return float(np.std(angles[15:-15] - smooth))


def fit_mirror(pulses):
    """vtkHeliosOscillatingMirror with a rounded triangle, fitted to the recorded angles [deg]."""
    angles = np.degrees(pulses["angle"])
    fine = 1000  # mirror steps per pulse, for phases between pulses
    mirror = vtkhelios.vtkHeliosOscillatingMirror()
    mirror.SetPulseFrequency(fine * PULSES_PER_SECOND)

    def follow(unknowns):
        angle, frequency, phase, turning, offset = unknowns
        mirror.SetScanAngle(angle)
        mirror.SetScanFrequency(frequency)
        mirror.SetTurningPulses(int(round(fine * turning)))
        steps = np.round(fine * (np.arange(len(angles)) + phase)).astype(int)
        return np.array([mirror.GetScanAngle(int(step)) for step in steps]) + offset - angles

    unknowns = np.array([15.2, 59.9, 1155.0, 129.0, 0.0])
    steps = np.array([0.01, 0.01, 0.1, 1.0, 0.01])
    residual = follow(unknowns)
    for _ in range(6):
        jacobian = np.stack(
            [(follow(unknowns + e) - follow(unknowns - e)) / (2 * e.sum()) for e in np.diag(steps)],
            -1,
        )
        unknowns = unknowns - np.linalg.lstsq(jacobian, residual, rcond=None)[0]
        residual = follow(unknowns)
    names = "angle", "frequency", "phase", "turning", "offset"
    return dict(zip(names, unknowns)), residual


def compare_laws(pulses):
    """Residuals [deg] and number of unknowns of laws of the scan angle, by name."""
    time, angle = pulses["time"] - pulses["time"][0], np.degrees(pulses["angle"])
    found = {name: fit_law(name, time, angle, 59.9) for name in LAWS}
    for highest in (7, 11):
        found[f"odd harmonics to {highest}, all free"] = fit_harmonics(highest, time, angle, 59.9)
    return found


def compare_wander(path):
    """Returns the direction of motion of two SBET records less the direction of their velocity
    [deg], by the use of the
    wander angle."""
    records = np.fromfile(path, "<f8").reshape(-1, 17)[:2]
    latitude, height = records[0, 1], records[0, 3]
    w = 1 - ECCENTRICITY * np.sin(latitude) ** 2
    step = np.diff(records[:, 1:3], axis=0)[0]
    north = step[0] * (SEMI_MAJOR * (1 - ECCENTRICITY) / w**1.5 + height)
    east = step[1] * (SEMI_MAJOR / np.sqrt(w) + height) * np.cos(latitude)
    x, y = records[:, 4:6].mean(axis=0)
    azimuth = np.degrees(np.arctan2(-y, x))  # clockwise from x; y is to the left
    wander = np.degrees(records[0, 10])
    motion = np.degrees(np.arctan2(east, north))
    return {
        "subtracted": motion - (azimuth - wander),
        "added": motion - (azimuth + wander),
        "ignored": motion - azimuth,
    }


def compare_projection(folder, count=2000):
    """SBET records in UTM zone 32 against pyproj: largest differences of position [m] and yaw [rad].

    Latitudes from -79 to 83 degrees, longitudes of the zone, all headings."""
    import pyproj

    random = np.random.default_rng(1)
    records = np.zeros((count, 17))
    records[:, 0] = np.arange(count)
    records[:, 1] = np.radians(random.uniform(-79, 83, count))
    records[:, 2] = np.radians(random.uniform(6, 12, count))
    records[:, 3] = random.uniform(-50, 3000, count)
    records[:, 9] = random.uniform(0, 2 * np.pi, count)
    path = folder / "zone32.sbet"
    records.astype("<f8").tofile(path)
    reader = vtkhelios.vtkHeliosTrajectoryReader()
    reader.SetFileName(str(path))
    reader.SetTargetCRS("EPSG:32632")
    rows = vtkhelios.arrays(vtkhelios.update(reader))
    path.unlink()
    projection = pyproj.Proj("EPSG:32632")
    degrees = np.degrees(records[:, 2]), np.degrees(records[:, 1])
    expected = np.stack([*projection(*degrees), records[:, 3]], -1)
    convergence = np.radians(projection.get_factors(*degrees).meridian_convergence)
    w, x, y, z = rows["Orientation"].T
    yaw = np.arctan2(2 * (x * y - w * z), 1 - 2 * (x * x + z * z))  # heading of y, clockwise
    turned = np.sin(yaw - (records[:, 9] - convergence))
    return np.abs(rows["points"] - expected).max(), np.abs(turned).max()


def make_errors(rms, time):
    """vtkHeliosPlatformNoise with slow errors: RMS of six components, correlation time [s]."""
    noise = vtkhelios.vtkHeliosPlatformNoise()
    for component, value in enumerate(rms):
        noise.SetSlowError(component, value, time)
    return noise


def sample_errors(noise, times, seed=0):
    """Slow errors at times [s]: (n, 6)."""
    values = np.empty((len(times), 6))
    for k, time in enumerate(times):
        row = [0.0] * 6
        noise.GetSlowErrors(seed, float(time), row)
        values[k] = row
    return values


def check_errors(noise, time, count):
    """RMS and autocorrelation of slow errors every quarter of the correlation time, with three
    standard errors of the estimates (Bartlett): rows of a table."""
    values = sample_errors(noise, 0.25 * time * np.arange(count))
    ratio = np.exp(-0.25)
    error = 3 * np.sqrt((1 + ratio**2) / (1 - ratio**2) / count)
    rows = []
    for component, name in enumerate(COMPONENTS):
        x = values[:, component]
        given = noise.GetSlowErrorRMS(component)
        variance = np.mean(x**2)
        row = {"component": name, "RMS given": given, "RMS found": np.sqrt(variance)}
        row["bound"] = given * error / np.sqrt(2)
        for lag in (4, 8):
            row[f"r({lag // 4} T)"] = np.mean(x[lag:] * x[:-lag]) / variance
        rows.append(row)
    return rows


def fly_strips(seed=0, starts=(0, 400, 800), height=500.0, speed=60.0, time=60.0):
    """Strips over a plane at z = 0 at several times: mean height of echoes and expected one [m]."""
    plane = vtkhelios.Scene(
        [[-400, -400, 0], [400, -400, 0], [400, 400, 0], [-400, 400, 0]], [[0, 1, 2], [0, 2, 3]]
    )
    noise = make_errors([0.038, 0.041, 0.047, 0.0022, 0.0022, 0.0173], time)
    mirror = vtkhelios.vtkHeliosOscillatingMirror()
    mirror.SetPulseFrequency(1000)
    mirror.SetScanFrequency(10)
    mirror.SetScanAngle(10)
    scanner = vtkhelios.vtkHeliosScanner()
    scanner.SetBeamDeflector(mirror)
    scanner.GetBeamSampler().SetBeamDivergence(0)
    scanner.SetMountOrientation(np.sqrt(0.5), -np.sqrt(0.5), 0, 0)  # down
    scanner.SetInputDataObject(0, plane.polydata)
    scanner.SetPlatformNoise(noise)
    scanner.SetSeed(seed)
    scanner.GenerateTruthOn()
    strips = []
    for start in starts:
        flight = vtkhelios.Cloud.from_arrays(
            np.array([[-120.0, 0, height], [120.0, 0, height]]),
            GpsTime=np.array([start, start + 240 / speed]),
            Orientation=np.array([[1.0, 0, 0, 0]] * 2),
        )
        scanner.SetInputDataObject(1, flight.polydata)
        scanner.SetStartTime(start)
        echoes = vtkhelios.arrays(vtkhelios.update(scanner))
        errors = sample_errors(noise, echoes["GpsTime"][::10], seed)
        strips.append(
            {
                "start": start,
                "heights": float(echoes["points"][:, 2].mean()),
                "expected": float(-errors[:, 2].mean()),
                "spread": float(np.abs(echoes["TruePoint"][:, 2]).max()),
            }
        )
    return strips


def draw(pulses, residual, out):
    """The recorded scan angles and the law's residuals; slow errors and their autocorrelation."""
    figure, axes = _study.make_figure(2, 2)
    axes[0].plot(np.degrees(pulses["angle"]), lw=1)
    axes[0].set(xlabel="pulse", ylabel="scan angle [deg]", title="Optech: recorded")
    axes[1].plot(residual, lw=1)
    axes[1].set(xlabel="pulse", ylabel="deg", title="rounded triangle less recorded")
    noise = make_errors([0.038, 0.041, 0.047, 0, 0, 0], 60.0)
    times = np.arange(0, 1800, 1.0)
    for values, name in zip(sample_errors(noise, times)[:, :3].T, COMPONENTS):
        axes[2].plot(times, values, lw=1, label=name)
    axes[2].set(xlabel="time [s]", ylabel="error [m]", title="slow errors, T = 60 s")
    axes[2].legend()
    x = sample_errors(noise, 5.0 * np.arange(20000))[:, 2]
    lags = np.arange(0, 41)
    found = [np.mean(x[k:] * x[: len(x) - k]) / np.mean(x**2) for k in lags]
    axes[3].plot(5 * lags, found, ".", label="found")
    law = np.exp(-5 * lags / 60)
    axes[3].plot(5 * lags, law, lw=1, label="exp(-s / T)")
    ratio = np.exp(-2 * 5 / 60)
    band = 2 * np.sqrt((1 + ratio) / (1 - ratio) / len(x))  # spread of large lags (Bartlett)
    axes[3].fill_between(5 * lags, law - band, law + band, alpha=0.2, label="2 standard errors")
    axes[3].set(xlabel="lag s [s]", ylabel="autocorrelation", title="28 h of the up component")
    axes[3].legend()
    _study.save_figure(figure, out / "trajectories.png")


SLOW_ERROR_TIME = 60.0  # correlation time [s]
WINDOWS = [(40, 45), (70, 72), (70, 75), (100, 105)]  # windows of the ATM [s]


def make_tables(data, _tools):
    """The tables of trajectories.md."""
    pulses, boresight = read_csd(data / "sensor" / "optech_sample.csd")
    yield _georeferencing_table(compare_georeferencing(pulses, boresight))
    yield _mirror_table(pulses)
    yield _laws_table(compare_laws(pulses))
    yield _atm_table(read_qfit(data / "sensor" / "atm_qfit.qi"))
    noise = read_errors(data / "trajectory" / "smrmsg.txt")
    rows = [_errors_row(row) for row in check_errors(noise, SLOW_ERROR_TIME, 50000)]
    titles = ["component", "RMS given", "RMS found", "bound", "r(T)", "r(2 T)"]
    yield _pages.Table("trajectories.md", "slow errors", titles, rows)
    yield _strips_table(fly_strips())


def draw_figures(data, folder):
    pulses, _ = read_csd(data / "sensor" / "optech_sample.csd")
    draw(pulses, fit_mirror(pulses)[1], folder)


def read_errors(path):
    """Slow errors of the RMS of an error report."""
    if not path.is_file():
        raise FileNotFoundError(2, "no report", str(path))
    report = vtkhelios.vtkHeliosNavigationReport()
    report.Read(str(path))
    return make_errors([report.GetRMS(k) for k in range(6)], SLOW_ERROR_TIME)


def _georeferencing_table(found):
    places = {"local": 8, "utm": 3, "arinc": 3}
    rows = []
    for name, words in POINTS.items():
        ends = np.sqrt(np.mean(found[name] ** 2)), found[name].max()
        rows.append([words, *(f"{end:.{places[name]}f} m" for end in ends)])
    titles = ["points of", "RMS", "largest"]
    return _pages.Table("trajectories.md", "georeferencing", titles, rows)


def _mirror_table(pulses):
    fitted, residual = fit_mirror(pulses)
    row = [
        f"{fitted['angle']:.2f} deg",
        f"{fitted['frequency']:.2f} Hz",
        f"{fitted['turning']:.0f} pulses",
        f"{np.sqrt(np.mean(residual**2)):.3f} deg",
        f"{np.abs(residual).max():.3f} deg",
        f"{angle_noise(pulses):.4f} deg",
    ]
    titles = ["scan angle", "frequency", "turning", "RMS", "largest", "noise of the record"]
    return _pages.Table("trajectories.md", "mirror", titles, [row])


def _laws_table(found):
    rows = []
    for name, (residual, unknowns) in found.items():
        ends = np.sqrt(np.mean(residual**2)), np.abs(residual).max()
        rows.append([name, str(unknowns), *(f"{end:.3f} deg" for end in ends)])
    return _pages.Table(
        "trajectories.md", "mirror laws", ["law", "unknowns", "RMS", "largest"], rows
    )


def _atm_table(shots):
    rows = []
    for window in WINDOWS:
        cone, wobbling = (fit_pattern(shots, *window, kind) for kind in ("cone", "palmer"))
        rows.append(
            [
                f"{window[0]}-{window[1]} s",
                f"{cone['shots']:,}",
                f"{cone['rms']:.1f} m",
                f"{cone['median']:.1f} m",
                f"{wobbling['rms']:.2f} m",
                f"{wobbling['median']:.2f} m",
                f"{wobbling['angle']:.2f} deg",
                f"{wobbling['phase']:.1f} deg",
                f"{wobbling['speed']:.1f} m/s",
            ]
        )
    fits = [f"{kind}: {what}" for kind in ("cone", "Palmer") for what in ("RMS", "median")]
    titles = ["window", "shots", *fits, "wobble", "phase", "speed"]
    return _pages.Table("trajectories.md", "atm", titles, rows)


def _errors_row(row):
    unit = "m" if row["component"] in COMPONENTS[:3] else "deg"
    numbers = [f"{row[name]:#.4g}" for name in ("RMS given", "RMS found")]
    ends = [f"{row[name]:.3f}" for name in ("r(1 T)", "r(2 T)")]
    return [f"{row['component']} [{unit}]", *numbers, f"{row['bound']:#.2g}", *ends]


def _strips_table(strips):
    titles = [
        "start",
        "mean height of the echoes",
        "less the mean error",
        "largest height of `TruePoint`",
    ]
    rows = [
        [
            f"{strip['start']} s",
            f"{strip['heights']:.4f} m",
            f"{strip['expected']:.4f} m",
            f"{strip['spread']:.0e} m",
        ]
        for strip in strips
    ]
    return _pages.Table("trajectories.md", "strips", titles, rows)


def main():
    options = _study.arguments(__doc__)
    pulses, boresight = read_csd(DATA / "sensor" / "optech_sample.csd")
    found = compare_georeferencing(pulses, boresight)
    names = {
        "local": "local system",
        "utm": "UTM instead of a local system",
        "arinc": "roll before pitch",
    }
    rows = [
        {"georeferencing of 1,000 pulses": names[name], "RMS [m]": np.sqrt(np.mean(d**2)),
         "largest [m]": d.max()}
        for name, d in found.items()
    ]  # fmt: skip
    _study.print_table(rows, "Optech, against geocentric coordinates")
    fitted, residual = fit_mirror(pulses)
    row = {**fitted, "RMS": np.sqrt(np.mean(residual**2)), "largest": np.abs(residual).max()}
    _study.print_table([{**row, "noise": angle_noise(pulses)}], "Scan angle [deg]")
    shots = read_qfit(DATA / "sensor" / "atm_qfit.qi")
    windows = [(70, 75)] if options.quick else WINDOWS
    rows = [
        {"pattern": kind, "window [s]": f"{window[0]}-{window[1]}",
         **fit_pattern(shots, *window, kind)}
        for window in windows for kind in ("cone", "palmer")
    ]  # fmt: skip
    _study.print_table(rows, "ATM spots [m, deg]")
    angles = compare_wander(DATA / "trajectory" / "two_points.sbet")
    _study.print_table([angles], "SBET: motion less velocity [deg], wander angle")
    try:
        position, yaw = compare_projection(options.out)
        row = {"position [m]": position, "yaw [rad]": yaw}
        _study.print_table([row], "SBET in UTM less pyproj, largest of 2,000 records")
    except ImportError:
        print("\nno pyproj: SBET in UTM is not compared")
    noise = read_errors(DATA / "trajectory" / "smrmsg.txt")
    rows = check_errors(noise, SLOW_ERROR_TIME, 2000 if options.quick else 50000)
    _study.print_table(rows, "Slow errors of the RMS of smrmsg.txt [m, deg]")
    _study.print_table(fly_strips(), "Strips over a plane [m]")
    draw(pulses, residual, options.out)


if __name__ == "__main__":
    main()
