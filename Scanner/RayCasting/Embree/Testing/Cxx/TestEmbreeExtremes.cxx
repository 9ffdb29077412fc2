// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkHeliosEmbreeRayCaster.h"

#include "../../../Testing/Cxx/heliosExtremeChecks.h"

#include <vtkNew.h>

TEST_CASE("EmbreeRayCaster: range error within 8 u R / cos in 168 cases", "[EmbreeRayCaster]")
{
  vtkNew<vtkHeliosEmbreeRayCaster> caster;
  helios::CheckRangeLaw(*caster);
}

TEST_CASE("EmbreeRayCaster: small distant leaves on terrain", "[EmbreeRayCaster]")
{
  vtkNew<vtkHeliosEmbreeRayCaster> caster;
  helios::CheckSmallLeaves(*caster);
}

TEST_CASE("EmbreeRayCaster: no leak through a height field, no second echo", "[EmbreeRayCaster]")
{
  vtkNew<vtkHeliosEmbreeRayCaster> caster;
  helios::CheckHeightFieldLeaks(*caster);
}

TEST_CASE("EmbreeRayCaster: needles are hit", "[EmbreeRayCaster]")
{
  vtkNew<vtkHeliosEmbreeRayCaster> caster;
  helios::CheckNeedles(*caster);
}

TEST_CASE("EmbreeRayCaster: a triangulated sphere", "[EmbreeRayCaster]")
{
  vtkNew<vtkHeliosEmbreeRayCaster> caster;
  helios::CheckSphere(*caster);
}

TEST_CASE("EmbreeRayCaster: sinusoidal terrain", "[EmbreeRayCaster]")
{
  vtkNew<vtkHeliosEmbreeRayCaster> caster;
  helios::CheckSineTerrain(*caster);
}
