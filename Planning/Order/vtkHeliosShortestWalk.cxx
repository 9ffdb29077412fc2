// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkHeliosShortestWalk.h"

#include "heliosTour.h"

#include <vtkCellArray.h>
#include <vtkFieldData.h>
#include <vtkInformation.h>
#include <vtkInformationVector.h>
#include <vtkMath.h>
#include <vtkNew.h>
#include <vtkObjectFactory.h>
#include <vtkPointData.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>

#include <algorithm>
#include <cmath>
#include <vector>

vtkStandardNewMacro(vtkHeliosShortestWalk);

namespace
{

constexpr vtkIdType MaximumPositions = 1000;

double GetDistance(vtkPolyData* positions, vtkIdType i, vtkIdType k)
{
  double a[3], b[3];
  positions->GetPoint(i, a);
  positions->GetPoint(k, b);
  return std::sqrt(vtkMath::Distance2BetweenPoints(a, b));
}

/// Distances of positions; of an open walk with a last place that is at distance 0 of all.
helios::DistanceTable MakeTable(vtkPolyData* positions, bool isClosed)
{
  const auto count = static_cast<int>(positions->GetNumberOfPoints());
  helios::DistanceTable table(count + (isClosed ? 0 : 1));
  for (int i = 0; i < count; ++i)
  {
    for (int k = i + 1; k < count; ++k)
    {
      table.Set(i, k, GetDistance(positions, i, k));
    }
  }
  return table;
}

/// Returns the walk of a round trip: without the last place, beginning nearer to position 0.
std::vector<int> MakeWalk(std::vector<int> order, vtkPolyData* positions, bool isClosed)
{
  const auto count = static_cast<int>(positions->GetNumberOfPoints());
  if (isClosed)
  {
    return order; // begins with 0
  }
  const auto cut = std::find(order.begin(), order.end(), count);
  std::rotate(order.begin(), cut, order.end());
  order.erase(order.begin());
  if (!order.empty() &&
    GetDistance(positions, order.back(), 0) < GetDistance(positions, order.front(), 0))
  {
    std::reverse(order.begin(), order.end());
  }
  return order;
}

void Store(vtkPolyData* positions, const std::vector<int>& order, vtkPolyData* output)
{
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  vtkNew<vtkCellArray> vertices;
  vtkPointData* data = output->GetPointData();
  data->CopyAllOn();
  data->CopyAllocate(positions->GetPointData(), positions->GetNumberOfPoints());
  for (const int i : order)
  {
    const vtkIdType id = points->InsertNextPoint(positions->GetPoint(i));
    data->CopyData(positions->GetPointData(), i, id);
    vertices->InsertNextCell(1, &id);
  }
  output->SetPoints(points);
  output->SetVerts(vertices);
  output->GetFieldData()->PassData(positions->GetFieldData());
}

} // namespace

//------------------------------------------------------------------------------
int vtkHeliosShortestWalk::RequestData(
  vtkInformation*, vtkInformationVector** inputs, vtkInformationVector* outputs)
{
  vtkPolyData* positions = vtkPolyData::GetData(inputs[0]);
  const vtkIdType count = positions->GetNumberOfPoints();
  if (count > MaximumPositions)
  {
    vtkErrorMacro(<< "there are " << count << " positions; give at most " << MaximumPositions);
    return 0;
  }
  for (vtkIdType i = 0; i < count; ++i)
  {
    double p[3];
    positions->GetPoint(i, p);
    if (!std::isfinite(p[0] + p[1] + p[2]))
    {
      vtkErrorMacro(<< "position " << i << " is (" << p[0] << ", " << p[1] << ", " << p[2]
                    << "); give finite coordinates");
      return 0;
    }
  }
  const helios::Tour tour = helios::SolveTour(MakeTable(positions, this->Closed));
  Store(positions, MakeWalk(tour.Order, positions, this->Closed), vtkPolyData::GetData(outputs));
  this->Length = tour.Length;
  this->LowerBound = tour.Bound;
  return 1;
}

//------------------------------------------------------------------------------
void vtkHeliosShortestWalk::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "Closed: " << this->Closed << "\n"
     << indent << "Length: " << this->Length << " m\n"
     << indent << "LowerBound: " << this->LowerBound << " m\n";
}
