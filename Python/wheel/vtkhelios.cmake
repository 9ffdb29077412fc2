# SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
# SPDX-License-Identifier: BSD-3-Clause
# Settings of vtkHelios in the wheel: without its large optional libraries, and with the GDAL of
# PyPI's rasterio, if it is installed.

set(VTKHELIOS_BUILD_TESTING OFF CACHE BOOL "")
set(VTKHELIOS_BUILD_VIEWER OFF CACHE BOOL "") # needs X11 and OpenGL
set(VTKHELIOS_ENABLE_CBC OFF CACHE BOOL "")
set(VTKHELIOS_ENABLE_CGAL OFF CACHE BOOL "") # GPL
set(VTKHELIOS_ENABLE_EMBREE OFF CACHE BOOL "") # 44 MB
set(VTKHELIOS_ENABLE_MPI OFF CACHE BOOL "")
set(VTKHELIOS_ENABLE_PCL OFF CACHE BOOL "")
set(VTKHELIOS_LOAD_GDAL ON CACHE BOOL "")
set(VTKHELIOS_PRECOMPILE_HEADERS ON CACHE BOOL "")
set(VTKHELIOS_WRAP_VTK ON CACHE BOOL "")
