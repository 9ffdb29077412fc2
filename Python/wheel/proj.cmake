# SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
# SPDX-License-Identifier: BSD-3-Clause
# Settings of the PROJ in the wheel: without network and GeoTIFF grids, with their 40 libraries. It
# finds its database beside its library, whatever PROJ_DATA names for another PROJ.

set(CMAKE_BUILD_TYPE Release CACHE STRING "")
set(CMAKE_C_FLAGS_RELEASE "-O2 -DNDEBUG" CACHE STRING "")
set(CMAKE_CXX_FLAGS_RELEASE "-O2 -DNDEBUG" CACHE STRING "")
set(CMAKE_INSTALL_LIBDIR lib CACHE STRING "")
set(CMAKE_C_COMPILER_LAUNCHER ccache CACHE STRING "")
set(CMAKE_CXX_COMPILER_LAUNCHER ccache CACHE STRING "")
set(BUILD_APPS OFF CACHE BOOL "")
set(BUILD_PROJSYNC OFF CACHE BOOL "")
set(BUILD_TESTING OFF CACHE BOOL "")
set(ENABLE_CURL OFF CACHE BOOL "")
set(ENABLE_TIFF OFF CACHE BOOL "")
set(PROJ_DATA_ENV_VAR_TRIED_LAST ON CACHE BOOL "")
