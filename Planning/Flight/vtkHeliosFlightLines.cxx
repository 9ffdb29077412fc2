// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkHeliosFlightLines.h"

#include "heliosConstants.h"
#include "heliosFlightPattern.h"
#include "vtkHeliosArrayNames.h"
#include "vtkHeliosFlightArrayNames.h"

#include <vtkCellArray.h>
#include <vtkDoubleArray.h>
#include <vtkInformation.h>
#include <vtkInformationVector.h>
#include <vtkIntArray.h>
#include <vtkMath.h>
#include <vtkNew.h>
#include <vtkObjectFactory.h>
#include <vtkPointData.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>
#include <vtkUnsignedCharArray.h>

#include <cmath>

vtkStandardNewMacro(vtkHeliosFlightLines);

namespace
{

constexpr double MaximumLines = 1e5;

/// Stores the lines of a pattern, with the arrays of waypoints.
void Store(const helios::FlightPattern& pattern, double altitude, double speed, vtkPolyData* output)
{
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  vtkNew<vtkCellArray> lines;
  vtkNew<vtkDoubleArray> speeds;
  speeds->SetName(vtkHeliosArrayNames::Speed);
  vtkNew<vtkUnsignedCharArray> active;
  active->SetName(vtkHeliosFlightArrayNames::Active);
  vtkNew<vtkIntArray> numbers;
  numbers->SetName(vtkHeliosArrayNames::LegIds);
  for (const helios::PatternLine& line : pattern.Lines)
  {
    vtkIdType ids[2];
    for (int end = 0; end < 2; ++end)
    {
      const vtkVector2d place = helios::FlightArea::TurnBack(
        { end == 0 ? line.First : line.Last, line.Across }, pattern.Heading);
      ids[end] = points->InsertNextPoint(place[0], place[1], altitude);
      speeds->InsertNextValue(speed);
      active->InsertNextValue(end == 0);
      numbers->InsertNextValue(static_cast<int>(lines->GetNumberOfCells()));
    }
    lines->InsertNextCell(2, ids);
  }
  output->SetPoints(points);
  output->SetLines(lines);
  output->GetPointData()->AddArray(speeds);
  output->GetPointData()->AddArray(active);
  output->GetPointData()->AddArray(numbers);
}

} // namespace

//------------------------------------------------------------------------------
double vtkHeliosFlightLines::ComputeTurnRadius(double speed, double bank)
{
  return speed * speed / (helios::StandardGravity * std::tan(vtkMath::RadiansFromDegrees(bank)));
}

//------------------------------------------------------------------------------
int vtkHeliosFlightLines::RequestData(
  vtkInformation*, vtkInformationVector** inputs, vtkInformationVector* outputs)
{
  if (this->LineSpacing > this->SwathWidth)
  {
    vtkErrorMacro(<< "the line spacing is " << this->LineSpacing << " m, above the swath width "
                  << this->SwathWidth << " m: strips would have gaps; give a smaller one");
    return 0;
  }
  helios::FlightArea area;
  if (const helios::Status status = area.Read(vtkPolyData::GetData(inputs[0])); !status.IsOk())
  {
    vtkErrorMacro(<< status.Message());
    return 0;
  }
  const helios::Interval west = area.Turn(0.0).GetWidth();
  const helios::Interval north = area.Turn(90.0).GetWidth();
  const double maximum = std::hypot(west.GetLength(), north.GetLength()) / this->LineSpacing;
  if (maximum > MaximumLines)
  {
    vtkErrorMacro(<< "the line spacing " << this->LineSpacing << " m results in up to " << maximum
                  << " lines; give one that results in fewer than " << MaximumLines);
    return 0;
  }
  const helios::PatternSettings settings = { this->SwathWidth, this->LineSpacing, this->RunIn,
    this->Speed, this->TurnRadius, this->TurnTime };
  const helios::FlightPattern pattern = this->OptimizeHeading
    ? helios::FindPattern(area, settings)
    : helios::MakePattern(area, this->Heading, settings);
  Store(pattern, this->Altitude, this->Speed, vtkPolyData::GetData(outputs));
  this->FirstHeading = std::fmod(pattern.Heading + 360.0, 360.0);
  this->NumberOfLines = static_cast<int>(pattern.Lines.size());
  this->LineLength = pattern.LineLength;
  this->TurnLength = pattern.TurnLength;
  this->FlightTime = pattern.Time;
  return 1;
}

//------------------------------------------------------------------------------
void vtkHeliosFlightLines::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "SwathWidth: " << this->SwathWidth << " m\n"
     << indent << "LineSpacing: " << this->LineSpacing << " m\n"
     << indent << "OptimizeHeading: " << this->OptimizeHeading << "\n"
     << indent << "Heading: " << this->Heading << " deg\n"
     << indent << "Altitude: " << this->Altitude << " m\n"
     << indent << "RunIn: " << this->RunIn << " m\n"
     << indent << "Speed: " << this->Speed << " m/s\n"
     << indent << "TurnRadius: " << this->TurnRadius << " m\n"
     << indent << "TurnTime: " << this->TurnTime << " s\n"
     << indent << "NumberOfLines: " << this->NumberOfLines << "\n"
     << indent << "FlightTime: " << this->FlightTime << " s\n";
}
