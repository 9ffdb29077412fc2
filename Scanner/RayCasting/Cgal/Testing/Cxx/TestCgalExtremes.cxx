// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkHeliosCgalRayCaster.h"

#include "../../../Testing/Cxx/heliosExtremeChecks.h"

#include <vtkNew.h>

TEST_CASE("CgalRayCaster: range error within 8 u R / cos in 168 cells", "[CgalRayCaster]")
{
  vtkNew<vtkHeliosCgalRayCaster> caster;
  helios::CheckRangeLaw(*caster);
}

TEST_CASE("CgalRayCaster: small leaves far out on terrain", "[CgalRayCaster]")
{
  vtkNew<vtkHeliosCgalRayCaster> caster;
  helios::CheckSmallLeaves(*caster);
}

TEST_CASE("CgalRayCaster: no leak through a heightfield, no second echo", "[CgalRayCaster]")
{
  vtkNew<vtkHeliosCgalRayCaster> caster;
  helios::CheckHeightFieldLeaks(*caster);
}

TEST_CASE("CgalRayCaster: needles are hit", "[CgalRayCaster]")
{
  vtkNew<vtkHeliosCgalRayCaster> caster;
  helios::CheckNeedles(*caster);
}

TEST_CASE("CgalRayCaster: a sphere of triangles", "[CgalRayCaster]")
{
  vtkNew<vtkHeliosCgalRayCaster> caster;
  helios::CheckSphere(*caster);
}

TEST_CASE("CgalRayCaster: a sine of terrain", "[CgalRayCaster]")
{
  vtkNew<vtkHeliosCgalRayCaster> caster;
  helios::CheckSineTerrain(*caster);
}
