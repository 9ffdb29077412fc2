// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma GCC diagnostic ignored "-Wpsabi" // vectors are passed to inlined functions only
#include "heliosReceiver.h"

#include "heliosConstants.h"
#include "heliosDetectorOffset.h"
#include "heliosRandom.h"
#include "heliosRayVectors.h"
#include "heliosReturnSelection.h"
#include "heliosVectorLoops.h"

#include <algorithm>
#include <cmath>

namespace helios
{
namespace
{

// The window of a Gaussian starts this long before the first return: no maximum lies outside
// the returns.
constexpr double MarginInSigma = 5.0;
constexpr double FarInSigma = 7.0;    // returns beyond contribute less than 1e-10
constexpr int MaximumIterations = 20; // steps of Newton's method
constexpr std::size_t Many = 1000;    // returns, that are sorted so that each is compared with few

double TwoWayTime(double range)
{
  return 2.0 / SpeedOfLight * range;
}

typedef double Powers __attribute__((vector_size(8 * PulseCluster::Order / 2)));
typedef long long PowerMasks __attribute__((vector_size(8 * PulseCluster::Order / 2)));
static_assert(PulseCluster::Order == 8, "there are four powers, and four times x^4");

/// Computes 1, x, x^2, x^3.
HELIOS_INLINE void SetPowers(double x, Powers& powers)
{
  constexpr PowerMasks has1 = { 0, -1, 0, -1 };
  constexpr PowerMasks has2 = { 0, 0, -1, -1 };
  const Powers one = Powers() + 1.0;
  powers = (has1 ? Powers() + x : one) * (has2 ? Powers() + x * x : one);
}

/// Returns the return nearest in range; the first of equally near ones.
const SubReturn* FindNearest(const SubReturn* begin, const SubReturn* end, double range)
{
  const SubReturn* nearest = begin;
  double minimum = std::abs(begin->Range - range);
  for (const SubReturn* r = begin + 1; r != end; ++r)
  {
    const double away = std::abs(r->Range - range);
    nearest = away < minimum ? r : nearest;
    minimum = std::min(minimum, away);
  }
  return nearest;
}

/// Returns the surface nearest in range, within reach of a medium that is nearer; else the medium.
const SubReturn* FindNearestSurface(
  const SubReturn* begin, const SubReturn* end, double range, double reach)
{
  const SubReturn* nearest = FindNearest(begin, end, range);
  if (nearest->SubRay != SubReturn::Column)
  {
    return nearest;
  }
  for (const SubReturn* r = begin; r != end; ++r)
  {
    const double away = std::abs(r->Range - range);
    if (r->SubRay != SubReturn::Column && away <= reach)
    {
      nearest = r;
      reach = away;
    }
  }
  return nearest;
}

} // namespace

//------------------------------------------------------------------------------
Receiver::Receiver(const ReceiverSettings& settings)
  : Settings(settings)
  , DetectionShape(settings.Shape)
  , Sigma(settings.Shape.GetSigma())
  , SigmaRange(0.5 * SpeedOfLight * settings.Shape.GetSigma())
{
  const double margin = MarginInSigma * this->Sigma; // OpenWindow()
  this->Settings.Shape.SetBinSize(settings.BinSize, margin);
  this->DetectionShape.SetBinSize(settings.DetectionBin, margin);
  if (settings.Detector)
  {
    this->Fault =
      ComputeDetectorOffset(*settings.Detector, settings.Shape, settings.BinSize, this->Offset);
  }
}

//------------------------------------------------------------------------------
/// Returns twice the reach of a pulse, in range.
double Receiver::Search::GetGap() const
{
  return SpeedOfLight * this->BinSize * static_cast<double>(this->Shape.GetReach() + 1);
}

//------------------------------------------------------------------------------
bool Receiver::FindMaxima(const std::vector<SubReturn>& returns, std::vector<Echo>& echoes)
{
  const Search search{ this->DetectionShape, this->Settings.DetectionBin, true };
  this->WasCut = false;
  const Iterator begin = returns.data();
  const Iterator end = begin + returns.size();
  const Limits limits = GetLimits(begin, end);
  const double samples = TwoWayTime(limits.Farthest - limits.Nearest) / search.BinSize;
  const bool isLong = samples > 0.5 * static_cast<double>(this->Settings.MaximumCount);
  this->IsSorted = !this->Settings.HasLimit && (isLong || returns.size() > Many);
  return this->IsSorted ? this->FindMaximaApart(returns, search, echoes)
                        : this->FindMaxima(begin, end, limits, search, echoes);
}

//------------------------------------------------------------------------------
/// Finds the maxima of many returns, or of returns too far apart for one window: each group has its
/// own.
bool Receiver::FindMaximaApart(
  const std::vector<SubReturn>& returns, const Search& search, std::vector<Echo>& echoes)
{
  this->Sorted = returns;
  std::stable_sort(this->Sorted.begin(), this->Sorted.end(),
    [](const SubReturn& a, const SubReturn& b) { return a.Range < b.Range; });
  const double gap = search.GetGap();
  const Iterator end = this->Sorted.data() + this->Sorted.size();
  bool isBinned = false;
  for (Iterator first = this->Sorted.data(), last = first; first != end; first = last)
  {
    do
    {
      ++last;
    } while (last != end && last->Range - (last - 1)->Range <= gap);
    isBinned |= !this->FindMaxima(first, last, GetLimits(first, last), search, echoes);
  }
  return !isBinned;
}

//------------------------------------------------------------------------------
/// Finds the maxima of returns in one window.
bool Receiver::FindMaxima(Iterator begin, Iterator end, const Limits& limits, const Search& search,
  std::vector<Echo>& echoes)
{
  if (limits.Farthest - limits.Nearest <= 2.0 * this->SigmaRange)
  {
    this->FindSingleEcho(begin, end, limits, echoes);
    return true;
  }
  bool isBinned = false;
  if (!this->FindInGroups(begin, end, limits, search, echoes, isBinned))
  {
    this->WasCut = this->OpenWindow(limits, search.BinSize) || this->WasCut;
    this->FillAll(begin, end, search.Shape);
    this->SetSamples(this->GetWindow());
    this->Detect(begin, end, search.BinSize, echoes);
  }
  return !isBinned;
}

//------------------------------------------------------------------------------
Receiver::Limits Receiver::GetLimits(Iterator begin, Iterator end)
{
  Limits limits{ begin->Range, begin->Range };
  for (Iterator r = begin + 1; r != end; ++r)
  {
    limits.Nearest = std::min(limits.Nearest, r->Range);
    limits.Farthest = std::max(limits.Farthest, r->Range);
  }
  return limits;
}

//------------------------------------------------------------------------------
/// Finds the echo of the returns within limits; no other return is as near to it.
void Receiver::FindSingleEcho(
  Iterator begin, Iterator end, const Limits& limits, std::vector<Echo>& echoes)
{
  this->Maximum.Open(static_cast<std::size_t>(end - begin));
  for (Iterator r = begin; r != end; ++r)
  {
    this->Maximum.Add(
      r->Range, r->Power, (r->Range >= limits.Nearest) & (r->Range <= limits.Farthest));
  }
  SingleMaximum::Result peak;
  if (!this->Maximum.Find(this->SigmaRange, peak) ||
    peak.Value < this->Settings.Detector->GetDetectionThreshold())
  {
    return;
  }
  const double widening = 4.0 / (SpeedOfLight * SpeedOfLight) * peak.Variance; // [ns^2]
  echoes.push_back(
    { peak.Place, peak.Value, FwhmPerSigma * std::sqrt(this->Sigma * this->Sigma + widening),
      FindNearestSurface(begin, end, peak.Place, this->SigmaRange) });
}

//------------------------------------------------------------------------------
void Receiver::MergeReturns(const std::vector<SubReturn>& returns, std::vector<Echo>& echoes) const
{
  double power = 0.0;
  double first = 0.0;
  double second = 0.0;
  const double origin = returns.front().Range;
  for (const SubReturn& r : returns)
  {
    const double range = r.Range - origin;
    power += r.Power;
    first += r.Power * range;
    second += r.Power * range * range;
  }
  if (!(power > 0.0) || power < this->Settings.Detector->GetDetectionThreshold())
  {
    return;
  }
  const double mean = first / power;
  const double variance = std::max(0.0, second / power - mean * mean);
  const double widening = 4.0 / (SpeedOfLight * SpeedOfLight) * variance; // [ns^2]
  echoes.push_back(
    { origin + mean, power, FwhmPerSigma * std::sqrt(this->Sigma * this->Sigma + widening),
      FindNearestSurface(
        returns.data(), returns.data() + returns.size(), origin + mean, this->SigmaRange) });
}

//------------------------------------------------------------------------------
bool Receiver::FindBinnedMaxima(const std::vector<SubReturn>& returns, std::vector<Echo>& echoes)
{
  const Iterator begin = returns.data();
  const Iterator end = begin + returns.size();
  this->IsSorted = false;
  bool isBinned;
  return this->FindInGroups(begin, end, GetLimits(begin, end),
    { this->Settings.Shape, this->Settings.BinSize, false }, echoes, isBinned);
}

//------------------------------------------------------------------------------
/// Groups of returns that do not overlap are processed separately; sets whether one was binned.
bool Receiver::FindInGroups(Iterator begin, Iterator end, const Limits& limits,
  const Search& search, std::vector<Echo>& echoes, bool& isBinned)
{
  const std::size_t before = echoes.size();
  const double gap = search.GetGap();
  bool isGood = !this->OpenWindow(limits, search.BinSize);
  isBinned = false;
  this->MakeClusters(begin, end);
  const std::size_t count = this->Clusters.size();
  for (std::size_t first = 0, last = 0; first < count && isGood; first = last)
  {
    do
    {
      ++last;
    } while (
      last < count && this->Clusters[last].Nearest - this->Clusters[last - 1].Farthest <= gap);
    const PulseCluster& nearest = this->Clusters[first];
    const PulseCluster& farthest = this->Clusters[last - 1];
    if (search.KnowsSingles && farthest.Farthest - nearest.Nearest <= 2.0 * this->SigmaRange)
    {
      this->FindSingleEcho(begin, end, { nearest.Nearest, farthest.Farthest }, echoes);
      continue;
    }
    isBinned = true;
    const BinRange bins = this->GetBinsOfMaxima(nearest, farthest, search.BinSize);
    this->FillGroup(first, last, search.Shape, bins);
    this->SetSamples(bins);
    isGood = this->FindPeaksIn(bins, search, begin, end, echoes);
  }
  if (!isGood)
  {
    echoes.erase(echoes.begin() + static_cast<std::ptrdiff_t>(before), echoes.end());
  }
  return isGood;
}

//------------------------------------------------------------------------------
/// Finds the echoes at the maxima in filled bins; false if a maximum lies at their end.
bool Receiver::FindPeaksIn(const BinRange& bins, const Search& search, Iterator begin, Iterator end,
  std::vector<Echo>& echoes)
{
  const vtkHeliosWaveform wave{ this->Wave.Samples.data(), this->GetWindow().Last, search.BinSize,
    search.Shape.GetLength() };
  const double threshold = this->Settings.Detector->GetDetectionThreshold();
  const bool isGood = FindPeaks(wave, threshold, bins, this->Peaks);
  for (const Peak& peak : this->Peaks)
  {
    vtkHeliosDetectedEcho echo = FitPeak(wave, peak);
    const auto [first, last] = this->GetNear(begin, end, echo.Time);
    if (search.KnowsSingles &&
      static_cast<std::size_t>(last - first) <= this->Settings.MaximumRefined)
    {
      this->Refine(first, last, search.BinSize, echo);
    }
    this->AddEcho(echo, first, last, echoes);
  }
  return isGood;
}

//------------------------------------------------------------------------------
/// Returns the returns that contribute to the sum at a time in the window; all of them, if not
/// sorted.
std::pair<Receiver::Iterator, Receiver::Iterator> Receiver::GetNear(
  Iterator begin, Iterator end, double time) const
{
  if (!this->IsSorted)
  {
    return { begin, end };
  }
  const double range = GetRange(this->Wave.StartTime, time);
  const double reach = (FarInSigma + 2.0) * this->SigmaRange; // two bins more, at least
  const auto isNearer = [](const SubReturn& r, double limit) { return r.Range < limit; };
  const Iterator first = std::lower_bound(begin, end, range - reach, isNearer);
  const Iterator last = std::lower_bound(first, end, range + reach, isNearer);
  return first != last ? std::make_pair(first, last) : std::make_pair(begin, end);
}

//------------------------------------------------------------------------------
/**
 * Moves the maximum near a bin to the maximum of the sum of Gaussians, by Newton's method on its
 * logarithm: where two echoes nearly merge, the parabola through three bins is not good enough.
 */
void Receiver::Refine(
  Iterator begin, Iterator end, double binSize, vtkHeliosDetectedEcho& echo) const
{
  const double scale = 1.0 / this->Sigma;
  double u = 0.0; // from the bins' maximum, in sigma
  double value = 0.0;
  for (int iteration = 0; iteration < MaximumIterations; ++iteration)
  {
    double w0 = 0.0;
    double w1 = 0.0;
    double w2 = 0.0;
    for (Iterator r = begin; r != end; ++r)
    {
      const double away = (echo.Time - this->GetTime(r->Range)) * scale + u;
      if (std::abs(away) < FarInSigma)
      {
        const double w = r->Power * std::exp(-0.5 * away * away);
        w0 += w;
        w1 += w * away;
        w2 += w * away * away;
      }
    }
    const double slope = w1 / w0;
    const double curvature = 1.0 - (w2 / w0 - slope * slope);
    const double step = slope / curvature;
    if (!(curvature > 0.0) || !(std::abs(u - step) <= 2.0 * binSize * scale))
    {
      return; // no maximum within two bins: the one of the bins stays
    }
    value = w0 * (1.0 + 0.5 * slope * step);
    u -= step;
    if (std::abs(step) < 1e-5) // the next step would be its square
    {
      break;
    }
  }
  echo.Time += u * this->Sigma;
  echo.Amplitude = value;
}

//------------------------------------------------------------------------------
bool Receiver::Fill(const std::vector<SubReturn>& returns, double background, vtkIdType pulseId)
{
  const SubReturn* begin = returns.data();
  const SubReturn* end = begin + returns.size();
  const bool cut = this->OpenWindow(GetLimits(begin, end), this->Settings.BinSize);
  this->FillAll(begin, end, this->Settings.Shape);
  this->AddNoise(background, pulseId);
  this->SetSamples(this->GetWindow());
  return cut;
}

//------------------------------------------------------------------------------
bool Receiver::Fill(const PlaneEcho& echo, double background, vtkIdType pulseId)
{
  const PulseShape& shape = this->Settings.Shape;
  const double widening = shape.IsGaussian() ? echo.Sigma / this->Sigma : 1.0;
  const bool cut = this->OpenWindow(echo.Range, echo.Range, widening, this->Settings.BinSize);
  for (std::size_t i = 0; i < this->Wave.Samples.size(); ++i)
  {
    const double time = static_cast<double>(i) * this->Settings.BinSize - this->Margin;
    this->Sum[i] = echo.Power * shape(time / widening);
  }
  this->AddNoise(background, pulseId);
  this->SetSamples(this->GetWindow());
  return cut;
}

//------------------------------------------------------------------------------
void Receiver::FillEmpty(vtkIdType pulseId)
{
  this->PulseId = pulseId;
  this->Wave.StartTime = this->Settings.GateStart;
  this->Wave.Samples.clear();
}

//------------------------------------------------------------------------------
/// Allocates the window for the pulses of returns; true if it was cut.
bool Receiver::OpenWindow(const Limits& limits, double binSize)
{
  return this->OpenWindow(limits.Nearest, limits.Farthest, 1.0, binSize);
}

//------------------------------------------------------------------------------
/// Allocates the window for the pulses of returns between two ranges; true if it was cut.
bool Receiver::OpenWindow(double nearest, double farthest, double widening, double binSize)
{
  const PulseShape& shape = this->Settings.Shape;
  const double before =
    shape.IsGaussian() ? MarginInSigma * widening * this->Sigma : binSize - shape.GetStart();
  const double after = shape.IsGaussian() ? before : shape.GetEnd();
  this->Nearest = nearest;
  this->Margin = before;
  this->Wave.StartTime = TwoWayTime(nearest) - before;
  const double length = before + TwoWayTime(farthest - nearest) + after;
  const double wanted = std::ceil(length / binSize) + 1.0;
  const bool cut = !(wanted <= static_cast<double>(this->Settings.MaximumCount)); // or NaN
  const auto count =
    static_cast<std::size_t>(cut ? static_cast<double>(this->Settings.MaximumCount) : wanted);
  this->Wave.Samples.resize(count);
  this->Sum.resize(std::max(this->Sum.size(), count));
  return cut;
}

//------------------------------------------------------------------------------
/**
 * Returns the bins where the sum of the Gaussians of returns may have maxima, and their neighbours:
 * it rises up to the first return and falls after the last.
 */
BinRange Receiver::GetBinsOfMaxima(
  const PulseCluster& first, const PulseCluster& last, double binSize) const
{
  const auto from = static_cast<vtkIdType>(this->GetTime(first.Nearest) / binSize) - 2;
  const auto to = static_cast<vtkIdType>(this->GetTime(last.Farthest) / binSize) + 4;
  return { std::max<vtkIdType>(0, from), std::min(to, this->GetWindow().Last) };
}

//------------------------------------------------------------------------------
/// Returns the time of a return at a range, in the window [ns].
double Receiver::GetTime(double range) const
{
  return TwoWayTime(range - this->Nearest) + this->Margin;
}

//------------------------------------------------------------------------------
/// Groups nearly coincident returns, in order of time.
HELIOS_CLONES
void Receiver::MakeClusters(Iterator begin, Iterator end)
{
  const double scale = 1.0 / this->Sigma;
  const double slotsPerTime = 0.5 * scale / PulseCluster::Reach;
  const double margin = this->Margin;
  this->Clusters.clear();
  PulseCluster none{ -1, 0.0, 0.0, 0.0 };
  PulseCluster* cluster = &none; // the next sub-ray often has the same time
  double nearest = 0.0;
  double farthest = 0.0;
  Powers low = Powers(); // its sums
  Powers high = Powers();
  constexpr std::size_t half = PulseCluster::Order / 2;
  const auto keep = [&]
  {
    cluster->Nearest = nearest;
    cluster->Farthest = farthest;
    Store(cluster->Sums, low);
    Store(cluster->Sums + half, high);
  };
  for (Iterator r = begin; r != end; ++r)
  {
    const double time = this->GetTime(r->Range);
    const auto slot = static_cast<vtkIdType>((time - margin) * slotsPerTime);
    if (cluster->Slot != slot)
    {
      keep();
      cluster = &this->GetCluster(slot);
      nearest = cluster->Nearest;
      farthest = cluster->Farthest;
      low = Load<Powers>(cluster->Sums);
      high = Load<Powers>(cluster->Sums + half);
    }
    nearest = std::min(nearest, r->Range);
    farthest = std::max(farthest, r->Range);
    const double away = (time - cluster->Time) * scale;
    const double away2 = away * away;
    Powers powers;
    SetPowers(away, powers);
    powers = r->Power * powers;
    low += powers;
    high += powers * (away2 * away2);
  }
  keep();
  this->ForgetPlaces();
  std::sort(this->Clusters.begin(), this->Clusters.end(),
    [](const PulseCluster& a, const PulseCluster& b) { return a.Slot < b.Slot; });
}

//------------------------------------------------------------------------------
/// Clears the places of the clusters by slot.
void Receiver::ForgetPlaces()
{
  for (const PulseCluster& cluster : this->Clusters)
  {
    if (cluster.Slot >= 0 && cluster.Slot < static_cast<vtkIdType>(this->NearClusters.size()))
    {
      this->NearClusters[static_cast<std::size_t>(cluster.Slot)] = -1;
    }
  }
  if (!this->FarClusters.empty())
  {
    this->FarClusters.clear();
  }
}

//------------------------------------------------------------------------------
/// Returns the cluster of a slot.
PulseCluster& Receiver::GetCluster(vtkIdType slot)
{
  const auto count = static_cast<int>(this->Clusters.size());
  const bool isNear = slot >= 0 && slot < static_cast<vtkIdType>(this->NearClusters.size());
  int& place = isNear ? this->NearClusters[static_cast<std::size_t>(slot)]
                      : this->FarClusters.try_emplace(slot, -1).first->second;
  if (place >= 0)
  {
    return this->Clusters[static_cast<std::size_t>(place)];
  }
  place = count;
  this->Clusters.push_back(
    { slot, this->DetectionShape.GetSlotTime(slot), VTK_DOUBLE_MAX, -VTK_DOUBLE_MAX });
  return this->Clusters.back();
}

//------------------------------------------------------------------------------
/// Fills a window with the pulses of some clusters.
void Receiver::FillGroup(
  std::size_t first, std::size_t last, const PulseShape& shape, const BinRange& bins)
{
  std::fill(this->Sum.begin() + bins.First, this->Sum.begin() + bins.Last, 0.0);
  for (std::size_t i = first; i < last; ++i)
  {
    shape.Deposit(this->Clusters[i], this->Sum.data(), bins);
  }
}

//------------------------------------------------------------------------------
/// Fills the current window with returns; nearly coincident ones of a Gaussian, together.
void Receiver::FillAll(Iterator begin, Iterator end, const PulseShape& shape)
{
  const BinRange bins = this->GetWindow();
  std::fill_n(this->Sum.begin(), bins.Last, 0.0);
  if (shape.IsGaussian())
  {
    this->MakeClusters(begin, end);
    for (const PulseCluster& cluster : this->Clusters)
    {
      shape.Deposit(cluster, this->Sum.data(), bins);
    }
    return;
  }
  for (Iterator r = begin; r != end; ++r)
  {
    shape.Deposit(this->GetTime(r->Range), r->Power, this->Sum.data(), bins);
  }
}

//------------------------------------------------------------------------------
void Receiver::AddNoise(double background, vtkIdType pulseId)
{
  this->PulseId = pulseId;
  if (background != 0.0)
  {
    std::for_each(this->Sum.begin(), this->Sum.begin() + this->GetWindow().Last,
      [background](double& sample) { sample += background; });
  }
  const std::size_t count = this->Wave.Samples.size();
  for (std::size_t i = 0; this->Settings.Noise > 0.0 && i < count; i += 2)
  {
    const auto noise = NormalPair(this->Settings.Seed, RandomStream::DetectorNoise,
      static_cast<std::uint64_t>(pulseId), static_cast<std::uint32_t>(i / 2));
    this->Sum[i] += this->Settings.Noise * noise[0];
    if (i + 1 < count)
    {
      this->Sum[i + 1] += this->Settings.Noise * noise[1];
    }
  }
}

//------------------------------------------------------------------------------
void Receiver::SetSamples(const BinRange& bins)
{
  std::transform(this->Sum.begin() + bins.First, this->Sum.begin() + bins.Last,
    this->Wave.Samples.begin() + bins.First,
    [maximum = this->Settings.Saturation](double value)
    { return static_cast<float>(std::min(value, maximum)); });
}

//------------------------------------------------------------------------------
void Receiver::DetectEchoes(const std::vector<SubReturn>& returns, std::vector<Echo>& echoes)
{
  this->Detect(returns.data(), returns.data() + returns.size(), this->Settings.BinSize, echoes);
}

//------------------------------------------------------------------------------
void Receiver::Detect(Iterator begin, Iterator end, double binSize, std::vector<Echo>& echoes)
{
  std::vector<vtkHeliosDetectedEcho>& detected = this->Detected.front();
  detected.clear();
  const vtkHeliosWaveform wave = this->Describe(this->Wave, this->PulseId, binSize);
  if (this->Settings.Detector->PrefersBlocks())
  {
    this->DetectWaveforms({ wave }, this->Detected);
  }
  else
  {
    this->Settings.Detector->Detect(wave, detected);
  }
  for (const vtkHeliosDetectedEcho& echo : detected)
  {
    this->AddEcho(echo, begin, end, echoes);
  }
}

//------------------------------------------------------------------------------
void Receiver::DetectAll(const std::vector<std::pair<const Waveform*, vtkIdType>>& waveforms,
  std::vector<std::vector<vtkHeliosDetectedEcho>>& detected)
{
  std::vector<vtkHeliosWaveform> described;
  for (const auto& [wave, pulseId] : waveforms)
  {
    described.push_back(this->Describe(*wave, pulseId, this->Settings.BinSize));
  }
  detected.assign(waveforms.size(), {});
  this->DetectWaveforms(described, detected);
}

//------------------------------------------------------------------------------
void Receiver::AddEchoes(const std::vector<vtkHeliosDetectedEcho>& detected,
  const std::vector<SubReturn>& returns, std::vector<Echo>& echoes) const
{
  for (const vtkHeliosDetectedEcho& echo : detected)
  {
    this->AddEcho(echo, returns.data(), returns.data() + returns.size(), echoes);
  }
}

//------------------------------------------------------------------------------
/// Returns a waveform of a pulse as a detector reads it.
vtkHeliosWaveform Receiver::Describe(const Waveform& wave, vtkIdType pulseId, double binSize) const
{
  return { wave.Samples.data(), static_cast<vtkIdType>(wave.Samples.size()), binSize,
    this->Settings.Shape.GetLength(), this->Settings.GateStart - wave.StartTime,
    this->Settings.GateStop - wave.StartTime, this->Settings.Seed,
    static_cast<std::uint64_t>(pulseId) };
}

//------------------------------------------------------------------------------
/// Calls the detector, and keeps its first error.
void Receiver::DetectWaveforms(const std::vector<vtkHeliosWaveform>& waveforms,
  std::vector<std::vector<vtkHeliosDetectedEcho>>& detected)
{
  std::string error;
  const bool isDone = this->Settings.Detector->DetectAll(waveforms, detected, error);
  this->Fault = isDone || !this->Fault.IsOk() ? this->Fault : Status::Error(error);
}

//------------------------------------------------------------------------------
void Receiver::AddEcho(const vtkHeliosDetectedEcho& detected, Iterator begin, Iterator end,
  std::vector<Echo>& echoes) const
{
  const double range = GetRange(this->Wave.StartTime, detected.Time - this->Offset);
  const bool isDark = detected.IsDark || begin == end;
  echoes.push_back({ range, detected.Amplitude, detected.Width,
    isDark ? nullptr : FindNearestSurface(begin, end, range, this->SigmaRange),
    detected.Deviation });
}

} // namespace helios
