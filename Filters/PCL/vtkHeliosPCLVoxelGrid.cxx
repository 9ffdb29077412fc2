// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkHeliosPCLVoxelGrid.h"

#include "heliosChunks.h"
#include "heliosPclInput.h"
#include "heliosPointSelection.h"
#include "vtkHeliosPCLArrayNames.h"

#include <vtkIntArray.h>
#include <vtkNew.h>
#include <vtkObjectFactory.h>
#include <vtkPointData.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>

#include <pcl/common/common.h>
#include <pcl/filters/voxel_grid.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <memory>
#include <numeric>
#include <utility>
#include <vector>

vtkStandardNewMacro(vtkHeliosPCLVoxelGrid);

namespace
{

using Cloud = helios::PclInput::Cloud;

/// Points sorted by cells: Order lists the points of cell c from Begin[c] to Begin[c + 1].
struct CellPoints
{
  std::vector<int> Order;
  std::vector<std::size_t> Begin;

  // Sorts points by the index by which PCL sorts its cells.
  CellPoints(pcl::VoxelGrid<pcl::PointXYZ>& grid, const Cloud& cloud)
    : Order(cloud.size())
  {
    const Eigen::Vector3i low = grid.getMinBoxCoordinates();
    const Eigen::Vector3i multiplier = grid.getDivisionMultiplier();
    std::vector<int> cells;
    cells.reserve(cloud.size());
    for (const pcl::PointXYZ& p : cloud)
    {
      cells.push_back((grid.getGridCoordinates(p.x, p.y, p.z) - low).dot(multiplier));
    }
    std::iota(this->Order.begin(), this->Order.end(), 0);
    const auto getCell = [&cells](int i) { return cells[static_cast<std::size_t>(i)]; };
    std::stable_sort(this->Order.begin(), this->Order.end(),
      [&getCell](int a, int b) { return getCell(a) < getCell(b); });
    for (std::size_t i = 0; i < this->Order.size(); ++i)
    {
      if (i == 0 || getCell(this->Order[i]) != getCell(this->Order[i - 1]))
      {
        this->Begin.push_back(i);
      }
    }
    this->Begin.push_back(this->Order.size());
  }

  std::size_t GetNumberOfCells() const { return this->Begin.size() - 1; }

  /// Returns the point of a cell that is nearest to a position; the first for ties.
  int GetNearest(std::size_t cell, const Cloud& cloud, const pcl::PointXYZ& place) const
  {
    const auto distance = [&cloud, &place](int i)
    {
      const pcl::PointXYZ& p = cloud[static_cast<std::size_t>(i)];
      return (p.getVector3fMap() - place.getVector3fMap()).squaredNorm();
    };
    const auto begin = this->Order.begin() + static_cast<std::ptrdiff_t>(this->Begin[cell]);
    const auto end = this->Order.begin() + static_cast<std::ptrdiff_t>(this->Begin[cell + 1]);
    return *std::min_element(
      begin, end, [&distance](int a, int b) { return distance(a) < distance(b); });
  }
};

void SetMeanPoints(const Cloud& means, const double origin[3], vtkPolyData* output)
{
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  points->SetNumberOfPoints(static_cast<vtkIdType>(means.size()));
  for (std::size_t i = 0; i < means.size(); ++i)
  {
    const pcl::PointXYZ& p = means[i];
    points->SetPoint(static_cast<vtkIdType>(i), origin[0] + static_cast<double>(p.x),
      origin[1] + static_cast<double>(p.y), origin[2] + static_cast<double>(p.z));
  }
  output->SetPoints(points);
}

void AddCounts(const CellPoints& cells, vtkPolyData* output)
{
  vtkNew<vtkIntArray> counts;
  counts->SetName(vtkHeliosPCLArrayNames::NumberOfPoints);
  counts->SetNumberOfValues(static_cast<vtkIdType>(cells.GetNumberOfCells()));
  for (std::size_t c = 0; c < cells.GetNumberOfCells(); ++c)
  {
    counts->SetValue(
      static_cast<vtkIdType>(c), static_cast<int>(cells.Begin[c + 1] - cells.Begin[c]));
  }
  output->GetPointData()->AddArray(counts);
}

} // namespace

//------------------------------------------------------------------------------
void vtkHeliosPCLVoxelGrid::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "VoxelSize: " << this->VoxelSize << " m\n"
     << indent << "UseMeanPoints: " << this->UseMeanPoints << "\n";
}

//------------------------------------------------------------------------------
/// Checks the number of cells: PCL indexes them by int, and returns its input if that overflows.
bool vtkHeliosPCLVoxelGrid::CheckSize(const helios::PclInput& input)
{
  pcl::PointXYZ low;
  pcl::PointXYZ high;
  pcl::getMinMax3D(*input.GetCloud(), low, high);
  double cells = 1.0;
  for (int axis = 0; axis < 3; ++axis)
  {
    cells *=
      std::floor(static_cast<double>(high.data[axis] - low.data[axis]) / this->VoxelSize) + 2;
  }
  if (cells < static_cast<double>(std::numeric_limits<int>::max()))
  {
    return true;
  }
  vtkErrorMacro(<< "VoxelSize is " << this->VoxelSize << " m, which makes " << cells
                << " cells in the box of the points; the maximum is 2147483647: set a larger one, "
                   "or process the points in tiles");
  return false;
}

//------------------------------------------------------------------------------
bool vtkHeliosPCLVoxelGrid::Process(helios::PclInput& input, vtkPolyData* output)
{
  if (!this->CheckSize(input))
  {
    return false;
  }
  const auto made = std::make_shared<std::pair<pcl::VoxelGrid<pcl::PointXYZ>, Cloud>>();
  const auto size = static_cast<float>(this->VoxelSize);
  made->first.setInputCloud(input.GetCloud());
  made->first.setLeafSize(size, size, size);
  if (!helios::RunApart([this](double share) { return this->GoOn(share); }, 0.15,
        [made] { made->first.filter(made->second); }))
  {
    return false;
  }
  const Cloud& means = made->second;
  const CellPoints cells(made->first, *input.GetCloud());
  if (means.size() != cells.GetNumberOfCells())
  {
    vtkErrorMacro(<< "PCL made " << means.size() << " points from " << cells.GetNumberOfCells()
                  << " cells; use a VoxelSize other than " << this->VoxelSize << " m");
    return false;
  }
  std::vector<vtkIdType> nearest;
  nearest.reserve(means.size());
  for (std::size_t c = 0; c < means.size(); ++c)
  {
    nearest.push_back(input.GetId(cells.GetNearest(c, *input.GetCloud(), means[c])));
  }
  helios::SelectPoints(input.GetData(), nearest, output);
  if (this->UseMeanPoints)
  {
    SetMeanPoints(means, input.GetOrigin(), output);
  }
  AddCounts(cells, output);
  return true;
}
