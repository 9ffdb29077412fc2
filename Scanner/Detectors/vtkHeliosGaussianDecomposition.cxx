// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkHeliosGaussianDecomposition.h"

#include "heliosConstants.h"
#include "heliosGaussianFit.h"
#include "heliosPeaks.h"

#include <vtkObjectFactory.h>

#include <algorithm>
#include <cmath>
#include <limits>

vtkStandardNewMacro(vtkHeliosGaussianDecomposition);

namespace
{

using helios::GaussianComponent;
using Components = std::vector<GaussianComponent>;

// Lengths in sigma of a component: the reach of the fitted samples, and of the residuals evaluated.
constexpr double FitReach = 4.0;
constexpr double DeviationReach = 2.0;

// The maximum number of echoes fitted together: the work grows with the cube.
constexpr std::size_t MaximumTogether = 12;

// Lengths in sigma of the pulse: the reach of the samples of an initial guess, and its maximum
// width.
constexpr double GuessReach = 1.0;
constexpr double WidestGuess = 20.0;

// The evidence required for an echo wider than the pulse (Bayesian information criterion: Raftery
// 1995, Sociological Methodology 25, 111-163: very strong).
constexpr double StrongEvidence = 10.0;

// Samples are stored as float: residuals below this fraction of the largest are rounding.
constexpr double Rounding = 6e-8;

/// Memory that a thread reuses for all waveforms.
struct Scratch
{
  std::vector<helios::Peak> Peaks;
  std::vector<vtkHeliosDetectedEcho> Guesses;
  helios::GaussianData Data;
  helios::GaussianData Near; // near one component
  helios::GaussianFit Fit;
  Components Start, Best, Trial;
};

/// Fits the echoes of one waveform; x is time over the pulse's sigma, y over the largest sample.
class Decomposition
{
public:
  Decomposition(const vtkHeliosWaveform& waveform, Scratch& scratch)
    : Waveform(waveform)
    , Work(scratch)
    , Sigma(waveform.PulseLength / helios::FwhmPerSigma)
  {
  }

  bool ResolveHidden = false;
  bool FitBackground = false;
  int MaximumEvaluations = 0;

  void Run(std::vector<vtkHeliosDetectedEcho>& echoes)
  {
    this->MakeGuesses();
    const std::size_t count = this->Work.Peaks.size();
    for (std::size_t first = 0; first < count;)
    {
      std::size_t last = first + 1;
      while (last < count && last - first < MaximumTogether &&
        this->GetStart(last) < this->GetEnd(first, last))
      {
        ++last;
      }
      this->RunGroup(first, last, echoes);
      first = last;
    }
  }

private:
  const vtkHeliosWaveform& Waveform;
  Scratch& Work;
  double Sigma;       // sigma of the pulse [ns]
  double Largest = 0; // sample of a group [W]

  /// Guesses the Gaussians of the maxima; overlapping neighbours no wider than their distance.
  void MakeGuesses()
  {
    const auto& peaks = this->Work.Peaks;
    auto& guesses = this->Work.Guesses;
    guesses.clear();
    for (const helios::Peak& peak : peaks)
    {
      guesses.push_back(helios::FitPeak(this->Waveform, peak, GuessReach * this->Sigma));
    }
    for (std::size_t i = 0; i < guesses.size(); ++i)
    {
      double widest = WidestGuess * this->Sigma;
      for (const std::size_t other : { i - 1, i + 1 }) // 0 - 1 is out of range, too
      {
        if (other < guesses.size())
        {
          widest = std::min(widest, 0.5 * std::abs(guesses[other].Time - guesses[i].Time));
        }
      }
      const double sigma = guesses[i].Width / helios::FwhmPerSigma;
      this->Sigmas.resize(guesses.size());
      this->Sigmas[i] = std::max(this->Sigma, std::min(sigma, widest));
    }
  }

  double GetStart(std::size_t i) const
  {
    return this->Work.Guesses[i].Time - FitReach * this->Sigmas[i];
  }

  /// Returns the last end of the windows of [first, last).
  double GetEnd(std::size_t first, std::size_t last) const
  {
    double end = 0.0;
    for (std::size_t i = first; i < last; ++i)
    {
      end = std::max(end, this->Work.Guesses[i].Time + FitReach * this->Sigmas[i]);
    }
    return end;
  }

