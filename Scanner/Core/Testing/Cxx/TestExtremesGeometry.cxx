// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
// Ranges, coordinates, sizes and incidences at the extremes, by whole scans: Docs/stability.md.
#include "heliosExtremeShots.h"

#include <vtkMath.h>

#include <cmath>
#include <random>
#include <string>

using helios::Vec3;
using namespace helios::testing;

namespace
{

constexpr double HalfAngle = 1.5e-4;   // w, of the default divergence
constexpr double EnergyBound = 1e-6;   // error of visible areas, relative to the beam
constexpr double Variance = 0.2373622; // variance of a beam's angle along an axis, in w^2

/// An orthonormal frame: the beam is along D.
const Vec3 D{ 0.36, 0.48, 0.8 };
const Vec3 U{ 0.8, -0.6, 0.0 };
const Vec3 V{ 0.48, 0.64, -0.6 };

std::array<Vec3, 3> GetCorners(vtkPolyData* scene, vtkIdType triangle)
{
  std::array<Vec3, 3> corners;
  for (vtkIdType i = 0; i < 3; ++i)
  {
    corners[static_cast<std::size_t>(i)] = Vec3(scene->GetPoint(3 * triangle + i));
  }
  return corners;
}

/// A large triangle at a range on the y axis, its normal at an angle from the beam.
Triangles MakePlane(double range, double degrees)
{
  const double angle = vtkMath::RadiansFromDegrees(degrees);
  const Vec3 slope(0, std::sin(angle), std::cos(angle));
  const Vec3 middle(0, range, 0);
  const double size = 30 * range;
  Triangles plane;
  plane.Add(middle - 0.7 * size * slope - Vec3(0.5 * size, 0, 0),
    middle - 0.7 * size * slope + Vec3(0.6 * size, 0, 0), middle + 1.1 * size * slope);
  return plane;
}

/// Returns what a sub-ray hits there.
TrueReturn MeetPlane(double range, double degrees, const Vec3& direction)
{
  const double angle = vtkMath::RadiansFromDegrees(degrees);
  const double cosine = std::cos(angle) * direction[1] - std::sin(angle) * direction[2];
  return { range * std::cos(angle) / cosine, cosine };
}

} // namespace

TEST_CASE("Extremes: one ray has the range of the stored numbers to 8 u R / cos, from 1 mm to "
          "10,000 km, everywhere and at any incidence",
  "[Extremes]")
{
  double worst = 0.0;
  int echoes = 0;
  for (const Vec3& place : Places)
  {
    for (double range = 1e-3; range < 2e7; range *= 10)
    {
      for (double degrees : { 0.0, 60.0, 85.0, 89.0, 89.9, 89.99, 89.999, 89.9999 })
      {
        const double angle = vtkMath::RadiansFromDegrees(degrees);
        const Vec3 slope = std::sin(angle) * D + std::cos(angle) * V;
        Triangles triangles;
        triangles.Add(range * (D - 0.7 * slope - 0.5 * U), range * (D - 0.7 * slope + 0.6 * U),
          range * (D + 1.1 * slope));
        const auto scene = triangles.GetScene(place);
        Shot shot(scene, place, D);
        shot.SetWay(Way::OneRay);
        const Real truth = GetPlaneRange(GetCorners(scene, 0), place, D);
        for (const ShotEcho& echo : shot.Fire())
        {
          const double error = static_cast<double>(std::abs(echo.Range - truth));
          worst = std::max(worst, error * std::cos(angle) / (HalfUlp * range));
          ++echoes;
        }
      }
    }
  }
  CHECK(echoes == 3 * 11 * 8);
  CHECK(worst <= 8.0);
}

