// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkHeliosVisibilityTestPoints.h"

#include "heliosGridLine.h"
#include "heliosMemory.h"
#include "heliosPlanScene.h"
#include "heliosPointMerger.h"
#include "heliosSceneCrs.h"
#include "heliosStatus.h"
#include "vtkHeliosArrayNames.h"
#include "vtkHeliosRayCaster.h"

#include <vtkDoubleArray.h>
#include <vtkIdTypeArray.h>
#include <vtkInformation.h>
#include <vtkIntArray.h>
#include <vtkNew.h>
#include <vtkObjectFactory.h>
#include <vtkPointData.h>
#include <vtkPolyData.h>
#include <vtkSMPTools.h>

#include <algorithm>
#include <cmath>
#include <sstream>
#include <vector>

namespace names = vtkHeliosArrayNames;
using helios::GridLine;
using helios::Vec3;

namespace
{

/// Intersection of a line and a surface.
struct Meeting
{
  Vec3 Point;
  vtkIdType Hit;
  int Axis; ///< axis of the line
};

/// Rays per batch.
constexpr vtkIdType RaysAtOnce = 2048;

} // namespace

vtkStandardNewMacro(vtkHeliosVisibilityTestPoints);

/// Casts lines through a scene.
class vtkHeliosVisibilityTestPoints::Search
{
public:
  explicit Search(vtkHeliosVisibilityTestPoints* self)
    : Self(self)
  {
  }

  helios::Status Prepare(vtkPolyData* scene)
  {
    if (!this->Self->Vertical && !this->Self->Horizontal)
    {
      return helios::Status::Error("Vertical and horizontal lines are both off; switch one on");
    }
    const helios::Status status = this->Scene.Set(scene);
    return status.IsOk() ? this->MakeGrid() : status;
  }

  /// Casts all lines; false on an abort request.
  bool Run()
  {
    double lines = 0.0;
    for (int axis : { 2, 0, 1 })
    {
      lines += static_cast<double>(this->GetLineCount(axis));
    }
    double done = 0.0;
    for (int axis : { 2, 0, 1 }) // vertical lines first
    {
      const vtkIdType count = this->GetLineCount(axis);
      constexpr vtkIdType LinesAtOnce = 64 * RaysAtOnce;
      for (vtkIdType first = 0; first < count; first += LinesAtOnce)
      {
        this->Self->UpdateProgress(done / lines);
        if (this->Self->GetAbortExecute())
        {
          return false;
        }
        const vtkIdType last = std::min(count, first + LinesAtOnce);
        this->FollowLines(axis, first, last);
        done += static_cast<double>(last - first);
      }
    }
    return true;
  }

  /// Merges points and fills the output; false if there are none.
  bool Fill(vtkPolyData* output)
  {
    const auto count = static_cast<vtkIdType>(this->Found.size());
    std::vector<double> places;
    for (const Meeting& meeting : this->Found)
    {
      places.insert(places.end(), meeting.Point.GetData(), meeting.Point.GetData() + 3);
    }
    helios::PointMerger merger(places.data(), count, this->GetTolerance());
    vtkNew<vtkPoints> points;
    points->SetDataTypeToDouble();
    vtkNew<vtkDoubleArray> normals;
    normals->SetName(names::Normal);
    normals->SetNumberOfComponents(3);
    vtkNew<vtkIdTypeArray> cells;
    cells->SetName(names::CellIds);
    vtkNew<vtkIntArray> parts;
    parts->SetName(names::PartIds);
    vtkNew<vtkDoubleArray> areas;
    areas->SetName(names::Area);
    std::vector<vtkIdType> outputs(this->Found.size(), -1);
    for (vtkIdType i = 0; i < count; ++i)
    {
      const Meeting& meeting = this->Found[static_cast<std::size_t>(i)];
      const vtkIdType own = merger.Add(static_cast<vtkTypeInt32>(i), 0);
      if (own == i)
      {
        outputs[i] = points->InsertNextPoint(meeting.Point.GetData());
        normals->InsertNextTuple(this->Scene.GetNormal(meeting.Hit).GetData());
        cells->InsertNextValue(meeting.Hit);
        parts->InsertNextValue(this->Scene.GetPart(meeting.Hit));
        areas->InsertNextValue(0.0);
      }
      areas->SetValue(outputs[own], areas->GetValue(outputs[own]) + this->GetArea(meeting));
    }
    output->SetPoints(points);
    output->GetPointData()->AddArray(normals);
    output->GetPointData()->AddArray(cells);
    if (count > 0 && parts->GetRange()[1] >= 0.0)
    {
      output->GetPointData()->AddArray(parts);
    }
    if (this->Self->GenerateAreas)
    {
      output->GetPointData()->AddArray(areas);
    }
    return count > 0;
  }

