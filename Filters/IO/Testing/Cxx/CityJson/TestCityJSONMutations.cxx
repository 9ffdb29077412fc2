// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
// Damaged city models give an error or a valid scene.
#include "heliosCityTesting.h"

TEST_CASE("CityJSONMutations: damaged files give an error or a valid scene", "[mutation]")
{
  helios::CheckMutations<vtkHeliosCityJSONReader>("a.json", { helios::city::MakeHouse() });
}

TEST_CASE("CityJSONMutations: changed numbers give an error or a valid scene", "[mutation]")
{
  const std::string good = helios::city::MakeHouse();
  for (int seed = 0; seed < helios::GetNumberOfMutations(); ++seed)
  {
    INFO("seed " << seed);
    helios::city::Reading reading(
      "a.json", helios::Mutator(static_cast<unsigned>(seed)).ChangeNumber(good));
    if (reading.Read())
    {
      helios::CheckScene(reading);
    }
  }
}
