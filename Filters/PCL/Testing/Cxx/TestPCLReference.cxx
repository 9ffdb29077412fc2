// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
// Computations in chunks or without PCL, compared with PCL's own filters.
#include "heliosGroundOpening.h"
#include "heliosPclCloud.h"
#include "heliosPclTesting.h"
#include "vtkHeliosPCLClusters.h"
#include "vtkHeliosPCLNormals.h"
#include "vtkHeliosPCLOutlierRemoval.h"

#include <vtkCallbackCommand.h>

#include <pcl/features/normal_3d.h>
#include <pcl/filters/statistical_outlier_removal.h>
#include <pcl/search/kdtree.h>
#include <pcl/segmentation/extract_clusters.h>
#include <pcl/segmentation/progressive_morphological_filter.h>

#include <catch2/catch.hpp>

#include <algorithm>
#include <numeric>

namespace names = vtkHeliosPCLArrayNames;

namespace
{

using Cloud = pcl::PointCloud<pcl::PointXYZ>;
using Tree = pcl::search::KdTree<pcl::PointXYZ>;

/// Relative to the same origin as within filters.
Cloud::Ptr MakePclCloud(vtkPolyData* data)
{
  double origin[3];
  helios::ChooseOrigin(data, origin);
  Cloud::Ptr cloud(new Cloud);
  REQUIRE(helios::ToPcl(data, origin, *cloud).empty());
  return cloud;
}

/// Points of uneven density about several centres, a third of them at existing points.
helios::Triples MakeUneven(unsigned seed, int count)
{
  helios::Uniform uniform(seed);
  helios::Triples points;
  for (int i = 0; i < count; ++i)
  {
    if (i % 3 == 2)
    {
      const auto twin = static_cast<std::size_t>(uniform(0, static_cast<double>(points.size())));
      points.push_back(points[twin]);
      continue;
    }
    const double reach = std::pow(10.0, uniform(-2.0, 0.7));
    const helios::Triple centre = { 3.0 * (i % 4), 2.0 * (i % 3), 0.0 };
    points.push_back(helios::Utm + centre +
      helios::Triple{ uniform(-reach, reach), uniform(-reach, reach), uniform(-reach, reach) });
  }
  return points;
}

/// PCL's clusters by size and first point, one per point; -1: too small.
std::vector<int> GetPclClusters(const Cloud::Ptr& cloud, double tolerance, int least)
{
  pcl::EuclideanClusterExtraction<pcl::PointXYZ> extraction;
  extraction.setClusterTolerance(tolerance);
  extraction.setMinClusterSize(least);
  extraction.setSearchMethod(Tree::Ptr(new Tree));
  extraction.setInputCloud(cloud);
  std::vector<pcl::PointIndices> clusters;
  extraction.extract(clusters);
  std::vector<std::pair<int, int>> keys;
  for (pcl::PointIndices& cluster : clusters)
  {
    std::sort(cluster.indices.begin(), cluster.indices.end());
  }
  std::sort(clusters.begin(), clusters.end(),
    [](const pcl::PointIndices& a, const pcl::PointIndices& b)
    {
      return a.indices.size() != b.indices.size() ? a.indices.size() > b.indices.size()
                                                  : a.indices[0] < b.indices[0];
    });
  std::vector<int> ids(cloud->size(), -1);
  for (std::size_t c = 0; c < clusters.size(); ++c)
  {
    for (const int i : clusters[c].indices)
    {
      ids[static_cast<std::size_t>(i)] = static_cast<int>(c);
    }
  }
  return ids;
}

/// Computes the clusters without a library: each pair of points, in float like PCL's points.
std::vector<int> GetFirstByPairs(const Cloud& cloud, double tolerance)
{
  std::vector<int> first(cloud.size());
  std::iota(first.begin(), first.end(), 0);
  const auto square =
    static_cast<float>(std::pow(static_cast<double>(static_cast<float>(tolerance)), 2));
  bool hasChanged = true;
  while (hasChanged)
  {
    hasChanged = false;
    for (std::size_t i = 0; i < cloud.size(); ++i)
    {
      for (std::size_t j = 0; j < i; ++j)
      {
        const float x = cloud[i].x - cloud[j].x;
        const float y = cloud[i].y - cloud[j].y;
        const float z = cloud[i].z - cloud[j].z;
        if (first[i] != first[j] && x * x + y * y + z * z < square)
        {
          first[i] = first[j] = std::min(first[i], first[j]);
          hasChanged = true;
        }
      }
    }
  }
  return first;
}

std::vector<int> GetIds(helios::Filtering<vtkHeliosPCLClusters>& run)
{
  std::vector<int> ids;
  for (vtkIdType i = 0; i < run.Count(); ++i)
  {
    ids.push_back(static_cast<int>(run.Get(names::ClusterIds)->GetTuple1(i)));
  }
  return ids;
}

} // namespace

