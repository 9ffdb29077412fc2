# SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
# SPDX-License-Identifier: BSD-3-Clause
"""Scan patterns of the catalogue, against the instruments': the table of Docs/validation/patterns.md.

    build/venv/bin/python Python/studies/patterns.py [DATA] [--quick] [--ouster-python PYTHON]

DATA is a folder with the real patterns (default: that of _study.real_data()); those that are absent are
left out. Livox patterns are
NumPy files of azimuth and elevation [rad], a row per pulse. Of an Ouster, the metadata (JSON) give the
origins and directions of a revolution by the formulas of its manual. PYTHON is an interpreter with
ouster-sdk; with it, the lookup table of the manufacturer, and its points of a recorded revolution
(pcap), are compared as well.
"""

import argparse
import json
import pathlib
import subprocess
import tempfile

import numpy as np

import _pages
import _study
import vtkhelios
from vtkhelios.surveys import instruments

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


COMPARISONS = [  # instrument and what is compared, in the order of the page
    *((name, "directions") for name in LIVOX),
    ("ouster_os1_128", "directions by the manual"),
    ("ouster_os1_128", "origins by the manual"),
    ("ouster_os1_128", "directions by ouster-sdk"),
    ("ouster_os1_128", "origins by ouster-sdk"),
    ("ouster_os1_128", "points of a sweep"),
]

# Writes origins [m] and directions of the lookup table of ouster-sdk, and the ranges [m] and points of
# the first whole revolution of a pcap, in the frame of the sensor, by beam and column.
OUSTER = """
import sys
import numpy as np
from ouster.sdk import open_source
from ouster.sdk.core import SensorInfo, XYZLut

info = SensorInfo(open(sys.argv[1]).read())
lut = XYZLut(info)
shape = info.format.pixels_per_column, info.format.columns_per_frame
near, far = (lut(np.full(shape, r, np.uint32)).reshape(*shape, 3) for r in (10**6, 2 * 10**6))
directions = (far - near) / 1000
found = dict(directions=directions, origins=near - (1000 - float(sys.argv[4])) * directions)
if sys.argv[2]:
    for scan in open_source(sys.argv[2], meta=[sys.argv[1]]):
        scan = scan[0]  # of the only sensor
        ranges = scan.field("RANGE")
        found.update(ranges=ranges / 1000, points=lut(scan).reshape(*shape, 3))
        break
np.savez(sys.argv[3], **found)
"""


def pulses_of(scanner, pulses, rate, **settings):
    """The first pulses of a scanner, in order: a Cloud of origins."""
    cloud = vtkhelios.scan(
        vtkhelios.Scene(*PLANE),
        (0, 0, 0),
        scanner=scanner,
        duration=(pulses + 0.5) / rate,
        **SHARP,
        **settings,
    )
    assert len(cloud.pulses) >= pulses, "not every pulse leaves the scanner"
    order = np.argsort(cloud.pulses["PulseIds"], kind="stable")[:pulses]
    return {name: cloud.pulses[name][order] for name in cloud.pulses.names} | {
        "Origin": cloud.pulses.points[order]
    }


def directions_of(scanner, pulses, rate):
    """The directions of the first pulses of a scanner of the catalogue, n x 3."""
    return pulses_of(scanner, pulses, rate)["Direction"]


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


def ouster_revolution(metadata):
    """Origins [m] and directions of a revolution by the manual of Ouster, n columns x beams x 3.

    Hardware user manual, "Lidar range to XYZ", in the frame of the sensor: encoder angle 2 pi (1 - m /
    columns) of column m, minus the azimuth of the beam; turned and moved by lidar_to_sensor_transform.
    """
    facts = json.loads(pathlib.Path(metadata).read_text())
    columns = facts["data_format"]["columns_per_frame"]
    encoder = 2 * np.pi * (1 - np.arange(columns)[:, None] / columns)
    azimuth = encoder - np.radians(facts["beam_azimuth_angles"])
    altitude = np.radians(facts["beam_altitude_angles"]) + 0 * encoder
    directions = np.stack(
        [
            np.cos(azimuth) * np.cos(altitude),
            np.sin(azimuth) * np.cos(altitude),
            np.sin(altitude),
        ],
        axis=-1,
    )
    circle = np.stack([np.cos(encoder), np.sin(encoder), 0 * encoder], axis=-1)
    origins = facts["lidar_origin_to_beam_origin_mm"] / 1000 * circle + 0 * directions
    transform = np.reshape(facts["lidar_to_sensor_transform"], (4, 4))
    return origins @ transform[:3, :3].T + transform[:3, 3] / 1000, directions @ transform[:3, :3].T


