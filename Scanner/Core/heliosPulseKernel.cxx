// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
#include "heliosPulseKernel.h"

#include "heliosRandom.h"
#include "vtkHeliosBeamDeflector.h"

#include <vtkMath.h>

#include <algorithm>
#include <cmath>

namespace helios
{
namespace
{

// Pulses traced together: their rays and hits stay in the cache.
constexpr vtkIdType PulsesTogether = 32;
// A stored waveform ends here: 16 million samples are 600 km in bins of 0.25 ns.
constexpr vtkIdType LongestWaveform = 1 << 24;

double IncidenceDegrees(double cosIncidence)
{
  return vtkMath::DegreesFromRadians(std::acos(std::min(1.0, cosIncidence)));
}

} // namespace

PulseKernel::PulseKernel(const ScanModel& model)
  : Model(model)
  , Signal(model.PulseLength, model.BinSize, model.Detector)
{
}

void PulseKernel::Run(vtkIdType first, vtkIdType last, ChunkResult& result)
{
  const std::size_t subRays = this->Model.SubRays.size();
  for (vtkIdType begin = first; begin < last; begin += PulsesTogether)
  {
    this->AimPulses(begin, std::min(last, begin + PulsesTogether));
    const vtkIdType rayCount = static_cast<vtkIdType>(this->Rays.size());
    this->Hits.resize(this->Rays.size());
    this->Model.Caster->Intersect(this->Rays.data(), this->Hits.data(), rayCount);
    for (std::size_t slot = 0; slot < this->Pulses.size(); ++slot)
    {
      this->CollectReturns(&this->Rays[slot * subRays], &this->Hits[slot * subRays]);
      this->FinishPulse(slot, result);
    }
  }
}

void PulseKernel::AimPulses(vtkIdType first, vtkIdType last)
{
  this->Pulses.clear();
  this->Indices.clear();
  this->Rays.clear();
  Pulse pulse;
  for (vtkIdType i = first; i < last; ++i)
  {
    if (!this->Model.Source.GetPulse(i, this->Cursor, pulse))
    {
      continue;
    }
    this->Pulses.push_back(pulse);
    this->Indices.push_back(i);
    const std::size_t before = this->Rays.size();
    this->Rays.resize(before + this->Model.SubRays.size());
    vtkHeliosRay* ray = this->Rays.data() + before;
    for (const Vec3& subRay : this->Model.SubRays)
    {
      const Vec3 direction = pulse.Beam * subRay;
      std::copy_n(pulse.Origin.GetData(), 3, ray->Origin);
      std::copy_n(direction.GetData(), 3, ray->Direction);
      ++ray;
    }
  }
  this->Counts.PulsesFired += static_cast<vtkIdType>(this->Pulses.size());
}

const Vec3& PulseKernel::GetNormal(vtkIdType cell)
{
  if (cell != this->NormalCell)
  {
    this->NormalCell = cell;
    if (!this->Model.Surfaces.GetNormal(cell, this->Normal))
    {
      this->Normal = this->Model.Caster->GetMesh().GetNormal(cell);
    }
  }
  return this->Normal;
}

void PulseKernel::CollectReturns(const vtkHeliosRay* rays, const vtkHeliosHit* hits)
{
  const ScanModel& m = this->Model;
  this->Returns.clear();
  NearbyTransmission transmission(m.Equation);
  for (std::size_t k = 0; k < m.SubRays.size(); ++k)
  {
    const vtkHeliosHit& hit = hits[k];
    if (hit.CellId < 0)
    {
      continue;
    }
    if (hit.Range < m.RangeMin || hit.Range > m.RangeMax)
    {
      ++this->Counts.HitsOutOfRange;
      continue;
    }
    const double* d = rays[k].Direction;
    const Vec3& n = this->GetNormal(hit.CellId);
    const double cosIncidence = std::abs(n[0] * d[0] + n[1] * d[1] + n[2] * d[2]);
    const int material = m.Surfaces.GetMaterialId(hit.CellId);
    const double gain = m.Equation.GetGain(hit.Range, transmission(hit.Range)) *
      m.Surfaces.GetReflectance(material) * cosIncidence;
    this->Returns.push_back(
      { hit.Range, m.Power * m.Weights[k] * gain, hit.CellId, static_cast<int>(k), cosIncidence });
  }
}

void PulseKernel::FinishPulse(std::size_t slot, ChunkResult& result)
{
  const Pulse& pulse = this->Pulses[slot];
  const vtkIdType index = this->Indices[slot];
  const vtkIdType id = this->Model.FirstPulseId + index;
  const std::size_t echoesBefore = result.Echoes.size();
  if (!this->Returns.empty())
  {
    ++this->Counts.PulsesHit;
    this->Echoes.clear();
    this->Signal.FindEchoes(this->Returns, this->Echoes);
    this->StoreEchoes(pulse, index, result);
    if (this->Model.WantsWaveforms)
    {
      this->StoreWaveform(pulse, id, result);
    }
    if (this->Model.WantsSubRays)
    {
      this->StoreSubRays(&this->Rays[slot * this->Model.SubRays.size()], id, result);
    }
  }
  if (this->Model.WantsPulses)
  {
    result.Pulses.push_back({ pulse.Origin, pulse.GetDirection(), pulse.Time, id,
      this->Model.Source.Deflector->GetScanAngle(index), result.Echoes.size() > echoesBefore });
  }
}

void PulseKernel::StoreEchoes(const Pulse& pulse, vtkIdType index, ChunkResult& result)
{
  const ScanModel& m = this->Model;
  std::size_t count = this->Echoes.size();
  if (count == 0)
  {
    double total = 0.0;
    for (const SubReturn& r : this->Returns)
    {
      total += r.Power;
    }
    this->Counts.LargestAmplitude = std::max(this->Counts.LargestAmplitude, total);
    return;
  }
  const std::size_t limit = m.MaximumNumberOfReturns > 0 ? m.MaximumNumberOfReturns : 255;
  count = std::min(count, limit);
  const Vec3 direction = pulse.GetDirection();
  const double scanAngle = m.Source.Deflector->GetScanAngle(index);
  const vtkIdType id = m.FirstPulseId + index;
  for (std::size_t e = 0; e < count; ++e)
  {
    const Echo& echo = this->Echoes[e];
    double range = echo.Range;
    if (m.RangeAccuracy > 0.0)
    {
      const auto noise = NormalPair(m.Seed, RandomStream::RangeNoise,
        static_cast<std::uint64_t>(id), static_cast<std::uint32_t>(e));
      range += m.RangeAccuracy * noise[0];
    }
    const vtkIdType cell = echo.Nearest->CellId;
    const int material = m.Surfaces.GetMaterialId(cell);
    this->Counts.LargestAmplitude = std::max(this->Counts.LargestAmplitude, echo.Amplitude);
    result.Echoes.push_back({ pulse.Origin + range * direction, pulse.Time, id, cell, range,
      echo.Amplitude, echo.Width, scanAngle, IncidenceDegrees(echo.Nearest->CosIncidence), material,
      m.Surfaces.GetPartId(cell), m.Surfaces.GetClassification(material),
      static_cast<unsigned char>(e + 1), static_cast<unsigned char>(count) });
  }
}

void PulseKernel::StoreWaveform(const Pulse& pulse, vtkIdType id, ChunkResult& result)
{
  const bool cut = this->Signal.MakeWaveform(this->Returns, LongestWaveform, this->Wave);
  this->Counts.CutWaveforms += cut ? 1 : 0;
  const auto& samples = this->Wave.Samples;
  result.Waveforms.push_back({ pulse.Origin, pulse.GetDirection(), pulse.Time, id,
    this->Wave.StartTime, static_cast<vtkIdType>(samples.size()) });
  result.Samples.insert(result.Samples.end(), samples.begin(), samples.end());
}

void PulseKernel::StoreSubRays(const vtkHeliosRay* rays, vtkIdType id, ChunkResult& result)
{
  for (const SubReturn& r : this->Returns)
  {
    const std::size_t k = static_cast<std::size_t>(r.SubRay);
    const Vec3 point = Vec3(rays[k].Origin) + r.Range * Vec3(rays[k].Direction);
    result.SubRays.push_back(
      { point, id, r.CellId, this->Model.Weights[k], r.Range, IncidenceDegrees(r.CosIncidence) });
  }
}

} // namespace helios
