// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
// From the sub-rays of a pulse to the received waveform and its echoes.

#ifndef heliosReturn_h
#define heliosReturn_h

#include "vtkHeliosEchoDetector.h"
#include "vtkHeliosScannerCoreModule.h"

#include <vtkType.h>

#include <vector>

namespace helios
{

/// What one sub-ray returns.
struct SubReturn
{
  double Range; // [m]
  double Power; // [W]
  vtkIdType CellId;
  int SubRay;
  double CosIncidence;
};

/// An echo at its range, and the sub-ray nearest to it.
struct Echo
{
  double Range;     // [m]
  double Amplitude; // [W]
  double Width;     // [ns], full width at half maximum
  const SubReturn* Nearest;
};

/// A waveform that starts StartTime [ns] after the emission.
struct Waveform
{
  double StartTime = 0.0;
  std::vector<float> Samples;
};

/**
 * The received signal of a Gaussian pulse: sub-return k adds its power times
 * exp(-(t - 2 R_k / c)^2 / (2 sigma^2)). One a thread: it owns the scratch memory.
 */
class VTKHELIOSSCANNERCORE_EXPORT Receiver
{
public:
  Receiver(double pulseLength, double binSize, const vtkHeliosEchoDetector* detector);

  /**
   * The echoes of a pulse in the order of range; it may reorder the returns. Returns too far apart
   * to touch are treated by themselves; where a group spreads over no more than c sigma its sum has
   * exactly one maximum, found by Newton's method, else bins are filled and searched.
   */
  void FindEchoes(std::vector<SubReturn>& returns, std::vector<Echo>& echoes);

  /// The whole waveform of the returns, cut after maximumCount samples (true: it was cut).
  bool MakeWaveform(
    const std::vector<SubReturn>& returns, vtkIdType maximumCount, Waveform& waveform);

private:
  using Iterator = const SubReturn*;

  void FindSingleEcho(Iterator begin, Iterator end, std::vector<Echo>& echoes) const;
  void FindBinnedEchoes(Iterator begin, Iterator end, std::vector<Echo>& echoes);
  bool Fill(Iterator begin, Iterator end, vtkIdType maximumCount, Waveform& waveform);
  void Deposit(double time, double power, vtkIdType count);

  double PulseLength;
  double BinSize;
  double Sigma;      // [ns]
  double SigmaRange; // [m]
  const vtkHeliosEchoDetector* Detector;
  std::vector<double> Shape; // of the pulse at multiples of BinSize, from -Reach on
  vtkIdType Reach;           // bins
  std::vector<double> Sum;
  Waveform Scratch;
  std::vector<vtkHeliosDetectedEcho> Detected;
};

} // namespace helios

#endif
