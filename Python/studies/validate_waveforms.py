# SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
# SPDX-License-Identifier: BSD-3-Clause
"""Waveforms and flags of real instruments against what vtkHelios reads and detects.

    build/venv/bin/python Python/studies/validate_waveforms.py OUT [--quick] [--data DIR]

DIR has the files of Docs/validation, in waveform/ and als/ (default: the folder of _study.real_data()).
Prints and writes (CSV) what the tables of waveforms.md and flags.md there are made of by validation.py.
"""

import pathlib
import struct
import sys
import tempfile

import numpy as np

import vtkhelios
from vtkhelios import cli, formats

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parent))
import _pages  # noqa: E402
import _study  # noqa: E402

LIGHT = 0.299792458  # [m/ns]
RIEGL = "waveform/100429_152240_2535pt_UTM.las"
FLIGHTS = ("bcts_1", "autzen_trim", "ahn3_delft_1")
PULSE_LENGTH = 4.2  # [ns], median of the maker's widths of single echoes on open ground
THRESHOLD = 8.0  # digitizer units, 3 to 5 above the zero of 3
# Relative thresholds, and the times in which they apply [ns]; 0: to whole waveforms.
SHARES = ((0.0, 0.0), (0.06, 0.0), (0.1, 0.0), (0.2, 0.0), (0.1, 30.0))
FULL_LINES = 2e-3  # [s]: longer pauses between pulses are clipped points

# Waveforms ---------------------------------------------------------------------------------------


def read_maker(path):
    """The maker's echoes: packet, return number, two-way time after the first sample [ns], width [ns],
    metres per nanosecond; by the LAS 1.4 specification, not by vtkHelios."""
    data = pathlib.Path(path).read_bytes()
    begin, length = struct.unpack_from("<I", data, 96)[0], struct.unpack_from("<H", data, 105)[0]
    form = np.dtype({
        "names": ["return", "packet", "location", "vector"],
        "formats": ["u1", "<u8", "<f4", ("<f4", 3)],
        "offsets": [14, 31, 43, 47],
        "itemsize": length,
    })  # fmt: skip
    raw = np.frombuffer(data, form, offset=begin)
    with formats.open_reader(path) as reader:
        widths = np.concatenate([chunk["EchoWidth"] for chunk in reader.chunks()])
    return {
        "packet": raw["packet"],
        "return": raw["return"] & 15,
        "time": 1e-3 * raw["location"],
        "width": widths,
        "speed": 1e3 * np.linalg.norm(raw["vector"], axis=1),
    }


def detect(path, *options):
    """The echoes of vtkhelios detect: pulse, two-way time after the first sample [ns], width [ns]."""
    with tempfile.TemporaryDirectory() as folder:
        output = f"{folder}/found.pvtp"
        words = ["detect", path, "-o", output, "--detector", "gaussian", "--fit-background"]
        words += ["--pulse-length", PULSE_LENGTH, "--threshold", 1e9 * THRESHOLD, "--quiet"]
        if cli.main([*map(str, words), *map(str, options)]) != 0:
            raise SystemExit(f"{path}: no echoes")
        with formats.open_reader(output) as reader:
            chunks = list(reader.chunks())
    names = ("PulseIds", "Range", "EchoWidth")
    return tuple(np.concatenate([chunk[name] for chunk in chunks]) for name in names)


def read_starts(path):
    """The packets by the row of their first point, and the start time of each [ns]."""
    reader = vtkhelios.vtkHeliosLASReader()
    reader.SetFileName(str(path))
    reader.ReadWaveformsOn()
    table = vtkhelios.arrays(vtkhelios.update(reader, 1))
    return dict(zip(table["PulseIds"].tolist(), table["StartTime"].tolist()))


def match_echoes(path, relative_threshold, ringing_time):
    """Returns, for each packet, the maker's echoes (rows), the detected ones nearest to them, all
    detected."""
    maker, starts = read_maker(path), read_starts(path)
    pulses, ranges, widths = detect(
        path, "--relative-threshold", relative_threshold, "--ringing-time", ringing_time
    )
    by_packet = {}
    for row in np.lexsort((maker["return"], maker["packet"])):
        by_packet.setdefault(int(maker["packet"][row]), []).append(row)
    found = {}
    for pulse, distance, width in zip(pulses.tolist(), ranges, widths):
        found.setdefault(pulse, []).append((2.0 * distance / LIGHT - starts[pulse], width))
    for rows in by_packet.values():
        echoes = np.array(found.get(int(min(rows)), [])).reshape(-1, 2)
        if len(echoes):
            away = np.abs(echoes[:, 0] - maker["time"][rows][:, None])
            yield rows, echoes[np.argmin(away, axis=1)], len(echoes)
        else:
            yield rows, None, 0


