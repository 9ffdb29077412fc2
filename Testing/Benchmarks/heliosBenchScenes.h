// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
// Large scenes and the rays of scanners over them, made in code.

#ifndef heliosBenchScenes_h
#define heliosBenchScenes_h

#include "heliosPose.h"
#include "heliosRandom.h"
#include "vtkHeliosRayCaster.h"

#include <vtkCellArray.h>
#include <vtkNew.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>
#include <vtkSmartPointer.h>

#include <cmath>
#include <cstdint>
#include <vector>

namespace helios
{

/// Position of the scenes: UTM.
inline const Vec3 BenchOffset(5e5, 5.5e6, 300);

/// The height of the hills at a position.
inline double GetHillHeight(double x, double y)
{
  return 8 * std::sin(0.011 * x) * std::cos(0.013 * y) + 2 * std::sin(0.05 * x + 0.03 * y) +
    0.3 * std::sin(0.31 * x) * std::sin(0.37 * y) + 0.05 * std::sin(1.7 * x + 2.3 * y);
}

/// A scene with preallocated points and triangles, moved to BenchOffset.
class BenchScene
{
public:
  BenchScene()
  {
    this->Points->SetDataType(VTK_DOUBLE);
    this->Polys->Use32BitStorage();
  }

  vtkIdType AddPoint(const Vec3& p)
  {
    const Vec3 moved = p + BenchOffset;
    return this->Points->InsertNextPoint(moved.GetData());
  }
  void AddTriangle(vtkIdType a, vtkIdType b, vtkIdType c)
  {
    this->Polys->InsertNextCell({ a, b, c });
  }
  void AddQuad(const Vec3& centre, const Vec3& u, const Vec3& v)
  {
    const vtkIdType a = this->AddPoint(centre - u - v);
    this->AddPoint(centre + u - v);
    this->AddPoint(centre + u + v);
    this->AddPoint(centre - u + v);
    this->AddTriangle(a, a + 1, a + 2);
    this->AddTriangle(a, a + 2, a + 3);
  }
  /// Hills over [0, width]^2, cells x cells squares of two triangles each.
  void AddHills(vtkIdType cells, double width)
  {
    const double step = width / static_cast<double>(cells);
    for (vtkIdType j = 0; j <= cells; ++j)
    {
      for (vtkIdType i = 0; i <= cells; ++i)
      {
        const double x = step * static_cast<double>(i);
        const double y = step * static_cast<double>(j);
        this->AddPoint({ x, y, GetHillHeight(x, y) });
      }
    }
    for (vtkIdType j = 0; j < cells; ++j)
    {
      for (vtkIdType i = 0; i < cells; ++i)
      {
        const vtkIdType a = j * (cells + 1) + i;
        this->AddTriangle(a, a + 1, a + cells + 2);
        this->AddTriangle(a, a + cells + 2, a + cells + 1);
      }
    }
  }
  vtkSmartPointer<vtkPolyData> Finish()
  {
    this->Points->Squeeze();
    this->Polys->Squeeze();
    auto scene = vtkSmartPointer<vtkPolyData>::New();
    scene->SetPoints(this->Points);
    scene->SetPolys(this->Polys);
    return scene;
  }

private:
  vtkNew<vtkPoints> Points;
  vtkNew<vtkCellArray> Polys;
};

/// 2 M triangles: hills over 1 km x 1 km.
inline vtkSmartPointer<vtkPolyData> MakeBenchTerrain()
{
  BenchScene scene;
  scene.AddHills(1000, 1000.0);
  return scene.Finish();
}

/// 984 k triangles: hills over 200 m x 200 m, and 200 trees of 2250 leaves of 5 to 10 cm each.
inline vtkSmartPointer<vtkPolyData> MakeBenchCanopy()
{
  BenchScene scene;
  scene.AddHills(205, 200.0);
  std::uint64_t item = 0;
  for (int tree = 0; tree < 200; ++tree)
  {
    const auto place = Uniform4(1, RandomStream::Scene, item++, 0);
    const double x = 5 + 190 * place[0];
    const double y = 5 + 190 * place[1];
    const double radius = 1.5 + 2 * place[2];
    const Vec3 crown(x, y, GetHillHeight(x, y) + 5 + 4 * place[3] + radius);
    for (int leaf = 0; leaf < 2250; ++leaf, ++item)
    {
      const auto a = Uniform4(1, RandomStream::Scene, item, 0);
      const auto b = Uniform4(1, RandomStream::Scene, item, 1);
      // Denser towards the outside, like crowns.
      const double r = radius * std::cbrt(0.1 + 0.9 * a[0]);
      const double z = 2 * a[1] - 1;
      const double s = std::sqrt(1 - z * z);
      const double turn = 2 * vtkMath::Pi() * a[2];
      const Vec3 centre = crown + Vec3(s * std::cos(turn), s * std::sin(turn), 1.3 * z) * r;
      const Vec3 u = Vec3(b[0] - 0.5, b[1] - 0.5, b[2] - 0.5).Normalized();
      const Vec3 v = u.Cross(Vec3(b[1] - 0.5, b[3] - 0.5, a[3] - 0.5).Normalized()).Normalized();
      const double size = 0.025 + 0.025 * a[3];
      scene.AddQuad(centre, u * size, v * (0.6 * size));
    }
  }
  return scene.Finish();
}

/// Pulses of a scanner, each as sub-rays within a cone: the centre, then rings of 6, 12, 18 ...
inline void AddPulse(
  std::vector<vtkHeliosRay>& rays, const Vec3& origin, const Vec3& direction, int rings)
{
  const Vec3 p = origin + BenchOffset;
  const Vec3 side(std::abs(direction[2]) < 0.9 ? Vec3(0, 0, 1) : Vec3(1, 0, 0));
  const Vec3 u = direction.Cross(side).Normalized();
  const Vec3 v = direction.Cross(u);
  for (int ring = 0; ring < rings; ++ring)
  {
    const int count = ring == 0 ? 1 : 6 * ring;
    for (int i = 0; i < count; ++i)
    {
      const double turn = 2 * vtkMath::Pi() * i / count;
      const double slope = 0.3e-3 * ring / std::max(1, rings - 1);
      const Vec3 d =
        (direction + u * (slope * std::cos(turn)) + v * (slope * std::sin(turn))).Normalized();
      rays.push_back({ { p[0], p[1], p[2] }, { d[0], d[1], d[2] } });
    }
  }
}

/// A tripod at the centre of a scene of a width: lines from -60 to +40 deg, 360 deg around.
inline std::vector<vtkHeliosRay> MakeTripodRays(double width, int pulses, int rings)
{
  std::vector<vtkHeliosRay> rays;
  const int perLine = static_cast<int>(std::sqrt(pulses / 2.0));
  const Vec3 origin(
    0.503 * width, 0.497 * width, GetHillHeight(0.503 * width, 0.497 * width) + 2.0);
  for (int i = 0; i < pulses; ++i)
  {
    const double elevation = vtkMath::RadiansFromDegrees(-60.0 + 100.0 * (i % perLine) / perLine);
    const double azimuth = 2 * vtkMath::Pi() * i / pulses;
    AddPulse(rays, origin,
      { std::cos(elevation) * std::sin(azimuth), std::cos(elevation) * std::cos(azimuth),
        std::sin(elevation) },
      rings);
  }
  return rays;
}

/// An aircraft over the centre of a scene of a width: lines across, as wide as the scene.
inline std::vector<vtkHeliosRay> MakeAirborneRays(
  double width, double height, int pulses, int rings)
{
  std::vector<vtkHeliosRay> rays;
  const int perLine = static_cast<int>(std::sqrt(static_cast<double>(pulses)));
  for (int i = 0; i < pulses; ++i)
  {
    const Vec3 origin(width * (0.02 + 0.96 * i / pulses), 0.5 * width, height);
    const double angle =
      std::atan(0.48 * width / height) * (2.0 * (i % perLine) / (perLine - 1) - 1.0);
    AddPulse(rays, origin, { 0.0, std::sin(angle), -std::cos(angle) }, rings);
  }
  return rays;
}

} // namespace helios

#endif
