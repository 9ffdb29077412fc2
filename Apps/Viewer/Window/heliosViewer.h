// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
// The viewer: one window on a running survey, a finished cloud, or a scene.

#ifndef heliosViewer_h
#define heliosViewer_h

#include "heliosCameraRig.h"
#include "heliosCloud.h"
#include "heliosFrameBudget.h"
#include "heliosLegend.h"
#include "heliosPlayClock.h"
#include "heliosPose.h"
#include "heliosRecorder.h"
#include "heliosSimulation.h"
#include "heliosStatus.h"
#include "heliosViewerOptions.h"
#include "vtkHeliosSurvey.h"

#include <vtkCallbackCommand.h>
#include <vtkNew.h>
#include <vtkRenderWindow.h>
#include <vtkRenderWindowInteractor.h>
#include <vtkRenderer.h>
#include <vtkSmartPointer.h>

#include <memory>
#include <string>
#include <vector>

class vtkImageData;
class vtkPolyData;

namespace helios::viewer
{

class CloudView;
class Hud;
class PlatformView;
class SceneMover;
class SceneView;
class TimeBar;
class ViewerKeys;
class ViewerTool;

class Viewer
{
public:
  explicit Viewer(const ViewerOptions& options);
  ~Viewer();
  Viewer(const Viewer&) = delete;
  void operator=(const Viewer&) = delete;

  /// Shows the inputs until the user closes the window or the recording ends; returns an exit code.
  int Run();

  /// @{
  /// Returns the state for tools and keys.
  const ViewerOptions& GetOptions() const { return this->Options; }
  vtkRenderer* GetRenderer() const { return this->Renderer; }
  vtkRenderWindow* GetWindow() const { return this->Window; }
  vtkRenderWindowInteractor* GetInteractor() const { return this->Interactor; }
  const Vec3& GetOrigin() const { return this->Origin; } ///< origin of everything drawn [m]
  Cloud& GetCloud() { return *this->Points; }
  CloudView& GetCloudView() { return *this->PointsView; }
  SceneView* GetSceneView() { return this->Mesh.get(); } ///< null: no scene (yet)
  PlatformView* GetPlatformView() { return this->Platform.get(); }
  Simulation* GetSimulation() { return this->Running.get(); } ///< null: not running
  vtkHeliosSurvey* GetSurvey() const { return this->Survey; }
  const std::vector<SimulatedLeg>& GetLegs() const { return this->Legs; }
  CameraRig& GetCamera() { return this->Camera; }
  PlayClock& GetClock() { return this->Clock; }
  Hud& GetHud() { return *this->Words; }
  ///@}

  /// Replaces the shown survey with another one, and runs it. keepCamera: keeps the camera.
  void ShowSurvey(vtkHeliosSurvey* survey, bool keepCamera = false);

  /// Shows a scene and its turbid voxels without a survey [m]. The first view also has what is drawn
  /// over it, such as flight lines.
  void ShowScene(vtkPolyData* scene, const std::vector<vtkSmartPointer<vtkImageData>>& grids = {},
    vtkPolyData* above = nullptr);

  /// Shows a message for a while; errors also on standard error.
  void ShowMessage(const std::string& message);
  void ShowError(const std::string& error);

  /// Requests a new frame.
  void Redraw() { this->IsDirty = true; }

  /// Shows the cloud and its trajectories, relative to the cloud's origin.
  void ShowCloud(const std::vector<SimulatedLeg>& legs);

  /// Sets the colours, by the name of a theme.
  void SetTheme(const std::string& name);

  /// Shows all data.
  void ResetCamera();

  ///@{
  /// Opens the dialog of files: for other inputs, for the edited survey, for a PNG.
  void OpenInputDialog();
  void OpenSurveyDialog();
  void OpenStillDialog();
  ///@}

  /// Shows other inputs.
  Status OpenInput(const std::string& path);

  /// Makes the menus anew, after those of a tool have changed.
  void UpdateMenus();

  /// Returns whether a tool waits for clicks.
  bool IsToolOn(const std::string& name) const;

  /// Sets the camera mode and its interaction style.
  void SetCameraMode(CameraMode mode);