def compare_echoes(path, relative_threshold, ringing_time=0.0):
    """A row of the table of echoes: vtkhelios detect against the maker's own."""
    maker = read_maker(path)
    separations, widths, same, count, pairs, wrong = [], [], 0, 0, 0, 0
    for rows, echoes, number in match_echoes(path, relative_threshold, ringing_time):
        count += 1
        same += number == len(rows)
        pairs += len(rows) == 2
        if echoes is None:
            continue
        if len(rows) == 1:
            widths.append(echoes[0, 1] / maker["width"][rows[0]] - 1.0)
        elif len(rows) == 2 and echoes[0, 0] != echoes[1, 0]:
            wrong += echoes[1, 0] < echoes[0, 0]
            step = np.diff(echoes[:, 0])[0] - np.diff(maker["time"][rows])[0]
            separations.append(step * maker["speed"][rows[0]])
    separations, widths = 1e3 * np.array(separations), 100.0 * np.array(widths)
    return {
        "relative threshold": relative_threshold,
        "ringing time [ns]": ringing_time,
        "packets": count,
        "packets with the maker's number of echoes": int(same),
        "pairs": pairs,
        "pairs found": len(separations),
        "later echo nearer": int(wrong),
        "separation: median difference [mm]": np.median(separations),
        "separation: median absolute deviation [mm]": _mad(separations),
        "width: median difference [%]": np.median(widths),
        "width: median absolute deviation [%]": _mad(widths),
    }


def _mad(values):
    return np.median(np.abs(values - np.median(values)))


def compare_pulsewaves(path):
    """A row of the table of formats: the .pls beside a .las, packet by packet."""
    found = formats.read_pulsewaves(pathlib.Path(path).with_suffix(".pls"))
    segments = vtkhelios.arrays(found.returning)
    reader = vtkhelios.vtkHeliosLASReader()
    reader.SetFileName(str(path))
    reader.ReadWaveformsOn()
    packets = vtkhelios.arrays(vtkhelios.update(reader, 1))
    places = [
        one["Origin"] + 0.5 * LIGHT * one["StartTime"][:, None] * one["Direction"]
        for one in (packets, segments)
    ]
    away, same = [], 0
    for row, (first, count) in enumerate(zip(packets["Offset"], packets["Count"])):
        near = np.flatnonzero(np.abs(segments["GpsTime"] - packets["GpsTime"][row]) < 1e-6)
        distances = np.linalg.norm(places[1][near] - places[0][row], axis=1)
        best = near[np.argmin(distances)]
        begin = segments["Offset"][best]
        samples = segments["Samples"][begin : begin + segments["Count"][best]]
        same += np.array_equal(samples[:count], packets["Samples"][first : first + count])
        away.append(1e3 * distances.min())
    return {
        "packets (.las, .wdp)": len(away),
        "segments (.pls, .wvs)": len(segments["PulseIds"]),
        "outgoing pulses": found.outgoing.GetNumberOfRows(),
        "packets with the same samples": int(same),
        "first sample: median distance [mm]": np.median(away),
        "first sample: largest distance [mm]": np.max(away),
    }


# Flags -------------------------------------------------------------------------------------------


def read_flight(path):
    """The points of a LAS or LAZ file by time: one value per pulse of each array."""
    with formats.open_reader(path) as reader:
        chunks = list(reader.chunks())
    names = ("points", "GpsTime", "ScanAngle", "ScanDirectionFlag", "EdgeOfFlightLine", "LegIds")
    points = {name: np.concatenate([chunk[name] for chunk in chunks]) for name in names}
    order = np.lexsort((points["GpsTime"], points["LegIds"]))
    points = {name: values[order] for name, values in points.items()}
    starts = np.flatnonzero(
        (np.diff(points["GpsTime"], prepend=-1.0) != 0)
        | (np.diff(points["LegIds"], prepend=-9) != 0)
    )
    pulses = {name: values[starts] for name, values in points.items()}
    edges = np.add.reduceat(points["EdgeOfFlightLine"].astype(int), starts)
    returns = np.diff(np.append(starts, len(order)))
    pulses["some"], pulses["all"] = edges > 0, edges == returns
    return pulses


def count_flags(name, path):
    """A row of the table of flags."""
    p = read_flight(path)
    angle, time, up = np.diff(p["ScanAngle"]), np.diff(p["GpsTime"]), p["ScanDirectionFlag"] == 1
    is_line = (time > 0) & (time < FULL_LINES) & (np.diff(p["LegIds"]) == 0)
    turns = np.flatnonzero(is_line & (np.diff(p["ScanDirectionFlag"].astype(int)) != 0))
    rising, falling = is_line & (angle > 0), is_line & (angle < 0)
    return {
        "file": name,
        "pulses": len(p["GpsTime"]),
        "angle rises: flag 1 [%]": _share(up[1:][rising]),
        "angle falls: flag 0 [%]": _share(~up[1:][falling]),
        "direction changes": len(turns),
        "pulses with an edge": int(p["some"].sum()),
        "all their returns have it [%]": _share(p["all"][p["some"]]),
        "edge: last before a change": int(p["some"][turns].sum()),
        "edge: first after a change": int(p["some"][turns + 1].sum()),
    }


