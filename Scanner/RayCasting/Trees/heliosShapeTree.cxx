// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
#include "heliosShapeTree.h"

#include "heliosStopCheck.h"
#include "heliosThreadLoop.h"
#include "heliosTriangleArea.h"

#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

namespace helios
{

namespace
{

constexpr vtkIdType Samples = 256; ///< triangles or points of a mean

vtkIdType GetStride(vtkIdType count)
{
  return std::max<vtkIdType>(1, count / Samples);
}

double GetDiagonal(const TriangleMesh& mesh, vtkIdType triangle)
{
  double square = 0.0;
  for (int axis = 0; axis < 3; ++axis)
  {
    const double a = mesh.GetCorner(triangle, 0)[axis];
    const double b = mesh.GetCorner(triangle, 1)[axis];
    const double c = mesh.GetCorner(triangle, 2)[axis];
    const double side = std::max({ a, b, c }) - std::min({ a, b, c });
    square += side * side;
  }
  return std::sqrt(square);
}

/// Returns the triangles that have an area in some of the frames.
std::vector<vtkTypeInt32> FindTriangles(const TriangleMesh& mesh, const MeshFrames& frames)
{
  std::vector<vtkTypeInt32> triangles;
  for (vtkTypeInt32 i = 0; i < mesh.GetNumberOfTriangles(); ++i)
  {
    const vtkTypeInt32* corners = mesh.GetCorners() + 3 * static_cast<vtkIdType>(i);
    bool hasArea = false;
    for (std::size_t frame = 0; frame < frames.GetCount() && !hasArea; ++frame)
    {
      const auto get = [&](int corner)
      { return frames.GetPoints(frame) + 3 * static_cast<vtkIdType>(corners[corner]); };
      hasArea = SpansArea(get(0), get(1), get(2));
    }
    if (hasArea)
    {
      triangles.push_back(i);
    }
  }
  return triangles;
}

} // namespace

//------------------------------------------------------------------------------
ShapePlan::ShapePlan(const MeshFrames& frames)
{
  if (!this->Mesh.Set(frames.GetFrame(frames.FindLargest())).IsOk())
  {
    return; // the geometry of the scene reports why
  }
  StopCheck never(nullptr);
  const OneThreadScope alone; // it runs between two pulses of a thread
  this->Tree.BuildShape(
    this->Mesh, FindTriangles(this->Mesh, frames), frames.GetBounds().data(), never);
  if (this->Tree.IsEmpty())
  {
    return;
  }
  this->Order.Set(this->Tree.GetStorage(), this->Mesh);
  const vtkIdType stride = GetStride(this->Mesh.GetNumberOfTriangles());
  vtkIdType count = 0;
  for (vtkIdType i = 0; i < this->Mesh.GetNumberOfTriangles(); i += stride)
  {
    this->TriangleSize += GetDiagonal(this->Mesh, i);
    ++count;
  }
  this->TriangleSize /= static_cast<double>(count);
}

//------------------------------------------------------------------------------
ShapeTree::ShapeTree(const MeshShape& shape, GetPlan getPlan)
  : Shape(shape)
  , FindPlan(std::move(getPlan))
{
}

//------------------------------------------------------------------------------
bool ShapeTree::HasShape() const
{
  return this->Shape.From == this->From && this->Shape.Fraction >= this->Low &&
    this->Shape.Fraction <= this->High;
}

//------------------------------------------------------------------------------
void ShapeTree::Follow()
{
  ++this->Uses;
  if (this->HasShape())
  {
    return;
  }
  if (!this->Plan)
  {
    this->Plan = this->FindPlan();
    this->Tree.CopyShape(this->Plan->Tree, this->Shape);
  }
  if (!this->Tree.IsEmpty())
  {
    this->ChooseParts();
    this->Fit();
  }
}

//------------------------------------------------------------------------------
/// Returns by how much points move from frame to frame, in the mean [m].
double ShapeTree::GetMeanWay() const
{
  const vtkIdType stride = GetStride(this->Plan->Mesh.GetNumberOfPoints());
  double sum = 0.0;
  vtkIdType count = 0;
  for (vtkIdType i = 0; i < this->Plan->Mesh.GetNumberOfPoints(); i += stride)
  {
    sum += (Vec3(this->Shape.To + 3 * i) - Vec3(this->Shape.From + 3 * i)).Norm();
    ++count;
  }
  return sum / static_cast<double>(count);
}

//------------------------------------------------------------------------------
/// Chooses parts of the way in which points move less than a triangle is wide, if there are enough
/// pulses to pay for fitting the tree so often. Results do not depend on it.
void ShapeTree::ChooseParts()
{
  constexpr double perPulse = 200.0; // triangles that are fitted in the time of a pulse
  constexpr double wide = 0.5;       // relative to a triangle
  constexpr double narrow = 0.1;
  constexpr int maximum = 64;
  const double way = this->GetMeanWay() / this->Parts;
  const double work = perPulse * static_cast<double>(this->Uses) /
    static_cast<double>(this->Plan->Mesh.GetNumberOfTriangles());
  const double size = this->Plan->TriangleSize;
  if (way > wide * size && work > 1.0 && this->Parts < maximum)
  {
    this->Parts *= 2;
  }
  else if ((way < narrow * size || work < 0.25) && this->Parts > 1)
  {
    this->Parts /= 2;
  }
}

//------------------------------------------------------------------------------
void ShapeTree::Fit()
{
  const double parts = this->Parts;
  const double part = std::min(std::floor(this->Shape.Fraction * parts), parts - 1.0);
  const bool holds = this->Shape.Hold * parts >= 1.0 || this->Shape.From == this->Shape.To;
  this->From = this->Shape.From;
  this->Low = holds ? this->Shape.Fraction : std::min(part / parts, this->Shape.Fraction);
  this->High = holds ? this->Shape.Fraction : std::max((part + 1.0) / parts, this->Shape.Fraction);
  this->Tree.Fit(this->Plan->Order, this->Low, this->High, this->Refit);
  this->Uses = 0;
}

} // namespace helios
