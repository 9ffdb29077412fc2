// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkHeliosBvhRayCaster.h"

#include "heliosExtremeChecks.h"

#include <vtkNew.h>

TEST_CASE("BvhRayCaster: range error within 8 u R / cos in 168 cases", "[BvhRayCaster]")
{
  vtkNew<vtkHeliosBvhRayCaster> caster;
  helios::CheckRangeLaw(*caster);
}

TEST_CASE("BvhRayCaster: small distant leaves on terrain", "[BvhRayCaster]")
{
  vtkNew<vtkHeliosBvhRayCaster> caster;
  helios::CheckSmallLeaves(*caster);
}

TEST_CASE("BvhRayCaster: no leak through a height field, no second echo", "[BvhRayCaster]")
{
  vtkNew<vtkHeliosBvhRayCaster> caster;
  helios::CheckHeightFieldLeaks(*caster);
}

TEST_CASE("BvhRayCaster: needles are hit", "[BvhRayCaster]")
{
  vtkNew<vtkHeliosBvhRayCaster> caster;
  helios::CheckNeedles(*caster);
}

TEST_CASE("BvhRayCaster: a triangulated sphere", "[BvhRayCaster]")
{
  vtkNew<vtkHeliosBvhRayCaster> caster;
  helios::CheckSphere(*caster);
}

TEST_CASE("BvhRayCaster: sinusoidal terrain", "[BvhRayCaster]")
{
  vtkNew<vtkHeliosBvhRayCaster> caster;
  helios::CheckSineTerrain(*caster);
}
