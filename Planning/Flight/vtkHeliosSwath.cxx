// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkHeliosSwath.h"

#include "heliosLegOptics.h"
#include "heliosPose.h"
#include "heliosSurveyData.h"
#include "vtkHeliosBeamDeflector.h"
#include "vtkHeliosSurvey.h"

#include <vtkMath.h>
#include <vtkObjectFactory.h>

#include <algorithm>
#include <cmath>

vtkStandardNewMacro(vtkHeliosSwath);

namespace
{

constexpr int NumberOfBins = 256;
constexpr std::size_t TangentsPerBin = 8; // at least, so that a bin counts evenly
constexpr double GoldenRatio = 0.6180339887498949;

struct Sample
{
  double Across;
  double Along;
  double Rate; // [1/s] that it stands for
};

/// Makes a scan whose lines do not repeat: the pulses per line become n + 0.618.
helios::ScanData MakeDense(const helios::ScanData& scan)
{
  helios::ScanData dense = scan;
  if (scan.ScanFrequency > 0.0)
  {
    const double perLine = std::floor(scan.PulseFrequency / scan.ScanFrequency);
    dense.ScanFrequency = scan.PulseFrequency / (perLine + GoldenRatio);
  }
  return dense;
}

} // namespace

/// The sampled pulses of a leg, and their distribution.
class vtkHeliosSwath::Sampler
{
public:
  explicit Sampler(vtkHeliosSwath* self)
    : Self(self)
    , Steepest(std::tan(vtkMath::RadiansFromDegrees(self->MaximumAngle)))
  {
  }

  /// Adds the pulses of a channel.
  void Add(const helios::ScannerData& scanner, const helios::ScanData& scan,
    const helios::Pose& mount, vtkIdType count)
  {
    const auto deflector = helios::MakeDeflector(scanner, MakeDense(scan));
    const helios::Rotation toBody((mount * scanner.Beam).Orientation);
    for (vtkIdType i = 0; i < count; ++i)
    {
      double d[3];
      if (deflector->GetDirection(i, d))
      {
        this->Add(toBody * helios::Vec3(d), scan.PulseFrequency / static_cast<double>(count));
      }
    }
  }

  bool IsEmpty() const { return this->Samples.size() < 2; }

  /// Sorts the pulses into bins.
  void Store()
  {
    std::sort(this->Samples.begin(), this->Samples.end(),
      [](const Sample& a, const Sample& b) { return a.Across < b.Across; });
    this->MergeEqual();
    const auto bins = std::clamp<std::size_t>(
      this->Tangents.size() / TangentsPerBin, 1, static_cast<std::size_t>(NumberOfBins));
    this->SetEdges();
    this->Self->Rates.assign(bins, 0.0);
    this->Self->Means.assign(bins, 0.0);
    this->Self->Deviations.assign(bins, 0.0);
    this->StoreMoments();
    this->StoreRates();
  }

private:
  struct Tangent
  {
    double Across;
    double Rate;
  };

  void Add(const helios::Vec3& direction, double rate)
  {
    const double across = -direction[0] / direction[2];
    if (direction[2] < 0.0 && std::abs(across) <= this->Steepest)
    {
      this->Samples.push_back({ across, -direction[1] / direction[2], rate });
    }
  }

  void MergeEqual()
  {
    constexpr double same = 1e-12;
    for (const Sample& sample : this->Samples)
    {
      if (this->Tangents.empty() || sample.Across - this->Tangents.back().Across > same)
      {
        this->Tangents.push_back({ sample.Across, 0.0 });
      }
      this->Tangents.back().Rate += sample.Rate;
    }
  }

  /// Sets the edges of the swath: half a step outside the outermost tangents.
  void SetEdges()
  {
    const std::vector<Tangent>& all = this->Tangents;
    const std::size_t last = all.size() - 1;
    const bool isOne = all.size() < 2;
    this->Self->LeftTangent =
      all[0].Across - (isOne ? 1e-6 : 0.5 * (all[1].Across - all[0].Across));
    this->Self->RightTangent =
      all[last].Across + (isOne ? 1e-6 : 0.5 * (all[last].Across - all[last - 1].Across));
  }

  void StoreMoments()
  {
    std::vector<double> rates(this->Self->Rates.size(), 0.0);
    for (const Sample& sample : this->Samples)
    {
      const auto bin = static_cast<std::size_t>(this->Self->FindBin(sample.Across));
      rates[bin] += sample.Rate;
      this->Self->Means[bin] += sample.Rate * sample.Along;
      this->Self->Deviations[bin] += sample.Rate * sample.Along * sample.Along;
      this->Self->PulseRate += sample.Rate;
      this->Self->LargestAlong = std::max(this->Self->LargestAlong, std::abs(sample.Along));
    }
    for (std::size_t bin = 0; bin < rates.size(); ++bin)
    {
      double& mean = this->Self->Means[bin];
      double& deviation = this->Self->Deviations[bin];
      mean = rates[bin] > 0.0 ? mean / rates[bin] : 0.0;
      const double square = rates[bin] > 0.0 ? deviation / rates[bin] - mean * mean : 0.0;
      deviation = std::sqrt(std::max(0.0, square));
    }
  }

