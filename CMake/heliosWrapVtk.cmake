# SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
# SPDX-License-Identifier: BSD-3-Clause
# Wraps the modules of VTK that the package uses once more, as vtkhelios.vtkmodules: for a wheel,
# which works beside another VTK.
#
# Wrapped modules load the modules that they depend on by full names, which are compiled in. With the
# name vtkmodules they would load the modules of another VTK, and crash.

# helios_add_depends(<list> <module>...)
# Appends VTK modules and all that their wrapped classes need, in this order: needed ones first.
function(helios_add_depends list)
  set(modules ${${list}})
  foreach(module IN LISTS ARGN)
    get_target_property(is_excluded ${module} INTERFACE_vtk_module_exclude_wrap)
    if(module IN_LIST modules OR is_excluded)
      continue()
    endif()
    get_target_property(depends ${module} INTERFACE_vtk_module_depends)
    helios_add_depends(modules ${depends})
    list(APPEND modules ${module})
  endforeach()
  set(${list} ${modules} PARENT_SCOPE)
endfunction()

if(VTKHELIOS_VTK_PYTHON_DIR) # libraries of VTK for another Python
  foreach(name IN ITEMS FiltersPython WrappingPythonCore)
    file(GLOB library "${VTKHELIOS_VTK_PYTHON_DIR}/libvtk${name}*.so")
    get_target_property(configuration VTK::${name} IMPORTED_CONFIGURATIONS)
    set_property(TARGET VTK::${name} PROPERTY IMPORTED_LOCATION_${configuration} "${library}")
  endforeach()
endif()

set(vtkhelios_wrapped_vtk)
helios_add_depends(vtkhelios_wrapped_vtk VTK::CommonCore VTK::CommonDataModel VTK::CommonExecutionModel
  VTK::CommonMisc VTK::FiltersCore VTK::FiltersPython VTK::FiltersSources VTK::IOXML)
foreach(module IN LISTS vtkhelios_wrapped_vtk)
  set_property(TARGET ${module} PROPERTY INTERFACE_vtk_module_python_package) # was vtkmodules
  set_property(TARGET ${module} PROPERTY INCLUDE_DIRECTORIES # for vtkWrapPython
    "$<TARGET_PROPERTY:${module},INTERFACE_INCLUDE_DIRECTORIES>")
endforeach()
vtk_module_wrap_python(
  MODULES             ${vtkhelios_wrapped_vtk}
  TARGET              vtkHelios::vtkmodules
  PYTHON_PACKAGE      vtkhelios.vtkmodules
  INSTALL_HEADERS     OFF
  MODULE_DESTINATION  "${vtkhelios_python_dir}"
  CMAKE_DESTINATION   ${CMAKE_INSTALL_LIBDIR}/cmake/vtkHelios
  LIBRARY_DESTINATION ${vtkhelios_library_dir}
  BUILD_STATIC        OFF)
foreach(module IN LISTS vtkhelios_wrapped_vtk)
  string(REGEX REPLACE "^VTK::(.*)$" "vtk\\1Python" wrapped "${module}")
  set_target_properties(${wrapped} PROPERTIES UNITY_BUILD ON UNITY_BUILD_BATCH_SIZE 30)
endforeach()
