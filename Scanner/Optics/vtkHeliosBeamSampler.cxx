// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkHeliosBeamSampler.h"

#include <vtkMath.h>
#include <vtkObjectFactory.h>

#include <algorithm>
#include <array>
#include <cmath>

vtkStandardNewMacro(vtkHeliosBeamSampler);

namespace
{

constexpr double QuarterTurn = 0.5 * vtkMath::Pi();
constexpr double GoldenSection = 0.61803398874989484820;
constexpr double WeightUnit = 0x1p-53;
constexpr int MaximumCircles = 64; // and rings
constexpr int MaximumPoints = 65536;

/// A sub-ray in the cross-section of the beam: its radius in units of w, its azimuth, its energy.
struct Node
{
  double Radius;
  double Sin;
  double Cos;
  double Weight;

  Node(double radius, double azimuth, double weight)
    : Radius(radius)
    , Sin(std::sin(azimuth))
    , Cos(std::cos(azimuth))
    , Weight(weight)
  {
  }
};

using Nodes = std::vector<Node>;

/// Returns the fraction of the energy inside radius r of a Gaussian beam truncated at radius k.
double EnergyInside(double r, double k)
{
  return std::expm1(-2.0 * r * r) / std::expm1(-2.0 * k * k);
}

/// Returns the inverse: the radius with the fraction p inside.
double EnergyQuantile(double p, double k)
{
  return std::sqrt(-0.5 * std::log1p(p * std::expm1(-2.0 * k * k)));
}

/// Computes node j of n of the Gauss-Legendre rule on [0, 1], ascending, and its weight: Newton's
/// method.
std::array<long double, 2> GaussLegendre(int j, int n)
{
  long double x = -std::cos(2.0 * QuarterTurn * (j + 0.75) / (n + 0.5));
  long double slope = 1.0L;
  for (int iteration = 0; iteration < 8; ++iteration)
  {
    long double p = 1.0L; // P_i
    long double before = 0.0L;
    for (int i = 1; i <= n; ++i)
    {
      const long double next = ((2 * i - 1) * x * p - (i - 1) * before) / i;
      before = p;
      p = next;
    }
    slope = n * (x * p - before) / (x * x - 1.0L);
    x -= p / slope;
  }
  return { 0.5L * (1.0L + x), 1.0L / ((1.0L - x * x) * slope * slope) };
}

/// Returns a quarter of the rings.
Nodes GaussLegendreQuarter(int rings, double k)
{
  Nodes nodes;
  for (int j = 0; j < rings; ++j)
  {
    const auto [p, weight] = GaussLegendre(j, rings);
    const double radius = EnergyQuantile(static_cast<double>(p), k);
    for (int i = 0; i < rings; ++i)
    {
      const double azimuth = QuarterTurn * (i + 0.5 * (j % 2)) / rings;
      nodes.emplace_back(radius, azimuth, static_cast<double>(weight / rings));
    }
  }
  return nodes;
}

/// Returns a quarter of the spiral.
Nodes VogelQuarter(int count, double k)
{
  Nodes nodes;
  for (int i = 0; i < count; ++i)
  {
    const double turns = i * GoldenSection;
    nodes.emplace_back(
      EnergyQuantile((i + 0.5) / count, k), QuarterTurn * (turns - std::floor(turns)), 1.0 / count);
  }
  return nodes;
}

/// Returns the points of a spiral for a number of sub-rays: four equal quarters.
int GetSpiralSize(int number)
{
  return number <= 1 ? 1 : (std::min(number, MaximumPoints) + 3) / 4 * 4;
}

/// Returns the sub-rays of circle i: floor(2 pi i), one at the centre.
int CircleSize(int circle)
{
  return std::max(1, static_cast<int>(2.0 * vtkMath::Pi() * circle));
}

/// Makes evenly spaced circles with a weight per sub-ray of a circle.
template <typename WeightOf>
Nodes Circles(int circles, double spacing, WeightOf weightOf)
{
  Nodes nodes;
  for (int i = 0; i < circles; ++i)
  {
    const int size = CircleSize(i);
    for (int a = 0; a < size; ++a)
    {
      nodes.emplace_back(i * spacing, 4.0 * QuarterTurn * a / size, weightOf(i, size));
    }
  }
  return nodes;
}

Nodes EnergyCircles(int circles, double k)
{
  const double spacing = k / (circles - 0.5);
  return Circles(circles, spacing,
    [spacing, k](int i, int size)
    {
      const double inner = std::max(0.0, i - 0.5) * spacing;
      const double outer = (i + 0.5) * spacing;
      return (EnergyInside(outer, k) - EnergyInside(inner, k)) / size;
    });
}

/// Makes circles with intensity 2 / pi exp(-2 r^2) times area pi k^2 / N, over the energy of the
/// cone.
Nodes LegacyCircles(int circles, double k)
{
  Nodes nodes = Circles(circles, k / circles, [](int, int) { return 0.0; });
  const double perRay = -2.0 * k * k / std::expm1(-2.0 * k * k) / static_cast<double>(nodes.size());
  for (Node& node : nodes)
  {
    node.Weight = perRay * std::exp(-2.0 * node.Radius * node.Radius);
  }
  return nodes;
}

/// Rounds the weights to multiples of a unit whose sum is 1 over turns: cumulated, then rounded.
void Normalize(Nodes& nodes, int turns)
{
  const double units = 1.0 / WeightUnit / turns;
  long double total = 0.0L;
  for (const Node& node : nodes)
  {
    total += node.Weight;
  }
  long double sum = 0.0L;
  double before = 0.0;
  for (Node& node : nodes)
  {
    sum += node.Weight;
    const double after = static_cast<double>(std::round(sum / total * units));
    node.Weight = (after - before) * WeightUnit;
    before = after;
  }
}

/// Returns each node and its rotations by 90, 180 and 270 degrees, without rounding.
Nodes FourTurns(const Nodes& quarter)
{
  Nodes nodes;
  for (Node node : quarter)
  {
    for (int turn = 0; turn < 4; ++turn)
    {
      nodes.push_back(node);
      const double sin = node.Sin;
      node.Sin = node.Cos;
      node.Cos = -sin;
    }
  }
  return nodes;
}

} // namespace

