// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
// A survey that runs in a thread of its own, up to the time that the viewer asks for.

#ifndef heliosSimulation_h
#define heliosSimulation_h

#include "heliosMovingScene.h"
#include "heliosPose.h"
#include "heliosSurveyData.h"
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

namespace helios
{

/// A leg that fires pulses, and the way of its platform.
struct SimulatedLeg
{
  int Leg = 0;
  double StartTime = 0.0; ///< [s]
  double EndTime = 0.0;   ///< [s]
  vtkIdType FirstPulse = 0;
  vtkIdType LastPulse = 0; ///< one behind
  Pose Mount;              ///< of the scanner on its platform
  std::vector<double> Times;
  std::vector<Pose> Poses;
  bool IsMoving = false;
  PlatformType Type = PlatformType::Static;
  double LineFrequency = 0.0; ///< of the scan [Hz]; 0: not known
  PulseClock Clock;           ///< of one channel
  ModelData Model;            ///< of the platform
  ModelData ScannerModel;
  Vec3 HeadAxis{ 0.0, 0.0, 1.0 };
  double HeadStart = 0.0; ///< [deg]
  double HeadSpeed = 0.0; ///< [deg/s]

  /// Where the platform is [s]: before and after the leg where it starts and ends.
  Pose GetPose(double time) const;

  /// How the head of the scanner is on the platform [s]: its mount, turned.
  Pose GetHead(double time) const;
};

/// The leg of a time [s], the last one that has begun; null where there is none.
const SimulatedLeg* FindLeg(const std::vector<SimulatedLeg>& legs, double time);

/// Takes the samples of a way, a polyline with GpsTime and Orientation.
void SetWay(vtkPolyData* way, SimulatedLeg& leg);

/// All that a pulse left behind.
struct PulseRecord
{
  vtkSmartPointer<vtkPolyData> Echoes;
  vtkSmartPointer<vtkTable> Waveform;
  vtkSmartPointer<vtkPolyData> Pulse;
  vtkSmartPointer<vtkPolyData> SubRays;
};

/// Blocks of echoes wait in a short queue, so that memory does not grow where nobody takes them.
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
  ~Simulation(); ///< ends the thread soon
  Simulation(const Simulation&) = delete;
  void operator=(const Simulation&) = delete;

  /// What the run is to be like, before Start().
  vtkHeliosSurveySource* GetSource() const { return this->Source; }

  void Start();

  Phase GetPhase() const;

  /// What went wrong; empty where nothing did.
  std::string GetMessage() const;

  ///@{
  /// What is known when it is no longer loading; nothing, where that failed.
  vtkPolyData* GetScene() const { return this->Scene; }
  const std::vector<vtkSmartPointer<vtkImageData>>& GetGrids() const { return this->Grids; }
  void GetBounds(double bounds[6]) const; ///< of both [m]
  const std::vector<SimulatedLeg>& GetLegs() const { return this->Legs; }
  double GetStartTime() const;
  double GetEndTime() const;
  vtkIdType GetNumberOfPulses() const { return this->NumberOfPulses; }
  ///@}

  /// Runs up to a time [s]; infinity: to the end. Never goes back.
  void SetTarget(double time);

  /// The echoes of the blocks that were run since the last call.
  std::vector<vtkSmartPointer<vtkPolyData>> TakeEchoes();

  /// The time up to which all echoes have been taken [s], and the pulses until then.
  double GetTakenTime() const;
  vtkIdType GetTakenPulses() const;

  /// How long it has computed blocks [s], of wall time.
  double GetComputingSeconds() const;

  /// Runs one pulse again, between two blocks, with all that it leaves behind.
  std::future<PulseRecord> Inspect(vtkIdType pulse);

  /// Runs the pulses [first, last) again, likewise, but without their sub-rays.
  std::future<PulseRecord> Inspect(vtkIdType first, vtkIdType last);

private:
  struct Block
  {
    vtkSmartPointer<vtkPolyData> Echoes;
    double EndTime;
    vtkIdType EndPulse;
  };
  struct Question
  {
    vtkIdType First;
    vtkIdType Last; ///< one behind
    bool HasSubRays;
    std::promise<PulseRecord> Answer;
  };

  std::future<PulseRecord> Ask(Question question);
  void Work();
  bool Load();
  void ReadLegs();
  bool HasWork() const;
  bool RunBlock();
  bool Answer();

  vtkSmartPointer<vtkHeliosSurvey> Survey;
  vtkNew<vtkHeliosSurveySource> Source;
  vtkSmartPointer<vtkPolyData> Scene;
  std::vector<vtkSmartPointer<vtkImageData>> Grids; // turbid voxels
  std::vector<SimulatedLeg> Legs;
  vtkIdType NumberOfPulses = 0;
  std::thread Thread;

  // Of the thread alone.
  vtkIdType NextPulse = 0;
  vtkIdType PulsesPerBlock;

  // Of both, under the mutex.
  mutable std::mutex Mutex;
  std::condition_variable Wake;
  Phase State = Phase::Loading;
  std::string Message;
  bool IsEnding = false;
  double Target;
  std::deque<Block> Blocks;
  std::deque<Question> Questions;
  double TakenTime = 0.0;
  vtkIdType TakenPulses = 0;
  double ComputingSeconds = 0.0;
};

} // namespace helios

#endif
