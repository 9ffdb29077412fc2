#!/usr/bin/env bash
# SPDX-License-Identifier: BSD-3-Clause
# laspy 2.7.0 with pyproj 3.7.2 and numpy 2.2.6, CPython 3.11.
#
# LAS 1.2 files name their coordinate system by GeoTIFF keys. Where a map is defined by parameters
# (ProjectedCSTypeGeoKey 32767, GTModelTypeGeoKey 1: projected), header.parse_crs() returns the
# geographic base, EPSG:4269 in degrees, for coordinates in metres, without a word; is_geographic is
# true.
# Vertical keys are left out: of EPSG:2263 with heights of NAVD88 in US survey feet (4096 and 4099)
# it returns EPSG:2263 alone, so that the unit of z is lost.
#
# Seen: by parameters: EPSG:4269, geographic True
#       with heights: EPSG:2263, compound False
# Exits with 1 if that is no longer so.
set -euo pipefail
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
python3 -m venv "$folder/venv"
"$folder/venv/bin/pip" install --quiet laspy==2.7.0 pyproj==3.7.2 numpy==2.2.6
cd "$folder"
"$folder/venv/bin/python" - <<'PYTHON'
import struct
import sys

import laspy
import numpy as np


def parse(keys, numbers=()):
    """What laspy says of a file with these keys: short values, or indices of numbers."""
    header = laspy.LasHeader(point_format=1, version="1.2")
    header.scales, header.offsets = [0.01] * 3, [600_000, 4_500_000, 0]
    entries = b"".join(struct.pack("<4H", *key) for key in keys)
    head = struct.pack("<4H", 1, 1, 0, len(keys))
    header.vlrs.append(laspy.VLR("LASF_Projection", 34735, "", head + entries))
    if numbers:
        data = struct.pack(f"<{len(numbers)}d", *numbers)
        header.vlrs.append(laspy.VLR("LASF_Projection", 34736, "", data))
    las = laspy.LasData(header)
    las.x, las.y, las.z = np.array([600_000.5]), np.array([4_500_000.5]), np.array([100.0])
    las.write("a.las")
    return laspy.read("a.las").header.parse_crs()


# A transverse Mercator map on NAD83 with the meridian 93.1 W: keys 3080, 3081, 3082, 3083, 3092.
made = parse(
    [
        (1024, 0, 1, 1), (1025, 0, 1, 1), (2048, 0, 1, 4269), (3072, 0, 1, 32767),
        (3074, 0, 1, 32767), (3075, 0, 1, 1), (3076, 0, 1, 9001),
        (3080, 34736, 1, 0), (3081, 34736, 1, 1), (3082, 34736, 1, 2), (3083, 34736, 1, 3),
        (3092, 34736, 1, 4),
    ],
    [-93.1, 40.0, 600_000.0, 4_500_000.0, 1.00004],
)
print("by parameters:", made.to_string(), "geographic", made.is_geographic)
if made.to_string() != "EPSG:4269" or not made.is_geographic:
    sys.exit("parameters are understood now")

high = parse(
    [(1024, 0, 1, 1), (1025, 0, 1, 1), (3072, 0, 1, 2263), (4096, 0, 1, 5703), (4099, 0, 1, 9003)]
)
print("with heights:", high.to_string(), "compound", high.is_compound)
if high.to_string() != "EPSG:2263" or high.is_compound:
    sys.exit("vertical keys are read now")
PYTHON
