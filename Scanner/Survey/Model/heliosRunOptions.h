// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
// The options of a run that change its echoes: what a survey leaves open, or what overrides it.

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

/// Set by vtkHeliosRunOptions, which documents them. 0 and empty: as in the survey.
struct RunOptions
{
  int Epoch = 0;
  vtkIdType Seed = -1; ///< negative: as in the survey, else 0
  bool Noise = true;
  double RangeTolerance = 0.0;  ///< [m]
  double EnergyTolerance = 0.0; ///< relative
  int NumberOfSubRays = 0;      ///< fixed
  std::string EchoDetector;
  std::string RayCaster;

  bool operator==(const RunOptions& other) const;

  /// Returns an error if a value is not valid: which one, and what is expected.
  Status FindFault() const;

  /// Adds the options to those of a run's summary, without the epoch.
  void Describe(Json::Value& options) const;
};

} // namespace helios

#endif
