# SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
# SPDX-License-Identifier: BSD-3-Clause
# Embree 4 or 3, as HeliosEmbree::HeliosEmbree; heliosEmbree.h is its header for both.
find_package(embree 4 QUIET)
if(NOT embree_FOUND)
  find_package(embree 3 QUIET)
endif()
include(FindPackageHandleStandardArgs)
find_package_handle_standard_args(HeliosEmbree REQUIRED_VARS EMBREE_LIBRARY VERSION_VAR EMBREE_VERSION
  REASON_FAILURE_MESSAGE "install Embree 3 or 4 (Debian: libembree-dev), or set VTKHELIOS_ENABLE_EMBREE to OFF")
if(HeliosEmbree_FOUND AND NOT TARGET HeliosEmbree::HeliosEmbree)
  add_library(HeliosEmbree::HeliosEmbree INTERFACE IMPORTED)
  target_link_libraries(HeliosEmbree::HeliosEmbree INTERFACE embree)
  target_compile_definitions(HeliosEmbree::HeliosEmbree INTERFACE HELIOS_EMBREE_VERSION=${EMBREE_VERSION_MAJOR})
endif()