  std::string DescribeGrid() const
  {
    std::ostringstream text;
    text << this->GetLineCount(2) << " vertical and "
         << this->GetLineCount(0) + this->GetLineCount(1) << " horizontal lines";
    return text.str();
  }

private:
  helios::Status MakeGrid()
  {
    static const char* const axes[] = { "x", "y", "z" };
    const double steps[] = { this->Self->XStep, this->Self->YStep, this->Self->ZStep };
    for (int axis = 0; axis < 3; ++axis)
    {
      this->Low[axis] = this->Scene.GetBound(this->Self->Region[2 * axis], 2 * axis);
      this->High[axis] = this->Scene.GetBound(this->Self->Region[2 * axis + 1], 2 * axis + 1);
      this->Steps[axis] = this->Scene.GetStep(steps[axis]);
      if (!(this->Low[axis] <= this->High[axis]))
      {
        std::ostringstream text;
        text << "The region of test points is " << axes[axis] << " " << this->Low[axis] << " to "
             << this->High[axis] << "; the first must not be above the second";
        return helios::Status::Error(text.str());
      }
      this->Lines[axis] = GridLine(this->Low[axis], this->High[axis], this->Steps[axis]);
    }
    double count = 0.0;
    for (int axis = 0; axis < 3; ++axis)
    {
      count += this->IsUsed(axis) ? static_cast<double>(this->Lines[(axis + 1) % 3].GetCount()) *
          static_cast<double>(this->Lines[(axis + 2) % 3].GetCount())
                                  : 0.0;
    }
    const helios::Status status =
      helios::CheckMemoryLimit("lines", count, 3 * sizeof(Meeting), this->Self->MemoryLimit);
    return status.IsOk()
      ? status
      : helios::Status::Error(status.Message() + "; make the grid of test points coarser");
  }

  bool IsUsed(int axis) const { return axis == 2 ? this->Self->Vertical : this->Self->Horizontal; }

  /// Returns the axis along which neighbouring lines lie, and the axis of rows.
  static int GetFast(int axis) { return axis == 0 ? 1 : 0; }
  static int GetSlow(int axis) { return axis == 2 ? 1 : 2; }

  vtkIdType GetLineCount(int axis) const
  {
    return this->IsUsed(axis)
      ? this->Lines[GetFast(axis)].GetCount() * this->Lines[GetSlow(axis)].GetCount()
      : 0;
  }

  void FollowLines(int axis, vtkIdType first, vtkIdType last)
  {
    const vtkIdType batches = (last - first + RaysAtOnce - 1) / RaysAtOnce;
    std::vector<std::vector<Meeting>> found(static_cast<std::size_t>(batches));
    vtkSMPTools::For(0, batches, 1,
      [&](vtkIdType begin, vtkIdType end)
      {
        for (vtkIdType b = begin; b < end; ++b)
        {
          const vtkIdType from = first + b * RaysAtOnce;
          this->FollowBatch(axis, from, std::min(last, from + RaysAtOnce), found[b]);
        }
      });
    for (const std::vector<Meeting>& some : found)
    {
      this->Found.insert(this->Found.end(), some.begin(), some.end());
    }
  }

  /// Casts rays, and again from behind each hit, until there are no more hits.
  void FollowBatch(int axis, vtkIdType first, vtkIdType last, std::vector<Meeting>& found) const
  {
    const double behind = this->GetTolerance();
    std::vector<vtkHeliosRay> rays;
    std::vector<vtkIdType> lines;
    for (vtkIdType line = first; line < last; ++line)
    {
      rays.push_back(this->GetRay(axis, line));
      lines.push_back(line);
    }
    std::vector<std::vector<Meeting>> onLine(rays.size());
    std::vector<vtkHeliosHit> hits(rays.size());
    while (!rays.empty())
    {
      this->Scene.GetCaster().Intersect(
        rays.data(), hits.data(), static_cast<vtkIdType>(rays.size()));
      std::size_t kept = 0;
      for (std::size_t i = 0; i < rays.size(); ++i)
      {
        if (hits[i].CellId < 0)
        {
          continue;
        }
        vtkHeliosRay ray = rays[i];
        const double sign = ray.Direction[axis];
        ray.Origin[axis] += sign * hits[i].Range;
        const Vec3 point(ray.Origin);
        if (this->IsInRegion(point))
        {
          onLine[lines[i] - first].push_back({ point, hits[i].CellId, axis });
        }
        // If the tolerance is below the coordinate's precision, continue at the next number.
        const double next = ray.Origin[axis] + sign * behind;
        ray.Origin[axis] = next != ray.Origin[axis] ? next : std::nextafter(next, sign * 1e300);
        rays[kept] = ray;
        lines[kept] = lines[i];
        ++kept;
      }
      rays.resize(kept);
      lines.resize(kept);
    }
    for (const std::vector<Meeting>& some : onLine)
    {
      found.insert(found.end(), some.begin(), some.end());
    }
  }