def our_revolution(metadata, columns, beams):
    """Returns the revolution of the scanner made from the metadata: columns x beams x 3, in the
    sensor's frame."""
    with tempfile.TemporaryDirectory() as folder:
        path = pathlib.Path(folder) / "ouster.xml"
        path.write_text(instruments.read_ouster(metadata, "sensor"))
        rate = columns * beams * 10
        found = pulses_of(f"{path}#sensor", columns * beams, rate, scan_frequency=10, columns=True)
    order = np.lexsort((found["ChannelIds"], found["ColumnIds"]))
    origins = found["Origin"][order] - [0, 0, 1.5]  # position of the tripod
    back = [[0, -1, 0], [1, 0, 0], [0, 0, 1]]  # x of the sensor is y, its y is -x
    shape = (columns, beams, 3)
    return (origins @ back).reshape(shape), (found["Direction"][order] @ back).reshape(shape)


def compare_ouster(metadata, python=None, pcap=None):
    """Rows of the table: against the manual, and with an interpreter against ouster-sdk."""
    origins, directions = ouster_revolution(metadata)
    ours = our_revolution(metadata, *directions.shape[:2])
    rows = ouster_rows("by the manual", ours, (origins, directions))
    if python:
        offset = json.loads(pathlib.Path(metadata).read_text())["lidar_origin_to_beam_origin_mm"]
        with tempfile.TemporaryDirectory() as folder:
            out = pathlib.Path(folder) / "lut.npz"
            words = [python, "-c", OUSTER, metadata, pcap or "", out, offset / 1000]
            subprocess.run(list(map(str, words)), check=True)
            found = {name: np.moveaxis(one, 0, 1) for name, one in np.load(out).items()}
        rows += ouster_rows("by ouster-sdk", ours, (found["origins"], found["directions"]))
        if "points" in found:
            ranges = found["ranges"][..., None] - offset / 1000
            hit = found["ranges"] > 0
            errors = np.linalg.norm(ours[0] + ranges * ours[1] - found["points"], axis=-1)[hit]
            rows.append(row("ouster_os1_128", "points of a sweep", errors, "um", 1e6))
    return rows


def compare_all(data, ouster_python=None, pulses=100_000):
    """All rows of the table for which a folder has files."""
    rows = []
    for instrument, (name, *_) in LIVOX.items():
        for path in sorted(data.rglob(name)):
            rows.append(compare_livox(instrument, path, pulses))
    for path in sorted(data.rglob("ouster_os1_128.json")):
        pcap = path.with_suffix(".pcap")
        rows += compare_ouster(path, ouster_python, pcap if pcap.is_file() else None)
    return rows


def ouster_rows(how, ours, theirs):
    origins = np.linalg.norm(ours[0] - theirs[0], axis=-1).ravel()
    directions = angles_between(*(one[1].reshape(-1, 3) for one in (ours, theirs)))
    return [
        row("ouster_os1_128", f"directions {how}", directions, "mdeg", 1000),
        row("ouster_os1_128", f"origins {how}", origins, "um", 1e6),
    ]


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


def make_tables(data, tools):
    """The table of patterns.md; of an Ouster, as far as its interpreter is there."""
    found = {
        (one["instrument"], one["compared"]): one for one in compare_all(data, tools.ouster_python)
    }
    if not found:
        raise FileNotFoundError(2, "no pattern", str(data))
    rows = []
    for key in COMPARISONS:
        rows.append(cells_of(found[key]) if key in found else list(key))
    titles = ["instrument", "compared", "pulses", "RMS", "maximum"]
    yield _pages.Table("patterns.md", "patterns", titles, rows, keys=2)


def cells_of(one):
    """A row of the page; numbers below 0.001 of their unit are rounding."""
    ends = [one[name] for name in ("rms", "maximum")]
    words = [
        f"{end:.2g} {one['unit']}" if end >= 1e-3 else f"< 0.001 {one['unit']}" for end in ends
    ]
    return [one["instrument"], one["compared"], f"{one['pulses']:,}", *words]


def print_table(rows):
    print("| instrument | compared | pulses | RMS | maximum |")
    print("|---|---|---|---|---|")
    for one in rows:
        print("|", " | ".join(cells_of(one)), "|")


def main():
    parser = argparse.ArgumentParser(
        description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter
    )
    parser.add_argument(
        "data",
        metavar="DATA",
        nargs="?",
        type=pathlib.Path,
        default=_study.real_data(),
        help="folder of real patterns",
    )
    parser.add_argument("--quick", action="store_true", help="10,000 pulses instead of 100,000")
    parser.add_argument("--ouster-python", metavar="PYTHON", help="an interpreter with ouster-sdk")
    given = parser.parse_args()
    print_table(compare_all(given.data, given.ouster_python, 10_000 if given.quick else 100_000))


if __name__ == "__main__":
    main()