  void ReadSamples(std::size_t first, std::size_t last)
  {
    const double bin = this->Waveform.BinSize;
    double start = this->GetStart(first);
    for (std::size_t i = first; i < last; ++i)
    {
      start = std::min(start, this->GetStart(i));
    }
    const auto begin = static_cast<vtkIdType>(std::max(0.0, std::ceil(start / bin)));
    const auto end = static_cast<vtkIdType>(std::min(static_cast<double>(this->Waveform.Count),
      std::floor(this->GetEnd(first, last) / bin) + 1.0));
    this->Largest = 0.0;
    for (std::size_t i = first; i < last; ++i)
    {
      this->Largest =
        std::max<double>(this->Largest, this->Waveform.Samples[this->Work.Peaks[i].First]);
    }
    helios::GaussianData& data = this->Work.Data;
    data.X.clear();
    data.Y.clear();
    data.HasBackground = this->FitBackground;
    data.Background = 0.0;
    for (vtkIdType i = begin; i < end; ++i)
    {
      const double sample = this->Waveform.Samples[i] / this->Largest;
      if (std::isfinite(sample))
      {
        data.X.push_back(static_cast<double>(i) * bin / this->Sigma);
        data.Y.push_back(sample);
      }
    }
  }

  void RunGroup(std::size_t first, std::size_t last, std::vector<vtkHeliosDetectedEcho>& echoes)
  {
    this->ReadSamples(first, last);
    Components& best = this->Work.Best;
    best.clear();
    for (std::size_t i = first; i < last; ++i)
    {
      const vtkHeliosDetectedEcho& guess = this->Work.Guesses[i];
      best.push_back({ guess.Amplitude / this->Largest, guess.Time / this->Sigma,
        this->Sigmas[i] / this->Sigma });
    }
    PushApart(best);
    this->Work.Start = best;
    const bool converged = this->Work.Fit.Run(this->Work.Data, best, this->MaximumEvaluations);
    for (std::size_t i = 0; converged && this->ResolveHidden && i < last - first; ++i)
    {
      this->Resolve(i);
    }
    for (std::size_t i = 0; i < best.size(); ++i)
    {
      const bool isPeak = i < last - first; // components found later are appended
      const bool isSound = converged && (!isPeak || this->IsSound(i));
      echoes.push_back(isSound ? this->MakeEcho(best[i])
                               : helios::FitPeak(this->Waveform, this->Work.Peaks[first + i]));
    }
  }

  /// Moves centres apart. Two Gaussians have two maxima only if their centres are two sigma apart
  /// or more: nearer maxima are flat ones between these.
  static void PushApart(Components& components)
  {
    for (std::size_t i = 1; i < components.size(); ++i)
    {
      GaussianComponent& a = components[i - 1];
      GaussianComponent& b = components[i];
      const double missing = 2.0 - (b.Centre - a.Centre);
      if (missing > 0.0)
      {
        a.Centre -= 0.5 * missing;
        b.Centre += 0.5 * missing;
        a.Sigma = b.Sigma = 1.0;
      }
    }
  }

  /// Returns whether a component is within its bounds, not on them.
  bool IsSound(std::size_t i) const
  {
    const GaussianComponent& g = this->Work.Best[i];
    const GaussianComponent& from = this->Work.Start[i];
    return g.Amplitude > 1e-3 * from.Amplitude && g.Amplitude < 1e3 * from.Amplitude &&
      std::abs(g.Centre - from.Centre) < 0.99 * helios::GaussianFit::Reach &&
      g.Sigma > 1.02 * helios::GaussianFit::SmallestSigma && g.Sigma < 2.0 * WidestGuess;
  }

  vtkHeliosDetectedEcho MakeEcho(const GaussianComponent& g) const
  {
    const helios::GaussianData& data = this->Work.Data;
    double sum = 0.0;
    int count = 0;
    for (std::size_t i = 0; i < data.X.size(); ++i)
    {
      if (std::abs(data.X[i] - g.Centre) <= DeviationReach * g.Sigma)
      {
        const double rest = data.Y[i] - helios::EvaluateGaussians(data, this->Work.Best, data.X[i]);
        sum += rest * rest;
        ++count;
      }
    }
    return { g.Centre * this->Sigma, g.Amplitude * this->Largest,
      helios::FwhmPerSigma * g.Sigma * this->Sigma, std::sqrt(sum / count) / g.Amplitude };
  }

