// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkHeliosPlatformNoise.h"

#include "heliosDriftState.h"
#include "heliosRandom.h"

#include <vtkMath.h>
#include <vtkObjectFactory.h>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <string>

vtkStandardNewMacro(vtkHeliosPlatformNoise);

namespace
{

const char* const ComponentNames[6] = { "PositionX", "PositionY", "PositionZ", "AttitudeX",
  "AttitudeY", "AttitudeZ" };

constexpr double ShortestTime = 1e-3; // correlation time [s]
constexpr double LongestTime = 1e9;

/// RMS errors of a class of GNSS/IMU solutions; Docs/trajectories.md has the table with the sources.
struct NavigationGrade
{
  const char* Name;
  double RMS[6]; ///< east, north, up [m]; about x, y, z of the body [deg]
};

constexpr NavigationGrade NavigationGrades[] = {
  // DJI Zenmuse L1 with RTK in real time, specifications
  { "consumer", { 0.010, 0.010, 0.015, 0.05, 0.05, 0.30 } },
  // Applanix APX-15 UAV after post-processing, data sheet; positions: the upper end
  { "tactical", { 0.05, 0.05, 0.05, 0.025, 0.025, 0.080 } },
  // SBG Systems Apogee, PPK, airborne, hardware manual 1.5, section 2.3.4, without the part per km
  { "survey", { 0.010, 0.010, 0.020, 0.005, 0.005, 0.010 } },
  // An Applanix solution: medians of its error report (smrmsg.txt of PDAL)
  { "navigation", { 0.038, 0.041, 0.047, 0.0022, 0.0022, 0.0173 } },
};

bool IsComponent(int component)
{
  return component >= vtkHeliosPlatformNoise::POSITION_X &&
    component <= vtkHeliosPlatformNoise::ATTITUDE_Z;
}

} // namespace

//------------------------------------------------------------------------------
bool vtkHeliosPlatformNoise::CheckComponent(int component)
{
  if (!IsComponent(component))
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
bool vtkHeliosPlatformNoise::SetGrade(const std::string& name)
{
  const auto* grade = std::find_if(std::begin(NavigationGrades), std::end(NavigationGrades),
    [&name](const NavigationGrade& each) { return name == each.Name; });
  if (grade == std::end(NavigationGrades))
  {
    vtkErrorMacro(<< "Grade is \"" << name << "\"; give one of " << GetGradeNames() << ".");
    return false;
  }
  for (int component = 0; component < 6; ++component)
  {
    this->SetSlowError(component, grade->RMS[component], this->All[component].SlowTime);
  }
  return true;
}

//------------------------------------------------------------------------------
std::string vtkHeliosPlatformNoise::GetGradeNames()
{
  std::string names;
  for (const NavigationGrade& grade : NavigationGrades)
  {
    names += (names.empty() ? "" : " ") + std::string(grade.Name);
  }
  return names;
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
  return IsComponent(component) ? this->All[component].Lifespan : -1;
}

//------------------------------------------------------------------------------
void vtkHeliosPlatformNoise::SetSlowError(int component, double rms, double correlationTime)
{
  if (!this->CheckComponent(component))
  {
    return;
  }
  if (!std::isfinite(rms) || rms < 0.0 ||
    !(correlationTime >= ShortestTime && correlationTime <= LongestTime))
  {
    vtkErrorMacro(<< ComponentNames[component] << " has a slow error of RMS " << rms
                  << " and correlation time " << correlationTime
                  << " s; give a finite RMS, 0 or more, and 1e-3 to 1e9 s.");
    return;
  }
  this->All[component].SlowRMS = rms;
  this->All[component].SlowTime = correlationTime;
  this->Modified();
}

//------------------------------------------------------------------------------
double vtkHeliosPlatformNoise::GetSlowErrorRMS(int component) const
{
  return IsComponent(component) ? this->All[component].SlowRMS : vtkMath::Nan();
}

//------------------------------------------------------------------------------
double vtkHeliosPlatformNoise::GetSlowErrorTime(int component) const
{
  return IsComponent(component) ? this->All[component].SlowTime : vtkMath::Nan();
}

//------------------------------------------------------------------------------
void vtkHeliosPlatformNoise::SetBoresight(double x, double y, double z)
{
  const double angles[3] = { x, y, z };
  if (!std::all_of(angles, angles + 3, [](double a) { return std::abs(a) <= 180.0; }))
  {
    vtkErrorMacro(<< "Boresight is " << x << ", " << y << ", " << z
                  << " deg; give angles from -180 to 180.");
    return;
  }
  std::copy_n(angles, 3, this->Boresight);
  this->Modified();
}

//------------------------------------------------------------------------------
void vtkHeliosPlatformNoise::SetLeverArmError(double x, double y, double z)
{
  const double error[3] = { x, y, z };
  if (!std::all_of(error, error + 3, [](double e) { return std::isfinite(e); }))
  {
    vtkErrorMacro(<< "LeverArmError is " << x << ", " << y << ", " << z
                  << " m; give finite numbers.");
    return;
  }
  std::copy_n(error, 3, this->LeverArmError);
  this->Modified();
}

//------------------------------------------------------------------------------
bool vtkHeliosPlatformNoise::HasErrors() const
{
  const auto isSet = [](double value) { return value != 0.0; };
  return this->ClockOffset != 0.0 || std::any_of(this->Boresight, this->Boresight + 3, isSet) ||
    std::any_of(this->LeverArmError, this->LeverArmError + 3, isSet) ||
    std::any_of(std::begin(this->All), std::end(this->All),
      [](const Component& c) { return c.SlowRMS > 0.0; });
}

//------------------------------------------------------------------------------
bool vtkHeliosPlatformNoise::IsOn() const
{
  return this->HasNoise() || this->HasErrors();
}

//------------------------------------------------------------------------------
bool vtkHeliosPlatformNoise::HasNoise() const
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
void vtkHeliosPlatformNoise::GetSlowErrors(vtkIdType seed, double time, double values[6]) const
{
  helios::DriftState cursor;
  this->GetSlowErrors(seed, time, cursor, values);
}

//------------------------------------------------------------------------------
void vtkHeliosPlatformNoise::GetSlowErrors(
  vtkIdType seed, double time, helios::DriftState& cursor, double values[6]) const
{
  for (std::uint32_t i = 0; i < 6; ++i)
  {
    const helios::GaussMarkov error = { this->All[i].SlowRMS, this->All[i].SlowTime };
    values[i] = error.Rms > 0.0
      ? error.GetValue(static_cast<std::uint64_t>(seed), i, time, cursor.Components[i])
      : 0.0;
  }
}

//------------------------------------------------------------------------------
void vtkHeliosPlatformNoise::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "Mode: " << (this->Mode == NAVIGATION_ERROR ? "NavigationError" : "Motion")
     << "\n"
     << indent << "Boresight: " << this->Boresight[0] << ", " << this->Boresight[1] << ", "
     << this->Boresight[2] << " deg\n"
     << indent << "LeverArmError: " << this->LeverArmError[0] << ", " << this->LeverArmError[1]
     << ", " << this->LeverArmError[2] << " m\n"
     << indent << "ClockOffset: " << this->ClockOffset << " s\n";
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
       << c.Lifespan << " pulses; slow error " << c.SlowRMS << " over " << c.SlowTime << " s\n";
  }
}
