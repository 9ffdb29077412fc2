#!/usr/bin/env bash
# SPDX-License-Identifier: BSD-3-Clause
# pye57 0.4.19 (libE57Format) with numpy 2.2.6, CPython 3.11, Linux, 64 bits.
#
# A buffer of numpy's int64, whose type character is "l", is taken for 32 bits with a stride of its
# own: of the integers 1, 2^33 + 5, 2^33 + 6, 2^33 + 7 the file gets 1, 0, 5, 2. No error, no
# warning; the same bytes with the character "q", which is as long, are right. Any
# array of Python integers, arange() or astype(int) is of the character "l".
#
# Seen: l [1, 0, 5, 2]
#       q [1, 8589934597, 8589934598, 8589934599]
# Exits with 1 if that is no longer so.
set -euo pipefail
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
python3 -m venv "$folder/venv"
"$folder/venv/bin/pip" install --quiet pye57==0.4.19 numpy==2.2.6
cd "$folder"
"$folder/venv/bin/python" - <<'PYTHON'
import sys

import numpy as np
from pye57 import libe57

VALUES = [1, 2**33 + 5, 2**33 + 6, 2**33 + 7]


def buffers(image, values):
    vector = libe57.VectorSourceDestBuffer()
    vector.append(libe57.SourceDestBuffer(image, "v", values, len(values), True, True))
    return vector


def write_and_read(character):
    """Writes the values from an array of a type; reads them into one of the character q."""
    image = libe57.ImageFile("a.e57", "w")
    image.extensionsAdd("", libe57.E57_V1_0_URI)
    prototype = libe57.StructureNode(image)
    prototype.set("v", libe57.IntegerNode(image, 0, 0, 2**40))
    points = libe57.CompressedVectorNode(image, prototype, libe57.VectorNode(image, True))
    image.root().set("points", points)
    vector = buffers(image, np.array(VALUES, dtype=character))
    writer = points.writer(vector)
    writer.write(vector, len(VALUES))
    writer.close()
    image.close()
    image = libe57.ImageFile("a.e57", "r")
    found = np.zeros(len(VALUES), "q")
    reader = image.root()["points"].reader(buffers(image, found))
    assert reader.read() == len(VALUES)
    reader.close()
    image.close()
    return found.tolist()


assert np.dtype("l").itemsize == np.dtype("q").itemsize == 8
assert np.arange(3).dtype.char == "l"
short, long = write_and_read("l"), write_and_read("q")
print("l", short)
print("q", long)
if long != VALUES or short != [1, 0, 5, 2]:
    sys.exit("int64 is no longer taken for 32 bits")
PYTHON
