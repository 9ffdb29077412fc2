# SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
# SPDX-License-Identifier: BSD-3-Clause
"""Range noise against range and incidence: detector noise on echoes of planes, and laws.

    build/venv/bin/python Python/studies/range_noise.py OUT [--quick]

A beam meets a plane at several ranges and incidences, again and again; the waveform of each pulse has
white noise, and an echo detector finds its range. The spread of the ranges is compared with the bound
of Cramer and Rao for the arrival time of a Gaussian in white noise (Kay 1993, Fundamentals of
Statistical Signal Processing: Estimation Theory, example 3.13), whose amplitude and width are those of
the echo, broadened by the footprint, and with R^2 / cos(incidence), the signal of a plane in a narrow
beam (Soudarissanane et al. 2009, IAPRS 38 3/W8). Prints and writes (CSV) the table of
Docs/validation/range_noise.md, and its figure.
"""

import math

import numpy as np

import _pages
import _study
import vtkhelios

LIGHT = 0.299792458  # m/ns
PULSE_LENGTH = 4.0  # FWHM [ns]
BIN = 1.0  # [ns]
DIVERGENCE = 1e-3  # full angle at 1/e^2 [rad]
FWHM = math.sqrt(8 * math.log(2))
REFERENCE = 50.0  # range [m], at normal incidence, of SIGNAL_TO_NOISE
SIGNAL_TO_NOISE = 200.0  # amplitude over the noise of a bin
THRESHOLD = 4.0  # times the noise of a bin
SHOTS = 2000
RANGES = (25.0, 50.0, 100.0)
INCIDENCES = (0, 30, 60, 75, 85)
DETECTORS = ("Gaussian", "Peak")


def make_scanner(distance, incidence, detector=None):
    """A scanner whose beam, along y, meets a plane."""
    tilt = math.radians(incidence)
    size = 1e3
    # the plane contains x and (0, sin, cos) of its tilt, so that its normal is tilted by the incidence
    along = size * np.array([0.0, math.sin(tilt), math.cos(tilt)])
    across = size * np.array([1.0, 0.0, 0.0])
    centre = np.array([0.0, distance, 0.0])
    corners = [centre + i * across + j * along for i, j in ((-1, -1), (1, -1), (1, 1), (-1, 1))]
    scene = vtkhelios.Scene(np.array(corners), [[0, 1, 2], [0, 2, 3]])
    mirror = vtkhelios.vtkHeliosRotatingMirror()
    mirror.SetScanFrequency(0)  # stands still
    scanner = vtkhelios.vtkHeliosScanner()
    scanner.SetBeamDeflector(mirror)
    scanner.GetBeamSampler().SetBeamDivergence(DIVERGENCE)
    scanner.SetPulseLength(PULSE_LENGTH)
    scanner.SetBinSize(BIN)
    scanner.SetReturnSelection(scanner.STRONGEST)
    if detector:
        scanner.SetEchoDetector(detector)
    scanner.SetInputDataObject(0, scene.polydata)
    platform = vtkhelios.Cloud.from_arrays(
        np.zeros((1, 3)), GpsTime=np.zeros(1), Orientation=np.array([[1.0, 0, 0, 0]])
    )
    scanner.SetInputDataObject(1, platform.polydata)
    return scanner


def make_detector(name):
    if name == "Gaussian":
        return vtkhelios.vtkHeliosGaussianDecomposition(minimum_separation=3 * PULSE_LENGTH)
    return vtkhelios.vtkHeliosPeakDetector()


def shoot(scanner, pulses):
    """The echoes of the first pulses: Range and Amplitude."""
    scanner.SetDuration((pulses - 0.5) / scanner.GetBeamDeflector().GetPulseFrequency())
    return vtkhelios.arrays(vtkhelios.update(scanner))


def reference_noise():
    """The noise of a bin [W]."""
    return float(shoot(make_scanner(REFERENCE, 0), 1)["Amplitude"][0]) / SIGNAL_TO_NOISE


def echo_deviation(distance, incidence):
    """The standard deviation of an echo [ns]: of the pulse, and of the ranges in the footprint."""
    footprint = DIVERGENCE / 2 * distance / 2 * math.tan(math.radians(incidence))
    return math.hypot(PULSE_LENGTH / FWHM, 2 * footprint / LIGHT)


def range_bound(deviation, signal_to_noise):
    """Cramer and Rao: the smallest spread of an unbiased range [m]."""
    return LIGHT / 2 * math.sqrt(2 * deviation * BIN / math.sqrt(math.pi)) / signal_to_noise


def compare(noise, distance, incidence, shots=SHOTS):
    """A row of the table; spreads [m]."""
    clean = shoot(make_scanner(distance, incidence), 1)
    signal = float(clean["Amplitude"][0]) / noise
    cosine = math.cos(math.radians(incidence))
    row = {
        "range": distance,
        "incidence": incidence,
        "signal to noise": signal,
        "signal law": SIGNAL_TO_NOISE * (REFERENCE / distance) ** 2 * cosine,
        "bound": range_bound(echo_deviation(distance, incidence), signal),
    }
    for name in DETECTORS:
        scanner = make_scanner(distance, incidence, make_detector(name))
        scanner.SetDetectorNoise(noise)
        scanner.GetEchoDetector().SetDetectionThreshold(THRESHOLD * noise)
        ranges = shoot(scanner, shots)["Range"]
        is_lost = len(ranges) < shots // 2  # most echoes are below the threshold
        row[name] = math.nan if is_lost else float(np.std(ranges))
    return row


def compare_all(shots=SHOTS):
    noise = reference_noise()
    return [compare(noise, r, angle, shots) for r in RANGES for angle in INCIDENCES]


def make_tables(_data, _tools):
    rows = []
    for row in compare_all():
        cells = [f"{row['range']:.0f} m", f"{row['incidence']} deg"]
        cells += [f"{row['signal to noise']:.1f}", f"{row['signal law']:.1f}"]
        cells += [f"{1e3 * row['bound']:.2f}"]
        cells += [spread_of(row[name]) for name in DETECTORS]
        rows.append(cells)
    titles = ["range", "incidence", "signal to noise", "by cos / R²", "bound [mm]"]
    titles += ["`gaussian` [mm]", "`peak` [mm]"]
    yield _pages.Table("range_noise.md", "range noise", titles, rows, keys=2)


def spread_of(spread):
    """A cell of the page [mm]."""
    return "lost" if math.isnan(spread) else f"{1e3 * spread:.2f}"


def draw_figures(_data, folder):
    noise = reference_noise()
    angles = np.arange(0, 85, 3)
    figure, axes = _study.make_figure(1, 1, (5.6, 4.0))
    for distance in RANGES:
        rows = [compare(noise, distance, int(angle), 400) for angle in angles]
        bound = [1e3 * row["bound"] for row in rows]
        found = [1e3 * row["Gaussian"] for row in rows]
        line = axes[0].plot(angles, bound, lw=1, label=f"bound, {distance:.0f} m")[0]
        axes[0].plot(
            angles, found, ".", color=line.get_color(), label=f"simulated, {distance:.0f} m"
        )
    axes[0].set(xlabel="incidence [deg]", ylabel="spread of ranges [mm]", yscale="log")
    axes[0].legend()
    _study.save_figure(figure, folder / "range_noise.png")


def main():
    options = _study.arguments(__doc__)
    rows = compare_all(200 if options.quick else SHOTS)
    _study.print_table(rows, "Range noise [m]")
    _study.write_csv(options.out / "range_noise.csv", rows)
    draw_figures(None, options.out)


if __name__ == "__main__":
    main()
