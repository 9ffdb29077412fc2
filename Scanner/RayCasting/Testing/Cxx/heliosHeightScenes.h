// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
// Rasters as a height field and as a mesh, with a tree over each.

#ifndef heliosHeightScenes_h
#define heliosHeightScenes_h

#include "heliosHeightField.h"
#include "heliosRasterScenes.h"
#include "heliosRayCastingScenes.h"
#include "heliosSceneTree.h"

#include <catch2/catch.hpp>

#include <algorithm>

namespace helios
{

struct HeightScene
{
  HeightField Field;
  SceneTree OfField;
  TriangleMesh Mesh;
  SceneTree OfMesh;

  /// Heights are floats if all of them are.
  explicit HeightScene(const HeightRaster& raster)
  {
    const bool areFloats = std::all_of(raster.Values.begin(), raster.Values.end(),
      [](double value)
      { return !(value < static_cast<float>(value) || value > static_cast<float>(value)); });
    const auto image =
      areFloats ? raster.MakeImage<vtkFloatArray>() : raster.MakeImage<vtkDoubleArray>();
    const Status status = this->Field.Set(image);
    INFO(status.Message());
    REQUIRE(status.IsOk());
    REQUIRE(this->Mesh.Set(MakeMesh(raster)).IsOk());
    StopCheck never(nullptr);
    this->OfField.Build(this->Field);
    this->OfMesh.Build(this->Mesh, never);
  }

  Soup GetSoup() const
  {
    Soup soup;
    for (vtkIdType i = 0; i < this->Mesh.GetNumberOfPoints(); ++i)
    {
      soup.AddPoint(Vec3(this->Mesh.GetPoints() + 3 * i));
    }
    for (vtkIdType i = 0; i < this->Mesh.GetNumberOfTriangles(); ++i)
    {
      const vtkTypeInt32* c = this->Mesh.GetCorners() + 3 * i;
      soup.Triangles.push_back({ c[0], c[1], c[2] });
    }
    return soup;
  }
};

/// Rays along the edges of a soup: within their triangles, and slightly above or below.
inline std::vector<vtkHeliosRay> MakeRaysAlongEdges(const Soup& soup, int count)
{
  Dice dice(11);
  std::vector<vtkHeliosRay> rays;
  for (int i = 0; i < count; ++i)
  {
    const auto pick = static_cast<std::size_t>(dice() * static_cast<double>(soup.Triangles.size()));
    const auto& triangle = soup.Triangles[pick];
    const Vec3& from = soup.Points[triangle[i % 3]];
    const Vec3 along = soup.Points[triangle[(i + 1) % 3]] - from;
    Vec3 origin = from - along * (i % 4 == 0 ? 0.0 : dice(0, 1000));
    origin[2] += i % 5 == 0 ? 0.0 : dice(-1, 1) * std::pow(10, dice(-12, 0));
    rays.push_back(MakeRay(origin, along * (i % 2 == 0 ? 1.0 : -1.0)));
  }
  return rays;
}

/// Rays at shallow angles over the whole raster.
inline std::vector<vtkHeliosRay> MakeGrazingRays(const Soup& soup, int count)
{
  Dice dice(12);
  const auto pick = [&]() -> const Vec3& {
    return soup.Points[static_cast<std::size_t>(dice() * static_cast<double>(soup.Points.size()))];
  };
  std::vector<vtkHeliosRay> rays;
  for (int i = 0; i < count; ++i)
  {
    const Vec3 from = pick();
    Vec3 direction = pick() - from;
    direction[2] += dice(-1, 1) * std::pow(10, dice(-3, 1));
    rays.push_back(MakeRay(from - direction * dice(0, 2), direction));
  }
  return rays;
}

} // namespace helios

#endif
