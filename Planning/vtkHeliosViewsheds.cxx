// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkHeliosViewsheds.h"

#include "heliosLineOfSight.h"
#include "heliosMemory.h"
#include "heliosRayCasterBackends.h"
#include "heliosStatus.h"
#include "heliosVisibility.h"
#include "vtkHeliosArrayNames.h"
#include "vtkHeliosRayCaster.h"
#include "vtkHeliosScene.h"

#include <vtkDoubleArray.h>
#include <vtkIdList.h>
#include <vtkInformation.h>
#include <vtkInformationVector.h>
#include <vtkNew.h>
#include <vtkObjectFactory.h>
#include <vtkPointData.h>
#include <vtkPolyData.h>
#include <vtkSMPTools.h>
#include <vtkStreamingDemandDrivenPipeline.h>
#include <vtkTypeInt64Array.h>
#include <vtkTypeUInt64Array.h>

#include <algorithm>
#include <cmath>
#include <numeric>
#include <sstream>
#include <vector>

namespace names = vtkHeliosArrayNames;
using helios::LineOfSight;
using helios::Vec3;

namespace
{

/// Returns the values of an array of 3 components as doubles; null if there is no such array.
vtkSmartPointer<vtkDoubleArray> GetDoubles(vtkDataArray* array)
{
  if (!array || array->GetNumberOfComponents() != 3)
  {
    return nullptr;
  }
  vtkSmartPointer<vtkDoubleArray> doubles = vtkDoubleArray::FastDownCast(array);
  if (!doubles)
  {
    doubles = vtkSmartPointer<vtkDoubleArray>::New();
    doubles->DeepCopy(array);
  }
  return doubles;
}

/// Returns the first point that is not finite, or -1.
vtkIdType FindNotFinite(vtkPolyData* data)
{
  for (vtkIdType i = 0; i < data->GetNumberOfPoints(); ++i)
  {
    double p[3];
    data->GetPoint(i, p);
    if (!std::isfinite(p[0] + p[1] + p[2]))
    {
      return i;
    }
  }
  return -1;
}

/// Copies points of a data set with all their arrays.
void CopyPoints(vtkPolyData* from, vtkIdType first, vtkIdType last, vtkPolyData* to)
{
  vtkNew<vtkIdList> ids;
  ids->SetNumberOfIds(last - first);
  std::iota(ids->GetPointer(0), ids->GetPointer(0) + last - first, first);
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  points->SetNumberOfPoints(last - first);
  for (vtkIdType i = first; i < last; ++i)
  {
    points->SetPoint(i - first, from->GetPoint(i));
  }
  to->SetPoints(points);
  to->GetPointData()->CopyAllOn();
  to->GetPointData()->CopyAllocate(from->GetPointData(), last - first);
  vtkNew<vtkIdList> newIds;
  newIds->SetNumberOfIds(last - first);
  std::iota(newIds->GetPointer(0), newIds->GetPointer(0) + last - first, vtkIdType(0));
  to->GetPointData()->CopyData(from->GetPointData(), ids, newIds);
  to->GetFieldData()->ShallowCopy(from->GetFieldData());
}

} // namespace

vtkStandardNewMacro(vtkHeliosViewsheds);

/// Candidates, and the test points they see.
class vtkHeliosViewsheds::Observers
{
public:
  Observers(vtkHeliosViewsheds* self, vtkPolyData* candidates, vtkPolyData* testPoints)
    : Self(self)
    , Candidates(candidates)
    , Points(GetDoubles(testPoints->GetPoints()->GetData()))
    , Normals(GetDoubles(testPoints->GetPointData()->GetArray(names::Normal)))
  {
    this->Targets.Points = this->Points->GetPointer(0);
    this->Targets.Normals = this->Normals ? this->Normals->GetPointer(0) : nullptr;
    this->Targets.Count = testPoints->GetNumberOfPoints();
    this->SetLimits();
    this->Words->SetName(names::Visibility);
    this->Words->SetNumberOfComponents(
      static_cast<int>(helios::Visibility::GetRowLength(this->Targets.Count)));
    this->Words->SetNumberOfTuples(candidates->GetNumberOfPoints());
    std::fill_n(this->Words->GetPointer(0), this->Words->GetNumberOfValues(), 0u);
    this->Angles->SetName(names::MeanIncidenceAngle);
    this->Sizes->SetName(names::ViewshedSize);
  }

