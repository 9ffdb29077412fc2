// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
#include "heliosBeamEnergy.h"
#include "heliosPolygon.h"

#include <catch2/catch.hpp>

#include <cmath>
#include <random>
#include <vector>

using helios::BeamEnergy;
using helios::EnergyMoments;
using helios::HalfPlane;
using helios::Polygon;

namespace
{

Polygon MakePolygon(const std::vector<std::pair<double, double>>& corners)
{
  Polygon p;
  for (const auto& [x, y] : corners)
  {
    p.Add(x, y);
  }
  return p;
}

Polygon MakeSquare(double half)
{
  return MakePolygon({ { -half, -half }, { half, -half }, { half, half }, { -half, half } });
}

/// The moments by the midpoint rule on a fine grid, with the intensity by its definition.
EnergyMoments Count(const Polygon& p, double w, double truncation)
{
  const double tangent = std::tan(w * truncation);
  constexpr int cells = 3000;
  EnergyMoments sum;
  double all = 0.0;
  for (int i = 0; i < cells; ++i)
  {
    for (int j = 0; j < cells; ++j)
    {
      const double x = -1.0 + (i + 0.5) * 2.0 / cells;
      const double y = -1.0 + (j + 0.5) * 2.0 / cells;
      const double r = std::hypot(x, y);
      if (r > 1.0)
      {
        continue;
      }
      // The energy between two angles is spread over the ring between them.
      const double theta = std::atan(r * tangent);
      const double f = std::exp(-2.0 * theta * theta / (w * w)) * theta / r * tangent /
        (1.0 + r * r * tangent * tangent);
      all += f;
      bool isInside = true;
      for (int edge = 0; edge < p.Size; ++edge)
      {
        isInside = isInside && p.GetInside(edge)(x, y) >= 0.0;
      }
      if (isInside)
      {
        EnergyMoments at;
        at.Energy = f;
        at.X = x * f;
        at.Y = y * f;
        at.XX = x * x * f;
        at.XY = x * y * f;
        at.YY = y * y * f;
        sum.Add(at);
      }
    }
  }
  return { sum.Energy / all, sum.X / all, sum.Y / all, sum.XX / all, sum.XY / all, sum.YY / all };
}

} // namespace

TEST_CASE("The energy in a polygon of a beam is its integral")
{
  const double truncation = GENERATE(1.0, 1.5, 2.5);
  const double w = GENERATE(1e-4, 0.2);
  CAPTURE(truncation, w);
  const BeamEnergy beam(w, truncation);
  CHECK(beam.GetTangent() == Approx(std::tan(w * truncation)));

  SECTION("The whole beam has an energy of 1, centred on the axis")
  {
    for (const double half : { 1.0, 1.5, 1000.0 })
    {
      const EnergyMoments all = beam.Integrate(MakeSquare(half));
      CHECK(all.Energy == Approx(1.0).epsilon(1e-6));
      CHECK(std::abs(all.X) < 1e-12);
      CHECK(std::abs(all.Y) < 1e-12);
    }
  }
  SECTION("A side of a line through the axis has half of it")
  {
    const Polygon p = Clip(MakeSquare(3.0), HalfPlane{ 0.3, -0.7, 0.0 });
    CHECK(beam.Integrate(p).Energy == Approx(0.5).epsilon(1e-6));
  }
  SECTION("Other polygons agree with a count of points")
  {
    const std::vector<Polygon> polygons = {
      MakePolygon({ { 0.1, 0.2 }, { 0.9, 0.1 }, { 0.4, 0.8 } }),
      MakePolygon({ { -3.0, 0.3 }, { 4.0, -0.2 }, { 0.0, 5.0 } }),
      MakePolygon({ { -0.9, -0.9 }, { 0.5, -0.9 }, { 0.7, 0.6 }, { -0.2, 0.7 } }),
      Clip(MakeSquare(0.3), HalfPlane{ 1.0, 1.0, 0.1 }),
    };
    for (const Polygon& p : polygons)
    {
      const EnergyMoments got = beam.Integrate(p);
      const EnergyMoments expected = Count(p, w, truncation);
      CHECK(std::abs(got.Energy - expected.Energy) < 1e-3);
      const double margin = w < 0.1 ? 1e-3 : 0.02; // wide beams: of a Gaussian in r
      CHECK(std::abs(got.X - expected.X) < margin);
      CHECK(std::abs(got.Y - expected.Y) < margin);
      CHECK(std::abs(got.XX - expected.XX) < margin);
      CHECK(std::abs(got.XY - expected.XY) < margin);
      CHECK(std::abs(got.YY - expected.YY) < margin);
    }
  }
}