//------------------------------------------------------------------------------
vtkHeliosBeamSampler::vtkHeliosBeamSampler()
{
  this->Build();
}

//------------------------------------------------------------------------------
void vtkHeliosBeamSampler::Modified()
{
  this->Build();
  this->Superclass::Modified();
}

//------------------------------------------------------------------------------
void vtkHeliosBeamSampler::Refuse(const char* property, double value, const char* cure)
{
  vtkErrorMacro(<< property << " is " << value << "; it must be " << cure);
}

//------------------------------------------------------------------------------
void vtkHeliosBeamSampler::SetProperty(double& property, double value)
{
  if (property != value)
  {
    property = value;
    this->Modified();
  }
}

//------------------------------------------------------------------------------
void vtkHeliosBeamSampler::SetBeamDivergence(double angle)
{
  if (!(angle >= 0.0 && angle <= 1.0))
  {
    this->Refuse("BeamDivergence", angle, "in [0, 1] rad; 0 is one ideal ray");
    return;
  }
  this->SetProperty(this->BeamDivergence, angle);
}

//------------------------------------------------------------------------------
void vtkHeliosBeamSampler::SetDivergenceRatio(double ratio)
{
  if (!(ratio >= 0.01 && ratio <= 1.0))
  {
    this->Refuse("DivergenceRatio", ratio, "in [0.01, 1]; 1 is a circular beam");
    return;
  }
  this->SetProperty(this->DivergenceRatio, ratio);
}

//------------------------------------------------------------------------------
void vtkHeliosBeamSampler::SetMajorAxisAngle(double angle)
{
  if (!(angle >= -360.0 && angle <= 360.0))
  {
    this->Refuse("MajorAxisAngle", angle, "in [-360, 360] deg; 0 is across the scan lines");
    return;
  }
  this->SetProperty(this->MajorAxisAngle, angle);
}

//------------------------------------------------------------------------------
void vtkHeliosBeamSampler::SetBeamQualityFactor(double factor)
{
  if (factor != 0.0 && !(factor >= 1.0 && factor <= 1e4))
  {
    this->Refuse("BeamQualityFactor", factor, "in [1, 10000], or 0 for a beam without a waist");
    return;
  }
  this->SetProperty(this->BeamQualityFactor, factor);
}

//------------------------------------------------------------------------------
void vtkHeliosBeamSampler::SetWavelength(double wavelength)
{
  if (!(wavelength >= 1.0 && wavelength <= 1e6))
  {
    this->Refuse("Wavelength", wavelength, "in [1, 1000000] nm, 1064 for instance");
    return;
  }
  this->SetProperty(this->Wavelength, wavelength);
}

//------------------------------------------------------------------------------
void vtkHeliosBeamSampler::SetNumberOfSubRays(int number)
{
  const int size = GetSpiralSize(number);
  if (this->SpiralSize != size)
  {
    this->SpiralSize = size;
    this->Modified();
  }
}

//------------------------------------------------------------------------------
double vtkHeliosBeamSampler::GetWaist() const
{
  const double w = 0.5 * this->BeamDivergence;
  return w > 0.0 ? this->BeamQualityFactor * 1e-9 * this->Wavelength / (vtkMath::Pi() * w) : 0.0;
}

//------------------------------------------------------------------------------
double vtkHeliosBeamSampler::GetFootprintRadius(double distance) const
{
  return std::hypot(this->GetWaist(), 0.5 * this->BeamDivergence * distance);
}

