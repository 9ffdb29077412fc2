// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
#include "heliosCutouts.h"

#include "heliosPose.h"

#include <cstdio>
#include <map>

namespace helios
{

namespace
{

/// Share of a material in a mesh.
struct Share
{
  vtkIdType Triangles = 0;
  double Area = 0.0; // [m2]
};

double ComputeArea(SceneMesh& mesh, vtkIdType triangle)
{
  const vtkTypeInt32* corners = mesh.Corners.GetValues() + 3 * triangle;
  const auto get = [&](int corner)
  { return Vec3(mesh.Points.GetValues() + 3 * static_cast<vtkIdType>(corners[corner])); };
  const Vec3 first = get(0);
  return 0.5 * (get(1) - first).Cross(get(2) - first).Norm();
}

std::string FormatShare(const Share& share, vtkIdType all, std::size_t materials)
{
  char text[160];
  std::snprintf(text, sizeof(text),
    "%lld of %lld triangles, %.3g m2, of %zu material%s are scanned as opaque",
    static_cast<long long>(share.Triangles), static_cast<long long>(all), share.Area, materials,
    materials == 1 ? "" : "s");
  return text;
}

} // namespace

//------------------------------------------------------------------------------
void WarnOfCutouts(SceneMesh& mesh, const std::vector<Cutout>& cutouts, TextReport& report)
{
  std::map<int, vtkIdType> counts; // number of triangles per material
  for (const Cutout& each : cutouts)
  {
    counts.emplace(each.Row, 0);
  }
  Share sum;
  const vtkIdType count = counts.empty() ? 0 : mesh.GetNumberOfTriangles();
  for (vtkIdType i = 0; i < count; ++i)
  {
    const auto found = counts.find(mesh.MaterialIds.GetValues()[i]);
    if (found != counts.end())
    {
      ++found->second;
      ++sum.Triangles;
      sum.Area += ComputeArea(mesh, i);
    }
  }
  const Cutout* first = nullptr;
  std::size_t materials = 0;
  for (const Cutout& each : cutouts)
  {
    vtkIdType& own = counts[each.Row];
    first = own > 0 && !first ? &each : first;
    materials += own > 0 ? 1 : 0;
    own = 0; // a material may be listed twice
  }
  if (first)
  {
    report.Warn(first->Place + first->What + " is not applied: " +
      FormatShare(sum, count, materials) + "; give leaves their outline as triangles");
  }
}

} // namespace helios
