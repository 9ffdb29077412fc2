// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
// Refractive indices by wavelength against published values.
#include "heliosDispersion.h"
#include "heliosOpticsBench.h"

#include <catch2/catch.hpp>

#include <cmath>

using namespace helios::testing;
using helios::DispersionKind;
using helios::GetIndices;
using helios::Material;
using helios::OpticsKind;
namespace names = vtkHeliosArrayNames;

TEST_CASE("Dispersion: indices of media are those published", "[Dispersion]")
{
  CHECK(GetIndices(DispersionKind::Bk7, 587.6).Phase == Approx(1.5168).margin(5e-5));
  CHECK(GetIndices(DispersionKind::Bk7, 1064.0).Phase == Approx(1.5066).margin(5e-5));
  CHECK(GetIndices(DispersionKind::Silica, 587.6).Phase == Approx(1.4585).margin(5e-5));
  CHECK(GetIndices(DispersionKind::Silica, 1064.0).Phase == Approx(1.4496).margin(5e-5));
  CHECK(GetIndices(DispersionKind::Silica, 1550.0).Group == Approx(1.4626).margin(2e-4));
  CHECK(GetIndices(DispersionKind::SodaLime, 587.6).Phase == Approx(1.5234).margin(5e-5));
  CHECK(GetIndices(DispersionKind::Water, 589.3).Phase == Approx(1.33299 * 1.000272).margin(5e-5));
  CHECK(GetIndices(DispersionKind::None, 532.0).Phase == 1.0);
}

TEST_CASE("Dispersion: the group index is n - l dn/dl", "[Dispersion]")
{
  const DispersionKind medium = GENERATE(
    DispersionKind::Water, DispersionKind::SodaLime, DispersionKind::Bk7, DispersionKind::Silica);
  const double wavelength = GENERATE(450.0, 532.0, 905.0, 1064.0);
  const double step = 0.01;
  const double slope =
    (GetIndices(medium, wavelength + step).Phase - GetIndices(medium, wavelength - step).Phase) /
    (2.0 * step);
  const helios::Indices indices = GetIndices(medium, wavelength);
  CHECK(indices.Group == Approx(indices.Phase - wavelength * slope).epsilon(1e-7));
  CHECK(indices.Group > indices.Phase);
}

TEST_CASE("Dispersion: beyond the range of the formulas their limits hold", "[Dispersion]")
{
  CHECK(GetIndices(DispersionKind::Water, 1550.0).Phase ==
    GetIndices(DispersionKind::Water, 1100.0).Phase);
  CHECK(
    GetIndices(DispersionKind::Bk7, 3000.0).Group == GetIndices(DispersionKind::Bk7, 2300.0).Group);
}

TEST_CASE("Dispersion: ranges through panes and water are those of the group index", "[Dispersion]")
{
  const bool isPane = GENERATE(true, false);
  const bool isAdaptive = GENERATE(false, true);
  const double thickness = isPane ? 0.1 : 2.0;
  Material medium = MakeMaterial(isPane ? OpticsKind::Pane : OpticsKind::Water);
  medium.Optics.Dispersion = isPane ? DispersionKind::SodaLime : DispersionKind::Water;
  medium.Optics.Thickness = thickness;
  const auto scene = MakeOpticalScene({ Wall(10.0) }, medium, { Wall(12.0) });
  RayBench bench(scene);
  bench.Scanner->SetWavelength(532.0);
  bench.Scanner->GetBeamSampler()->SetBeamDivergence(isAdaptive ? 1e-6 : 0.0);
  if (isAdaptive)
  {
    bench.Scanner->SetSamplingToTolerance();
  }
  vtkPolyData* cloud = bench.Run();
  const vtkIdType last = cloud->GetNumberOfPoints() - 1;
  REQUIRE(last >= 0);
  const double group = GetIndices(medium.Optics.Dispersion, 532.0).Group;
  CHECK(Value(cloud, names::Range, last) == Approx(12.0 + (group - 1.0) * thickness).margin(1e-6));
}
