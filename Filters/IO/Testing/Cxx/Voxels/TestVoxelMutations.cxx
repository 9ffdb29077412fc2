// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
// Damaged .vox files give an error or a grid.
#include "heliosMutation.h"
#include "heliosVoxTesting.h"

#include <catch2/catch.hpp>

namespace names = vtkHeliosArrayNames;
using namespace helios::vox;

TEST_CASE("VoxelMutations: damaged files give an error or a grid", "[VoxelReader][mutation]")
{
  helios::Mutator mutate(20260);
  int errors = 0;
  int grids = 0;
  for (int i = 0; i < helios::GetNumberOfMutations(); ++i)
  {
    const std::string text = mutate(Head + Columns + Rows);
    Reading reading(text);
    reading.Reader->SetMaximumNumberOfCells(1000000);
    INFO("file " << i << "\n" << text);
    const bool isGood = reading.Read();
    (isGood ? grids : errors) += 1;
    REQUIRE((isGood || reading.Log->HasError("a.vox:")));
    REQUIRE(isGood == (reading.Grid()->GetCellData()->GetArray(names::PAD) != nullptr));
  }
  CHECK(errors > 20);
  CHECK(grids > 20);
}
