// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
// The inspector as text: beside its chart, and in the state file.
#include "heliosInspector.h"

#include "heliosCloudView.h"
#include "heliosColorMaps.h"
#include "heliosFormat.h"
#include "heliosSceneView.h"
#include "heliosSimulation.h"
#include "heliosTicks.h"
#include "heliosViewer.h"

#include <json/json.h>

#include <limits>

namespace helios::viewer
{

namespace
{

/// Returns a formatted number; empty if it is unknown.
std::string FormatNumber(const char* format, double value)
{
  char text[64];
  std::snprintf(text, sizeof(text), format, value);
  return std::isnan(value) ? "" : text;
}

} // namespace

//------------------------------------------------------------------------------
std::string Inspector::DescribeEcho() const
{
  const Echo echo = this->Owner.GetCloud().GetEcho(this->Row);
  double width = std::numeric_limits<double>::quiet_NaN();
  for (const PulseEcho& known : this->Reading.Echoes)
  {
    width = known.ReturnNumber == echo.ReturnNumber ? known.Width : width;
  }
  const bool isRaw = this->Owner.GetCloud().HasRawAmplitudes();
  std::string text = echo.PulseId < 0 ? Format("point %lld", static_cast<long long>(this->Row))
                                      : Format("pulse %lld", static_cast<long long>(echo.PulseId));
  text += Format(", return %d of %d", echo.ReturnNumber, echo.NumberOfReturns) +
    FormatNumber(", at %.6f s", echo.GpsTime) + "\n";
  text += std::isnan(echo.Range) ? "" : FormatNumber("%.3f m, ", echo.Range);
  text += isRaw                  ? FormatNumber("intensity %.0f", echo.Amplitude)
    : std::isnan(echo.Amplitude) ? ""
                                 : DescribeValue(echo.Amplitude, "W");
  text += FormatNumber(", %.2f ns wide", width) +
    FormatNumber(", incidence %.0f\xC2\xB0", echo.IncidenceAngle);
  text += "\n" + this->DescribeSurface(echo);
  if (this->Record.valid())
  {
    text += "\n\nlooking for the waveform ...";
  }
  return text + (this->Problem.empty() ? "" : "\n\n" + this->Problem);
}

//------------------------------------------------------------------------------
std::string Inspector::DescribeSurface(const Echo& echo) const
{
  SceneView* scene = this->Owner.GetSceneView();
  std::string text = GetClassName(echo.Class);
  if (echo.Part >= 0)
  {
    const std::string number = Format("part %d", echo.Part);
    const std::string known = this->Owner.GetCloud().GetPartName(echo.Part);
    const std::string name =
      scene ? scene->GetPartName(echo.Part) : (known.empty() ? number : known);
    text =
      (name == number || name == std::to_string(echo.Part) ? number : name + " (" + number + ")") +
      ", " + text;
  }
  if (!this->Reading.SubRays.empty())
  {
    text += this->Reading.SubRays.size() == 1
      ? ", hit by one sub-ray"
      : Format(", hit by %zu sub-rays", this->Reading.SubRays.size());
  }
  else if (!this->Reading.Samples.empty() && this->Owner.GetSimulation())
  {
    text += ", planar footprint: no sub-rays";
  }
  return text;
}

//------------------------------------------------------------------------------
std::string Inspector::GetStatus() const
{
  return this->Record.valid() ? "inspecting ..." : this->LineRecord.valid() ? "waveforms ..." : "";
}

//------------------------------------------------------------------------------
void Inspector::Describe(Json::Value& state) const
{
  Json::Value value;
  value["row"] = Json::Int64(this->Row);
  value["pulse"] = Json::Int64(this->Row >= 0 ? this->Reading.Pulse : -1);
  value["return"] = 0;
  value["position"] = Json::Value(Json::arrayValue);
  if (this->Row >= 0)
  {
    const Echo echo = this->Owner.GetCloud().GetEcho(this->Row);
    value["return"] = echo.ReturnNumber;
    for (int i = 0; i < 3; ++i)
    {
      value["position"].append(echo.Position[i]);
    }
  }
  value["waveformSamples"] = Json::Int64(this->Chart.GetNumberOfSamples());
  value["echoes"] = Json::Int64(this->Chart.GetNumberOfEchoes());
  value["gaussians"] = Json::Int64(this->Chart.GetNumberOfGaussians());
  value["subRays"] = Json::UInt64(this->Reading.SubRays.size());
  value["beams"] = Json::Int64(this->View.GetNumberOfBeams());
  value["waveforms"] = Json::Int64(this->View.GetNumberOfWaveforms());
  value["chart"] = this->Chart.IsVisible();
  value["waiting"] = this->IsWaiting();
  value["problem"] = this->Problem;
  state["inspector"] = value;
}

} // namespace helios::viewer
