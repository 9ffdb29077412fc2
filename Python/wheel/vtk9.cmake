# SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
# SPDX-License-Identifier: BSD-3-Clause
# Settings of the VTK in the wheel: what vtkHelios and its Python package use, nothing that draws.

set(CMAKE_BUILD_TYPE Release CACHE STRING "")
set(CMAKE_C_FLAGS_RELEASE "-O2 -DNDEBUG" CACHE STRING "")
set(CMAKE_CXX_FLAGS_RELEASE "-O2 -DNDEBUG" CACHE STRING "") # as Debian's
set(CMAKE_CXX_FLAGS "-fno-gnu-unique" CACHE STRING "") # unique symbols are shared with other VTKs
set(CMAKE_SHARED_LINKER_FLAGS "-Wl,--as-needed" CACHE STRING "")
set(CMAKE_MODULE_LINKER_FLAGS "-Wl,--as-needed" CACHE STRING "")
set(CMAKE_C_COMPILER_LAUNCHER ccache CACHE STRING "")
set(CMAKE_CXX_COMPILER_LAUNCHER ccache CACHE STRING "")
set(CMAKE_UNITY_BUILD ON CACHE BOOL "")
set(CMAKE_UNITY_BUILD_BATCH_SIZE 25 CACHE STRING "")

set(VTK_BUILD_ALL_MODULES OFF CACHE BOOL "")
set(VTK_BUILD_TESTING OFF CACHE STRING "")
set(VTK_CUSTOM_LIBRARY_SUFFIX vtkhelios CACHE STRING "") # libvtkCommonCore-vtkhelios.so
set(VTK_ENABLE_LOGGING ON CACHE BOOL "")
set(VTK_GROUP_ENABLE_Rendering DONT_WANT CACHE STRING "")
set(VTK_GROUP_ENABLE_StandAlone DONT_WANT CACHE STRING "")
set(VTK_INSTALL_PYTHON_EXES OFF CACHE BOOL "")
set(VTK_PYTHON_VERSION 3 CACHE STRING "")
set(VTK_SMP_IMPLEMENTATION_TYPE TBB CACHE STRING "") # as Debian's
set(VTK_WRAP_PYTHON ON CACHE BOOL "")

foreach(module IN ITEMS
  CommonColor CommonCore CommonDataModel CommonExecutionModel CommonMath CommonMisc CommonSystem
  CommonTransforms FiltersCore FiltersGeneral FiltersGeometry FiltersPython FiltersSources IOCore
  IOXML IOXMLParser Python WrappingPythonCore)
  set(VTK_MODULE_ENABLE_VTK_${module} YES CACHE STRING "")
endforeach()

# Debian's source package has no copies of these.
foreach(module IN ITEMS doubleconversion expat lz4 lzma pugixml utf8 zlib)
  set(VTK_MODULE_USE_EXTERNAL_VTK_${module} ON CACHE BOOL "")
endforeach()
