// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
// The transmitted pulse over time: peak 1 at time 0.

#ifndef heliosPulseShape_h
#define heliosPulseShape_h

#include "vtkHeliosScannerCoreModule.h"

#include <vtkType.h>

#include <algorithm>
#include <vector>

namespace helios
{

/// Returns that nearly coincide: the sums of their powers times the powers of their times.
struct PulseCluster
{
  static constexpr int Order = 8;
  static constexpr double Reach = 0.15; ///< distance of a time from the middle, in sigma

  vtkIdType Slot; ///< index of the cluster among adjacent ones
  double Time;    ///< the middle [ns], PulseShape::GetSlotTime()
  double Nearest; ///< the ranges in it [m]
  double Farthest;
  double Sums[Order] = {}; ///< with the times from the middle in sigma
};

/// The filled bins [First, Last) of a window.
struct BinRange
{
  vtkIdType First;
  vtkIdType Last;
};

class VTKHELIOSSCANNERCORE_EXPORT PulseShape
{
public:
  /// Makes exp(-t^2 / (2 sigma^2)), length [ns] its full width at half maximum.
  static PulseShape MakeGaussian(double length);

  /// Makes (t / tau)^2 exp(-t / tau) from 2 tau before its peak, tau = length / 3.3947.
  static PulseShape MakeHelios(double length);

  /// Makes straight lines between powers at increasing times [ns]: three or more, one of them
  /// positive, others may be negative.
  static PulseShape MakeSampled(
    const std::vector<double>& times, const std::vector<double>& powers);

  bool IsGaussian() const { return this->Kind == Gaussian; }

  /// Returns the full width at half maximum, and the standard deviation of a Gaussian of that width
  /// [ns].
  double GetLength() const { return this->Length; }
  double GetSigma() const;

  /// Returns the times before and after the peak between which there is power [ns].
  double GetStart() const { return this->Start; }
  double GetEnd() const { return this->End; }

  double operator()(double time) const;

  /// Computes times [ns] from the peak, and the powers there: the samples of a sampled pulse, or
  /// many in steps.
  void GetSamples(std::vector<double>& times, std::vector<double>& powers) const;

  /// Prepares for bins of a size [ns], and for clusters whose slots begin at a time [ns] after bin 0.
  void SetBinSize(double binSize, double slotStart = 0.0);

  /// Returns the middle of a slot of clusters [ns].
  double GetSlotTime(vtkIdType slot) const
  {
    return this->SlotStart +
      (static_cast<double>(slot) + 0.5) * (2.0 * PulseCluster::Reach * this->GetSigma());
  }

  /// Returns the bins within reach of a Gaussian to either side.
  vtkIdType GetReach() const { return this->Reach; }

  /**
   * Adds a pulse with its peak at a time [ns] after bin 0. Every bin gets the pulse's value at the
   * bin's own time, without rounding to bins; byte-identical whichever other bins are filled.
   */
  void Deposit(double time, double power, double* sum, const BinRange& bins) const;

  /**
   * Adds the Gaussians of a cluster in one pass: exp(-(u - d)^2 / 2) = exp(-u^2 / 2) sum He_n(u)
   * d^n / n! with Hermite's polynomials, to 1e-9 of the peak.
   */
  void Deposit(const PulseCluster& cluster, double* sum, const BinRange& bins) const;

private:
  /// A Gaussian at a time: bin From + i gets Start Ratio^i Shape[i].
  struct Placed
  {
    double Time;     // [ns]
    double Position; // the nearest bin
    vtkIdType From;
    vtkIdType Shape; // its first one, in the member
    double Start, Ratio;
  };
  Placed Place(double time) const;
  struct Window;
  bool GetWindow(const Placed& placed, const BinRange& bins, Window& window) const;

  enum Kinds
  {
    Gaussian,
    Helios,
    Sampled
  };

  void DepositGaussian(double time, double power, double* sum, const BinRange& bins) const;
  void SetSamples(const std::vector<double>& times, const std::vector<double>& powers);

  Kinds Kind = Gaussian;
  double Length = 4.0;
  double Start = 0.0;
  double End = 0.0;
  double Tau = 0.0;
  std::vector<double> Times; // times of a sampled pulse, from its peak
  std::vector<double> Powers;
  double BinSize = 0.25;
  std::vector<double> Shape; // values of a Gaussian at multiples of BinSize, from -Reach
  vtkIdType Reach = 0;       // bins
  double SlotStart = 0.0;    // [ns]
  std::vector<Placed> Slots; // Gaussians in the middle of the first slots
};

} // namespace helios

#endif
