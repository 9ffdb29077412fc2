// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
// The records that a pulse leaves: echoes, waveforms, pulses and sub-rays.

#include "heliosPulseKernel.h"

#include "heliosRandom.h"
#include "heliosReturnSelection.h"
#include "heliosScatteredEchoes.h"
#include "vtkHeliosBeamDeflector.h"
#include "vtkHeliosErrorModel.h"

#include <vtkMath.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace helios
{
namespace
{

constexpr std::size_t ManySamples = 1 << 22; // samples of a block

double IncidenceDegrees(double cosIncidence)
{
  return vtkMath::DegreesFromRadians(std::acos(std::min(1.0, cosIncidence)));
}

} // namespace

void PulseKernel::StorePulse(std::size_t slot, ChunkResult& result)
{
  const Pulse& pulse = this->Pulses[slot];
  const bool isSeen = !this->Returns.empty() || !this->Echoes.empty(); // also by dark counts
  const bool isAsked = isSeen || this->Model.Wants.Pulses;
  const double scanAngle =
    isAsked ? this->Model.Source.Deflector->GetScanAngle(this->Indices[slot]) : 0.0;
  const std::size_t echoesBefore = result.Echoes.size();
  if (isSeen)
  {
    this->Counts.PulsesHit += this->HasSurface() ? 1 : 0;
    this->SetScanFlags(this->Indices[slot]);
    if (this->Model.Wants.Velocities)
    {
      this->Velocity = this->Model.Source.GetVelocity(this->Indices[slot], this->VelocityCursor);
    }
    this->StoreEchoes(pulse, scanAngle, result);
    if (this->Model.Zones.Zone > 0)
    {
      this->MoveToZones(this->Indices[slot], echoesBefore, result);
    }
    if (this->Model.Wants.Waveforms && this->HasWaveform)
    {
      this->StoreWaveform(pulse, result);
    }
    if (this->Model.Wants.SubRays)
    {
      this->StoreSubRays(pulse, result);
    }
  }
  if (this->Model.Wants.Pulses)
  {
    result.Pulses.push_back({ pulse.ReportedOrigin, pulse.Reported, pulse.Time, this->PulseId,
      scanAngle, pulse.Channel, result.Echoes.size() > echoesBefore });
  }
}

//------------------------------------------------------------------------------
/// Exchanges the members of the current pulse for those of a waiting one.
void PulseKernel::SwapPulse(WaitingPulse& pulse)
{
  this->Returns.swap(pulse.Returns);
  this->SubRays.swap(pulse.SubRays);
  this->Echoes.swap(pulse.Echoes);
  this->Tracer.GetPaths().SwapEnds(pulse.Ends);
  if (this->Scattered)
  {
    this->Scattered->GetProfile().SwapReturns(pulse.Scattered);
  }
  this->Signal.SwapWaveform(pulse.Wave);
}

//------------------------------------------------------------------------------
/// Adds the current pulse to the block, which is stored once it is large.
void PulseKernel::AddToBlock(std::size_t slot, ChunkResult& result)
{
  if (this->BlockSize == this->Block.size())
  {
    this->Block.emplace_back();
  }
  WaitingPulse& pulse = this->Block[this->BlockSize++];
  pulse.Slot = slot;
  pulse.Id = this->PulseId;
  pulse.HasWaveform = this->HasWaveform;
  pulse.IsDetected = !this->IsWaiting;
  this->SwapPulse(pulse);
  this->BlockSamples += pulse.HasWaveform ? pulse.Wave.Samples.size() : 0;
  if (this->BlockSamples > ManySamples)
  {
    this->StoreBlock(result);
  }
}

//------------------------------------------------------------------------------
/// Detects the echoes of the pulses that wait, and stores them in their order.
void PulseKernel::StoreBlock(ChunkResult& result)
{
  std::vector<std::pair<const Waveform*, vtkIdType>> waveforms;
  for (std::size_t i = 0; i < this->BlockSize; ++i)
  {
    const WaitingPulse& pulse = this->Block[i];
    if (!pulse.IsDetected)
    {
      waveforms.emplace_back(&pulse.Wave, pulse.Id);
    }
  }
  std::vector<std::vector<vtkHeliosDetectedEcho>> detected;
  if (!waveforms.empty())
  {
    this->Signal.DetectAll(waveforms, detected);
  }
  auto echoes = detected.begin();
  for (std::size_t i = 0; i < this->BlockSize; ++i)
  {
    WaitingPulse& pulse = this->Block[i];
    this->SwapPulse(pulse);
    this->PulseId = pulse.Id;
    this->HasWaveform = pulse.HasWaveform;
    this->MoveTo(pulse.Slot);
    if (!pulse.IsDetected)
    {
      this->Signal.AddEchoes(*echoes++, this->Returns, this->Echoes);
    }
    this->StorePulse(pulse.Slot, result);
    this->SwapPulse(pulse);
  }
  this->BlockSize = 0;
  this->BlockSamples = 0;
}

//------------------------------------------------------------------------------
/// Returns whether a surface or leaf returns light, not only the air.
bool PulseKernel::HasSurface() const
{
  return std::any_of(
    this->Returns.begin(), this->Returns.end(), [](const SubReturn& r) { return r.CellId >= 0; });
}

//------------------------------------------------------------------------------
void PulseKernel::SetScanFlags(vtkIdType index)
{
  if (this->Model.Wants.ScanFlags)
  {
    const vtkHeliosBeamDeflector* deflector = this->Model.Source.Deflector;
    this->ScanDirection = static_cast<unsigned char>(deflector->GetScanDirectionFlag(index));
    this->EdgeOfFlightLine = deflector->IsEdgeOfFlightLine(index) ? 1 : 0;
  }
}

//------------------------------------------------------------------------------
void PulseKernel::StoreEchoes(const Pulse& pulse, double scanAngle, ChunkResult& result)
{
  double largest = 0.0;
  for (const Echo& echo : this->Echoes)
  {
    largest = std::max(largest, echo.Amplitude);
  }
  for (std::size_t i = 0; this->Echoes.empty() && i < this->Returns.size(); ++i)
  {
    largest += this->Returns[i].Power;
  }
  this->Counts.LargestAmplitude = std::max(this->Counts.LargestAmplitude, largest);
  const bool countsPhotons = !(this->Model.Receiver.Detector->GetCalibrationAmplitude() > 0.0);
  if (this->Scattered && this->Model.Path.Echo != EchoPath::Mean && !countsPhotons)
  {
    DropUncertainEchoes(this->Scattered->GetProfile(), this->Model.Receiver.Shape, this->Echoes);
  }
  SelectReturns(
    this->Echoes, this->Model.ReturnSelection, this->Model.MaximumNumberOfReturns, this->Kept);
  for (std::size_t i = 0; i < this->Kept.size(); ++i)
  {
    this->StoreEcho(pulse, scanAngle, this->Echoes[this->Kept[i]], i, this->Kept.size(), result);
  }
  this->Counts.Echoes += static_cast<vtkIdType>(this->Kept.size());
}

//------------------------------------------------------------------------------
void PulseKernel::StoreEcho(const Pulse& pulse, double scanAngle, const Echo& echo,
  std::size_t number, std::size_t count, ChunkResult& result)
{
  const SceneSurfaces& surfaces = this->Model.Surfaces;
  const double range = this->GetMeasuredRange(echo, vtkMath::RadiansFromDegrees(scanAngle), number);
  const vtkIdType cell = echo.Nearest ? echo.Nearest->CellId : -1;
  const bool isDark = cell < 0; // no surface: a dark count, or the air
  const int material = isDark ? -1 : surfaces.GetMaterialId(cell);
  const double incidence = isDark ? 0.0 : IncidenceDegrees(echo.Nearest->CosIncidence);
  result.Echoes.push_back({ pulse.ReportedOrigin + range * pulse.Reported, pulse.Time,
    this->PulseId, cell, range, echo.Amplitude, echo.Width, echo.Deviation, scanAngle, incidence,
    pulse.Channel, material, isDark ? -1 : surfaces.GetPartId(cell),
    isDark ? 0 : surfaces.GetClassification(material), static_cast<unsigned char>(number + 1),
    static_cast<unsigned char>(count), this->ScanDirection, this->EdgeOfFlightLine });
  if (this->Model.Wants.Truth)
  {
    const Vec3 normal = isDark ? Vec3(0, 0, 0) : this->Response.GetNormal(cell);
    const PathEnd end = this->FindEnd(pulse, echo);
    result.Truths.push_back({ end.Point, normal, end.Events });
  }
  if (this->Scattered)
  {
    result.Scattered.push_back(GetScatteredPower(this->Scattered->GetProfile(),
      this->Model.Receiver.Shape, this->Model.Path.Echo == EchoPath::Mean, echo.Range));
  }
  if (this->Model.Wants.Velocities || this->Model.Wants.Motion)
  {
    this->StoreMotion(pulse, echo, result);
  }
  if (this->Model.Wants.Colors)
  {
    result.Colors.push_back(isDark
        ? ColorRecord()
        : this->Model.Colors.Find(cell, material, this->FindEnd(pulse, echo).Point));
  }
}

//------------------------------------------------------------------------------
/// Stores how scanner and target of an echo move.
void PulseKernel::StoreMotion(const Pulse& pulse, const Echo& echo, ChunkResult& result)
{
  const vtkIdType cell = echo.Nearest ? echo.Nearest->CellId : -1;
  const PathEnd end = this->FindEnd(pulse, echo);
  const bool moves = this->Moving && cell >= 0 && !this->Model.Surfaces.IsTurbid(cell);
  const Vec3 velocity = moves ? this->Moving->GetVelocity(cell, end.Point) : Vec3(0.0, 0.0, 0.0);
  if (this->Model.Wants.Velocities)
  {
    const bool isKnown = cell >= 0 && end.Events == 0 && echo.Nearest->SubRay != SubReturn::Column;
    result.Velocities.push_back(isKnown ? pulse.GetDirection().Dot(velocity - this->Velocity)
                                        : std::numeric_limits<double>::quiet_NaN());
  }
  if (this->Model.Wants.Motion)
  {
    result.Motions.push_back({ moves ? this->Moving->GetPose(cell) : Pose(), velocity });
  }
}

//------------------------------------------------------------------------------
/// Finds where an echo comes from, without noise.
PathEnd PulseKernel::FindEnd(const Pulse& pulse, const Echo& echo) const
{
  const bool isStraight = !echo.Nearest || echo.Nearest->Path < 0;
  return isStraight ? PathEnd{ pulse.Origin + echo.Range * pulse.GetDirection(), 0 }
                    : this->Tracer.GetPaths().GetEnd(echo.Nearest->Path);
}

//------------------------------------------------------------------------------
/// Returns the range with the errors of the instrument; number counts the echoes of the pulse from
/// 0.
double PulseKernel::GetMeasuredRange(const Echo& echo, double theta, std::size_t number)
{
  const RangeNoise& law = this->Model.Noise;
  using Terms = vtkHeliosErrorModel;
  const Terms* errors = this->Model.Source.Errors;
  double range = echo.Range;
  if (errors)
  {
    range += this->UseTerm(Terms::RANGE_ERROR, errors->GetRangeError(theta), theta, 0.0);
  }
  if (law.IsOn())
  {
    const auto noise = NormalPair(this->Model.Seed, RandomStream::RangeNoise,
      static_cast<std::uint64_t>(this->PulseId), static_cast<std::uint32_t>(number));
    const double factor = errors
      ? this->UseTerm(Terms::RANGE_NOISE_FACTOR, errors->GetRangeNoiseFactor(range), range, 1.0)
      : 1.0;
    range += factor * law.GetDeviation(echo.Range, echo.Amplitude) * noise[0];
  }
  return range;
}

//------------------------------------------------------------------------------
/// Returns the value of a term of the error model; another, and counted, if it is invalid.
double PulseKernel::UseTerm(int term, double value, double variable, double otherwise)
{
  if (IsUsableTerm(value))
  {
    return value;
  }
  this->Counts.Faults[static_cast<std::size_t>(term)].Add(this->PulseId, variable);
  return otherwise;
}

//------------------------------------------------------------------------------
/// Moves an echo of a pulse to the pulse that it is taken for; false if that is not emitted.
bool PulseKernel::MoveToZone(vtkIdType index, EchoRecord& echo)
{
  const RangeZones& zones = this->Model.Zones;
  const vtkIdType step = zones.GetStep(echo.Range);
  const vtkIdType taken = index + step * zones.Stride;
  Pulse pulse;
  if (taken < 0 || taken >= zones.NumberOfPulses ||
    !this->Model.Source.GetPulse(taken, this->ZoneCursor, pulse))
  {
    return false;
  }
  this->SetScanFlags(taken);
  echo.Range -= static_cast<double>(step) * zones.Depth;
  echo.Point = pulse.ReportedOrigin + echo.Range * pulse.Reported;
  echo.Time = pulse.Time;
  echo.PulseId = pulse.Id;
  echo.ScanAngle = this->Model.Source.Deflector->GetScanAngle(taken);
  echo.ScanDirection = this->ScanDirection;
  echo.EdgeOfFlightLine = this->EdgeOfFlightLine;
  return true;
}

//------------------------------------------------------------------------------
/// Moves the echoes of a pulse, the last of a chunk from a row on, and drops those that are lost.
void PulseKernel::MoveToZones(vtkIdType index, std::size_t first, ChunkResult& result)
{
  std::vector<EchoRecord>& echoes = result.Echoes;
  std::vector<std::size_t> rows; // those that are kept
  for (std::size_t i = first; i < echoes.size(); ++i)
  {
    if (this->MoveToZone(index, echoes[i]))
    {
      rows.push_back(i);
    }
  }
  this->Counts.Echoes -= static_cast<vtkIdType>(echoes.size() - first - rows.size());
  const auto keep = [first, &rows](auto& records)
  {
    for (std::size_t k = 0; k < rows.size() && !records.empty(); ++k)
    {
      records[first + k] = records[rows[k]];
    }
    records.resize(std::min(records.size(), first + rows.size()));
  };
  keep(echoes);
  keep(result.Truths);
  keep(result.Velocities);
  keep(result.Motions);
  keep(result.Colors);
  keep(result.Scattered);
}

//------------------------------------------------------------------------------
void PulseKernel::StoreWaveform(const Pulse& pulse, ChunkResult& result)
{
  const Waveform& wave = this->Signal.GetWaveform();
  result.Waveforms.push_back({ pulse.ReportedOrigin, pulse.Reported, pulse.Time, this->PulseId,
    wave.StartTime, static_cast<vtkIdType>(wave.Samples.size()), pulse.Channel });
  result.Samples.insert(result.Samples.end(), wave.Samples.begin(), wave.Samples.end());
}

//------------------------------------------------------------------------------
void PulseKernel::StoreSubRays(const Pulse& pulse, ChunkResult& result)
{
  for (const SubReturn& r : this->Returns)
  {
    if (r.SubRay == SubReturn::Column)
    {
      continue;
    }
    const CastSubRay& ray = this->SubRays[static_cast<std::size_t>(r.SubRay)];
    const Vec3 point = pulse.Origin + r.Range * ray.Direction;
    result.SubRays.push_back(
      { point, this->PulseId, r.CellId, ray.Weight, r.Range, IncidenceDegrees(r.CosIncidence) });
  }
}

} // namespace helios
