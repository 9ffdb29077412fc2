# SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
# SPDX-License-Identifier: BSD-3-Clause
# CGAL 5 or 6, as HeliosCgal::HeliosCgal. Sources are written for CGAL 6; Compatibility/Cgal5 has its
# headers for CGAL 5.
find_package(CGAL QUIET)
include(FindPackageHandleStandardArgs)
find_package_handle_standard_args(HeliosCgal REQUIRED_VARS CGAL_DIR VERSION_VAR CGAL_VERSION
  REASON_FAILURE_MESSAGE "install CGAL 5 or 6 (Debian: libcgal-dev), or set VTKHELIOS_ENABLE_CGAL to OFF")
if(HeliosCgal_FOUND AND NOT TARGET HeliosCgal::HeliosCgal)
  add_library(HeliosCgal::HeliosCgal INTERFACE IMPORTED)
  target_link_libraries(HeliosCgal::HeliosCgal INTERFACE CGAL::CGAL)
  if(CGAL_VERSION VERSION_LESS 6)
    target_include_directories(HeliosCgal::HeliosCgal INTERFACE "${CMAKE_CURRENT_LIST_DIR}/Compatibility/Cgal5")
  endif()
endif()