  /// Returns the sum of squares of a trial fit, at least the rounding error; infinite if it failed.
  double FitTrial()
  {
    return this->Work.Fit.Run(this->Work.Near, this->Work.Trial, this->MaximumEvaluations)
      ? this->GetResidual(this->Work.Trial)
      : std::numeric_limits<double>::infinity();
  }

  double GetResidual(const Components& components) const
  {
    const helios::GaussianData& data = this->Work.Near;
    return std::max(helios::SumSquares(data, components),
      static_cast<double>(data.X.size()) * Rounding * Rounding);
  }

  /// Gets the signal of a component: the samples near it without the others and the background.
  void IsolateComponent(std::size_t i)
  {
    const helios::GaussianData& data = this->Work.Data;
    Components others = this->Work.Best;
    const GaussianComponent g = others[i];
    others.erase(others.begin() + static_cast<std::ptrdiff_t>(i));
    helios::GaussianData& near = this->Work.Near;
    near.X.clear();
    near.Y.clear();
    for (std::size_t k = 0; k < data.X.size(); ++k)
    {
      if (std::abs(data.X[k] - g.Centre) <= FitReach * std::max(1.0, g.Sigma))
      {
        near.X.push_back(data.X[k]);
        near.Y.push_back(data.Y[k] - helios::EvaluateGaussians(data, others, data.X[k]));
      }
    }
  }

  /// Returns the minimum residual of any smooth curve in the samples of a component: half the
  /// squared differences of neighbours, the estimate of noise (von Neumann 1941, Ann. Math. Stat.
  /// 12, 367-395).
  double GetRough(const Components& one) const
  {
    const helios::GaussianData& data = this->Work.Near;
    double sum = 0.0, before = 0.0;
    for (std::size_t k = 0; k < data.X.size(); ++k)
    {
      const double rest = data.Y[k] - helios::EvaluateGaussians(data, one, data.X[k]);
      sum += k > 0 ? 0.5 * (rest - before) * (rest - before) : 0.0;
      before = rest;
    }
    return sum;
  }

  /**
   * Replaces a component by two of the pulse's width if their residual is not significantly larger
   * and it is significantly wider than the pulse; or if their residual is significantly smaller.
   */
  void Resolve(std::size_t i)
  {
    this->IsolateComponent(i);
    const Components one = { this->Work.Best[i] };
    const auto count = static_cast<double>(this->Work.Near.X.size());
    const double left = this->GetResidual(one);
    if (left <= count * 100.0 * Rounding * Rounding)
    {
      return; // no residual to explain
    }
    const auto isBetter = [count](double less, double more)
    { return count * std::log(more / less) - std::log(count) > StrongEvidence; };
    this->Work.Trial = one;
    this->Work.Trial[0].Sigma = 1.0;
    this->Work.Trial[0].IsSigmaFixed = true;
    const Components narrow = this->Work.Trial;
    const double leftNarrow = this->FitTrial();
    const Components fitted = this->Work.Trial;
    const bool isWide = one[0].Sigma > 1.0 && isBetter(left, leftNarrow);
    if (!isWide && !isBetter(0.8 * this->GetRough(one), left))
    {
      return;
    }
    const double spread = std::sqrt(std::max(0.1, one[0].Sigma * one[0].Sigma - 1.0));
    double minimum = left * (1.0 + 4.0 / count);
    Components two;
    for (const bool isAtRest : { false, true })
    {
      this->Work.Trial = isAtRest ? fitted : narrow;
      isAtRest ? this->AddAtRest() : this->Split(spread);
      const double leftTwo = this->FitTrial();
      if (leftTwo < minimum && (isWide || isBetter(leftTwo, left)))
      {
        minimum = leftTwo;
        two = this->Work.Trial;
      }
    }
    if (!two.empty())
    {
      this->Accept(i, two);
    }
  }

