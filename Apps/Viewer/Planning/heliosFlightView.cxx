// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
#include "heliosFlightView.h"

#include "heliosTheme.h"
#include "heliosTicks.h"
#include "vtkHeliosArrayNames.h"
#include "vtkHeliosFlightArrayNames.h"

#include <vtkActor.h>
#include <vtkCellArray.h>
#include <vtkNew.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>
#include <vtkPolyDataMapper.h>
#include <vtkProperty.h>

#include <json/json.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <vector>

namespace helios::viewer
{
namespace names = vtkHeliosArrayNames;
namespace flight = vtkHeliosFlightArrayNames;

namespace
{

constexpr double Lift = 0.3;            // [m], of cells above the ground at their centres
constexpr double Quantile = 0.995;      // quantile of the densities: the highest colour
constexpr vtkIdType MaximumLabels = 60; // more would cover each other
constexpr int MaximumTicks = 6;
constexpr Rgb GapColor = { 235, 60, 55 };
constexpr Rgb LineColor = { 255, 158, 38 };

const Ramp& GetRamp()
{
  static const Ramp ramp = MakeRamp({ 0.15, 1.0 });
  return ramp;
}

/// Returns the densities of all cells, sorted.
std::vector<double> SortDensities(vtkPolyData* cells)
{
  std::vector<double> densities;
  for (vtkIdType i = 0; i < cells->GetNumberOfPoints(); ++i)
  {
    densities.push_back(GetPlanned(cells, flight::PulseDensity, i, 0.0));
  }
  std::sort(densities.begin(), densities.end());
  return densities;
}

} // namespace

//------------------------------------------------------------------------------
FlightView::FlightView(vtkRenderer* renderer, const Plan& plan, const Vec3& origin)
  : PlanLayer(renderer, origin)
{
  if (plan.Cells && plan.Cells->GetNumberOfPoints() > 0)
  {
    this->AddCells(plan.Cells);
  }
  this->AddLines(plan.Lines);
}

//------------------------------------------------------------------------------
Rgb FlightView::GetColor(double density, double highest)
{
  const double share = highest > 0.0 ? std::clamp(density / highest, 0.0, 1.0) : 0.0;
  return density > 0.0 ? GetRamp()[static_cast<std::size_t>(255.0 * share)] : GapColor;
}

//------------------------------------------------------------------------------
void FlightView::AddCells(vtkPolyData* cells)
{
  const std::vector<double> sorted = SortDensities(cells);
  this->HighestDensity =
    sorted[static_cast<std::size_t>(Quantile * static_cast<double>(sorted.size() - 1))];
  this->NumberOfCells = cells->GetNumberOfPoints();
  vtkNew<vtkPoints> places;
  std::vector<Rgb> colors;
  for (vtkIdType i = 0; i < this->NumberOfCells; ++i)
  {
    const double density = GetPlanned(cells, flight::PulseDensity, i, 0.0);
    places->InsertNextPoint(
      (this->ToRenderer(cells->GetPoint(i)) + Vec3(0.0, 0.0, Lift)).GetData());
    colors.push_back(GetColor(density, this->HighestDensity));
    this->NumberOfGaps += density > 0.0 ? 0 : 1;
    this->MeanDensity += density / static_cast<double>(this->NumberOfCells);
  }
  this->AddPoints(places, colors, 5.0F);
}

//------------------------------------------------------------------------------
/// Adds lines: the scanner fires from an active waypoint to the next one; turns are not drawn.
void FlightView::AddLines(vtkPolyData* waypoints)
{
  vtkNew<vtkPoints> places;
  vtkNew<vtkCellArray> segments;
  double last = -1.0; // line
  const vtkIdType count = waypoints->GetNumberOfPoints();
  for (vtkIdType i = 0; i < count; ++i)
  {
    const Vec3 place = this->ToRenderer(waypoints->GetPoint(i));
    places->InsertNextPoint(place.GetData());
    if (i + 1 == count || GetPlanned(waypoints, flight::Active, i, 1.0) == 0.0)
    {
      continue;
    }
    const vtkIdType ends[2] = { i, i + 1 };
    segments->InsertNextCell(2, ends);
    const double line = GetPlanned(waypoints, names::LegIds, i, 0.0);
    if (line != last)
    {
      last = line;
      this->NumberOfLines < MaximumLabels
        ? this->AddLabel(std::to_string(static_cast<int>(line)), place)
        : void();
      ++this->NumberOfLines;
    }
  }
  vtkNew<vtkPolyData> lines;
  lines->SetPoints(places);
  lines->SetLines(segments);
  vtkNew<vtkPolyDataMapper> mapper;
  mapper->SetInputData(lines);
  vtkNew<vtkActor> actor;
  actor->SetMapper(mapper);
  actor->GetProperty()->LightingOff();
  actor->GetProperty()->SetColor(Shade(LineColor).Rgb);
  actor->GetProperty()->SetLineWidth(3.0F);
  this->AddActor(actor);
}

//------------------------------------------------------------------------------
std::string FlightView::Describe() const
{
  if (this->NumberOfCells == 0)
  {
    return std::to_string(this->NumberOfLines) + " flight lines";
  }
  char text[320];
  std::snprintf(text, sizeof(text),
    "%lld flight lines give %.3g pulses/m\xC2\xB2 on average; %.1f %% of the area has none",
    static_cast<long long>(this->NumberOfLines), this->MeanDensity,
    100.0 * static_cast<double>(this->NumberOfGaps) / static_cast<double>(this->NumberOfCells));
  return text;
}

//------------------------------------------------------------------------------
Legend FlightView::MakeLegend() const
{
  Legend legend;
  legend.Title = "Pulses [1/m\xC2\xB2]";
  if (this->NumberOfCells == 0)
  {
    legend.Title = "Plan";
    legend.IsCategory = true;
    legend.Colors.push_back(LineColor);
    legend.Marks.push_back({ 0.0, "flight line" });
    return legend;
  }
  legend.Colors.assign(GetRamp().begin(), GetRamp().end());
  const double high = std::max(this->HighestDensity, 1e-3);
  for (const Tick& tick : MakeTicks(0.0, high, MaximumTicks, "").List)
  {
    legend.Marks.push_back({ tick.Value / high, tick.Text });
  }
  legend.Others.emplace_back(LineColor, "flight line");
  legend.Others.emplace_back(GapColor, "no pulse");
  return legend;
}

//------------------------------------------------------------------------------
void FlightView::Describe(Json::Value& state) const
{
  state["lines"] = Json::Int64(this->NumberOfLines);
  state["cells"] = Json::Int64(this->NumberOfCells);
  state["gaps"] = Json::Int64(this->NumberOfGaps);
  state["meanDensity"] = this->MeanDensity;
}

} // namespace helios::viewer
