// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
#include "heliosInspector.h"

#include "heliosCloudView.h"
#include "heliosFormat.h"
#include "heliosHud.h"
#include "heliosSceneView.h"
#include "heliosSimulation.h"
#include "heliosStatus.h"
#include "heliosSurveyData.h"
#include "heliosViewer.h"

#include <vtkPolyData.h>
#include <vtkTable.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <utility>

namespace helios::viewer
{

namespace
{

constexpr double PickPixels = 6.0;
constexpr vtkIdType MaximumPulses = 4096; // pulses of a line when re-run
constexpr vtkIdType MaximumWaveforms = 256;
constexpr vtkIdType UsualLine = 1000; // pulses, if the scan has no lines or is unknown
constexpr double WaveShare = 0.35;    // waveform height, of its length
constexpr double LineShare = 0.015;   // waveform height in a line, of its range

bool IsReady(const std::future<PulseRecord>& answer)
{
  return answer.valid() && answer.wait_for(std::chrono::seconds(0)) == std::future_status::ready;
}

/// Gets the record; returns the error of the thread that made it.
Status Receive(std::future<PulseRecord>& answer, PulseRecord& record)
{
  try
  {
    record = answer.get();
    return {};
  }
  catch (const std::future_error&)
  {
    return Status::Error("the run has ended with an error; its pulses cannot be simulated again");
  }
  catch (const std::exception& error)
  {
    return Status::Error(error.what());
  }
}

PulseEcho MakeEcho(const Echo& from)
{
  PulseEcho echo;
  echo.Position = from.Position;
  echo.ReturnNumber = from.ReturnNumber;
  echo.NumberOfReturns = from.NumberOfReturns;
  echo.Class = from.Class;
  echo.Part = from.Part;
  echo.GpsTime = from.GpsTime;
  echo.Range = from.Range;
  echo.Amplitude = from.Amplitude;
  echo.IncidenceAngle = from.IncidenceAngle;
  return echo;
}

} // namespace

//------------------------------------------------------------------------------
Inspector::Inspector(Viewer& viewer)
  : Owner(viewer)
  , View(viewer.GetRenderer())
  , Chart(viewer.GetRenderer())
{
}

//------------------------------------------------------------------------------
Inspector::~Inspector() = default;

//------------------------------------------------------------------------------
std::vector<KeyHelp> Inspector::GetKeys() const
{
  return { { "click", "the pulse of an echo: waveform, sub-rays", "" },
    { "i", "the pulse of the echo in the middle; close", "i" }, { "n", "next echo", "n" },
    { "N", "previous echo", "N" }, { "Up", "next pulse", "Up" },
    { "Down", "previous pulse", "Down" }, { "u", "waveforms of the scan line", "u" },
    { "Escape", "close the inspector", "Escape" } };
}

//------------------------------------------------------------------------------
bool Inspector::OnKey(const std::string& key, bool control)
{
  const bool isOpen = this->Row >= 0 || this->View.GetNumberOfWaveforms() > 0;
  if (control)
  {
    return false;
  }
  if (key == "i")
  {
    this->Toggle();
  }
  else if (key == "u")
  {
    this->ShowLine();
  }
  else if (isOpen && key == "Escape")
  {
    this->Close();
  }
  else if (this->Row >= 0 && (key == "n" || key == "Right" || key == "N" || key == "Left"))
  {
    this->StepEcho(key == "n" || key == "Right" ? 1 : -1);
  }
  else if (this->Row >= 0 && (key == "Up" || key == "Down"))
  {
    this->StepPulse(key == "Up" ? 1 : -1);
  }
  else
  {
    return false;
  }
  return true;
}

//------------------------------------------------------------------------------
bool Inspector::OnClick(int x, int y)
{
  if (this->Chart.Contains(x, y))
  {
    return true;
  }
  const auto echo = this->Owner.GetCloudView().Pick(x, y, PickPixels);
  if (echo)
  {
    this->Inspect(echo->Row);
  }
  return echo.has_value();
}

//------------------------------------------------------------------------------
void Inspector::Toggle()
{
  if (this->Row >= 0)
  {
    this->Close();
    return;
  }
  const int* size = this->Owner.GetWindow()->GetSize();
  const auto echo = this->Owner.GetCloudView().Pick(
    0.5 * size[0], 0.5 * size[1], 0.25 * std::min(size[0], size[1]));
  echo ? this->Inspect(echo->Row)
       : this->Owner.ShowMessage("no echo is near the middle of the window");
}

//------------------------------------------------------------------------------
void Inspector::Inspect(vtkIdType row)
{
  const Echo echo = this->Owner.GetCloud().GetEcho(row);
  const bool isSamePulse = this->Row >= 0 && echo.PulseId == this->Reading.Pulse;
  this->Row = row;
  if (!isSamePulse || echo.PulseId < 0)
  {
    this->View.Clear();
    this->Reading = PulseReading();
    this->Reading.Pulse = echo.PulseId;
    this->FindEchoes(echo);
    this->RequestPulse(echo);
  }
  this->Show();
}

//------------------------------------------------------------------------------
/// Finds the echoes of the pulse in the cloud: they are consecutive.
void Inspector::FindEchoes(const Echo& echo)
{
  const Cloud& cloud = this->Owner.GetCloud();
  const auto isOf = [&](vtkIdType row)
  {
    return row >= 0 && row < cloud.GetNumberOfPoints() && echo.PulseId >= 0 &&
      cloud.GetEcho(row).PulseId == echo.PulseId;
  };
  vtkIdType first = echo.Row;
  while (isOf(first - 1))
  {
    --first;
  }
  for (vtkIdType row = first; row == echo.Row || isOf(row); ++row)
  {
    this->Reading.Echoes.push_back(MakeEcho(cloud.GetEcho(row)));
  }
}

//------------------------------------------------------------------------------
void Inspector::RequestPulse(const Echo& echo)
{
  this->Problem.clear();
  this->Record = {};
  if (echo.PulseId < 0)
  {
    this->Problem = "no waveform: the points of the cloud have no pulse numbers";
    return;
  }
  this->Record = this->Find(echo.Leg, echo.PulseId, echo.PulseId + 1, true);
}

//------------------------------------------------------------------------------
/// Returns a pending result; invalid, with a problem, if there is no source.
std::future<PulseRecord> Inspector::Find(int leg, vtkIdType first, vtkIdType last, bool hasSubRays)
{
  Simulation* run = this->Owner.GetSimulation();
  if (run && run->GetPhase() == Simulation::Phase::Failed)
  {
    this->Problem = "no waveform: the run has failed";
    return {};
  }
  if (run)
  {
    return hasSubRays ? run->Inspect(first) : run->Inspect(first, last);
  }
  const auto files = FindWaveformFiles(this->Owner.GetOptions().Inputs);
  if (files.empty())
  {
    this->Problem =
      "no waveform: no survey is running, no legNNN_fullwave.txt or .pvtt is next to\n"
      "the points, and no LAS file has waveforms; show the survey itself, or run it\n"
      "with --waveforms";
    return {};
  }
  return this->Search.Find(files, leg, first, last);
}

//------------------------------------------------------------------------------
/// Steps in cloud order: the echoes of the pulse, then the echoes of the next pulse.
void Inspector::StepEcho(int step)
{
  const vtkIdType row = this->Row + step;
  if (row >= 0 && row < this->Owner.GetCloud().GetNumberOfPoints())
  {
    this->Inspect(row);
  }
}

//------------------------------------------------------------------------------
void Inspector::StepPulse(int step)
{
  const Cloud& cloud = this->Owner.GetCloud();
  vtkIdType row = this->Row + step;
  while (row >= 0 && row < cloud.GetNumberOfPoints())
  {
    if (cloud.GetEcho(row).PulseId != this->Reading.Pulse)
    {
      this->Inspect(row);
      return;
    }
    row += step;
  }
}

//------------------------------------------------------------------------------
/// Returns the number of pulses per scan line.
vtkIdType Inspector::FindLineLength(int leg) const
{
  vtkHeliosSurvey* survey = this->Owner.GetSurvey();
  if (!survey || leg < 0 || leg >= survey->GetNumberOfLegs())
  {
    return UsualLine;
  }
  const LegData& data = survey->GetData().Legs[static_cast<std::size_t>(leg)];
  double pulses = 0.0;
  for (const ScanData& scan : data.Scans)
  {
    pulses += scan.ScanFrequency > 0.0 ? scan.PulseFrequency / scan.ScanFrequency : 0.0;
  }
  return pulses > 0.0 ? static_cast<vtkIdType>(std::ceil(pulses)) : UsualLine;
}

//------------------------------------------------------------------------------
/// Shows half a line before and after the echo; if none is selected, the line of the newest one.
void Inspector::ShowLine()
{
  const Cloud& cloud = this->Owner.GetCloud();
  const vtkIdType row = this->Row >= 0 ? this->Row : cloud.GetNumberOfPoints() - 1;
  const Echo echo = row >= 0 ? cloud.GetEcho(row) : Echo();
  if (echo.PulseId < 0)
  {
    this->Owner.ShowMessage("no waveforms: there is no echo with a pulse number yet");
    return;
  }
  const vtkIdType line = std::min(this->FindLineLength(echo.Leg), MaximumPulses);
  const vtkIdType last = this->Row >= 0 ? echo.PulseId + line / 2 : echo.PulseId + 1;
  this->LineRecord = this->Find(echo.Leg, std::max<vtkIdType>(0, last - line), last, false);
  if (!this->LineRecord.valid())
  {
    this->Owner.ShowMessage(this->Problem);
  }
}

//------------------------------------------------------------------------------
bool Inspector::OnFrame()
{
  bool isNew = this->PlaceChart();
  if (IsReady(this->Record))
  {
    this->ReceivePulse();
    isNew = true;
  }
  if (IsReady(this->LineRecord))
  {
    this->ReceiveLine();
    isNew = true;
  }
  this->View.Update();
  return isNew;
}

//------------------------------------------------------------------------------
void Inspector::ReceivePulse()
{
  PulseRecord record;
  this->Problem = Receive(this->Record, record).Message();
  if (this->Problem.empty())
  {
    const std::vector<PulseEcho> known = std::move(this->Reading.Echoes);
    SceneView* scene = this->Owner.GetSceneView();
    this->Reading = ReadPulse(record, this->Reading.Pulse, scene);
    this->Reading.Echoes = this->Reading.Echoes.empty() ? known : this->Reading.Echoes;
    this->Problem = this->Reading.Problem;
  }
  this->Show();
  if (!this->Reading.Samples.empty())
  {
    const double length = this->Reading.Ranges.back() - this->Reading.Ranges.front();
    const Status status = this->View.SetWaveforms(
      record.Waveform, std::max(0.2, WaveShare * length), 1, this->Reading.Pulse);
    if (!status.IsOk())
    {
      this->Owner.ShowMessage(status.Message());
    }
  }
}

//------------------------------------------------------------------------------
void Inspector::ReceiveLine()
{
  PulseRecord record;
  Status status = Receive(this->LineRecord, record);
  if (status.IsOk() && record.Waveform && record.Waveform->GetNumberOfRows() > 0)
  {
    const vtkIdType count = record.Waveform->GetNumberOfRows();
    const vtkIdType nth = (count + MaximumWaveforms - 1) / MaximumWaveforms;
    const Cloud& cloud = this->Owner.GetCloud();
    const Echo echo = cloud.GetEcho(this->Row >= 0 ? this->Row : cloud.GetNumberOfPoints() - 1);
    const double range = std::isnan(echo.Range) ? 100.0 : echo.Range;
    this->View.SetOrigin(this->Owner.GetOrigin());
    status = this->View.SetWaveforms(
      record.Waveform, std::max(0.5, LineShare * range), static_cast<int>(nth), -1);
    this->Owner.ShowMessage(Format("waveforms of %lld of %lld pulses of the line",
      static_cast<long long>(this->View.GetNumberOfWaveforms()), static_cast<long long>(count)));
  }
  else if (status.IsOk())
  {
    status = Status::Error("no pulse of this line has a waveform");
  }
  if (!status.IsOk())
  {
    this->Owner.ShowMessage(status.Message());
  }
}

//------------------------------------------------------------------------------
void Inspector::Show()
{
  const Echo echo = this->Owner.GetCloud().GetEcho(this->Row);
  this->View.SetOrigin(this->Owner.GetOrigin());
  this->View.SetMark(echo.Position);
  this->View.SetBeams(this->Reading);
  this->PlaceChart();
  this->Chart.Show(this->Reading, echo.ReturnNumber, this->DescribeEcho());
  this->Owner.Redraw();
}

//------------------------------------------------------------------------------
/// Places the chart; true: it is drawn elsewhere than before, or in other colours.
bool Inspector::PlaceChart()
{
  Hud& hud = this->Owner.GetHud();
  const int* size = this->Owner.GetWindow()->GetSize();
  hud.SetSize(PanelId::Chart,
    this->Chart.IsVisible() ? PanelSize{ size[0] / 2, 46 * size[1] / 100 } : PanelSize());
  return this->Chart.Place(hud.GetRect(PanelId::Chart), hud.GetTheme(), hud.GetTextSize());
}

//------------------------------------------------------------------------------
void Inspector::Close()
{
  this->Row = -1;
  this->Reading = PulseReading();
  this->Problem.clear();
  this->Record = {};
  this->LineRecord = {};
  this->View.Clear();
  this->Chart.Hide();
  this->Owner.Redraw();
}

//------------------------------------------------------------------------------
void Inspector::OnNewSurvey()
{
  this->Close();
}

} // namespace helios::viewer
