// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
#include "heliosOutliers.h"

#include <vtkSMPTools.h>
#include <vtkType.h>

#include <pcl/search/kdtree.h>

#include <cmath>

namespace helios
{

namespace
{

using Tree = pcl::search::KdTree<pcl::PointXYZ>;

float GetMeanDistance(const Tree& tree, const pcl::PointXYZ& point, int numberOfNeighbors)
{
  pcl::Indices nearest;
  std::vector<float> squares;
  tree.nearestKSearch(point, numberOfNeighbors + 1, nearest, squares); // includes the point itself
  double sum = 0.0;
  for (std::size_t k = 1; k < squares.size(); ++k)
  {
    sum += static_cast<double>(std::sqrt(squares[k]));
  }
  return static_cast<float>(sum / numberOfNeighbors);
}

} // namespace

std::vector<float> GetNeighborDistances(
  const pcl::PointCloud<pcl::PointXYZ>::Ptr& points, int numberOfNeighbors, const GoOn& goOn)
{
  const Tree::Ptr tree(new Tree(false));
  std::vector<float> distances(points->size());
  const bool isWhole = RunApart(goOn, 0.0, [tree, points] { tree->setInputCloud(points); }) &&
    ForChunks(points->size(), goOn,
      [&](std::size_t begin, std::size_t end)
      {
        vtkSMPTools::For(static_cast<vtkIdType>(begin), static_cast<vtkIdType>(end),
          [&](vtkIdType first, vtkIdType last)
          {
            for (auto i = static_cast<std::size_t>(first); i < static_cast<std::size_t>(last); ++i)
            {
              distances[i] = GetMeanDistance(*tree, (*points)[i], numberOfNeighbors);
            }
          });
      });
  return isWhole ? distances : std::vector<float>();
}

double GetDistanceLimit(const std::vector<float>& distances, double standardDeviations)
{
  const auto count = static_cast<double>(distances.size());
  double sum = 0.0;
  double squares = 0.0;
  for (const float distance : distances)
  {
    sum += static_cast<double>(distance);
    squares += static_cast<double>(distance * distance);
  }
  const double variance = (squares - sum * sum / count) / (count - 1.0);
  return sum / count + standardDeviations * std::sqrt(variance);
}

} // namespace helios
