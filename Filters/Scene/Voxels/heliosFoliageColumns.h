// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
// The columns of echoes and hits that say what a beam met, and where beams begin.

#ifndef heliosFoliageColumns_h
#define heliosFoliageColumns_h

#include "heliosFoliageInput.h"
#include "heliosPose.h"
#include "heliosStatus.h"

#include <vtkDoubleArray.h>
#include <vtkSmartPointer.h>
#include <vtkType.h>

#include <vector>

class vtkDataArray;
class vtkPolyData;

namespace helios
{

/// Returns an array as doubles, a copy if it has another type.
vtkSmartPointer<vtkDoubleArray> GetDoubles(vtkDataArray* array);

/// Returns whether a class of LAS is counted if none are given: all but ground, water and noise.
bool IsPlantClass(int id);

/// Columns of echoes and of hits of sub-rays, by row.
class FoliageColumns
{
public:
  Status Set(const FoliageInput& input);

  Vec3 GetPoint(vtkIdType echo) const { return Vec3(this->Points->GetPointer(3 * echo)); }
  Vec3 GetHitPoint(vtkIdType hit) const { return Vec3(this->HitPoints->GetPointer(3 * hit)); }

  /// Returns whether the class of an echo is noise: no surface, so that it ends no beam.
  bool IsNoise(vtkIdType echo) const;

  /// Returns whether an echo is of the plants to measure.
  bool IsCounted(vtkIdType echo) const;

  /// Returns the weight of an echo, or of the hit of a sub-ray: FoliageHit.
  double GetWeight(vtkIdType echo) const
  {
    return this->IsCounted(echo) ? GetIncidenceWeight(this->Incidences, echo) : 0.0;
  }
  double GetHitWeight(vtkIdType hit) const { return GetIncidenceWeight(this->HitIncidences, hit); }

  double GetHitEnergy(vtkIdType hit) const { return this->HitEnergies->GetValue(hit); }

  /// Returns the energy of an echo, in any unit; by reflectance in pulses.
  double GetEnergy(vtkIdType echo, double range) const;

  /// Returns the number of returns of the pulse of an echo; 0: unknown.
  double GetNumberOfReturns(vtkIdType echo) const;

  FoliageInput::Shares GetShares() const { return this->Shares; }

private:
  static double GetIncidenceWeight(vtkDataArray* incidences, vtkIdType row);
  Status SetHits(const FoliageInput& input);

  FoliageInput::Shares Shares = FoliageInput::Shares::Equal;
  double ElementReflectance = 0.5;
  std::vector<int> CountedClasses;
  std::vector<int> CountedMaterials;
  vtkSmartPointer<vtkDoubleArray> Points;
  vtkSmartPointer<vtkDoubleArray> HitPoints;
  vtkSmartPointer<vtkDoubleArray> HitEnergies;
  vtkDataArray* Classes = nullptr;
  vtkDataArray* Materials = nullptr;
  vtkDataArray* Amplitudes = nullptr;
  vtkDataArray* Widths = nullptr;
  vtkDataArray* Reflectances = nullptr;
  vtkDataArray* Returns = nullptr;
  vtkDataArray* Incidences = nullptr;
  vtkDataArray* HitIncidences = nullptr;
};

/// Where the beams of echoes without pulses begin: at an array, a trajectory, or one place.
class BeamOrigins
{
public:
  Status Set(const FoliageInput& input);

  /// Computes the origin of the beam of an echo.
  Status Get(vtkIdType echo, double origin[3]);

private:
  Status SetTrajectory(const FoliageInput& input);

  const double* Place = nullptr;
  vtkDataArray* Array = nullptr;
  vtkPolyData* Trajectory = nullptr;
  vtkDataArray* EchoTimes = nullptr;
  vtkSmartPointer<vtkDoubleArray> Times; // along the trajectory
  double Shift = 0.0;                    // from the times of echoes to those of the trajectory [s]
};

} // namespace helios

#endif