TEST_CASE("Extremes: a plane that fills the beam has its echo within 1 mm and 1 %, from 1 mm to "
          "10,000 km",
  "[Extremes]")
{
  double worstRange = 0.0;
  double worstAmplitude = 0.0;
  int planes = 0;
  for (double range = 1e-3; range < 2e7; range *= 10)
  {
    for (double degrees : { 0.0, 30.0, 60.0, 80.0, 85.0, 88.0 })
    {
      const TrueReturn truth = GetFirstEcho(
        HalfAngle, [=](const Vec3& direction) { return MeetPlane(range, degrees, direction); });
      const double full = GetFull(truth.Range);
      if (truth.Power < 0.02 * full)
      {
        break; // outside of the promise, as all that are steeper
      }
      Shot shot(MakePlane(range, degrees).GetScene());
      const auto echoes = shot.Fire();
      CAPTURE(range, degrees);
      REQUIRE(echoes.size() == 1);
      // Across the beam the ranges spread over R s^2 by their curvature: its moments are neglected.
      const double curve = range * Variance * HalfAngle * HalfAngle / SigmaRange;
      const double rangeBound = 1e-3 + std::pow(curve, 3) * SigmaRange;
      const double amplitudeBound = 0.01 + 0.5 * curve * curve;
      worstRange = std::max(worstRange, std::abs(echoes[0].Range - truth.Range) / rangeBound);
      worstAmplitude = std::max(
        worstAmplitude, std::abs(echoes[0].Amplitude - truth.Power) / (full * amplitudeBound));
      ++planes;
    }
  }
  CHECK(planes > 30);
  CHECK(worstRange <= 1.0);
  CHECK(worstAmplitude <= 1.0);
}

TEST_CASE("Extremes: a grazing plane returns no more than its cosine allows", "[Extremes]")
{
  double worst = 0.0;
  for (double range : { 1e-3, 1.0, 100.0, 1e4, 1e6 })
  {
    for (double degrees : { 89.9, 89.99, 89.9999 })
    {
      for (Way way : { Way::Adaptive, Way::Circles })
      {
        Shot shot(MakePlane(range, degrees).GetScene());
        shot.SetWay(way);
        const double cosine =
          std::cos(vtkMath::RadiansFromDegrees(degrees)) + 1.5 * HalfAngle; // at the rim
        const auto echoes = shot.Fire();
        CHECK_FALSE(echoes.empty());
        for (const ShotEcho& echo : echoes)
        {
          worst = std::max(worst, echo.Amplitude / (GetFull(echo.Range) * cosine));
          REQUIRE(echo.Range > 0.0);
        }
      }
    }
  }
  CHECK(worst > 0.0);
  CHECK(worst <= 1.0);
}

TEST_CASE("Extremes: strips and discs of 1 um to 1 m have their energies to 1e-6 of the beam, from "
          "30 m to 10,000 km, everywhere",
  "[Extremes]")
{
  double worst = 0.0;
  const auto check = [&worst](Shot& shot, double range, double expected)
  {
    const auto echoes = shot.Fire();
    const double found = echoes.empty() ? 0.0 : echoes[0].Amplitude / GetFull(echoes[0].Range);
    CAPTURE(range, expected, found);
    CHECK(echoes.size() <= 1);
    CHECK((found > 0.0 || expected < 1e-11));
    constexpr double tiled = 6.4e5; // from which the beam is divided into tiles
    worst = std::max(worst, std::abs(found - expected) / (range > tiled ? 10.0 : 1.0));
    if (found > 0.0)
    {
      CHECK(std::abs(echoes[0].Range / std::hypot(1.0, 1.5 * HalfAngle) - range) < 3e-8 * range);
    }
  };
  for (const Vec3& place : Places)
  {
    for (double range : { 30.0, 4000.0, 1e5, 1e7 })
    {
      const double w = HalfAngle * range;
      for (double size : { 1e-6, 3e-3, 1.0 })
      {
        for (double off : { 0.0, 0.7, 1.49 })
        {
          Triangles strip;
          strip.AddWall(range, -0.02 * range, 0.02 * range, off * w - size / 2, off * w + size / 2);
          const auto scene = strip.GetScene(place);
          const double low = scene->GetPoint(0)[2] - place[2];
          const double high = scene->GetPoint(2)[2] - place[2];
          Shot shot(scene, place);
          check(shot, range, GetStripEnergy(low / w, high / w));
        }
        if (size < w)
        {
          Triangles disc;
          disc.AddDisc({ 0, range, 0 }, size / 2, 128);
          Shot shot(disc.GetScene(place), place);
          check(shot, range, GetDiscEnergy(size / 2 / w));
        }
      }
    }
  }
  CHECK(worst <= EnergyBound);
}

