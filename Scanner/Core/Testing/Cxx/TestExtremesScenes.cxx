// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
// Degenerate, coincident, crossing and countless triangles, and scanners in odd places.
#include "heliosExtremeShots.h"

#include <vtkFloatArray.h>
#include <vtkMath.h>

#include <cmath>
#include <limits>
#include <random>

using helios::Vec3;
using namespace helios::testing;

namespace
{

constexpr double HalfAngle = 1.5e-4; // w, of the default divergence
constexpr double W = 50 * HalfAngle; // at 50 m

Triangles MakeWall()
{
  Triangles wall;
  wall.AddWall(50, -50, 50, -50, 50);
  return wall;
}

/// One echo at a range, within 1 um, of a share of a full footprint, within 1e-6.
void CheckEcho(const std::vector<ShotEcho>& echoes, double range, double energy)
{
  CAPTURE(range, energy);
  REQUIRE(echoes.size() == 1);
  CHECK(std::abs(echoes[0].Range - range) < 1e-6);
  CHECK(std::abs(echoes[0].Amplitude / GetFull(range) - energy) < 1e-6);
}

/// A pulse at a scene, locally and in UTM, of an origin.
void CheckOneEcho(
  const Triangles& triangles, double range, double energy, const Vec3& origin = { 0, 0, 0 })
{
  for (const Vec3& place : { Places[0], Places[1] })
  {
    Shot shot(triangles.GetScene(place), origin + place);
    CheckEcho(shot.Fire(), range, energy);
  }
}

/// A box of half width 3 m.
Triangles MakeBox()
{
  constexpr double h = 3.0;
  Triangles box;
  const Vec3 axes[3] = { { h, 0, 0 }, { 0, h, 0 }, { 0, 0, h } };
  for (int k = 0; k < 3; ++k)
  {
    const Vec3& a = axes[(k + 1) % 3];
    const Vec3& b = axes[(k + 2) % 3];
    for (const double side : { -1.0, 1.0 })
    {
      const Vec3 c = side * axes[k];
      box.AddQuad(c - a - b, c + a - b, c + a + b, c - a + b);
    }
  }
  return box;
}

} // namespace

TEST_CASE("Extremes: coincident surfaces return what one of them returns", "[Extremes]")
{
  Triangles same = MakeWall();
  same.AddWall(50, -50, 50, -50, 50);
  CheckOneEcho(same, 50, 1);
  Triangles reversed = MakeWall();
  reversed.AddQuad({ -50, 50, 50 }, { 50, 50, 50 }, { 50, 50, -50 }, { -50, 50, -50 });
  CheckOneEcho(reversed, 50, 1);
  Triangles other = MakeWall();
  other.AddQuad({ -33.3, 50, 41.7 }, { 50.1, 50, 33.3 }, { 47.7, 50, -50.3 }, { -51.7, 50, -49.1 });
  CheckOneEcho(other, 50, 1);

  // Sloping, and coincident to rounding only, with an edge in the beam.
  const Vec3 u(1, 0.37, 0);
  const Vec3 v(0.11, 0.53, 1);
  const Vec3 c(0.001, 50, 0.002);
  Triangles one;
  one.AddQuad(c - 40.0 * u - 30.0 * v, c - 40.0 * u, c + 40.0 * u, c + 40.0 * u - 30.0 * v);
  Triangles three = one;
  three.AddQuad(c - 17.0 * u - 23.0 * v, c - 17.0 * u, c + 31.0 * u, c + 11.0 * u - 30.0 * v);
  three.AddQuad(c + 13.0 * u, c + 7.0 * u - 9.0 * v, c - 3.0 * u - 3.0 * v, c - 37.0 * u);
  Shot single(one.GetScene());
  const auto truth = single.Fire();
  REQUIRE(truth.size() == 1);
  CHECK(truth[0].Amplitude / GetFull(50) > 0.1);
  Shot shot(three.GetScene());
  const auto echoes = shot.Fire();
  REQUIRE(echoes.size() == 1); // other parts of the same surface
  CHECK(std::abs(echoes[0].Range - truth[0].Range) < 1e-5);
  CHECK(std::abs(echoes[0].Amplitude - truth[0].Amplitude) < 1e-5 * GetFull(50));
}

