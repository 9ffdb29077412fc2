// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkHeliosBvhRayCaster.h"

#include "heliosExtremeChecks.h"

#include <vtkNew.h>

TEST_CASE("BvhRayCaster: range error within 8 u R / cos in 168 cells", "[BvhRayCaster]")
{
  vtkNew<vtkHeliosBvhRayCaster> caster;
  helios::CheckRangeLaw(*caster);
}

TEST_CASE("BvhRayCaster: small leaves far out on terrain", "[BvhRayCaster]")
{
  vtkNew<vtkHeliosBvhRayCaster> caster;
  helios::CheckSmallLeaves(*caster);
}

TEST_CASE("BvhRayCaster: no leak through a heightfield, no second echo", "[BvhRayCaster]")
{
  vtkNew<vtkHeliosBvhRayCaster> caster;
  helios::CheckHeightFieldLeaks(*caster);
}

TEST_CASE("BvhRayCaster: needles are hit", "[BvhRayCaster]")
{
  vtkNew<vtkHeliosBvhRayCaster> caster;
  helios::CheckNeedles(*caster);
}

TEST_CASE("BvhRayCaster: a sphere of triangles", "[BvhRayCaster]")
{
  vtkNew<vtkHeliosBvhRayCaster> caster;
  helios::CheckSphere(*caster);
}

TEST_CASE("BvhRayCaster: a sine of terrain", "[BvhRayCaster]")
{
  vtkNew<vtkHeliosBvhRayCaster> caster;
  helios::CheckSineTerrain(*caster);
}
