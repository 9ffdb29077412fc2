// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
// Directions of scattered light: their density, and the energy.
#include "heliosScatterer.h"

#include "heliosPose.h"
#include "heliosRadiometry.h"
#include "heliosRandom.h"

#include <catch2/catch.hpp>

#include <cmath>

using helios::Scatterer;
using helios::Vec3;

namespace
{

constexpr double Pi = 3.14159265358979323846;

Scatterer MakeScatterer(Scatterer::Kinds kind, const helios::SurfaceReflection& reflection)
{
  Scatterer scatterer;
  scatterer.Kind = kind;
  scatterer.Incoming = Vec3(0.6, 0.0, -0.8);
  scatterer.Plane = scatterer.Normal =
    kind == Scatterer::Surface ? Vec3(0.0, 0.0, 1.0) : -1.0 * scatterer.Incoming;
  scatterer.Reflection = reflection;
  return scatterer;
}

/// Integrates f(direction) over the sphere by the midpoint rule.
template <typename FunctionT>
double IntegrateSphere(FunctionT f)
{
  constexpr int rings = 1000, turns = 500;
  double sum = 0.0;
  for (int i = 0; i < rings; ++i)
  {
    const double cosine = -1.0 + 2.0 * (i + 0.5) / rings;
    for (int k = 0; k < turns; ++k)
    {
      sum += f(helios::GetAround(
        { 0, 0, 1 }, cosine, std::sqrt(1.0 - cosine * cosine), 2.0 * Pi * (k + 0.5) / turns));
    }
  }
  return sum * 4.0 * Pi / (rings * turns);
}

void CheckScatterer(const Scatterer& scatterer)
{
  CHECK(IntegrateSphere([&](const Vec3& d) { return scatterer.GetDensity(d); }) ==
    Approx(1.0).epsilon(2e-3));
  const double albedo =
    IntegrateSphere([&](const Vec3& d) { return scatterer.GetResponse(d); }) / Pi;
  const double moment =
    IntegrateSphere([&](const Vec3& d) { return scatterer.GetResponse(d) * d[0]; }) / Pi;
  double sum = 0.0, first = 0.0;
  constexpr int draws = 40000;
  for (std::uint32_t i = 0; i < draws; ++i)
  {
    const auto u = helios::Uniform4(1, helios::RandomStream::Scattering, 0, i);
    const Vec3 d = scatterer.Sample(
      u, [i] { return helios::Uniform4(1, helios::RandomStream::Scattering, 1, i); });
    REQUIRE(d.Norm() == Approx(1.0).epsilon(1e-12));
    const double weight = scatterer.GetResponse(d) / (Pi * scatterer.GetDensity(d));
    sum += weight / draws;
    first += weight * d[0] / draws;
  }
  CHECK(sum == Approx(albedo).epsilon(0.01));
  CHECK(first == Approx(moment).margin(0.01));
}

} // namespace

TEST_CASE("Scatterer: drawn directions have the density that is given, and conserve energy")
{
  const double specularity = GENERATE(0.0, 0.4, 1.0);
  const Scatterer surface = MakeScatterer(Scatterer::Surface, { 0.6, specularity, 12.0 });
  CheckScatterer(surface);
  Scatterer leaf = MakeScatterer(Scatterer::Leaf, { 0.45, 0.0, 12.0 });
  CheckScatterer(leaf);
  leaf.Transmittance = 0.3;
  CheckScatterer(leaf);
}

TEST_CASE("Scatterer: leaves have the albedo of reflectance and transmittance")
{
  Scatterer leaf = MakeScatterer(Scatterer::Leaf, { 0.45, 0.0, 10.0 });
  const auto getAlbedo = [&leaf]
  { return IntegrateSphere([&](const Vec3& d) { return leaf.GetResponse(d); }) / Pi; };
  CHECK(getAlbedo() == Approx(0.45).epsilon(1e-4));
  // back to the light 2/3 of a leaf that faces it
  CHECK(leaf.GetResponse(-1.0 * leaf.Incoming) == Approx(2.0 / 3.0 * 0.45));
  CHECK(leaf.GetResponse(leaf.Incoming) == Approx(0.0).margin(1e-12));
  leaf.Transmittance = 0.3;
  CHECK(getAlbedo() == Approx(0.75).epsilon(1e-4));
  CHECK(leaf.GetResponse(leaf.Incoming) == Approx(2.0 / 3.0 * 0.3));
}

TEST_CASE("Scatterer: isotropic voxels return to the scanner what the lidar equation has")
{
  const helios::SurfaceReflection reflection{ 0.2, 0.0, 10.0 };
  const Scatterer isotropic = MakeScatterer(Scatterer::Isotropic, reflection);
  CHECK(isotropic.GetResponse(-1.0 * isotropic.Incoming) ==
    Approx(helios::GetBackscatter(reflection, 1.0)).epsilon(1e-12));
  CheckScatterer(isotropic);
  CHECK(IntegrateSphere([&](const Vec3& d) { return isotropic.GetResponse(d); }) / Pi ==
    Approx(4.0 * 0.2).epsilon(1e-6));
}

TEST_CASE("Scatterer: a surface returns nothing behind it")
{
  const Scatterer surface = MakeScatterer(Scatterer::Surface, { 0.6, 0.0, 10.0 });
  CHECK(surface.GetResponse({ 0.0, 0.0, -1.0 }) == 0.0);
  CHECK(surface.GetResponse({ 0.0, 0.0, 1.0 }) == Approx(0.6));
}
