# SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
# SPDX-License-Identifier: BSD-3-Clause
"""Scan patterns of the catalogue, against those of the instruments: the table of Docs/validation.md.

    build/venv/bin/python Python/studies/patterns.py DATA [--quick]

DATA is a folder with the real patterns; those that are absent are left out. Livox patterns are
NumPy files of azimuth and elevation [rad], a row per pulse.
"""

import argparse
import pathlib

import numpy as np

import vtkhelios

PLANE = (
    [[-500, -500, -1], [500, -500, -1], [500, 500, -1], [-500, 500, -1]],
    [[0, 1, 2], [0, 2, 3]],
)
SHARP = dict(noise=False, pulses=True, beam_divergence=0)

# Instrument: file, first pulse in it, pulses per second.
LIVOX = {
    "livox_mid40": ("livox_mid40.npy", 1, 100_000),
    "livox_mid70": ("livox_mid70.npy", 1, 100_000),
    "livox_avia": ("livox_avia.npy", 0, 240_000),
}


def directions_of(scanner, pulses, rate, **settings):
    """The directions of the first pulses of a scanner of the catalogue, n x 3."""
    cloud = vtkhelios.scan(
        vtkhelios.Scene(*PLANE),
        (0, 0, 0),
        scanner=scanner,
        duration=(pulses + 0.5) / rate,
        **SHARP,
        **settings,
    )
    found = cloud.pulses["Direction"]
    assert len(found) >= pulses, "not every pulse leaves the scanner"
    return found[np.argsort(cloud.pulses["PulseIds"], kind="stable")][:pulses]


def to_directions(angles):
    """Unit vectors, n x 3, of azimuth (anticlockwise) and elevation [rad]; y forward, z up."""
    azimuth, elevation = np.asarray(angles, float).T
    return np.stack(
        [
            -np.sin(azimuth) * np.cos(elevation),
            np.cos(azimuth) * np.cos(elevation),
            np.sin(elevation),
        ],
        axis=1,
    )


def angles_between(a, b):
    """The angles between unit vectors [deg], exact for small ones."""
    return np.degrees(2 * np.arcsin(np.linalg.norm(a - b, axis=1) / 2))


def compare_livox(instrument, path, pulses=100_000):
    """A row of the table."""
    _, first, rate = LIVOX[instrument]
    real = to_directions(np.load(path)[:pulses])
    ours = directions_of(instrument, first + len(real), rate)[first:]
    return row(instrument, "directions", angles_between(ours, real), "mdeg", 1000)


def row(instrument, what, errors, unit, factor):
    errors = np.asarray(errors) * factor
    return {
        "instrument": instrument,
        "compared": what,
        "pulses": len(errors),
        "rms": float(np.sqrt(np.mean(errors**2))),
        "maximum": float(errors.max()),
        "unit": unit,
    }


def print_table(rows):
    print("| instrument | compared | pulses | RMS | maximum |")
    print("|---|---|---|---|---|")
    for one in rows:
        ends = [f"{one[name]:.2g} {one['unit']}" for name in ("rms", "maximum")]
        print(
            "|", " | ".join([one["instrument"], one["compared"], f"{one['pulses']:,}", *ends]), "|"
        )


def main():
    parser = argparse.ArgumentParser(
        description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter
    )
    parser.add_argument("data", metavar="DATA", type=pathlib.Path, help="folder of real patterns")
    parser.add_argument("--quick", action="store_true", help="10,000 pulses instead of 100,000")
    given = parser.parse_args()
    pulses = 10_000 if given.quick else 100_000
    rows = []
    for instrument, (name, *_) in LIVOX.items():
        for path in sorted(given.data.rglob(name)):
            rows.append(compare_livox(instrument, path, pulses))
    print_table(rows)


if __name__ == "__main__":
    main()
