# SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
# SPDX-License-Identifier: BSD-3-Clause
# JsonCpp, as JsonCpp::JsonCpp. That target is of VTK, where it has found JsonCpp for the viewer, or
# of packages of JsonCpp 1.9.5; others have jsoncpp_lib only.
if(NOT TARGET JsonCpp::JsonCpp)
  find_package(jsoncpp QUIET)
endif()
if(TARGET jsoncpp_lib AND NOT TARGET JsonCpp::JsonCpp)
  add_library(JsonCpp::JsonCpp INTERFACE IMPORTED)
  target_link_libraries(JsonCpp::JsonCpp INTERFACE jsoncpp_lib)
endif()
if(TARGET JsonCpp::JsonCpp)
  set(HeliosJsonCpp_TARGET JsonCpp::JsonCpp)
endif()
include(FindPackageHandleStandardArgs)
find_package_handle_standard_args(HeliosJsonCpp REQUIRED_VARS HeliosJsonCpp_TARGET
  REASON_FAILURE_MESSAGE "install JsonCpp (Debian: libjsoncpp-dev)")
