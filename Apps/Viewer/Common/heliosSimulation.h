// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
// Runs a survey in its own thread, up to the time the viewer requests.

#ifndef heliosSimulation_h
#define heliosSimulation_h

#include "heliosPlatformKind.h"
#include "heliosPose.h"
#include "heliosPulseClock.h"
#include "heliosShapePath.h"
#include "heliosSurveyData.h"
#include "heliosTrajectory.h"
#include "vtkHeliosSurvey.h"
#include "vtkHeliosSurveySource.h"

#include <vtkImageData.h>
#include <vtkNew.h>
#include <vtkPolyData.h>
#include <vtkSmartPointer.h>
#include <vtkTable.h>
#include <vtkType.h>

#include <condition_variable>
#include <deque>
#include <future>
#include <mutex>
#include <string>
#include <thread>
#include <vector>

namespace helios::viewer
{

/// A leg that emits pulses, and its platform trajectory.
struct SimulatedLeg
{
  int Leg = 0;
  double StartTime = 0.0; ///< [s]
  double EndTime = 0.0;   ///< [s]
  vtkIdType FirstPulse = 0;
  vtkIdType LastPulse = 0; ///< past the end
  Pose Mount;              ///< pose of the scanner on its platform
  Trajectory Path;
  std::vector<Vec3> Positions; ///< positions of its samples
  bool IsMoving = false;
  PlatformType Type = PlatformType::Static;
  PlatformKind Kind = PlatformKind::Unknown; ///< for its model
  double Height = 0.0; ///< height of a trajectory above the ground that its platform is on [m]
  double LineFrequency = 0.0; ///< lines of the scan per second [Hz]; 0: unknown
  PulseClock Clock;           ///< clock of one channel
  ModelData Model;            ///< model of the platform
  ModelData ScannerModel;
  Vec3 HeadAxis{ 0.0, 0.0, 1.0 };
  double HeadStart = 0.0; ///< [deg]
  double HeadSpeed = 0.0; ///< [deg/s]

  /// Sets the trajectory: a polyline with GpsTime and Orientation. False if it has no samples, or
  /// bad ones.
  bool SetTrajectory(vtkPolyData* trajectory);

  /// Platform pose [s]: clamped to the start and end of the leg.
  Pose GetPose(double time) const { return this->Path.GetPose(time); }

  /// Returns the pose of the scanner head on the platform at a time [s]: its mount, rotated.
  Pose GetHead(double time) const;
};

/// Sets the kinds of platforms that are not known, and the heights of those on the ground, by points
/// of the scene or cloud.
void FindPlatforms(std::vector<SimulatedLeg>& legs, const std::vector<Vec3>& points);

/// Returns the leg at a time [s], the last one started; null before the first.
const SimulatedLeg* FindLeg(const std::vector<SimulatedLeg>& legs, double time);

/// All data of a pulse.
struct PulseRecord
{
  vtkSmartPointer<vtkPolyData> Echoes;
  vtkSmartPointer<vtkTable> Waveform;
  vtkSmartPointer<vtkPolyData> Pulse;
  vtkSmartPointer<vtkPolyData> SubRays;
};

/// Blocks of echoes wait in a short queue, so that memory stays bounded if nobody takes them.
class Simulation
{
public:
  enum class Phase
  {
    Loading,
    Running, ///< or waiting for a later target
    Finished,
    Failed
  };

  explicit Simulation(vtkHeliosSurvey* survey);
  ~Simulation(); ///< ends the thread
  Simulation(const Simulation&) = delete;
  void operator=(const Simulation&) = delete;

  /// Settings of the run, before Start().
  vtkHeliosSurveySource* GetSource() const { return this->Source; }

  void Start();

  Phase GetPhase() const;

  /// Returns the error; empty without one.
  std::string GetMessage() const;

  /// @{
  /// Returns results of loading, known once it has ended; null if it failed.
  vtkPolyData* GetScene() const { return this->Scene; }
  const std::vector<vtkSmartPointer<vtkImageData>>& GetGrids() const { return this->Grids; }
  const SceneFrames& GetFrames() const { return this->Frames; }
  void GetBounds(double bounds[6]) const; ///< bounds of both [m]
  const std::vector<SimulatedLeg>& GetLegs() const { return this->Legs; }
  double GetStartTime() const;
  double GetEndTime() const;
  vtkIdType GetNumberOfPulses() const { return this->NumberOfPulses; }
  ///@}

  /// Runs up to a time [s]; infinity: to the end. Never backwards.
  void SetTarget(double time);

  /// Returns the echoes of the blocks run since the last call.
  std::vector<vtkSmartPointer<vtkPolyData>> CollectEchoes();

  /// Returns the time up to which all echoes have been collected [s], and the pulses up to it.
  double GetCollectedTime() const;
  vtkIdType GetCollectedPulses() const;

  /// Returns whether the echoes of all pulses before a time have been collected; once it is loaded.
  bool HasCollected(double time) const;

  /// Returns the wall time spent on computing blocks [s].
  double GetComputingSeconds() const;

  /// Runs one pulse again, between two blocks, with all its data.
  std::future<PulseRecord> Inspect(vtkIdType pulse);

  /// Runs the pulses [first, last) again, without sub-rays.
  std::future<PulseRecord> Inspect(vtkIdType first, vtkIdType last);

private:
  struct Block
  {
    vtkSmartPointer<vtkPolyData> Echoes;
    double EndTime;
    vtkIdType EndPulse;
  };
  struct Request
  {
    vtkIdType First;
    vtkIdType Last; ///< past the end
    bool HasSubRays;
    std::promise<PulseRecord> Record;
  };

  std::future<PulseRecord> Submit(Request request);
  void Work();
  bool Load();
  void ReadLegs();
  bool HasWork() const;
  bool RunBlock();
  bool RunRequests();

  vtkSmartPointer<vtkHeliosSurvey> Survey;
  vtkNew<vtkHeliosSurveySource> Source;
  vtkSmartPointer<vtkPolyData> Scene;
  std::vector<vtkSmartPointer<vtkImageData>> Grids; // turbid voxels
  SceneFrames Frames;                               // frames of the parts that deform
  std::vector<SimulatedLeg> Legs;
  vtkIdType NumberOfPulses = 0;
  std::thread Thread;

  // Members that only the thread uses.
  vtkIdType NextPulse = 0;
  vtkIdType PulsesPerBlock;

  // Shared, under the mutex.
  mutable std::mutex Mutex;
  std::condition_variable Wake;
  Phase State = Phase::Loading;
  std::string Message;
  bool IsEnding = false;
  double Target;
  std::deque<Block> Blocks;
  std::deque<Request> Requests;
  double CollectedTime = 0.0;
  vtkIdType CollectedPulses = 0;
  double ComputingSeconds = 0.0;
};

} // namespace helios::viewer

#endif
