# SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
# SPDX-License-Identifier: BSD-3-Clause
# Build rules for all modules and test programs of vtkHelios.

set(vtkhelios_warnings -Wall -Wextra -Wshadow -Wnon-virtual-dtor -Woverloaded-virtual)
if(VTKHELIOS_WARNINGS_AS_ERRORS)
  list(APPEND vtkhelios_warnings -Werror)
endif()

# helios_get_folders(<output> <file>...)
# The subfolders that some of the files are in.
function(helios_get_folders output)
  list(FILTER ARGN INCLUDE REGEX "/")
  list(TRANSFORM ARGN REPLACE "/[^/]*$" "" OUTPUT_VARIABLE folders)
  list(REMOVE_DUPLICATES folders)
  set(${output} ${folders} PARENT_SCOPE)
endfunction()

# helios_add_module(<name> CLASSES ... [SOURCES ...] [HEADERS ...] [LINK ...])
# A VTK module with the project's warnings; HEADERS are installed and not wrapped, SOURCES are
# private. Floating-point contraction is off: byte-identical on every machine, no leak between
# triangles. Files may be in subfolders; headers are included by their names alone.
function(helios_add_module name)
  cmake_parse_arguments(arg "" "" "CLASSES;SOURCES;HEADERS;LINK" ${ARGN})
  vtk_module_add_module(vtkHelios::${name}
    CLASSES ${arg_CLASSES}
    SOURCES ${arg_SOURCES}
    NOWRAP_HEADERS ${arg_HEADERS})
  helios_get_folders(folders ${arg_CLASSES} ${arg_SOURCES} ${arg_HEADERS})
  foreach(folder IN LISTS folders)
    vtk_module_include(vtkHelios::${name} PUBLIC "$<BUILD_INTERFACE:${CMAKE_CURRENT_SOURCE_DIR}/${folder}>")
  endforeach()
  vtk_module_compile_options(vtkHelios::${name} PRIVATE ${vtkhelios_warnings} -ffp-contract=off
    -fno-semantic-interposition)
  get_target_property(target vtkHelios::${name} ALIASED_TARGET)
  helios_precompile(${target} heliosModuleHeaders)
  if(arg_LINK)
    vtk_module_link(vtkHelios::${name} PRIVATE ${arg_LINK})
  endif()
endfunction()

# Removes the modules with a disabled optional library from the list of vtk.module files.
function(helios_drop_disabled_modules files)
  set(kept ${${files}})
  if(NOT VTKHELIOS_ENABLE_EMBREE)
    list(FILTER kept EXCLUDE REGEX "RayCasting/Embree/vtk.module$")
  endif()
  if(NOT VTKHELIOS_ENABLE_CGAL)
    list(FILTER kept EXCLUDE REGEX "(RayCasting/Cgal|Filters/Simplify)/vtk.module$")
  endif()
  if(NOT VTKHELIOS_ENABLE_PCL)
    list(FILTER kept EXCLUDE REGEX "Filters/PCL/vtk.module$")
  endif()
  if(NOT VTKHELIOS_ENABLE_CBC)
    list(FILTER kept EXCLUDE REGEX "Planning/Cbc/vtk.module$")
  endif()
  if(NOT VTKHELIOS_ENABLE_MPI)
    list(FILTER kept EXCLUDE REGEX "Scanner/Mpi/vtk.module$")
  endif()
  set(${files} ${kept} PARENT_SCOPE)
endfunction()

# helios_add_test_program(<module> <folder> [LINK <module>...])
# One Catch2 program of all Test*.cxx below <folder>/Testing/Cxx, one ctest per case. Cases tagged
# [mutation] pass damaged files to a reader and are in Test*Mutations.cxx.
function(helios_add_test_program module folder)
  cmake_parse_arguments(arg "" "" "LINK" ${ARGN})
  set(tests "${CMAKE_SOURCE_DIR}/${folder}/Testing/Cxx")
  file(GLOB_RECURSE sources CONFIGURE_DEPENDS "${tests}/Test*.cxx")
  if(NOT sources OR NOT TARGET vtkHelios::${module})
    return()
  endif()
  set(program vtkHelios${module}Tests)
  add_executable(${program} ${sources})
  file(GLOB folders LIST_DIRECTORIES true CONFIGURE_DEPENDS "${tests}/*")
  list(FILTER folders EXCLUDE REGEX "[.](h|cxx)$")
  target_include_directories(${program} PRIVATE "${tests}" ${folders})
  target_compile_options(${program} PRIVATE ${vtkhelios_warnings} -ffp-contract=off)
  list(TRANSFORM arg_LINK REPLACE "^([^:]+)$" "vtkHelios::\\1")
  target_link_libraries(${program} PRIVATE heliosTesting vtkHelios::${module} ${arg_LINK})
  helios_precompile(${program} heliosTestHeaders)
  # STRICT: a title with ; or an unbalanced [ would be registered wrongly and run nothing.
  catch_discover_tests(${program} TEST_PREFIX "${module}." TEST_SPEC "~[mutation]" EXTRA_ARGS ${HeliosCatch2_STRICT}
    PROPERTIES LABELS ${module} TIMEOUT 300)
  set(mutation_tests ${sources})
  list(FILTER mutation_tests INCLUDE REGEX "Mutations?[.]cxx$")
  if(mutation_tests)
    catch_discover_tests(${program} TEST_PREFIX "${module}." TEST_SPEC "[mutation]" TEST_LIST ${program}_MUTATIONS
      EXTRA_ARGS ${HeliosCatch2_STRICT}
      PROPERTIES LABELS "${module};mutation" TIMEOUT 3000 ENVIRONMENT "HELIOS_MUTATIONS=${VTKHELIOS_MUTATIONS}")
  endif()
endfunction()

# Registers VTK's rendering classes in a program or library of the viewer.
function(helios_register_drawing target)
  list(TRANSFORM vtkhelios_viewer_components PREPEND "VTK::" OUTPUT_VARIABLE modules)
  vtk_module_autoinit(TARGETS ${target} MODULES ${modules})
endfunction()
