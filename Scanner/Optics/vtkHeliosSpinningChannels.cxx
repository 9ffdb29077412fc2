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
// The azimuth in turns: of the head at the start of the cycle, in the cycle, of the channel.
double vtkHeliosSpinningChannels::ComputeTurn(vtkIdType pulse) const
{
  const int channel = this->GetChannel(pulse);
  const Channel& one = this->Channels[static_cast<std::size_t>(channel)];
  const double own = one.Azimuth / 360.0;
  if (one.FiringTime < 0.0)
  {
    return helios::Fraction(this->ComputePhase(pulse, this->ScanFrequency) + own);
  }
  const double start = this->ComputePhase(pulse - channel, this->ScanFrequency);
  return helios::Fraction(start + helios::Phase(one.FiringTime, this->ScanFrequency) + own);
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
  os << indent << "ScanFrequency: " << this->ScanFrequency << "\n";
  for (const Channel& channel : this->Channels)
  {
    os << indent << "Channel: elevation " << channel.Elevation << ", azimuth " << channel.Azimuth
       << ", fires at " << channel.FiringTime << " s\n";
  }
}