TEST_CASE("PCLClusters: the clusters of PCL, at any density", "[PCLClusters]")
{
  for (unsigned seed = 0; seed < 8; ++seed)
  {
    helios::Filtering<vtkHeliosPCLClusters> run(MakeUneven(seed, 1500));
    const Cloud::Ptr cloud = MakePclCloud(vtkPolyData::SafeDownCast(run.Filter->GetInput()));
    for (const double tolerance : { 0.001, 0.01, 0.03, 0.1, 0.2, 0.4, 0.8, 3.0 })
    {
      INFO(seed << ", " << tolerance);
      const int least = 1 + static_cast<int>(seed % 4);
      run.Filter->SetTolerance(tolerance);
      run.Filter->SetMinimumClusterSize(least);
      REQUIRE(run.Run());
      REQUIRE(GetIds(run) == GetPclClusters(cloud, tolerance, least));
    }
  }
}

TEST_CASE("PCLClusters: distances equal to the tolerance do not join, as in PCL", "[PCLClusters]")
{
  helios::Triples points;
  for (int i = 0; i < 512; ++i) // 0.25 m apart, exactly
  {
    points.push_back({ 0.25 * (i % 8), 0.25 * (i / 8 % 8), 0.25 * (i / 64) });
  }
  helios::Filtering<vtkHeliosPCLClusters> run(points);
  run.Filter->SetMinimumClusterSize(1);
  const Cloud::Ptr cloud = MakePclCloud(vtkPolyData::SafeDownCast(run.Filter->GetInput()));
  for (const double tolerance : { 0.25, 0.250001 })
  {
    run.Filter->SetTolerance(tolerance);
    REQUIRE(run.Run());
    CHECK(GetIds(run) == GetPclClusters(cloud, tolerance, 1));
    CHECK(run.Filter->GetNumberOfClusters() == (tolerance > 0.25 ? 1 : 512));
  }
}

TEST_CASE("PCLClusters: compared with all pairs of points", "[PCLClusters]")
{
  helios::Filtering<vtkHeliosPCLClusters> run(MakeUneven(20, 900));
  run.Filter->SetMinimumClusterSize(1);
  run.Filter->SetTolerance(0.15);
  REQUIRE(run.Run());
  const std::vector<int> ids = GetIds(run);
  const std::vector<int> first =
    GetFirstByPairs(*MakePclCloud(vtkPolyData::SafeDownCast(run.Filter->GetInput())), 0.15);
  int wrong = 0;
  for (std::size_t i = 0; i < ids.size(); ++i)
  {
    for (std::size_t j = 0; j < i; ++j)
    {
      wrong += (ids[i] == ids[j]) == (first[i] == first[j]) ? 0 : 1;
    }
  }
  CHECK(wrong == 0);
  CHECK(run.Filter->GetNumberOfClusters() > 10);
}

// Two dense sheets slightly farther apart than the tolerance: all pairs of a cell with its
// neighbours would be 4e10. Counted by the reports, one per about 2.6e5 points read.
TEST_CASE("PCLClusters: dense points that are not joined take n log n", "[PCLClusters]")
{
  helios::Uniform uniform(9);
  helios::Triples points;
  for (int i = 0; i < 400000; ++i)
  {
    const double x = uniform(0.0, 0.2);
    points.push_back({ x, uniform(0.0, 0.2), 0.3 * x + (i % 2) * 1.05 });
  }
  helios::Filtering<vtkHeliosPCLClusters> run(points);
  run.Filter->SetTolerance(1.0);
  int reports = 0;
  vtkNew<vtkCallbackCommand> count;
  count->SetClientData(&reports);
  count->SetCallback(
    [](vtkObject*, unsigned long, void* data, void*) { ++*static_cast<int*>(data); });
  run.Filter->AddObserver(vtkCommand::ProgressEvent, count);
  REQUIRE(run.Run());
  CHECK(run.Filter->GetNumberOfClusters() == 2);
  CHECK(reports < 1000);
}

