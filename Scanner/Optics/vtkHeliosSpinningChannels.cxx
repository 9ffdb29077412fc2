// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkHeliosSpinningChannels.h"

#include "heliosPhase.h"

#include <vtkMath.h>
#include <vtkObjectFactory.h>

#include <algorithm>
#include <cmath>

vtkStandardNewMacro(vtkHeliosSpinningChannels);

//------------------------------------------------------------------------------
vtkHeliosSpinningChannels::vtkHeliosSpinningChannels()
  : Channels(1)
{
}

//------------------------------------------------------------------------------
void vtkHeliosSpinningChannels::SetNumberOfChannels(int channels)
{
  const int clamped = std::clamp(channels, 1, 100000);
  if (clamped != this->GetNumberOfChannels())
  {
    this->Channels.resize(static_cast<std::size_t>(clamped));
    this->Modified();
  }
}

//------------------------------------------------------------------------------
int vtkHeliosSpinningChannels::GetNumberOfChannels() const
{
  return static_cast<int>(this->Channels.size());
}

//------------------------------------------------------------------------------
vtkHeliosSpinningChannels::Channel* vtkHeliosSpinningChannels::Find(int channel)
{
  if (channel >= 0 && channel < this->GetNumberOfChannels())
  {
    return &this->Channels[static_cast<std::size_t>(channel)];
  }
  vtkErrorMacro(<< "there is no channel " << channel << "; give one from 0 to "
                << this->GetNumberOfChannels() - 1 << ", or set NumberOfChannels first");
  return nullptr;
}

//------------------------------------------------------------------------------
vtkHeliosSpinningChannels::Channel vtkHeliosSpinningChannels::GetOne(int channel) const
{
  const bool isOne = channel >= 0 && channel < this->GetNumberOfChannels();
  return isOne ? this->Channels[static_cast<std::size_t>(channel)] : Channel();
}

//------------------------------------------------------------------------------
void vtkHeliosSpinningChannels::SetElevation(int channel, double elevation)
{
  if (Channel* found = this->Find(channel))
  {
    this->SetClamped(found->Elevation, std::isnan(elevation) ? 0.0 : elevation, -90.0, 90.0);
  }
}

//------------------------------------------------------------------------------
void vtkHeliosSpinningChannels::SetAzimuth(int channel, double azimuth)
{
  if (Channel* found = this->Find(channel))
  {
    this->SetClamped(found->Azimuth, std::isnan(azimuth) ? 0.0 : azimuth, -360.0, 360.0);
  }
}

//------------------------------------------------------------------------------
void vtkHeliosSpinningChannels::SetFiringTime(int channel, double time)
{
  if (Channel* found = this->Find(channel))
  {
    this->SetClamped(found->FiringTime, time, -1.0, 1e3);
  }
}

//------------------------------------------------------------------------------
void vtkHeliosSpinningChannels::SetOriginOffset(int channel, double offset)
{
  if (Channel* found = this->Find(channel))
  {
    this->SetClamped(found->OriginOffset, std::isnan(offset) ? 0.0 : offset, -10.0, 10.0);
  }
}

//------------------------------------------------------------------------------
void vtkHeliosSpinningChannels::SetOriginHeight(int channel, double height)
{
  if (Channel* found = this->Find(channel))
  {
    this->SetClamped(found->OriginHeight, std::isnan(height) ? 0.0 : height, -10.0, 10.0);
  }
}

//------------------------------------------------------------------------------
double vtkHeliosSpinningChannels::GetElevation(int channel) const
{
  return this->GetOne(channel).Elevation;
}

//------------------------------------------------------------------------------
double vtkHeliosSpinningChannels::GetAzimuth(int channel) const
{
  return this->GetOne(channel).Azimuth;
}

//------------------------------------------------------------------------------
double vtkHeliosSpinningChannels::GetFiringTime(int channel) const
{
  return this->GetOne(channel).FiringTime;
}

//------------------------------------------------------------------------------
double vtkHeliosSpinningChannels::GetOriginOffset(int channel) const
{
  return this->GetOne(channel).OriginOffset;
}

//------------------------------------------------------------------------------
double vtkHeliosSpinningChannels::GetOriginHeight(int channel) const
{
  return this->GetOne(channel).OriginHeight;
}

//------------------------------------------------------------------------------
int vtkHeliosSpinningChannels::GetChannel(vtkIdType pulse) const
{
  return static_cast<int>(this->ComputeCount(pulse) % this->GetNumberOfChannels());
}

