#!/bin/sh
# SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
# SPDX-License-Identifier: BSD-3-Clause
# rename_modules.sh SOURCE: the Python modules of that VTK import each other as vtkhelios.vtkmodules.
#
# Wrapped modules load those that they depend on by their full names. With the name vtkmodules, two
# VTKs in one process would load each other's modules.

set -eu
cd "$1"
sed -i 's/PYTHON_PACKAGE  "vtkmodules"/PYTHON_PACKAGE  "vtkhelios.vtkmodules"/' CMakeLists.txt
sed -i 's/"vtkmodules\.vtkCommonCore\./"vtkhelios.vtkmodules.vtkCommonCore./' Wrapping/PythonCore/PyVTK*.cxx
grep -q 'PYTHON_PACKAGE  "vtkhelios.vtkmodules"' CMakeLists.txt

# Modules that are linked to, and that Python does not use.
for module in Common/ComputationalGeometry Filters/General Filters/Geometry; do
  grep -q '^EXCLUDE_WRAP$' "$module/vtk.module" || echo EXCLUDE_WRAP >>"$module/vtk.module"
done
