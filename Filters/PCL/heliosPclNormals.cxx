// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
#include "heliosPclNormals.h"

#include <vtkSMPTools.h>
#include <vtkType.h>

#include <pcl/features/normal_3d.h>
#include <pcl/search/kdtree.h>

#include <algorithm>
#include <numeric>

namespace helios
{

bool EstimateNormals(const pcl::PointCloud<pcl::PointXYZ>::Ptr& points, double radius,
  int numberOfNeighbors, const GoOn& goOn, pcl::PointCloud<pcl::Normal>& normals)
{
  using Tree = pcl::search::KdTree<pcl::PointXYZ>;
  const Tree::Ptr tree(new Tree);
  if (!RunApart(goOn, 0.0, [tree, points] { tree->setInputCloud(points); }))
  {
    return false;
  }
  normals.resize(points->size());
  const int neighbors = std::min(numberOfNeighbors, static_cast<int>(points->size()));
  return ForChunks(points->size(), goOn,
    [&](std::size_t begin, std::size_t end)
    {
      vtkSMPTools::For(static_cast<vtkIdType>(begin), static_cast<vtkIdType>(end),
        [&](vtkIdType first, vtkIdType last)
        {
          pcl::NormalEstimation<pcl::PointXYZ, pcl::Normal> estimation;
          estimation.setInputCloud(points);
          estimation.setSearchMethod(tree);
          radius > 0.0 ? estimation.setRadiusSearch(radius) : estimation.setKSearch(neighbors);
          const pcl::IndicesPtr part(new pcl::Indices(static_cast<std::size_t>(last - first)));
          std::iota(part->begin(), part->end(), static_cast<pcl::index_t>(first));
          estimation.setIndices(part);
          pcl::PointCloud<pcl::Normal> found;
          estimation.compute(found);
          std::copy(found.begin(), found.end(), normals.begin() + first);
        });
    });
}

} // namespace helios
