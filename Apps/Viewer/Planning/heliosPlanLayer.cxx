// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
#include "heliosPlanLayer.h"

#include <vtkActor.h>
#include <vtkCamera.h>
#include <vtkCellArray.h>
#include <vtkCoordinate.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>
#include <vtkPolyDataMapper.h>
#include <vtkProperty.h>
#include <vtkRenderer.h>
#include <vtkTextActor.h>
#include <vtkTextProperty.h>
#include <vtkUnsignedCharArray.h>

namespace helios::viewer
{

//------------------------------------------------------------------------------
PlanLayer::PlanLayer(vtkRenderer* renderer, const Vec3& origin)
  : Renderer(renderer)
  , Origin(origin)
{
}

//------------------------------------------------------------------------------
PlanLayer::~PlanLayer()
{
  for (const auto& actor : this->Actors)
  {
    this->Renderer->RemoveActor(actor);
  }
  for (const auto& label : this->Labels)
  {
    this->Renderer->RemoveActor2D(label);
  }
}

//------------------------------------------------------------------------------
void PlanLayer::AddActor(vtkActor* actor)
{
  actor->PickableOff();
  this->Renderer->AddActor(actor);
  this->Actors.emplace_back(actor);
}

//------------------------------------------------------------------------------
void PlanLayer::AddPoints(vtkPoints* points, const std::vector<Rgb>& colors, float size)
{
  vtkNew<vtkPolyData> data;
  vtkNew<vtkCellArray> vertices;
  for (vtkIdType i = 0; i < points->GetNumberOfPoints(); ++i)
  {
    vertices->InsertNextCell(1, &i);
  }
  vtkNew<vtkUnsignedCharArray> scalars;
  scalars->SetNumberOfComponents(3);
  for (vtkIdType i = 0; i < points->GetNumberOfPoints(); ++i)
  {
    const std::size_t own = colors.size() > 1 ? static_cast<std::size_t>(i) : 0;
    scalars->InsertNextTypedTuple(colors[own].data());
  }
  data->SetPoints(points);
  data->SetVerts(vertices);
  data->GetPointData()->SetScalars(scalars);
  vtkNew<vtkPolyDataMapper> mapper;
  mapper->SetInputData(data);
  vtkNew<vtkActor> actor;
  actor->SetMapper(mapper);
  actor->GetProperty()->LightingOff();
  actor->GetProperty()->SetPointSize(size);
  this->AddActor(actor);
}

//------------------------------------------------------------------------------
void PlanLayer::AddLabel(const std::string& text, const Vec3& place)
{
  vtkNew<vtkTextActor> label;
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
  this->Renderer->AddActor2D(label);
  this->Labels.emplace_back(label);
}

//------------------------------------------------------------------------------
void PlanLayer::SetVisible(bool visible)
{
  this->Visible = visible;
  for (const auto& actor : this->Actors)
  {
    actor->SetVisibility(visible);
  }
  for (const auto& label : this->Labels)
  {
    label->SetVisibility(visible);
  }
}

//------------------------------------------------------------------------------
void PlanLayer::Update()
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

} // namespace helios::viewer
