// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkHeliosClearance.h"

#include "heliosBvh.h"
#include "heliosFlatScene.h"
#include "heliosSceneGeometry.h"
#include "heliosSceneTree.h"
#include "heliosStatus.h"
#include "heliosStopCheck.h"
#include "heliosTriangleMesh.h"
#include "vtkHeliosArrayNames.h"
#include "vtkHeliosScene.h"

#include <vtkDoubleArray.h>
#include <vtkInformation.h>
#include <vtkInformationVector.h>
#include <vtkNew.h>
#include <vtkObjectFactory.h>
#include <vtkPointData.h>
#include <vtkPolyData.h>
#include <vtkSmartPointer.h>

#include <algorithm>
#include <cmath>
#include <iomanip>
#include <limits>
#include <sstream>
#include <string>

namespace names = vtkHeliosArrayNames;
using helios::Vec3;

namespace
{

constexpr double None = std::numeric_limits<double>::infinity();

/// The scene, for distance queries from segments.
class Surroundings
{
public:
  /// Builds from a scene: for heights, without copies of instances; for distances, with them.
  helios::Status Build(vtkPolyData* scene, bool forHeights)
  {
    this->IsWhole = forHeights && vtkHeliosScene::HasInstances(scene);
    return this->IsWhole ? this->BuildWhole(scene) : this->BuildMesh(scene);
  }

  /// Returns the height above the surface below, along the segment from a to b.
  double FindHeight(const Vec3& a, const Vec3& b, double spacing) const
  {
    const double pieces = std::max(1.0, std::ceil((b - a).Norm() / spacing));
    double height = this->GetHeight(b);
    for (double k = 0.0; k < pieces; ++k)
    {
      height = std::min(height, this->GetHeight(a + k / pieces * (b - a)));
    }
    return height;
  }

  /// Returns the distance to the nearest surface within a radius, from the segment from a to b.
  double FindDistance(const Vec3& a, const Vec3& b, double radius) const
  {
    // Short segments have tight boxes.
    const double pieces = std::max(1.0, std::ceil((b - a).Norm() / radius));
    double distance = None;
    for (double k = 0.0; k < pieces; ++k)
    {
      const Vec3 from = a + k / pieces * (b - a);
      const Vec3 to = k + 1.0 < pieces ? a + (k + 1.0) / pieces * (b - a) : b;
      distance = std::min(distance, this->Tree.GetDistance(from, to, std::min(distance, radius)));
    }
    return distance;
  }

private:
  helios::Status BuildWhole(vtkPolyData* scene)
  {
    helios::Status status = this->Whole.Set(scene);
    if (status.IsOk())
    {
      helios::StopCheck never(nullptr);
      this->SceneTree.Build(this->Whole, never);
    }
    return status;
  }

  helios::Status BuildMesh(vtkPolyData* scene)
  {
    vtkSmartPointer<vtkPolyData> flat;
    helios::Status status = helios::GetFlatScene(scene, flat);
    status = status.IsOk() ? this->Mesh.Set(flat) : status;
    if (status.IsOk())
    {
      this->Tree.Build(this->Mesh);
    }
    return status;
  }

  double Cast(const Vec3& from, double up) const
  {
    if (this->IsWhole)
    {
      const vtkHeliosRay ray{ { from[0], from[1], from[2] }, { 0.0, 0.0, up } };
      const vtkHeliosHit hit = this->SceneTree.AddOutliers(ray, this->SceneTree.Intersect(ray));
      return hit.CellId < 0 ? None : hit.Range;
    }
    helios::TestRay ray;
    const bool isSet = ray.Set({ { from[0], from[1], from[2] }, { 0.0, 0.0, up } });
    return isSet ? this->Tree.Intersect(ray).Range : None;
  }

  double GetHeight(const Vec3& p) const
  {
    // A ray does not hit a surface at its origin: it starts above, by the rounding of a height.
    const double rounding = 1e-12 * std::max(1.0, std::abs(p[2]));
    const Vec3 start(p[0], p[1], p[2] + rounding);
    const double below = this->Cast(start, -1.0);
    const double above = below < None ? None : this->Cast(start, 1.0);
    const double height = above < None ? -above : below;
    return std::abs(height - rounding) <= rounding ? 0.0 : height - rounding;
  }

  helios::TriangleMesh Mesh;
  helios::Bvh Tree;
  bool IsWhole = false; ///< the scene has instances, which are in the following
  helios::SceneGeometry Whole;
  helios::SceneTree SceneTree;
};

/// Returns "sample 3 at x 1, y 2, z 3 with 4 m".
std::string Describe(vtkPolyData* path, vtkDoubleArray* clearances, vtkIdType sample)
{
  double p[3];
  path->GetPoint(sample, p);
  std::ostringstream text;
  text << std::setprecision(15) << "sample " << sample << " at x " << p[0] << ", y " << p[1]
       << ", z " << p[2] << std::setprecision(6) << " with " << clearances->GetValue(sample)
       << " m";
  return text.str();
}

} // namespace

vtkStandardNewMacro(vtkHeliosClearance);

//------------------------------------------------------------------------------
vtkHeliosClearance::vtkHeliosClearance()
{
  this->SetNumberOfInputPorts(2);
}

