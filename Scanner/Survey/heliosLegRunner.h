// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
// Runs the legs of a survey, block by block, into files.

#ifndef heliosLegRunner_h
#define heliosLegRunner_h

#include "heliosLegPlan.h"
#include "heliosLegScanner.h"
#include "heliosSurveyData.h"

#include <vtkSmartPointer.h>

#include <functional>
#include <string>
#include <vector>

class vtkHeliosStreamWriter;
class vtkPolyData;

namespace helios
{

class Messages;

/// How a survey is run.
struct RunSettings
{
  std::string Folder; ///< of the files
  std::string Format; ///< xyz, vtp
  ScanOptions Scan;
  vtkIdType PulsesPerBlock = 262144;
};

/// What a run has done so far.
struct RunCounts
{
  vtkIdType Pulses = 0; ///< of the legs' pulse times
  vtkIdType Echoes = 0;
  vtkIdType FirstReturns = 0;
  vtkIdType PulsesFired = 0;
  vtkIdType PulsesHit = 0;         ///< a surface in the ranges that are measured
  vtkIdType PulsesOnPlane = 0;     ///< their beam met one plane: in closed form
  vtkIdType PulsesWithoutBins = 0; ///< their maxima were found without bins
  vtkIdType PulsesBinned = 0;
  vtkIdType SubRays = 0;         ///< traced
  vtkIdType HitsOutOfRange = 0;  ///< of sub-rays
  double LargestAmplitude = 0.0; ///< [W], detected or not
};

/// Called after every block; false ends the run.
using BlockCallback = std::function<bool(const RunCounts&)>;

class LegRunner
{
public:
  LegRunner(
    const SurveyData& survey, vtkPolyData* scene, const RunSettings& settings, Messages& log);
  ~LegRunner();

  /// Plans the legs and counts their pulses; false after an error.
  bool Plan();

  const std::vector<LegPlan>& GetPlans() const { return this->Plans; }
  vtkIdType GetNumberOfPulses() const { return this->NumberOfPulses; }
  const RunCounts& GetCounts() const { return this->Counts; }

  /// Runs one leg and writes its files; false after an error or where the callback ends it. What is
  /// written then is valid and called .part.
  bool Run(const LegPlan& plan, const BlockCallback& onBlock);

  /// What sub-rays and bins the settings come to, in words.
  std::string DescribeSampling();

  /// Why a run has no echo, and what to do about it.
  std::string ExplainNoEchoes() const;

  /// The names of all files that a leg can have: a regular expression.
  static const char* GetFilePattern();

private:
  using Writers = std::vector<vtkSmartPointer<vtkHeliosStreamWriter>>;

  Writers OpenWriters(const LegPlan& plan);
  void Open(vtkHeliosStreamWriter* writer, const LegPlan& plan, const char* ending);
  bool WriteTrajectory(const LegPlan& plan);
  bool RunBlocks(const LegPlan& plan, const Writers& writers, const BlockCallback& onBlock);

  const SurveyData& Survey;
  RunSettings Settings;
  Messages& Log;
  vtkSmartPointer<vtkPolyData> Scene;
  LegScanner Scanner;
  std::vector<LegPlan> Plans;
  vtkIdType NumberOfPulses = 0;
  RunCounts Counts;
};

} // namespace helios

#endif
