// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
// Damaged PLY files give an error or a valid scene.
#include "heliosPlyTesting.h"

TEST_CASE("PLYMutations: damaged files give an error or a valid scene", "[mutation]")
{
  helios::CheckMutations<vtkHeliosPLYSceneReader>("a.ply",
    { helios::ply::Square, helios::ply::MakeBinary(false), helios::ply::MakeBinary(true) });
}
