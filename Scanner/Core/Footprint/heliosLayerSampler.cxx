// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
#include "heliosLayerSampler.h"

#include "heliosVectorLoops.h"

#include <algorithm>
#include <cmath>

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
}

//------------------------------------------------------------------------------
/// The triangle of each direction: the one that it is the farthest inside of, so that rounding at
/// an edge leaves no gap.
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
void LayerSampler::Trace(
  const ConeLayer& layer, const double origin[3], vtkHeliosRay* rays, vtkHeliosHit* hits)
{
  this->Meet(layer);
  const auto& frame = layer.Frame;
  for (std::size_t i = 0; i < this->Size; ++i)
  {
    const double z = 1.0 / this->Length[i];
    const double x = z * this->X[i];
    const double y = z * this->Y[i];
    vtkHeliosRay& ray = rays[i];
    for (int axis = 0; axis < 3; ++axis)
    {
      ray.Origin[axis] = origin[axis];
      ray.Direction[axis] = x * frame[0][axis] + y * frame[1][axis] + z * frame[2][axis];
    }
    const auto piece = static_cast<std::size_t>(this->Piece[i]);
    hits[i] = { this->Length[i] / this->Inverse[i], layer.Pieces[piece].Cell };
  }
}

} // namespace helios
