// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
#include "heliosMeshFrames.h"

#include <vtkCellArray.h>
#include <vtkDoubleArray.h>
#include <vtkNew.h>
#include <vtkPoints.h>
#include <vtkTypeInt32Array.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace helios
{

namespace
{

using Box = std::array<double, 6>;

Box MakeEmpty()
{
  constexpr double endless = std::numeric_limits<double>::infinity();
  return { endless, -endless, endless, -endless, endless, -endless };
}

void Widen(Box& box, const Box& by)
{
  for (std::size_t i = 0; i < 6; i += 2)
  {
    box[i] = std::min(box[i], by[i]);
    box[i + 1] = std::max(box[i + 1], by[i + 1]);
  }
}

double GetDiagonal(const Box& b)
{
  return std::hypot(b[1] - b[0], b[3] - b[2], b[5] - b[4]);
}

} // namespace

//------------------------------------------------------------------------------
void MeshFrames::Add(vtkPolyData* frame)
{
  const double* points = vtkDoubleArray::FastDownCast(frame->GetPoints()->GetData())->GetPointer(0);
  vtkPolyData* first = this->Frames.empty() ? frame : this->Frames.front().Get();
  vtkTypeInt32Array* corners = first->GetPolys()->GetConnectivityArray32();
  Box box = MakeEmpty();
  for (vtkIdType i = 0; i < corners->GetNumberOfValues(); ++i)
  {
    const double* p = points + 3 * static_cast<vtkIdType>(corners->GetValue(i));
    Widen(box, { p[0], p[0], p[1], p[1], p[2], p[2] });
  }
  this->Frames.emplace_back(frame);
  this->Points.push_back(points);
  this->Bounds.push_back(box);
}

//------------------------------------------------------------------------------
std::array<double, 6> MeshFrames::GetBounds() const
{
  Box all = MakeEmpty();
  for (const Box& box : this->Bounds)
  {
    Widen(all, box);
  }
  return all;
}

//------------------------------------------------------------------------------
std::size_t MeshFrames::FindLargest() const
{
  const auto isSmaller = [](const Box& a, const Box& b) { return GetDiagonal(a) < GetDiagonal(b); };
  const auto largest = std::max_element(this->Bounds.begin(), this->Bounds.end(), isSmaller);
  return static_cast<std::size_t>(largest - this->Bounds.begin());
}

//------------------------------------------------------------------------------
MeshFrames MeshFrames::MakePlaced(const Similarity& place) const
{
  vtkTypeInt32Array* corners = this->Frames.front()->GetPolys()->GetConnectivityArray32();
  const vtkTypeInt32* begin = corners->GetPointer(0);
  const auto [first, last] = std::minmax_element(begin, begin + corners->GetNumberOfValues());
  const vtkIdType count = *last - *first + 1;
  vtkNew<vtkCellArray> polys;
  polys->Use32BitStorage();
  for (vtkIdType i = 0; i < corners->GetNumberOfValues(); i += 3)
  {
    polys->InsertNextCell({ begin[i] - *first, begin[i + 1] - *first, begin[i + 2] - *first });
  }
  MeshFrames placed;
  for (const double* from : this->Points)
  {
    vtkNew<vtkPoints> points;
    points->SetDataTypeToDouble();
    points->SetNumberOfPoints(count);
    double* to = vtkDoubleArray::FastDownCast(points->GetData())->GetPointer(0);
    for (vtkIdType i = 0; i < 3 * count; i += 3)
    {
      place.Apply(from + 3 * static_cast<vtkIdType>(*first) + i, to + i);
    }
    vtkNew<vtkPolyData> mesh;
    mesh->SetPoints(points);
    mesh->SetPolys(polys);
    placed.Add(mesh);
  }
  return placed;
}

//------------------------------------------------------------------------------
std::size_t MeshFrames::GetMemorySize() const
{
  std::size_t size = 0;
  for (vtkPolyData* frame : this->Frames)
  {
    size += static_cast<std::size_t>(frame->GetNumberOfPoints()) * 3 * sizeof(double);
  }
  return size;
}

} // namespace helios
