// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
// Selects the drawn points: all, a sample or the visible.
#include "heliosCloudView.h"

#include "heliosEyeDome.h"
#include "heliosPixelMap.h"
#include "heliosPointActor.h"

#include <vtkRenderPass.h>
#include <vtkRenderWindow.h>
#include <vtkRenderer.h>
#include <vtkSMPTools.h>

#include <algorithm>

namespace helios::viewer
{

namespace
{

/// Hashes rows, so that a sample by the last bits has no pattern.
std::uint32_t Hash(std::uint32_t row)
{
  row = (row ^ (row >> 16)) * 0x7feb352du;
  row = (row ^ (row >> 15)) * 0x846ca68bu;
  return row ^ (row >> 16);
}

} // namespace

//------------------------------------------------------------------------------
void CloudView::UpdateSample()
{
  const auto end = static_cast<std::uint32_t>(this->Points.GetNumberOfPoints());
  for (auto row = static_cast<std::uint32_t>(this->Sampled); row < end; ++row)
  {
    if ((Hash(row) & this->SampleMask) != 0)
    {
      continue;
    }
    if (this->SampleRows.size() == MaximumSample)
    {
      this->SampleMask = 2 * this->SampleMask + 1;
      this->SampleRows.erase(
        std::remove_if(this->SampleRows.begin(), this->SampleRows.end(),
          [this](std::uint32_t kept) { return (Hash(kept) & this->SampleMask) != 0; }),
        this->SampleRows.end());
      if ((Hash(row) & this->SampleMask) != 0)
      {
        continue;
      }
    }
    this->SampleRows.push_back(row);
  }
  this->Sampled = end;
}

//------------------------------------------------------------------------------
void CloudView::Refresh()
{
  this->Stale = true;
  this->UpdateRoom();
  const auto& chunks = this->Points.GetChunks();
  while (this->IsWhole() && this->Chunks.size() < chunks.size())
  {
    this->Chunks.push_back(std::make_unique<PointActor>(this->Renderer));
    PointActor& actor = *this->Chunks.back();
    actor.Rgba.reserve(static_cast<std::size_t>(4 * CloudChunk::Capacity));
    actor.SetPointSize(this->PointSize);
    actor.SetPlanes(this->Window.IsClipped() ? this->Planes.Get() : nullptr);
  }
  if (!this->IsWhole())
  {
    this->Chunks.clear();
  }
  if (this->Interacting && this->SampleMask != 0)
  {
    for (const auto& actor : this->Chunks)
    {
      actor->SetVisible(false);
    }
    this->ShowSample();
  }
  else if (this->IsWhole())
  {
    this->Colorize();
    for (std::size_t c = 0; c < chunks.size(); ++c)
    {
      this->ShowChunk(c);
    }
    this->Sample->SetVisible(false);
  }
}

//------------------------------------------------------------------------------
void CloudView::UpdateRoom()
{
  double bounds[6];
  const bool hasRoom = this->Visible && this->Points.GetBounds(bounds);
  for (int i = 0; i < 6; ++i)
  {
    bounds[i] -= this->Points.GetOrigin()[i / 2];
  }
  this->Room->SetBounds(hasRoom ? bounds : nullptr);
}

//------------------------------------------------------------------------------
void CloudView::Colorize()
{
  vtkSMPTools::For(0, static_cast<vtkIdType>(this->Chunks.size()), 1,
    [this](vtkIdType begin, vtkIdType end)
    {
      for (auto c = static_cast<std::size_t>(begin); c < static_cast<std::size_t>(end); ++c)
      {
        const CloudChunk& chunk = *this->Points.GetChunks()[c];
        PointActor& actor = *this->Chunks[c];
        const auto colored = static_cast<vtkIdType>(actor.Rgba.size() / 4);
        if (colored < chunk.GetSize())
        {
          actor.Rgba.resize(static_cast<std::size_t>(4 * chunk.GetSize()));
          this->Colors.Map(
            this->Points, chunk, colored, chunk.GetSize(), actor.Rgba.data() + 4 * colored);
          actor.ColorsChanged();
        }
      }
    });
}

//------------------------------------------------------------------------------
void CloudView::ShowChunk(std::size_t c)
{
  const CloudChunk& chunk = *this->Points.GetChunks()[c];
  PointActor& actor = *this->Chunks[c];
  if (!this->Visible || this->Window.IsOutside(chunk))
  {
    actor.SetVisible(false);
    return;
  }
  const double limit = this->Window.TimeLimit;
  if (!(chunk.LastTime > limit))
  {
    actor.Show(chunk.GetXyz(), chunk.GetSize());
  }
  else if (chunk.IsInTimeOrder)
  {
    vtkIdType first = 0, count = chunk.GetSize();
    while (count > 0) // binary search for the first later point
    {
      const vtkIdType half = count / 2;
      const bool isShown = !(chunk.GetTime(first + half) > limit);
      first = isShown ? first + half + 1 : first;
      count = isShown ? count - half - 1 : half;
    }
    actor.Show(chunk.GetXyz(), first);
  }
  else
  {
    std::vector<vtkIdType> which;
    for (vtkIdType i = 0; i < chunk.GetSize(); ++i)
    {
      if (!(chunk.GetTime(i) > limit))
      {
        which.push_back(i);
      }
    }
    actor.ShowSome(chunk.GetXyz(), which);
  }
  actor.SetVisible(true);
}

//------------------------------------------------------------------------------
void CloudView::ShowSample()
{
  std::vector<std::uint32_t> rows;
  const std::uint32_t mask = this->SampleMask | this->MovingMask;
  for (const std::uint32_t row : this->SampleRows)
  {
    const CloudChunk& chunk = this->Points.FindChunk(row);
    if ((Hash(row) & mask) == 0 && this->Window.Contains(chunk, row - chunk.FirstRow))
    {
      rows.push_back(row);
    }
  }
  this->ShowRows(rows);
}

//------------------------------------------------------------------------------
void CloudView::ShowVisible()
{
  if (this->IsWhole() || this->Interacting || !this->Visible)
  {
    return;
  }
  const PixelMap pixels(this->Renderer);
  if (this->Stale || !this->VisibleFrom || !(*this->VisibleFrom == pixels))
  {
    this->ShowRows(FindVisiblePoints(this->Points, this->Window, pixels));
    this->VisibleFrom = std::make_unique<PixelMap>(pixels);
    this->Stale = false;
  }
}

//------------------------------------------------------------------------------
void CloudView::ShowRows(const std::vector<std::uint32_t>& rows)
{
  std::vector<std::uint8_t>& rgba = this->Sample->Rgba;
  rgba.resize(4 * rows.size());
  this->SampleXyz.resize(3 * rows.size());
  vtkSMPTools::For(0, static_cast<vtkIdType>(rows.size()),
    [&](vtkIdType begin, vtkIdType end)
    {
      for (auto k = static_cast<std::size_t>(begin); k < static_cast<std::size_t>(end); ++k)
      {
        const CloudChunk& chunk = this->Points.FindChunk(rows[k]);
        const vtkIdType i = rows[k] - chunk.FirstRow;
        std::copy(
          chunk.GetXyz() + 3 * i, chunk.GetXyz() + 3 * i + 3, this->SampleXyz.data() + 3 * k);
        this->Colors.Map(this->Points, chunk, i, i + 1, rgba.data() + 4 * k);
      }
    });
  this->Sample->ColorsChanged();
  this->Sample->Show(this->SampleXyz.data(), 0); // the values have changed in place
  this->Sample->Show(this->SampleXyz.data(), static_cast<vtkIdType>(rows.size()));
  this->Sample->SetVisible(this->Visible);
}

//------------------------------------------------------------------------------
void CloudView::UpdatePass()
{
  const bool shaded = this->EyeDomeLighting && !(this->Interacting && this->Unshaded);
  if (shaded == this->Shaded)
  {
    return;
  }
  this->Shaded = shaded;
  if (this->Renderer->GetPass() && this->Renderer->GetRenderWindow())
  {
    this->Renderer->GetPass()->ReleaseGraphicsResources(this->Renderer->GetRenderWindow());
  }
  this->Renderer->SetPass(shaded ? MakeEyeDomePass().Get() : nullptr);
}

//------------------------------------------------------------------------------
void CloudView::ReportFrame(double seconds)
{
  constexpr std::size_t minimum = 20000;
  if (!this->Interacting)
  {
    return;
  }
  const std::uint32_t mask = this->SampleMask | this->MovingMask;
  if (seconds > 0.08 && this->Shaded)
  {
    this->Unshaded = true;
    this->UpdatePass();
  }
  else if (seconds > 0.08 &&
    (this->SampleRows.size() >> 1) / (mask / (this->SampleMask + 1) + 1) >= minimum)
  {
    this->MovingMask = 2 * mask + 1;
    this->Refresh();
  }
  else if (seconds < 0.025 && mask != this->SampleMask)
  {
    this->MovingMask = mask / 2;
    this->Refresh();
  }
}

} // namespace helios::viewer
