// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
// Non-interactive viewer: videos and stills.
#include "heliosStatus.h"
#include "heliosViewer.h"

#include "heliosCloudView.h"
#include "heliosHud.h"
#include "heliosSimulation.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <thread>

namespace helios::viewer
{

//------------------------------------------------------------------------------
/// Runs without interaction: every frame at its time, regardless of computing time.
int Viewer::RunScripted()
{
  const double step = 1.0 / this->Options.FramesPerSecond;
  const double seconds = this->Options.Seconds > 0.0 ? this->Options.Seconds : 10.0;
  this->WaitFor(-1.0);
  if (!this->Options.Record.empty() && this->ExitCode == 0)
  {
    if (!this->Options.HasSpeed)
    {
      const double span = this->Clock.GetEnd() - this->Clock.GetTime();
      this->Clock.SetSpeed(std::max(1e-6, span / seconds));
    }
    this->Draw();
    Status status =
      this->Video.Open(this->Window, this->Options.Record, this->Options.FramesPerSecond);
    const auto frames = static_cast<int>(std::lround(seconds / step));
    for (int i = 0; i < frames && status.IsOk() && this->ExitCode == 0; ++i)
    {
      this->WaitFor(
        std::min(this->Clock.GetEnd(), this->Clock.GetTime() + step * this->Clock.GetSpeed()));
      this->Frame(step);
      this->Draw();
      status = this->Video.AddFrame();
    }
    const Status end = this->Video.Close();
    status = status.IsOk() ? end : status;
    if (!status.IsOk())
    {
      this->ShowError(status.Message());
      this->ExitCode = 1;
    }
  }
  if (!this->Options.Still.empty() && this->ExitCode == 0)
  {
    const double time =
      this->Options.StartTime >= 0.0 ? this->Options.StartTime : this->Clock.GetEnd();
    this->Clock.Seek(time);
    this->WaitFor(time);
    this->Frame(0.0);
    this->AddReceivedPoints();
    this->PointsView->SetAutomaticRange(); // range of the full cloud
    this->UpdateStatus();                  // the legend
    this->SaveStill(this->Options.Still);
  }
  return this->ExitCode;
}

//------------------------------------------------------------------------------
/// Waits for the measurements up to a time, or the end of the run.
void Viewer::WaitFor(double time)
{
  const auto isThere = [this, time]
  {
    const Simulation::Phase phase = this->Running->GetPhase();
    return phase == Simulation::Phase::Failed ||
      (phase != Simulation::Phase::Loading && !this->IsLoading &&
        (time < 0.0 || this->Running->HasCollected(time)));
  };
  while (this->Running && !isThere())
  {
    this->FinishLoading();
    this->ReceiveResults();
    this->Running->SetTarget(time);
    std::this_thread::sleep_for(std::chrono::milliseconds(2));
  }
  if (this->Running)
  {
    this->FinishLoading();
  }
}

//------------------------------------------------------------------------------
void Viewer::AddVideoFrame(double now)
{
  if (!this->Video.IsOpen() || now - this->LastVideoFrame < 1.0 / this->Options.FramesPerSecond)
  {
    return;
  }
  this->LastVideoFrame = now;
  const Status status = this->Video.AddFrame();
  if (!status.IsOk())
  {
    static_cast<void>(this->Video.Close()); // the first error is told
    this->ShowError(status.Message());
  }
}

//------------------------------------------------------------------------------
void Viewer::SaveStill(const std::string& fileName)
{
  this->Words->SetStill(true);
  this->Draw();
  const Status status = WriteStill(this->Window, fileName);
  this->Words->SetStill(false);
  if (status.IsOk())
  {
    this->ShowMessage("saved " + fileName);
    return;
  }
  this->ShowError(status.Message());
  this->ExitCode = 1;
}

//------------------------------------------------------------------------------
void Viewer::ToggleRecording()
{
  const bool wasOpen = this->Video.IsOpen();
  const std::string name = "vtkhelios.ogv";
  const Status status = wasOpen
    ? this->Video.Close()
    : this->Video.Open(this->Window, name, this->Options.FramesPerSecond);
  status.IsOk() ? this->ShowMessage((wasOpen ? "saved " : "recording ") + name)
                : this->ShowError(status.Message());
}

} // namespace helios::viewer
