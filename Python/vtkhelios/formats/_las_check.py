# SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
# SPDX-License-Identifier: BSD-3-Clause
"""LAS headers and LAZ chunks, checked before laspy and lazrs read them.

Both trust the file: they allocate memory for any count, and a wrong one ends the process. Every
size is checked against the file here, and every count against the chunk table.
"""

import struct

import numpy as np

from ._base import memory_limit

HEADER_BYTES = 393  # header of LAS 1.5, the longest
TABLE_AT_END = -1  # the last 8 bytes of the file hold the chunk table offset
VARIABLE = 2**32 - 1  # the chunk size of variable chunks
POINTWISE, LAYERED = 1, 3  # compressors
POINTS_A_BYTE = 100  # largest ratio of compressed points
FEW = 1_000_000  # points allowed in any file

# Items of a compressed point, by type: bytes (None: any), layers of a chunk (None: one per byte).
ITEMS = {
    0: (None, 0), 6: (20, 0), 7: (8, 0), 8: (6, 0), 9: (29, 0),
    10: (30, 9), 11: (6, 1), 12: (8, 2), 13: (29, 1), 14: (None, None),
}  # fmt: skip


class Damage(Exception):
    """An error in a file."""


class Unsupported(Exception):
    """A valid file that cannot be read; the message has the remedy."""


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


def check_points(path, header, size):
    """Raises Damage if the compressed points of a file do not match its header; the header is laspy's."""
    import lazrs

    zipped = header.vlrs.get("LasZipVlr")
    if not zipped:
        raise Damage("the header record of LASzip is missing")
    layers = _check_items(zipped[0].record_data, header.point_format.size)
    vlr = lazrs.LazVlr(zipped[0].record_data)
    count, width = header.point_count, header.point_format.size
    if count == 0:
        return
    if not vlr.uses_variable_size_chunks():
        _check_memory(vlr.chunk_size(), width, size)
    if count > FEW + POINTS_A_BYTE * size:
        raise Damage(f"{size} bytes are too few for {count} points")
    with open(path, "rb") as file:
        begin = header.offset_to_point_data
        end, chunks = _find_table(file, begin, size)
        room = end - begin - 8
        if chunks > count or chunks * width > room:
            raise Damage(
                f"its chunk table counts {chunks} chunks in {room} bytes of {count} points"
            )
        file.seek(end)
        sizes = _read_table(lazrs, file, vlr, count)
        _check_chunks(sizes, count, width, room, size)
        if layers:
            _check_layers(file, begin + 8, sizes, width, layers)


def _check_items(data, width):
    """Returns the number of layers of a chunk, 0 without layers."""
    if len(data) < 34:
        raise Damage("its header record of LASzip is cut off")
    compressor, items = struct.unpack_from("<H", data)[0], struct.unpack_from("<H", data, 32)[0]
    if compressor == POINTWISE:
        raise Unsupported(
            "is compressed without chunks, by LASzip before version 2, which lazrs cannot read; "
            "decompress it to LAS with laszip, and give that"
        )
    if compressor not in (2, LAYERED) or len(data) < 34 + 6 * items:
        raise Damage(f"it has compressor {compressor} of {items} items, which cannot be read")
    total = layers = 0
    layered = compressor == LAYERED
    for kind, size, _ in struct.iter_unpack("<HHH", data[34 : 34 + 6 * items]):
        expected, own = ITEMS.get(kind, (-1, 0))
        if expected not in (None, size) or layered != (kind >= 10):
            raise Damage(f"it has an item of type {kind} with {size} bytes, which cannot be read")
        total += size
        layers += size if own is None else own
    if total != width:
        raise Damage(f"its items have {total} bytes, but its points {width}")
    return layers


def _find_table(file, begin, size):
    """Returns the offset of the chunk table, and its number of chunks."""
    file.seek(begin)
    place = _unpack(file, "<q")
    if place == TABLE_AT_END:
        file.seek(size - 8)
        place = _unpack(file, "<q")
    if not begin + 8 <= place <= size - 8:
        raise Damage(f"its chunk table should be at byte {place}, but it has {size} bytes")
    file.seek(place)
    version, chunks = struct.unpack("<II", file.read(8))
    if version != 0:
        raise Damage(f"its chunk table has the unknown version {version}")
    return place, chunks


def _unpack(file, form):
    data = file.read(struct.calcsize(form))
    if len(data) < struct.calcsize(form):
        raise Damage("it ends before its points")
    return struct.unpack(form, data)[0]


def _read_table(lazrs, file, vlr, count):
    """Returns the chunks: number of points, bytes."""
    table = [(int(n), int(length)) for n, length in lazrs.read_chunk_table_only(file, vlr)]
    if vlr.uses_variable_size_chunks():
        return table
    chunk = vlr.chunk_size()
    if chunk < 1 or len(table) != -(-count // chunk):
        raise Damage(f"{len(table)} chunks of {chunk} points are not {count} points")
    return [(min(chunk, count - i * chunk), length) for i, (_, length) in enumerate(table)]


def _check_chunks(sizes, count, width, room, size):
    if sum(points for points, _ in sizes) != count:
        raise Damage(f"its chunks have {sum(p for p, _ in sizes)} points, but its header {count}")
    if sum(length for _, length in sizes) > room:
        raise Damage(f"its chunks have {sum(b for _, b in sizes)} bytes, but there are {room}")
    if any(points < 1 or length < width for points, length in sizes):
        raise Damage("it has a chunk without points")
    _check_memory(max(points for points, _ in sizes), width, size)


def _check_memory(points, width, size):
    """lazrs allocates whole chunks, of the size in the header record."""
    if points * width > memory_limit(size):
        raise Damage(
            f"a chunk of {points} points needs {points * width / 1e6:.0f} MB, too much for a file "
            f"of {size} bytes"
        )


def _check_layers(file, begin, sizes, width, layers):
    """A chunk: its first point, the number of points, the bytes of each layer, and the layers."""
    head = struct.Struct(f"<{1 + layers}I")
    for points, length in sizes:
        file.seek(begin + width)
        data = file.read(head.size)
        if len(data) < head.size or width + head.size > length:
            raise Damage("it has a chunk that is cut off")
        found, *parts = head.unpack(data)
        if found != points or width + head.size + sum(parts) > length:
            raise Damage(
                f"a chunk of {points} points in {length} bytes states that it has {found} points "
                f"in {width + head.size + sum(parts)} bytes"
            )
        begin += length
