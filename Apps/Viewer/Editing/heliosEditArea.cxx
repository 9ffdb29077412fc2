// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
#include "heliosEditArea.h"

#include "vtkHeliosFlightLines.h"

#include <vtkBoundingBox.h>
#include <vtkMath.h>
#include <vtkNew.h>
#include <vtkPlaneSource.h>
#include <vtkPolyData.h>

#include <algorithm>
#include <cmath>

namespace helios::viewer
{

namespace
{

constexpr double MaximumLines = 1000.0;
constexpr double ShortestSide = 0.01; // [m]
constexpr double UsualAngle = 20.0;   // [deg]

} // namespace

Status FlyArea(SurveyEdit& edit)
{
  if (!edit.HasArea)
  {
    return {};
  }
  vtkBoundingBox box;
  box.AddPoint(edit.Corners[0].GetData());
  box.AddPoint(edit.Corners[1].GetData());
  const double angle = std::isnan(edit.Settings.ScanAngle) ? UsualAngle : edit.Settings.ScanAngle;
  const double swath =
    2.0 * edit.Height * std::tan(vtkMath::RadiansFromDegrees(std::clamp(angle, 1e-3, 89.0)));
  const double spacing = swath * (1.0 - 0.01 * edit.Overlap);
  double sides[3];
  box.GetLengths(sides);
  const double across = std::min(sides[0], sides[1]);
  if (across < ShortestSide)
  {
    return Status::Error("the corners span no rectangle: click an opposite corner");
  }
  if (across > MaximumLines * spacing)
  {
    return Status::Error("more than 1000 flight lines: raise the height, or lower the overlap");
  }
  double low[3];
  double high[3];
  box.GetMinPoint(low[0], low[1], low[2]);
  box.GetMaxPoint(high[0], high[1], high[2]);
  vtkNew<vtkPlaneSource> rectangle;
  rectangle->SetOutputPointsPrecision(vtkAlgorithm::DOUBLE_PRECISION);
  rectangle->SetOrigin(low[0], low[1], 0.0);
  rectangle->SetPoint1(high[0], low[1], 0.0);
  rectangle->SetPoint2(low[0], high[1], 0.0);
  vtkNew<vtkHeliosFlightLines> flight;
  flight->SetInputConnection(rectangle->GetOutputPort());
  flight->SetSwathWidth(swath);
  flight->SetLineSpacing(spacing);
  flight->OptimizeHeadingOff();
  flight->SetHeading(sides[0] >= sides[1] ? 90.0 : 0.0);
  flight->SetAltitude(high[2] + edit.Height);
  flight->Update();
  std::vector<FlightLine> lines;
  for (vtkIdType i = 0; i + 1 < flight->GetOutput()->GetNumberOfPoints(); i += 2)
  {
    const Vec3 begin(flight->GetOutput()->GetPoint(i));
    lines.emplace_back(begin, Vec3(flight->GetOutput()->GetPoint(i + 1)));
  }
  SetLines(edit, lines);
  return {};
}

} // namespace helios::viewer
