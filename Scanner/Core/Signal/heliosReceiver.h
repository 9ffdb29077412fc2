// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
// Computes the received waveform of a pulse and its echoes from its sub-rays.

#ifndef heliosReceiver_h
#define heliosReceiver_h

#include "heliosPeaks.h"
#include "heliosPulseShape.h"
#include "heliosSingleMaximum.h"
#include "heliosStatus.h"
#include "vtkHeliosEchoDetector.h"
#include "vtkHeliosScannerCoreModule.h"

#include <vtkType.h>

#include <cstdint>
#include <limits>
#include <unordered_map>
#include <utility>
#include <vector>

namespace helios
{

/// The return of one sub-ray.
struct SubReturn
{
  static constexpr int Column = -1; ///< SubRay of what a medium before a surface returns

  double Range; // [m]
  double Power; // [W]
  double CosIncidence;
  vtkIdType CellId;
  int SubRay;    ///< index, or Column
  int Path = -1; // behind mirrors and glass: of PathTracer::GetEnd()
};

/// An echo at its range, and the nearest sub-ray.
struct Echo
{
  double Range;             // [m]
  double Amplitude;         // [W]
  double Width;             // [ns], full width at half maximum
  const SubReturn* Nearest; // null: a dark count
  double Deviation = std::numeric_limits<double>::quiet_NaN();
};

/// A waveform that starts StartTime [ns] after the emission.
struct Waveform
{
  double StartTime = 0.0;
  std::vector<float> Samples;
};

/// The undetected echo of a beam on a plane.
struct PlaneEcho
{
  double Range;
  double Power; // at its peak [W]
  double Sigma; // [ns]; not used for a non-Gaussian pulse
};

/// The receiver.
struct ReceiverSettings
{
  PulseShape Shape;
  double BinSize = 0.25;      // bin of waveforms [ns]
  double DetectionBin = 0.25; // bin of groups of returns that FindMaxima() has to bin [ns]
  /// Returns from which on the maxima of FindMaxima() are those of these bins.
  std::size_t MaximumRefined = std::numeric_limits<std::size_t>::max();
  const vtkHeliosEchoDetector* Detector = nullptr;
  vtkIdType MaximumCount = VTK_ID_MAX; // largest number of samples of a waveform
  bool HasLimit = true; // whether returns beyond that have no echo, or only no sample
  double Noise = 0.0;   // standard deviation of a sample [W]
  double Saturation = std::numeric_limits<double>::infinity(); // larger samples are clipped [W]
  double GateStart = 0.0; // between which the receiver is armed, after the emission [ns]
  double GateStop = 0.0;
  std::uint64_t Seed = 0;
};

/**
 * The received signal: return k adds its power times the pulse at t - 2 R_k / c. One per thread: it
 * owns the scratch memory.
 */
class VTKHELIOSSCANNERCORE_EXPORT Receiver
{
public:
  explicit Receiver(const ReceiverSettings& settings);

  /**
   * Finds the echoes of a pulse in order of range. Groups of returns too far apart to overlap are
   * processed separately; a group that spreads over no more than c sigma has exactly one maximum,
   * found by Newton's method; in others the bins that may hold maxima are filled. Returns true if
   * no group needed bins. For Gaussian pulses and detectors that find maxima. The nearest returns
   * of the echoes are valid until the next call.
   */
  bool FindMaxima(const std::vector<SubReturn>& returns, std::vector<Echo>& echoes);

  /// Returns whether the last FindMaxima() left out returns beyond the maximum length of a
  /// waveform.
  bool IsCut() const { return this->WasCut; }

  /**
   * Finds the echoes that DetectEchoes() finds in the waveform of the returns, without noise,
   * byte-identical: only bins that may hold a maximum are filled. False if no echoes were computed,
   * because the waveform was cut or has no single maxima. For Gaussian pulses and detectors that
   * find maxima.
   */
  bool FindBinnedMaxima(const std::vector<SubReturn>& returns, std::vector<Echo>& echoes);

  /// Makes one echo of all returns: their sum, at their mean range weighted by power.
  void MergeReturns(const std::vector<SubReturn>& returns, std::vector<Echo>& echoes) const;

  ///@{
  /**
   * Fills the waveform of a pulse, over a background [W]; its id is the key of the noise. Returns
   * true if it was cut at the maximum length.
   */
  bool Fill(const std::vector<SubReturn>& returns, double background, vtkIdType pulseId);
  bool Fill(const PlaneEcho& echo, double background, vtkIdType pulseId);
  ///@}

  /// Fills the waveform of a pulse that returns nothing: no samples.
  void FillEmpty(vtkIdType pulseId);

  const Waveform& GetWaveform() const { return this->Wave; }

