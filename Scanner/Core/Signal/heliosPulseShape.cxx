// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
#include "heliosPulseShape.h"

#include "heliosConstants.h"
#include "heliosVectorLoops.h"

#include <algorithm>
#include <cmath>

namespace helios
{
namespace
{

// A Gaussian is truncated where it has fallen to 2e-10 of its peak: below a float's last bit.
constexpr double ReachInSigma = 6.7;
// t^2 exp(-t): half maxima at 0.76124023 and 4.15592090 tau, below 1e-9 of the peak from 27 tau.
constexpr double HeliosLengthInTau = 3.3946806708465;
constexpr double HeliosEndInTau = 27.0;
// Samples before the peak of a pulse in closed form that is stored: one is the peak.
constexpr int SamplesToPeak = 200;
// Slots of clusters whose Gaussians are known.
constexpr vtkIdType NumberOfSlots = 64;
// Bins processed together, for vector instructions.
constexpr vtkIdType Lanes = 8;

/**
 * A run of bins: bin i, from 0, gets Start Ratio^i Shape[i]. The first Skip bins, a multiple of
 * Lanes, are unchanged.
 */
struct Run
{
  double* Sum;
  const double* Shape; // padded to full lanes
  double Start, Ratio;
  vtkIdType Skip, Count;
};

/// Computes Start Ratio^i of the first lanes after the skipped ones; returns the factor to the next
/// ones.
HELIOS_INLINE double StartLanes(const Run& run, double factor[Lanes])
{
  factor[0] = run.Start;
  for (vtkIdType l = 1; l < Lanes; ++l)
  {
    factor[l] = factor[l - 1] * run.Ratio;
  }
  const double rho2 = run.Ratio * run.Ratio;
  const double rho4 = rho2 * rho2;
  const double rho8 = rho4 * rho4;
  for (vtkIdType i = 0; i < run.Skip; i += Lanes)
  {
    for (vtkIdType l = 0; l < Lanes; ++l)
    {
      factor[l] *= rho8;
    }
  }
  return rho8;
}

/// Adds the values of Lanes bins from bin i, of those in the run.
HELIOS_INLINE void AddLanes(const Run& run, vtkIdType i, const double value[Lanes])
{
  if (i + Lanes <= run.Count)
  {
    for (vtkIdType l = 0; l < Lanes; ++l)
    {
      run.Sum[i + l] += value[l];
    }
    return;
  }
  for (vtkIdType l = 0; i + l < run.Count; ++l)
  {
    run.Sum[i + l] += value[l];
  }
}

/// Adds a run.
HELIOS_CLONES void AddGeometric(const Run& run)
{
  double factor[Lanes];
  const double ratio = StartLanes(run, factor);
  double value[Lanes];
  for (vtkIdType i = run.Skip; i < run.Count; i += Lanes)
  {
    for (vtkIdType l = 0; l < Lanes; ++l)
    {
      value[l] = run.Shape[i + l] * factor[l];
      factor[l] *= ratio;
    }
    AddLanes(run, i, value);
  }
}

/// Adds a run times c(u + i du) at bin i, c a polynomial.
HELIOS_CLONES void AddPolynomial(
  const Run& run, double u, double du, const double c[PulseCluster::Order])
{
  double factor[Lanes];
  const double ratio = StartLanes(run, factor);
  double at[Lanes];
  for (vtkIdType l = 0; l < Lanes; ++l)
  {
    at[l] = static_cast<double>(l);
  }
  double value[Lanes];
  for (vtkIdType i = run.Skip; i < run.Count; i += Lanes)
  {
    for (vtkIdType l = 0; l < Lanes; ++l)
    {
      const double x = u + (static_cast<double>(i) + at[l]) * du;
      double poly = c[PulseCluster::Order - 1];
      for (int k = PulseCluster::Order - 2; k >= 0; --k)
      {
        poly = c[k] + x * poly;
      }
      value[l] = run.Shape[i + l] * factor[l] * poly;
      factor[l] *= ratio;
    }
    AddLanes(run, i, value);
  }
}

/// Returns the crossing of a level between two samples of a polyline.
double GetCrossing(double t0, double p0, double t1, double p1, double level)
{
  return t0 + (t1 - t0) * (level - p0) / (p1 - p0);
}

} // namespace

//------------------------------------------------------------------------------
PulseShape PulseShape::MakeGaussian(double length)
{
  PulseShape shape;
  shape.Length = length;
  shape.End = ReachInSigma * length / FwhmPerSigma;
  shape.Start = -shape.End;
  return shape;
}

//------------------------------------------------------------------------------
PulseShape PulseShape::MakeHelios(double length)
{
  PulseShape shape;
  shape.Kind = Helios;
  shape.Length = length;
  shape.Tau = length / HeliosLengthInTau;
  shape.Start = -2.0 * shape.Tau;
  shape.End = (HeliosEndInTau - 2.0) * shape.Tau;
  return shape;
}

//------------------------------------------------------------------------------
double PulseShape::GetSigma() const
{
  return this->Length / FwhmPerSigma;
}

//------------------------------------------------------------------------------
double PulseShape::operator()(double time) const
{
  if (this->Kind == Gaussian)
  {
    const double u = time / this->GetSigma();
    return std::exp(-0.5 * u * u);
  }
  if (time < this->Start || time > this->End)
  {
    return 0.0;
  }
  if (this->Kind == Helios)
  {
    const double half = 0.5 * time / this->Tau + 1.0; // t / (2 tau), from the start of the pulse
    return half * half * std::exp(-time / this->Tau);
  }
  const auto above = std::upper_bound(this->Times.begin() + 1, this->Times.end() - 1, time);
  const auto i = static_cast<std::size_t>(above - this->Times.begin());
  const double share = (time - this->Times[i - 1]) / (this->Times[i] - this->Times[i - 1]);
  return this->Powers[i - 1] + share * (this->Powers[i] - this->Powers[i - 1]);
}

//------------------------------------------------------------------------------
void PulseShape::GetSamples(std::vector<double>& times, std::vector<double>& powers) const
{
  times = this->Times;
  powers = this->Powers;
  const double step = -this->Start / SamplesToPeak;
  for (int i = -SamplesToPeak; this->Kind != Sampled && i * step <= this->End; ++i)
  {
    times.push_back(i * step);
    powers.push_back((*this)(times.back()));
  }
}

//------------------------------------------------------------------------------
void PulseShape::SetBinSize(double binSize, double slotStart)
{
  this->BinSize = binSize;
  this->SlotStart = slotStart;
  if (this->Kind != Gaussian)
  {
    return;
  }
  this->Reach = static_cast<vtkIdType>(std::ceil(this->End / binSize));
  const vtkIdType count = 2 * this->Reach + 1 + Lanes; // lanes may exceed the end
  this->Shape.assign(static_cast<std::size_t>(count), 0.0);
  for (vtkIdType i = 0; i <= 2 * this->Reach; ++i)
  {
    this->Shape[static_cast<std::size_t>(i)] =
      (*this)(static_cast<double>(i - this->Reach) * binSize);
  }
  this->Slots.clear();
  for (vtkIdType slot = 0; slot < NumberOfSlots; ++slot)
  {
    this->Slots.push_back(this->Place(this->GetSlotTime(slot)));
  }
}

//------------------------------------------------------------------------------
void PulseShape::Deposit(double time, double power, double* sum, const BinRange& bins) const
{
  if (this->Kind == Gaussian)
  {
    this->DepositGaussian(time, power, sum, bins);
    return;
  }
  const double first =
    std::max(static_cast<double>(bins.First), std::ceil((time + this->Start) / this->BinSize));
  const double last =
    std::min(static_cast<double>(bins.Last) - 1.0, std::floor((time + this->End) / this->BinSize));
  for (double bin = first; bin <= last; bin += 1.0)
  {
    sum[static_cast<vtkIdType>(bin)] += power * (*this)(bin * this->BinSize - time);
  }
}

/// The window of a Gaussian.
struct PulseShape::Window
{
  vtkIdType From, Skip, Count; // Skip: lanes before the filled bins
  const double* Shape;
  double Start, Ratio;

