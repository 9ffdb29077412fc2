// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
// A plan of scan positions, and their coverage.

#ifndef heliosPlanView_h
#define heliosPlanView_h

#include "heliosPlanFiles.h"
#include "heliosPlanLayer.h"

#include <vtkType.h>

#include <string>

namespace helios::viewer
{

/// Test points in five colours by number of scans, numbered tripods, small candidates.
class PlanView : public PlanLayer
{
public:
  PlanView(vtkRenderer* renderer, const Plan& plan, const Vec3& origin);

  /// Returns the colour of test points: not coverable, seen by no selected position, by 1, 2, and 3
  /// or more.
  static const Rgb& GetColor(bool isCoverable, int scans);

  vtkIdType GetNumberOfPositions() const { return this->NumberOfPositions; }
  vtkIdType GetNumberOfTestPoints() const { return this->NumberOfTestPoints; }
  vtkIdType GetNumberCoverable() const { return this->NumberCoverable; }
  vtkIdType GetNumberCovered() const { return this->NumberCovered; }

  std::string Describe() const override;
  Legend MakeLegend() const override;
  void Describe(Json::Value& state) const override;

private:
  void AddTestPoints(vtkPolyData* points);
  void AddCandidates(vtkPolyData* candidates);
  void AddPositions(vtkPolyData* positions, double size);

  vtkIdType NumberOfPositions = 0;
  vtkIdType NumberOfTestPoints = 0;
  vtkIdType NumberCoverable = 0;
  vtkIdType NumberCovered = 0;
  bool HasCandidates = false;
};

} // namespace helios::viewer

#endif
