// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
// The options of a run: what a survey leaves open, or what overrides it.

#ifndef heliosRunOptions_h
#define heliosRunOptions_h

#include "heliosStatus.h"

#include <vtkType.h>

#include <string>
#include <vector>

namespace Json
{
class Value;
}

namespace helios
{

/// The valid names of an echo detector; the first is the default.
std::vector<std::string> GetEchoDetectorNames();

/// The parts of the model that a run can leave out.
std::vector<std::string> GetModelPartNames();

/// The patterns of fixed sub-rays.
std::vector<std::string> GetSubRayPatternNames();

/// Set by vtkHeliosRunOptions, which documents them. 0 and empty: as in the survey.
struct RunOptions
{
  int Epoch = 0;
  vtkIdType Seed = -1; ///< negative: as in the survey, else 0
  bool Noise = true;
  double RangeTolerance = 0.0;  ///< [m]
  double EnergyTolerance = 0.0; ///< relative
  int NumberOfSubRays = 0;      ///< fixed
  int MaximumSubRays = 0;       ///< of adaptive sampling, of a beam; 0: the default of the scanner
  std::string SubRayPattern;    ///< of the fixed ones
  double BinSize = 0.0;         ///< [ns]
  std::string EchoDetector;
  std::string RayCaster;
  std::string Weather;        ///< see ParseWeather()
  std::string GpsStart;       ///< see vtkHeliosGpsTime::Parse()
  std::string Without;        ///< names of parts of the model, separated by blanks
  vtkIdType PulseStep = 1;    ///< a sample: every n-th pulse
  bool AccuracyReport = true; ///< changes no echo: not among those that are compared

  /// Whether a part of the model is left out.
  bool IsWithout(const std::string& part) const;

  /// The pattern of vtkHeliosBeamSampler for the fixed sub-rays: without SubRayPattern circles if
  /// they give that number, else a spiral.
  int GetPattern() const;

  bool operator==(const RunOptions& other) const;

  /// Returns an error if a value is not valid: which one, and what is expected.
  Status FindFault() const;

  /// Adds the options to those of a run's summary, without the epoch and the accuracy report.
  void Describe(Json::Value& options) const;

private:
  Status CheckSampling() const;
  Status CheckPattern() const;
  Status CheckParts() const;
  Status CheckWeather() const;
  Status CheckGpsStart() const;
};

} // namespace helios

#endif
