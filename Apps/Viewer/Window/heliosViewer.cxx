// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
#include "heliosViewer.h"

#include "heliosBeamFan.h"
#include "heliosCloudView.h"
#include "heliosColorNames.h"
#include "heliosHud.h"
#include "heliosInteractorStyles.h"
#include "heliosLights.h"
#include "heliosPlatformView.h"
#include "heliosSceneMover.h"
#include "heliosSceneView.h"
#include "heliosSimulation.h"
#include "heliosStatus.h"
#include "heliosSurveyData.h"
#include "heliosTheme.h"
#include "heliosTimeBar.h"
#include "heliosViewerInputs.h"
#include "heliosViewerKeys.h"
#include "heliosViewerState.h"
#include "heliosViewerTool.h"
#include "vtkHeliosSurvey.h"

#include <vtkCallbackCommand.h>
#include <vtkCamera.h>
#include <vtkCommand.h>
#include <vtkPolyData.h>
#include <vtkRenderWindow.h>
#include <vtkRenderWindowInteractor.h>
#include <vtkRenderer.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <iostream>
#include <limits>
#include <thread>

namespace helios::viewer
{

namespace
{

constexpr int TimerMilliseconds = 15;
constexpr double MessageSeconds = 6.0; // duration of a message
constexpr std::size_t FanBeams = 90;
constexpr double FanSeconds = 0.02; // time of beams, if the scan has no lines

double GetSeconds()
{
  return std::chrono::duration<double>(std::chrono::steady_clock::now().time_since_epoch()).count();
}

} // namespace

//------------------------------------------------------------------------------
Viewer::Viewer(const ViewerOptions& options)
  : Options(options)
  , Camera(this->Renderer)
  , Points(std::make_unique<Cloud>())
{
  this->Clock.SetPlaying(!options.Paused);
  this->Clock.SetSpeed(options.FullSpeed ? PlayClock::AsFastAsItComputes : options.Speed);
}

//------------------------------------------------------------------------------
Viewer::~Viewer()
{
  this->Tools.clear();
}

//------------------------------------------------------------------------------
double Viewer::Now() const
{
  return GetSeconds();
}

//------------------------------------------------------------------------------
int Viewer::Run()
{
  this->SetUpWindow();
  this->SetUpView();
  if (!this->LoadInputs())
  {
    return 1;
  }
  const bool isScripted = this->Options.Offscreen || !this->Options.Record.empty();
  return isScripted ? this->RunScripted() : this->RunInteractively();
}

//------------------------------------------------------------------------------
void Viewer::SetUpWindow()
{
  this->Window->SetSize(this->Options.Width, this->Options.Height);
  this->Window->SetWindowName("vtkHelios");
  this->Window->SetMultiSamples(0);
  this->Window->AddRenderer(this->Renderer);
  this->Window->SetOffScreenRendering(this->Options.Offscreen);
  this->Renderer->GradientBackgroundOn();
  AddLights(this->Renderer);
  if (!this->Options.Offscreen)
  {
    this->Interactor = vtkSmartPointer<vtkRenderWindowInteractor>::New();
    this->Interactor->SetRenderWindow(this->Window);
    this->SetUpEvents();
  }
}

//------------------------------------------------------------------------------
void Viewer::SetUpView()
{
  this->PointsView = std::make_unique<CloudView>(*this->Points, this->Renderer);
  this->Words = std::make_unique<Hud>(this->Renderer);
  this->Words->Resize(this->Options.Width, this->Options.Height);
  this->Words->SetVisible(this->Options.Words);
  this->Words->SetInteractive(!this->Options.Offscreen);
  this->SetTheme(this->Options.Theme);
  this->PointsView->SetPointSize(this->Options.PointSize);
  this->PointsView->SetEyeDomeLighting(this->Options.EyeDome);
  for (const auto& coloring : GetColorings())
  {
    if (coloring.first == this->Options.ColorBy)
    {
      this->PointsView->SetColorBy(coloring.second);
    }
  }
  if (this->Interactor)
  {
    this->Interactor->Initialize();
    this->Bar = std::make_unique<TimeBar>(this->Interactor,
      [this](double time)
      {
        this->Clock.Seek(time);
        this->Redraw();
      });
    this->Words->SetOnPlay([this] { this->Keys->Press("space", false); });
  }
  this->Tools = MakeTools(*this);
  this->SetUpKeys();
}

//------------------------------------------------------------------------------
/// Sets the camera from the options.
Status Viewer::SetUpCamera()
{
  const auto& names = GetCameraModeNames();
  const auto mode = std::find(names.begin(), names.end(), this->Options.Camera) - names.begin();
  this->SetCameraMode(static_cast<CameraMode>(mode));
  if (this->Options.CameraScript.empty())
  {
    return {};
  }
  this->SetCameraMode(CameraMode::Script);
  return this->Camera.ReadScript(this->Options.CameraScript);
}

//------------------------------------------------------------------------------
bool Viewer::LoadInputs()
{
  Status status = this->SetUpCamera();
  status = status.IsOk() ? ShowInputs(*this) : status;
  if (!status.IsOk())
  {
    std::cerr << "error: " << status.Message() << "\n";
  }
  return status.IsOk();
}

//------------------------------------------------------------------------------
bool Viewer::IsComputing() const
{
  return this->Running && this->Running->GetPhase() == Simulation::Phase::Running &&
    this->Clock.GetTarget() > this->Running->GetCollectedTime();
}

//------------------------------------------------------------------------------
void Viewer::SetCameraMode(CameraMode mode)
{
  this->Camera.SetMode(mode);
  if (this->Interactor)
  {
    UseStyle(this->Interactor, mode == CameraMode::Fly);
  }
  this->Redraw();
}

//------------------------------------------------------------------------------
void Viewer::SetTheme(const std::string& name)
{
  const Theme& theme = FindTheme(name);
  this->Renderer->SetBackground(Shade(theme.Background[0]).Rgb);
  this->Renderer->SetBackground2(Shade(theme.Background[1]).Rgb);
  this->Words->SetTheme(theme);
  this->CoverMesh();
  this->PointsView->SetRampPart(theme.Ramp);
  this->Redraw();
}

//------------------------------------------------------------------------------
int Viewer::RunInteractively()
{
  this->UpdateStatus();
  this->Draw();
  this->Interactor->CreateRepeatingTimer(TimerMilliseconds);
  this->LastFrame = this->Now();
  this->Interactor->Start();
  this->Bar.reset();
  const Status status = this->Video.Close();
  if (!status.IsOk())
  {
    this->ShowError(status.Message());
  }
  return this->ExitCode;
}

//------------------------------------------------------------------------------
void Viewer::OnTimer()
{
  const double now = this->Now();
  const double seconds = now - this->LastFrame;
  this->LastFrame = now;
  this->HandleClick();
  this->Frame(seconds);
  this->UpdateCursor(now);
  const bool isSketched = this->Budget.IsBusy(now) || this->IsComputing();
  if (isSketched != this->IsSketched)
  {
    this->IsSketched = isSketched;
    this->PointsView->SetInteracting(isSketched);
    this->Redraw();
  }
  if (this->IsDirty && this->Budget.IsDue(now, this->IsComputing()))
  {
    this->Draw();
  }
  this->AddVideoFrame(now);
  if (this->IsClosing)
  {
    this->Interactor->TerminateApp();
  }
}

//------------------------------------------------------------------------------
/// Does everything between two frames.
void Viewer::Frame(double seconds)
{
  const double before = this->Clock.GetTime();
  if (this->Running)
  {
    this->FinishLoading();
    this->ReceiveResults();
    this->Clock.Advance(seconds, this->Running->GetCollectedTime());
    this->Running->SetTarget(this->Clock.GetTarget());
  }
  else
  {
    this->Clock.Advance(seconds, this->Clock.GetEnd());
  }
  if (this->Clock.GetTime() != before)
  {
    this->Redraw();
  }
  if (this->Mover && this->Mover->MoveTo(this->Legs, this->Clock.GetTime()))
  {
    this->Redraw();
  }
  this->PlacePlatform(seconds);
  for (auto& tool : this->Tools)
  {
    this->IsDirty = tool->OnFrame() || this->IsDirty;
  }
  this->UpdateStatus();
  this->PlacePanels();
}

//------------------------------------------------------------------------------
void Viewer::ReceiveResults()
{
  const auto blocks = this->Running->CollectEchoes();
  for (const auto& block : blocks)
  {
    this->Points->Append(block);
  }
  if (!blocks.empty())
  {
    this->HasNewPoints = true; // shown in the next frame
    this->Redraw();
  }
}

//------------------------------------------------------------------------------
void Viewer::PlacePlatform(double seconds)
{
  const double time = this->Clock.GetTime();
  const SimulatedLeg* leg = this->Platform ? FindLeg(this->Legs, time) : nullptr;
  if (!leg)
  {
    this->Camera.Update(seconds, nullptr);
    return;
  }
  const Pose platform = leg->GetPose(time);
  const Pose scanner = platform * leg->Mount;
  const double line =
    leg->LineFrequency > 0.0 ? std::min(1.0 / leg->LineFrequency, 0.2) : FanSeconds;
  this->LastEnds = FindNewestPoints(*this->Points, time, line, FanBeams);
  this->Platform->SetFan(scanner.Position, this->LastEnds);
  CameraRig::Subject subject;
  subject.Platform = { platform.Position - this->Origin, platform.Orientation };
  subject.Scanner = { scanner.Position - this->Origin, scanner.Orientation };
  subject.HasTarget = !this->LastEnds.empty();
  for (const Vec3& end : this->LastEnds)
  {
    subject.Target = subject.Target + (1.0 / double(this->LastEnds.size())) * (end - this->Origin);
  }
  this->Camera.Update(this->Clock.IsPlaying() ? seconds : 0.0, &subject);
  this->Platform->Place(*leg, platform, time);
  this->Platform->SetModelVisible(this->Camera.GetMode() != CameraMode::Scanner);
}

//------------------------------------------------------------------------------
/// Adds the points received since the last frame, up to the shown time.
void Viewer::AddReceivedPoints()
{
  if (this->HasNewPoints)
  {
    this->HasNewPoints = false;
    this->PointsView->Update();
  }
  const double time = this->Clock.GetTime();
  const double limit =
    time >= this->Clock.GetEnd() ? std::numeric_limits<double>::infinity() : time;
  if (limit != this->PointsView->GetTimeLimit())
  {
    this->PointsView->SetTimeLimit(limit);
  }
}

//------------------------------------------------------------------------------
void Viewer::Draw()
{
  const double start = this->Now();
  this->AddReceivedPoints();
  this->UpdateStatus(); // with the legend of these points
  this->PlacePanels();
  this->Mesh ? this->Mesh->SetInteracting(this->PointsView->IsInteracting()) : void();
  this->Renderer->ResetCameraClippingRange();
  this->Window->Render();
  const double end = this->Now();
  this->Budget.RecordFrame(end, end - start);
  this->PointsView->ReportFrame(end - start);
  this->FramesPerSecond = 1.0 / std::max(1e-3, end - start);
  ++this->NumberOfFrames;
  this->IsDirty = false;
  this->WriteState();
}

//------------------------------------------------------------------------------
void Viewer::WriteState() const
{
  const ViewerState state{ this->Window, this->Renderer, this->Origin, this->Camera, this->Clock,
    this->Video, this->Running.get(), *this->Points, *this->PointsView, this->Mesh.get(),
    this->Platform.get(), *this->Words, this->Tools, this->NumberOfFrames, this->FramesPerSecond,
    this->PulsesPerSecond, this->Message };
  state.Write(this->Options.State);
}

//------------------------------------------------------------------------------
void Viewer::ShowMessage(const std::string& message)
{
  this->Message = message;
  this->MessageUntil = this->Now() + MessageSeconds;
  this->Redraw();
}

//------------------------------------------------------------------------------
void Viewer::ShowError(const std::string& error)
{
  std::cerr << "error: " << error << "\n";
  this->ShowMessage(error);
  this->MessageUntil = std::numeric_limits<double>::infinity();
}

//------------------------------------------------------------------------------
void Viewer::Close()
{
  this->IsClosing = true;
}

} // namespace helios::viewer
