// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
// Scenes, rays and the brute-force reference for the tests of ray casters.

#ifndef heliosRayCastingScenes_h
#define heliosRayCastingScenes_h

#include "heliosPose.h"
#include "heliosRandom.h"
#include "heliosTriangleArea.h"
#include "heliosTriangleMesh.h"
#include "heliosTriangleTest.h"
#include "vtkHeliosRayCaster.h"

#include <vtkCellArray.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>
#include <vtkSmartPointer.h>

#include <array>
#include <cmath>
#include <map>
#include <utility>
#include <vector>

namespace helios
{

/// Locations in the world: local, UTM, geocentric.
inline const Vec3 Offsets[3] = { { 0, 0, 0 }, { 5e5, 5.5e6, 300 }, { 4e6, 6e5, 4.9e6 } };

/// Random numbers in (0, 1), in sequence.
class Dice
{
public:
  explicit Dice(std::uint64_t seed = 1)
    : Seed(seed)
  {
  }
  double operator()() { return Uniform4(this->Seed, RandomStream::Scene, this->Index++, 0)[0]; }
  double operator()(double low, double high) { return low + (high - low) * (*this)(); }
  Vec3 Point(double low, double high)
  {
    const double x = (*this)(low, high);
    const double y = (*this)(low, high);
    return { x, y, (*this)(low, high) };
  }
  Vec3 Direction()
  {
    Vec3 v = this->Point(-1, 1);
    while (v.Norm() > 1 || v.Norm() < 0.1)
    {
      v = this->Point(-1, 1);
    }
    return v.Normalized();
  }

private:
  std::uint64_t Seed;
  std::uint64_t Index = 0;
};

/// A scene under construction.
struct Soup
{
  std::vector<Vec3> Points;
  std::vector<std::array<vtkIdType, 3>> Triangles;

