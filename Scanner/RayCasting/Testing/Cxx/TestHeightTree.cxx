// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma GCC diagnostic ignored "-Wpsabi" // heliosBeamBundle.h needs it
#include "heliosBeamBundle.h"
#include "heliosConeProbe.h"
#include "heliosHeightScenes.h"

#include <algorithm>
#include <cstring>

using helios::Dice;
using helios::HeightRaster;
using helios::HeightScene;
using helios::SceneTree;
using helios::Vec3;

namespace
{

std::vector<vtkHeliosHit> Trace(
  const SceneTree& tree, const std::vector<vtkHeliosRay>& rays, int raysPerBeam)
{
  std::vector<vtkHeliosHit> hits(rays.size());
  helios::BeamBundle bundle(tree);
  const int count = static_cast<int>(rays.size());
  for (int i = 0; i < count; i += raysPerBeam)
  {
    bundle.Trace(&rays[i], &hits[i], std::min(raysPerBeam, count - i));
  }
  return hits;
}

std::vector<vtkHeliosHit> Intersect(const SceneTree& tree, const std::vector<vtkHeliosRay>& rays)
{
  std::vector<vtkHeliosHit> hits;
  std::transform(rays.begin(), rays.end(), std::back_inserter(hits),
    [&tree](const vtkHeliosRay& ray) { return tree.Intersect(ray); });
  return hits;
}

std::vector<bool> GetOccluded(const SceneTree& tree, const std::vector<vtkHeliosRay>& rays)
{
  SceneTree::Occluder occluder;
  std::vector<bool> occluded;
  for (const vtkHeliosRay& ray : rays)
  {
    occluded.push_back(tree.IsOccluded(ray, occluder));
  }
  return occluded;
}

/// Checks rays, alone and in bundles; returns the number of hits.
std::ptrdiff_t CheckRays(const HeightScene& scene, const std::vector<vtkHeliosRay>& rays)
{
  const auto truth = Intersect(scene.OfMesh, rays);
  CHECK(helios::CountDifferences(Intersect(scene.OfField, rays), truth) == 0);
  for (const int raysPerBeam : { 2, 19, 256 })
  {
    CHECK(helios::CountDifferences(Trace(scene.OfField, rays, raysPerBeam), truth) == 0);
  }
  CHECK(GetOccluded(scene.OfField, rays) == GetOccluded(scene.OfMesh, rays));
  return std::count_if(
    truth.begin(), truth.end(), [](const vtkHeliosHit& hit) { return hit.CellId >= 0; });
}

void CheckAllRays(const HeightRaster& raster, int count = 1000)
{
  const HeightScene scene(raster);
  const helios::Soup soup = scene.GetSoup();
  CHECK(CheckRays(scene, helios::MakeRays(soup, count)) > count / 5);
  CHECK(CheckRays(scene, helios::MakeGrazingRays(soup, count)) > count / 5);
  CheckRays(scene, helios::MakeRaysAlongEdges(soup, count));
}

/// Rasters of all transforms and kinds of heights.
std::vector<HeightRaster> MakeRasters(int columns, int rows)
{
  std::vector<HeightRaster> rasters;
  for (const auto& transform : helios::TestTransforms)
  {
    HeightRaster raster(columns, rows, transform);
    rasters.push_back(raster); // flat
    raster.AddHills(4.0, 0.3);
    rasters.push_back(raster);
    for (double& height : raster.Values)
    {
      height += 300.1;
    }
    raster.AddHoles();
    rasters.push_back(raster);
  }
  return rasters;
}

bool AreSame(const helios::ConeLayer& a, const helios::ConeLayer& b)
{
  return a.Size == b.Size &&
    std::memcmp(a.Pieces, b.Pieces, static_cast<std::size_t>(a.Size) * sizeof(a.Pieces[0])) == 0;
}

bool AreSame(const helios::ConeView& a, const helios::ConeView& b)
{
  return a.Farthest == b.Farthest &&
    std::equal(a.Triangles.begin(), a.Triangles.end(), b.Triangles.begin(), b.Triangles.end(),
      [](const helios::ConeTriangle& s, const helios::ConeTriangle& t)
      { return s.Cell == t.Cell && std::memcmp(s.Corners, t.Corners, sizeof(s.Corners)) == 0; });
}

/// Probes a cone about each ray, and collects its triangles; returns the numbers of each kind.
std::array<int, 3> CheckCones(const HeightScene& scene, const std::vector<vtkHeliosRay>& rays)
{
  const auto ofField = helios::MakeConeProbe(scene.OfField);
  const auto ofMesh = helios::MakeConeProbe(scene.OfMesh);
  Dice dice(31);
  std::array<int, 3> kinds{};
  int probes = 0, layers = 0, views = 0; // hits that differ
  for (const vtkHeliosRay& ray : rays)
  {
    if (ray.Origin[2] == scene.Mesh.GetCorner(0, 0)[2])
    {
      continue; // in the plane of a flat raster
    }
    const Vec3 axis = Vec3(ray.Direction).Normalized();
    const double tangent = std::pow(10, dice(-5, -1));
    helios::PlaneLimits limits(0.01);
    limits.OfLayer.Distance = 0.1;
    helios::ConeLayer layer, otherLayer;
    const auto hit = ofField->Probe(ray.Origin, axis.GetData(), tangent, limits, &layer);
    const auto other = ofMesh->Probe(ray.Origin, axis.GetData(), tangent, limits, &otherLayer);
    probes += hit.Kind != other.Kind || hit.CellId != other.CellId || hit.Range != other.Range;
    layers += !AreSame(layer, otherLayer);
    helios::ConeView view, otherView;
    const bool isWhole = ofField->Collect(ray.Origin, axis.GetData(), tangent, 0.1, 500, view);
    const bool isOtherWhole =
      ofMesh->Collect(ray.Origin, axis.GetData(), tangent, 0.1, 500, otherView);
    views += isWhole != isOtherWhole || (isWhole && !AreSame(view, otherView));
    ++kinds[static_cast<std::size_t>(hit.Kind)];
  }
  CHECK(probes == 0);
  CHECK(layers == 0);
  CHECK(views == 0);
  return kinds;
}

} // namespace

TEST_CASE("HeightTree: hits are those of the mesh, bit for bit", "[HeightTree]")
{
  for (const auto& [columns, rows] :
    { std::pair(4, 4), { 3, 70 }, { 5, 90 }, { 131, 9 }, { 63, 40 } })
  {
    for (const HeightRaster& raster : MakeRasters(columns, rows))
    {
      INFO(columns << " x " << rows << ", geotransform " << raster.Transform[0] << " "
                   << raster.Transform[1] << ", height " << raster.Values[columns + 1]);
      CheckAllRays(raster);
    }
  }
}

TEST_CASE("HeightTree: cones are those of the mesh", "[HeightTree]")
{
  for (const HeightRaster& raster : MakeRasters(63, 40))
  {
    INFO("geotransform " << raster.Transform[0] << " " << raster.Transform[1] << ", height "
                         << raster.Values[64]);
    const HeightScene scene(raster);
    const helios::Soup soup = scene.GetSoup();
    const auto kinds = CheckCones(scene, helios::MakeRays(soup, 1000));
    CHECK(*std::min_element(kinds.begin(), kinds.end()) > 50);
    CheckCones(scene, helios::MakeGrazingRays(soup, 1000));
    CheckCones(scene, helios::MakeRaysAlongEdges(soup, 1000));
  }
}
