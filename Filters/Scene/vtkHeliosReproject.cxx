// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkHeliosReproject.h"

#include "heliosCoordinateSystem.h"
#include "heliosReprojection.h"
#include "heliosSceneCrs.h"
#include "heliosStatus.h"
#include "heliosTriangleMesh.h"
#include "vtkHeliosArrayNames.h"

#include <vtkDataArray.h>
#include <vtkFieldData.h>
#include <vtkInformation.h>
#include <vtkInformationVector.h>
#include <vtkObjectFactory.h>
#include <vtkPointData.h>
#include <vtkPointSet.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>

#include <string>
#include <vector>

vtkStandardNewMacro(vtkHeliosReproject);

namespace
{

/// Returns the first point, and the corners of the box about all.
std::vector<double> GetSamples(vtkPointSet* data)
{
  std::vector<double> samples(3);
  data->GetPoint(0, samples.data());
  double b[6];
  data->GetBounds(b);
  for (int corner = 0; corner < 4; ++corner)
  {
    samples.insert(samples.end(), { b[corner % 2], b[2 + corner / 2], b[4] });
  }
  return samples;
}

/// Returns steps as fine as the steps of the source.
helios::CoordinateSteps ConvertSteps(helios::CoordinateSteps steps,
  const helios::CoordinateSystem& source, const helios::CoordinateSystem& target)
{
  constexpr double metresPerDegree = 111195.0; // a sphere as large as the Earth
  const auto getUnit = [](const helios::CoordinateSystem& system, int axis)
  {
    return axis == 2          ? system.GetHeightUnit()
      : system.IsGeographic() ? metresPerDegree
                              : system.GetUnit();
  };
  for (int axis = 0; axis < 3; ++axis)
  {
    steps.Scale[axis] *= getUnit(source, axis) / getUnit(target, axis);
  }
  steps.HasOffset = false;
  return steps;
}

/// Returns the decimal year of a GPS time [s]; leap seconds do not matter here.
double GetYear(double gpsTime)
{
  constexpr double first = 1980.0 + 5.0 / 366.0; // 6 January
  constexpr double secondsPerYear = 365.2425 * 86400.0;
  return first + gpsTime / secondsPerYear;
}

/// Returns the epoch of points with times, a decimal year; 0: not known.
double FindEpoch(vtkPointSet* data)
{
  vtkDataArray* epoch = data->GetFieldData()->GetArray(vtkHeliosArrayNames::GpsEpoch);
  vtkDataArray* times = data->GetPointData()->GetArray(vtkHeliosArrayNames::GpsTime);
  if (!epoch || !times || epoch->GetNumberOfValues() != 1 || times->GetNumberOfTuples() == 0)
  {
    return 0.0;
  }
  const double* range = times->GetRange();
  const double year = GetYear(epoch->GetComponent(0, 0) + 0.5 * (range[0] + range[1]));
  constexpr double last = 3000.0;
  return year > GetYear(0.0) && year < last ? year : 0.0;
}

} // namespace

//------------------------------------------------------------------------------
vtkHeliosReproject::~vtkHeliosReproject()
{
  this->SetSourceCRS(nullptr);
  this->SetTargetCRS(nullptr);
}

//------------------------------------------------------------------------------
bool vtkHeliosReproject::FindSystems(
  vtkPointSet* input, helios::CoordinateSystem& source, helios::CoordinateSystem& target)
{
  const std::string own = helios::GetCRS(input);
  const std::string given = this->SourceCRS ? this->SourceCRS : "";
  const std::string wanted = this->TargetCRS ? this->TargetCRS : "";
  if (wanted.empty())
  {
    vtkErrorMacro(<< "TargetCRS is not set; give the target system, e.g. EPSG:32632");
    return false;
  }
  if (given.empty() && own.empty())
  {
    vtkErrorMacro(<< "The input has no CRS in its field data; set SourceCRS, the system it is in");
    return false;
  }
  const helios::Status targetProblem = target.Set(wanted);
  const helios::Status sourceProblem = source.Set(given.empty() ? own : given);
  if (!targetProblem.IsOk() || !sourceProblem.IsOk())
  {
    const char* place = given.empty() ? "CRS of the input" : "SourceCRS";
    vtkErrorMacro(<< (sourceProblem.IsOk() ? "TargetCRS" : place) << ": "
                  << (sourceProblem.IsOk() ? targetProblem.Message() : sourceProblem.Message()));
    return false;
  }
  helios::CoordinateSystem declared;
  const bool isWarned = this->Warned > this->GetMTime();
  if (!isWarned && !given.empty() && !own.empty() &&
    !(declared.Set(own).IsOk() && declared == source))
  {
    vtkWarningMacro(<< "SourceCRS is " << source.GetName() << ", but the input has " << own
                    << "; SourceCRS is used");
  }
  return this->SetHeightUnit(source);
}

