# SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
# SPDX-License-Identifier: BSD-3-Clause
"""LAS headers, checked before laspy reads them: it trusts their counts."""

import struct

import numpy as np

HEADER_BYTES = 393  # header of LAS 1.5, the longest


class Damage(Exception):
    """An error in a file."""


def check_header(start, size):
    """Returns the error in the first bytes of a file of a size (HEADER_BYTES), or None."""
    if len(start) < 227 or start[:4] != b"LASF":
        return "it does not start with LASF"
    if start[24] != 1 or start[25] > 5:
        return f"its version is {start[24]}.{start[25]}; only 1.0 to 1.5 can be read"
    header_size, begin, records = struct.unpack_from("<HII", start, 94)
    least = {3: 235, 4: 375, 5: HEADER_BYTES}.get(start[25], 227)
    if header_size < least or len(start) < least or not header_size <= begin <= size:
        return f"its header has {header_size} bytes, and its points begin at byte {begin} of {size}"
    if records * 54 > begin - header_size:
        return f"it counts {records} header records, more than fit into it"
    return _find_wrong_scale(start)


def _find_wrong_scale(start):
    numbers = struct.unpack_from("<6d", start, 131)
    for scale, offset in zip(numbers[:3], numbers[3:]):
        if scale == 0 or not np.isfinite(2.0**31 * abs(scale) + abs(offset)):
            return (
                f"it has a scale of {scale:g} and an offset of {offset:g}, which give no valid "
                "coordinates"
            )
    return None