TEST_CASE(
  "Extremes: closed bodies and leaves with two sides hide what is behind them", "[Extremes]")
{
  // Beside the axis: a box of 3 mm by 0.1 mm, and a leaf of two triangles of opposite orientation.
  const double left = 0.2 * W;
  const double right = 0.6 * W;
  Triangles leaf = MakeWall();
  leaf.AddWall(40, left, right, -1, 1);
  leaf.AddQuad({ right, 40, -1 }, { left, 40, -1 }, { left, 40, 1 }, { right, 40, 1 });
  Triangles box = leaf;
  box.AddWall(40.0001, left, right, -1, 1);
  box.AddQuad({ left, 40, -1 }, { left, 40.0001, -1 }, { left, 40.0001, 1 }, { left, 40, 1 });
  box.AddQuad({ right, 40, -1 }, { right, 40.0001, -1 }, { right, 40.0001, 1 }, { right, 40, 1 });
  const double energy = GetStripEnergy(left / W * 50 / 40, right / W * 50 / 40);
  for (const Triangles* scene : { &leaf, &box })
  {
    Shot shot(scene->GetScene());
    const auto echoes = shot.Fire();
    REQUIRE(echoes.size() == 2);
    CHECK(std::abs(echoes[0].Amplitude / GetFull(40) - energy) < 1e-6);
    CHECK(std::abs(echoes[1].Amplitude / GetFull(50) - (1 - energy)) < 1e-6);
  }
}

TEST_CASE("Extremes: T-junctions have no gaps", "[Extremes]")
{
  for (double slope : { 0.0, 0.371 })
  {
    Triangles wall;
    const auto at = [slope](double x, double z)
    { return Vec3(x, 50 + slope * x + 1.4 * slope * z, z); };
    wall.AddQuad(at(-50, 0.001), at(50, 0.001), at(50, 50), at(-50, 50));
    for (int i = 0; i < 100; ++i)
    {
      const double x = 0.0002 * (i - 50);
      const double left = i > 0 ? x : -50;
      const double right = i < 99 ? x + 0.0002 : 50;
      wall.AddQuad(at(left, -50), at(right, -50), at(right, 0.001), at(left, 0.001));
    }
    Triangles whole;
    whole.AddQuad(at(-50, -50), at(50, -50), at(50, 50), at(-50, 50));
    wall.AddWall(160, -50, 50, -50, 50);
    Shot shot(wall.GetScene(Places[1]), Places[1]);
    Shot truth(whole.GetScene(Places[1]), Places[1]);
    const auto one = truth.Fire();
    const auto echoes = shot.Fire();
    REQUIRE(one.size() == 1);
    CAPTURE(slope);
    REQUIRE(echoes.size() == 1);
    CHECK(std::abs(echoes[0].Range - one[0].Range) < 1e-3);
    CHECK(std::abs(echoes[0].Amplitude - one[0].Amplitude) < 1e-3 * GetFull(50));
  }
}

TEST_CASE(
  "Extremes: triangles without area, and planes through the scanner, are not hit", "[Extremes]")
{
  Triangles triangles = MakeWall();
  triangles.Add({ 0, 40, 0 }, { 0, 40, 0 }, { 0, 40, 0 });
  triangles.Add({ -1, 40, 0 }, { 0, 40, 0 }, { 3, 40, 0 });
  triangles.Add({ 0, 0, 0 }, { 0, 0, 0 }, { 0, 0, 0 });
  triangles.Add({ 0, -10, 0 }, { 0, 40, 0 }, { 0, 40, 10 });    // along the axis, from behind
  triangles.Add({ -10, 10, 0 }, { 10, 40, 0 }, { 10, -10, 0 }); // across it, around the scanner
  triangles.Add({ 0, 0, 0 }, { 0.01, 40, 0.01 }, { -0.01, 40, 0.01 });
  Shot shot(triangles.GetScene());
  CheckEcho(shot.Fire(), 50, 1);
}

