// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
// A flight plan: its lines, and the predicted pulse density.

#ifndef heliosFlightView_h
#define heliosFlightView_h

#include "heliosPlanFiles.h"
#include "heliosPlanLayer.h"

#include <vtkType.h>

#include <string>

namespace helios::viewer
{

/// Numbered lines from where they begin, and the cells of the area coloured by their density.
class FlightView : public PlanLayer
{
public:
  FlightView(vtkRenderer* renderer, const Plan& plan, const Vec3& origin);

  /// Returns the colour from no pulse to the highest density; cells without a pulse have a colour
  /// of their own.
  static Rgb GetColor(double density, double highest);

  vtkIdType GetNumberOfLines() const { return this->NumberOfLines; }
  vtkIdType GetNumberOfCells() const { return this->NumberOfCells; }
  vtkIdType GetNumberOfGaps() const { return this->NumberOfGaps; }
  double GetMeanDensity() const { return this->MeanDensity; }

  std::string Describe() const override;
  Legend MakeLegend() const override;
  void Describe(Json::Value& state) const override;

private:
  void AddCells(vtkPolyData* cells);
  void AddLines(vtkPolyData* waypoints);

  vtkIdType NumberOfLines = 0;
  vtkIdType NumberOfCells = 0;
  vtkIdType NumberOfGaps = 0; // cells without a pulse
  double MeanDensity = 0.0;   // [1/m2]
  double HighestDensity = 0.0;
};

} // namespace helios::viewer

#endif
