// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
#include "heliosLeafProjection.h"

#include "heliosPose.h"
#include "heliosStatus.h"
#include "vtkHeliosArrayNames.h"

#include <vtkDataArray.h>
#include <vtkMath.h>

#include <cmath>

namespace names = vtkHeliosArrayNames;

namespace helios
{

namespace
{

using Distribution = LeafProjection::Distribution;

/// Returns the density of the angle a of leaf normals, not normalized.
double GetDensity(Distribution distribution, double a, double ratio)
{
  switch (distribution)
  {
    case Distribution::Planophile:
      return 1.0 + std::cos(2.0 * a);
    case Distribution::Erectophile:
      return 1.0 - std::cos(2.0 * a);
    case Distribution::Plagiophile:
      return 1.0 - std::cos(4.0 * a);
    case Distribution::Extremophile:
      return 1.0 + std::cos(4.0 * a);
    case Distribution::Ellipsoidal:
    {
      const double cosine = std::cos(a);
      const double sine = std::sin(a);
      const double axis = cosine * cosine + ratio * ratio * sine * sine;
      return sine / (axis * axis);
    }
    default:
      return 1.0;
  }
}

/// Returns the mean of |cos| between a direction and normals of one angle and all azimuths:
/// J. Ross 1981, The Radiation Regime and Architecture of Plant Stands.
double GetKernel(double direction, double normal)
{
  const double level = std::cos(direction) * std::cos(normal);
  const double upright = std::sin(direction) * std::sin(normal);
  if (level >= upright)
  {
    return level;
  }
  const double psi = std::acos(level / upright);
  return 2.0 / vtkMath::Pi() * (upright * std::sin(psi) + level * (0.5 * vtkMath::Pi() - psi));
}

/// Integrates by the midpoint rule.
double Integrate(Distribution distribution, double ratio, double direction)
{
  constexpr int steps = 900;
  double sum = 0.0;
  double weights = 0.0;
  for (int i = 0; i < steps; ++i)
  {
    const double a = 0.5 * vtkMath::Pi() * (i + 0.5) / steps;
    const double weight = GetDensity(distribution, a, ratio);
    weights += weight;
    sum += weight * GetKernel(direction, a);
  }
  return sum / weights;
}

} // namespace

//------------------------------------------------------------------------------
void LeafProjection::Set(Distribution distribution, double ratio)
{
  this->Rows.clear();
  if (distribution == Distribution::Spherical)
  {
    return;
  }
  for (int degree = 0; degree <= 90; ++degree)
  {
    const double angle = vtkMath::RadiansFromDegrees(static_cast<double>(degree));
    const double projection = distribution == Distribution::Horizontal ? std::cos(angle)
      : distribution == Distribution::Vertical ? GetKernel(angle, 0.5 * vtkMath::Pi())
                                               : Integrate(distribution, ratio, angle);
    this->Rows.emplace_back(angle, projection);
  }
}

//------------------------------------------------------------------------------
Status LeafProjection::Set(vtkDataArray* table)
{
  this->Rows.clear();
  std::vector<std::pair<double, double>> rows;
  for (vtkIdType i = 0; table->GetNumberOfComponents() == 4 && i < table->GetNumberOfTuples(); ++i)
  {
    double row[4];
    table->GetTuple(i, row);
    const double angle = std::atan2(std::hypot(row[0], row[1]), std::abs(row[2]));
    const bool isGood =
      Vec3(row).Norm() > 0.0 && std::isfinite(angle) && row[3] >= 0.0 && std::isfinite(row[3]);
    if (!isGood)
    {
      rows.clear();
      break;
    }
    rows.emplace_back(angle, row[3]);
  }
  if (rows.empty())
  {
    return Status::Error(std::string("field array ") + names::LeafProjection +
      " of the voxels needs rows x y z G: a direction, and a projection of 0 or more");
  }
  std::sort(rows.begin(), rows.end());
  constexpr double same = 1e-6; // [rad]
  for (std::size_t i = 0; i < rows.size();)
  {
    std::size_t end = i;
    double sum = 0.0;
    for (; end < rows.size() && rows[end].first - rows[i].first <= same; ++end)
    {
      sum += rows[end].second;
    }
    this->Rows.emplace_back(rows[i].first, sum / static_cast<double>(end - i));
    i = end;
  }
  return {};
}

} // namespace helios