  Run GetRun(double* sum, double power) const
  {
    return { sum + this->From, this->Shape, power * this->Start, this->Ratio, this->Skip,
      this->Count };
  }
};

//------------------------------------------------------------------------------
/**
 * Places a pulse. With the nearest bin m and delta = time - m b, bin m + q gets
 * exp(-(q b - delta)^2 / (2 sigma^2)) = shape(q) exp(-delta^2 / (2 sigma^2)) rho^q, rho = exp(b
 * delta / sigma^2): no exponential per bin.
 */
PulseShape::Placed PulseShape::Place(double time) const
{
  const double position = std::round(time / this->BinSize);
  const vtkIdType middle = static_cast<vtkIdType>(position);
  const double sigma = this->GetSigma();
  const double delta = time - position * this->BinSize;
  const double exponent = this->BinSize * delta / (sigma * sigma);
  const double u = delta / sigma;
  const vtkIdType from = std::max<vtkIdType>(0, middle - this->Reach);
  return { time, position, from, from - middle + this->Reach,
    std::exp(-0.5 * u * u + exponent * static_cast<double>(from - middle)), std::exp(exponent) };
}

//------------------------------------------------------------------------------
/// Computes the window of a pulse; false if no bin is reached.
bool PulseShape::GetWindow(const Placed& placed, const BinRange& bins, Window& window) const
{
  if (placed.Position - static_cast<double>(this->Reach) >= static_cast<double>(bins.Last))
  {
    return false;
  }
  const vtkIdType middle = static_cast<vtkIdType>(placed.Position);
  window.From = placed.From;
  window.Skip = std::max<vtkIdType>(0, (bins.First - window.From) / Lanes * Lanes);
  window.Count = std::min(bins.Last, middle + this->Reach + 1) - window.From;
  window.Shape = this->Shape.data() + placed.Shape;
  window.Start = placed.Start;
  window.Ratio = placed.Ratio;
  return true;
}

//------------------------------------------------------------------------------
void PulseShape::DepositGaussian(double time, double power, double* sum, const BinRange& bins) const
{
  Window w;
  if (this->GetWindow(this->Place(time), bins, w))
  {
    AddGeometric(w.GetRun(sum, power));
  }
}

//------------------------------------------------------------------------------
void PulseShape::Deposit(const PulseCluster& cluster, double* sum, const BinRange& bins) const
{
  Window w;
  const auto slot = static_cast<std::size_t>(cluster.Slot);
  const bool isKnown = slot < this->Slots.size() && this->Slots[slot].Time == cluster.Time;
  if (!this->GetWindow(isKnown ? this->Slots[slot] : this->Place(cluster.Time), bins, w))
  {
    return;
  }
  double a[PulseCluster::Order];
  double factorial = 1.0;
  for (int n = 0; n < PulseCluster::Order; ++n)
  {
    a[n] = cluster.Sums[n] / factorial;
    factorial *= n + 1.0;
  }
  const double c[PulseCluster::Order] = { a[0] - a[2] + 3.0 * a[4] - 15.0 * a[6],
    a[1] - 3.0 * a[3] + 15.0 * a[5] - 105.0 * a[7], a[2] - 6.0 * a[4] + 45.0 * a[6],
    a[3] - 10.0 * a[5] + 105.0 * a[7], a[4] - 15.0 * a[6], a[5] - 21.0 * a[7], a[6], a[7] };
  const double du = this->BinSize / this->GetSigma();
  const double u = (static_cast<double>(w.From) * this->BinSize - cluster.Time) / this->GetSigma();
  AddPolynomial(w.GetRun(sum, 1.0), u, du, c);
}

//------------------------------------------------------------------------------
PulseShape PulseShape::MakeSampled(
  const std::vector<double>& times, const std::vector<double>& powers)
{
  PulseShape shape;
  shape.SetSamples(times, powers);
  return shape;
}

//------------------------------------------------------------------------------
void PulseShape::SetSamples(const std::vector<double>& times, const std::vector<double>& powers)
{
  const auto peak = std::max_element(powers.begin(), powers.end());
  const auto at = static_cast<std::size_t>(peak - powers.begin());
  this->Kind = Sampled;
  this->Times = times;
  this->Powers = powers;
  for (std::size_t i = 0; i < times.size(); ++i)
  {
    this->Times[i] = times[i] - times[at];
    this->Powers[i] = powers[i] / *peak;
  }
  this->Start = this->Times.front();
  this->End = this->Times.back();
  std::size_t left = at;
  while (left > 0 && this->Powers[left] > 0.5)
  {
    --left;
  }
  std::size_t right = at;
  while (right + 1 < times.size() && this->Powers[right] > 0.5)
  {
    ++right;
  }
  const auto& t = this->Times;
  const auto& p = this->Powers;
  const double rise =
    p[left] < 0.5 ? GetCrossing(t[left], p[left], t[left + 1], p[left + 1], 0.5) : t[left];
  const double fall =
    p[right] < 0.5 ? GetCrossing(t[right - 1], p[right - 1], t[right], p[right], 0.5) : t[right];
  this->Length = fall - rise;
}

} // namespace helios