  /// Processes all candidates; false on an abort request.
  bool Run()
  {
    const vtkIdType count = this->Candidates->GetNumberOfPoints();
    const vtkIdType runs = this->GetRunCount();
    const vtkIdType atOnce = std::max<vtkIdType>(1, 4096 / runs);
    for (vtkIdType first = 0; first < count; first += atOnce)
    {
      this->Self->UpdateProgress(static_cast<double>(first) / static_cast<double>(count));
      if (this->Self->GetAbortExecute())
      {
        return false;
      }
      this->FillRows(first, std::min(count, first + atOnce));
    }
    return true;
  }

  void Fill(vtkPolyData* output) const
  {
    output->GetPointData()->AddArray(this->Words);
    output->GetPointData()->AddArray(this->Sizes);
    if (this->Targets.Normals)
    {
      output->GetPointData()->AddArray(this->Angles);
    }
  }

  vtkIdType GetNumberOfRays() const { return this->Rays; }

private:
  void SetLimits()
  {
    const vtkHeliosViewsheds* s = this->Self;
    this->Limits.HitTolerance = s->HitTolerance;
    this->Limits.BothSides = s->BothSides;
    this->Limits.MinimumRange = s->MinimumRange;
    this->Limits.MaximumRange = s->MaximumRange;
    this->Limits.MinimumCosine = std::cos(vtkMath::RadiansFromDegrees(s->MaximumIncidenceAngle));
    this->Limits.MinimumSine = std::sin(vtkMath::RadiansFromDegrees(s->MinimumElevation));
    this->Limits.MaximumSine = std::sin(vtkMath::RadiansFromDegrees(s->MaximumElevation));
    const double step = vtkMath::RadiansFromDegrees(s->AngularStep);
    this->Limits.DensityFactor = s->MinimumPointDensity * step * step;
  }

  vtkIdType GetRunCount() const
  {
    return (this->Targets.Count + LineOfSight::PointsAtOnce - 1) / LineOfSight::PointsAtOnce;
  }

  /// Threads process ranges of test points of any candidate.
  void FillRows(vtkIdType first, vtkIdType last)
  {
    const vtkIdType runs = this->GetRunCount();
    std::vector<helios::SightSum> sums(static_cast<std::size_t>((last - first) * runs));
    vtkSMPTools::For(0, (last - first) * runs, 4,
      [&](vtkIdType begin, vtkIdType end)
      {
        LineOfSight sight(*this->Self->RayCaster, this->Targets, this->Limits);
        for (vtkIdType i = begin; i < end; ++i)
        {
          const vtkIdType candidate = first + i / runs;
          const vtkIdType point = i % runs * LineOfSight::PointsAtOnce;
          double eye[3];
          this->Candidates->GetPoints()->GetPoint(candidate, eye);
          vtkTypeUInt64* row = this->Words->GetPointer(0) +
            candidate * static_cast<vtkIdType>(this->Words->GetNumberOfComponents());
          sums[static_cast<std::size_t>(i)] = sight.FindVisible(Vec3(eye), point, row + point / 64);
        }
      });
    for (vtkIdType candidate = first; candidate < last; ++candidate)
    {
      this->AddSums(candidate, &sums[static_cast<std::size_t>((candidate - first) * runs)]);
    }
  }

  void AddSums(vtkIdType candidate, const helios::SightSum* sums)
  {
    helios::SightSum sum;
    for (vtkIdType i = 0; i < this->GetRunCount(); ++i)
    {
      sum.Incidence += sums[i].Incidence;
      sum.Rays += sums[i].Rays;
    }
    const vtkIdType length = this->Words->GetNumberOfComponents();
    const vtkTypeUInt64* row = this->Words->GetPointer(0) + candidate * length;
    const vtkIdType size = std::accumulate(row, row + length, vtkIdType(0),
      [](vtkIdType n, vtkTypeUInt64 word) { return n + __builtin_popcountll(word); });
    this->Sizes->InsertNextValue(size);
    this->Angles->InsertNextValue(size == 0
        ? vtkMath::Nan()
        : vtkMath::DegreesFromRadians(sum.Incidence / static_cast<double>(size)));
    this->Rays += sum.Rays;
  }

