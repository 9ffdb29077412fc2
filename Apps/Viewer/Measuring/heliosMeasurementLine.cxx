// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
#include "heliosMeasurementLine.h"

#include "heliosCloudView.h"
#include "heliosSceneView.h"
#include "heliosTheme.h"
#include "heliosViewer.h"

#include <vtkActor2D.h>
#include <vtkCellArray.h>
#include <vtkCoordinate.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>
#include <vtkPolyDataMapper2D.h>
#include <vtkProperty2D.h>
#include <vtkRenderer.h>

namespace helios::viewer
{

namespace
{

constexpr double PickPixels = 6.0;

} // namespace

//------------------------------------------------------------------------------
MeasurementLine::MeasurementLine(vtkRenderer* renderer)
  : Renderer(renderer)
{
  vtkNew<vtkCoordinate> world;
  world->SetCoordinateSystemToWorld();
  vtkNew<vtkPolyDataMapper2D> mapper;
  mapper->SetTransformCoordinate(world);
  mapper->SetInputData(this->Data);
  this->Actor->SetMapper(mapper);
  this->Actor->GetProperty()->SetLineWidth(2.0F);
  this->Actor->GetProperty()->SetPointSize(8.0F);
  this->Actor->PickableOff();
  this->Actor->VisibilityOff();
  renderer->AddActor2D(this->Actor);
}

//------------------------------------------------------------------------------
MeasurementLine::~MeasurementLine()
{
  this->Renderer->RemoveActor2D(this->Actor);
}

//------------------------------------------------------------------------------
void MeasurementLine::SetPoints(const std::vector<Vec3>& places, const Rgb& color)
{
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  vtkNew<vtkCellArray> vertices;
  vtkNew<vtkCellArray> lines;
  const auto count = static_cast<vtkIdType>(places.size());
  for (vtkIdType i = 0; i < count; ++i)
  {
    points->InsertNextPoint(places[static_cast<std::size_t>(i)].GetData());
    vertices->InsertNextCell(1, &i);
    if (i > 0)
    {
      const vtkIdType ends[2] = { i - 1, i };
      lines->InsertNextCell(2, ends);
    }
  }
  this->Data->Initialize();
  this->Data->SetPoints(points);
  this->Data->SetVerts(vertices);
  this->Data->SetLines(lines);
  this->Actor->GetProperty()->SetColor(Shade(color).Rgb);
  this->Actor->SetVisibility(count > 0);
}

//------------------------------------------------------------------------------
std::optional<Vec3> PickPosition(Viewer& viewer, int x, int y)
{
  const auto echo = viewer.GetCloudView().Pick(x, y, PickPixels);
  if (echo)
  {
    return echo->Position;
  }
  SceneView* scene = viewer.GetSceneView();
  const auto hit = scene && scene->IsVisible() ? scene->Pick(x, y) : std::nullopt;
  return hit ? std::optional<Vec3>(hit->Position) : std::nullopt;
}

} // namespace helios::viewer