//------------------------------------------------------------------------------
int vtkHeliosClearance::FillInputPortInformation(int, vtkInformation* info)
{
  info->Set(vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE(), "vtkPolyData");
  return 1;
}

//------------------------------------------------------------------------------
int vtkHeliosClearance::RequestData(
  vtkInformation*, vtkInformationVector** inputs, vtkInformationVector* outputs)
{
  vtkPolyData* path = vtkPolyData::GetData(inputs[0]);
  vtkPolyData* output = vtkPolyData::GetData(outputs);
  this->NumberBelowMinimum = 0;
  this->FirstBelowMinimum = -1;
  this->SmallestClearance = None;
  vtkNew<vtkDoubleArray> clearances;
  clearances->SetName(names::Clearance);
  if (!this->Measure(path, vtkPolyData::GetData(inputs[1]), clearances) ||
    !this->CheckClearances(path, clearances))
  {
    return 0;
  }
  output->ShallowCopy(path);
  output->GetPointData()->AddArray(clearances);
  return 1;
}

//------------------------------------------------------------------------------
bool vtkHeliosClearance::Measure(vtkPolyData* path, vtkPolyData* scene, vtkDoubleArray* clearances)
{
  if (scene->GetNumberOfCells() == 0 && !vtkHeliosScene::HasInstances(scene))
  {
    vtkErrorMacro(<< "The scene on port 1 is empty; connect the surfaces to keep clear of.");
    return false;
  }
  Surroundings surroundings;
  const helios::Status status = surroundings.Build(scene, this->Direction == DOWN);
  if (!status.IsOk())
  {
    vtkErrorMacro(<< "The scene on port 1 is not valid: " << status.Message() << ".");
    return false;
  }
  const vtkIdType count = path->GetNumberOfPoints();
  vtkDataArray* times = path->GetPointData()->GetArray(names::GpsTime);
  clearances->SetNumberOfValues(count);
  for (vtkIdType i = 0; i < count; ++i)
  {
    const vtkIdType next = std::min(i + 1, count - 1);
    const bool jumps = times && times->GetComponent(i, 0) == times->GetComponent(next, 0);
    const Vec3 a(path->GetPoint(i));
    const Vec3 b(path->GetPoint(jumps ? i : next));
    if (!std::isfinite(a[0] + a[1] + a[2] + b[0] + b[1] + b[2]))
    {
      vtkErrorMacro(<< "Sample " << i << " or " << next << " is not finite; correct it.");
      return false;
    }
    clearances->SetValue(i,
      this->Direction == DOWN ? surroundings.FindHeight(a, b, this->Spacing)
                              : surroundings.FindDistance(a, b, this->Radius));
    this->UpdateProgress(static_cast<double>(i + 1) / static_cast<double>(count));
    if (this->GetAbortExecute())
    {
      vtkErrorMacro(<< "Aborted at sample " << i << "; update again to complete the trajectory.");
      return false;
    }
  }
  return true;
}

//------------------------------------------------------------------------------
bool vtkHeliosClearance::CheckClearances(vtkPolyData* path, vtkDoubleArray* clearances)
{
  vtkIdType nearest = 0;
  for (vtkIdType i = 0; i < clearances->GetNumberOfValues(); ++i)
  {
    const double clearance = clearances->GetValue(i);
    nearest = clearance < clearances->GetValue(nearest) ? i : nearest;
    if (clearance < this->MinimumClearance)
    {
      this->FirstBelowMinimum = this->NumberBelowMinimum == 0 ? i : this->FirstBelowMinimum;
      ++this->NumberBelowMinimum;
    }
  }
  this->SmallestClearance =
    clearances->GetNumberOfValues() > 0 ? clearances->GetValue(nearest) : None;
  if (this->NumberBelowMinimum == 0)
  {
    return true;
  }
  std::ostringstream text;
  text << this->NumberBelowMinimum << " of " << clearances->GetNumberOfValues()
       << " samples are closer to the scene than MinimumClearance (" << this->MinimumClearance
       << " m): the first is " << Describe(path, clearances, this->FirstBelowMinimum)
       << ", the nearest " << Describe(path, clearances, nearest)
       << "; move the trajectory away, or lower MinimumClearance.";
  if (this->FailBelowMinimum)
  {
    vtkErrorMacro(<< text.str());
    return false;
  }
  vtkWarningMacro(<< text.str());
  return true;
}

//------------------------------------------------------------------------------
void vtkHeliosClearance::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "Direction: " << (this->Direction == DOWN ? "Down" : "AllAround") << "\n"
     << indent << "Radius: " << this->Radius << " m\n"
     << indent << "Spacing: " << this->Spacing << " m\n"
     << indent << "MinimumClearance: " << this->MinimumClearance << " m\n"
     << indent << "FailBelowMinimum: " << this->FailBelowMinimum << "\n"
     << indent << "NumberBelowMinimum: " << this->NumberBelowMinimum << "\n"
     << indent << "FirstBelowMinimum: " << this->FirstBelowMinimum << "\n"
     << indent << "SmallestClearance: " << this->SmallestClearance << " m\n";
}
