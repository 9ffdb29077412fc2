// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma GCC diagnostic ignored "-Wpsabi" // vectors are passed to inlined functions only
#include "heliosLayerSampler.h"

#include "heliosRayVectors.h"

#include <algorithm>
#include <cmath>
#include <cstddef>

namespace helios
{
namespace
{

constexpr std::size_t Lanes = 8;

} // namespace

LayerSampler::LayerSampler(const std::vector<Vec3>& directions)
  : Size(directions.size())
{
  const std::size_t padded = (this->Size + Lanes - 1) / Lanes * Lanes;
  for (std::vector<double>* values :
    { &this->X, &this->Y, &this->Length, &this->Inside, &this->Inverse, &this->Piece })
  {
    values->resize(padded);
  }
  for (std::size_t i = 0; i < this->Size; ++i)
  {
    const Vec3& d = directions[i];
    this->X[i] = d[0] / d[1];
    this->Y[i] = d[2] / d[1];
    this->Length[i] = std::sqrt(1.0 + this->X[i] * this->X[i] + this->Y[i] * this->Y[i]);
  }
  this->BeamX = this->X;
  this->BeamY = this->Y;
}

//------------------------------------------------------------------------------
void LayerSampler::Align(const double frame[3][3], const Vec3& x, const Vec3& z)
{
  const Vec3 across(frame[0]);
  const Vec3 up(frame[1]);
  const double turn[2][2] = { { across.Dot(x), across.Dot(z) }, { up.Dot(x), up.Dot(z) } };
  for (std::size_t i = 0; i < this->Size; ++i)
  {
    this->X[i] = turn[0][0] * this->BeamX[i] + turn[0][1] * this->BeamY[i];
    this->Y[i] = turn[1][0] * this->BeamX[i] + turn[1][1] * this->BeamY[i];
  }
}

//------------------------------------------------------------------------------
/// Returns the triangle of each direction: the one that it is the farthest inside of, so that
/// rounding at an edge leaves no gap.
HELIOS_CLONES
void LayerSampler::Meet(const ConeLayer& layer)
{
  const std::size_t count = this->X.size();
  const double* xs = this->X.data();
  const double* ys = this->Y.data();
  double* insides = this->Inside.data();
  double* inverses = this->Inverse.data();
  double* pieces = this->Piece.data();
  std::fill_n(insides, count, -HUGE_VAL);
  for (int k = 0; k < layer.Size; ++k)
  {
    const ConeLayer::Piece& piece = layer.Pieces[k];
    const auto& e = piece.Edges;
    const double* n = piece.Inverse;
    for (std::size_t i = 0; i < count; ++i)
    {
      const double x = xs[i];
      const double y = ys[i];
      const double a = e[0][0] * x + e[0][1] * y + e[0][2];
      const double b = e[1][0] * x + e[1][1] * y + e[1][2];
      const double c = e[2][0] * x + e[2][1] * y + e[2][2];
      const double inside = std::min(a, std::min(b, c));
      const double inverse = n[0] * x + n[1] * y + n[2];
      const bool isBetter = inside > insides[i];
      insides[i] = isBetter ? inside : insides[i];
      inverses[i] = isBetter ? inverse : inverses[i];
      pieces[i] = isBetter ? k : pieces[i];
    }
  }
}

//------------------------------------------------------------------------------
/// Aims the sub-rays, and sets where they meet their triangles.
HELIOS_CLONES
void LayerSampler::Trace(
  const ConeLayer& layer, const double origin[3], vtkHeliosRay* rays, vtkHeliosHit* hits)
{
  static_assert(offsetof(vtkHeliosRay, Direction) == 3 * sizeof(double) &&
      offsetof(vtkHeliosRay, MaximumRange) == 6 * sizeof(double),
    "origin, direction and range are written as two vectors that overlap");
  this->Meet(layer);
  const auto& f = layer.Frame;
  constexpr Masks isRange = { 0, 0, 0, -1 };
  const Doubles across = { f[0][0], f[0][1], f[0][2], 0.0 };
  const Doubles up = { f[1][0], f[1][1], f[1][2], 0.0 };
  const Doubles along = { f[2][0], f[2][1], f[2][2], 0.0 };
  const Doubles apex = { origin[0], origin[1], origin[2], 0.0 };
  const Doubles range = Doubles() + vtkHeliosRay().MaximumRange;
  for (std::size_t i = 0; i < this->Size; ++i)
  {
    const double length = this->Length[i];
    const Doubles direction = across * this->X[i] + up * this->Y[i] + along;
    auto* place = reinterpret_cast<char*>(rays + i);
    Store(place, apex);
    const Doubles unit = direction / length;
    Store(place + offsetof(vtkHeliosRay, Direction), isRange ? range : unit);
    const auto piece = static_cast<std::size_t>(this->Piece[i]);
    hits[i] = { length / this->Inverse[i], layer.Pieces[piece].Cell };
  }
}

} // namespace helios