TEST_CASE("Extremes: a strip of 3 mm and a disc of 17 mm at 4 km, by visible areas and by a spiral",
  "[Extremes]")
{
  const double w = HalfAngle * 4000;
  Triangles strip;
  strip.AddWall(4000, -80, 80, -0.0015, 0.0015);
  Triangles disc;
  disc.AddDisc({ 0, 4000, 0 }, 0.0085, 128);
  const struct
  {
    const Triangles& Target;
    double Energy;
  } cases[] = { { strip, GetStripEnergy(-0.0015 / w, 0.0015 / w) },
    { disc, GetDiscEnergy(0.0085 / w) } };
  for (const auto& [target, energy] : cases)
  {
    for (bool hasGround : { false, true })
    {
      Triangles all = target;
      if (hasGround)
      {
        all.AddWall(4100, -100, 100, -100, 100);
      }
      for (Way way : { Way::Adaptive, Way::Spiral })
      {
        Shot shot(all.GetScene(Places[1]), Places[1]);
        shot.SetWay(way);
        double found = 0.0;
        for (const ShotEcho& echo : shot.Fire())
        {
          found += echo.Range < 4050 ? echo.Amplitude / GetFull(4000) : 0.0;
        }
        CAPTURE(energy, found, hasGround, way == Way::Spiral);
        // Two edges of the spiral, each 1e-3 RMS for 2416 sub-rays, falling as N^-3/4.
        const double edges = 3 * std::sqrt(2.0) * 1e-3 * std::pow(2416.0 / 4096.0, 0.75);
        CHECK(std::abs(found - energy) <= (way == Way::Spiral ? edges : EnergyBound));
      }
    }
  }
}

TEST_CASE("Extremes: a triangle of 1 um before one of 1000 km", "[Extremes]")
{
  for (const Vec3& place : Places)
  {
    for (double range : { 1.0, 10.0, 1000.0 })
    {
      Triangles triangles;
      triangles.Add({ -4e5, 1100, -3e5 }, { 6e5, 1100, -3e5 }, { 0, 1100, 6e5 });
      triangles.Add({ -5e-7, range, -4e-7 }, { 5e-7, range, -4e-7 }, { 0, range, 8e-7 });
      const auto scene = triangles.GetScene(place);
      const auto p = GetCorners(scene, 1); // rounded to 1e-9 m far from the origin
      const double area = 0.5 * (p[1] - p[0]).Cross(p[2] - p[0]).Norm();
      const double w = HalfAngle * range;
      const double energy = 2 * area / (std::acos(-1.0) * w * w * -std::expm1(-4.5));
      Shot shot(scene, place);
      const auto echoes = shot.Fire();
      CAPTURE(place[0], range, energy);
      REQUIRE(echoes.size() == 2);
      CHECK(std::abs(echoes[0].Range - range) <= 1e-12 * range);
      CHECK(echoes[0].Cell == 1);
      CHECK(echoes[0].Amplitude / GetFull(range) == Approx(energy).epsilon(3e-5));
      CHECK(std::abs(echoes[1].Amplitude / GetFull(1100) - (1 - energy)) <= EnergyBound);
      CHECK(std::abs(echoes[1].Range - 1100) < 1e-3);
    }
  }
}

TEST_CASE(
  "Extremes: the edge of a triangle of 1000 km is in place to 2 u of its size", "[Extremes]")
{
  double worst = 0.0;
  for (const Vec3& place : Places)
  {
    for (double range : { 1e-3, 1.0, 100.0, 1e4 })
    {
      for (double slope : { 0.0, 0.37, -2.3 })
      {
        const double w = HalfAngle * range;
        Triangles half;
        const Vec3 along(3e5, 0, 3e5 * slope);
        const Vec3 middle(0, range, 0.3 * w);
        half.Add(middle - along, middle + 2.0 * along, middle + Vec3(1e5, 0, 9e5));
        const auto scene = half.GetScene(place);
        const auto p = GetCorners(scene, 0);
        const Real a[2] = { Real(p[0][0]) - place[0], Real(p[0][2]) - place[2] };
        const Real b[2] = { Real(p[1][0]) - place[0], Real(p[1][2]) - place[2] };
        const Real offset = (a[1] * b[0] - a[0] * b[1]) / std::hypot(b[0] - a[0], b[1] - a[1]);
        const Real depth = Real(p[0][1]) - place[1];
        Shot shot(scene, place);
        const auto echoes = shot.Fire();
        REQUIRE(echoes.size() <= 1);
        const double found = echoes.empty() ? 0.0 : echoes[0].Amplitude / GetFull(echoes[0].Range);
        const double error = std::abs(found - GetStripEnergy(offset / (HalfAngle * depth), 1.5));
        // The intensity is at most 0.81 per w; the rest is the bound of visible areas.
        const double size = (p[1] - p[0]).Norm();
        CAPTURE(place[0], range, slope, error);
        worst = std::max(worst, error / (0.81 * 2 * HalfUlp * size / w + EnergyBound));
      }
    }
  }
  CHECK(worst <= 1.0);
}

