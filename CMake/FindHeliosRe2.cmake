# SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
# SPDX-License-Identifier: BSD-3-Clause
# RE2, as PkgConfig::RE2. Since 2023 it is built on Abseil, which has its users define NOMINMAX, of
# use on Windows only; precompiled headers without it could not be used.
find_package(PkgConfig REQUIRED)
pkg_check_modules(RE2 QUIET IMPORTED_TARGET re2)
include(FindPackageHandleStandardArgs)
find_package_handle_standard_args(HeliosRe2 REQUIRED_VARS RE2_FOUND VERSION_VAR RE2_VERSION
  REASON_FAILURE_MESSAGE "install RE2 (Debian: libre2-dev)")
if(HeliosRe2_FOUND)
  get_target_property(helios_re2_options PkgConfig::RE2 INTERFACE_COMPILE_OPTIONS)
  if(helios_re2_options)
    list(REMOVE_ITEM helios_re2_options -DNOMINMAX)
    set_target_properties(PkgConfig::RE2 PROPERTIES INTERFACE_COMPILE_OPTIONS "${helios_re2_options}")
  endif()
endif()