  /// Writes a PNG of the view.
  void SaveStill(const std::string& fileName);

  /// Starts or stops the recording.
  void ToggleRecording();

  void Close();

private:
  Status SetUpCamera();
  bool LoadInputs();
  void SetUpWindow();
  void SetUpEvents();
  void SetUpView();
  void SetUpKeys();
  void Begin(const double bounds[6], vtkPolyData* scene, bool keepCamera);
  void ShowMesh(vtkPolyData* scene);
  void CoverMesh();
  void ShowTrajectories();
  void ShowBox(const double bounds[6], bool hasData, vtkPolyData* scene);
  void SetSpan(double start, double end);
  int RunInteractively();
  int RunScripted();
  void Frame(double seconds);
  void ReceiveResults();
  void AddReceivedPoints();
  void FinishLoading();
  void PlacePlatform(double seconds);
  void UpdateStatus();
  Legend FindLegend() const;
  void CountRates();
  bool IsFinished() const;
  void PlacePanels();
  void UpdateCursor(double now);
  std::string DescribeTime() const;
  std::string DescribeCloud() const;
  std::string DescribeLegs() const;
  void Draw();
  void WriteState() const;
  void WaitFor(double time);
  bool IsComputing() const;
  void AddVideoFrame(double now);
  double Now() const;

  static void OnEvent(vtkObject*, unsigned long event, void* self, void*);
  void OnKey();
  static void OnReleaseEvent(vtkObject*, unsigned long event, void* self, void*);
  bool OnPress();
  void OnRelease();
  void HandleClick();
  void OnTimer();
  void OnResize();
  bool OnWheel(int rows);

  ViewerOptions Options;
  vtkNew<vtkRenderer> Renderer;
  vtkNew<vtkRenderWindow> Window;
  vtkSmartPointer<vtkRenderWindowInteractor> Interactor;
  vtkNew<vtkCallbackCommand> Observer;
  vtkNew<vtkCallbackCommand> Releases; // observes those captured by a drag
  CameraRig Camera;
  PlayClock Clock;
  FrameBudget Budget;
  Recorder Video;
  Vec3 Origin{ 0.0, 0.0, 0.0 };

  vtkSmartPointer<vtkHeliosSurvey> Survey;
  std::unique_ptr<Simulation> Running;
  std::vector<SimulatedLeg> Legs;
  std::unique_ptr<Cloud> Points;
  std::unique_ptr<CloudView> PointsView;
  std::unique_ptr<SceneView> Mesh;
  std::unique_ptr<SceneMover> Mover; // moves the mesh's parts; null: no survey
  std::unique_ptr<PlatformView> Platform;
  std::unique_ptr<Hud> Words;
  std::unique_ptr<TimeBar> Bar;
  std::unique_ptr<ViewerKeys> Keys;
  std::vector<std::unique_ptr<ViewerTool>> Tools;
  std::vector<Vec3> LastEnds; // ends of the newest beams

  bool IsLoading = false;
  bool HasFailed = false;
  bool HasNewPoints = false;
  bool IsSketched = false; // a sample of the points, to save time
  bool KeepsCamera = false;
  bool IsDirty = true;
  bool IsClosing = false;
  bool IsDragging = false;
  int ExitCode = 0;
  int PressedAt[2] = { 0, 0 };
  bool IsPressOnPanel = false;
  double MovedAt = 0.0;  // last motion of the mouse
  bool HasMoved = false; // since the coordinates were shown
  bool HasClick = false; // not yet passed to the tools
  int ClickAt[2] = { 0, 0 };
  int ClickKeys[2] = { 0, 0 }; // shift, control
  int Size[2] = { 0, 0 };
  double LastFrame = 0.0;
  double LastVideoFrame = 0.0;
  double FramesPerSecond = 0.0;
  vtkIdType NumberOfFrames = 0;
  double RateSince = 0.0; // start of the counts per second
  vtkIdType RatePulses = 0;
  vtkIdType RatePoints = 0;
  double PulsesPerSecond = 0.0;
  double PointsPerSecond = 0.0;
  std::string ShownText; // in the last frame
  std::string Message;
  double MessageUntil = 0.0;
};

} // namespace helios::viewer

#endif