  vtkIdType AddPoint(const Vec3& p)
  {
    this->Points.push_back(p);
    return static_cast<vtkIdType>(this->Points.size()) - 1;
  }
  void AddTriangle(const Vec3& a, const Vec3& b, const Vec3& c)
  {
    const vtkIdType first = this->AddPoint(a);
    this->AddPoint(b);
    this->AddPoint(c);
    this->Triangles.push_back({ first, first + 1, first + 2 });
  }
  void Move(const Vec3& offset, double scale = 1.0)
  {
    for (Vec3& p : this->Points)
    {
      p = offset + p * scale;
    }
  }
  vtkSmartPointer<vtkPolyData> GetPolyData() const
  {
    vtkNew<vtkPoints> points;
    points->SetDataType(VTK_DOUBLE);
    for (const Vec3& p : this->Points)
    {
      points->InsertNextPoint(p.GetData());
    }
    vtkNew<vtkCellArray> polys;
    polys->Use32BitStorage();
    for (const auto& triangle : this->Triangles)
    {
      polys->InsertNextCell(3, triangle.data());
    }
    auto scene = vtkSmartPointer<vtkPolyData>::New();
    scene->SetPoints(points);
    scene->SetPolys(polys);
    return scene;
  }
};

/// A sphere of radius 1: an icosahedron with each triangle split into four, level times.
inline Soup MakeIcosphere(int level)
{
  Soup soup;
  const double t = (1 + std::sqrt(5.0)) / 2;
  for (double a : { -1.0, 1.0 })
  {
    for (double b : { -t, t })
    {
      soup.AddPoint(Vec3(a, b, 0).Normalized());
      soup.AddPoint(Vec3(0, a, b).Normalized());
      soup.AddPoint(Vec3(b, 0, a).Normalized());
    }
  }
  const auto isEdge = [&soup](vtkIdType i, vtkIdType j)
  { return (soup.Points[i] - soup.Points[j]).Norm() < 1.1; };
  for (vtkIdType i = 0; i < 12; ++i)
  {
    for (vtkIdType j = i + 1; j < 12; ++j)
    {
      for (vtkIdType k = j + 1; k < 12; ++k)
      {
        if (isEdge(i, j) && isEdge(j, k) && isEdge(k, i))
        {
          soup.Triangles.push_back({ i, j, k });
        }
      }
    }
  }
  for (; level > 0; --level)
  {
    std::map<std::pair<vtkIdType, vtkIdType>, vtkIdType> middles;
    const auto getMiddle = [&soup, &middles](vtkIdType i, vtkIdType j)
    {
      const auto key = std::make_pair(std::min(i, j), std::max(i, j));
      const auto found = middles.find(key);
      return found != middles.end()
        ? found->second
        : middles[key] = soup.AddPoint((soup.Points[i] + soup.Points[j]).Normalized());
    };
    std::vector<std::array<vtkIdType, 3>> finer;
    for (const auto& [i, j, k] : soup.Triangles)
    {
      const vtkIdType a = getMiddle(i, j);
      const vtkIdType b = getMiddle(j, k);
      const vtkIdType c = getMiddle(k, i);
      finer.insert(finer.end(), { { i, a, c }, { j, b, a }, { k, c, b }, { a, b, c } });
    }
    soup.Triangles = finer;
  }
  return soup;
}

/// Hills: a grid of n x n squares of a size, two triangles each, from the origin.
inline Soup MakeTerrain(vtkIdType n, double size)
{
  Soup soup;
  for (vtkIdType j = 0; j <= n; ++j)
  {
    for (vtkIdType i = 0; i <= n; ++i)
    {
      const double x = size * static_cast<double>(i);
      const double y = size * static_cast<double>(j);
      soup.AddPoint({ x, y, 3 * std::sin(0.07 * x) * std::cos(0.05 * y) + 0.2 * std::sin(x + y) });
    }
  }
  for (vtkIdType j = 0; j < n; ++j)
  {
    for (vtkIdType i = 0; i < n; ++i)
    {
      const vtkIdType a = j * (n + 1) + i;
      soup.Triangles.push_back({ a, a + 1, a + n + 2 });
      soup.Triangles.push_back({ a, a + n + 2, a + n + 1 });
    }
  }
  return soup;
}

/// Leaves: randomly oriented quads of a size, in a box.
inline void AddLeaves(Soup& soup, int count, double leaf, const Vec3& low, const Vec3& high)
{
  Dice dice(2);
  for (int i = 0; i < count; ++i)
  {
    const Vec3 centre(dice(low[0], high[0]), dice(low[1], high[1]), dice(low[2], high[2]));
    const Vec3 normal = dice.Direction();
    const Vec3 u = normal.Cross(dice.Direction()).Normalized() * leaf;
    const Vec3 v = normal.Cross(u);
    const vtkIdType a = soup.AddPoint(centre - u - v);
    soup.AddPoint(centre + u - v);
    soup.AddPoint(centre + u + v);
    soup.AddPoint(centre - u + v);
    soup.Triangles.push_back({ a, a + 1, a + 2 });
    soup.Triangles.push_back({ a, a + 2, a + 3 });
  }
}

/// A mixture within [-1, 1]: large, small, thin, shared, duplicate and flat triangles.
inline Soup MakeMixture()
{
  Soup soup = MakeIcosphere(2);
  soup.Move({ 0, 0, 0 }, 0.5);
  AddLeaves(soup, 300, 0.02, { -1, -1, -1 }, { 1, 1, 1 });
  Dice dice(3);
  for (int i = 0; i < 100; ++i)
  {
    const Vec3 p = dice.Point(-1, 1);
    const Vec3 along = dice.Direction() * dice(0.1, 1);
    const double width = std::pow(10, dice(-12, -1));
    soup.AddTriangle(p, p + along, p + along * dice() + dice.Direction() * width);
    soup.AddTriangle(p, p + along, p + along * 2.0); // without area, except rounding
    soup.AddTriangle(dice.Point(-1, 1), dice.Point(-1, 1), dice.Point(-1, 1));
    const double z = dice(-1, 1);
    soup.AddTriangle({ -1, dice(-1, 1), z }, { 1, dice(-1, 1), z }, { dice(-1, 1), 1, z });
  }
  const auto doubled = soup.Triangles;
  soup.Triangles.insert(soup.Triangles.end(), doubled.begin(), doubled.begin() + 400);
  return soup;
}

inline vtkHeliosRay MakeRay(const Vec3& origin, const Vec3& direction, double maximum = NoHit)
{
  return { { origin[0], origin[1], origin[2] }, { direction[0], direction[1], direction[2] },
    maximum };
}

/// Rays of every kind at a soup: random, to corners and edges, along the axes, from far and near.
inline std::vector<vtkHeliosRay> MakeRays(const Soup& soup, int count, std::uint64_t seed = 4)
{
  Vec3 low = soup.Points[0];
  Vec3 high = low;
  for (const Vec3& p : soup.Points)
  {
    for (int axis = 0; axis < 3; ++axis)
    {
      low[axis] = std::min(low[axis], p[axis]);
      high[axis] = std::max(high[axis], p[axis]);
    }
  }
  const Vec3 centre = (low + high) * 0.5;
  const double size = (high - low).Norm();
  Dice dice(seed);
  const auto pick = [&dice](std::size_t n)
  { return static_cast<std::size_t>(dice() * static_cast<double>(n)); };
  std::vector<vtkHeliosRay> rays;
  for (int i = 0; i < count; ++i)
  {
    const auto& triangle = soup.Triangles[pick(soup.Triangles.size())];
    const Vec3& a = soup.Points[triangle[0]];
    const Vec3& b = soup.Points[triangle[1]];
    const Vec3& c = soup.Points[triangle[2]];
    const double near = i % 3 == 0 ? 0.3 : (i % 3 == 1 ? 1 : std::pow(10, dice(0, 5)));
    Vec3 origin = centre + dice.Direction() * (near * size);
    const double s = dice();
    const Vec3 targets[4] = { a, a + (b - a) * s, a * 0.3 + b * 0.3 + c * 0.4,
      centre + dice.Direction() * (0.5 * s * size) };
    const Vec3& target = targets[i / 3 % 4];
    Vec3 direction = target - origin;
    if (i % 5 == 0) // along an axis, directly at the target
    {
      const int axis = static_cast<int>(pick(3));
      direction = Vec3(0, 0, 0);
      direction[axis] = i % 2 == 0 ? 1.0 : -1.0;
      origin = target - direction * (near * size);
    }
    else if (i % 5 == 1) // in a plane across an axis
    {
      const int axis = static_cast<int>(pick(3));
      direction[axis] = i % 2 == 0 ? 0.0 : 1e-30;
      origin[axis] = target[axis];
    }
    else if (i % 5 == 2)
    {
      direction = direction * std::pow(10, dice(-6, 6));
    }
    rays.push_back(MakeRay(origin, direction));
    if (i % 7 == 0)
    {
      rays.back().MaximumRange = dice(0, 2) * near * size / direction.Norm();
    }
  }
  return rays;
}

/// The reference: every triangle with an area, tested in order.
inline vtkHeliosHit IntersectBruteForce(const TriangleMesh& mesh, const vtkHeliosRay& ray)
{
  vtkHeliosHit hit{ NoHit, -1 };
  TestRay prepared;
  for (vtkIdType i = 0; prepared.Set(ray) && i < mesh.GetNumberOfTriangles(); ++i)
  {
    const double* points[3] = { mesh.GetCorner(i, 0), mesh.GetCorner(i, 1), mesh.GetCorner(i, 2) };
    const double range =
      SpansArea(points[0], points[1], points[2]) ? TestTriangle(prepared, points) : NoHit;
    if (range < hit.Range)
    {
      hit = { range, i };
    }
  }
  return hit;
}

/// The number of hits of two lists that differ in any bit.
inline int CountDifferences(const std::vector<vtkHeliosHit>& a, const std::vector<vtkHeliosHit>& b)
{
  int count = a.size() == b.size() ? 0 : -1;
  for (std::size_t i = 0; count >= 0 && i < a.size(); ++i)
  {
    count += a[i].CellId != b[i].CellId || a[i].Range != b[i].Range;
  }
  return count;
}

inline std::vector<vtkHeliosHit> Cast(
  const vtkHeliosRayCaster* caster, const std::vector<vtkHeliosRay>& rays)
{
  std::vector<vtkHeliosHit> hits(rays.size());
  caster->Intersect(rays.data(), hits.data(), static_cast<vtkIdType>(rays.size()));
  return hits;
}

} // namespace helios

#endif
