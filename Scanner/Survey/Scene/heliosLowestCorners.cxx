// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
#include "heliosLowestCorners.h"

#include "heliosStatus.h"
#include "heliosTriangleMesh.h"

#include <vtkPolyData.h>
#include <vtkType.h>

#include <algorithm>

namespace helios
{

namespace
{

/// The difference of unit vectors that are the same but for rounding.
constexpr double SameDirection = 1e-12;

double GetHeight(const Vec3& up, const double* p)
{
  return up[0] * p[0] + up[1] * p[1] + up[2] * p[2];
}

/// Calls a function with each corner of a mesh, in order.
template <typename CallT>
void ForEachCorner(vtkPolyData* data, const CallT& call)
{
  TriangleMesh mesh;
  const vtkIdType count = mesh.Set(data).IsOk() ? 3 * mesh.GetNumberOfTriangles() : 0;
  for (vtkIdType corner = 0; corner < count; ++corner)
  {
    call(mesh.GetCorner(corner / 3, static_cast<int>(corner % 3)));
  }
}

} // namespace

//------------------------------------------------------------------------------
bool FindLowestCorner(vtkPolyData* mesh, const Vec3& up, Vec3& lowest)
{
  const double* best = nullptr;
  ForEachCorner(mesh,
    [&](const double* p) { best = !best || GetHeight(up, p) < GetHeight(up, best) ? p : best; });
  lowest = best ? Vec3(best) : lowest;
  return best != nullptr;
}

//------------------------------------------------------------------------------
LowestCorners::Candidates LowestCorners::FindCandidates(vtkPolyData* mesh, const Vec3& up)
{
  Candidates candidates;
  candidates.Up = up;
  Vec3 lowest;
  if (!FindLowestCorner(mesh, up, lowest))
  {
    return candidates;
  }
  double radius = 0.0;
  ForEachCorner(mesh, [&](const double* p) { radius = std::max(radius, Vec3(p).Norm()); });
  // Heights along two such directions differ by at most the radius times their difference.
  const double limit = GetHeight(up, lowest.GetData()) + 4.0 * SameDirection * radius;
  ForEachCorner(mesh,
    [&](const double* p)
    {
      if (GetHeight(up, p) <= limit)
      {
        candidates.Corners.emplace_back(p);
      }
    });
  return candidates;
}

//------------------------------------------------------------------------------
bool LowestCorners::Find(vtkPolyData* mesh, const Vec3& up, Vec3& lowest)
{
  Candidates& known = this->Known[mesh];
  if (!((known.Up - up).Norm() <= SameDirection))
  {
    known = FindCandidates(mesh, up);
  }
  const auto isLower = [&up](const Vec3& a, const Vec3& b)
  { return GetHeight(up, a.GetData()) < GetHeight(up, b.GetData()); };
  const auto best = std::min_element(known.Corners.begin(), known.Corners.end(), isLower);
  const bool isFound = best != known.Corners.end();
  lowest = isFound ? *best : lowest;
  return isFound;
}

} // namespace helios