  /// Detects the echoes in the waveform filled last, and their nearest returns.
  void DetectEchoes(const std::vector<SubReturn>& returns, std::vector<Echo>& echoes);

  /// Swaps the waveform filled last with another one.
  void SwapWaveform(Waveform& other) { std::swap(this->Wave, other); }

  /// Detects the echoes in waveforms of the receiver, each with the id of its pulse, together.
  void DetectAll(const std::vector<std::pair<const Waveform*, vtkIdType>>& waveforms,
    std::vector<std::vector<vtkHeliosDetectedEcho>>& detected);

  /// Adds echoes that were detected in the current waveform, with their nearest returns.
  void AddEchoes(const std::vector<vtkHeliosDetectedEcho>& detected,
    const std::vector<SubReturn>& returns, std::vector<Echo>& echoes) const;

  /// Returns the first error of the detector.
  const Status& GetFault() const { return this->Fault; }

private:
  using Iterator = const SubReturn*;

  struct Search
  {
    const PulseShape& Shape; // prepared for the bins
    double BinSize;          // [ns]
    bool KnowsSingles;       // whether groups with one maximum skip the bins
    double GetGap() const;   // between returns whose pulses do not overlap [m]
  };

  /// The nearest and the farthest range of returns [m].
  struct Limits
  {
    double Nearest;
    double Farthest;
  };
  static Limits GetLimits(Iterator begin, Iterator end);
  bool FindMaxima(Iterator begin, Iterator end, const Limits& limits, const Search& search,
    std::vector<Echo>& echoes);
  bool FindMaximaApart(
    const std::vector<SubReturn>& returns, const Search& search, std::vector<Echo>& echoes);
  bool FindInGroups(Iterator begin, Iterator end, const Limits& limits, const Search& search,
    std::vector<Echo>& echoes, bool& isBinned);
  bool FindPeaksIn(const BinRange& bins, const Search& search, Iterator begin, Iterator end,
    std::vector<Echo>& echoes);
  std::pair<Iterator, Iterator> GetNear(Iterator begin, Iterator end, double time) const;
  void Refine(Iterator begin, Iterator end, double binSize, vtkHeliosDetectedEcho& echo) const;
  void FindSingleEcho(
    Iterator begin, Iterator end, const Limits& limits, std::vector<Echo>& echoes);
  bool OpenWindow(const Limits& limits, double binSize);
  bool OpenWindow(double nearest, double farthest, double widening, double binSize);
  BinRange GetWindow() const { return { 0, static_cast<vtkIdType>(this->Wave.Samples.size()) }; }
  void MakeClusters(Iterator begin, Iterator end);
  void ForgetPlaces();
  PulseCluster& GetCluster(vtkIdType slot);
  BinRange GetBinsOfMaxima(
    const PulseCluster& first, const PulseCluster& last, double binSize) const;
  void FillAll(Iterator begin, Iterator end, const PulseShape& shape);
  void FillGroup(
    std::size_t first, std::size_t last, const PulseShape& shape, const BinRange& bins);
  double GetTime(double range) const;
  void SetSamples(const BinRange& bins);
  void AddNoise(double background, vtkIdType pulseId);
  vtkHeliosWaveform Describe(const Waveform& wave, vtkIdType pulseId, double binSize) const;
  void DetectWaveforms(const std::vector<vtkHeliosWaveform>& waveforms,
    std::vector<std::vector<vtkHeliosDetectedEcho>>& detected);
  void Detect(Iterator begin, Iterator end, double binSize, std::vector<Echo>& echoes);
  void AddEcho(const vtkHeliosDetectedEcho& detected, Iterator begin, Iterator end,
    std::vector<Echo>& echoes) const;

  ReceiverSettings Settings;
  PulseShape DetectionShape;
  double Offset = 0.0; // how late the detector finds a plane [ns]
  Status Fault;
  vtkIdType PulseId = 0;
  double Sigma;      // [ns]
  double SigmaRange; // [m]
  double Nearest = 0.0;
  double Margin = 0.0;     // from the start of the window to the peak of the nearest return [ns]
  std::vector<double> Sum; // sums in the filled samples of the waveform
  std::vector<PulseCluster> Clusters;
  std::vector<int> NearClusters = std::vector<int>(256, -1); // places of clusters by slot; -1: none
  std::unordered_map<vtkIdType, int> FarClusters;            // places of those of slots beyond
  bool WasCut = false;
  bool IsSorted = false;         // whether the returns are, by range
  std::vector<SubReturn> Sorted; // many returns, or returns too far apart for one window
  SingleMaximum Maximum;
  Waveform Wave;
  std::vector<Peak> Peaks;
  std::vector<std::vector<vtkHeliosDetectedEcho>> Detected{ 1 }; // in the current waveform
};

} // namespace helios

#endif
