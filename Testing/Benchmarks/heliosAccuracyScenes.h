// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
// Scenes on which the accuracy of echoes is measured: thin, sparse, rough and far surfaces.

#ifndef heliosAccuracyScenes_h
#define heliosAccuracyScenes_h

#include "heliosTradeScenes.h"

#include "vtkHeliosCropFieldSource.h"

#include <cstdint>
#include <vector>

namespace helios::bench
{

/// Numbers in [0, 1) for an item of a scene.
inline std::array<double, 4> Draw(std::uint64_t item, std::uint32_t stream = 0)
{
  return Uniform4(11, RandomStream::Scene, item, stream);
}

/// A random unit vector.
inline Vec3 DrawDirection(std::uint64_t item, std::uint32_t stream)
{
  const auto r = Draw(item, stream);
  const double z = 2 * r[0] - 1;
  const double s = std::sqrt(1 - z * z);
  const double turn = 2 * vtkMath::Pi() * r[1];
  return { s * std::cos(turn), s * std::sin(turn), z };
}

/// A cylinder of eight sides without ends.
inline void AddCylinder(BenchScene& scene, const Vec3& from, const Vec3& to, double radius)
{
  const Vec3 axis = (to - from).Normalized();
  const Vec3 u = axis.Cross(std::abs(axis[2]) < 0.9 ? Vec3(0, 0, 1) : Vec3(1, 0, 0)).Normalized();
  const Vec3 v = axis.Cross(u);
  constexpr int sides = 8;
  std::vector<vtkIdType> ring;
  for (int i = 0; i < sides; ++i)
  {
    const double turn = 2 * vtkMath::Pi() * i / sides;
    const Vec3 out = radius * (std::cos(turn) * u + std::sin(turn) * v);
    ring.push_back(scene.AddPoint(from + out));
    scene.AddPoint(to + out);
  }
  for (std::size_t i = 0; i < ring.size(); ++i)
  {
    const vtkIdType a = ring[i];
    const vtkIdType b = ring[(i + 1) % ring.size()];
    scene.AddTriangle(a, b, b + 1);
    scene.AddTriangle(a, b + 1, a + 1);
  }
}

/// A hexagon of four triangles.
inline void AddDisc(BenchScene& scene, const Vec3& centre, const Vec3& normal, double radius)
{
  const Vec3 u =
    normal.Cross(std::abs(normal[2]) < 0.9 ? Vec3(0, 0, 1) : Vec3(1, 0, 0)).Normalized();
  const Vec3 v = normal.Cross(u);
  vtkIdType first = 0;
  for (int i = 0; i < 6; ++i)
  {
    const double turn = vtkMath::Pi() / 3 * i;
    const vtkIdType id =
      scene.AddPoint(centre + radius * (std::cos(turn) * u + std::sin(turn) * v));
    first = i == 0 ? id : first;
  }
  for (vtkIdType i = 1; i < 5; ++i)
  {
    scene.AddTriangle(first, first + i, first + i + 1);
  }
}

/// A stone: an octahedron, each face of which is divided in four, with random radii.
inline void AddStone(BenchScene& scene, const Vec3& centre, double radius, std::uint64_t item)
{
  const Vec3 axes[6] = { { 1, 0, 0 }, { -1, 0, 0 }, { 0, 1, 0 }, { 0, -1, 0 }, { 0, 0, 1 },
    { 0, 0, -1 } };
  std::uint32_t next = 10;
  const auto add = [&](const Vec3& direction)
  {
    const double r = radius * (0.7 + 0.3 * Draw(item, next++)[0]);
    return scene.AddPoint(centre + r * direction.Normalized());
  };
  vtkIdType tips[6], middles[6][6];
  for (int i = 0; i < 6; ++i)
  {
    tips[i] = add(axes[i]);
  }
  for (int i = 0; i < 6; ++i)
  {
    for (int j = i + 1; j < 6; ++j)
    {
      if (i / 2 != j / 2)
      {
        middles[i][j] = middles[j][i] = add(axes[i] + axes[j]);
      }
    }
  }
  for (int x = 0; x < 2; ++x)
  {
    for (int y = 2; y < 4; ++y)
    {
      for (int z = 4; z < 6; ++z)
      {
        const vtkIdType a = middles[x][y];
        const vtkIdType b = middles[y][z];
        const vtkIdType c = middles[z][x];
        scene.AddTriangle(a, b, c);
        scene.AddTriangle(tips[x], a, c);
        scene.AddTriangle(tips[y], b, a);
        scene.AddTriangle(tips[z], c, b);
      }
    }
  }
}

/// Wires of 5 mm every 4 cm, 0.4 m before a wall, from 25 m.
inline TradeScene MakeFenceScene()
{
  BenchScene scene;
  scene.AddQuad({ 0, 25.4, 0 }, { 20, 0, 0 }, { 0, 0, 20 });
  for (int i = -50; i <= 50; ++i)
  {
    const double s = 0.04 * i;
    AddCylinder(scene, { s, 25, -2 }, { s, 25, 2 }, 0.0025);
    AddCylinder(scene, { -2, 25.006, s }, { 2, 25.006, s }, 0.0025);
  }
  return { "fence", scene.Finish(), BenchOffset, { 0.3, 0, 0.2 }, { -1.5, 25, -1.5 }, { 3, 0, 0 },
    { 0, 0, 3 }, 0.35e-3, {} };
}

/// Stones of 4 to 40 mm on a plane, from a tripod of 1.7 m, at 2 to 18 m.
inline TradeScene MakeGravelScene()
{
  BenchScene scene;
  scene.AddQuad({ 0, 10, 0 }, { 5, 0, 0 }, { 0, 12, 0 });
  for (std::uint64_t i = 0; i < 40000; ++i)
  {
    const auto place = Draw(i);
    const double radius = 0.002 * std::pow(10.0, place[2]);
    AddStone(scene, { 1.5 * (2 * place[0] - 1), 2 + 16 * place[1], 0.5 * radius }, radius, i);
  }
  return { "gravel", scene.Finish(), BenchOffset, { 0, 0, 1.7 }, { -0.15, 2, 0 }, { 0.3, 0, 0 },
    { 0, 16, 0 }, 0.5e-3, {} };
}

/// Conductors of 25 mm over hills, from 500 m above.
inline TradeScene MakePowerLineScene()
{
  BenchScene scene;
  scene.AddHills(400, 200.0);
  for (int wire = 0; wire < 4; ++wire)
  {
    for (int i = 0; i < 40; ++i)
    {
      const auto at = [wire](int k)
      {
        const double x = 5.0 * k;
        const double sag = 1e-3 * (x - 100) * (x - 100);
        return Vec3(x, 97 + 2.0 * wire, 25 + sag + 0.5 * wire);
      };
      AddCylinder(scene, at(i), at(i + 1), 0.0125);
    }
  }
  return { "line", scene.Finish(), BenchOffset, { 90, 60, 500 }, { 40, 97, 28 }, { 100, 0, 0 },
    { 0, 6, 0 }, 0.35e-3, {} };
}

/// Roofs of different slopes, with eaves of 0.4 m, from 1200 m obliquely.
inline TradeScene MakeRoofScene()
{
  BenchScene scene;
  scene.AddHills(100, 400.0);
  for (std::uint64_t house = 0; house < 100; ++house)
  {
    const auto r = Draw(house);
    const Vec3 centre(20 + 36 * static_cast<double>(house % 10),
      20 + 36 * static_cast<double>(house / 10), 20 + 3 * r[0]);
    const double turn = vtkMath::Pi() * r[1];
    const Vec3 along(6 * std::cos(turn), 6 * std::sin(turn), 0);
    const Vec3 across(-4 * std::sin(turn), 4 * std::cos(turn), 0);
    const double rise = 1 + 3 * r[2];
    scene.AddQuad(centre + 0.5 * across, along, 0.5 * across - Vec3(0, 0, 0.5 * rise));
    scene.AddQuad(centre - 0.5 * across, along, 0.5 * across + Vec3(0, 0, 0.5 * rise));
    for (const double side : { -0.9, 0.9 })
    {
      const Vec3 wall = centre + side * across - Vec3(0, 0, 5 + 0.4 * rise);
      scene.AddQuad(wall, along, Vec3(0, 0, 5));
    }
  }
  return { "roofs", scene.Finish(), BenchOffset, { 500, 100, 1200 }, { 20, 20, 20 }, { 320, 0, 0 },
    { 0, 320, 0 }, 0.5e-3, {} };
}

/// Leaf discs of 2.5 cm between 2 and 9 m above hills, leaf area index 0.6, from 450 m.
inline TradeScene MakeLeavesScene()
{
  BenchScene scene;
  scene.AddHills(60, 30.0);
  constexpr double radius = 0.0125;
  const auto count =
    static_cast<std::uint64_t>(0.6 * 900 / (1.5 * std::sqrt(3.0) * radius * radius));
  for (std::uint64_t i = 0; i < count; ++i)
  {
    const auto r = Draw(i);
    const double x = 30 * r[0];
    const double y = 30 * r[1];
    AddDisc(scene, { x, y, GetHillHeight(x, y) + 2 + 7 * r[2] }, DrawDirection(i, 1), radius);
  }
  return { "leaves", scene.Finish(), BenchOffset, { 40, 15, 450 }, { 8, 8, 5 }, { 14, 0, 0 },
    { 0, 14, 0 }, 0.3e-3, {} };
}

/// Rows of maize from a mast.
inline TradeScene MakeCropScene()
{
  vtkNew<vtkHeliosCropFieldSource> maker;
  maker->SetNumberOfRows(12);
  maker->SetRowLength(9.0);
  maker->Update();
  auto mesh = vtkSmartPointer<vtkPolyData>::New();
  mesh->SetPoints(maker->GetOutput()->GetPoints());
  mesh->SetPolys(maker->GetOutput()->GetPolys());
  double b[6];
  mesh->GetBounds(b);
  const Vec3 middle(0.5 * (b[0] + b[1]), 0.5 * (b[2] + b[3]), 0.5);
  return { "crop", mesh, {}, middle + Vec3(-25, 5, 12), middle - Vec3(2, 2, 0), { 4, 0, 0 },
    { 0, 4, 0 }, 0.5e-3, {} };
}

/// One broadleaf tree, from a tripod.
inline TradeScene MakeTreeScene()
{
  const auto mesh = MakeMesh([](vtkHeliosSyntheticScene* maker) { maker->SetKindToTree(); });
  double b[6];
  mesh->GetBounds(b);
  const Vec3 middle(0.5 * (b[0] + b[1]), 0.5 * (b[2] + b[3]), 0.6 * b[5]);
  return { "tree", mesh, {}, middle + Vec3(-30, -40, -3), middle - Vec3(2, 0, 2), { 4, 0, 0 },
    { 0, 0, 4 }, 0.35e-3, {} };
}

inline std::vector<TradeScene> MakeAccuracyScenes()
{
  return { MakeFenceScene(), MakeGravelScene(), MakePowerLineScene(), MakeRoofScene(),
    MakeLeavesScene(), MakeCropScene(), MakeTreeScene() };
}

} // namespace helios::bench

#endif
