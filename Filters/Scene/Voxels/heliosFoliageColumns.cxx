// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
#include "heliosFoliageColumns.h"

#include "heliosStatus.h"
#include "vtkHeliosArrayNames.h"

#include <vtkFieldData.h>
#include <vtkMath.h>
#include <vtkPointData.h>
#include <vtkPolyData.h>

#include <algorithm>
#include <cmath>
#include <string>

namespace names = vtkHeliosArrayNames;

namespace helios
{

namespace
{

// Classes of LAS.
constexpr int Noise[] = { 7, 18 };
constexpr int NoPlants[] = { 2, 7, 9, 18 }; // ground, noise, water

/// Smallest cosine of an incidence: below it a leaf weighs no more.
constexpr double SmallestCosine = 0.02;

/// Mean |cos| of the incidence on elements of random orientation that are hit.
constexpr double MeanHitCosine = 2.0 / 3.0;

constexpr double EpochTolerance = 1.0; // beyond the ends of a trajectory [s]

template <typename ListT>
bool Has(const ListT& list, double value)
{
  return std::find(std::begin(list), std::end(list), static_cast<int>(value)) != std::end(list);
}

double GetEpoch(vtkPolyData* data)
{
  vtkDataArray* epoch = data->GetFieldData()->GetArray(names::GpsEpoch);
  return epoch && epoch->GetNumberOfTuples() > 0 ? epoch->GetTuple1(0) : 0.0;
}

} // namespace

//------------------------------------------------------------------------------
vtkSmartPointer<vtkDoubleArray> GetDoubles(vtkDataArray* array)
{
  vtkSmartPointer<vtkDoubleArray> doubles = vtkDoubleArray::FastDownCast(array);
  if (!doubles)
  {
    doubles = vtkSmartPointer<vtkDoubleArray>::New();
    doubles->DeepCopy(array);
  }
  return doubles;
}

//------------------------------------------------------------------------------
bool IsPlantClass(int id)
{
  return !Has(NoPlants, id);
}

//------------------------------------------------------------------------------
Status FoliageColumns::Set(const FoliageInput& input)
{
  vtkPointData* data = input.Echoes->GetPointData();
  this->Points = GetDoubles(input.Echoes->GetPoints()->GetData());
  this->Classes = data->GetArray(names::ClassificationIds);
  this->Materials = data->GetArray(names::MaterialIds);
  this->Returns = data->GetArray(names::NumberOfReturns);
  this->Amplitudes = data->GetArray(names::Amplitude);
  this->Amplitudes = this->Amplitudes ? this->Amplitudes : data->GetArray(names::Intensity);
  this->Widths = data->GetArray(names::EchoWidth);
  this->CountedClasses = input.Classes;
  this->CountedMaterials = input.Materials;
  const bool hasEnergy = this->Amplitudes && this->Amplitudes->GetRange()[1] > 0.0;
  const bool isEnergy = input.EchoShares == FoliageInput::Shares::Energy;
  this->Shares = isEnergy && !hasEnergy ? FoliageInput::Shares::Equal : input.EchoShares;
  const bool needsEchoes = input.Echoes->GetNumberOfPoints() > 0;
  this->ElementReflectance = input.ElementReflectance;
  this->Reflectances = data->GetArray(names::Reflectance);
  if (needsEchoes && !input.Hits && this->Shares == FoliageInput::Shares::Reflectance &&
    !this->Reflectances)
  {
    return Status::Error(std::string("the echoes have no array ") + names::Reflectance +
      " [dB], which their shares are to be of; choose other EchoShares");
  }
  if (needsEchoes && !input.Classes.empty() && !this->Classes)
  {
    return Status::Error(std::string("the echoes have no array ") + names::ClassificationIds +
      ", by which plants are counted; remove the counted classes");
  }
  if (needsEchoes && !input.Materials.empty() && !this->Materials)
  {
    return Status::Error(std::string("the echoes have no array ") + names::MaterialIds +
      ", by which plants are counted; remove the counted materials");
  }
  this->Incidences = input.UsesIncidence ? data->GetArray(names::IncidenceAngle) : nullptr;
  if (needsEchoes && input.UsesIncidence && !input.Hits && !this->Incidences)
  {
    return Status::Error(std::string("the echoes have no array ") + names::IncidenceAngle +
      ", the angles of leaves; choose a leaf angle distribution");
  }
  return input.Hits ? this->SetHits(input) : Status();
}

//------------------------------------------------------------------------------
Status FoliageColumns::SetHits(const FoliageInput& input)
{
  vtkPointData* data = input.Hits->GetPointData();
  vtkDataArray* energies = data->GetArray(names::Weight);
  this->HitIncidences = input.UsesIncidence ? data->GetArray(names::IncidenceAngle) : nullptr;
  if (!energies || (input.UsesIncidence && !this->HitIncidences))
  {
    return Status::Error(std::string("the hits of sub-rays have no array ") +
      (energies ? names::IncidenceAngle : names::Weight) + "; give those of a run (--hits)");
  }
  this->HitPoints = GetDoubles(input.Hits->GetPoints()->GetData());
  this->HitEnergies = GetDoubles(energies);
  return {};
}

//------------------------------------------------------------------------------
bool FoliageColumns::IsNoise(vtkIdType echo) const
{
  return this->Classes && Has(Noise, this->Classes->GetTuple1(echo));
}

//------------------------------------------------------------------------------
bool FoliageColumns::IsCounted(vtkIdType echo) const
{
  if (!this->CountedMaterials.empty() &&
    !Has(this->CountedMaterials, this->Materials->GetTuple1(echo)))
  {
    return false;
  }
  if (!this->CountedClasses.empty())
  {
    return Has(this->CountedClasses, this->Classes->GetTuple1(echo));
  }
  return !this->CountedMaterials.empty() || !this->Classes ||
    IsPlantClass(static_cast<int>(this->Classes->GetTuple1(echo)));
}

//------------------------------------------------------------------------------
double FoliageColumns::GetIncidenceWeight(vtkDataArray* incidences, vtkIdType row)
{
  if (!incidences)
  {
    return 1.0;
  }
  const double cosine = std::abs(std::cos(vtkMath::RadiansFromDegrees(incidences->GetTuple1(row))));
  return cosine > SmallestCosine ? 1.0 / cosine : 1.0 / SmallestCosine;
}

//------------------------------------------------------------------------------
double FoliageColumns::GetEnergy(vtkIdType echo, double range) const
{
  if (this->Shares == FoliageInput::Shares::Reflectance && this->IsCounted(echo))
  {
    const double apparent = std::pow(10.0, 0.1 * this->Reflectances->GetTuple1(echo));
    return apparent / (MeanHitCosine * this->ElementReflectance);
  }
  if (this->Shares != FoliageInput::Shares::Energy)
  {
    return 1.0;
  }
  const double width = this->Widths ? this->Widths->GetTuple1(echo) : 1.0;
  const double energy = this->Amplitudes->GetTuple1(echo) * (width > 0.0 ? width : 1.0);
  return energy > 0.0 ? energy * range * range : 0.0;
}

//------------------------------------------------------------------------------
double FoliageColumns::GetNumberOfReturns(vtkIdType echo) const
{
  return this->Returns ? this->Returns->GetTuple1(echo) : 0.0;
}

//------------------------------------------------------------------------------
Status BeamOrigins::Set(const FoliageInput& input)
{
  this->Array = input.Echoes->GetPointData()->GetArray(names::Origin);
  this->Place = input.Origin;
  if (this->Array && this->Array->GetNumberOfComponents() == 3)
  {
    return {};
  }
  this->Array = nullptr;
  if (input.Trajectory)
  {
    return this->SetTrajectory(input);
  }
  return this->Place || input.Echoes->GetNumberOfPoints() == 0
    ? Status()
    : Status::Error(
        std::string("where the beams begin is not known: connect pulses (input 1) or a "
                    "trajectory (input 3), set BeamOrigin, or give the echoes an array ") +
        names::Origin);
}

//------------------------------------------------------------------------------
Status BeamOrigins::SetTrajectory(const FoliageInput& input)
{
  this->Trajectory = input.Trajectory;
  this->EchoTimes = input.Echoes->GetPointData()->GetArray(names::GpsTime);
  vtkDataArray* times = input.Trajectory->GetPointData()->GetArray(names::GpsTime);
  if (!this->EchoTimes || !times || input.Trajectory->GetNumberOfPoints() == 0)
  {
    return Status::Error(std::string(this->EchoTimes ? "the trajectory has" : "the echoes have") +
      " no array " + names::GpsTime + ", which places the beams on the trajectory; give times");
  }
  this->Times = GetDoubles(times);
  const double* begin = this->Times->GetPointer(0);
  if (!std::is_sorted(begin, begin + this->Times->GetNumberOfValues()))
  {
    return Status::Error(
      std::string("the trajectory is not sorted by ") + names::GpsTime + "; sort it");
  }
  const double epochs[] = { GetEpoch(input.Echoes), GetEpoch(input.Trajectory) };
  this->Shift = epochs[0] > 0.0 && epochs[1] > 0.0 ? epochs[0] - epochs[1] : 0.0;
  return {};
}

//------------------------------------------------------------------------------
Status BeamOrigins::Get(vtkIdType echo, double origin[3])
{
  if (this->Array)
  {
    this->Array->GetTuple(echo, origin);
    return {};
  }
  if (!this->Trajectory)
  {
    std::copy(this->Place, this->Place + 3, origin);
    return {};
  }
  const double time = this->EchoTimes->GetTuple1(echo) + this->Shift;
  const double* begin = this->Times->GetPointer(0);
  const double* end = begin + this->Times->GetNumberOfValues();
  const bool stands = end - begin == 1;
  if (!stands && !(time >= *begin - EpochTolerance && time <= end[-1] + EpochTolerance))
  {
    return Status::Error(std::string(names::GpsTime) + ' ' + std::to_string(time) + " of echo " +
      std::to_string(echo) + " is not on the trajectory, which is from " + std::to_string(*begin) +
      " to " + std::to_string(end[-1]) + " s; give the trajectory of these echoes");
  }
  const double* next = std::clamp(std::upper_bound(begin, end, time), begin + 1, end - 1);
  const vtkIdType row = stands ? 0 : next - begin - 1;
  this->Trajectory->GetPoint(row, origin);
  if (!stands)
  {
    double other[3];
    this->Trajectory->GetPoint(row + 1, other);
    const double length = next[0] - next[-1];
    const double share = length > 0.0 ? std::clamp((time - next[-1]) / length, 0.0, 1.0) : 0.0;
    std::transform(origin, origin + 3, other, origin,
      [share](double a, double b) { return a + share * (b - a); });
  }
  return {};
}

} // namespace helios
