// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
#include "heliosPlanView.h"

#include "heliosErrorText.h"
#include "heliosPlatformModel.h"
#include "heliosStatus.h"
#include "heliosSurveyData.h"
#include "heliosViewer.h"
#include "vtkHeliosArrayNames.h"
#include "vtkHeliosPointXMLReader.h"

#include <vtkActor.h>
#include <vtkCamera.h>
#include <vtkCellArray.h>
#include <vtkCoordinate.h>
#include <vtkDataArray.h>
#include <vtkPointData.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>
#include <vtkPolyDataMapper.h>
#include <vtkProperty.h>
#include <vtkRenderer.h>
#include <vtkTextActor.h>
#include <vtkTextProperty.h>
#include <vtkUnsignedCharArray.h>

#include <json/json.h>

#include <algorithm>
#include <array>
#include <cstdio>
#include <filesystem>

namespace fs = std::filesystem;

namespace helios::viewer
{
namespace names = vtkHeliosArrayNames;

namespace
{

constexpr double Lift = 0.05;         // [m], of test points above their surface
constexpr double TripodShare = 0.045; // minimum height of a tripod, of the plan's diagonal

fs::path GetFolder(const std::string& path)
{
  std::error_code error;
  return fs::is_directory(path, error) ? fs::path(path) : fs::path(path).parent_path();
}

/// Null and an error if the file is not valid; null alone if it is missing.
vtkSmartPointer<vtkPolyData> Read(const fs::path& path, Status& status)
{
  std::error_code error;
  if (!fs::exists(path, error))
  {
    return nullptr;
  }
  vtkNew<vtkHeliosPointXMLReader> reader;
  const ErrorText errors(reader);
  reader->SetFileName(path.c_str());
  reader->Update();
  if (!errors.IsEmpty() || !reader->GetOutput())
  {
    status = Status::Error(path.string() + ": cannot be read; plan again");
    return nullptr;
  }
  return reader->GetOutput();
}

double Get(vtkPolyData* points, const char* name, vtkIdType row, double missing)
{
  vtkDataArray* array = points->GetPointData()->GetArray(name);
  return array ? array->GetTuple1(row) : missing;
}

void Show(vtkActor* actor, vtkPoints* points, vtkUnsignedCharArray* colors, float size)
{
  vtkNew<vtkPolyData> data;
  vtkNew<vtkCellArray> vertices;
  for (vtkIdType i = 0; i < points->GetNumberOfPoints(); ++i)
  {
    vertices->InsertNextCell(1, &i);
  }
  data->SetPoints(points);
  data->SetVerts(vertices);
  data->GetPointData()->SetScalars(colors);
  vtkNew<vtkPolyDataMapper> mapper;
  mapper->SetInputData(data);
  actor->SetMapper(mapper);
  actor->GetProperty()->LightingOff();
  actor->GetProperty()->SetPointSize(size);
  actor->PickableOff();
}

/// A number over the picture, at a position in renderer coordinates.
vtkSmartPointer<vtkTextActor> MakeLabel(const std::string& text, const Vec3& place)
{
  auto label = vtkSmartPointer<vtkTextActor>::New();
  label->SetInput((" " + text + " ").c_str());
  label->GetPositionCoordinate()->SetCoordinateSystemToWorld();
  label->GetPositionCoordinate()->SetValue(place[0], place[1], place[2]);
  vtkTextProperty* letters = label->GetTextProperty();
  letters->SetFontSize(18);
  letters->SetColor(0.08, 0.08, 0.1);
  letters->SetBackgroundColor(1.0, 0.72, 0.25);
  letters->SetBackgroundOpacity(1.0);
  letters->BoldOn();
  letters->SetJustificationToCentered();
  label->PickableOff();
  return label;
}

double FindDiagonal(const Plan& plan)
{
  vtkPolyData* data = plan.TestPoints ? plan.TestPoints : plan.Positions;
  return data->GetNumberOfPoints() > 0 ? data->GetLength() : 1.0;
}

} // namespace

//------------------------------------------------------------------------------
bool IsPlan(const std::string& path)
{
  std::error_code error;
  return fs::is_directory(path, error) ? fs::exists(fs::path(path) / "positions.vtp", error)
                                       : fs::path(path).filename() == "positions.vtp";
}

//------------------------------------------------------------------------------
Status ReadPlan(const std::string& path, Plan& plan)
{
  const fs::path folder = GetFolder(path);
  Status status;
  plan.Positions = Read(folder / "positions.vtp", status);
  plan.Candidates = Read(folder / "candidates.vtp", status);
  plan.TestPoints = Read(folder / "test_points.vtp", status);
  std::error_code error;
  const fs::path survey = folder / "survey.xml";
  plan.Survey = fs::exists(survey, error) ? survey.string() : "";
  if (status.IsOk() && (!plan.Positions || plan.Positions->GetNumberOfPoints() == 0))
  {
    status = Status::Error(path + ": has no positions; plan again, or give another folder");
  }
  return status;
}

//------------------------------------------------------------------------------
PlanView::PlanView(vtkRenderer* renderer, const Plan& plan, const Vec3& origin)
  : Renderer(renderer)
  , Origin(origin)
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
PlanView::~PlanView()
{
  this->Renderer->RemoveActor(this->TestPoints);
  this->Renderer->RemoveActor(this->Candidates);
  for (const auto& tripod : this->Tripods)
  {
    this->Renderer->RemoveActor(tripod);
  }
  for (const auto& label : this->Labels)
  {
    this->Renderer->RemoveActor2D(label);
  }
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
  vtkNew<vtkUnsignedCharArray> colors;
  colors->SetNumberOfComponents(3);
  vtkDataArray* normals = points->GetPointData()->GetArray(names::Normal);
  for (vtkIdType i = 0; i < points->GetNumberOfPoints(); ++i)
  {
    Vec3 place = Vec3(points->GetPoint(i)) - this->Origin;
    place = normals ? place + Lift * Vec3(normals->GetTuple3(i)) : place;
    places->InsertNextPoint(place.GetData());
    const int scans = static_cast<int>(Get(points, names::NumberOfScans, i, 0.0));
    const bool isCoverable = scans > 0 || Get(points, names::Coverable, i, 1.0) != 0.0;
    colors->InsertNextTypedTuple(GetColor(isCoverable, scans).data());
    this->NumberCoverable += isCoverable;
    this->NumberCovered += scans > 0;
  }
  this->NumberOfTestPoints = points->GetNumberOfPoints();
  Show(this->TestPoints, places, colors, 5.0F);
  this->Renderer->AddActor(this->TestPoints);
}

//------------------------------------------------------------------------------
void PlanView::AddCandidates(vtkPolyData* candidates)
{
  vtkNew<vtkPoints> places;
  for (vtkIdType i = 0; i < candidates->GetNumberOfPoints(); ++i)
  {
    places->InsertNextPoint((Vec3(candidates->GetPoint(i)) - this->Origin).GetData());
  }
  Show(this->Candidates, places, nullptr, 2.0F);
  this->Candidates->GetProperty()->SetColor(0.85, 0.87, 0.9);
  this->Renderer->AddActor(this->Candidates);
}

//------------------------------------------------------------------------------
/// The instrument is at its planned position; small tripods are enlarged downwards.
void PlanView::AddPositions(vtkPolyData* positions, double size)
{
  const auto model = MakePlatformModel(PlatformType::Static);
  double bounds[6];
  model->GetBounds(bounds);
  const double scale = std::max(1.0, TripodShare * size / bounds[5]);
  for (vtkIdType i = 0; i < positions->GetNumberOfPoints(); ++i)
  {
    const Vec3 place = Vec3(positions->GetPoint(i)) - this->Origin;
    auto tripod = vtkSmartPointer<vtkActor>::New();
    vtkNew<vtkPolyDataMapper> mapper;
    mapper->SetInputData(model);
    mapper->ScalarVisibilityOff();
    tripod->SetMapper(mapper);
    tripod->SetScale(scale);
    tripod->SetPosition(place[0], place[1], place[2] - bounds[5]);
    tripod->GetProperty()->SetColor(1.0, 0.62, 0.15);
    tripod->PickableOff();
    this->Renderer->AddActor(tripod);
    this->Tripods.push_back(tripod);
    const Vec3 head = place + Vec3(0.0, 0.0, (1.1 * scale - 1.0) * bounds[5]);
    auto label = MakeLabel(std::to_string(i + 1), head);
    this->Renderer->AddActor2D(label);
    this->Labels.push_back(label);
  }
}

//------------------------------------------------------------------------------
void PlanView::SetVisible(bool visible)
{
  this->Visible = visible;
  this->TestPoints->SetVisibility(visible);
  this->Candidates->SetVisibility(visible);
  for (const auto& tripod : this->Tripods)
  {
    tripod->SetVisibility(visible);
  }
  for (const auto& label : this->Labels)
  {
    label->SetVisibility(visible);
  }
}

//------------------------------------------------------------------------------
void PlanView::Update()
{
  vtkCamera* camera = this->Renderer->GetActiveCamera();
  const Vec3 ahead(camera->GetDirectionOfProjection());
  for (const auto& label : this->Labels)
  {
    const Vec3 place(label->GetPositionCoordinate()->GetValue());
    const bool isAhead = (place - Vec3(camera->GetPosition())).Dot(ahead) > 0.0;
    label->SetVisibility(this->Visible && isAhead);
  }
}

//------------------------------------------------------------------------------
vtkIdType PlanView::GetNumberOfPositions() const
{
  return static_cast<vtkIdType>(this->Tripods.size());
}

//------------------------------------------------------------------------------
std::string PlanView::Describe() const
{
  if (this->NumberOfTestPoints == 0)
  {
    return std::to_string(this->Tripods.size()) + " scan positions";
  }
  const auto percent = [this](vtkIdType of)
  { return of > 0 ? 100.0 * static_cast<double>(this->NumberCovered) / double(of) : 0.0; };
  char text[320];
  std::snprintf(text, sizeof(text),
    "%zu scan positions see %lld of %lld test points: %.1f %%, or %.1f %% of the visible ones\n"
    "yellow: 1 scan, green: 2, blue: 3 or more, red: not covered, grey: not visible",
    this->Tripods.size(), static_cast<long long>(this->NumberCovered),
    static_cast<long long>(this->NumberOfTestPoints), percent(this->NumberOfTestPoints),
    percent(this->NumberCoverable));
  return text;
}

//------------------------------------------------------------------------------
PlanTool::PlanTool(Viewer& viewer)
  : Owner(viewer)
{
  const auto& inputs = viewer.GetOptions().Inputs;
  this->IsWanted =
    inputs.size() == 1 && IsPlan(inputs.front()) && ReadPlan(inputs.front(), this->Files).IsOk();
}

//------------------------------------------------------------------------------
PlanTool::~PlanTool() = default;

//------------------------------------------------------------------------------
std::vector<KeyHelp> PlanTool::GetKeys() const
{
  return { { "j", "scan positions and their coverage", "j" } };
}

//------------------------------------------------------------------------------
bool PlanTool::OnKey(const std::string& key, bool control)
{
  if (key != "j" || control || !this->View)
  {
    return false;
  }
  this->View->SetVisible(!this->View->IsVisible());
  this->Owner.Redraw();
  return true;
}

//------------------------------------------------------------------------------
bool PlanTool::OnFrame()
{
  const Vec3 origin = this->Owner.GetOrigin();
  if (!this->IsWanted || (this->View && origin == this->Origin))
  {
    this->View ? this->View->Update() : void();
    return false;
  }
  this->Origin = origin;
  this->View.reset();
  this->View = std::make_unique<PlanView>(this->Owner.GetRenderer(), this->Files, origin);
  return true;
}

//------------------------------------------------------------------------------
void PlanTool::OnNewSurvey()
{
  this->View.reset();
  this->IsWanted = false;
}

//------------------------------------------------------------------------------
std::string PlanTool::GetStatus() const
{
  return this->View && this->View->IsVisible() ? this->View->Describe() : "";
}

//------------------------------------------------------------------------------
void PlanTool::Describe(Json::Value& state) const
{
  if (this->View)
  {
    Json::Value& value = state["plan"];
    value["positions"] = Json::Int64(this->View->GetNumberOfPositions());
    value["testPoints"] = Json::Int64(this->View->GetNumberOfTestPoints());
    value["coverable"] = Json::Int64(this->View->GetNumberCoverable());
    value["covered"] = Json::Int64(this->View->GetNumberCovered());
    value["visible"] = this->View->IsVisible();
  }
}

} // namespace helios::viewer