TEST_CASE("Extremes: a scanner inside, before, on and in the surfaces of a box", "[Extremes]")
{
  const Triangles box = MakeBox();
  CheckOneEcho(box, 3, 1);
  CheckOneEcho(box, 6, 1, { 0, -9, 0 });     // from outside
  CheckOneEcho(box, 3, 0.5, { 3, 0, 0.1 });  // in the plane of a side
  CheckOneEcho(box, 6, 0.5, { 3, -9, 0.1 }); // at an edge, from outside
  CheckOneEcho(box, 1e-3, 1, { 0, 2.999, 0 });
  Shot on(box.GetScene(), { 0, 3, 0 });
  CHECK(on.Fire().empty()); // a surface is not hit at range 0
  Shot beyond(box.GetScene(), { 0, 4, 0 });
  CHECK(beyond.Fire().empty());
}

TEST_CASE("Extremes: planes that cross in the beam show their nearer sides", "[Extremes]")
{
  // Planes y = 50 + s x for two slopes.
  const struct
  {
    double First, Second;
  } pairs[] = { { 1, -1 }, { 1, 6 }, { 0, 20 } };
  for (const auto& [first, second] : pairs)
  {
    Triangles planes;
    for (const double slope : { first, second })
    {
      const auto at = [slope](double x, double z) { return Vec3(x, 50 + slope * x, z); };
      planes.AddQuad(at(-20, -20), at(20, -20), at(20, 20), at(-20, 20));
    }
    const TrueReturn truth = GetFirstEcho(HalfAngle,
      [&, a = first, b = second](const Vec3& d)
      {
        TrueReturn nearest{ 1e300, 0 };
        for (const double slope : { a, b })
        {
          // y = 50 + s x along R d; the beam varies most along its third axis.
          const double cosine = (d[1] - slope * d[2]) / std::hypot(1.0, slope);
          const double range = 50 / (d[1] - slope * d[2]);
          if (range < nearest.Range)
          {
            nearest = { range, cosine };
          }
        }
        return nearest;
      });
    Shot shot(planes.GetScene(Places[2]), Places[2]);
    const auto echoes = shot.Fire();
    CAPTURE(first, second);
    REQUIRE(echoes.size() == 1);
    CHECK(std::abs(echoes[0].Range - truth.Range) < 1e-3);
    CHECK(std::abs(echoes[0].Amplitude - truth.Power) < 0.01 * GetFull(50));
  }
}

TEST_CASE("Extremes: the rim of the beam is sharp", "[Extremes]")
{
  for (double off : { 1.4, 1.49, 1.499, 1.4999, 1.50001, 1.6 })
  {
    Triangles beside;
    beside.AddWall(50, -10, 10, off * W, 10);
    Shot shot(beside.GetScene());
    const auto echoes = shot.Fire();
    const double found = echoes.empty() ? 0.0 : echoes[0].Amplitude / GetFull(50);
    CAPTURE(off);
    CHECK(echoes.size() == (off < 1.5 ? 1 : 0));
    CHECK(std::abs(found - GetStripEnergy(off, 1.5)) < 1e-8);
  }
}

TEST_CASE("Extremes: thousands of triangles in a beam, and a wire before them", "[Extremes]")
{
  const double energy = GetStripEnergy(-0.35 * 1.25, -0.25 * 1.25);
  for (int count : { 1, 100, 249, 250, 251, 600, 3000 })
  {
    Triangles strips;
    const double step = 4 * W / count;
    for (int i = 0; i < count; ++i)
    {
      strips.AddWall(50, -2 * W + i * step, -2 * W + (i + 1) * step, -1, 1);
    }
    Shot wall(strips.GetScene());
    const auto alone = wall.Fire();
    CAPTURE(count);
    REQUIRE(alone.size() == 1);
    CHECK(std::abs(alone[0].Range - 50) < 1e-3);
    CHECK(std::abs(alone[0].Amplitude / GetFull(50) - 1) < 0.01);
    strips.AddWall(40, -0.35 * W, -0.25 * W, -1, 1);
    Shot shot(strips.GetScene());
    const auto echoes = shot.Fire();
    REQUIRE(echoes.size() == 2);
    CHECK(std::abs(echoes[0].Range - 40) < 1e-3);
    CHECK(std::abs(echoes[0].Amplitude / GetFull(40) - energy) < 0.01);
    CHECK(std::abs(echoes[1].Amplitude / GetFull(50) - (1 - energy)) < 0.01);
  }
}

