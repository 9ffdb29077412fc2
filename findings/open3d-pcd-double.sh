#!/usr/bin/env bash
# SPDX-License-Identifier: BSD-3-Clause
#
# Open3D 0.20.0, Python 3.11: open3d.io.read_point_cloud() reads x y z of 64 bits (TYPE F, SIZE 8) of
# a binary PCD file as 0, without an error or a warning. The same file with DATA ascii, and the
# binary one by open3d.t.io.read_point_cloud(), are read right.
#
# Output seen:
#   io,   ascii:  [[1. 2. 3.]]
#   io,   binary: [[0. 0. 0.]]
#   t.io, binary: [[1. 2. 3.]]
# Exits with 1 if that is no longer so.
set -euo pipefail
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
python3 -m venv "$folder/venv"
"$folder/venv/bin/pip" install --quiet open3d-cpu==0.20.0
cd "$folder"
venv/bin/python - <<'EOF'
import struct
import sys

import numpy as np
import open3d

head = "VERSION 0.7\nFIELDS x y z\nSIZE 8 8 8\nTYPE F F F\nCOUNT 1 1 1\nWIDTH 1\nHEIGHT 1\n"
head += "VIEWPOINT 0 0 0 1 0 0 0\nPOINTS 1\nDATA "
with open("ascii.pcd", "w") as file:
    file.write(head + "ascii\n1 2 3\n")
with open("binary.pcd", "wb") as file:
    file.write(head.encode() + b"binary\n" + struct.pack("<3d", 1, 2, 3))
text = np.asarray(open3d.io.read_point_cloud("ascii.pcd").points)
binary = np.asarray(open3d.io.read_point_cloud("binary.pcd").points)
tensor = open3d.t.io.read_point_cloud("binary.pcd").point.positions.numpy()
print("io,   ascii: ", text)
print("io,   binary:", binary)
print("t.io, binary:", tensor)
seen = text.tolist(), binary.tolist(), tensor.tolist()
sys.exit(0 if seen == ([[1, 2, 3]], [[0, 0, 0]], [[1, 2, 3]]) else 1)
EOF
