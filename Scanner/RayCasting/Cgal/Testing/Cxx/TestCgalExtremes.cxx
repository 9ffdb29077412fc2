// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkHeliosCgalRayCaster.h"

#include "../../../Testing/Cxx/heliosExtremeChecks.h"

#include <vtkNew.h>

TEST_CASE("CgalRayCaster: range error within 8 u R / cos in 168 cases", "[CgalRayCaster]")
{
  vtkNew<vtkHeliosCgalRayCaster> caster;
  helios::CheckRangeLaw(*caster);
}

TEST_CASE("CgalRayCaster: small distant leaves on terrain", "[CgalRayCaster]")
{
  vtkNew<vtkHeliosCgalRayCaster> caster;
  helios::CheckSmallLeaves(*caster);
}

TEST_CASE("CgalRayCaster: no leak through a height field, no second echo", "[CgalRayCaster]")
{
  vtkNew<vtkHeliosCgalRayCaster> caster;
  helios::CheckHeightFieldLeaks(*caster);
}

TEST_CASE("CgalRayCaster: needles are hit", "[CgalRayCaster]")
{
  vtkNew<vtkHeliosCgalRayCaster> caster;
  helios::CheckNeedles(*caster);
}

TEST_CASE("CgalRayCaster: a triangulated sphere", "[CgalRayCaster]")
{
  vtkNew<vtkHeliosCgalRayCaster> caster;
  helios::CheckSphere(*caster);
}

TEST_CASE("CgalRayCaster: sinusoidal terrain", "[CgalRayCaster]")
{
  vtkNew<vtkHeliosCgalRayCaster> caster;
  helios::CheckSineTerrain(*caster);
}
