# SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
# SPDX-License-Identifier: BSD-3-Clause
# Catch2 2 or 3, as HeliosCatch2::HeliosCatch2, and the function catch_discover_tests. Tests are
# written for Catch2 2; Compatibility/Catch3 has its header for Catch2 3.
# HeliosCatch2_STRICT: arguments of test programs with which it is a failure to run no test.
find_package(Catch2 3 QUIET)
if(NOT Catch2_FOUND)
  find_package(Catch2 2 QUIET)
endif()
include(FindPackageHandleStandardArgs)
find_package_handle_standard_args(HeliosCatch2 REQUIRED_VARS Catch2_DIR VERSION_VAR Catch2_VERSION
  REASON_FAILURE_MESSAGE "install Catch2 2 or 3 (Debian: catch2), or set VTKHELIOS_BUILD_TESTING to OFF")
if(HeliosCatch2_FOUND)
  include(Catch)
  set(HeliosCatch2_STRICT)
  if(Catch2_VERSION VERSION_LESS 3)
    set(HeliosCatch2_STRICT --warn NoTests)
  endif()
endif()
if(HeliosCatch2_FOUND AND NOT TARGET HeliosCatch2::HeliosCatch2)
  add_library(HeliosCatch2::HeliosCatch2 INTERFACE IMPORTED)
  target_link_libraries(HeliosCatch2::HeliosCatch2 INTERFACE Catch2::Catch2)
  if(Catch2_VERSION VERSION_GREATER_EQUAL 3)
    target_link_libraries(HeliosCatch2::HeliosCatch2 INTERFACE Catch2::Catch2WithMain)
    target_include_directories(HeliosCatch2::HeliosCatch2 INTERFACE "${CMAKE_CURRENT_LIST_DIR}/Compatibility/Catch3")
  endif()
endif()
