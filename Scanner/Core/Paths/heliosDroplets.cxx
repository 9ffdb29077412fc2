// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
#include "heliosDroplets.h"

#include "heliosRandom.h"

#include <vtkMath.h>

#include <algorithm>
#include <cmath>

namespace helios
{
namespace
{

constexpr double Efficiency = 2.0; // extinction of a large drop, relative to its section
constexpr std::uint32_t MaximumDrops = 1u << 20; // in a beam
constexpr double ShellRatio = 1.05;              // ratio of the ranges at the ends of a shell
constexpr double MinimumVisible = 1e-9;          // share of a beam

double Square(double x)
{
  return x * x;
}

/// Share of a beam that its hits, in order of range, leave visible at growing ranges.
class Visibility
{
public:
  explicit Visibility(const std::vector<Hidden>& hits)
    : Next(hits.begin())
    , End(hits.end())
  {
  }

  /// Returns the share of the beam that no hit before a range hides.
  double Get(double range)
  {
    for (; this->Next != this->End && this->Next->Range < range; ++this->Next)
    {
      this->Share -= this->Next->Weight;
    }
    return this->Share;
  }

private:
  std::vector<Hidden>::const_iterator Next;
  std::vector<Hidden>::const_iterator End;
  double Share = 1.0;
};

} // namespace

//------------------------------------------------------------------------------
Droplets::Droplets(
  const AirSettings& air, double end, const BeamWidth& beam, double diameter, double minimumPower)
  : Air(air)
  , Beam(beam)
  , MinimumPower(minimumPower)
  , Section(0.25 * vtkMath::Pi() * diameter * diameter)
  , Density(
      beam.Angle > 0.0 && diameter > 0.0 ? air.Extinction / (Efficiency * this->Section) : 0.0)
{
  if (!this->IsEmpty())
  {
    this->End = this->FindEnd(end);
    this->MakeShells();
  }
}

//------------------------------------------------------------------------------
void Droplets::MakeShells()
{
  double effective = 0.0;
  double range = this->Air.Start;
  while (range < this->End)
  {
    const double far = std::min(this->End, ShellRatio * range);
    const double share = this->GetReach(range);
    this->Shells.push_back({ this->GetVolume(range), effective, share });
    effective += share * (this->GetVolume(far) - this->GetVolume(range));
    range = far;
  }
  this->Shells.push_back({ this->GetVolume(range), effective, 0.0 });
}

//------------------------------------------------------------------------------
/// Returns the square of the distance from the axis, in K w, up to which drops reach the least
/// power: the share of the beam's section.
double Droplets::GetReach(double range) const
{
  if (!(this->MinimumPower > 0.0))
  {
    return 1.0;
  }
  const double centre = this->GetWhole(range) * this->GetReceived(range, 0.0);
  return std::clamp(
    0.5 * std::log(centre / this->MinimumPower) / Square(this->Beam.Truncation), 0.0, 1.0);
}

//------------------------------------------------------------------------------
/// Returns the range up to which drops on the axis reach the least power; their power falls with
/// range.
double Droplets::FindEnd(double end) const
{
  double low = this->Air.Start;
  double high = end;
  for (int i = 0; i < 60 && this->GetPower(high, 0.0) < this->MinimumPower; ++i)
  {
    const double middle = 0.5 * (low + high);
    (this->GetPower(middle, 0.0) < this->MinimumPower ? high : low) = middle;
  }
  return high;
}

//------------------------------------------------------------------------------
double Droplets::GetHomogeneousShare(double range) const
{
  const double k2 = Square(this->Beam.Truncation);
  return 1.0 - (1.0 - std::exp(-2.0 * k2 * this->GetReach(range))) / (1.0 - std::exp(-2.0 * k2));
}

//------------------------------------------------------------------------------
double Droplets::GetVolume(double range) const
{
  return vtkMath::Pi() * Square(this->Beam.Truncation * this->Beam.Angle) *
    (Square(this->Beam.Apex) + range * range / 3.0) * range;
}

//------------------------------------------------------------------------------
/// Computes the range up to which a beam has a volume, by Newton's method from above.
double Droplets::FindRange(double volume) const
{
  const double unit = vtkMath::Pi() * Square(this->Beam.Truncation * this->Beam.Angle);
  double range = std::cbrt(3.0 * volume / unit);
  for (int i = 0; i < 50 && this->Beam.Apex > 0.0; ++i)
  {
    const double excess = this->GetVolume(range) - volume;
    const double step = excess / (unit * (Square(this->Beam.Apex) + range * range));
    range -= step;
    if (!(step > 1e-12 * range))
    {
      break;
    }
  }
  return range;
}

//------------------------------------------------------------------------------
/// Returns the share of the beam that a drop receives, at a range and the square of a distance from
/// the axis in w.
double Droplets::GetReceived(double range, double away2) const
{
  const double k2 = Square(this->Beam.Truncation);
  const double w2 = Square(this->Beam.Angle) * (range * range + Square(this->Beam.Apex));
  const double density = // energy per area of the beam
    2.0 / (vtkMath::Pi() * w2) * std::exp(-2.0 * away2) / (1.0 - std::exp(-2.0 * k2));
  return density * this->Section;
}

//------------------------------------------------------------------------------
/// Returns the power that a drop would return of a whole beam.
double Droplets::GetWhole(double range) const
{
  // Uses the backscatter of the air, over n, for a drop: 2 section / lidar ratio.
  const double response = vtkMath::Pi() * Efficiency * this->Air.Backscatter / this->Air.Extinction;
  return this->Air.Gain * std::exp(-2.0 * this->Air.Extinction * range) / (range * range) *
    response;
}

//------------------------------------------------------------------------------
/// Returns the power that a drop returns.
double Droplets::GetPower(double range, double away2) const
{
  return this->GetWhole(range) * std::min(1.0, this->GetReceived(range, away2));
}

//------------------------------------------------------------------------------
void Droplets::Append(std::uint64_t seed, vtkIdType pulse, const std::vector<Hidden>& hits,
  std::vector<SubReturn>& returns) const
{
  Visibility visibility(hits);
  double effective = 0.0;
  auto shell = this->Shells.begin();
  for (std::uint32_t drop = 0; drop < MaximumDrops; ++drop)
  {
    const auto u = Uniform4(seed, RandomStream::Droplets, static_cast<std::uint64_t>(pulse), drop);
    effective -= std::log(u[0]) / this->Density;
    if (!(effective < this->Shells.back().Effective))
    {
      return;
    }
    while ((shell + 1)->Effective <= effective)
    {
      ++shell;
    }
    const double range =
      this->FindRange(shell->Volume + (effective - shell->Effective) / shell->Share);
    const double visible = visibility.Get(range);
    if (!(visible > MinimumVisible))
    {
      return;
    }
    const double away2 = u[2] * shell->Share * Square(this->Beam.Truncation);
    const double power = this->GetPower(range, away2);
    if (power >= this->MinimumPower && u[1] < visible)
    {
      returns.push_back({ range, power, 1.0, -1, SubReturn::Column });
    }
  }
}

} // namespace helios
