// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
#include "heliosCloudView.h"

#include "heliosPixelMap.h"
#include "heliosPointActor.h"

#include <vtkCommand.h>
#include <vtkPlane.h>
#include <vtkPlaneCollection.h>
#include <vtkRenderer.h>

#include <algorithm>
#include <cmath>

namespace helios::viewer
{

//------------------------------------------------------------------------------
CloudView::CloudView(const Cloud& cloud, vtkRenderer* renderer)
  : Points(cloud)
  , Renderer(renderer)
  , Sample(std::make_unique<PointActor>(renderer))
{
  this->Sample->SetPointSize(this->PointSize);
  renderer->AddViewProp(this->Room);
  this->Observer = renderer->AddObserver(vtkCommand::StartEvent, this, &CloudView::ShowVisible);
  this->Update();
}

//------------------------------------------------------------------------------
CloudView::~CloudView()
{
  this->Renderer->RemoveObserver(this->Observer);
  this->Renderer->RemoveViewProp(this->Room);
  this->SetEyeDomeLighting(false);
}

//------------------------------------------------------------------------------
void CloudView::Update()
{
  if (this->Points.GetNumberOfPoints() < this->Sampled) // was cleared
  {
    this->Chunks.clear();
    this->Sample->SetVisible(false);
    this->SampleRows.clear();
    this->SampleMask = 0;
    this->Sampled = this->FittedTo = 0;
  }
  if (this->Sampled == 0)
  {
    this->SetUpPlanes(); // the first points set the origin
  }
  this->UpdateSample();
  const bool hasGrown = this->Points.GetNumberOfPoints() > 1.1 * this->FittedTo;
  if (hasGrown)
  {
    this->FittedTo = this->Points.GetNumberOfPoints();
    if (this->AutomaticRange && this->FitRange())
    {
      this->Recolor();
    }
    this->UpdateLegend();
  }
  this->Refresh();
}

//------------------------------------------------------------------------------
std::vector<double> CloudView::GetSampleValues() const
{
  std::vector<double> values(this->Colors.IsPlain() ? 0 : this->SampleRows.size());
  for (std::size_t i = 0; i < values.size(); ++i)
  {
    const CloudChunk& chunk = this->Points.FindChunk(this->SampleRows[i]);
    const vtkIdType at = this->SampleRows[i] - chunk.FirstRow;
    this->Points.GetValues(
      chunk, static_cast<CloudColumn>(this->Colors.By), at, at + 1, values.data() + i);
  }
  return values;
}

//------------------------------------------------------------------------------
bool CloudView::FitRange()
{
  CloudColors fitted = this->Colors;
  if (fitted.IsCategory() || !fitted.FitRange(this->GetSampleValues()))
  {
    return false;
  }
  // Small changes do not justify recolouring all points.
  const double tolerance = 0.05 * (fitted.High - fitted.Low);
  const bool differs = std::abs(fitted.Low - this->Colors.Low) > tolerance ||
    std::abs(fitted.High - this->Colors.High) > tolerance;
  if (differs)
  {
    this->Colors = fitted;
  }
  return differs;
}

//------------------------------------------------------------------------------
void CloudView::UpdateLegend()
{
  const bool isShown = this->Visible && this->Points.GetNumberOfPoints() > 0;
  this->Scale = isShown
    ? this->Colors.MakeLegend(
        this->Points, this->Colors.IsCategory() ? this->GetSampleValues() : std::vector<double>())
    : Legend();
}

//------------------------------------------------------------------------------
void CloudView::Recolor()
{
  for (const auto& chunk : this->Chunks)
  {
    chunk->Rgba.clear();
  }
}

//------------------------------------------------------------------------------
void CloudView::SetWholeLimit(vtkIdType points)
{
  this->WholeLimit = points;
  this->Sample->SetVisible(false);
  this->Refresh();
}

//------------------------------------------------------------------------------
void CloudView::SetColorBy(ColorBy by)
{
  if (by == this->Colors.By)
  {
    return;
  }
  this->Colors.By = by;
  this->SetAutomaticRange();
}

//------------------------------------------------------------------------------
void CloudView::SetColor(const Rgb& color)
{
  this->Colors.One = color;
  this->Recolor();
  this->Refresh();
}

//------------------------------------------------------------------------------
bool CloudView::SetRange(double low, double high)
{
  if (!(low < high) || !std::isfinite(high - low))
  {
    return false;
  }
  this->AutomaticRange = false;
  this->Colors.Low = low;
  this->Colors.High = high;
  this->Recolor();
  this->UpdateLegend();
  this->Refresh();
  return true;
}

//------------------------------------------------------------------------------
void CloudView::SetAutomaticRange()
{
  this->AutomaticRange = true;
  this->Colors.FitRange(this->GetSampleValues());
  this->Recolor();
  this->UpdateLegend();
  this->Refresh();
}

//------------------------------------------------------------------------------
void CloudView::SetPointSize(double size)
{
  this->PointSize = std::min(std::max(size, 1.0), 50.0);
  for (const auto& actor : this->Chunks)
  {
    actor->SetPointSize(this->PointSize);
  }
  this->Sample->SetPointSize(this->PointSize);
}

//------------------------------------------------------------------------------
void CloudView::SetEyeDomeLighting(bool on)
{
  this->EyeDomeLighting = on;
  this->Unshaded = false;
  this->UpdatePass();
}

//------------------------------------------------------------------------------
bool CloudView::SetClipBox(const double bounds[6])
{
  for (int axis = 0; axis < 3; ++axis)
  {
    if (!(bounds[2 * axis] <= bounds[2 * axis + 1]))
    {
      return false;
    }
  }
  std::copy(bounds, bounds + 6, this->Box);
  this->SetUpPlanes();
  return true;
}

//------------------------------------------------------------------------------
void CloudView::SetClipping(bool on)
{
  this->Window.HasBox = on;
  this->SetUpPlanes();
}

//------------------------------------------------------------------------------
void CloudView::SetSection(const std::optional<Slab>& slab)
{
  this->Section = slab;
  this->SetUpPlanes();
}

//------------------------------------------------------------------------------
void CloudView::SetUpPlanes()
{
  this->Planes->RemoveAllItems();
  this->Window.HasSlab = this->Section.has_value();
  if (this->Section)
  {
    this->Window.Section = this->Section->RelativeTo(this->Points.GetOrigin());
    this->Window.Section.AddPlanes(this->Planes);
  }
  for (int i = 0; i < 6; ++i)
  {
    this->Window.Box[i] = this->Box[i] - this->Points.GetOrigin()[i / 2];
    vtkNew<vtkPlane> plane;
    Vec3 origin(0.0, 0.0, 0.0), normal(0.0, 0.0, 0.0);
    origin[i / 2] = this->Window.Box[i];
    normal[i / 2] = i % 2 == 0 ? 1.0 : -1.0;
    plane->SetOrigin(origin.GetData());
    plane->SetNormal(normal.GetData());
    this->Window.HasBox ? this->Planes->AddItem(plane) : void();
  }
  for (const auto& actor : this->Chunks)
  {
    actor->SetPlanes(this->Window.IsClipped() ? this->Planes.Get() : nullptr);
  }
  this->Refresh();
}

//------------------------------------------------------------------------------
void CloudView::SetTimeLimit(double time)
{
  this->Window.TimeLimit = time;
  this->Refresh();
}

//------------------------------------------------------------------------------
void CloudView::SetInteracting(bool on)
{
  if (on != this->Interacting)
  {
    this->Interacting = on;
    this->UpdatePass();
    this->Refresh();
  }
}

//------------------------------------------------------------------------------
void CloudView::SetVisible(bool on)
{
  this->Visible = on;
  this->Sample->SetVisible(false);
  this->UpdateLegend();
  this->Refresh();
}

//------------------------------------------------------------------------------
void CloudView::SetRampPart(const RampPart& part)
{
  this->Colors.Colors = MakeRamp(part);
  this->Recolor();
  this->UpdateLegend();
  this->Refresh();
}

//------------------------------------------------------------------------------
std::optional<Echo> CloudView::Pick(double x, double y, double radius) const
{
  const PickSpot spot{ x, y, radius, this->PointSize };
  const vtkIdType row =
    this->Visible ? PickPoint(this->Points, this->Window, this->Renderer, spot) : -1;
  return row < 0 ? std::nullopt : std::optional<Echo>(this->Points.GetEcho(row));
}

//------------------------------------------------------------------------------
vtkIdType CloudView::GetNumberOfDrawnPoints() const
{
  vtkIdType count = this->Sample->IsVisible() ? this->Sample->GetNumberOfPoints() : 0;
  for (const auto& actor : this->Chunks)
  {
    count += actor->IsVisible() ? actor->GetNumberOfPoints() : 0;
  }
  return count;
}

//------------------------------------------------------------------------------
std::size_t CloudView::GetMemorySize() const
{
  std::size_t bytes = this->Sample->GetMemorySize() + this->SampleXyz.capacity() * sizeof(float) +
    this->SampleRows.capacity() * sizeof(std::uint32_t);
  for (const auto& actor : this->Chunks)
  {
    bytes += actor->GetMemorySize();
  }
  return bytes;
}

} // namespace helios::viewer
