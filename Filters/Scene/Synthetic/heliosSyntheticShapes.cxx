// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
#include "heliosSyntheticShapes.h"

#include "heliosMeshBuilder.h"
#include "heliosRandom.h"
#include "heliosSyntheticMaterials.h"

#include <array>
#include <cmath>
#include <cstdint>
#include <map>
#include <utility>

namespace helios
{

namespace
{

/// Returns division point i of parts in [-side / 2, side / 2].
double Along(double side, int i, int parts)
{
  return side * (static_cast<double>(i) / parts - 0.5);
}

/// Extrudes a profile of the x, z plane, from left to right, along y.
void AddExtrusion(
  MeshBuilder& mesh, const std::vector<vtkVector2d>& profile, double side, int parts)
{
  const auto width = static_cast<vtkTypeInt32>(profile.size());
  for (int j = 0; j <= parts; ++j)
  {
    for (const vtkVector2d& p : profile)
    {
      mesh.AddPoint({ p[0], Along(side, j, parts), p[1] });
    }
  }
  for (int j = 0; j < parts; ++j)
  {
    for (vtkTypeInt32 i = 0; i + 1 < width; ++i)
    {
      const vtkTypeInt32 a = j * width + i;
      mesh.AddQuad(a, a + 1, a + width + 1, a + width);
    }
  }
}

/// Triangles between corners, each divided into parts x parts, that share the points of their
/// edges.
class FacetedSolid
{
public:
  FacetedSolid(MeshBuilder& mesh, std::vector<Vec3> corners, int parts, double radius)
    : Mesh(mesh)
    , Corners(std::move(corners))
    , Parts(parts)
    , Radius(radius)
  {
  }

  /// Adds a face whose corners are counter-clockwise as seen from outside.
  void AddFace(int a, int b, int c)
  {
    std::vector<vtkTypeInt32> last;
    for (int row = 0; row <= this->Parts; ++row)
    {
      std::vector<vtkTypeInt32> ids;
      for (int i = 0; i <= row; ++i)
      {
        ids.push_back(this->GetPoint({ { { a, this->Parts - row }, { b, row - i }, { c, i } } }));
      }
      for (int i = 0; i < row; ++i)
      {
        this->Mesh.AddTriangle(last[i], ids[i], ids[i + 1]);
      }
      for (int i = 0; i + 1 < row; ++i)
      {
        this->Mesh.AddTriangle(last[i], ids[i + 1], last[i + 1]);
      }
      last = std::move(ids);
    }
  }

private:
  using Shares = std::array<std::pair<int, int>, 3>; // a corner, its share of the point in parts

  /// A point of an edge is created once for all its faces.
  vtkTypeInt32 GetPoint(const Shares& shares)
  {
    std::vector<std::pair<int, int>> key;
    for (const auto& share : shares)
    {
      if (share.second > 0)
      {
        key.push_back(share);
      }
    }
    if (key.size() == 3)
    {
      return this->AddPoint(key);
    }
    std::sort(key.begin(), key.end());
    const auto known = this->EdgePoints.find(key);
    return known != this->EdgePoints.end() ? known->second
                                           : this->EdgePoints[key] = this->AddPoint(key);
  }

  vtkTypeInt32 AddPoint(const std::vector<std::pair<int, int>>& shares)
  {
    Vec3 point(0, 0, 0);
    for (const auto& share : shares)
    {
      point = point + this->Corners[share.first] * static_cast<double>(share.second);
    }
    const double divisor = this->Radius > 0 ? point.Norm() / this->Radius : this->Parts;
    return this->Mesh.AddPoint({ point[0] / divisor, point[1] / divisor, point[2] / divisor });
  }

