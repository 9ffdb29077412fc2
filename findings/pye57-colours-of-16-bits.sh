#!/usr/bin/env bash
# SPDX-License-Identifier: BSD-3-Clause
# pye57 0.4.19: read_scan(colors=True) cannot read colours of 16 bits, which E57 allows (an integer node
# from 0 to 65535 with colorLimits): its buffers have 8 bits, and it raises ErrorValueNotRepresentable.
# The same file is read through libe57 with buffers of double. Exits with an error if that changes.
#
# Output seen:
#   pye57 0.4.19
#   read_scan: a value could not be represented in the requested type (ErrorValueNotRepresentable)
#   libe57: [65535. 1000.]
set -euo pipefail
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
python3 -m venv "$folder/venv"
"$folder/venv/bin/pip" install --quiet "numpy==2.2.6" "pyquaternion==0.9.9" "pye57==0.4.19"
cd "$folder"
venv/bin/python - <<'PYTHON'
import importlib.metadata
import sys

import numpy as np
import pye57
from pye57 import libe57

print("pye57", importlib.metadata.version("pye57"))
names = ["cartesianX", "cartesianY", "cartesianZ", "colorRed", "colorGreen", "colorBlue"]
with pye57.E57("a.e57", "w") as file:
    image = file.image_file
    prototype, buffers, held = libe57.StructureNode(image), libe57.VectorSourceDestBuffer(), []
    for name in names:
        is_colour = name.startswith("color")
        node = libe57.IntegerNode(image, 0, 0, 65535) if is_colour else libe57.FloatNode(image)
        prototype.set(name, node)
        held.append(np.array([65535.0, 1000.0] if is_colour else [0.0, 1.0]))
        buffers.append(libe57.SourceDestBuffer(image, name, held[-1], 2, True, True))
    scan = libe57.StructureNode(image)
    scan.set("guid", libe57.StringNode(image, "{1}"))
    points = libe57.CompressedVectorNode(image, prototype, libe57.VectorNode(image, True))
    scan.set("points", points)
    file.data3d.append(scan)
    writer = points.writer(buffers)
    writer.write(2)
    writer.close()

with pye57.E57("a.e57") as file:
    try:
        file.read_scan(0, colors=True, ignore_missing_fields=True)
        sys.exit("read_scan: reads colours of 16 bits now")
    except libe57.E57Exception as error:
        print("read_scan:", str(error).strip().splitlines()[0])
    red, vector = np.empty(2), libe57.VectorSourceDestBuffer()
    vector.append(libe57.SourceDestBuffer(file.image_file, "colorRed", red, 2, True, True))
    file.get_header(0).points.reader(vector).read()
    print("libe57:", red)
    sys.exit(0 if red.tolist() == [65535.0, 1000.0] else "libe57: other values")
PYTHON
