// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
// Echoes of a survey with their velocities, to compare with closed forms.

#ifndef heliosVelocityEchoes_h
#define heliosVelocityEchoes_h

#include "vtkHeliosRunOptions.h"
#include "vtkHeliosSurveySource.h"

#include "heliosPose.h"
#include "heliosSurveyFiles.h"
#include "vtkHeliosArrayNames.h"

#include <vtkDataArray.h>
#include <vtkPointData.h>
#include <vtkPolyData.h>

#include <catch2/catch.hpp>

#include <algorithm>
#include <cmath>
#include <functional>
#include <map>

namespace helios
{
namespace test
{
namespace names = vtkHeliosArrayNames;

struct Echoes
{
  Files& Folder;
  Reading Survey;
  vtkNew<vtkHeliosSurveySource> Source;
  std::map<vtkIdType, vtkIdType> Rows; ///< rows of pulses, by id

  Echoes(Files& files, const char* attributes, const char* legs, int subRays)
    : Folder(files)
    , Survey(files, attributes, legs)
  {
    INFO(this->Survey.Log->Errors);
    REQUIRE(this->Survey.Good);
    this->Source->SetSurvey(this->Survey.Reader->GetSurvey());
    this->Source->SetGenerateVelocities(true);
    this->Source->SetGenerateMotion(true);
    this->Source->SetGenerateTruth(true);
    this->Source->SetGeneratePulses(true);
    this->Source->GetOptions()->SetNumberOfSubRays(subRays);
    this->Source->Update();
    vtkDataArray* ids = this->GetPulses()->GetPointData()->GetArray(names::PulseIds);
    for (vtkIdType i = 0; i < ids->GetNumberOfTuples(); ++i)
    {
      this->Rows[static_cast<vtkIdType>(ids->GetComponent(i, 0))] = i;
    }
  }

  vtkIdType Count() { return this->Source->GetOutput()->GetNumberOfPoints(); }
  double Get(const char* name, vtkIdType i, int component = 0)
  {
    return this->Source->GetOutput()->GetPointData()->GetArray(name)->GetComponent(i, component);
  }
  Vec3 GetPoint(vtkIdType i)
  {
    return { this->Get(names::TruePoint, i, 0), this->Get(names::TruePoint, i, 1),
      this->Get(names::TruePoint, i, 2) };
  }
  Vec3 GetOrigin(vtkIdType i)
  {
    Vec3 origin;
    this->GetPulses()->GetPoint(
      this->Rows.at(static_cast<vtkIdType>(this->Get(names::PulseIds, i))), origin.GetData());
    return origin;
  }
  vtkPolyData* GetPulses()
  {
    return vtkPolyData::SafeDownCast(this->Source->GetOutputDataObject(2));
  }

  /// Checks the velocity of the points hit, and the radial one, with that of the origins.
  void CheckVelocities(const std::function<Vec3(const Vec3&, double)>& ofPoint,
    const std::function<Vec3(const Vec3&, double)>& ofOrigin, double tolerance,
    double ofPointTolerance = 1e-9)
  {
    REQUIRE(this->Count() > 10000);
    double largest = 0.0;
    for (vtkIdType i = 0; i < this->Count(); ++i)
    {
      const Vec3 point = this->GetPoint(i);
      const Vec3 origin = this->GetOrigin(i);
      const double time = this->Get(names::GpsTime, i);
      const Vec3 velocity = ofPoint(point, time);
      for (int axis = 0; axis < 3; ++axis)
      {
        REQUIRE(
          std::abs(this->Get(names::PartVelocity, i, axis) - velocity[axis]) < ofPointTolerance);
      }
      Vec3 direction = point - origin;
      direction.Normalize();
      const double radial = direction.Dot(velocity - ofOrigin(origin, time));
      REQUIRE(std::abs(this->Get(names::RadialVelocity, i) - radial) < tolerance);
      largest = std::max(largest, std::abs(radial));
    }
    CHECK(largest > 1.0);
  }
};

inline Vec3 AtRest(const Vec3&, double)
{
  return { 0.0, 0.0, 0.0 };
}

} // namespace test
} // namespace helios

#endif
