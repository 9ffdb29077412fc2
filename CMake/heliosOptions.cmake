# SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
# SPDX-License-Identifier: BSD-3-Clause
# Build options and output directories.

option(VTKHELIOS_WRAP_PYTHON "Wrap the classes for Python" ON)
option(VTKHELIOS_WRAP_VTK "Wrap the classes of VTK, too, as vtkhelios.vtkmodules: for wheels" OFF)
set(VTKHELIOS_VTK_PYTHON_DIR "" CACHE PATH "Libraries of VTK for another Python than its own; with VTKHELIOS_WRAP_VTK")
option(VTKHELIOS_BUILD_VIEWER "Build the viewer" ON)
option(VTKHELIOS_BUILD_TESTING "Build the tests" ON)
option(VTKHELIOS_BUILD_BENCHMARKS "Build the benchmarks (they need Embree, CGAL and tinyobjloader)" OFF)
option(VTKHELIOS_ENABLE_EMBREE "Build the ray caster on Embree 3 or 4" ON)
option(VTKHELIOS_ENABLE_CGAL "Build what uses CGAL's GPL parts: a ray caster, mesh simplification" OFF)
option(VTKHELIOS_ENABLE_PCL "Build the filters on the Point Cloud Library" ON)
option(VTKHELIOS_ENABLE_CBC "Build the proof of the fewest scan positions, on COIN-OR CBC" ON)
option(VTKHELIOS_LOAD_GDAL "Load GDAL when the first raster is read, such as that of PyPI's rasterio, without linking to it" OFF)
option(VTKHELIOS_ENABLE_MPI "Build runs by the ranks of MPI" ON)
option(VTKHELIOS_WARNINGS_AS_ERRORS "Stop at warnings of the compiler; for developers" OFF)
option(VTKHELIOS_PRECOMPILE_HEADERS "Precompile the headers that most sources include" OFF)
set(VTKHELIOS_MUTATIONS 200 CACHE STRING "Damaged files that the tests give to each reader")

if(NOT CMAKE_BUILD_TYPE AND NOT CMAKE_CONFIGURATION_TYPES)
  set(CMAKE_BUILD_TYPE Release CACHE STRING "Debug, Release, RelWithDebInfo or MinSizeRel" FORCE)
endif()

set(CMAKE_CXX_STANDARD 17)
set(CMAKE_CXX_STANDARD_REQUIRED ON)
set(CMAKE_CXX_EXTENSIONS OFF)
set(CMAKE_CXX_VISIBILITY_PRESET hidden)
set(CMAKE_VISIBILITY_INLINES_HIDDEN ON)
set(BUILD_SHARED_LIBS ON)
set(CMAKE_EXPORT_COMPILE_COMMANDS ON) # for clang-tidy
set(CMAKE_INSTALL_RPATH "$ORIGIN")

find_program(CCACHE_PROGRAM ccache)
mark_as_advanced(CCACHE_PROGRAM)
if(CCACHE_PROGRAM)
  set(CMAKE_C_COMPILER_LAUNCHER "${CCACHE_PROGRAM}")
  set(CMAKE_CXX_COMPILER_LAUNCHER "${CCACHE_PROGRAM}")
endif()

include(GNUInstallDirs)
set(CMAKE_RUNTIME_OUTPUT_DIRECTORY "${CMAKE_BINARY_DIR}/${CMAKE_INSTALL_BINDIR}")
set(CMAKE_LIBRARY_OUTPUT_DIRECTORY "${CMAKE_BINARY_DIR}/${CMAKE_INSTALL_LIBDIR}")
set(CMAKE_ARCHIVE_OUTPUT_DIRECTORY "${CMAKE_BINARY_DIR}/${CMAKE_INSTALL_LIBDIR}")

# A wheel has the libraries beside the Python modules.
if(SKBUILD)
  set(vtkhelios_library_dir vtkhelios)
  set(vtkhelios_python_dir ".")
else()
  set(vtkhelios_library_dir ${CMAKE_INSTALL_LIBDIR})
  set(vtkhelios_python_dir "lib/python3/dist-packages")
endif()

set(vtkhelios_vtk_components
  CommonCore CommonDataModel CommonExecutionModel CommonMath CommonTransforms CommonSystem
  FiltersCore FiltersGeneral IOXML)
if(VTKHELIOS_ENABLE_MPI)
  list(APPEND vtkhelios_vtk_components ParallelMPI)
endif()
if(VTKHELIOS_WRAP_PYTHON)
  list(APPEND vtkhelios_vtk_components FiltersPython WrappingPythonCore Python)
  if(VTKHELIOS_WRAP_VTK)
    list(APPEND vtkhelios_vtk_components CommonMisc FiltersSources)
  endif()
endif()

# Rendering components of the viewer; not part of the package for other projects.
set(vtkhelios_viewer_components)
if(VTKHELIOS_BUILD_VIEWER)
  set(vtkhelios_viewer_components
    ChartsCore CommonColor FiltersModeling FiltersSources ImagingCore InteractionStyle InteractionWidgets
    IOGeometry IOImage IOMovie IOOggTheora IOPLY RenderingAnnotation RenderingContext2D
    RenderingContextOpenGL2 RenderingCore RenderingFreeType RenderingOpenGL2 RenderingUI ViewsContext2D)
endif()
