// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkHeliosPlatformNoise.h"

#include "heliosRandom.h"

#include <vtkObjectFactory.h>

#include <algorithm>
#include <cmath>

vtkStandardNewMacro(vtkHeliosPlatformNoise);

namespace
{

const char* const ComponentNames[6] = { "PositionX", "PositionY", "PositionZ", "AttitudeX",
  "AttitudeY", "AttitudeZ" };

} // namespace

//------------------------------------------------------------------------------
bool vtkHeliosPlatformNoise::CheckComponent(int component)
{
  if (component < POSITION_X || component > ATTITUDE_Z)
  {
    vtkErrorMacro(<< "Component is " << component
                  << "; give one of POSITION_X (0) to ATTITUDE_Z (5).");
    return false;
  }
  return true;
}

//------------------------------------------------------------------------------
void vtkHeliosPlatformNoise::SetDistribution(int component, int distribution, double a, double b)
{
  Component& c = this->All[component];
  if (c.Distribution != distribution || c.A != a || c.B != b)
  {
    c.Distribution = distribution;
    c.A = a;
    c.B = b;
    this->Modified();
  }
}

//------------------------------------------------------------------------------
void vtkHeliosPlatformNoise::SetNormal(int component, double mean, double stdev)
{
  if (!this->CheckComponent(component))
  {
    return;
  }
  if (!std::isfinite(mean) || !std::isfinite(stdev) || stdev < 0.0)
  {
    vtkErrorMacro(<< ComponentNames[component] << " has mean " << mean << " and stdev " << stdev
                  << "; give finite numbers, stdev 0 or more.");
    return;
  }
  this->SetDistribution(component, NORMAL, mean, stdev);
}

//------------------------------------------------------------------------------
void vtkHeliosPlatformNoise::SetUniform(int component, double minimum, double maximum)
{
  if (!this->CheckComponent(component))
  {
    return;
  }
  if (!std::isfinite(maximum - minimum) || minimum > maximum)
  {
    vtkErrorMacro(<< ComponentNames[component] << " is uniform between " << minimum << " and "
                  << maximum << "; give finite numbers, the smaller first.");
    return;
  }
  this->SetDistribution(component, UNIFORM, minimum, maximum);
}

//------------------------------------------------------------------------------
void vtkHeliosPlatformNoise::SetNone(int component)
{
  if (this->CheckComponent(component))
  {
    this->SetDistribution(component, NONE, 0.0, 0.0);
  }
}

//------------------------------------------------------------------------------
void vtkHeliosPlatformNoise::SetClip(int component, double minimum, double maximum)
{
  if (!this->CheckComponent(component))
  {
    return;
  }
  if (!(minimum <= maximum))
  {
    vtkErrorMacro(<< ComponentNames[component] << " is clipped to " << minimum << " and " << maximum
                  << "; give numbers, the smaller first.");
    return;
  }
  this->All[component].ClipMinimum = minimum;
  this->All[component].ClipMaximum = maximum;
  this->Modified();
}

//------------------------------------------------------------------------------
void vtkHeliosPlatformNoise::SetNoClip(int component)
{
  this->SetClip(component, -VTK_DOUBLE_MAX, VTK_DOUBLE_MAX);
}

//------------------------------------------------------------------------------
void vtkHeliosPlatformNoise::SetLifespan(int component, vtkIdType pulses)
{
  if (!this->CheckComponent(component))
  {
    return;
  }
  if (pulses < 0 || pulses > 1000000000000000)
  {
    vtkErrorMacro(<< ComponentNames[component] << " has a lifespan of " << pulses
                  << " pulses; give 0 (unlimited) to 1e15.");
    return;
  }
  this->All[component].Lifespan = pulses;
  this->Modified();
}

//------------------------------------------------------------------------------
vtkIdType vtkHeliosPlatformNoise::GetLifespan(int component) const
{
  return component >= POSITION_X && component <= ATTITUDE_Z ? this->All[component].Lifespan : -1;
}

//------------------------------------------------------------------------------
bool vtkHeliosPlatformNoise::IsOn() const
{
  return std::any_of(std::begin(this->All), std::end(this->All),
    [](const Component& c) { return c.Distribution != NONE; });
}

//------------------------------------------------------------------------------
void vtkHeliosPlatformNoise::GetValues(vtkIdType seed, vtkIdType pulse, double values[6]) const
{
  const auto key = static_cast<std::uint64_t>(seed);
  for (std::uint32_t i = 0; i < 6; ++i)
  {
    const Component& c = this->All[i];
    values[i] = 0.0;
    if (c.Distribution == NONE)
    {
      continue;
    }
    const auto item = static_cast<std::uint64_t>(c.Lifespan > 0 ? pulse / c.Lifespan : 0);
    const double value = c.Distribution == NORMAL
      ? c.A + c.B * helios::NormalPair(key, helios::RandomStream::Platform, item, i)[0]
      : c.A + (c.B - c.A) * helios::Uniform4(key, helios::RandomStream::Platform, item, i)[0];
    values[i] = std::min(std::max(value, c.ClipMinimum), c.ClipMaximum);
  }
}

//------------------------------------------------------------------------------
void vtkHeliosPlatformNoise::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "Mode: " << (this->Mode == NAVIGATION_ERROR ? "NavigationError" : "Motion")
     << "\n";
  for (int i = 0; i < 6; ++i)
  {
    const Component& c = this->All[i];
    os << indent << ComponentNames[i] << ": ";
    switch (c.Distribution)
    {
      case NORMAL:
        os << "normal, mean " << c.A << ", stdev " << c.B;
        break;
      case UNIFORM:
        os << "uniform between " << c.A << " and " << c.B;
        break;
      default:
        os << "none";
    }
    os << "; clipped to " << c.ClipMinimum << " and " << c.ClipMaximum << "; lifespan "
       << c.Lifespan << " pulses\n";
  }
}
