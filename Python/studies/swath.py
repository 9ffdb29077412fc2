# SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
# SPDX-License-Identifier: BSD-3-Clause
"""Pulses across the swath of an airborne oscillating mirror, and its lines, real and simulated.

    build/venv/bin/python Python/studies/swath.py OUT [--quick]

Reads two tiles of a forest (bcts, see Docs/validation) from the folder als/ of the real data. Their
scan angles are whole degrees: the times at which these change in a line tell how long the mirror takes
for a degree, also where a tile cuts lines off. vtkHeliosOscillatingMirror is fitted to these
times and flown over a plane; the same code counts its pulses. Prints and writes (CSV) the tables of
Docs/validation/swath.md.
"""

import numpy as np

import _pages
import _study
import vtkhelios

from validate_waveforms import FULL_LINES, read_flight

TILES = ("bcts_1", "bcts_2")
HEIGHT = 670.0  # [m], above the ground
EDGE = 14.5  # [deg]: the last change of the scan angle before a turn
DEGREES = np.arange(1, 15)  # off nadir, either side
SAME_LINE = 5e-5  # [s]: longest time between pulses at a change of the scan angle
LINE = 0.02  # [s], longer than a line
AT = 11.5  # [deg]: where the spacing of lines is measured; all strips have lines there


def find_crossings(pulses):
    """Times [s] at which the scan angle passes half degrees, these angles [deg], and the pulses."""
    time, angle = pulses["GpsTime"], np.round(pulses["ScanAngle"])
    step = np.flatnonzero((np.diff(angle) != 0) & (np.diff(time) < SAME_LINE))
    return (time[step] + time[step + 1]) / 2, (angle[step] + angle[step + 1]) / 2, step


def median(values):
    """NaN without values."""
    return float(np.median(values)) if len(values) else np.nan


def times_per_degree(pulses):
    """Median time [s] in each of DEGREES off nadir, and beyond EDGE in a turn, which is two lines."""
    time, angle, _ = find_crossings(pulses)
    spent, near = np.diff(time), np.diff(time) < LINE
    mean, step = (angle[1:] + angle[:-1]) / 2, np.abs(np.diff(angle))
    found = [median(spent[near & (step == 1) & (np.abs(mean) == degree)]) for degree in DEGREES]
    turns = near & (step == 0) & (np.abs(mean) == EDGE) & (spent < LINE / 10)
    return np.array([*found, median(spent[turns])])


def pulses_in_turn(pulses):
    """Median number of pulses in the file beyond EDGE in a turn."""
    time, angle, step = find_crossings(pulses)
    turns = (
        (np.diff(time) < LINE / 10) & (np.abs(np.diff(angle)) == 0) & (np.abs(angle[1:]) == EDGE)
    )
    return median(np.diff(step)[turns])


def line_period(pulses):
    """Median time [s] from a turn to the next one at that side."""
    time, angle = pulses["GpsTime"], pulses["ScanAngle"]
    turns = np.diff(pulses["ScanDirectionFlag"].astype(int)) != 0
    turns = np.flatnonzero(turns & (np.diff(time) < FULL_LINES) & (np.abs(angle[1:]) > EDGE))
    between = [np.diff(time[turns[side * angle[turns] > 0]]) for side in (-1, 1)]
    between = np.concatenate(between)
    return median(between[between < LINE])


def find_rate(pulses):
    """Pulses per second: the mean time between pulses that follow each other."""
    between = np.diff(pulses["GpsTime"])
    return float(1 / np.mean(between[between < 1.5e-5]))


def line_spacing(pulses, place):
    """Distances along the flight of consecutive lines of one direction [m], and the speed [m/s].

    place: the points of the pulses, n x 3; the flight is straight."""
    time, angle, step = find_crossings(pulses)
    rising = pulses["ScanDirectionFlag"][step] == 1
    side = 1 if np.sum(angle == AT) >= np.sum(angle == -AT) else -1
    chosen = rising & (angle == side * AT)
    time, where = time[chosen], place[step[chosen], :2]
    velocity = np.polyfit(time - time.mean(), where, 1)[0]
    speed = float(np.linalg.norm(velocity))
    along = where @ velocity / speed
    near = np.diff(time) < LINE
    return np.diff(along)[near], speed


def read_strips(data):
    """Reads the pulses of each strip of the tiles, like read_flight(), with their first points."""
    for name in TILES:
        flight = read_flight(data / f"als/{name}.laz")
        for leg in np.unique(flight["LegIds"]):
            chosen = flight["LegIds"] == leg
            yield {key: values[chosen] for key, values in flight.items()}


def make_mirror(rate, frequency, angle, turning):
    mirror = vtkhelios.vtkHeliosOscillatingMirror()
    mirror.SetPulseFrequency(rate)
    mirror.SetScanFrequency(frequency)
    mirror.SetScanAngle(angle)
    mirror.SetTurningPulses(int(round(turning)))
    return mirror


