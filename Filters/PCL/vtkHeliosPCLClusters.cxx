// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkHeliosPCLClusters.h"

#include "heliosPclInput.h"
#include "heliosPointSelection.h"
#include "vtkHeliosPCLArrayNames.h"

#include <vtkIntArray.h>
#include <vtkNew.h>
#include <vtkObjectFactory.h>
#include <vtkPointData.h>
#include <vtkPolyData.h>

#include <pcl/search/kdtree.h>
#include <pcl/segmentation/extract_clusters.h>

#include <algorithm>
#include <vector>

vtkStandardNewMacro(vtkHeliosPCLClusters);

//------------------------------------------------------------------------------
void vtkHeliosPCLClusters::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "Tolerance: " << this->Tolerance << " m\n"
     << indent << "MinimumClusterSize: " << this->MinimumClusterSize << "\n"
     << indent << "MaximumClusterSize: " << this->MaximumClusterSize << "\n"
     << indent << "NumberOfClusters: " << this->NumberOfClusters << "\n";
}

//------------------------------------------------------------------------------
bool vtkHeliosPCLClusters::CheckProperties()
{
  this->NumberOfClusters = 0;
  if (this->MinimumClusterSize > this->MaximumClusterSize)
  {
    vtkErrorMacro(<< "MinimumClusterSize is " << this->MinimumClusterSize
                  << ", above MaximumClusterSize, " << this->MaximumClusterSize
                  << "; set a smaller one");
    return false;
  }
  return true;
}

//------------------------------------------------------------------------------
bool vtkHeliosPCLClusters::Process(helios::PclInput& input, vtkPolyData* output)
{
  pcl::EuclideanClusterExtraction<pcl::PointXYZ> extraction;
  extraction.setClusterTolerance(this->Tolerance);
  extraction.setMinClusterSize(this->MinimumClusterSize);
  extraction.setMaxClusterSize(this->MaximumClusterSize);
  extraction.setSearchMethod(
    pcl::search::KdTree<pcl::PointXYZ>::Ptr(new pcl::search::KdTree<pcl::PointXYZ>));
  extraction.setInputCloud(input.GetCloud());
  std::vector<pcl::PointIndices> clusters;
  extraction.extract(clusters);
  // of the same size: by the first point
  std::sort(clusters.begin(), clusters.end(),
    [](const pcl::PointIndices& a, const pcl::PointIndices& b)
    {
      const auto firstOf = [](const pcl::PointIndices& c)
      { return *std::min_element(c.indices.begin(), c.indices.end()); };
      return a.indices.size() != b.indices.size() ? a.indices.size() > b.indices.size()
                                                  : firstOf(a) < firstOf(b);
    });
  this->NumberOfClusters = static_cast<int>(clusters.size());

  helios::SelectPoints(input.GetData(), input.GetIds(), output);
  vtkNew<vtkIntArray> ids;
  ids->SetName(vtkHeliosPCLArrayNames::ClusterIds);
  ids->SetNumberOfValues(input.GetSize());
  ids->FillValue(-1);
  for (std::size_t c = 0; c < clusters.size(); ++c)
  {
    for (const pcl::index_t i : clusters[c].indices)
    {
      ids->SetValue(i, static_cast<int>(c));
    }
  }
  output->GetPointData()->AddArray(ids);
  return true;
}
