// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
// From the sub-rays of a pulse to the received waveform and its echoes.

#ifndef heliosReturn_h
#define heliosReturn_h

#include "heliosPeaks.h"
#include "heliosPulseShape.h"
#include "heliosSingleMaximum.h"
#include "vtkHeliosEchoDetector.h"
#include "vtkHeliosScannerCoreModule.h"

#include <vtkType.h>

#include <cstdint>
#include <limits>
#include <vector>

namespace helios
{

/// What one sub-ray returns.
struct SubReturn
{
  double Range; // [m]
  double Power; // [W]
  double CosIncidence;
  vtkIdType CellId;
  int SubRay;
};

/// An echo at its range, and the sub-ray nearest to it.
struct Echo
{
  double Range;     // [m]
  double Amplitude; // [W]
  double Width;     // [ns], full width at half maximum
  const SubReturn* Nearest;
  double Deviation = std::numeric_limits<double>::quiet_NaN();
};

/// A waveform that starts StartTime [ns] after the emission.
struct Waveform
{
  double StartTime = 0.0;
  std::vector<float> Samples;
};

/// The echo of a beam on a plane, before it is detected.
struct PlaneEcho
{
  double Range;
  double Power; // at its peak [W]
  double Sigma; // [ns]; of a pulse that is no Gaussian: not used
};

/// What receives the light.
struct ReceiverSettings
{
  PulseShape Shape;
  double BinSize = 0.25;      // of waveforms [ns]
  double DetectionBin = 0.25; // of groups of returns that FindEchoes() has to bin [ns]
  const vtkHeliosEchoDetector* Detector = nullptr;
  vtkIdType MaximumCount = VTK_ID_MAX; // of samples of a waveform
  double Noise = 0.0;                  // standard deviation of a sample [W]
  std::uint64_t Seed = 0;
};

/**
 * The received signal: sub-return k adds its power times the pulse at t - 2 R_k / c. One a thread: it
 * owns the scratch memory.
 */
class VTKHELIOSSCANNERCORE_EXPORT Receiver
{
public:
  explicit Receiver(const ReceiverSettings& settings);

  /// The standard deviation of the pulse in range [m].
  double GetSigmaRange() const { return this->SigmaRange; }

  /**
   * The echoes of a pulse in the order of range. Returns too far apart to touch are treated by
   * themselves; where a group spreads over no more than c sigma its sum has exactly one maximum, found
   * by Newton's method, else bins are filled where maxima may be. True: all groups went without bins.
   * For Gaussian pulses and detectors that find maxima.
   */
  bool FindEchoes(const std::vector<SubReturn>& returns, std::vector<Echo>& echoes);

  /**
   * The echoes that DetectEchoes() finds in the waveform of the returns, without noise, to the byte:
   * only bins where a maximum may be are filled. False: nothing was found out, for the waveform was
   * cut or has no single maxima. For Gaussian pulses and detectors that find maxima.
   */
  bool FindEchoesInBins(const std::vector<SubReturn>& returns, std::vector<Echo>& echoes);

  ///@{
  /**
   * Fills the waveform of a pulse, over a background [W]; its id is the key of the noise. True: it was
   * cut, since it would be longer than allowed.
   */
  bool Fill(const std::vector<SubReturn>& returns, double background, vtkIdType pulseId);
  bool Fill(const PlaneEcho& echo, double background, vtkIdType pulseId);
  ///@}

  const Waveform& GetWaveform() const { return this->Wave; }

  /// The echoes in the waveform that was filled last, and their nearest returns.
  void DetectEchoes(const std::vector<SubReturn>& returns, std::vector<Echo>& echoes);

private:
  using Iterator = const SubReturn*;

  struct Search
  {
    const PulseShape& Shape; // ready for the bins
    double BinSize;          // [ns]
    bool KnowsSingles;       // whether groups with one maximum go without bins
  };

  /// The nearest and the farthest range of returns [m].
  struct Limits
  {
    double Nearest;
    double Farthest;
  };
  static Limits GetLimits(Iterator begin, Iterator end);
  bool FindMaxima(const std::vector<SubReturn>& returns, const Limits& limits, const Search& search,
    std::vector<Echo>& echoes, bool& isBinned);
  bool FindPeaksIn(const BinRange& bins, const Search& search, Iterator begin, Iterator end,
    std::vector<Echo>& echoes);
  void FindSingleEcho(
    const std::vector<SubReturn>& returns, const Limits& limits, std::vector<Echo>& echoes);
  bool OpenWindow(const Limits& limits, double binSize);
  bool OpenWindow(double nearest, double farthest, double widening, double binSize);
  BinRange GetWindow() const { return { 0, static_cast<vtkIdType>(this->Wave.Samples.size()) }; }
  void MakeClusters(Iterator begin, Iterator end);
  PulseCluster& GetCluster(vtkIdType slot);
  BinRange GetBinsOfMaxima(
    const PulseCluster& first, const PulseCluster& last, double binSize) const;
  void FillAll(Iterator begin, Iterator end, const PulseShape& shape);
  void FillGroup(
    std::size_t first, std::size_t last, const PulseShape& shape, const BinRange& bins);
  double GetTime(double range) const;
  void SetSamples(const BinRange& bins);
  void AddNoise(double background, vtkIdType pulseId);
  void Detect(Iterator begin, Iterator end, double binSize, std::vector<Echo>& echoes);
  void AddEcho(const vtkHeliosDetectedEcho& detected, Iterator begin, Iterator end,
    std::vector<Echo>& echoes) const;

  ReceiverSettings Settings;
  PulseShape DetectionShape;
  double Sigma;      // [ns]
  double SigmaRange; // [m]
  double Nearest = 0.0;
  double Margin = 0.0;     // from the start of the window to the peak of the nearest return [ns]
  std::vector<double> Sum; // of the samples of the waveform, those that are filled
  std::vector<PulseCluster> Clusters;
  SingleMaximum Maximum;
  Waveform Wave;
  std::vector<Peak> Peaks;
  std::vector<vtkHeliosDetectedEcho> Detected;
};

} // namespace helios

#endif
