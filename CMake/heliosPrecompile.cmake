# SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
# SPDX-License-Identifier: BSD-3-Clause
# Precompiled headers: those that most sources include, parsed once for all modules and once for all
# programs. Sources still include what they use; the preset "minimal" builds without.

set(vtkhelios_precompiled
  <algorithm> <array> <cmath> <cstdint> <cstring> <filesystem> <fstream> <functional> <limits> <map> <memory>
  <numeric> <set> <sstream> <string> <utility> <vector>
  <vtkCallbackCommand.h> <vtkCellArray.h> <vtkCellData.h> <vtkDoubleArray.h> <vtkFieldData.h>
  <vtkFloatArray.h> <vtkImageData.h> <vtkInformation.h> <vtkInformationVector.h> <vtkIntArray.h> <vtkMath.h>
  <vtkNew.h> <vtkObjectFactory.h> <vtkPointData.h> <vtkPoints.h> <vtkPolyData.h> <vtkPolyDataAlgorithm.h>
  <vtkSMPTools.h> <vtkSmartPointer.h> <vtkStringArray.h> <vtkTable.h>)

# -pthread, since some libraries require it and users of one header must agree; the other is for
# ccache.
set(vtkhelios_precompile_options -pthread $<$<CXX_COMPILER_ID:GNU>:-fpch-preprocess>)

# helios_add_precompiled(<target> [OPTIONS option...] [HEADERS header...] [LIBRARIES library...])
# A library without code whose precompiled headers others use; their options must be the same. HEADERS are
# of LIBRARIES, and added to the common ones.
function(helios_add_precompiled target)
  cmake_parse_arguments(arg "" "" "OPTIONS;HEADERS;LIBRARIES" ${ARGN})
  if(NOT VTKHELIOS_PRECOMPILE_HEADERS)
    return()
  endif()
  file(CONFIGURE OUTPUT "${CMAKE_BINARY_DIR}/${target}.cxx" CONTENT "// Only the headers are of use.\n")
  add_library(${target} OBJECT "${CMAKE_BINARY_DIR}/${target}.cxx")
  target_compile_options(${target} PRIVATE ${vtkhelios_precompile_options} ${arg_OPTIONS})
  # Include directories only: compile definitions differ, and no header here uses them.
  foreach(library IN ITEMS VTK::CommonCore LISTS arg_LIBRARIES)
    target_include_directories(${target} SYSTEM PRIVATE $<TARGET_PROPERTY:${library},INTERFACE_INCLUDE_DIRECTORIES>)
  endforeach()
  target_precompile_headers(${target} PRIVATE ${vtkhelios_precompiled} ${arg_HEADERS})
endfunction()

# helios_precompile(<target> <precompiled>): uses the headers of that library.
function(helios_precompile target precompiled)
  if(VTKHELIOS_PRECOMPILE_HEADERS)
    target_precompile_headers(${target} REUSE_FROM ${precompiled})
    target_compile_options(${target} PRIVATE ${vtkhelios_precompile_options})
  endif()
endfunction()

# ccache accepts precompiled headers only if set to ignore their dates.
if(VTKHELIOS_PRECOMPILE_HEADERS AND CCACHE_PROGRAM)
  set(CMAKE_CXX_COMPILER_LAUNCHER "${CMAKE_COMMAND}" -E env CCACHE_SLOPPINESS=pch_defines,time_macros
    "${CCACHE_PROGRAM}")
endif()
