// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
#include "heliosPolygonTriangulator.h"

#include <vtkCellArray.h>
#include <vtkContourTriangulator.h>
#include <vtkNew.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>

#include <algorithm>
#include <cmath>

namespace helios
{

namespace
{

constexpr double AreaTolerance = 1e-6; // of the area of a polygon

/// The vector from a vertex to another.
Vec3 GetSide(const double* points, vtkTypeInt32 from, vtkTypeInt32 to)
{
  return Vec3(points + 3 * static_cast<vtkIdType>(to)) -
    Vec3(points + 3 * static_cast<vtkIdType>(from));
}

/// Twice the area of a triangle as a vector along its normal.
Vec3 GetCross(const double* points, vtkTypeInt32 a, vtkTypeInt32 b, vtkTypeInt32 c)
{
  return GetSide(points, a, b).Cross(GetSide(points, a, c));
}

/// Twice the area of a ring as a vector (Newell), computed relative to its first vertex.
Vec3 GetAreaVector(const double* points, const std::vector<vtkTypeInt32>& ring)
{
  Vec3 sum(0.0, 0.0, 0.0);
  for (std::size_t i = 2; i < ring.size(); ++i)
  {
    sum = sum + GetCross(points, ring[0], ring[i - 1], ring[i]);
  }
  return sum;
}

/// A ring without vertices that repeat the one before; also the last one, if it is the first.
std::vector<vtkTypeInt32> RemoveRepeated(std::vector<vtkTypeInt32> ring)
{
  ring.erase(std::unique(ring.begin(), ring.end()), ring.end());
  while (ring.size() > 1 && ring.front() == ring.back())
  {
    ring.pop_back();
  }
  return ring;
}

} // namespace

//------------------------------------------------------------------------------
bool PolygonTriangulator::Triangulate(const double* points, const PolygonRings& rings)
{
  this->Corners.clear();
  this->SetRings(points, rings);
  if (!(this->Area > 0.0))
  {
    return this->Area == 0.0;
  }
  if (this->Rings.size() == 1 && this->IsConvex())
  {
    this->AddFan();
  }
  else
  {
    this->AddContours();
  }
  return std::abs(this->ComputeTriangleArea() - this->Area) <= AreaTolerance * this->Area;
}

//------------------------------------------------------------------------------
void PolygonTriangulator::SetRings(const double* points, const PolygonRings& rings)
{
  this->Points = points;
  this->Rings.clear();
  this->Area = 0.0;
  for (const std::vector<vtkTypeInt32>& given : rings)
  {
    std::vector<vtkTypeInt32> ring = RemoveRepeated(given);
    Vec3 vector = GetAreaVector(points, ring);
    if (this->Rings.empty())
    {
      this->Area = 0.5 * vector.Normalize();
      this->Normal = vector;
      this->Rings.push_back(ring);
    }
    else if (const double area = 0.5 * vector.Dot(this->Normal); area != 0.0)
    {
      this->Area -= std::abs(area);
      area > 0.0 ? std::reverse(ring.begin(), ring.end()) : void();
      this->Rings.push_back(ring);
    }
  }
}

//------------------------------------------------------------------------------
bool PolygonTriangulator::IsConvex() const
{
  const std::vector<vtkTypeInt32>& ring = this->Rings.front();
  const std::size_t count = ring.size();
  for (std::size_t i = 0; i < count; ++i)
  {
    const Vec3 turn = GetCross(this->Points, ring[i], ring[(i + 1) % count], ring[(i + 2) % count]);
    if (count > 3 && turn.Dot(this->Normal) < 0.0)
    {
      return false;
    }
  }
  return true;
}

//------------------------------------------------------------------------------
void PolygonTriangulator::AddFan()
{
  const std::vector<vtkTypeInt32>& ring = this->Rings.front();
  for (std::size_t i = 2; i < ring.size(); ++i)
  {
    this->Corners.insert(this->Corners.end(), { ring[0], ring[i - 1], ring[i] });
  }
}

//------------------------------------------------------------------------------
/// The rings as lines between points relative to the first vertex, moved along the normal into one
/// plane: the triangulator rejects a vertex that is a millimetre off.
void PolygonTriangulator::AddContours()
{
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  vtkNew<vtkCellArray> lines;
  std::vector<vtkTypeInt32> ids;
  const vtkTypeInt32 origin = this->Rings.front().front();
  for (const std::vector<vtkTypeInt32>& ring : this->Rings)
  {
    const auto first = static_cast<vtkIdType>(ids.size());
    const auto count = static_cast<vtkIdType>(ring.size());
    for (vtkIdType i = 0; i < count; ++i)
    {
      ids.push_back(ring[static_cast<std::size_t>(i)]);
      const Vec3 side = GetSide(this->Points, origin, ids.back());
      points->InsertNextPoint((side - side.Dot(this->Normal) * this->Normal).GetData());
      const vtkIdType line[2] = { first + i, first + (i + 1) % count };
      lines->InsertNextCell(2, line);
    }
  }
  vtkNew<vtkPolyData> contours;
  contours->SetPoints(points);
  contours->SetLines(lines);
  vtkNew<vtkCellArray> triangles;
  vtkContourTriangulator::TriangulateContours(
    contours, 0, lines->GetNumberOfCells(), triangles, this->Normal.GetData());
  vtkIdType size = 0;
  const vtkIdType* corners = nullptr;
  for (triangles->InitTraversal(); triangles->GetNextCell(size, corners);)
  {
    for (vtkIdType i = 0; i < size && size == 3; ++i)
    {
      this->Corners.push_back(ids[static_cast<std::size_t>(corners[i])]);
    }
  }
}

//------------------------------------------------------------------------------
/// Seen along the normal; triangles that overlap count twice.
double PolygonTriangulator::ComputeTriangleArea() const
{
  double area = 0.0;
  for (std::size_t i = 0; i < this->Corners.size(); i += 3)
  {
    const vtkTypeInt32* c = this->Corners.data() + i;
    area += 0.5 * std::abs(GetCross(this->Points, c[0], c[1], c[2]).Dot(this->Normal));
  }
  return area;
}

} // namespace helios
