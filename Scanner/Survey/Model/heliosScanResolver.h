// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
// How one channel of a scanner scans on a leg.

#ifndef heliosScanResolver_h
#define heliosScanResolver_h

#include "heliosMessages.h"
#include "heliosSurveyData.h"

namespace helios
{

/// Resolves the scan of one channel on a leg, step by step; a failed step has reported its error.
class ScanResolver
{
public:
  ScanResolver(const LegSettings& settings, const ScannerData& scanner, const SurveyData& survey,
    std::size_t leg, Messages& log)
    : Given(settings)
    , Scanner(scanner)
    , IsMoving(survey.IsMoving(leg))
    , Fires(survey.Fires(leg))
    , Log(log)
    , Scan(settings.Scan)
  {
  }

  ScanData Resolve();

private:
  void ResolvePulses();
  void CheckBeams();
  void CheckEllipse();
  void ResolveScanAngles();
  void ResolveFrequencies();
  void ResolveScanProduct();
  void ResolveHead();
  void ResolveWarmUp();
  void CheckUnused();
  void ResolveWindow();
  void ClipScanFrequency();
  void CheckHead();

  bool Has(Optics type) const { return this->Scanner.Type == type; }

  bool HasResolution() const
  {
    return this->Given.VerticalResolution != 0.0 || this->Given.HorizontalResolution != 0.0;
  }

  /// The limits of the instrument and their sources.
  struct Limits
  {
    double Low;
    const char* LowName;
    double High;
    const char* HighName;
  };

  /// Returns the requested value (asked: its text in messages), clipped to the limits with a
  /// warning.
  double Clip(const MessageBuilder& asked, double value, const Limits& limits);

  /// Reports messages only for legs that fire pulses.
  void Error(const MessageBuilder& text);
  void Warning(const MessageBuilder& text);

  const LegSettings& Given;
  const ScannerData& Scanner;
  bool IsMoving;
  bool Fires;
  Messages& Log;
  ScanData Scan;
};

} // namespace helios

#endif