  /// Stores the rate of each bin: the pulses of a tangent are spread from halfway to its
  /// neighbours.
  void StoreRates()
  {
    std::vector<double>& rates = this->Self->Rates;
    const double left = this->Self->LeftTangent;
    const double width = (this->Self->RightTangent - left) / static_cast<double>(rates.size());
    const std::vector<Tangent>& all = this->Tangents;
    for (std::size_t i = 0; i < all.size(); ++i)
    {
      const double low = i == 0 ? left : 0.5 * (all[i - 1].Across + all[i].Across);
      const double high =
        i + 1 == all.size() ? this->Self->RightTangent : 0.5 * (all[i].Across + all[i + 1].Across);
      const int first = this->Self->FindBin(low);
      const int last = this->Self->FindBin(high);
      for (int bin = first; bin <= last; ++bin)
      {
        const double begin = std::max(low, left + bin * width);
        const double end = std::min(high, left + (bin + 1) * width);
        rates[static_cast<std::size_t>(bin)] +=
          all[i].Rate * std::max(0.0, end - begin) / (high - low) / width;
      }
    }
  }

  vtkHeliosSwath* Self;
  double Steepest;
  std::vector<Sample> Samples;
  std::vector<Tangent> Tangents;
};

//------------------------------------------------------------------------------
bool vtkHeliosSwath::Build(vtkHeliosSurvey* survey, int leg)
{
  this->PulseRate = 0.0;
  this->LargestAlong = 0.0;
  this->Rates.clear();
  this->Modified();
  if (!survey || leg < 0 || leg >= survey->GetNumberOfLegs())
  {
    vtkErrorMacro(<< "the survey has no leg " << leg << "; give a checked survey, and one of its "
                  << (survey ? survey->GetNumberOfLegs() : 0) << " legs");
    return false;
  }
  const helios::SurveyData& data = survey->GetData();
  const auto index = static_cast<std::size_t>(leg);
  const helios::ScannerData& scanner = data.GetScanner(index);
  const auto channels = static_cast<vtkIdType>(scanner.GetNumberOfChannels());
  Sampler sampler(this);
  for (vtkIdType k = 0; k < channels; ++k)
  {
    const auto channel = static_cast<std::size_t>(k);
    sampler.Add(scanner.GetChannel(channel), data.Legs[index].Scans[channel],
      data.GetPlatform(index).Mount, this->NumberOfSamples / channels);
  }
  if (sampler.IsEmpty())
  {
    vtkErrorMacro(<< "no pulse of scanner " << scanner.Id << " on platform "
                  << data.GetPlatform(index).Id << " points down within " << this->MaximumAngle
                  << " deg of nadir; give a platform whose mount looks down");
    return false;
  }
  sampler.Store();
  this->RangeMin = scanner.Receiver.RangeMin;
  this->RangeMax = scanner.Receiver.RangeMax;
  return true;
}

//------------------------------------------------------------------------------
int vtkHeliosSwath::FindBin(double across) const
{
  const auto bins = static_cast<double>(this->Rates.size());
  const double share = (across - this->LeftTangent) / (this->RightTangent - this->LeftTangent);
  return static_cast<int>(std::clamp(std::floor(share * bins), 0.0, bins - 1.0));
}

//------------------------------------------------------------------------------
double vtkHeliosSwath::GetRate(double across) const
{
  const bool isInside =
    !this->Rates.empty() && across >= this->LeftTangent && across <= this->RightTangent;
  return isInside ? this->Rates[static_cast<std::size_t>(this->FindBin(across))] : 0.0;
}

//------------------------------------------------------------------------------
double vtkHeliosSwath::GetSmallestRate(double low, double high) const
{
  if (this->Rates.empty() || low < this->LeftTangent || high > this->RightTangent || low > high)
  {
    return 0.0;
  }
  const auto first = this->Rates.begin() + this->FindBin(low);
  return *std::min_element(first, this->Rates.begin() + this->FindBin(high) + 1);
}

//------------------------------------------------------------------------------
double vtkHeliosSwath::GetAlongMean(double across) const
{
  return this->Means.empty() ? 0.0 : this->Means[static_cast<std::size_t>(this->FindBin(across))];
}

//------------------------------------------------------------------------------
double vtkHeliosSwath::GetAlongDeviation(double across) const
{
  return this->Deviations.empty()
    ? 0.0
    : this->Deviations[static_cast<std::size_t>(this->FindBin(across))];
}

//------------------------------------------------------------------------------
void vtkHeliosSwath::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "MaximumAngle: " << this->MaximumAngle << " deg\n"
     << indent << "NumberOfSamples: " << this->NumberOfSamples << "\n"
     << indent << "PulseRate: " << this->PulseRate << " Hz\n"
     << indent << "LeftTangent: " << this->LeftTangent << "\n"
     << indent << "RightTangent: " << this->RightTangent << "\n"
     << indent << "LargestAlong: " << this->LargestAlong << "\n"
     << indent << "RangeMin: " << this->RangeMin << " m\n"
     << indent << "RangeMax: " << this->RangeMax << " m\n";
}
