// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
// Damaged STL files give an error or a valid scene.
#include "heliosStlTesting.h"

TEST_CASE("STLMutations: damaged files give an error or a valid scene", "[mutation]")
{
  helios::CheckMutations<vtkHeliosSTLSceneReader>("a.stl",
    { helios::stl::Square,
      helios::stl::MakeBinary({ 0, 0, 0, 1, 0, 0, 1, 1, 0, 0, 0, 0, 1, 1, 0, 0, 1, 0 }) });
}
