# SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
# SPDX-License-Identifier: BSD-3-Clause
# Debian packages by CPack: Apps/Packages/Debian/build.sh. A package is a group of install components.

set(vtkhelios_library_package "libvtkhelios${PROJECT_VERSION_MAJOR}.${PROJECT_VERSION_MINOR}")
set(vtkhelios_debian_dir "${CMAKE_SOURCE_DIR}/Apps/Packages/Debian")

# Files for the desktop and the shells; man pages and completions exist once the script made them.
install(FILES "${vtkhelios_debian_dir}/vtkhelios.desktop"
  DESTINATION share/applications COMPONENT desktop EXCLUDE_FROM_ALL)
install(FILES "${vtkhelios_debian_dir}/vtkhelios.svg"
  DESTINATION share/icons/hicolor/scalable/apps COMPONENT desktop EXCLUDE_FROM_ALL)
install(DIRECTORY "${CMAKE_BINARY_DIR}/debian/share/"
  DESTINATION share COMPONENT desktop EXCLUDE_FROM_ALL OPTIONAL)
file(READ "${CMAKE_SOURCE_DIR}/LICENSE" license)
string(STRIP "${license}" license)
string(REPLACE "\n\n" "\n.\n" license "${license}")
string(REPLACE "\n" "\n " license " ${license}")
configure_file("${vtkhelios_debian_dir}/copyright.template" "${CMAKE_BINARY_DIR}/debian/copyright" @ONLY)
foreach(package IN ITEMS vtkhelios python3-vtkhelios ${vtkhelios_library_package} libvtkhelios-dev)
  install(FILES "${CMAKE_BINARY_DIR}/debian/copyright"
    DESTINATION share/doc/${package} COMPONENT copyright-${package} EXCLUDE_FROM_ALL)
  list(APPEND vtkhelios_copyrights copyright-${package})
endforeach()

set(CPACK_GENERATOR DEB)
set(CPACK_PACKAGE_NAME vtkhelios)
set(CPACK_PACKAGE_CONTACT "The vtkHelios authors")
set(CPACK_PACKAGING_INSTALL_PREFIX /usr)
set(CPACK_STRIP_FILES ON)
set(CPACK_DEB_COMPONENT_INSTALL ON)
set(CPACK_COMPONENTS_GROUPING ONE_PER_GROUP)
set(CPACK_COMPONENTS_ALL runtime python command viewer desktop development ${vtkhelios_copyrights})

set(CPACK_DEBIAN_FILE_NAME DEB-DEFAULT)
set(CPACK_DEBIAN_PACKAGE_RELEASE 1)
set(CPACK_DEBIAN_PACKAGE_SHLIBDEPS ON)
set(CPACK_DEBIAN_PACKAGE_GENERATE_SHLIBS ON)
set(CPACK_DEBIAN_PACKAGE_SHLIBDEPS_PRIVATE_DIRS "${CMAKE_LIBRARY_OUTPUT_DIRECTORY}")
set(CPACK_DEBIAN_PACKAGE_CONTROL_STRICT_PERMISSION ON)

# helios_debian_package(GROUP NAME SECTION SUMMARY DEPENDS COMPONENT...)
macro(helios_debian_package group name section summary depends)
  foreach(component IN ITEMS ${ARGN} copyright-${name})
    string(TOUPPER "${component}" upper)
    set(CPACK_COMPONENT_${upper}_GROUP ${group})
  endforeach()
  string(TOUPPER "${group}" upper)
  set(CPACK_DEBIAN_${upper}_PACKAGE_NAME "${name}")
  set(CPACK_DEBIAN_${upper}_PACKAGE_SECTION "${section}")
  set(CPACK_DEBIAN_${upper}_PACKAGE_DEPENDS "${depends}")
  set(CPACK_COMPONENT_${upper}_DESCRIPTION "${summary}")
  set(CPACK_COMPONENT_GROUP_${upper}_DESCRIPTION "${summary}")
endmacro()

set(version "${PROJECT_VERSION}-${CPACK_DEBIAN_PACKAGE_RELEASE}")
helios_debian_package(libraries ${vtkhelios_library_package} libs
  "Simulation of laser scanning (LiDAR): libraries\n Scenes, scanners, platforms and surveys as filters of VTK."
  "" runtime)
helios_debian_package(package python3-vtkhelios python
  "Simulation of laser scanning (LiDAR): Python package\n Clouds as numpy arrays, surveys and scenes as objects, and\n all filters as classes."
  "${vtkhelios_library_package} (= ${version}), python3, python3-vtk9, python3-numpy, python3-rich, python3-jinja2, python3-matplotlib"
  python)
helios_debian_package(programs vtkhelios science
  "Simulation of laser scanning (LiDAR): command line and viewer\n Runs surveys of HELIOS and HELIOS++, plans scan positions, shows,\n converts and compares clouds."
  "python3-vtkhelios (= ${version}), fonts-dejavu-core" command viewer desktop)
helios_debian_package(headers libvtkhelios-dev libdevel
  "Simulation of laser scanning (LiDAR): headers and CMake files\n For programs with filters, deflectors or detectors of their own."
  "${vtkhelios_library_package} (= ${version}), libvtk9-dev" development)
include(CPack)
