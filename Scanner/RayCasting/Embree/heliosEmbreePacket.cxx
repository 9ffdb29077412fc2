// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma GCC diagnostic ignored "-Wpsabi" // vectors are passed to inlined functions only
#include "heliosEmbreePacket.h"

#include "heliosRayVectors.h"

#include <algorithm>
#include <cmath>
#include <cstring>

namespace helios
{

namespace
{

/// Returns the float range of a ray for a hit at a range: rounded up, so that equal ranges are
/// still found.
template <typename Real>
HELIOS_INLINE Real GetFar(const Real& range, const Real& start, const Real& stretch)
{
  return (range - start) * stretch * (1.0 + 0x1p-20) + 2 * LocalFrame::Pad;
}

/// Sets four rays; writes their float rays from lane first, and their validity.
HELIOS_INLINE void SetQuad(RayQuad& quad, const LocalFrame& frame, const vtkHeliosRay* rays,
  int count, int first, Packet& packet)
{
  const vtkHeliosRay* r[QuadWidth];
  for (int lane = 0; lane < QuadWidth; ++lane)
  {
    r[lane] = rays + (first + lane < count ? first + lane : 0);
  }
  for (int axis = 0; axis < 3; ++axis)
  {
    quad.Origin[axis] =
      Doubles{ r[0]->Origin[axis], r[1]->Origin[axis], r[2]->Origin[axis], r[3]->Origin[axis] };
    quad.Direction[axis] = Doubles{ r[0]->Direction[axis], r[1]->Direction[axis],
      r[2]->Direction[axis], r[3]->Direction[axis] };
  }
  quad.Range =
    Doubles{ r[0]->MaximumRange, r[1]->MaximumRange, r[2]->MaximumRange, r[3]->MaximumRange };
  quad.Triangle = Masks() + RayQuad::NoTriangle;

  Masks isAlive, isX, isY;
  SetTerms<Doubles, Masks>(quad, isAlive, isX, isY);
  const Masks z = isX ? Masks() : (isY ? Masks() + 1 : Masks() + 2);
  quad.HaveSameAxes = true;
  for (int lane = 0; lane < QuadWidth; ++lane)
  {
    quad.Axes[lane] = RayAxes(static_cast<int>(z[lane]));
    quad.HaveSameAxes = quad.HaveSameAxes && z[lane] == z[0];
  }

  // Advance the origins to the scene's box, in double.
  Doubles origin[3], low[3], high[3], entry, exit;
  for (int axis = 0; axis < 3; ++axis)
  {
    origin[axis] = quad.Origin[axis] - frame.Centre[axis];
    low[axis] = frame.Low[axis] - origin[axis];
    high[axis] = frame.High[axis] - origin[axis];
  }
  GetBoxRange(low, high, quad.Inverse, entry, exit);
  const Masks lanes = Masks{ 0, 1, 2, 3 } + first;
  isAlive = isAlive & (lanes < count) & (quad.Range > 0.0);
  isAlive = isAlive & (entry <= exit) & (exit > 0.0) & (entry <= quad.Range);
  quad.Start = Max(entry, Doubles());
  quad.Stretch = Max<Doubles>(quad.Largest, -quad.Largest) * frame.Scale;
  float* origins = packet.GetField(RayField::Origin);
  float* directions = packet.GetField(RayField::Direction);
  const Doubles shrink = Max<Doubles>(quad.LargestInverse, -quad.LargestInverse);
  for (int axis = 0; axis < 3; ++axis)
  {
    const Doubles start = (origin[axis] + quad.Start * quad.Direction[axis]) * frame.Scale;
    const Doubles direction = quad.Direction[axis] * shrink;
    Store(&origins[axis * packet.Width + first], __builtin_convertvector(start, Floats));
    Store(&directions[axis * packet.Width + first], __builtin_convertvector(direction, Floats));
  }
  const Doubles far = GetFar(quad.Range, quad.Start, quad.Stretch);
  Store(packet.GetField(RayField::Far) + first, __builtin_convertvector(far, Floats));
  Store(packet.Valid + first, __builtin_convertvector(isAlive, ShortMasks));
}

/// Tests four rays whose axes are the same.
HELIOS_INLINE void TestQuad(
  RayQuad& quad, const Masks& isValid, const TrianglePair& pair, LazyPlane planes[2], float* far)
{
  for (int i = 0; i < pair.Count; ++i)
  {
    Masks better;
    TestLanes(quad, quad.Axes[0], isValid, pair.First + i, pair.Points[i], planes[i], better);
    if (Any(better))
    {
      const Doubles newFar = GetFar(quad.Range, quad.Start, quad.Stretch);
      const Floats shortFar = __builtin_convertvector(newFar, Floats);
      Store(far, __builtin_convertvector(better, ShortMasks) ? shortFar : Load<Floats>(far));
    }
  }
}

} // namespace

void LocalFrame::Set(const double low[3], const double high[3])
{
  double half = 0.0;
  for (int axis = 0; axis < 3; ++axis)
  {
    this->Centre[axis] = 0.5 * low[axis] + 0.5 * high[axis];
    half = std::max(half, high[axis] - this->Centre[axis]);
  }
  this->Scale = half > 0.0 ? std::ldexp(1.0, -std::ilogb(half) - 1) : 0.0;
  for (int axis = 0; axis < 3; ++axis)
  {
    this->Low[axis] = low[axis] - this->Centre[axis] - 2 * Pad / this->Scale;
    this->High[axis] = high[axis] - this->Centre[axis] + 2 * Pad / this->Scale;
  }
}

void LocalFrame::AddBox(const double* const points[3], float low[3], float high[3]) const
{
  for (int axis = 0; axis < 3; ++axis)
  {
    for (int corner = 0; corner < 3; ++corner)
    {
      const double x = (points[corner][axis] - this->Centre[axis]) * this->Scale;
      low[axis] = std::min(low[axis], static_cast<float>(x - Pad));
      high[axis] = std::max(high[axis], static_cast<float>(x + Pad));
    }
  }
}

void Packet::SetWidth(int width)
{
  this->Width = width;
  for (int lane = 0; lane < width; ++lane)
  {
    const unsigned int all = ~0u;
    this->GetField(RayField::Near)[lane] = 0.0f;
    this->GetField(RayField::Time)[lane] = 0.0f;
    std::memcpy(this->GetField(RayField::Mask) + lane, &all, sizeof(all));
    std::memcpy(this->GetField(RayField::Id) + lane, &lane, sizeof(lane));
    this->GetField(RayField::Flags)[lane] = 0.0f;
  }
}

HELIOS_CLONES
int Packet::Set(const LocalFrame& frame, const vtkHeliosRay* rays, int count)
{
  if (frame.Scale == 0.0) // the whole scene is without area, or outliers
  {
    count = 0;
  }
  ShortMasks alive = ShortMasks();
  for (int first = 0; first < this->Width; first += QuadWidth)
  {
    SetQuad(this->Quads[first / QuadWidth], frame, rays, count, first, *this);
    alive += Load<ShortMasks>(this->Valid + first);
  }
  return -(alive[0] + alive[1] + alive[2] + alive[3]);
}

HELIOS_CLONES
void Packet::TestLanes(const int* valid, const TrianglePair& pair, float* far)
{
  LazyPlane planes[2];
  for (int first = 0; first < this->Width; first += QuadWidth)
  {
    RayQuad& quad = this->Quads[first / QuadWidth];
    const Masks isValid = __builtin_convertvector(Load<ShortMasks>(valid + first), Masks);
    if (Any(isValid) && quad.HaveSameAxes)
    {
      TestQuad(quad, isValid, pair, planes, far + first);
    }
    else if (Any(isValid))
    {
      for (int lane = 0; lane < QuadWidth; ++lane)
      {
        if (isValid[lane])
        {
          quad.TestLane(lane, pair, far[first + lane]);
        }
      }
    }
  }
}

bool RayQuad::TestLane(int lane, const TrianglePair& pair, float& far)
{
  RayTerms<double> ray;
  for (int axis = 0; axis < 3; ++axis)
  {
    ray.Origin[axis] = this->Origin[axis][lane];
    ray.Direction[axis] = this->Direction[axis][lane];
    ray.Inverse[axis] = this->Inverse[axis][lane];
  }
  ray.Shear[0] = this->Shear[0][lane];
  ray.Shear[1] = this->Shear[1][lane];
  bool isBetter = false;
  for (int i = 0; i < pair.Count; ++i)
  {
    double corners[3][3], sheared[3][2], edges[3];
    ComputeOffsets<double>(ray.Origin, pair.Points[i], corners);
    GetEdgeFunctions(ray, this->Axes[lane], corners, sheared, edges);
    if (!IsInside(sheared, edges))
    {
      continue;
    }
    const TrianglePlane plane = GetPlane(pair.Points[i]);
    RangeTerms<double> terms;
    terms.Set(plane, corners);
    const double range = GetRange(ray, plane, terms);
    const double best = this->Range[lane];
    if (range > 0.0 && (range < best || (range == best && pair.First + i < this->Triangle[lane])))
    {
      this->Range[lane] = range;
      this->Triangle[lane] = pair.First + i;
      far = static_cast<float>(GetFar<double>(range, this->Start[lane], this->Stretch[lane]));
      isBetter = true;
    }
  }
  return isBetter;
}

} // namespace helios