def mirror_times(rate, frequency, angle, turning):
    """The times of times_per_degree() of our mirror [s], between pulses."""
    fine = 100  # steps per pulse
    mirror = make_mirror(fine * rate, frequency, angle, fine * turning)
    steps = np.arange(0, int(fine * rate / frequency / 2), fine // 4)
    angles = np.array([mirror.GetScanAngle(int(step)) for step in steps])
    ends = np.interp(np.arange(0.5, 15), angles, steps / (fine * rate))
    return np.append(np.diff(ends), 2 * (steps[-1] / (fine * rate) - ends[-1]))


def fit_mirror(times, rate, frequency):
    """Scan angle [deg] and turning pulses of our mirror, by least squares of pulses per degree."""
    unknowns, steps = np.array([15.0, 200.0]), np.array([0.02, 4.0])

    def follow(values):
        return rate * (mirror_times(rate, frequency, *values) - times)

    for _ in range(8):
        jacobian = np.stack(
            [(follow(unknowns + e) - follow(unknowns - e)) / (2 * e.sum()) for e in np.diag(steps)],
            -1,
        )
        unknowns = unknowns - np.linalg.lstsq(jacobian, follow(unknowns), rcond=None)[0]
    return unknowns


def fly(rate, frequency, angle, turning, speed, duration=0.5):
    """Our mirror over a plane, as a file would have it: pulses and their points."""
    scanner = vtkhelios.vtkHeliosScanner()
    scanner.SetBeamDeflector(make_mirror(rate, frequency, angle, turning))
    scanner.GetBeamSampler().SetBeamDivergence(0)
    scanner.SetMountOrientation(np.sqrt(0.5), -np.sqrt(0.5), 0, 0)  # down
    scanner.GenerateScanFlagsOn()
    size = 1e4
    plane = vtkhelios.Scene(
        [[-size, -size, 0], [size, -size, 0], [size, size, 0], [-size, size, 0]],
        [[0, 1, 2], [0, 2, 3]],
    )
    scanner.SetInputDataObject(0, plane.polydata)
    # the mirror scans the plane of y and z of the mount: the aircraft flies along x
    flight = vtkhelios.Cloud.from_arrays(
        np.array([[0.0, 0, HEIGHT], [speed * duration, 0, HEIGHT]]),
        GpsTime=np.array([0.0, duration]),
        Orientation=np.array([[1.0, 0, 0, 0]] * 2),
    )
    scanner.SetInputDataObject(1, flight.polydata)
    return vtkhelios.arrays(vtkhelios.update(scanner))


def compare(data):
    """Numbers of the real strips, of the fit, and of its flight."""
    strips = list(read_strips(data))
    real = {
        "times": np.nanmedian([times_per_degree(strip) for strip in strips], axis=0),
        "rate": float(np.median([find_rate(strip) for strip in strips])),
        "turn": float(np.nanmedian([pulses_in_turn(strip) for strip in strips])),
    }
    real["frequency"] = 1 / float(np.nanmedian([line_period(strip) for strip in strips]))
    real["spacing"] = [line_spacing(strip, strip["points"]) for strip in strips]
    angle, turning = fit_mirror(real["times"], real["rate"], real["frequency"])
    speed = float(np.median([found[1] for found in real["spacing"]]))
    ours = fly(real["rate"], real["frequency"], angle, turning, speed)
    simulated = {
        "times": times_per_degree(ours),
        "frequency": 1 / line_period(ours),
        "rate": find_rate(ours),
        "turn": pulses_in_turn(ours),
        "spacing": [line_spacing(ours, ours["points"])],
    }
    return real, (angle, turning), simulated


def degree_rows(real, simulated):
    names = [f"{degree} deg" for degree in DEGREES] + [f"turn, beyond {EDGE} deg"]
    for name, one, other in zip(names, real["times"], simulated["times"]):
        pulses, ours = real["rate"] * one, simulated["rate"] * other
        yield row_of(name, pulses, ours)
    yield row_of("the same, pulses in the file", real["turn"], simulated["turn"])


def row_of(name, real, ours):
    return [
        name,
        f"{real:.1f}",
        f"{ours:.1f}",
        f"{100 * (ours / real - 1):+.0f} %".replace("-0", "+0"),
    ]


def line_rows(real, simulated):
    def spacing(found):
        return np.concatenate([one[0] for one in found["spacing"]])

    def row(name, pick, form):
        return [name, *(form.format(pick(found)) for found in (real, simulated))]

    yield row("pulse frequency", lambda found: found["rate"] / 1e3, "{:.1f} kHz")
    yield row("mirror frequency", lambda found: found["frequency"], "{:.2f} Hz")
    yield row("speed", lambda found: np.median([s for _, s in found["spacing"]]), "{:.1f} m/s")
    yield row("line spacing, median", lambda found: np.median(spacing(found)), "{:.3f} m")
    deviation = "line spacing, median absolute deviation"
    yield row(
        deviation, lambda f: np.median(np.abs(spacing(f) - np.median(spacing(f)))), "{:.3f} m"
    )


def make_tables(data, _tools):
    """The tables of swath.md."""
    real, fitted, simulated = compare(data)
    titles = ["off nadir", "real [pulses]", "simulated [pulses]", "difference"]
    yield _pages.Table("swath.md", "swath", titles, list(degree_rows(real, simulated)))
    rows = list(line_rows(real, simulated))
    rows.append(["scan angle", "", f"{fitted[0]:.2f} deg"])
    rows.append(["turning pulses", "", f"{fitted[1]:.0f}"])
    yield _pages.Table("swath.md", "lines", ["", "real", "simulated"], rows)


def main():
    options = _study.arguments(__doc__)
    for table in make_tables(_study.real_data(), None):
        rows = [dict(zip(table.titles, row)) for row in table.rows]
        _study.print_table(rows, table.name)
        _study.write_csv(options.out / f"{table.name}.csv", rows)


if __name__ == "__main__":
    main()