  /// Replaces a component by two, and fits all again.
  void Accept(std::size_t i, const Components& two)
  {
    this->Work.Trial = this->Work.Best;
    this->Work.Trial[i] = two[0];
    this->Work.Trial.push_back(two[1]);
    this->Work.Best = this->Work.Trial;
    if (this->Work.Fit.Run(this->Work.Data, this->Work.Trial, this->MaximumEvaluations))
    {
      this->Work.Best = this->Work.Trial;
    }
  }

  /// Splits the trial's component into two halves, offset by spread to either side.
  void Split(double spread)
  {
    GaussianComponent half = this->Work.Trial[0];
    half.Amplitude *= 0.6;
    half.Centre += spread;
    this->Work.Trial[0].Amplitude = half.Amplitude;
    this->Work.Trial[0].Centre -= spread;
    this->Work.Trial.push_back(half);
  }

  /// Adds a second component at the largest residual of the trial.
  void AddAtRest()
  {
    const helios::GaussianData& data = this->Work.Near;
    GaussianComponent second = this->Work.Trial[0];
    double maximum = 1e-3 * second.Amplitude;
    for (std::size_t k = 0; k < data.X.size(); ++k)
    {
      const double rest = data.Y[k] - helios::EvaluateGaussians(data, this->Work.Trial, data.X[k]);
      if (rest > maximum)
      {
        maximum = rest;
        second.Centre = data.X[k];
      }
    }
    second.Amplitude = maximum;
    this->Work.Trial.push_back(second);
  }

  std::vector<double> Sigmas; // sigmas of the guesses [ns]
};

/// Removes maxima below a fraction of the largest one, or of one before them by at most a time [ns].
void RemoveSmall(const vtkHeliosWaveform& waveform, double fraction, double ringing,
  std::vector<helios::Peak>& peaks)
{
  const auto getSample = [&waveform](const helios::Peak& peak)
  { return static_cast<double>(waveform.Samples[peak.First]); };
  const auto isSmall = [&, all = peaks](const helios::Peak& peak)
  {
    return std::any_of(all.begin(), all.end(),
      [&](const helios::Peak& other)
      {
        const double after = waveform.BinSize * static_cast<double>(peak.First - other.First);
        const bool isReached = ringing == 0.0 || (after > 0.0 && after <= ringing);
        return isReached && getSample(peak) < fraction * getSample(other);
      });
  };
  peaks.erase(std::remove_if(peaks.begin(), peaks.end(), isSmall), peaks.end());
}

} // namespace

//------------------------------------------------------------------------------
void vtkHeliosGaussianDecomposition::SetInstrument(const vtkHeliosInstrumentData& instrument)
{
  this->Superclass::SetInstrument(instrument);
  this->SetMinimumSeparation(instrument.PeakWindow);
}

//------------------------------------------------------------------------------
void vtkHeliosGaussianDecomposition::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "MinimumSeparation: " << this->MinimumSeparation << " ns\n"
     << indent << "ResolveHidden: " << this->ResolveHidden << "\n"
     << indent << "FitBackground: " << this->FitBackground << "\n"
     << indent << "RelativeThreshold: " << this->RelativeThreshold << "\n"
     << indent << "RingingTime: " << this->RingingTime << " ns\n"
     << indent << "MaximumNumberOfIterations: " << this->MaximumNumberOfIterations << "\n";
}

//------------------------------------------------------------------------------
void vtkHeliosGaussianDecomposition::Detect(
  const vtkHeliosWaveform& waveform, std::vector<vtkHeliosDetectedEcho>& echoes) const
{
  static thread_local Scratch scratch;
  helios::FindPeaks(waveform, this->DetectionThreshold, this->MinimumSeparation, scratch.Peaks);
  RemoveSmall(waveform, this->RelativeThreshold, this->RingingTime, scratch.Peaks);
  const std::size_t before = echoes.size();
  Decomposition decomposition(waveform, scratch);
  decomposition.ResolveHidden = this->ResolveHidden;
  decomposition.FitBackground = this->FitBackground;
  decomposition.MaximumEvaluations = this->MaximumNumberOfIterations;
  decomposition.Run(echoes);
  std::stable_sort(echoes.begin() + static_cast<std::ptrdiff_t>(before), echoes.end(),
    [](const vtkHeliosDetectedEcho& a, const vtkHeliosDetectedEcho& b) { return a.Time < b.Time; });
  this->RemoveDead(echoes, before);
}