//------------------------------------------------------------------------------
/// Returns a sub-ray of the circular beam in the elliptical one: z is narrowed, start and slope
/// alike.
vtkHeliosBeamSampler::SubRay vtkHeliosBeamSampler::Narrow(const SubRay& circular) const
{
  SubRay ray = circular;
  ray.Offset[2] *= this->DivergenceRatio;
  ray.Direction[2] *= this->DivergenceRatio;
  vtkMath::Normalize(ray.Direction);
  return ray;
}

//------------------------------------------------------------------------------
void vtkHeliosBeamSampler::Build()
{
  const double k = this->Truncation;
  const bool circles = this->Pattern == CIRCLES;
  Nodes nodes;
  if (this->BeamDivergence == 0.0 || (circles && this->NumberOfCircles == 1) ||
    (this->Pattern == VOGEL && this->SpiralSize == 1))
  {
    nodes.emplace_back(0.0, 0.0, 1.0);
  }
  else if (circles && this->LegacyWeights)
  {
    nodes = LegacyCircles(this->NumberOfCircles, k);
  }
  else if (circles)
  {
    nodes = EnergyCircles(this->NumberOfCircles, k);
    Normalize(nodes, 1);
  }
  else
  {
    Nodes quarter = this->Pattern == VOGEL ? VogelQuarter(this->SpiralSize / 4, k)
                                           : GaussLegendreQuarter(this->NumberOfRings, k);
    Normalize(quarter, 4);
    nodes = FourTurns(quarter);
  }

  const double w = 0.5 * this->BeamDivergence;
  const double waist = this->GetWaist();
  this->SubRays.clear();
  for (const Node& node : nodes)
  {
    // Uses a slope instead of an angle with a waist, which keeps the hyperboloid exact.
    const double angle = waist > 0.0 ? std::atan(node.Radius * w) : node.Radius * w;
    const double across = std::sin(angle);
    const double aside = node.Radius * waist;
    const SubRay ray = { { across * node.Sin, std::cos(angle), across * node.Cos },
      { aside * node.Cos, 0.0, -aside * node.Sin }, node.Weight };
    this->SubRays.push_back(this->DivergenceRatio == 1.0 ? ray : this->Narrow(ray));
  }
}

//------------------------------------------------------------------------------
void vtkHeliosBeamSampler::GetDirection(int subRay, double direction[3]) const
{
  std::copy_n(this->SubRays[static_cast<std::size_t>(subRay)].Direction, 3, direction);
}

//------------------------------------------------------------------------------
void vtkHeliosBeamSampler::GetOffset(int subRay, double offset[3]) const
{
  std::copy_n(this->SubRays[static_cast<std::size_t>(subRay)].Offset, 3, offset);
}

//------------------------------------------------------------------------------
double vtkHeliosBeamSampler::GetWeight(int subRay) const
{
  return this->SubRays[static_cast<std::size_t>(subRay)].Weight;
}

//------------------------------------------------------------------------------
const char* vtkHeliosBeamSampler::GetPatternAsString() const
{
  return GetPatternName(this->Pattern);
}

//------------------------------------------------------------------------------
const char* vtkHeliosBeamSampler::GetPatternName(int pattern)
{
  const char* const names[] = { "GaussLegendre", "Circles", "Vogel" };
  return pattern >= GAUSS_LEGENDRE && pattern <= VOGEL ? names[pattern] : nullptr;
}

//------------------------------------------------------------------------------
int vtkHeliosBeamSampler::CountSubRays(int pattern, int size)
{
  switch (pattern)
  {
    case GAUSS_LEGENDRE:
      return 4 * size * size;
    case VOGEL:
      return GetSpiralSize(size);
    default:
      int count = 0;
      for (int circle = 0; circle < size; ++circle)
      {
        count += CircleSize(circle);
      }
      return count;
  }
}

//------------------------------------------------------------------------------
int vtkHeliosBeamSampler::FindPatternSize(int pattern, int subRays)
{
  if (pattern == VOGEL)
  {
    return GetSpiralSize(subRays);
  }
  int size = 1;
  while (size < MaximumCircles && CountSubRays(pattern, size) < subRays)
  {
    ++size;
  }
  return size;
}

//------------------------------------------------------------------------------
void vtkHeliosBeamSampler::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "Pattern: " << this->GetPatternAsString() << "\n";
  os << indent << "BeamDivergence: " << this->BeamDivergence << "\n";
  os << indent << "DivergenceRatio: " << this->DivergenceRatio << "\n";
  os << indent << "MajorAxisAngle: " << this->MajorAxisAngle << "\n";
  os << indent << "NumberOfRings: " << this->NumberOfRings << "\n";
  os << indent << "NumberOfCircles: " << this->NumberOfCircles << "\n";
  os << indent << "LegacyWeights: " << this->LegacyWeights << "\n";
  os << indent << "NumberOfSubRays: " << this->GetNumberOfSubRays() << "\n";
  os << indent << "Truncation: " << this->Truncation << "\n";
  os << indent << "BeamQualityFactor: " << this->BeamQualityFactor << "\n";
  os << indent << "Wavelength: " << this->Wavelength << "\n";
}