  MeshBuilder& Mesh;
  std::vector<Vec3> Corners;
  int Parts;
  double Radius; // radius of the sphere that points are projected to; 0: no projection
  std::map<std::vector<std::pair<int, int>>, vtkTypeInt32> EdgePoints;
};

} // namespace

//------------------------------------------------------------------------------
void AddPlane(MeshBuilder& mesh, double side, int parts)
{
  mesh.SetMaterial(synthetic::Ground());
  std::vector<vtkVector2d> profile;
  for (int i = 0; i <= parts; ++i)
  {
    profile.emplace_back(Along(side, i, parts), 0.0);
  }
  AddExtrusion(mesh, profile, side, parts);
}

//------------------------------------------------------------------------------
void AddStep(MeshBuilder& mesh, double side, double height, int parts)
{
  mesh.SetMaterial(synthetic::Ground());
  std::vector<vtkVector2d> profile;
  for (int i = 0; i < parts; ++i)
  {
    profile.emplace_back(side * (0.5 * i / parts - 0.5), 0.0);
  }
  for (int i = 0; i < parts; ++i)
  {
    profile.emplace_back(0.0, height * i / parts);
  }
  for (int i = 0; i <= parts; ++i)
  {
    profile.emplace_back(side * 0.5 * i / parts, height);
  }
  AddExtrusion(mesh, profile, side, parts);
}

//------------------------------------------------------------------------------
void AddSphere(MeshBuilder& mesh, double diameter, int parts)
{
  mesh.SetMaterial(synthetic::Target());
  const double g = 0.5 * (1.0 + std::sqrt(5.0)); // the golden ratio
  FacetedSolid sphere(mesh,
    { { -1, g, 0 }, { 1, g, 0 }, { -1, -g, 0 }, { 1, -g, 0 }, { 0, -1, g }, { 0, 1, g },
      { 0, -1, -g }, { 0, 1, -g }, { g, 0, -1 }, { g, 0, 1 }, { -g, 0, -1 }, { -g, 0, 1 } },
    parts, 0.5 * diameter);
  constexpr int faces[20][3] = { { 0, 11, 5 }, { 0, 5, 1 }, { 0, 1, 7 }, { 0, 7, 10 },
    { 0, 10, 11 }, { 1, 5, 9 }, { 5, 11, 4 }, { 11, 10, 2 }, { 10, 7, 6 }, { 7, 1, 8 }, { 3, 9, 4 },
    { 3, 4, 2 }, { 3, 2, 6 }, { 3, 6, 8 }, { 3, 8, 9 }, { 4, 9, 5 }, { 2, 4, 11 }, { 6, 2, 10 },
    { 8, 6, 7 }, { 9, 8, 1 } };
  for (const auto& face : faces)
  {
    sphere.AddFace(face[0], face[1], face[2]);
  }
}

//------------------------------------------------------------------------------
void AddPyramid(MeshBuilder& mesh, double side, double height, int parts)
{
  mesh.SetMaterial(synthetic::Target());
  const double r = 0.5 * side;
  FacetedSolid pyramid(
    mesh, { { -r, -r, 0 }, { r, -r, 0 }, { r, r, 0 }, { -r, r, 0 }, { 0, 0, height } }, parts, 0.0);
  for (int i = 0; i < 4; ++i)
  {
    pyramid.AddFace(4, i, (i + 1) % 4);
  }
  pyramid.AddFace(0, 2, 1);
  pyramid.AddFace(0, 3, 2);
}

//------------------------------------------------------------------------------
void AddBlocks(MeshBuilder& mesh, double side, double height, int cells, vtkIdType seed)
{
  AddPlane(mesh, side, cells);
  mesh.SetMaterial(synthetic::Concrete());
  const double cell = side / cells;
  for (int i = 0; i < cells * cells; ++i)
  {
    const Vec3 centre(
      Along(side, i % cells, cells) + 0.5 * cell, Along(side, i / cells, cells) + 0.5 * cell, 0.0);
    if (std::abs(centre[0]) < 0.75 * cell && std::abs(centre[1]) < 0.75 * cell)
    {
      continue;
    }
    const auto u = Uniform4(static_cast<std::uint64_t>(seed), RandomStream::Scene, i, 0);
    const double x = cell * (0.15 + 0.15 * u[0]);
    const double y = cell * (0.15 + 0.15 * u[1]);
    mesh.SetFrame({ centre, AxisAngle({ 0, 0, 1 }, 90.0 * u[3]) });
    mesh.AddBox({ -x, -y, -0.05 * height }, { x, y, height * (0.2 + 0.8 * u[2]) });
  }
  mesh.SetFrame(Pose());
}

} // namespace helios
