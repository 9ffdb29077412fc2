// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
#include "heliosPulseView.h"

#include "heliosColorMaps.h"
#include "heliosErrorText.h"
#include "heliosStatus.h"
#include "vtkHeliosWaveformPolylines.h"

#include <vtkActor.h>
#include <vtkActor2D.h>
#include <vtkCamera.h>
#include <vtkCellArray.h>
#include <vtkCellData.h>
#include <vtkCoordinate.h>
#include <vtkPointData.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>
#include <vtkPolyDataMapper.h>
#include <vtkPolyDataMapper2D.h>
#include <vtkProperty.h>
#include <vtkProperty2D.h>
#include <vtkRegularPolygonSource.h>
#include <vtkRenderer.h>
#include <vtkTable.h>
#include <vtkUnsignedCharArray.h>

#include <cmath>

namespace helios::viewer
{

namespace
{

constexpr double RingPixels = 11.0;
const Rgb UnknownColor = { 200, 205, 210 };

void SetUp(vtkRenderer* renderer, vtkActor* actor, vtkPolyData* data, bool hasColors)
{
  vtkNew<vtkPolyDataMapper> mapper;
  mapper->SetInputData(data);
  mapper->SetScalarVisibility(hasColors);
  actor->SetMapper(mapper);
  actor->GetProperty()->LightingOff();
  actor->PickableOff();
  actor->UseBoundsOff();
  renderer->AddActor(actor);
}

/// Draws lines and points on top of the picture.
void SetUpOverlay(vtkRenderer* renderer, vtkActor2D* actor, vtkPolyData* data, bool hasColors)
{
  vtkNew<vtkCoordinate> world;
  world->SetCoordinateSystemToWorld();
  vtkNew<vtkPolyDataMapper2D> mapper;
  mapper->SetInputData(data);
  mapper->SetTransformCoordinate(world);
  mapper->SetScalarVisibility(hasColors);
  actor->SetMapper(mapper);
  actor->PickableOff();
  renderer->AddActor2D(actor);
}

void SetUpRing(vtkActor2D* actor)
{
  vtkNew<vtkRegularPolygonSource> ring;
  ring->SetNumberOfSides(32);
  ring->SetRadius(RingPixels);
  ring->GeneratePolygonOff();
  vtkNew<vtkPolyDataMapper2D> mapper;
  mapper->SetInputConnection(ring->GetOutputPort());
  actor->SetMapper(mapper);
  actor->GetPositionCoordinate()->SetCoordinateSystemToWorld();
  actor->GetProperty()->SetColor(1.0, 0.85, 0.25);
  actor->GetProperty()->SetLineWidth(2.5F);
  actor->PickableOff();
  actor->VisibilityOff();
}

/// Finds the end points of the beams: sub-rays, or else the echoes.
std::vector<SubRayHit> FindEnds(const PulseReading& reading)
{
  std::vector<SubRayHit> ends = reading.SubRays;
  for (std::size_t i = 0; reading.SubRays.empty() && i < reading.Echoes.size(); ++i)
  {
    ends.push_back({ reading.Echoes[i].Position, 1.0, reading.Echoes[i].Part });
  }
  return ends;
}

} // namespace

//------------------------------------------------------------------------------
PulseView::PulseView(vtkRenderer* renderer)
  : Renderer(renderer)
{
  SetUp(renderer, this->BeamActor, this->Beams, true);
  SetUp(renderer, this->WaveformActor, this->Waveforms, false);
  this->BeamActor->GetProperty()->SetOpacity(0.55);
  this->WaveformActor->GetProperty()->SetColor(0.35, 0.85, 1.0);
  this->WaveformActor->GetProperty()->SetLineWidth(1.5F);
  this->WaveformActor->GetProperty()->SetOpacity(0.7);
  SetUpOverlay(renderer, this->Curve, this->Waveforms, false);
  SetUpOverlay(renderer, this->HitActor, this->Hits, true);
  this->HitActor->GetProperty()->SetPointSize(5.0F);
  this->Curve->GetProperty()->SetColor(0.35, 0.85, 1.0);
  this->Curve->GetProperty()->SetLineWidth(2.0F);
  SetUpRing(this->Mark);
  renderer->AddActor2D(this->Mark);
  this->Clear();
}

//------------------------------------------------------------------------------
PulseView::~PulseView()
{
  for (vtkActor2D* actor : { this->Mark.Get(), this->HitActor.Get(), this->Curve.Get() })
  {
    this->Renderer->RemoveActor2D(actor);
  }
  this->Renderer->RemoveActor(this->BeamActor);
  this->Renderer->RemoveActor(this->WaveformActor);
}

//------------------------------------------------------------------------------
void PulseView::SetMark(const Vec3& position)
{
  this->Marked = position - this->Origin;
  this->HasMark = true;
  this->Mark->GetPositionCoordinate()->SetValue(this->Marked[0], this->Marked[1], this->Marked[2]);
  this->Update();
}

//------------------------------------------------------------------------------
void PulseView::SetBeams(const PulseReading& reading)
{
  vtkNew<vtkPoints> points;
  vtkNew<vtkPoints> ends;
  vtkNew<vtkCellArray> lines;
  vtkNew<vtkCellArray> vertices;
  vtkNew<vtkUnsignedCharArray> colors;
  colors->SetNumberOfComponents(3);
  const vtkIdType start = points->InsertNextPoint((reading.Origin - this->Origin).GetData());
  for (const SubRayHit& hit : FindEnds(reading))
  {
    const Vec3 end = hit.Position - this->Origin;
    const vtkIdType vertex = ends->InsertNextPoint(end.GetData());
    vertices->InsertNextCell(1, &vertex);
    const Rgb color = hit.Part < 0 ? UnknownColor : GetDistinctColor(hit.Part);
    colors->InsertNextTypedTuple(color.data());
    const vtkIdType line[2] = { start, points->InsertNextPoint(end.GetData()) };
    lines->InsertNextCell(2, line);
  }
  this->Hits->SetPoints(ends);
  this->Hits->SetVerts(vertices);
  this->Hits->GetCellData()->SetScalars(colors);
  this->Beams->Initialize();
  if (reading.HasOrigin)
  {
    this->Beams->SetPoints(points);
    this->Beams->SetLines(lines);
    this->Beams->GetCellData()->SetScalars(colors);
  }
}

//------------------------------------------------------------------------------
Status PulseView::SetWaveforms(vtkTable* waveforms, double height, int everyNth, std::int64_t pulse)
{
  vtkNew<vtkHeliosWaveformPolylines> curves;
  const ErrorText errors(curves);
  curves->SetInputData(waveforms);
  curves->SetHeight(height);
  curves->SetEveryNth(everyNth);
  double right[3], up[3];
  vtkCamera* camera = this->Renderer->GetActiveCamera();
  camera->GetViewUp(up);
  vtkMath::Cross(camera->GetDirectionOfProjection(), up, right);
  curves->SetDisplacementDirection(right);
  if (pulse >= 0)
  {
    curves->AddPulseId(pulse);
  }
  curves->Update();
  this->Waveforms->Initialize();
  if (!errors.IsEmpty())
  {
    return errors.IsEmpty() ? Status() : Status::Error(errors.Get(""));
  }
  vtkNew<vtkPoints> points;
  for (vtkIdType i = 0; i < curves->GetOutput()->GetNumberOfPoints(); ++i)
  {
    points->InsertNextPoint((Vec3(curves->GetOutput()->GetPoint(i)) - this->Origin).GetData());
  }
  this->Waveforms->SetPoints(points);
  this->Waveforms->SetLines(curves->GetOutput()->GetLines());
  this->WaveformActor->SetVisibility(pulse < 0); // many: near ones occlude far ones
  this->Curve->SetVisibility(pulse >= 0);
  return {};
}

//------------------------------------------------------------------------------
void PulseView::Clear()
{
  this->HasMark = false;
  for (vtkPolyData* data : { this->Beams.Get(), this->Hits.Get(), this->Waveforms.Get() })
  {
    data->Initialize();
  }
  this->Update();
}

//------------------------------------------------------------------------------
void PulseView::Update()
{
  vtkCamera* camera = this->Renderer->GetActiveCamera();
  const Vec3 ahead(camera->GetDirectionOfProjection());
  const bool isAhead = (this->Marked - Vec3(camera->GetPosition())).Dot(ahead) > 0.0;
  this->Mark->SetVisibility(this->HasMark && isAhead);
}

//------------------------------------------------------------------------------
vtkIdType PulseView::GetNumberOfBeams() const
{
  return this->Beams->GetNumberOfLines();
}

//------------------------------------------------------------------------------
vtkIdType PulseView::GetNumberOfHits() const
{
  return this->Hits->GetNumberOfVerts();
}

//------------------------------------------------------------------------------
vtkIdType PulseView::GetNumberOfWaveforms() const
{
  return this->Waveforms->GetNumberOfLines();
}

} // namespace helios::viewer
