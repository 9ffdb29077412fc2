// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
#include "heliosPlatformView.h"

#include "heliosLights.h"
#include "heliosPlatformModel.h"

#include <vtkActor.h>
#include <vtkCamera.h>
#include <vtkCellArray.h>
#include <vtkCellData.h>
#include <vtkMatrix4x4.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>
#include <vtkPolyDataMapper.h>
#include <vtkProperty.h>
#include <vtkRenderer.h>

#include <algorithm>
#include <utility>

namespace helios::viewer
{

namespace
{

constexpr double SmallestShare = 0.04; // share of the view's height

void Show(vtkActor* actor, vtkPolyData* data)
{
  vtkNew<vtkPolyDataMapper> mapper;
  mapper->SetInputData(data);
  mapper->SetScalarVisibility(data->GetCellData()->GetScalars() != nullptr);
  actor->SetMapper(mapper);
}

/// Returns a pose, scaled by s, as a matrix.
vtkSmartPointer<vtkMatrix4x4> MakeMatrix(const Pose& pose, double s)
{
  auto matrix = vtkSmartPointer<vtkMatrix4x4>::New();
  const Rotation rotation(pose.Orientation);
  for (int row = 0; row < 3; ++row)
  {
    for (int column = 0; column < 3; ++column)
    {
      matrix->SetElement(row, column, s * rotation.M[row][column]);
    }
    matrix->SetElement(row, 3, pose.Position[row]);
  }
  return matrix;
}

/// Returns the longest side [m], not 0.
double GetLongestSide(vtkPolyData* model)
{
  double bounds[6];
  model->GetBounds(bounds);
  return std::max({ 1e-3, bounds[1] - bounds[0], bounds[3] - bounds[2], bounds[5] - bounds[4] });
}

void SetFlat(vtkActor* actor, double r, double g, double b)
{
  actor->GetProperty()->SetColor(r, g, b);
  actor->GetProperty()->LightingOff();
  actor->PickableOff();
}

} // namespace

//------------------------------------------------------------------------------
PlatformView::PlatformView(
  vtkRenderer* renderer, const Vec3& origin, std::shared_ptr<ModelFiles> models)
  : Renderer(renderer)
  , Origin(origin)
  , Models(std::move(models))
{
  SetUpSurface(this->Body->GetProperty());
  SetUpSurface(this->Scanner->GetProperty());
  this->Body->GetProperty()->SetColor(0.36, 0.55, 0.78);
  this->Scanner->GetProperty()->SetColor(0.95, 0.55, 0.1);
  this->Body->PickableOff();
  this->Scanner->PickableOff();
  SetFlat(this->Trajectories, 0.95, 0.75, 0.2);
  SetFlat(this->Stands, 0.95, 0.75, 0.2);
  SetFlat(this->Fan, 0.2, 1.0, 0.35);
  this->Trajectories->GetProperty()->SetLineWidth(1.5F);
  this->Stands->GetProperty()->SetPointSize(7.0F);
  this->Fan->GetProperty()->SetOpacity(0.35);
  Show(this->Fan, this->Beams);
  for (vtkActor* actor : { this->Body.Get(), this->Scanner.Get() })
  {
    actor->VisibilityOff(); // until placed
  }
  for (vtkActor* actor : { this->Body.Get(), this->Scanner.Get(), this->Trajectories.Get(),
         this->Stands.Get(), this->Fan.Get() })
  {
    renderer->AddActor(actor);
  }
}

//------------------------------------------------------------------------------
PlatformView::~PlatformView()
{
  for (vtkActor* actor : { this->Body.Get(), this->Scanner.Get(), this->Trajectories.Get(),
         this->Stands.Get(), this->Fan.Get() })
  {
    this->Renderer->RemoveActor(actor);
  }
}

//------------------------------------------------------------------------------
void PlatformView::SetTrajectories(const std::vector<SimulatedLeg>& legs)
{
  vtkNew<vtkPolyData> trajectories;
  vtkNew<vtkPolyData> stands;
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  vtkNew<vtkCellArray> lines;
  vtkNew<vtkCellArray> vertices;
  for (const SimulatedLeg& leg : legs)
  {
    std::vector<vtkIdType> ids;
    for (const Vec3& position : leg.Positions)
    {
      ids.push_back(points->InsertNextPoint((position - this->Origin).GetData()));
    }
    vtkCellArray* cells = leg.IsMoving ? lines : vertices;
    cells->InsertNextCell(static_cast<vtkIdType>(ids.size()), ids.data());
  }
  trajectories->SetPoints(points);
  trajectories->SetLines(lines);
  stands->SetPoints(points);
  stands->SetVerts(vertices);
  Show(this->Trajectories, trajectories);
  Show(this->Stands, stands);
}

//------------------------------------------------------------------------------
void PlatformView::SetVisible(bool visible)
{
  this->IsVisible = visible;
  this->Trajectories->SetVisibility(visible);
  this->Stands->SetVisibility(visible);
  this->SetModelVisible(visible);
}

//------------------------------------------------------------------------------
void PlatformView::SetModelVisible(bool visible)
{
  const bool isShown = visible && this->IsVisible && this->HasModel;
  this->Body->SetVisibility(isShown);
  this->Scanner->SetVisibility(isShown);
}

//------------------------------------------------------------------------------
void PlatformView::SetFanVisible(bool visible)
{
  this->Fan->SetVisibility(visible);
}

//------------------------------------------------------------------------------
bool PlatformView::IsFanVisible() const
{
  return this->Fan->GetVisibility() != 0;
}

//------------------------------------------------------------------------------
/// Returns the scale factor that keeps an object of a size visible.
double PlatformView::FindScale(const Vec3& position, double size) const
{
  vtkCamera* camera = this->Renderer->GetActiveCamera();
  const double height = camera->GetParallelProjection()
    ? 2.0 * camera->GetParallelScale()
    : 2.0 * (position - Vec3(camera->GetPosition())).Norm() *
      std::tan(0.5 * vtkMath::RadiansFromDegrees(camera->GetViewAngle()));
  return std::max(1.0, SmallestShare * height / size);
}

//------------------------------------------------------------------------------
Status PlatformView::ReadModels(const std::vector<SimulatedLeg>& legs)
{
  std::string problems;
  for (const SimulatedLeg& leg : legs)
  {
    for (const ModelData* model : { &leg.Model, &leg.ScannerModel })
    {
      const std::string problem = this->Models->GetProblem(*model);
      const bool isNew = !problem.empty() && problems.find(problem) == std::string::npos;
      problems += isNew ? (problems.empty() ? "" : "\n") + problem : "";
    }
  }
  return problems.empty() ? Status() : Status::Error(problems);
}

//------------------------------------------------------------------------------
void PlatformView::ShowModels(const SimulatedLeg& leg)
{
  const std::string wanted = std::to_string(static_cast<int>(leg.Kind)) + leg.Model.Where +
    leg.Model.File + " " + leg.ScannerModel.Where + leg.ScannerModel.File;
  if (this->HasModel && wanted == this->Shown)
  {
    return;
  }
  vtkPolyData* body = this->Models->Find(leg.Model);
  vtkPolyData* scanner = this->Models->Find(leg.ScannerModel);
  body ? Show(this->Body, body) : Show(this->Body, MakePlatformModel(leg.Kind));
  scanner ? Show(this->Scanner, scanner) : Show(this->Scanner, MakeScannerModel());
  this->Size = body ? GetLongestSide(body) : leg.Kind == PlatformKind::Aircraft ? 7.0 : 1.5;
  this->Shown = wanted;
  this->HasModel = true;
  this->SetModelVisible(true);
}

//------------------------------------------------------------------------------
void PlatformView::Place(const SimulatedLeg& leg, const Pose& platform, double time)
{
  this->ShowModels(leg);
  const Pose local{ platform.Position - this->Origin, platform.Orientation };
  const double scale = this->FindScale(local.Position, this->Size);
  const Vec3 wheels = local.Position - scale * Rotate(local.Orientation, Vec3(0, 0, leg.Height));
  this->Body->SetUserMatrix(MakeMatrix({ wheels, local.Orientation }, scale));
  const Pose head = leg.GetHead(time);
  const Pose scanner = local * Pose{ scale * head.Position, head.Orientation };
  this->Scanner->SetUserMatrix(MakeMatrix(scanner, scale));
}

//------------------------------------------------------------------------------
void PlatformView::SetFan(const Vec3& scanner, const std::vector<Vec3>& ends)
{
  vtkNew<vtkPoints> points;
  vtkNew<vtkCellArray> lines;
  const vtkIdType center = points->InsertNextPoint((scanner - this->Origin).GetData());
  for (const Vec3& end : ends)
  {
    const vtkIdType ids[2] = { center, points->InsertNextPoint((end - this->Origin).GetData()) };
    lines->InsertNextCell(2, ids);
  }
  this->Beams->SetPoints(points);
  this->Beams->SetLines(lines);
  this->Beams->Modified();
}

//------------------------------------------------------------------------------
vtkIdType PlatformView::GetNumberOfBeams() const
{
  return this->Beams->GetNumberOfLines();
}

} // namespace helios::viewer