TEST_CASE("PCLOutlierRemoval: keeps the points that PCL keeps", "[PCLOutlierRemoval]")
{
  helios::Filtering<vtkHeliosPCLOutlierRemoval> run(MakeUneven(30, 6000));
  const Cloud::Ptr cloud = MakePclCloud(vtkPolyData::SafeDownCast(run.Filter->GetInput()));
  for (const int neighbors : { 1, 8, 50 })
  {
    pcl::StatisticalOutlierRemoval<pcl::PointXYZ> filter;
    filter.setInputCloud(cloud);
    filter.setMeanK(neighbors);
    filter.setStddevMulThresh(1.0);
    pcl::Indices kept;
    filter.filter(kept);
    run.Filter->SetNumberOfNeighbors(neighbors);
    run.Filter->SetStandardDeviations(1.0);
    REQUIRE(run.Run());
    REQUIRE(kept.size() < 6000);
    REQUIRE(run.Count() == static_cast<vtkIdType>(kept.size()));
    for (vtkIdType i = 0; i < run.Count(); ++i)
    {
      REQUIRE(run.GetId(i) == kept[static_cast<std::size_t>(i)]);
    }
  }
}

TEST_CASE("PCLNormals: equal to PCL's in one piece", "[PCLNormals]")
{
  helios::Filtering<vtkHeliosPCLNormals> run(MakeUneven(31, 9000));
  const Cloud::Ptr cloud = MakePclCloud(vtkPolyData::SafeDownCast(run.Filter->GetInput()));
  for (const double radius : { 0.0, 0.3 })
  {
    pcl::NormalEstimation<pcl::PointXYZ, pcl::Normal> estimation;
    estimation.setInputCloud(cloud);
    estimation.setSearchMethod(Tree::Ptr(new Tree));
    radius > 0.0 ? estimation.setRadiusSearch(radius) : estimation.setKSearch(16);
    pcl::PointCloud<pcl::Normal> whole;
    estimation.compute(whole);
    run.Filter->SetRadius(radius);
    REQUIRE(run.Run());
    int wrong = 0;
    for (vtkIdType i = 0; i < run.Count(); ++i)
    {
      const pcl::Normal& n = whole[static_cast<std::size_t>(i)];
      const bool isNone = !std::isfinite(n.normal_x);
      const double curvature = isNone ? 0.0 : static_cast<double>(n.curvature);
      const double z = isNone ? 0.0 : std::abs(static_cast<double>(n.normal_z));
      wrong += run.Get(names::Curvature)->GetTuple1(i) == curvature &&
          run.Get(vtkHeliosArrayNames::Normals)->GetComponent(i, 2) == z
        ? 0
        : 1;
    }
    CHECK(wrong == 0);
  }
}

TEST_CASE("PCLGroundFilter: openings equal PCL's", "[PCLGroundFilter]")
{
  helios::Uniform uniform(32);
  for (const double side : { 30.0, 200.0, 3000.0 }) // dense to sparse
  {
    Cloud::Ptr cloud(new Cloud);
    for (int i = 0; i < 4000; ++i)
    {
      const auto z = static_cast<float>(uniform(0, 1) < 0.3 ? uniform(0, 15) : uniform(0, 0.5));
      cloud->push_back(pcl::PointXYZ(
        static_cast<float>(uniform(-side, side)), static_cast<float>(uniform(0, side)), z));
    }
    pcl::ProgressiveMorphologicalFilter<pcl::PointXYZ> filter;
    filter.setInputCloud(cloud);
    filter.setCellSize(1.0F);
    filter.setMaxWindowSize(33);
    filter.setSlope(0.5F);
    filter.setInitialDistance(0.25F);
    filter.setMaxDistance(2.5F);
    pcl::Indices expected;
    filter.extract(expected);
    pcl::Indices ground;
    REQUIRE(helios::FindGround(
      *cloud, { 1.0F, 33.0F, 0.5F, 0.25F, 2.5F }, [](double) { return true; }, ground));
    CHECK(ground.size() < 4000);
    CHECK(ground == expected);
  }
}