def _share(values):
    return 100.0 * np.mean(values) if len(values) else float("nan")


# Pages -------------------------------------------------------------------------------------------


def make_tables(data, _tools):
    """The tables of waveforms.md and flags.md."""
    yield _formats_table(compare_pulsewaves(data / RIEGL))
    yield _echoes_table([compare_echoes(data / RIEGL, *share) for share in SHARES])
    yield _flags_table([count_flags(name, data / f"als/{name}.laz") for name in FLIGHTS])


def _formats_table(row):
    near, far = (row[f"first sample: {which} distance [mm]"] for which in ("median", "largest"))
    segments = "segments (`.pls`, `.wvs`); the others are of a second, less sensitive receiver, or have no point"
    rows = [
        ["packets (`.las`, `.wdp`)", f"{row['packets (.las, .wdp)']:,}"],
        [segments, f"{row['segments (.pls, .wvs)']:,}"],
        ["outgoing pulses, 24 samples each", f"{row['outgoing pulses']:,}"],
        ["packets with the same samples", f"{row['packets with the same samples']:,}"],
        ["distance of the first samples: median, largest", f"{near:.1f} mm, {far:.1f} mm"],
    ]
    return _pages.Table("waveforms.md", "formats", ["", ""], rows)


def _echoes_table(found):
    rows = []
    for row in found:
        number, share, middle, deviation = (
            row[name] for name in (
                "packets with the maker's number of echoes", "width: median difference [%]",
                "separation: median difference [mm]", "separation: median absolute deviation [mm]",
            )
        )  # fmt: skip
        spread = row["width: median absolute deviation [%]"]
        rows.append(
            [
                f"{row['relative threshold']:g}",
                f"{row['ringing time [ns]']:g}" if row["ringing time [ns]"] else "",
                f"{number:,}",
                f"{row['pairs found']}",
                f"{middle:.1f}, {deviation:.1f}",
                f"{share:+.1f}, {spread:.1f}",
            ]
        )
    titles = [
        "F",
        "T [ns]",
        "packets with the maker's number of echoes",
        f"pairs found, of {found[0]['pairs']}",
        "separation of pairs: median, deviation [mm]",
        "width of single echoes: median, deviation [%]",
    ]
    return _pages.Table("waveforms.md", "echoes", titles, rows)


def _flags_table(found):
    titles = [
        "",
        "pulses with returns",
        "flag 1 where the scan angle rises",
        "flag 0 where it falls",
        "pulses with an edge flag",
        "the flag is on all returns of its pulse",
        "edge on the last pulse before a change of direction",
        "edge on the first pulse after a change",
    ]
    columns = [_flags_column(row) for row in found]
    columns.append(["vtkHelios", "", "100 %", "100 %", "one per line", "100 %", "all", "none"])
    return _pages.Table("flags.md", "flags", *_pages.transpose(titles, columns))


def _flags_column(row):
    edges, changes = row["pulses with an edge"], row["direction changes"]

    def share(name, never=""):
        return never if np.isnan(row[name]) else f"{row[name]:.4g} %"

    def at_change(name):
        return "no changes" if not changes else str(row[name]) if edges else ""

    return [
        row["file"],
        f"{row['pulses']:,}",
        share("angle rises: flag 1 [%]", "it never rises"),
        share("angle falls: flag 0 [%]", "it never falls"),
        f"{edges:,}",
        share("all their returns have it [%]"),
        at_change("edge: last before a change"),
        at_change("edge: first after a change"),
    ]


def main():
    data = _study.real_data()
    if "--data" in sys.argv:
        at = sys.argv.index("--data")
        data = pathlib.Path(sys.argv[at + 1])
        del sys.argv[at : at + 2]
    arguments = _study.arguments(__doc__)
    tables = {
        "formats": [compare_pulsewaves(data / RIEGL)],
        "echoes": [compare_echoes(data / RIEGL, *share) for share in SHARES],
        "flags": [count_flags(name, data / f"als/{name}.laz") for name in FLIGHTS],
    }
    for name, rows in tables.items():
        for row in rows:
            _study.print_table([{"": key, "value": value} for key, value in row.items()], name)
        _study.write_csv(arguments.out / f"{name}.csv", rows)


if __name__ == "__main__":
    main()
