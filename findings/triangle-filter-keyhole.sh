#!/usr/bin/env bash
# SPDX-License-Identifier: BSD-3-Clause
# vtkTriangleFilter of VTK 9.4.2 (PyPI) drops polygons with holes: a ring that goes along a side to a
# hole, round it and back ("keyhole", the way OBJ and vtkPolyData have holes) gets no triangles, and
# there is no warning. VTK 9.1.0 of Debian 12 does the same.
# Seen: "VTK 9.4.2: 0 triangles of 0 m2 for 12 m2". Exits with 1 if the area is right.
set -euo pipefail
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
python3 -m venv "$folder/venv"
"$folder/venv/bin/pip" -q install --no-deps vtk==9.4.2
"$folder/venv/bin/python" - <<'END'
import sys
from vtkmodules.vtkCommonCore import vtkPoints, vtkVersion
from vtkmodules.vtkCommonDataModel import vtkCellArray, vtkPolyData, vtkTriangle
from vtkmodules.vtkFiltersCore import vtkTriangleFilter

points, polys, mesh = vtkPoints(), vtkCellArray(), vtkPolyData()
for x, y in ((0, 0), (4, 0), (4, 4), (0, 4), (1, 1), (3, 1), (3, 3), (1, 3)):
    points.InsertNextPoint(x, y, 0)
ring = (0, 1, 2, 3, 0, 4, 7, 6, 5, 4)
polys.InsertNextCell(len(ring), ring)
mesh.SetPoints(points)
mesh.SetPolys(polys)
cutter = vtkTriangleFilter()
cutter.SetInputData(mesh)
cutter.Update()
made = cutter.GetOutput()
area = sum(
    vtkTriangle.TriangleArea(*(made.GetCell(i).GetPoints().GetPoint(k) for k in range(3)))
    for i in range(made.GetNumberOfCells())
)
print(f"VTK {vtkVersion.GetVTKVersion()}: {made.GetNumberOfCells()} triangles of {area:g} m2 for 12 m2")
sys.exit(abs(area - 12) < 1e-9)
END
