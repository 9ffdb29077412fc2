// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
// The scenes of BenchScannerTrade, their targets, and closed forms for three.

#ifndef heliosTradeScenes_h
#define heliosTradeScenes_h

#include "heliosBenchScenes.h"
#include "heliosConstants.h"
#include "heliosRandom.h"
#include "vtkHeliosBeamDeflector.h"
#include "vtkHeliosSyntheticScene.h"

#include <vtkMath.h>
#include <vtkObjectFactory.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <string>
#include <vector>

namespace helios::bench
{

/// Aims pulses in directions of a list, so that aiming adds no measured cost.
class ListDeflector : public vtkHeliosBeamDeflector
{
public:
  static ListDeflector* New();
  vtkTypeMacro(ListDeflector, vtkHeliosBeamDeflector);

  bool GetDirection(vtkIdType pulse, double direction[3]) const override
  {
    const Vec3& d = this->Directions[static_cast<std::size_t>(pulse) % this->Directions.size()];
    std::copy_n(d.GetData(), 3, direction);
    return true;
  }
  double GetScanAngle(vtkIdType) const override { return 0.0; }

  std::vector<Vec3> Directions;
};
vtkStandardNewMacro(ListDeflector);

/// Known values of the first echo of a pulse: NaN if unknown.
struct ClosedForm
{
  double Range = vtkMath::Nan();
  double Share = vtkMath::Nan(); // share of the amplitude of a plane across the beam at Range
};

/// A scene and a beam from From to the parallelogram at Corner, all in the scene's frame.
struct TradeScene
{
  std::string Name;
  vtkSmartPointer<vtkPolyData> Mesh;
  Vec3 Offset; // cells of the mesh
  Vec3 From, Corner, U, V;
  double Divergence;
  std::function<ClosedForm(const Vec3& direction)> Truth;
};

/// Returns rays to side * side squares of the target, line by line, at a random position within
/// each.
inline std::vector<Vec3> GetDirections(const TradeScene& scene, int side)
{
  std::vector<Vec3> directions;
  for (int pulse = 0; pulse < side * side; ++pulse)
  {
    const auto jitter = Uniform4(3, RandomStream::Scene, static_cast<std::uint64_t>(pulse), 9);
    const double u = (pulse % side + jitter[0]) / side;
    const double v = (pulse / side + jitter[1]) / side;
    const Vec3 to = scene.Corner + u * scene.U + v * scene.V;
    directions.push_back((to - scene.From).Normalized());
  }
  return directions;
}

constexpr double Truncation = 1.5;

/// E[r^2] / w^2 of a beam truncated at K.
inline double MeanSquare()
{
  const double e = std::exp(-2 * Truncation * Truncation);
  return (0.5 - e * (Truncation * Truncation + 0.5)) / (1 - e);
}

/// The energy of a truncated beam beyond a line at s w from its axis: 1 / (pi E) int exp(-2 (s /
/// cos a)^2) - e da.
inline double ShareBeyond(double s)
{
  if (s < 0)
  {
    return 1 - ShareBeyond(-s);
  }
  const double e = std::exp(-2 * Truncation * Truncation);
  const double end = std::acos(std::min(1.0, s / Truncation));
  double sum = 0;
  constexpr int steps = 200;
  for (int i = 0; i < steps; ++i)
  {
    const double r = s / std::cos(end * (i + 0.5) / steps);
    sum += std::exp(-2 * r * r) - e;
  }
  return sum * end / steps / ((1 - e) * vtkMath::Pi());
}

/// The bare triangles of a synthetic scene.
template <typename SetUp>
vtkSmartPointer<vtkPolyData> MakeMesh(SetUp setUp)
{
  vtkNew<vtkHeliosSyntheticScene> maker;
  setUp(maker.Get());
  maker->Update();
  auto mesh = vtkSmartPointer<vtkPolyData>::New();
  mesh->SetPoints(maker->GetOutput()->GetPoints());
  mesh->SetPolys(maker->GetOutput()->GetPolys());
  return mesh;
}

/// A plane from 100 m above: incidences of 3 to 75 degrees, footprints of 0.1 to 0.4 m across.
inline TradeScene MakePlaneScene()
{
  const auto mesh = MakeMesh(
    [](vtkHeliosSyntheticScene* maker)
    {
      maker->SetKindToPlane();
      maker->SetSize(2000);
    });
  const double divergence = 1e-3;
  const auto truth = [divergence](const Vec3& d)
  {
    const double variance = 0.5 * MeanSquare() * 0.25 * divergence * divergence;
    const double range = 100 / -d[2];
    const double tan2 = 1 / (d[2] * d[2]) - 1;
    const double sigma = 0.5 * SpeedOfLight * 4 / 2.35482004503095; // [m]
    const double widening = range * range * tan2 * variance / (sigma * sigma);
    ClosedForm form; // to first order in the widening: for narrow footprints only
    if (widening < 0.01)
    {
      form.Range = range * (1 + variance * (1 - 2 * tan2));
      form.Share = -d[2] / std::sqrt(1 + widening);
    }
    return form;
  };
  return { "plane", mesh, {}, { 0, 0, 100 }, { 5, -20, 0 }, { 365, 0, 0 }, { 0, 40, 0 }, divergence,
    truth };
}

/// The edge of a 10 m step, from 150 m above it.
inline TradeScene MakeStepScene()
{
  const auto mesh = MakeMesh([](vtkHeliosSyntheticScene* maker) { maker->SetKindToStep(); });
  const Vec3 from(0.3, 0, 150);
  const double divergence = 1e-3;
  const auto truth = [from, divergence](const Vec3& d)
  {
    const Vec3 toEdge = Vec3(0, 0, 10) - from;
    const Vec3 normal =
      toEdge.Cross(Vec3(0, 1, 0)).Normalized(); // normal of the plane of scanner and edge
    const double s = std::asin(normal.Dot(d)) / (0.5 * divergence);
    const double upper = ShareBeyond(normal[0] > 0 ? -s : s);
    ClosedForm form;
    if (upper > 0.05)
    {
      form.Range = (from[2] - 10) / -d[2];
      form.Share = upper * -d[2];
    }
    return form;
  };
  return { "step", mesh, {}, from, { -0.6, -20, 10 }, { 1.2, 0, 0 }, { 0, 40, 0 }, divergence,
    truth };
}

/// A sphere of 5 m radius, 20,480 triangles, from 50 m, near its rim.
inline TradeScene MakeSphereScene()
{
  const auto mesh = MakeMesh([](vtkHeliosSyntheticScene* maker) { maker->SetKindToSphere(); });
  const Vec3 from(0, -50, 0);
  const auto truth = [from](const Vec3& d)
  {
    const double across = (from - from.Dot(d) * d).Norm();
    ClosedForm form;
    if (across < 3.5)
    {
      form.Range = -from.Dot(d) - std::sqrt(25 - across * across);
    }
    return form;
  };
  return { "sphere", mesh, {}, from, { -5.2, 0, -5.2 }, { 10.4, 0, 0 }, { 0, 0, 10.4 }, 1e-3,
    truth };
}

/// A pyramid of 10 m, faces of 10^2 triangles each, from 60 m obliquely above.
inline TradeScene MakePyramidScene()
{
  const auto mesh = MakeMesh(
    [](vtkHeliosSyntheticScene* maker)
    {
      maker->SetKindToPyramid();
      maker->SetResolution(10);
    });
  return { "pyramid", mesh, {}, { 20, -50, 30 }, { -6, 0, -0.5 }, { 12, 0, 0 }, { 0, 0, 11 }, 1e-3,
    {} };
}

/// The canopy from an aircraft: footprints of 0.24 m on leaves of 5 to 10 cm.
inline TradeScene MakeCanopyScene()
{
  return { "canopy", MakeBenchCanopy(), BenchOffset, { 100, 55, 800 }, { 80, 60, 0 }, { 40, 0, 0 },
    { 0, 40, 0 }, 0.3e-3, {} };
}

/// Hills from an aircraft: footprints of 0.18 m on triangles of 1 m.
inline TradeScene MakeTerrainScene()
{
  return { "terrain", MakeBenchTerrain(), BenchOffset, { 500, 450, 600 }, { 350, 430, 0 },
    { 300, 0, 0 }, { 0, 40, 0 }, 0.3e-3, {} };
}

/// Crowns of leaves of 5 to 11 cm, two triangles each, above hills from 400 m: footprints of 0.3 m.
inline TradeScene MakeStandScene()
{
  BenchScene scene;
  scene.AddHills(60, 30.0);
  constexpr std::uint64_t leaves = 90000;
  for (std::uint64_t i = 0; i < leaves; ++i)
  {
    const auto r = Uniform4(11, RandomStream::Scene, i, 0);
    const auto s = Uniform4(11, RandomStream::Scene, i, 1);
    const auto tree = static_cast<double>(i % 9);
    const double turn = 2 * vtkMath::Pi() * r[0];
    const double out = 3.0 * std::sqrt(r[1]);
    const double x = 5 + 10 * std::fmod(tree, 3.0) + out * std::cos(turn);
    const double y = 5 + 10 * std::floor(tree / 3.0) + out * std::sin(turn);
    const double z = GetHillHeight(x, y) + 4 + 8 * r[2];
    const double tilt = vtkMath::Pi() * (s[0] - 0.5);
    const double around = 2 * vtkMath::Pi() * s[1];
    const double half = 0.025 + 0.03 * s[2];
    const Vec3 along(std::cos(around), std::sin(around), 0);
    const Vec3 across(
      -std::sin(around) * std::cos(tilt), std::cos(around) * std::cos(tilt), std::sin(tilt));
    scene.AddQuad({ x, y, z }, half * along, half * across);
  }
  return { "stand", scene.Finish(), BenchOffset, { 40, 15, 400 }, { 2, 2, 5 }, { 26, 0, 0 },
    { 0, 26, 0 }, 0.5e-3, {} };
}

/// Wires of 4 to 12 mm every 10 cm, 2 m before a wall, from 60 m.
inline TradeScene MakeWiresScene()
{
  BenchScene scene;
  scene.AddQuad({ 0, 62, 0 }, { 20, 0, 0 }, { 0, 0, 20 });
  for (int i = -20; i <= 20; ++i)
  {
    const double half = 0.002 + 0.001 * std::abs(i % 5);
    scene.AddQuad({ 0.1 * i, 60, 0 }, { half, 0, 0 }, { 0, 0, 2 });
  }
  return { "wires", scene.Finish(), BenchOffset, { 0.3, 0, 0.2 }, { -1.5, 60, -1.5 }, { 3, 0, 0 },
    { 0, 0, 3 }, 0.5e-3, {} };
}

} // namespace helios::bench

#endif