  vtkHeliosViewsheds* Self;
  vtkPolyData* Candidates;
  vtkSmartPointer<vtkDoubleArray> Points;
  vtkSmartPointer<vtkDoubleArray> Normals;
  helios::SightTargets Targets;
  helios::SightLimits Limits;
  vtkNew<vtkTypeUInt64Array> Words;
  vtkNew<vtkTypeInt64Array> Sizes;
  vtkNew<vtkDoubleArray> Angles;
  vtkIdType Rays = 0;
};

//------------------------------------------------------------------------------
vtkHeliosViewsheds::vtkHeliosViewsheds()
{
  this->SetNumberOfInputPorts(3);
  this->RayCaster = helios::MakeDefaultRayCaster();
}

//------------------------------------------------------------------------------
vtkHeliosViewsheds::~vtkHeliosViewsheds() = default;

//------------------------------------------------------------------------------
void vtkHeliosViewsheds::SetRayCaster(vtkHeliosRayCaster* caster)
{
  if (this->RayCaster != caster)
  {
    this->RayCaster = caster;
    this->Modified();
  }
}

//------------------------------------------------------------------------------
vtkHeliosRayCaster* vtkHeliosViewsheds::GetRayCaster() const
{
  return this->RayCaster;
}

//------------------------------------------------------------------------------
int vtkHeliosViewsheds::FillInputPortInformation(int, vtkInformation* info)
{
  info->Set(vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE(), "vtkPolyData");
  return 1;
}

//------------------------------------------------------------------------------
int vtkHeliosViewsheds::RequestInformation(
  vtkInformation*, vtkInformationVector**, vtkInformationVector* outputs)
{
  outputs->GetInformationObject(0)->Set(vtkAlgorithm::CAN_HANDLE_PIECE_REQUEST(), 1);
  return 1;
}

//------------------------------------------------------------------------------
int vtkHeliosViewsheds::RequestUpdateExtent(
  vtkInformation*, vtkInformationVector** inputs, vtkInformationVector*)
{
  using Pipeline = vtkStreamingDemandDrivenPipeline;
  for (int port : { 0, 1, 2 })
  {
    vtkInformation* info = inputs[port]->GetInformationObject(0);
    info->Set(Pipeline::UPDATE_PIECE_NUMBER(), 0); // inputs are always complete
    info->Set(Pipeline::UPDATE_NUMBER_OF_PIECES(), 1);
    info->Set(Pipeline::UPDATE_NUMBER_OF_GHOST_LEVELS(), 0);
  }
  return 1;
}

//------------------------------------------------------------------------------
int vtkHeliosViewsheds::RequestData(
  vtkInformation*, vtkInformationVector** inputs, vtkInformationVector* outputs)
{
  using Pipeline = vtkStreamingDemandDrivenPipeline;
  vtkPolyData* scene = vtkPolyData::GetData(inputs[0]);
  vtkPolyData* candidates = vtkPolyData::GetData(inputs[1]);
  vtkPolyData* testPoints = vtkPolyData::GetData(inputs[2]);
  vtkInformation* info = outputs->GetInformationObject(0);
  const vtkIdType pieces = std::max(1, info->Get(Pipeline::UPDATE_NUMBER_OF_PIECES()));
  const vtkIdType piece = info->Get(Pipeline::UPDATE_PIECE_NUMBER());
  const vtkIdType count = candidates->GetNumberOfPoints();
  const vtkIdType first = count / pieces * piece + count % pieces * piece / pieces;
  const vtkIdType last = count / pieces * (piece + 1) + count % pieces * (piece + 1) / pieces;

  this->NumberOfRays = 0;
  helios::Status status = this->FindFault(scene, candidates, testPoints);
  status = status.IsOk() ? this->FindExcess(last - first, testPoints->GetNumberOfPoints()) : status;
  if (status.IsOk() && !this->RayCaster->Build(scene))
  {
    status = helios::Status::Error("No rays can be cast onto the scene on port 0");
  }
  if (!status.IsOk())
  {
    vtkErrorMacro(<< status.Message() << ".");
    return 0;
  }
  vtkPolyData* output = vtkPolyData::GetData(outputs);
  CopyPoints(candidates, first, last, output);
  Observers observers(this, output, testPoints);
  if (!observers.Run())
  {
    vtkErrorMacro(<< "Aborted; update again for all viewsheds.");
    return 0;
  }
  observers.Fill(output);
  this->NumberOfRays = observers.GetNumberOfRays();
  return 1;
}

