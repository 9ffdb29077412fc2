// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
#include "heliosReturn.h"

#include "heliosRadiometry.h"

#include <algorithm>
#include <cmath>

namespace helios
{
namespace
{

// A pulse is followed to where it has fallen to 1e-14 of its peak ...
constexpr double ReachInSigma = 8.0;
// ... and the window opens this long before the first return: no maximum lies outside the returns.
constexpr double MarginInSigma = 5.0;
// Bins handled together, so that the compiler can use vector instructions.
constexpr vtkIdType Lanes = 8;

double TwoWayTime(double range)
{
  return 2.0 * range / SpeedOfLight;
}

/// The return nearest in range; of two equally near the first.
const SubReturn* FindNearest(const SubReturn* begin, const SubReturn* end, double range)
{
  return std::min_element(begin, end,
    [range](const SubReturn& a, const SubReturn& b)
    { return std::abs(a.Range - range) < std::abs(b.Range - range); });
}

/// sum[i] += shape[i] start rho^i. Compiled for wider registers too; the bytes stay the same.
__attribute__((target_clones("avx2", "default"))) void AddGeometric(
  double* __restrict sum, const double* __restrict shape, double start, double rho, vtkIdType count)
{
  double factor[Lanes];
  factor[0] = start;
  for (vtkIdType l = 1; l < Lanes; ++l)
  {
    factor[l] = factor[l - 1] * rho;
  }
  const double rho2 = rho * rho;
  const double rho4 = rho2 * rho2;
  const double rho8 = rho4 * rho4;
  vtkIdType i = 0;
  for (; i + Lanes <= count; i += Lanes)
  {
    for (vtkIdType l = 0; l < Lanes; ++l)
    {
      sum[i + l] += shape[i + l] * factor[l];
      factor[l] *= rho8;
    }
  }
  for (vtkIdType l = 0; i < count; ++i, ++l)
  {
    sum[i] += shape[i] * factor[l];
  }
}

bool IsNearer(const SubReturn& a, const SubReturn& b)
{
  return a.Range < b.Range || (a.Range == b.Range && a.SubRay < b.SubRay);
}

/// exp(-y) for y >= 0: near 0, where most sub-rays are, by its series to the last bit.
double ExpMinus(double y)
{
  return y < 0.01 ? 1.0 -
      y * (1.0 - y * (1 / 2.0 - y * (1 / 6.0 - y * (1 / 24.0 - y * (1 / 120.0 - y * (1 / 720.0))))))
                  : std::exp(-y);
}

} // namespace

Receiver::Receiver(double pulseLength, double binSize, const vtkHeliosEchoDetector* detector)
  : PulseLength(pulseLength)
  , BinSize(binSize)
  , Sigma(pulseLength / FwhmPerSigma)
  , SigmaRange(0.5 * SpeedOfLight * pulseLength / FwhmPerSigma)
  , Detector(detector)
  , Reach(static_cast<vtkIdType>(std::ceil(ReachInSigma * pulseLength / FwhmPerSigma / binSize)))
{
  const vtkIdType count = (2 * this->Reach + Lanes) / Lanes * Lanes;
  this->Shape.resize(static_cast<std::size_t>(count), 0.0);
  for (vtkIdType i = 0; i <= 2 * this->Reach; ++i)
  {
    const double u = static_cast<double>(i - this->Reach) * binSize / this->Sigma;
    this->Shape[static_cast<std::size_t>(i)] = std::exp(-0.5 * u * u);
  }
}

void Receiver::FindEchoes(std::vector<SubReturn>& returns, std::vector<Echo>& echoes)
{
  const SubReturn* end = returns.data() + returns.size();
  const auto limits = std::minmax_element(returns.begin(), returns.end(), IsNearer);
  if (limits.second->Range - limits.first->Range <= 2.0 * this->SigmaRange)
  {
    this->FindSingleEcho(returns.data(), end, echoes);
    return;
  }
  std::sort(returns.begin(), returns.end(), IsNearer);
  const double gap = 2.0 * ReachInSigma * this->SigmaRange;
  for (const SubReturn* first = returns.data(); first != end;)
  {
    const SubReturn* last = first + 1;
    while (last != end && last->Range - (last - 1)->Range <= gap)
    {
      ++last;
    }
    if ((last - 1)->Range - first->Range <= 2.0 * this->SigmaRange)
    {
      this->FindSingleEcho(first, last, echoes);
    }
    else
    {
      this->FindBinnedEchoes(first, last, echoes);
    }
    first = last;
  }
}

void Receiver::FindSingleEcho(Iterator begin, Iterator end, std::vector<Echo>& echoes) const
{
  double power = 0.0, first = 0.0, second = 0.0, third = 0.0;
  for (Iterator r = begin; r != end; ++r)
  {
    const double x = r->Range - begin->Range;
    const double px = r->Power * x;
    power += r->Power;
    first += px;
    second += px * x;
    third += px * x * x;
  }
  if (!(power > 0.0))
  {
    return;
  }
  const double mean = first / power;
  const double variance = std::max(0.0, second / power - mean * mean);

  // Newton on the logarithm of the sum, which is concave; u in units of sigma. For a small spread the
  // maximum lies at mean - mu3 / (2 sigma^2) but for terms of its fifth power.
  const double scale = 1.0 / this->SigmaRange;
  const bool isSmall = variance * scale * scale < 1e-2;
  const double mu3 = third / power - mean * (3.0 * variance + mean * mean);
  double x = isSmall ? mean - 0.5 * scale * scale * mu3 : mean;
  double amplitude = power;
  for (int iteration = 0; iteration < 50; ++iteration)
  {
    double w0 = 0.0, w1 = 0.0, w2 = 0.0;
    for (Iterator r = begin; r != end; ++r)
    {
      const double u = (x - (r->Range - begin->Range)) * scale;
      const double w = r->Power * ExpMinus(0.5 * u * u);
      w0 += w;
      w1 += w * u;
      w2 += w * u * u;
    }
    amplitude = w0;
    const double slope = w1 / w0;
    const double curvature = 1.0 - (w2 / w0 - slope * slope); // 0 only for two halves 2 sigma apart
    const double step = slope / std::max(curvature, 0.02);
    x -= step / scale;
    if (std::abs(step) < 1e-7)
    {
      break;
    }
  }
  if (amplitude < this->Detector->GetDetectionThreshold())
  {
    return;
  }
  const double widening = 4.0 / (SpeedOfLight * SpeedOfLight) * variance; // [ns^2]
  const double range = begin->Range + x;
  echoes.push_back(
    { range, amplitude, FwhmPerSigma * std::sqrt(this->Sigma * this->Sigma + widening),
      FindNearest(begin, end, range) });
}

void Receiver::FindBinnedEchoes(Iterator begin, Iterator end, std::vector<Echo>& echoes)
{
  this->Fill(begin, end, VTK_ID_MAX, this->Scratch);
  this->Detected.clear();
  const auto& samples = this->Scratch.Samples;
  this->Detector->Detect(
    { samples.data(), static_cast<vtkIdType>(samples.size()), this->BinSize, this->PulseLength },
    this->Detected);
  for (const vtkHeliosDetectedEcho& echo : this->Detected)
  {
    const double range = 0.5 * SpeedOfLight * (this->Scratch.StartTime + echo.Time);
    echoes.push_back({ range, echo.Amplitude, echo.Width, FindNearest(begin, end, range) });
  }
}

bool Receiver::MakeWaveform(
  const std::vector<SubReturn>& returns, vtkIdType maximumCount, Waveform& waveform)
{
  return this->Fill(returns.data(), returns.data() + returns.size(), maximumCount, waveform);
}

bool Receiver::Fill(Iterator begin, Iterator end, vtkIdType maximumCount, Waveform& waveform)
{
  const auto limits = std::minmax_element(begin, end, IsNearer);
  const double nearest = limits.first->Range;
  const double margin = MarginInSigma * this->Sigma;
  waveform.StartTime = TwoWayTime(nearest) - margin;
  const double length = TwoWayTime(limits.second->Range - nearest) + 2.0 * margin;
  const double wanted = std::ceil(length / this->BinSize) + 1.0;
  const bool cut = wanted > static_cast<double>(maximumCount);
  const vtkIdType count = cut ? maximumCount : static_cast<vtkIdType>(wanted);

  this->Sum.assign(static_cast<std::size_t>(count), 0.0);
  for (Iterator r = begin; r != end; ++r)
  {
    this->Deposit(TwoWayTime(r->Range - nearest) + margin, r->Power, count);
  }
  waveform.Samples.resize(static_cast<std::size_t>(count));
  std::transform(this->Sum.begin(), this->Sum.end(), waveform.Samples.begin(),
    [](double value) { return static_cast<float>(value); });
  return cut;
}

/**
 * Adds a pulse with its peak at a time after the window's start. With the nearest bin m and
 * delta = time - m b, bin m + q gets exp(-(q b - delta)^2 / (2 sigma^2)) =
 * shape(q) exp(-delta^2 / (2 sigma^2)) rho^q, rho = exp(b delta / sigma^2): no exponential a bin.
 */
void Receiver::Deposit(double time, double power, vtkIdType count)
{
  const double position = std::round(time / this->BinSize);
  if (position - static_cast<double>(this->Reach) >= static_cast<double>(count))
  {
    return; // behind a window that was cut
  }
  const vtkIdType middle = static_cast<vtkIdType>(position);
  const double delta = time - position * this->BinSize;
  const double exponent = this->BinSize * delta / (this->Sigma * this->Sigma);
  const double u = delta / this->Sigma;

  const vtkIdType from = std::max<vtkIdType>(0, middle - this->Reach);
  const vtkIdType to = std::min(count, middle + this->Reach + 1);
  const double* shape = this->Shape.data() + (from - middle + this->Reach);
  double* sum = this->Sum.data() + from;

  const double start =
    power * std::exp(-0.5 * u * u + exponent * static_cast<double>(from - middle));
  AddGeometric(sum, shape, start, std::exp(exponent), to - from);
}

} // namespace helios