  /// Returns the ray of a line: vertical lines go down, horizontal ones up the axis.
  vtkHeliosRay GetRay(int axis, vtkIdType line) const
  {
    const double* bounds = this->Scene.GetBounds();
    const double room = std::max(1.0, bounds[2 * axis + 1] - bounds[2 * axis]);
    const GridLine& fast = this->Lines[GetFast(axis)];
    vtkHeliosRay ray{ {}, { 0.0, 0.0, 0.0 } };
    ray.Direction[axis] = axis == 2 ? -1.0 : 1.0;
    ray.Origin[axis] = axis == 2 ? bounds[5] + room : bounds[2 * axis] - room;
    ray.Origin[GetFast(axis)] = fast.GetPlace(line % fast.GetCount());
    ray.Origin[GetSlow(axis)] = this->Lines[GetSlow(axis)].GetPlace(line / fast.GetCount());
    return ray;
  }

  bool IsInRegion(const Vec3& p) const
  {
    for (int axis = 0; axis < 3; ++axis)
    {
      // The scene's own bounds do not limit: rounding must not drop the highest point.
      if (p[axis] < this->Self->Region[2 * axis] || p[axis] > this->Self->Region[2 * axis + 1])
      {
        return false;
      }
    }
    return true;
  }

  double GetTolerance() const
  {
    const double step = std::min(std::min(this->Steps[0], this->Steps[1]), this->Steps[2]);
    return std::min(this->Self->MergeTolerance, 1e-3 * step);
  }

  double GetArea(const Meeting& meeting) const
  {
    const Vec3 n = this->Scene.GetFaceNormal(meeting.Hit);
    double sum = 0.0;
    for (int axis = 0; axis < 3; ++axis)
    {
      sum += this->IsUsed(axis) ? n[axis] * n[axis] : 0.0;
    }
    const double cell = this->Steps[GetFast(meeting.Axis)] * this->Steps[GetSlow(meeting.Axis)];
    return sum > 0.0 ? cell * std::abs(n[meeting.Axis]) / sum : 0.0;
  }

  vtkHeliosVisibilityTestPoints* Self;
  helios::PlanScene Scene;
  double Low[3];
  double High[3];
  double Steps[3];
  GridLine Lines[3] = { { 0.0, 0.0, 1.0 }, { 0.0, 0.0, 1.0 }, { 0.0, 0.0, 1.0 } };
  std::vector<Meeting> Found;
};

//------------------------------------------------------------------------------
void vtkHeliosVisibilityTestPoints::SetStep(double step)
{
  this->SetXStep(step);
  this->SetYStep(step);
  this->SetZStep(step);
}

//------------------------------------------------------------------------------
int vtkHeliosVisibilityTestPoints::FillInputPortInformation(int, vtkInformation* info)
{
  info->Set(vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE(), "vtkPolyData");
  return 1;
}

//------------------------------------------------------------------------------
int vtkHeliosVisibilityTestPoints::RequestData(
  vtkInformation*, vtkInformationVector** inputs, vtkInformationVector* outputs)
{
  vtkPolyData* scene = vtkPolyData::GetData(inputs[0]);
  Search search(this);
  const helios::Status status = search.Prepare(scene);
  if (!status.IsOk())
  {
    vtkErrorMacro(<< status.Message() << ".");
    return 0;
  }
  if (!search.Run())
  {
    vtkErrorMacro(<< "Aborted; update again for all test points.");
    return 0;
  }
  vtkPolyData* output = vtkPolyData::GetData(outputs);
  if (!search.Fill(output))
  {
    vtkErrorMacro(<< "No test point: none of " << search.DescribeGrid()
                  << " meets a surface in the region; move it onto the scene, or make the grid "
                     "finer.");
    return 0;
  }
  helios::SetCRS(output, helios::GetCRS(scene));
  return 1;
}

//------------------------------------------------------------------------------
void vtkHeliosVisibilityTestPoints::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "XStep: " << this->XStep << " m\n"
     << indent << "YStep: " << this->YStep << " m\n"
     << indent << "ZStep: " << this->ZStep << " m\n"
     << indent << "Region: x " << this->Region[0] << " to " << this->Region[1] << ", y "
     << this->Region[2] << " to " << this->Region[3] << ", z " << this->Region[4] << " to "
     << this->Region[5] << " m\n"
     << indent << "Vertical: " << this->Vertical << "\n"
     << indent << "Horizontal: " << this->Horizontal << "\n"
     << indent << "MergeTolerance: " << this->MergeTolerance << " m\n"
     << indent << "GenerateAreas: " << this->GenerateAreas << "\n"
     << indent << "MemoryLimit: " << this->MemoryLimit << " MiB\n";
}