//------------------------------------------------------------------------------
/// Applies SourceHeightUnit, or warns if the unit of heights is a guess.
bool vtkHeliosReproject::SetHeightUnit(helios::CoordinateSystem& source)
{
  if (this->SourceHeightUnit > 0.0)
  {
    const helios::CoordinateSystem stated = source.WithHeightUnit(this->SourceHeightUnit);
    if (!stated.IsSet())
    {
      vtkErrorMacro(<< "SourceHeightUnit is " << this->SourceHeightUnit << ", but heights of "
                    << source.GetName() << " are in metres; leave it 0");
      return false;
    }
    source = stated;
  }
  const bool isGuess = !source.HasHeightUnit() && source.GetHeightUnit() != 1.0;
  if (isGuess && !(this->Warned > this->GetMTime()))
  {
    vtkWarningMacro(<< source.GetName() << " does not state the unit of heights, which are read as "
                    << source.GetUnitName() << ", like x and y; if they are not, give the system "
                    << "with a vertical part, or SourceHeightUnit (metres: 1)");
  }
  return true;
}

//------------------------------------------------------------------------------
int vtkHeliosReproject::ExecuteInformation(
  vtkInformation*, vtkInformationVector** inputVector, vtkInformationVector* outputVector)
{
  // Points are independent of each other: input in pieces gives output in pieces.
  outputVector->GetInformationObject(0)->CopyEntry(
    inputVector[0]->GetInformationObject(0), vtkAlgorithm::CAN_HANDLE_PIECE_REQUEST());
  return 1;
}

//------------------------------------------------------------------------------
int vtkHeliosReproject::RequestData(
  vtkInformation*, vtkInformationVector** inputVector, vtkInformationVector* outputVector)
{
  vtkPointSet* input = vtkPointSet::GetData(inputVector[0]);
  if (const helios::Status status = helios::CheckNoInstances(vtkPolyData::SafeDownCast(input));
      !status.IsOk())
  {
    vtkErrorMacro(<< status.Message());
    return 0;
  }
  vtkPointSet* output = vtkPointSet::GetData(outputVector);
  helios::CoordinateSystem source;
  helios::CoordinateSystem target;
  if (!this->FindSystems(input, source, target))
  {
    return 0;
  }
  helios::CoordinateTransform transform;
  helios::Status status = transform.Set(source, target);
  if (!status.IsOk())
  {
    vtkErrorMacro(<< status.Message());
    return 0;
  }
  output->ShallowCopy(input);
  helios::SetCRS(output, target.GetText());
  transform.SetEpoch(this->Epoch > 0.0 ? this->Epoch : FindEpoch(input));
  if (transform.IsIdentity() || input->GetNumberOfPoints() == 0)
  {
    return 1;
  }
  helios::SetCoordinateSteps(
    output, ConvertSteps(helios::GetCoordinateSteps(input), source, target));
  this->Warn(input, transform);
  status = this->Transform(input, output, transform);
  if (!status.IsOk())
  {
    vtkErrorMacro(<< status.Message());
    output->Initialize();
    return 0;
  }
  return 1;
}

//------------------------------------------------------------------------------
void vtkHeliosReproject::Warn(vtkPointSet* input, helios::CoordinateTransform& transform)
{
  const bool isWarned = this->Warned > this->GetMTime();
  const std::vector<double> samples = GetSamples(input);
  const std::string warning = isWarned
    ? std::string()
    : transform.GetWarning(samples.data(), static_cast<vtkIdType>(samples.size() / 3));
  if (!warning.empty())
  {
    vtkWarningMacro(<< warning);
  }
  this->Warned.Modified();
}

//------------------------------------------------------------------------------
helios::Status vtkHeliosReproject::Transform(
  vtkPointSet* input, vtkPointSet* output, const helios::CoordinateTransform& transform)
{
  double done = 0.0;
  const auto watch = [&](double share)
  {
    this->UpdateProgress(done + share / 3.0);
    return !this->GetAbortExecute();
  };
  helios::Reprojection reprojection(transform, watch);
  helios::Status status = reprojection.TransformCells(input, output);
  done = 1.0 / 3.0;
  if (status.IsOk() && !reprojection.IsAborted())
  {
    status = reprojection.TransformPointData(input, output);
  }
  done = 2.0 / 3.0;
  if (status.IsOk() && !reprojection.IsAborted())
  {
    status = reprojection.TransformPoints(input, output);
  }
  if (reprojection.IsAborted())
  {
    output->Initialize();
  }
  return status;
}

//------------------------------------------------------------------------------
void vtkHeliosReproject::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "SourceCRS: " << (this->SourceCRS ? this->SourceCRS : "(the input's)") << "\n";
  os << indent << "TargetCRS: " << (this->TargetCRS ? this->TargetCRS : "(none)") << "\n"
     << indent << "Epoch: " << this->Epoch << "\n"
     << indent << "SourceHeightUnit: " << this->SourceHeightUnit << "\n";
}