//------------------------------------------------------------------------------
double vtkHeliosSpinningChannels::GetDelay(vtkIdType pulse) const
{
  const int channel = this->GetChannel(pulse);
  const double time = this->GetOne(channel).FiringTime;
  return time < 0.0 ? 0.0 : time - channel / this->PulseFrequency;
}

//------------------------------------------------------------------------------
double vtkHeliosSpinningChannels::GetElapsedTime(vtkIdType pulse) const
{
  const int channel = this->GetChannel(pulse);
  const double time = this->GetOne(channel).FiringTime;
  return time < 0.0 ? this->Superclass::GetElapsedTime(pulse)
                    : helios::PulseTime(0.0, pulse - channel, this->PulseFrequency) + time;
}

//------------------------------------------------------------------------------
// The azimuth of the head in turns: at the start of the cycle, and in the cycle.
double vtkHeliosSpinningChannels::ComputeHeadTurn(vtkIdType pulse, const Channel& one) const
{
  const double start = this->StartAngle / 360.0;
  if (one.FiringTime < 0.0)
  {
    return this->ComputePhase(pulse, this->ScanFrequency) + start;
  }
  const double cycle = this->ComputePhase(pulse - this->GetChannel(pulse), this->ScanFrequency);
  return cycle + helios::Phase(one.FiringTime, this->ScanFrequency) + start;
}

//------------------------------------------------------------------------------
double vtkHeliosSpinningChannels::ComputeTurn(vtkIdType pulse) const
{
  const Channel one = this->GetOne(this->GetChannel(pulse));
  return helios::Fraction(this->ComputeHeadTurn(pulse, one) + one.Azimuth / 360.0);
}

//------------------------------------------------------------------------------
bool vtkHeliosSpinningChannels::GetOrigin(vtkIdType pulse, double origin[3]) const
{
  const Channel one = this->GetOne(this->GetChannel(pulse));
  if (one.OriginOffset == 0.0 && one.OriginHeight == 0.0)
  {
    return false;
  }
  const double azimuth = 2.0 * vtkMath::Pi() * helios::Fraction(this->ComputeHeadTurn(pulse, one));
  origin[0] = -one.OriginOffset * std::sin(azimuth);
  origin[1] = one.OriginOffset * std::cos(azimuth);
  origin[2] = one.OriginHeight;
  return true;
}

//------------------------------------------------------------------------------
void vtkHeliosSpinningChannels::GetCrossAxis(double axis[3]) const
{
  axis[0] = axis[1] = 0.0;
  axis[2] = 1.0;
}

//------------------------------------------------------------------------------
vtkIdType vtkHeliosSpinningChannels::GetColumn(vtkIdType pulse) const
{
  const double frequency = std::abs(this->ScanFrequency);
  if (frequency == 0.0)
  {
    return 0;
  }
  const double columns = this->PulseFrequency / this->GetNumberOfChannels() / frequency;
  const double turn = this->ComputePhase(pulse - this->GetChannel(pulse), frequency);
  // Rounding must not lose a column that begins here, nor add one at the end.
  const double rounding = 1e-6;
  const double column = std::floor(turn * columns + rounding);
  return column + rounding < columns ? static_cast<vtkIdType>(column) : 0;
}

//------------------------------------------------------------------------------
double vtkHeliosSpinningChannels::GetScanAngle(vtkIdType pulse) const
{
  return 360.0 * this->ComputeTurn(pulse);
}

//------------------------------------------------------------------------------
bool vtkHeliosSpinningChannels::GetDirection(vtkIdType pulse, double direction[3]) const
{
  const double azimuth = 2.0 * vtkMath::Pi() * this->ComputeTurn(pulse);
  const double elevation =
    vtkMath::RadiansFromDegrees(this->GetOne(this->GetChannel(pulse)).Elevation);
  direction[0] = -std::sin(azimuth) * std::cos(elevation);
  direction[1] = std::cos(azimuth) * std::cos(elevation);
  direction[2] = std::sin(elevation);
  return true;
}

//------------------------------------------------------------------------------
void vtkHeliosSpinningChannels::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "ScanFrequency: " << this->ScanFrequency << "\n"
     << indent << "StartAngle: " << this->StartAngle << "\n";
  for (const Channel& channel : this->Channels)
  {
    os << indent << "Channel: elevation " << channel.Elevation << ", azimuth " << channel.Azimuth
       << ", fires at " << channel.FiringTime << " s, starts " << channel.OriginOffset
       << " m from the axis at height " << channel.OriginHeight << " m\n";
  }
}
