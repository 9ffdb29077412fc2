# SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
# SPDX-License-Identifier: BSD-3-Clause
"""A raster of heights as GeoTIFF: GDAL's Python module is not required to make an example."""

import struct

import numpy as np

_SHORT, _LONG, _DOUBLE = (3, "H"), (4, "I"), (12, "d")
_ENTRY = struct.Struct("<HHI4s")
_HEADER = struct.Struct("<2sHI")


def write_geotiff(path, heights, west, north, pixel, epsg):
    """Writes heights (rows x columns, from north to south) [m] as float32.

    west, north
        the outer corner of the first pixel [m].
    pixel
        the size of a pixel [m].
    epsg
        the number of the projected coordinate system.
    """
    heights = np.ascontiguousarray(heights, dtype="<f4")
    rows, columns = heights.shape
    # Projected coordinates (1024), pixels are areas (1025), the system (3072): GeoTIFF 1.1, OGC 19-008.
    keys = (1, 1, 0, 3, 1024, 0, 1, 1, 1025, 0, 1, 1, 3072, 0, 1, epsg)
    start = _HEADER.size  # type of the pixels
    tags = [
        (256, _LONG, (columns,)),
        (257, _LONG, (rows,)),
        (258, _SHORT, (32,)),  # bits
        (259, _SHORT, (1,)),  # not compressed
        (262, _SHORT, (1,)),  # black is zero
        (273, _LONG, (start,)),
        (277, _SHORT, (1,)),  # samples per pixel
        (278, _LONG, (rows,)),  # rows per strip
        (279, _LONG, (heights.nbytes,)),
        (339, _SHORT, (3,)),  # floating point
        (33550, _DOUBLE, (pixel, pixel, 0.0)),
        (33922, _DOUBLE, (0.0, 0.0, 0.0, west, north, 0.0)),
        (34735, _SHORT, keys),
    ]
    directory = start + heights.nbytes
    with open(path, "wb") as file:
        file.write(_HEADER.pack(b"II", 42, directory))
        file.write(heights.tobytes())
        file.write(_pack_directory(tags, directory))


def _pack_directory(tags, begin):
    """Returns the directory at this byte of the file, with the values that do not fit into its
    entries."""
    after = begin + 2 + _ENTRY.size * len(tags) + 4
    entries, values = b"", b""
    for tag, (kind, letter), numbers in tags:
        packed = struct.pack(f"<{len(numbers)}{letter}", *numbers)
        if len(packed) > 4:
            place = struct.pack("<I", after + len(values))
            values += packed
        else:
            place = packed.ljust(4, b"\0")
        entries += _ENTRY.pack(tag, kind, len(numbers), place)
    return struct.pack("<H", len(tags)) + entries + struct.pack("<I", 0) + values