namespace
{

/// Triangles in and about a beam at a range: compact, thin, or much larger than the beam.
Triangles Scatter(unsigned seed, double range, double footprint)
{
  std::mt19937 random(seed);
  std::uniform_real_distribution<double> number(-1, 1);
  const auto vector = [&] { return Vec3(number(random), number(random), number(random)); };
  Triangles triangles;
  for (unsigned i = 0; i < 3 + seed; ++i)
  {
    const Vec3 a = Vec3(0, range, 0) +
      Vec3(1.5 * footprint * number(random), 0.05 * range * number(random),
        1.5 * footprint * number(random));
    const Vec3 b = a + footprint * vector();
    switch (i % 3)
    {
      case 0:
        triangles.Add(a, b, a + footprint * vector());
        break;
      case 1:
        triangles.Add(a, a + 5.0 * (b - a), a + 0.03 * footprint * vector());
        break;
      default:
        const double size = footprint * std::pow(10, 3 + 3 * number(random));
        triangles.Add(b, a + size * Vec3(number(random), 0.1 * number(random), number(random)),
          a + size * Vec3(number(random), 0.1 * number(random), number(random)));
    }
  }
  return triangles;
}

/// The energy of each triangle in a beam.
std::vector<double> GetEnergies(Shot& shot, std::size_t count)
{
  shot.Scanner->GenerateSubRaysOn();
  shot.Run();
  vtkPolyData* hits = shot.Scanner->GetOutput(3);
  std::vector<double> energies(count);
  for (vtkIdType i = 0; i < hits->GetNumberOfPoints(); ++i)
  {
    const auto cell = static_cast<std::size_t>(Value(hits, vtkHeliosArrayNames::CellIds, i));
    energies[cell] += Value(hits, vtkHeliosArrayNames::Weight, i);
  }
  return energies;
}

} // namespace

TEST_CASE(
  "Extremes: random scenes of any size, place and beam have the energies of 65,536 sub-rays",
  "[Extremes]")
{
  double worst = 0.0;
  for (unsigned seed = 0; seed < 18; ++seed)
  {
    const Vec3& place = Places[seed % 3];
    const double range = std::pow(10, static_cast<double>(seed % 7) - 1);  // 10 cm to 100 km
    const double w = std::pow(10, -4 + static_cast<double>(seed % 4)) * 2; // to 0.2 rad
    const Triangles triangles = Scatter(seed, range, w * range);
    const auto scene = triangles.GetScene(place);
    Shot shot(scene, place);
    Shot reference(scene, place);
    reference.SetWay(Way::Spiral);
    for (Shot* each : { &shot, &reference })
    {
      each->Scanner->GetBeamSampler()->SetBeamDivergence(2 * w);
    }
    reference.Scanner->GetBeamSampler()->SetNumberOfSubRays(65536);
    const auto found = GetEnergies(shot, triangles.All.size());
    const auto truth = GetEnergies(reference, triangles.All.size());
    CAPTURE(seed, range, w);
    CHECK(shot.Scanner->GetCount("pulsesHit") == 1);
    for (std::size_t i = 0; i < truth.size(); ++i)
    {
      worst = std::max(worst, std::abs(found[i] - truth[i]));
    }
  }
  CHECK(worst <= 5e-3); // beams of many surfaces may be sampled, too
}

TEST_CASE("Extremes: with a waist, edges beyond ten Rayleigh ranges are straight", "[Extremes]")
{
  constexpr double w = 5e-4;
  constexpr double rayleigh = 1.064e-6 / (3.14159265358979 * w * w); // 1.35 m
  std::mt19937 random(3);
  std::uniform_real_distribution<double> number(0, 1);
  double worst = 0.0;
  for (int i = 0; i < 12; ++i)
  {
    // An edge along the beam, before a wall.
    const double near = rayleigh * (10 + 10 * number(random));
    const double far = near * (1 + 9 * number(random));
    Triangles triangles;
    triangles.Add({ -w * near, near, w * near * (number(random) - 0.5) },
      { w * far, far, w * far * (number(random) - 0.5) }, { 0, 0.5 * (near + far), 30 });
    triangles.AddWall(11 * near + 1, -50, 50, -50, 50);
    const auto scene = triangles.GetScene();
    Shot shot(scene);
    Shot reference(scene);
    reference.SetWay(Way::Spiral);
    for (Shot* each : { &shot, &reference })
    {
      each->Scanner->GetBeamSampler()->SetBeamDivergence(2 * w);
      each->Scanner->GetBeamSampler()->SetBeamQualityFactor(1);
    }
    reference.Scanner->GetBeamSampler()->SetNumberOfSubRays(65536);
    const auto found = GetEnergies(shot, 3);
    const auto truth = GetEnergies(reference, 3);
    worst = std::max(worst, std::abs(found[0] - truth[0]));
  }
  CHECK(worst <= 0.01);
}

