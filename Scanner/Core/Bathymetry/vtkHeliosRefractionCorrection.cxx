// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkHeliosRefractionCorrection.h"

#include "heliosFresnel.h"
#include "heliosRayCasterBackends.h"
#include "heliosSceneGeometry.h"
#include "heliosTrajectory.h"
#include "vtkHeliosArrayNames.h"
#include "vtkHeliosRayCaster.h"

#include <vtkDoubleArray.h>
#include <vtkInformation.h>
#include <vtkInformationVector.h>
#include <vtkNew.h>
#include <vtkObjectFactory.h>
#include <vtkPointData.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>
#include <vtkSMPTools.h>

#include <algorithm>
#include <cmath>
#include <string>

vtkStandardNewMacro(vtkHeliosRefractionCorrection);

namespace names = vtkHeliosArrayNames;

namespace
{

constexpr vtkIdType BlockSize = 65536; // between checks for an abort request

/// Corrects echoes one by one.
struct Corrector
{
  const helios::Trajectory& Trajectory;
  const vtkHeliosRayCaster& Water;
  helios::Vec3 LeverArm;
  double Index;
  double Slowness;     // the group index
  vtkDataArray* Times; // null: any
  vtkDoubleArray* Points;
  vtkDoubleArray* Depths;

  helios::Vec3 GetOrigin(vtkIdType i) const
  {
    const double time = this->Times ? this->Times->GetComponent(i, 0) : 0.0;
    const helios::Pose pose = this->Trajectory.GetPose(time);
    return pose.Position + helios::Rotation(pose.Orientation) * this->LeverArm;
  }

  void Correct(vtkIdType i) const
  {
    const helios::Vec3 origin = this->GetOrigin(i);
    helios::Vec3 direction = helios::Vec3(this->Points->GetPointer(3 * i)) - origin;
    const double range = direction.Normalize();
    vtkHeliosRay ray;
    std::copy_n(origin.GetData(), 3, ray.Origin);
    std::copy_n(direction.GetData(), 3, ray.Direction);
    vtkHeliosHit hit;
    this->Water.Intersect(&ray, &hit, 1);
    double depth = 0.0;
    if (hit.CellId >= 0 && hit.Range < range)
    {
      helios::Vec3 normal = this->Water.GetGeometry().GetNormal(hit.CellId);
      normal = normal.Dot(direction) > 0.0 ? -1.0 * normal : normal;
      const double refracted = helios::GetRefractedCosine(-normal.Dot(direction), 1.0, this->Index);
      const double length = (range - hit.Range) / this->Slowness;
      const helios::Vec3 end = origin + hit.Range * direction +
        length * helios::GetRefracted(direction, normal, 1.0, this->Index, refracted);
      std::copy_n(end.GetData(), 3, this->Points->GetPointer(3 * i));
      depth = length * refracted;
    }
    this->Depths->SetValue(i, depth);
  }
};

} // namespace

//------------------------------------------------------------------------------
vtkHeliosRefractionCorrection::vtkHeliosRefractionCorrection()
{
  this->SetNumberOfInputPorts(3);
}

//------------------------------------------------------------------------------
int vtkHeliosRefractionCorrection::FillInputPortInformation(int, vtkInformation* info)
{
  info->Set(vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE(), "vtkPolyData");
  return 1;
}

//------------------------------------------------------------------------------
int vtkHeliosRefractionCorrection::RequestData(
  vtkInformation*, vtkInformationVector** inputs, vtkInformationVector* outputs)
{
  vtkPolyData* cloud = vtkPolyData::GetData(inputs[0]);
  vtkPolyData* output = vtkPolyData::GetData(outputs);
  helios::Trajectory trajectory;
  const helios::Status status = trajectory.Set(vtkPolyData::GetData(inputs[2]));
  if (!status.IsOk())
  {
    vtkErrorMacro(<< status.Message());
    return 0;
  }
  vtkDataArray* times = cloud->GetPointData()->GetArray(names::GpsTime);
  if (!times && !trajectory.IsStatic())
  {
    vtkErrorMacro(<< "the cloud has no point array " << names::GpsTime
                  << ", by which echoes find their place on the trajectory");
    return 0;
  }
  const auto water = helios::MakeDefaultRayCaster();
  if (!water->Build(vtkPolyData::GetData(inputs[1])))
  {
    vtkErrorMacro(<< "the surface of the water (port 1) has no triangles that can be hit");
    return 0;
  }
  const vtkIdType count = cloud->GetNumberOfPoints();
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  points->DeepCopy(cloud->GetPoints());
  vtkNew<vtkDoubleArray> depths;
  depths->SetName(names::WaterDepth);
  depths->SetNumberOfValues(count);
  const Corrector corrector{ trajectory, *water, helios::Vec3(this->LeverArm),
    this->RefractiveIndex, this->GroupIndex > 0.0 ? this->GroupIndex : this->RefractiveIndex, times,
    vtkDoubleArray::SafeDownCast(points->GetData()), depths };
  for (vtkIdType first = 0; first < count && !this->GetAbortExecute(); first += BlockSize)
  {
    vtkSMPTools::For(first, std::min(first + BlockSize, count),
      [&corrector](vtkIdType begin, vtkIdType end)
      {
        for (vtkIdType i = begin; i < end; ++i)
        {
          corrector.Correct(i);
        }
      });
    this->UpdateProgress(static_cast<double>(first) / static_cast<double>(count));
  }
  output->ShallowCopy(cloud);
  output->SetPoints(points);
  output->GetPointData()->AddArray(depths);
  return 1;
}

//------------------------------------------------------------------------------
void vtkHeliosRefractionCorrection::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "RefractiveIndex: " << this->RefractiveIndex << "\n"
     << indent << "GroupIndex: " << this->GroupIndex << "\n"
     << indent << "LeverArm: " << this->LeverArm[0] << " " << this->LeverArm[1] << " "
     << this->LeverArm[2] << " m\n";
}