TEST_CASE(
  "Extremes: a wall of slivers of 1e6 : 1 returns what it returns as two triangles", "[Extremes]")
{
  const Vec3 u = Vec3(1, 0.37, 0.21).Normalized();
  const Vec3 v = Vec3(-0.2, 0.61, 1).Normalized();
  double worst = 0.0;
  for (const Vec3& place : Places)
  {
    for (double width : { 1e-3, 1e-4, 1e-5 })
    {
      const int count = width > 5e-4 ? 60 : 240;
      const Vec3 half = 5e5 * width * u;
      const auto middle = [&](int i) { return Vec3(0, 100, 0) + (i - 0.5 * count) * width * v; };
      Triangles slivers;
      for (int i = 0; i < count; ++i)
      {
        slivers.AddQuad(
          middle(i) - half, middle(i) + half, middle(i + 1) + half, middle(i + 1) - half);
      }
      Triangles whole;
      whole.AddQuad(middle(0) - half, middle(0) + half, middle(count) + half, middle(count) - half);
      Shot shot(slivers.GetScene(place), place);
      Shot other(whole.GetScene(place), place);
      const auto echoes = shot.Fire();
      const auto truth = other.Fire();
      CAPTURE(place[0], width);
      REQUIRE(echoes.size() == 1);
      REQUIRE(truth.size() == 1);
      CHECK(std::abs(echoes[0].Range - truth[0].Range) < 1e-3);
      worst = std::max(
        worst, std::abs(echoes[0].Amplitude - truth[0].Amplitude) / GetFull(echoes[0].Range));
    }
  }
  CHECK(worst <= 0.01);
}

TEST_CASE(
  "Extremes: near a waist, edges along the beam have the energies of sub-rays", "[Extremes]")
{
  std::mt19937 random(1);
  std::uniform_real_distribution<double> number(0, 1);
  for (int i = 0; i < 20; ++i)
  {
    const double w = i % 2 == 0 ? 1.5e-4 : 1e-3;
    const double rayleigh = 1.064e-6 / (vtkMath::Pi() * w * w);
    const double near = rayleigh * (0.1 + number(random));
    const double far = rayleigh * (1 + 5 * number(random));
    const double waist = w * rayleigh;
    Triangles triangles;
    triangles.Add({ -waist, near, waist * (number(random) - 0.5) },
      { waist, far, waist * (number(random) - 0.5) }, { 0, 0.5 * (near + far), 30 });
    triangles.AddWall(8 * rayleigh, -50, 50, -50, 50);
    const auto scene = triangles.GetScene();
    double energies[2] = { 0, 0 };
    for (int k = 0; k < 2; ++k)
    {
      Shot shot(scene);
      shot.SetWay(k == 0 ? Way::Adaptive : Way::Spiral);
      if (k == 1)
      {
        shot.Scanner->GetBeamSampler()->SetNumberOfSubRays(65536);
      }
      shot.Scanner->GetBeamSampler()->SetBeamDivergence(2 * w);
      shot.Scanner->GetBeamSampler()->SetBeamQualityFactor(1);
      shot.Scanner->GenerateSubRaysOn();
      shot.Run();
      vtkPolyData* hits = shot.Scanner->GetOutput(3);
      for (vtkIdType hit = 0; hit < hits->GetNumberOfPoints(); ++hit)
      {
        const bool isFirst = Value(hits, vtkHeliosArrayNames::CellIds, hit) == 0.0;
        energies[k] += isFirst ? Value(hits, vtkHeliosArrayNames::Weight, hit) : 0.0;
      }
    }
    CAPTURE(w, near, far);
    CHECK(std::abs(energies[0] - energies[1]) < 5e-3);
  }
}
