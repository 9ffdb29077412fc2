// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
#include "heliosEchoComparison.h"

#include "vtkHeliosArrayNames.h"

#include <vtkDataArray.h>
#include <vtkPointData.h>
#include <vtkPolyData.h>

#include <algorithm>
#include <cmath>
#include <numeric>
#include <string>

namespace helios
{
namespace names = vtkHeliosArrayNames;

//------------------------------------------------------------------------------
double EchoMatching::GetFullAmplitude(double range) const
{
  return this->FullAmplitude / (range * range) * std::exp(-2.0 * this->Extinction * range);
}

//------------------------------------------------------------------------------
double EchoMatching::GetLeastAmplitude(double range) const
{
  return std::max(this->LeastAmplitude, this->LeastShare * this->GetFullAmplitude(range));
}

//------------------------------------------------------------------------------
Status EchoComparison::Read(vtkPolyData* data, Echoes& echoes)
{
  vtkDataArray* arrays[4];
  const char* const wanted[] = { names::PulseIds, names::Range, names::Amplitude,
    names::EchoWidth };
  for (std::size_t i = 0; i < 4; ++i)
  {
    arrays[i] = data->GetPointData()->GetArray(wanted[i]);
    if (!arrays[i] && data->GetNumberOfPoints() > 0)
    {
      return Status::Error(std::string("echoes have no point array ") + wanted[i] +
        "; compare outputs of vtkHeliosScanner");
    }
  }
  echoes.reserve(static_cast<std::size_t>(data->GetNumberOfPoints()));
  for (vtkIdType i = 0; i < data->GetNumberOfPoints(); ++i)
  {
    echoes.push_back({ static_cast<vtkIdType>(arrays[0]->GetTuple1(i)), arrays[1]->GetTuple1(i),
      arrays[2]->GetTuple1(i), arrays[3]->GetTuple1(i), false });
  }
  std::sort(echoes.begin(), echoes.end(),
    [](const Echo& a, const Echo& b)
    { return a.Pulse != b.Pulse ? a.Pulse < b.Pulse : a.Range < b.Range; });
  return {};
}

//------------------------------------------------------------------------------
Status EchoComparison::Add(
  vtkPolyData* data, vtkPolyData* referenceData, const EchoMatching& matching)
{
  Echoes echoes;
  Echoes reference;
  Status status = Read(data, echoes);
  status = status.IsOk() ? Read(referenceData, reference) : status;
  if (!status.IsOk())
  {
    return status;
  }
  Echo* other = reference.data();
  Echo* const otherEnd = other + reference.size();
  Echo* const end = echoes.data() + echoes.size();
  const auto isSame = [](const Echo* first)
  { return [first](const Echo& echo) { return echo.Pulse == first->Pulse; }; };
  for (Echo* first = echoes.data(); first != end;)
  {
    Echo* const last = std::find_if_not(first, end, isSame(first));
    other = std::find_if(
      other, otherEnd, [first](const Echo& echo) { return echo.Pulse >= first->Pulse; });
    Echo* const otherLast = std::find_if_not(other, otherEnd, isSame(first));
    this->Match(first, last, other, otherLast, matching);
    other = otherLast;
    first = last;
  }
  const auto isLost = [&matching](const Echo& echo)
  { return !echo.IsMatched && echo.Amplitude >= matching.GetLeastAmplitude(echo.Range); };
  const auto missed = std::count_if(reference.begin(), reference.end(), isLost);
  this->Missed += missed;
  this->Expected += missed;
  this->Invented += std::count_if(echoes.begin(), echoes.end(), isLost);
  return {};
}

//------------------------------------------------------------------------------
/// Matches the echoes of one pulse in pairs, nearest first.
void EchoComparison::Match(
  Echo* first, Echo* last, Echo* otherFirst, Echo* otherLast, const EchoMatching& matching)
{
  while (true)
  {
    double nearest = matching.Distance;
    Echo* echo = nullptr;
    Echo* partner = nullptr;
    for (Echo* a = first; a != last; ++a)
    {
      for (Echo* b = otherFirst; !a->IsMatched && b != otherLast; ++b)
      {
        const double distance = std::abs(a->Range - b->Range);
        if (!b->IsMatched && (echo ? distance < nearest : distance <= nearest))
        {
          nearest = distance;
          echo = a;
          partner = b;
        }
      }
    }
    if (!echo)
    {
      return;
    }
    echo->IsMatched = partner->IsMatched = true;
    this->AddPair(*echo, *partner, matching);
  }
}

//------------------------------------------------------------------------------
/// Adds the deviations of a pair, if its echo of the reference counts.
void EchoComparison::AddPair(const Echo& echo, const Echo& reference, const EchoMatching& matching)
{
  if (reference.Amplitude < matching.GetLeastAmplitude(reference.Range))
  {
    return;
  }
  ++this->Expected;
  const double full =
    matching.FullAmplitude > 0.0 ? matching.GetFullAmplitude(reference.Range) : reference.Amplitude;
  this->Ranges.push_back(echo.Range - reference.Range);
  this->Amplitudes.push_back((echo.Amplitude - reference.Amplitude) / full);
  this->Widths.push_back(echo.Width - reference.Width);
}

//------------------------------------------------------------------------------
EchoErrors EchoComparison::GetErrors() const
{
  EchoErrors errors;
  errors.Echoes = this->Expected;
  errors.Matched = static_cast<vtkIdType>(this->Ranges.size());
  std::vector<double> sorted = this->Ranges;
  for (double& deviation : sorted)
  {
    deviation = std::abs(deviation);
  }
  std::sort(sorted.begin(), sorted.end());
  errors.RangeP50 = EstimateQuantile(sorted, 0.5);
  errors.RangeP95 = EstimateQuantile(sorted, 0.95);
  errors.RangeP99 = EstimateQuantile(sorted, 0.99).Value;
  errors.RangeRms = EstimateRms(sorted);
  errors.RangeBias = std::accumulate(this->Ranges.begin(), this->Ranges.end(), 0.0) /
    std::max<double>(1.0, static_cast<double>(errors.Matched));
  errors.Missed = EstimateFraction(this->Missed, this->Expected);
  errors.Invented = EstimateFraction(this->Invented, this->Expected);
  errors.Lost = EstimateFraction(this->Missed + this->Invented, this->Expected);
  errors.AmplitudeRms = EstimateRms(this->Amplitudes);
  errors.WidthRms = EstimateRms(this->Widths);
  return errors;
}

} // namespace helios
