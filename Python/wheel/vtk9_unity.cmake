# SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
# SPDX-License-Identifier: BSD-3-Clause
# Included by project(VTK). Several sources are compiled as one (CMAKE_UNITY_BUILD), which takes a
# third of the time; not those of the targets below, which cannot be.

function(vtkhelios_separate_sources)
  foreach(target IN ITEMS vtksys loguru)
    if(TARGET ${target})
      set_target_properties(${target} PROPERTIES UNITY_BUILD OFF)
    endif()
  endforeach()
endfunction()
cmake_language(DEFER CALL vtkhelios_separate_sources) # at the end, when there are all targets
