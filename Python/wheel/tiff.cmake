# SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
# SPDX-License-Identifier: BSD-3-Clause
# Settings of the libtiff in the wheel, which reads textures: without JBIG, whose library is GPL, and
# without compressions that textures do not have.

set(CMAKE_BUILD_TYPE Release CACHE STRING "")
set(CMAKE_C_FLAGS_RELEASE "-O2 -DNDEBUG" CACHE STRING "")
set(CMAKE_INSTALL_LIBDIR lib CACHE STRING "")
set(CMAKE_C_COMPILER_LAUNCHER ccache CACHE STRING "")
set(BUILD_SHARED_LIBS ON CACHE BOOL "")
set(cxx OFF CACHE BOOL "")
foreach(name tools tests contrib docs jbig lerc libdeflate lzma webp zstd)
  set(tiff-${name} OFF CACHE BOOL "")
  set(${name} OFF CACHE BOOL "")
endforeach()
