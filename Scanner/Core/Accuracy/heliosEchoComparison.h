// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
// Differences between the echoes of the same pulses, computed in two ways.

#ifndef heliosEchoComparison_h
#define heliosEchoComparison_h

#include "heliosConfidence.h"
#include "heliosStatus.h"
#include "vtkHeliosScannerCoreModule.h" // For export macro

#include <vtkType.h>

#include <vector>

class vtkPolyData;

namespace helios
{

/// Which echoes are the same, and which of them count.
struct VTKHELIOSSCANNERCORE_EXPORT EchoMatching
{
  double Distance = 0.3; ///< most between echoes that are the same [m]
  /// amplitude of a full footprint at 1 m without extinction [W]; 0: not known
  double FullAmplitude = 0.0;
  double Extinction = 0.0;     ///< one way [1/m]
  double LeastShare = 0.02;    ///< smallest share of a full footprint, for echoes that count
  double LeastAmplitude = 0.0; ///< smallest amplitude of echoes that count [W]

  /// Returns the amplitude of a full footprint at a range [W].
  double GetFullAmplitude(double range) const;

  /// Returns the smallest amplitude of echoes that count at a range [W].
  double GetLeastAmplitude(double range) const;
};

/// The errors of echoes against a reference.
struct EchoErrors
{
  vtkIdType Echoes = 0;  ///< echoes of the reference that count
  vtkIdType Matched = 0; ///< echoes that were matched
  Estimate RangeP50;     ///< [m], of matched echoes
  Estimate RangeP95;     ///< [m]
  Estimate RangeRms;     ///< [m]
  double RangeP99 = 0.0;
  double RangeBias = 0.0; ///< [m], mean
  Estimate Missed;        ///< fraction of the echoes
  Estimate Invented;      ///< relative to the number of echoes
  Estimate Lost;          ///< both together
  Estimate AmplitudeRms;  ///< relative to a full footprint, else to the reference
  Estimate WidthRms;      ///< [ns]
};

/// A measure and its name in tables and summaries.
struct EchoMeasure
{
  const char* Name;
  Estimate EchoErrors::*Measure;
};

constexpr EchoMeasure EchoMeasures[] = {
  { "rangeP50_m", &EchoErrors::RangeP50 },
  { "rangeP95_m", &EchoErrors::RangeP95 },
  { "rangeRms_m", &EchoErrors::RangeRms },
  { "missed", &EchoErrors::Missed },
  { "invented", &EchoErrors::Invented },
  { "missedAndInvented", &EchoErrors::Lost },
  { "amplitudeRms", &EchoErrors::AmplitudeRms },
  { "widthRms_ns", &EchoErrors::WidthRms },
};

/**
 * Echoes of a pulse are matched in pairs, nearest first. An echo of the reference that counts and
 * has no partner is missed; one of the others that counts and has none is invented. A partner may
 * be weaker than what counts, so that an echo at the limit is neither.
 */
class VTKHELIOSSCANNERCORE_EXPORT EchoComparison
{
public:
  /// Adds echoes; an error if PulseIds, Range, Amplitude or EchoWidth is missing.
  Status Add(vtkPolyData* echoes, vtkPolyData* reference, const EchoMatching& matching);

  EchoErrors GetErrors() const;

private:
  struct Echo
  {
    vtkIdType Pulse;
    double Range;
    double Amplitude;
    double Width;
    bool IsMatched;
  };
  using Echoes = std::vector<Echo>;

  static Status Read(vtkPolyData* data, Echoes& echoes);
  void Match(
    Echo* first, Echo* last, Echo* otherFirst, Echo* otherLast, const EchoMatching& matching);
  void AddPair(const Echo& echo, const Echo& reference, const EchoMatching& matching);

  vtkIdType Expected = 0;
  vtkIdType Missed = 0;
  vtkIdType Invented = 0;
  std::vector<double> Ranges; // signed deviations of pairs
  std::vector<double> Amplitudes;
  std::vector<double> Widths;
};

} // namespace helios

#endif
