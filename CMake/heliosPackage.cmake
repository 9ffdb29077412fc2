# SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
# SPDX-License-Identifier: BSD-3-Clause
# find_package(vtkHelios) for other projects.

include(CMakePackageConfigHelpers)
set(vtkhelios_cmake_dir ${CMAKE_INSTALL_LIBDIR}/cmake/vtkHelios)
set(vtkhelios_components ${vtkhelios_modules})
list(TRANSFORM vtkhelios_components REPLACE "^vtkHelios::" "")
set(vtkhelios_vtk_public ${vtkhelios_vtk_components})
list(REMOVE_ITEM vtkhelios_vtk_public ParallelMPI WrappingPythonCore Python)
list(JOIN vtkhelios_vtk_public " " vtkhelios_vtk_public)
configure_package_config_file(
  "${CMAKE_CURRENT_SOURCE_DIR}/CMake/vtkHeliosConfig.cmake.in"
  "${CMAKE_BINARY_DIR}/vtkHeliosConfig.cmake"
  INSTALL_DESTINATION ${vtkhelios_cmake_dir})
write_basic_package_version_file("${CMAKE_BINARY_DIR}/vtkHeliosConfigVersion.cmake"
  COMPATIBILITY SameMinorVersion)
install(FILES "${CMAKE_BINARY_DIR}/vtkHeliosConfig.cmake" "${CMAKE_BINARY_DIR}/vtkHeliosConfigVersion.cmake"
  DESTINATION ${vtkhelios_cmake_dir} COMPONENT development)
