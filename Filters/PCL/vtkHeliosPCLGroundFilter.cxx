// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkHeliosPCLGroundFilter.h"

#include "heliosGroundSurface.h"
#include "heliosPclInput.h"
#include "heliosPointSelection.h"
#include "vtkHeliosArrayNames.h"

#include <vtkDataArray.h>
#include <vtkIntArray.h>
#include <vtkNew.h>
#include <vtkObjectFactory.h>
#include <vtkPointData.h>
#include <vtkPolyData.h>
#include <vtkSMPTools.h>

#include <pcl/filters/grid_minimum.h>
#include <pcl/segmentation/progressive_morphological_filter.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

vtkStandardNewMacro(vtkHeliosPCLGroundFilter);

namespace
{

constexpr int Unclassified = 1; // as LAS has them
constexpr int Ground = 2;

using Cloud = helios::PclInput::Cloud;

Cloud::Ptr TakeLowest(const Cloud::Ptr& points, double cellSize)
{
  pcl::GridMinimum<pcl::PointXYZ> grid(static_cast<float>(cellSize));
  grid.setInputCloud(points);
  Cloud::Ptr lowest(new Cloud);
  grid.filter(*lowest);
  return lowest;
}

/// The classes of the input, where it has them, with ground as it was found.
vtkSmartPointer<vtkIntArray> MakeClasses(vtkDataArray* known, const std::vector<char>& isGround)
{
  auto classes = vtkSmartPointer<vtkIntArray>::New();
  classes->SetName(vtkHeliosArrayNames::ClassificationIds);
  classes->SetNumberOfValues(static_cast<vtkIdType>(isGround.size()));
  for (vtkIdType i = 0; i < classes->GetNumberOfTuples(); ++i)
  {
    const int old = known ? static_cast<int>(known->GetComponent(i, 0)) : Unclassified;
    const int other = old == Ground ? Unclassified : old;
    classes->SetValue(i, isGround[static_cast<std::size_t>(i)] ? Ground : other);
  }
  return classes;
}

} // namespace

//------------------------------------------------------------------------------
void vtkHeliosPCLGroundFilter::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "CellSize: " << this->CellSize << " m\n"
     << indent << "MaximumWindowSize: " << this->MaximumWindowSize << " m\n"
     << indent << "Slope: " << this->Slope << "\n"
     << indent << "InitialDistance: " << this->InitialDistance << " m\n"
     << indent << "MaximumDistance: " << this->MaximumDistance << " m\n"
     << indent << "Tolerance: " << this->Tolerance << " m\n";
}

//------------------------------------------------------------------------------
bool vtkHeliosPCLGroundFilter::CheckCells(const helios::PclInput& input)
{
  const double across = std::floor(2.0 * input.GetReach() / this->CellSize) + 2.0;
  if (across * across < static_cast<double>(std::numeric_limits<int>::max()))
  {
    return true;
  }
  vtkErrorMacro(<< "CellSize is " << this->CellSize << " m, which makes more cells than PCL can "
                << "count; set " << 2.0 * input.GetReach() / 46000.0
                << " m or more, or work at the "
                << "points in tiles");
  return false;
}

//------------------------------------------------------------------------------
bool vtkHeliosPCLGroundFilter::Process(helios::PclInput& input, vtkPolyData* output)
{
  if (!this->CheckCells(input))
  {
    return false;
  }
  const Cloud::Ptr lowest = TakeLowest(input.GetCloud(), this->CellSize);
  pcl::ProgressiveMorphologicalFilter<pcl::PointXYZ> filter;
  filter.setInputCloud(lowest);
  filter.setCellSize(static_cast<float>(this->CellSize));
  filter.setMaxWindowSize(static_cast<int>(std::ceil(this->MaximumWindowSize)));
  filter.setSlope(static_cast<float>(this->Slope));
  filter.setInitialDistance(static_cast<float>(this->InitialDistance));
  filter.setMaxDistance(static_cast<float>(this->MaximumDistance));
  filter.setExponential(true);
  pcl::Indices kept;
  filter.extract(kept);
  if (!this->GoOn(0.6))
  {
    return false;
  }
  std::vector<char> isGround(static_cast<std::size_t>(input.GetSize()), 0);
  if (!kept.empty())
  {
    const helios::GroundSurface surface(Cloud(*lowest, kept), this->CellSize);
    vtkSMPTools::For(0, input.GetSize(),
      [this, &input, &surface, &isGround](vtkIdType begin, vtkIdType end)
      {
        for (auto i = static_cast<std::size_t>(begin); i < static_cast<std::size_t>(end); ++i)
        {
          const pcl::PointXYZ& p = (*input.GetCloud())[i];
          const double height = static_cast<double>(p.z) - surface.GetHeight(p.x, p.y);
          isGround[i] = std::abs(height) <= this->Tolerance;
        }
      });
  }
  helios::SelectPoints(input.GetData(), input.GetIds(), output);
  vtkPointData* data = output->GetPointData();
  data->AddArray(MakeClasses(data->GetArray(vtkHeliosArrayNames::ClassificationIds), isGround));
  return true;
}
