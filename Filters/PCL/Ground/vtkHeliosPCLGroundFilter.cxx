// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkHeliosPCLGroundFilter.h"

#include "heliosGroundOpening.h"
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

#include <algorithm>
#include <cmath>
#include <limits>
#include <memory>
#include <vector>

vtkStandardNewMacro(vtkHeliosPCLGroundFilter);

namespace
{

constexpr int Unclassified = 1; // LAS classes
constexpr int Ground = 2;

using Cloud = helios::PclInput::Cloud;

/// Finds the lowest points of cells; false if it was stopped.
bool FindLowest(
  const Cloud::Ptr& points, double cellSize, const helios::GoOn& goOn, const Cloud::Ptr& lowest)
{
  return helios::RunApart(goOn, 0.0,
    [points, cellSize, lowest]
    {
      pcl::GridMinimum<pcl::PointXYZ> grid(static_cast<float>(cellSize));
      grid.setInputCloud(points);
      grid.filter(*lowest);
    });
}

/// Marks points near the surface; false if it was stopped.
bool MarkNear(const Cloud::Ptr& ground, double cellSize, const Cloud& points, double tolerance,
  const helios::GoOn& goOn, std::vector<char>& isNear)
{
  const auto surface = std::make_shared<helios::GroundSurface>();
  if (!helios::RunApart(
        goOn, 0.0, [surface, ground, cellSize] { surface->Build(*ground, cellSize); }))
  {
    return false;
  }
  return helios::ForChunks(points.size(), goOn,
    [&](std::size_t begin, std::size_t end)
    {
      vtkSMPTools::For(static_cast<vtkIdType>(begin), static_cast<vtkIdType>(end),
        [&](vtkIdType first, vtkIdType last)
        {
          for (auto i = static_cast<std::size_t>(first); i < static_cast<std::size_t>(last); ++i)
          {
            const pcl::PointXYZ& p = points[i];
            const double height = static_cast<double>(p.z) - surface->GetHeight(p.x, p.y);
            isNear[i] = std::abs(height) <= tolerance;
          }
        });
    });
}

/// Returns the classes of the input, if present, with the detected ground.
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
                << " m or more, or process the points in tiles");
  return false;
}

//------------------------------------------------------------------------------
bool vtkHeliosPCLGroundFilter::Process(helios::PclInput& input, vtkPolyData* output)
{
  if (!this->CheckCells(input))
  {
    return false;
  }
  const helios::GroundWindows windows = { static_cast<float>(this->CellSize),
    static_cast<float>(std::ceil(this->MaximumWindowSize)), static_cast<float>(this->Slope),
    static_cast<float>(this->InitialDistance), static_cast<float>(this->MaximumDistance) };
  pcl::Indices kept;
  std::vector<char> isGround(static_cast<std::size_t>(input.GetSize()), 0);
  const helios::GoOn goOn = [this](double share) { return this->GoOn(0.1 + 0.85 * share); };
  const Cloud::Ptr lowest(new Cloud);
  if (!FindLowest(input.GetCloud(), this->CellSize, goOn, lowest) ||
    !helios::FindGround(*lowest, windows, helios::Within(goOn, 0.1, 0.5), kept))
  {
    return false;
  }
  const Cloud::Ptr ground(new Cloud(*lowest, kept));
  if (!ground->empty() &&
    !MarkNear(ground, this->CellSize, *input.GetCloud(), this->Tolerance,
      helios::Within(goOn, 0.5, 1.0), isGround))
  {
    return false;
  }
  helios::SelectPoints(input.GetData(), input.GetIds(), output);
  vtkPointData* data = output->GetPointData();
  data->AddArray(MakeClasses(data->GetArray(vtkHeliosArrayNames::ClassificationIds), isGround));
  return true;
}
