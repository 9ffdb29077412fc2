// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
// Text over the picture.
#include "heliosViewer.h"

#include "heliosFormat.h"
#include "heliosHud.h"
#include "heliosSimulation.h"
#include "heliosTimeBar.h"
#include "heliosViewerTool.h"

#include <algorithm>
#include <cmath>
#include <cstdio>

namespace helios::viewer
{

namespace
{

constexpr double RateSeconds = 0.5;  // averaging time of a rate
constexpr std::size_t MostLegs = 14; // listed

/// "1.23 M".
std::string Shorten(double number)
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
void Viewer::WriteWords()
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
  this->Words->SetLegs(this->DescribeLegs());
  this->Words->SetMessage(this->Message);
  if (this->Bar)
  {
    this->Bar->SetTime(this->Clock.GetTime());
  }
}

//------------------------------------------------------------------------------
/// Pulses and points per second, as received.
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
  const char* doing = this->Clock.IsPlaying() ? "playing" : "paused";
  std::string text = Format("%.3f of %.3f s   %s, %s\n", this->Clock.GetTime(),
    this->Clock.GetEnd(), doing, DescribeSpeed(this->Clock.GetSpeed()).c_str());
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
  if (this->Running && !this->IsLoading)
  {
    text += Format("%s of %s pulses, %s/s\n",
      Shorten(static_cast<double>(this->Running->GetCollectedPulses())).c_str(),
      Shorten(static_cast<double>(this->Running->GetNumberOfPulses())).c_str(),
      Shorten(this->PulsesPerSecond).c_str());
  }
  if (points > 0.0)
  {
    text += Shorten(points) + " points";
    text += this->Running ? ", " + Shorten(this->PointsPerSecond) + "/s\n" : "\n";
  }
  return text;
}

//------------------------------------------------------------------------------
/// One line per leg, around the active one.
std::string Viewer::DescribeLegs() const
{
  const auto& legs = this->Legs;
  const SimulatedLeg* current = FindLeg(legs, this->Clock.GetTime());
  if (this->IsLoading || !current)
  {
    return {};
  }
  const auto at = static_cast<std::size_t>(current - legs.data());
  const std::size_t most = std::min(MostLegs, legs.size());
  const std::size_t first = std::min(at - std::min(at, most / 2), legs.size() - most);
  std::string text = Format("%zu of %zu legs\n", at + 1, legs.size());
  for (std::size_t i = first; i < first + most; ++i)
  {
    text += Format("%sleg %d  %.2f to %.2f s\n", i == at ? "> " : "", legs[i].Leg,
      legs[i].StartTime, legs[i].EndTime);
  }
  return text;
}

} // namespace helios::viewer
