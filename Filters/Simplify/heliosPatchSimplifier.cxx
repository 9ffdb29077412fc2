// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
#include "heliosPatchSimplifier.h"

#include "heliosPatchVerifier.h"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace helios
{

namespace
{

/// Initial tolerance of the samples of the decimation, as a share of the limit.
constexpr double FirstTolerance = 0.75;
/// Factor by which their tolerance is reduced if the limit is exceeded.
constexpr double Tightening = 0.4;
/// About ten are enough for rough ground at 80,000 triangles per patch.
constexpr int NumberOfRounds = 24;

/// Returns the rounding of distances for coordinates of this size.
double GetRounding(const Patch& patch)
{
  double size = 0.0;
  for (const Vec3& p : patch.Points)
  {
    size = std::max({ size, std::abs(p[0]), std::abs(p[1]), std::abs(p[2]) });
  }
  return 0x1p-46 * size;
}

void Tighten(
  const Patch& patch, const std::vector<vtkIdType>& triangles, std::vector<double>& tolerances)
{
  std::vector<bool> isBad(tolerances.size(), false);
  for (const vtkIdType triangle : triangles)
  {
    for (int corner = 0; corner < 3; ++corner)
    {
      isBad[static_cast<std::size_t>(
        patch.Corners[3 * static_cast<std::size_t>(triangle) + corner])] = true;
    }
  }
  for (std::size_t i = 0; i < tolerances.size(); ++i)
  {
    tolerances[i] *= isBad[i] ? Tightening : 1.0;
  }
}

} // namespace

SimplifiedPatch Simplify(const Patch& patch, double limit, StopCheck& check)
{
  const double allowed = std::max(limit, GetRounding(patch));
  std::vector<double> tolerances(patch.Points.size(), FirstTolerance * allowed);
  MeshDecimation decimation(patch);
  PatchVerifier verifier(patch, allowed, check);
  SimplifiedPatch result;
  for (int round = 0; round < NumberOfRounds; ++round)
  {
    check.Poll();
    result.Mesh = decimation.Run(tolerances, check);
    if (result.Mesh.Triangles.size() == patch.Cells.size())
    {
      break;
    }
    if (verifier.Verify(result.Mesh))
    {
      result.Distance = verifier.GetDistance();
      result.IsUntouched = false;
      return result;
    }
    Tighten(patch, verifier.GetBadTriangles(), tolerances);
  }
  result.Mesh.Corners = patch.Corners;
  result.Mesh.Triangles.resize(patch.Cells.size());
  std::iota(result.Mesh.Triangles.begin(), result.Mesh.Triangles.end(), 0);
  return result;
}

} // namespace helios
