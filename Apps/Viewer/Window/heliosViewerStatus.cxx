// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
// Text over the picture.
#include "heliosViewer.h"

#include "heliosCloudView.h"
#include "heliosFormat.h"
#include "heliosHud.h"
#include "heliosSimulation.h"
#include "heliosTimeBar.h"
#include "heliosViewerTool.h"

#include <vtkRenderWindowInteractor.h>
#include <vtkRenderer.h>

#include <algorithm>
#include <cmath>
#include <cstdio>

namespace helios::viewer
{

namespace
{

constexpr double RateSeconds = 0.5;     // averaging time of a rate
constexpr double RestSeconds = 0.12;    // time the mouse rests until its coordinates are shown
constexpr std::size_t MaximumLegs = 14; // listed

/// Shortens a number: "1.23 M".
std::string ShortenNumber(double number)
{
  if (number >= 1e6)
  {
    return Format("%.2f M", 1e-6 * number);
  }
  return number >= 1e4 ? Format("%.0f k", 1e-3 * number) : Format("%.0f", number);
}

std::string DescribeSpeed(double speed)
{
  if (std::isinf(speed))
  {
    return "maximum speed";
  }
  return speed == 1.0 ? "real time" : Format("%gx", speed);
}

} // namespace

//------------------------------------------------------------------------------
void Viewer::UpdateStatus()
{
  const double now = this->Now();
  this->CountRates();
  if (now > this->MessageUntil && !this->Message.empty())
  {
    this->Message.clear();
    this->Redraw();
  }
  std::string status = this->DescribeTime() + this->DescribeCloud();
  for (const auto& tool : this->Tools)
  {
    const std::string line = tool->GetStatus();
    status += line.empty() ? "" : line + "\n";
  }
  this->Words->SetStatus(status);
  const std::string legs = this->DescribeLegs();
  this->Words->SetLegs(legs);
  this->Words->SetLegend(this->FindLegend());
  if (status + legs + this->Message != this->ShownText)
  {
    this->ShownText = status + legs + this->Message;
    this->Redraw();
  }
  this->Words->SetMessage(this->Message);
  if (this->Bar)
  {
    this->Bar->SetTime(this->Clock.GetTime());
  }
}

//------------------------------------------------------------------------------
/// Returns the legend of the points; without one, that of a tool.
Legend Viewer::FindLegend() const
{
  Legend legend = this->PointsView->GetLegend();
  for (const auto& tool : this->Tools)
  {
    legend = legend.Colors.empty() ? tool->GetLegend() : legend;
  }
  return legend;
}

//------------------------------------------------------------------------------
void Viewer::PlacePanels()
{
  this->Words->SetPlaying(this->Clock.IsPlaying() && !this->IsFinished());
  this->Words->SetTimeBar(this->Bar && this->Clock.GetEnd() > this->Clock.GetStart());
  this->Words->Place();
  if (this->Bar)
  {
    this->Bar->Place(this->Words->GetTimeTrack(), this->Words->GetTheme());
  }
  for (const auto& tool : this->Tools)
  {
    tool->Place();
  }
}

//------------------------------------------------------------------------------
/// Returns whether all is computed and shown.
bool Viewer::IsFinished() const
{
  const bool isComputed =
    !this->Running || this->Running->GetPhase() == Simulation::Phase::Finished;
  return isComputed && this->Clock.GetTime() >= this->Clock.GetEnd();
}

//------------------------------------------------------------------------------
/// Counts pulses and points per second, when received.
void Viewer::CountRates()
{
  const double now = this->Now();
  const vtkIdType pulses = this->Running ? this->Running->GetCollectedPulses() : 0;
  const vtkIdType points = this->Points->GetNumberOfPoints();
  const double seconds = now - this->RateSince;
  if (seconds >= RateSeconds)
  {
    this->PulsesPerSecond = std::max(0.0, static_cast<double>(pulses - this->RatePulses) / seconds);
    this->PointsPerSecond = std::max(0.0, static_cast<double>(points - this->RatePoints) / seconds);
    this->RatePulses = pulses;
    this->RatePoints = points;
    this->RateSince = now;
  }
}

//------------------------------------------------------------------------------
std::string Viewer::DescribeTime() const
{
  if (this->IsLoading)
  {
    return "loading the scene\n";
  }
  if (this->Clock.GetEnd() <= this->Clock.GetStart())
  {
    return {};
  }
  if (this->IsFinished())
  {
    return Format("finished, %.3f s\n", this->Clock.GetEnd());
  }
  const char* doing = this->Clock.IsPlaying() ? "playing" : "paused";
  std::string text = Format("%.3f of %.3f s, %s, %s\n", this->Clock.GetTime(), this->Clock.GetEnd(),
    doing, DescribeSpeed(this->Clock.GetSpeed()).c_str());
  const bool isBehind = this->Running && this->Clock.IsPlaying() &&
    std::isfinite(this->Clock.GetSpeed()) &&
    this->Clock.GetTime() + 0.5 * this->Clock.GetSpeed() < this->Clock.GetEnd() &&
    this->Running->GetCollectedTime() <= this->Clock.GetTime();
  text += isBehind ? "slower: limited by the computation\n" : "";
  return text;
}

//------------------------------------------------------------------------------
std::string Viewer::DescribeCloud() const
{
  const auto points = static_cast<double>(this->Points->GetNumberOfPoints());
  std::string text;
  const bool isComputing = this->Running && this->Running->GetPhase() == Simulation::Phase::Running;
  if (this->Running && !this->IsLoading)
  {
    const std::string pulses =
      ShortenNumber(static_cast<double>(this->Running->GetCollectedPulses()));
    text += isComputing
      ? Format("%s of %s pulses, %s/s\n", pulses.c_str(),
          ShortenNumber(static_cast<double>(this->Running->GetNumberOfPulses())).c_str(),
          ShortenNumber(this->PulsesPerSecond).c_str())
      : pulses + " pulses\n";
  }
  if (points > 0.0)
  {
    text += points == 1.0 ? "1 point" : ShortenNumber(points) + " points";
    text += isComputing ? ", " + ShortenNumber(this->PointsPerSecond) + "/s\n" : "\n";
  }
  return text;
}

//------------------------------------------------------------------------------
/// Describes one leg per line, around the active one.
std::string Viewer::DescribeLegs() const
{
  const auto& legs = this->Legs;
  const SimulatedLeg* current = FindLeg(legs, this->Clock.GetTime());
  if (this->IsLoading || !current)
  {
    return {};
  }
  const auto at = static_cast<std::size_t>(current - legs.data());
  const std::size_t maximum = std::min(MaximumLegs, legs.size());
  const std::size_t first = std::min(at - std::min(at, maximum / 2), legs.size() - maximum);
  std::string text = Format("%zu of %zu legs\n", at + 1, legs.size());
  for (std::size_t i = first; i < first + maximum; ++i)
  {
    text += Format("%sleg %d  %.2f to %.2f s\n", i == at ? "> " : "", legs[i].Leg,
      legs[i].StartTime, legs[i].EndTime);
  }
  return text;
}

//------------------------------------------------------------------------------
/// Shows the coordinates of the surface or point below the mouse once it rests.
void Viewer::UpdateCursor(double now)
{
  int mouse[2];
  this->Interactor->GetEventPosition(mouse[0], mouse[1]);
  this->Words->ShowTip(mouse[0], mouse[1]) ? this->Redraw() : void();
  if (!this->HasMoved || this->IsDragging || now - this->MovedAt < RestSeconds)
  {
    return;
  }
  this->HasMoved = false;
  int at[2];
  this->Interactor->GetEventPosition(at[0], at[1]);
  PanelId panel = PanelId::Status;
  const double depth = this->Renderer->GetZ(at[0], at[1]); // 1: nothing is there
  const bool isHit = depth < 1.0 && !this->Words->GetLayout().Find(at[0], at[1], panel);
  this->Renderer->SetDisplayPoint(at[0], at[1], depth);
  this->Renderer->DisplayToWorld();
  const double* p = this->Renderer->GetWorldPoint();
  const Vec3 world = Vec3(p[0] / p[3], p[1] / p[3], p[2] / p[3]) + this->Origin;
  this->Words->SetCursor(
    isHit ? Format("E %.2f  N %.2f  z %.2f m", world[0], world[1], world[2]) : std::string());
  this->Redraw();
}

} // namespace helios::viewer