//------------------------------------------------------------------------------
helios::Status vtkHeliosViewsheds::FindFault(
  vtkPolyData* scene, vtkPolyData* candidates, vtkPolyData* testPoints) const
{
  using helios::Status;
  if (!this->RayCaster)
  {
    return Status::Error("RayCaster is not set; set one, e.g. a vtkHeliosBvhRayCaster");
  }
  if (scene->GetNumberOfCells() == 0 && !vtkHeliosScene::HasInstances(scene))
  {
    return Status::Error("The scene on port 0 is empty; connect what hides test points");
  }
  if (candidates->GetNumberOfPoints() == 0)
  {
    return Status::Error("There are no candidates on port 1; connect a "
                         "vtkHeliosScanPositionCandidates, or points of your own");
  }
  if (testPoints->GetNumberOfPoints() == 0)
  {
    return Status::Error("There are no test points on port 2; connect a "
                         "vtkHeliosVisibilityTestPoints, or points of your own");
  }
  if (const vtkIdType i = FindNotFinite(candidates); i >= 0)
  {
    return Status::Error("Candidate " + std::to_string(i) + " is not finite; correct or remove it");
  }
  if (const vtkIdType i = FindNotFinite(testPoints); i >= 0)
  {
    return Status::Error(
      "Test point " + std::to_string(i) + " is not finite; correct or remove it");
  }
  if (!GetDoubles(testPoints->GetPointData()->GetArray(names::Normal)) &&
    (this->MaximumIncidenceAngle < 90.0 || this->MinimumPointDensity > 0.0))
  {
    return Status::Error(
      std::string("A maximum incidence angle and a minimum point density need normals, and the "
                  "test points have no point array ") +
      names::Normal + " of 3 components; add it, or do not set these limits");
  }
  if (this->MinimumPointDensity > 0.0 && this->AngularStep == 0.0)
  {
    return Status::Error("A minimum point density needs the angle between neighbouring pulses, "
                         "and AngularStep is 0, unknown or irregular; set it, or give no minimum "
                         "density");
  }
  return {};
}

//------------------------------------------------------------------------------
helios::Status vtkHeliosViewsheds::FindExcess(vtkIdType candidates, vtkIdType testPoints) const
{
  const double row = 8.0 * static_cast<double>(helios::Visibility::GetRowLength(testPoints));
  const helios::Status status = helios::CheckMemoryLimit(
    "candidates' views", static_cast<double>(candidates), row, this->MemoryLimit);
  return status.IsOk() ? status
                       : helios::Status::Error(status.Message() +
                           "; make the grids coarser, ask for the matrix in pieces, or allow more");
}

//------------------------------------------------------------------------------
void vtkHeliosViewsheds::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "RayCaster: " << (this->RayCaster ? this->RayCaster->GetName() : "(none)") << "\n"
     << indent << "HitTolerance: " << this->HitTolerance << " m\n"
     << indent << "BothSides: " << this->BothSides << "\n"
     << indent << "MinimumRange: " << this->MinimumRange << " m\n"
     << indent << "MaximumRange: " << this->MaximumRange << " m\n"
     << indent << "MaximumIncidenceAngle: " << this->MaximumIncidenceAngle << " deg\n"
     << indent << "MinimumElevation: " << this->MinimumElevation << " deg\n"
     << indent << "MaximumElevation: " << this->MaximumElevation << " deg\n"
     << indent << "MinimumPointDensity: " << this->MinimumPointDensity << " 1/m2\n"
     << indent << "AngularStep: " << this->AngularStep << " deg\n"
     << indent << "MemoryLimit: " << this->MemoryLimit << " MiB\n"
     << indent << "NumberOfRays: " << this->NumberOfRays << "\n";
}
