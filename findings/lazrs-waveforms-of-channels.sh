#!/usr/bin/env bash
# SPDX-License-Identifier: BSD-3-Clause
# lazrs 0.8.2 and laszip 0.3.0 under laspy 2.7.0, numpy 2.2.6, CPython 3.11.
#
# LAZ of point format 9 (10 likewise) with points of two scanner channels in turn: the file that
# lazrs writes has other waveform references than it was given, without an error: byte offset and
# location in the waveform of 997 of 1,000 points. All other fields are right, also with one channel; the file that laszip
# writes is right whichever of the two reads it, and both read the same wrong values from that of
# lazrs: it is its encoder. Instruments with several channels alternate them by design.
#
# Seen: lazrs  channels 1: 0 wrong; channels 2: 997 wrong
#       laszip channels 1: 0 wrong; channels 2: 0 wrong
# Exits with 1 if that is no longer so.
set -euo pipefail
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
python3 -m venv "$folder/venv"
"$folder/venv/bin/pip" install --quiet laspy==2.7.0 lazrs==0.8.2 laszip==0.3.0 numpy==2.2.6
cd "$folder"
"$folder/venv/bin/python" - <<'PYTHON'
import sys

import laspy
import numpy as np

COUNT = 1000
OTHERS = ("X", "Y", "gps_time", "scanner_channel", "wavepacket_index", "wavepacket_size", "x_t")
REFERENCES = ("wavepacket_offset", "return_point_wave_location")


def make(channels):
    """Points with waveform references, of channels in turn."""
    header = laspy.LasHeader(point_format=9, version="1.4")
    header.scales = [0.001] * 3
    las, i = laspy.LasData(header), np.arange(COUNT)
    las.x, las.y, las.z = i * 0.01, i * 0.02, i * 0.0
    las.gps_time, las.scanner_channel = i * 1e-5, i % channels
    las.return_number = las.number_of_returns = las.wavepacket_index = np.ones(COUNT, int)
    las.wavepacket_offset, las.wavepacket_size = 60 + 256 * i, np.full(COUNT, 256)
    las.return_point_wave_location, las.x_t = 10.0 * i, np.full(COUNT, 1e-4)
    return las


def count_wrong(backend, channels):
    """Points whose references differ after writing by a backend, the same for both readers."""
    las = make(channels)
    las.write("a.laz", laz_backend=backend)
    counts = set()
    for reader in (laspy.LazBackend.Lazrs, laspy.LazBackend.Laszip):
        found = laspy.read("a.laz", laz_backend=reader)
        assert all(np.array_equal(found[name], las[name]) for name in OTHERS)
        wrong = [np.asarray(found[name]) != np.asarray(las[name]) for name in REFERENCES]
        counts.add(int(np.logical_or(*wrong).sum()))
    assert len(counts) == 1
    return counts.pop()


wrong = {}
for name, backend in (("lazrs", laspy.LazBackend.Lazrs), ("laszip", laspy.LazBackend.Laszip)):
    wrong[name] = [count_wrong(backend, channels) for channels in (1, 2)]
    print(f"{name:6} channels 1: {wrong[name][0]} wrong; channels 2: {wrong[name][1]} wrong")
if wrong != {"lazrs": [0, 997], "laszip": [0, 0]}:
    sys.exit("lazrs encodes channels in turn otherwise")
PYTHON
