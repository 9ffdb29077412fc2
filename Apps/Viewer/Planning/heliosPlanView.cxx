// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
#include "heliosPlanView.h"

#include "heliosPlatformKind.h"
#include "heliosPlatformModel.h"
#include "heliosTheme.h"
#include "vtkHeliosArrayNames.h"

#include <vtkActor.h>
#include <vtkDataArray.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>
#include <vtkPolyDataMapper.h>
#include <vtkProperty.h>

#include <json/json.h>

#include <algorithm>
#include <array>
#include <cstdio>
#include <vector>

namespace helios::viewer
{
namespace names = vtkHeliosArrayNames;

namespace
{

constexpr double Lift = 0.05;         // [m], of test points above their surface
constexpr double TripodShare = 0.045; // minimum height of a tripod, of the plan's diagonal

constexpr Rgb PositionColor = { 255, 158, 38 };
constexpr Rgb CandidateColor = { 217, 222, 230 };

double FindDiagonal(const Plan& plan)
{
  vtkPolyData* data = plan.TestPoints ? plan.TestPoints : plan.Positions;
  return data->GetNumberOfPoints() > 0 ? data->GetLength() : 1.0;
}

} // namespace

//------------------------------------------------------------------------------
PlanView::PlanView(vtkRenderer* renderer, const Plan& plan, const Vec3& origin)
  : PlanLayer(renderer, origin)
{
  if (plan.TestPoints)
  {
    this->AddTestPoints(plan.TestPoints);
  }
  if (plan.Candidates)
  {
    this->AddCandidates(plan.Candidates);
  }
  this->AddPositions(plan.Positions, FindDiagonal(plan));
}

//------------------------------------------------------------------------------
const Rgb& PlanView::GetColor(bool isCoverable, int scans)
{
  static const std::array<Rgb, 5> colors = { Rgb{ 110, 112, 118 }, Rgb{ 235, 60, 55 },
    Rgb{ 250, 205, 70 }, Rgb{ 110, 205, 90 }, Rgb{ 70, 150, 245 } };
  return isCoverable ? colors[static_cast<std::size_t>(std::clamp(scans, 0, 3)) + 1] : colors[0];
}

//------------------------------------------------------------------------------
void PlanView::AddTestPoints(vtkPolyData* points)
{
  vtkNew<vtkPoints> places;
  std::vector<Rgb> colors;
  vtkDataArray* normals = points->GetPointData()->GetArray(names::Normal);
  for (vtkIdType i = 0; i < points->GetNumberOfPoints(); ++i)
  {
    Vec3 place = this->ToRenderer(points->GetPoint(i));
    place = normals ? place + Lift * Vec3(normals->GetTuple3(i)) : place;
    places->InsertNextPoint(place.GetData());
    const int scans = static_cast<int>(GetPlanned(points, names::NumberOfScans, i, 0.0));
    const bool isCoverable = scans > 0 || GetPlanned(points, names::Coverable, i, 1.0) != 0.0;
    colors.push_back(GetColor(isCoverable, scans));
    this->NumberCoverable += isCoverable;
    this->NumberCovered += scans > 0;
  }
  this->NumberOfTestPoints = points->GetNumberOfPoints();
  this->AddPoints(places, colors, 5.0F);
}

//------------------------------------------------------------------------------
void PlanView::AddCandidates(vtkPolyData* candidates)
{
  vtkNew<vtkPoints> places;
  for (vtkIdType i = 0; i < candidates->GetNumberOfPoints(); ++i)
  {
    places->InsertNextPoint(this->ToRenderer(candidates->GetPoint(i)).GetData());
  }
  this->HasCandidates = candidates->GetNumberOfPoints() > 0;
  this->AddPoints(places, { CandidateColor }, 2.0F);
}

//------------------------------------------------------------------------------
/// Adds the instruments at their planned positions; small tripods are enlarged downwards.
void PlanView::AddPositions(vtkPolyData* positions, double size)
{
  const auto model = MakePlatformModel(PlatformKind::Tripod);
  double bounds[6];
  model->GetBounds(bounds);
  const double scale = std::max(1.0, TripodShare * size / bounds[5]);
  this->NumberOfPositions = positions->GetNumberOfPoints();
  for (vtkIdType i = 0; i < positions->GetNumberOfPoints(); ++i)
  {
    const Vec3 place = this->ToRenderer(positions->GetPoint(i));
    vtkNew<vtkActor> tripod;
    vtkNew<vtkPolyDataMapper> mapper;
    mapper->SetInputData(model);
    mapper->ScalarVisibilityOff();
    tripod->SetMapper(mapper);
    tripod->SetScale(scale);
    tripod->SetPosition(place[0], place[1], place[2] - bounds[5]);
    tripod->GetProperty()->SetColor(Shade(PositionColor).Rgb);
    this->AddActor(tripod);
    const Vec3 head = place + Vec3(0.0, 0.0, (1.1 * scale - 1.0) * bounds[5]);
    this->AddLabel(std::to_string(i), head);
  }
}

//------------------------------------------------------------------------------
std::string PlanView::Describe() const
{
  if (this->NumberOfTestPoints == 0)
  {
    return std::to_string(this->NumberOfPositions) + " scan positions";
  }
  const auto percent = [this](vtkIdType of)
  { return of > 0 ? 100.0 * static_cast<double>(this->NumberCovered) / double(of) : 0.0; };
  char text[320];
  std::snprintf(text, sizeof(text),
    "%lld scan positions see %lld of %lld test points: %.1f %%, or %.1f %% of the visible ones",
    static_cast<long long>(this->NumberOfPositions), static_cast<long long>(this->NumberCovered),
    static_cast<long long>(this->NumberOfTestPoints), percent(this->NumberOfTestPoints),
    percent(this->NumberCoverable));
  return text;
}

//------------------------------------------------------------------------------
Legend PlanView::MakeLegend() const
{
  Legend legend;
  legend.Title = "Scans of a test point";
  legend.IsCategory = true;
  const auto add = [&legend](const Rgb& color, const char* text)
  {
    legend.Marks.push_back({ static_cast<double>(legend.Colors.size()), text });
    legend.Colors.push_back(color);
  };
  if (this->NumberOfTestPoints > 0)
  {
    add(GetColor(true, 3), "3 and more");
    add(GetColor(true, 2), "2");
    add(GetColor(true, 1), "1");
    add(GetColor(true, 0), "0: not covered");
    add(GetColor(false, 0), "not visible from anywhere");
  }
  else
  {
    legend.Title = "Plan";
  }
  add(PositionColor, "scan position");
  this->HasCandidates ? add(CandidateColor, "candidate") : void();
  return legend;
}

//------------------------------------------------------------------------------
void PlanView::Describe(Json::Value& state) const
{
  state["positions"] = Json::Int64(this->NumberOfPositions);
  state["testPoints"] = Json::Int64(this->NumberOfTestPoints);
  state["coverable"] = Json::Int64(this->NumberCoverable);
  state["covered"] = Json::Int64(this->NumberCovered);
}

} // namespace helios::viewer