TEST_CASE("Extremes: scenes, paths and beams that cannot be computed are refused", "[Extremes]")
{
  const auto scene = MakeWall().GetScene();
  const auto expect = [](Shot& shot, const char* message)
  {
    shot.Scanner->Update();
    CAPTURE(message, shot.Log->Errors);
    CHECK(shot.Log->HasError(message));
    CHECK(shot.Scanner->GetOutput()->GetNumberOfPoints() == 0);
  };
  for (const double bad : { std::nan(""), std::numeric_limits<double>::infinity() })
  {
    vtkNew<vtkPolyData> broken;
    broken->DeepCopy(scene);
    broken->GetPoints()->SetPoint(2, 50, bad, 50);
    Shot shot(broken);
    expect(shot, "cell 0 of the scene has a corner that is not finite (point 2)");
  }
  const auto toFloats = [](vtkPolyData* data)
  {
    vtkNew<vtkPoints> points;
    points->SetDataTypeToFloat();
    points->DeepCopy(data->GetPoints());
    auto copy = vtkSmartPointer<vtkPolyData>::New();
    copy->DeepCopy(data);
    vtkNew<vtkFloatArray> floats;
    floats->SetNumberOfComponents(3);
    for (vtkIdType i = 0; i < data->GetNumberOfPoints(); ++i)
    {
      floats->InsertNextTuple(data->GetPoint(i));
    }
    copy->GetPoints()->SetData(floats);
    return copy;
  };
  {
    Shot shot(toFloats(MakeWall().GetScene(Places[1])), Places[1]);
    expect(shot,
      "the scene has float coordinates of up to 5.50005e+06 m, where they are 0.5 m apart; "
      "give it double coordinates (vtkPoints::SetDataTypeToDouble()), or subtract an "
      "offset from all inputs");
  }
  {
    Shot shot(scene);
    const auto path = toFloats(MakeWaypoints({ Places[1], Places[1] + Vec3(100, 0, 0) }));
    vtkNew<vtkDoubleArray> times;
    times->SetName(vtkHeliosArrayNames::GpsTime);
    times->InsertNextValue(0);
    times->InsertNextValue(1);
    path->GetPointData()->AddArray(times);
    shot.Scanner->SetInputData(1, path);
    expect(shot, "the trajectory has float coordinates of up to 5.5e+06 m, where they are 0.5 m");
  }
  {
    Shot shot(scene);
    shot.Log->Watch(shot.Tripod);
    shot.Log->Watch(shot.Tripod->GetExecutive());
    shot.Tripod->SetInputData(toFloats(MakeWaypoints({ Places[2] })));
    expect(shot, "the list of waypoints has float coordinates of up to 4.9e+06 m");
  }
  Shot near(toFloats(MakeWall().GetScene())); // floats are good enough near the origin,
  CHECK(near.Fire().size() == 1);
  Triangles large;
  large.AddWall(50, -1e6, 1e6, -1e6, 1e6);
  Shot wide(toFloats(large.GetScene())); // and for what is large itself
  CHECK(wide.Fire().size() == 1);
  {
    Shot shot(scene);
    shot.Scanner->GetBeamSampler()->SetBeamDivergence(1e-12);
    expect(shot, "BeamDivergence is 1e-12 rad; give at least 1e-09 rad, or 0 for one ideal ray");
  }
  {
    Shot shot(scene);
    shot.Scanner->GetBeamSampler()->SetBeamDivergence(1e-8);
    shot.Scanner->GetBeamSampler()->SetBeamQualityFactor(1);
    expect(shot,
      "BeamQualityFactor 1 and BeamDivergence 1e-08 rad make a waist of 67.7363 m radius, "
      "more than 10 m; raise the divergence, or give BeamQualityFactor 0 for a beam "
      "without a waist");
  }
}