TEST_CASE("The energies of the parts of a polygon add up to its energy")
{
  const BeamEnergy beam(1.5e-4, 1.5);
  std::mt19937 random(1);
  std::uniform_real_distribution<double> number(-1.0, 1.0);
  for (int trial = 0; trial < 1000; ++trial)
  {
    const double radius = std::pow(10.0, 2.0 * number(random) - 1.0);
    const double x = number(random);
    const double y = number(random);
    Polygon p;
    for (int i = 0; i < 5; ++i)
    {
      p.Add(x + radius * std::cos(1.2566 * i), y + radius * std::sin(1.2566 * i));
    }
    const double a = number(random);
    const double b = number(random);
    const HalfPlane side{ a, b, -(a * x + b * y) + 0.3 * radius * number(random) };
    const EnergyMoments all = beam.Integrate(p);
    EnergyMoments sum = beam.Integrate(Clip(p, side));
    sum.Add(beam.Integrate(Clip(p, side.GetOpposite())));
    CHECK(std::abs(sum.Energy - all.Energy) < 2e-6);
    CHECK(std::abs(sum.X - all.X) < 2e-6);
    CHECK(std::abs(sum.Y - all.Y) < 2e-6);
    CHECK(std::abs(sum.XX - all.XX) < 2e-6);
    CHECK(std::abs(sum.XY - all.XY) < 2e-6);
    CHECK(std::abs(sum.YY - all.YY) < 2e-6);
  }
}

TEST_CASE("Small polygons have the energies of the large one that they fill")
{
  const BeamEnergy beam(1.5e-4, 1.5);
  constexpr int cells = 40;
  EnergyMoments sum;
  for (int i = 0; i < cells; ++i)
  {
    for (int j = 0; j < cells; ++j)
    {
      const double x = -0.2 + 0.5 * i / cells;
      const double y = 0.1 + 0.5 * j / cells;
      const double step = 0.5 / cells;
      sum.Add(beam.Integrate(
        MakePolygon({ { x, y }, { x + step, y }, { x + step, y + step }, { x, y + step } })));
    }
  }
  const EnergyMoments whole =
    beam.Integrate(MakePolygon({ { -0.2, 0.1 }, { 0.3, 0.1 }, { 0.3, 0.6 }, { -0.2, 0.6 } }));
  CHECK(sum.Energy == Approx(whole.Energy).epsilon(2e-5));
  CHECK(sum.X == Approx(whole.X).epsilon(1e-4));
  CHECK(sum.Y == Approx(whole.Y).epsilon(2e-5));
  CHECK(sum.XX == Approx(whole.XX).epsilon(1e-4));
  CHECK(sum.XY == Approx(whole.XY).epsilon(1e-4));
  CHECK(sum.YY == Approx(whole.YY).epsilon(1e-4));
}

TEST_CASE("Small polygons err by no more than is allowed")
{
  const BeamEnergy exact(1.5e-4, 1.5, 1e-12);
  for (const double error : { 1e-7, 1e-6, 1e-5, 3e-5 })
  {
    const BeamEnergy beam(1.5e-4, 1.5, error);
    std::mt19937 random(1);
    std::uniform_real_distribution<double> number(-1.0, 1.0);
    double largest = 0.0;
    double least = 1.0; // smallest of energies
    for (int trial = 0; trial < 20000; ++trial)
    {
      const double radius = 0.4 * std::abs(number(random));
      const double flatness = std::abs(number(random));
      const int corners = 3 + trial % 4;
      const double x = 0.8 * number(random);
      const double y = 0.8 * number(random);
      Polygon p;
      for (int i = 0; i < corners; ++i)
      {
        const double angle = 2.0 * 3.14159265358979 * i / corners;
        p.Add(x + radius * std::cos(angle), y + radius * flatness * std::sin(angle));
      }
      const double got = beam.Integrate(p).Energy;
      largest = std::max(largest, std::abs(got - exact.Integrate(p).Energy));
      least = std::min(least, got);
    }
    CAPTURE(error);
    CHECK(largest < error);
    CHECK(largest > 0.1 * error); // the bound is no waste
    CHECK(least > -error);
  }
}
